/* SPDX-FileCopyrightText: 2026 The CAD2SLAM authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* The smallest program of a robot in C, linked to the installed shared library. */
#include <stdio.h>

#include <cad2slam.h>

int main(void) {
  char message[256];
  cad2slam_projector* projector = NULL;
  const int result = cad2slam_load("no such file.c2s", &projector, message, sizeof message);
  printf("%s: %s\n", cad2slam_version(), message);
  cad2slam_free(projector);
  return result == CAD2SLAM_NOT_FOUND ? 0 : 1;
}
