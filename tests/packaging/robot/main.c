/* SPDX-FileCopyrightText: 2026 The CAD2SLAM authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* The smallest program of a robot in C, linked to the installed shared library. */
#include <stdio.h>

#include <cad2slam.h>

int main(int argc, char** argv) {
  char message[256];
  cad2slam_projector* projector = NULL;
  cad2slam_pose pose = {0.75, 0.25, 0.0};
  if (argc != 2) return 2;
  if (cad2slam_load("no such file.c2s", &projector, message, sizeof message) != CAD2SLAM_NOT_FOUND) return 1;
  printf("%s: %s\n", cad2slam_version(), message);
  if (cad2slam_load(argv[1], &projector, message, sizeof message) != CAD2SLAM_OK) {
    printf("%s\n", message);
    return 1;
  }
  const int status = cad2slam_slam_from_blueprint(projector, &pose, &pose, CAD2SLAM_OUTSIDE_ERROR);
  cad2slam_free(projector);
  printf("%.3f %.3f %.3f\n", pose.x, pose.y, pose.heading);
  return status == CAD2SLAM_INSIDE ? 0 : 1;
}
