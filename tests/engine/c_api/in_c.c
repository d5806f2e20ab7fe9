/* SPDX-FileCopyrightText: 2026 The CAD2SLAM authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* usage: in_c FILE.c2s
 * Calls the whole C interface the way C programs do, wrong arguments included. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cad2slam.h>

static int failures = 0;

#define CHECK(condition)                                              \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                     \
    }                                                                 \
  } while (0)

static void checkErrors(void) {
  char message[256] = "untouched";
  cad2slam_projector* projector = NULL;
  CHECK(cad2slam_load("no such file.c2s", &projector, message, sizeof message) == CAD2SLAM_NOT_FOUND);
  CHECK(projector == NULL && strstr(message, "no such file.c2s") != NULL);
  CHECK(cad2slam_load(NULL, &projector, message, sizeof message) != CAD2SLAM_OK);
  CHECK(cad2slam_load("x", NULL, message, sizeof message) == CAD2SLAM_INVALID_ARGUMENT);
  CHECK(cad2slam_load("no such file.c2s", &projector, NULL, 0) == CAD2SLAM_NOT_FOUND);
  CHECK(cad2slam_load("no such file.c2s", &projector, message, 1) == CAD2SLAM_NOT_FOUND && message[0] == '\0');
  CHECK(cad2slam_load("no such file.c2s", &projector, message, 8) == CAD2SLAM_NOT_FOUND && strlen(message) == 7);
  CHECK(cad2slam_load_bytes("rubbish!rubbish!", 16, "bytes", &projector, message, sizeof message) ==
        CAD2SLAM_MALFORMED);
  CHECK(strstr(message, "bytes") == message);
  CHECK(cad2slam_load_bytes(NULL, 16, NULL, &projector, message, sizeof message) == CAD2SLAM_MALFORMED);

  cad2slam_pose pose = {1.0, 2.0, 3.0};
  uint8_t status = 77;
  CHECK(cad2slam_slam_from_blueprint(NULL, &pose, &pose, CAD2SLAM_OUTSIDE_ERROR) == CAD2SLAM_INVALID);
  CHECK(isnan(pose.x) && isnan(pose.y) && isnan(pose.heading));
  CHECK(cad2slam_blueprint_from_slam_many(NULL, &pose, &pose, &status, 1, 0) == 0 && status == CAD2SLAM_INVALID);
  CHECK(cad2slam_metadata(NULL, "scale") == NULL);
  CHECK(cad2slam_node_count(NULL) == 0);
  cad2slam_free(NULL);
}

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: in_c FILE.c2s\n");
    return 2;
  }
  checkErrors();

  char message[256];
  cad2slam_projector* projector = NULL;
  if (cad2slam_load(argv[1], &projector, message, sizeof message) != CAD2SLAM_OK) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  CHECK(message[0] == '\0');
  CHECK(strlen(cad2slam_version()) >= 5);
  CHECK(cad2slam_node_count(projector) > 1000);
  CHECK(strcmp(cad2slam_metadata(projector, "format"), "cad2slam-projector") == 0);
  CHECK(strlen(cad2slam_metadata(projector, "slam_image_sha256")) == 64);
  CHECK(cad2slam_metadata(projector, "no such key") == NULL);
  CHECK(cad2slam_metadata(projector, NULL) == NULL);

  enum { kCount = 10000 };
  static cad2slam_pose start[kCount], there[kCount], back[kCount];
  static uint8_t status[kCount];
  for (int k = 0; k < kCount; ++k) {
    start[k].x = 0.5 * (k % 100);
    start[k].y = 0.5 * (k / 100);
    start[k].heading = 0.001 * k - 3.1;
  }
  const size_t answered =
      cad2slam_slam_from_blueprint_many(projector, start, there, status, kCount, CAD2SLAM_OUTSIDE_ERROR);
  CHECK(answered > 1000);
  (void)cad2slam_blueprint_from_slam_many(projector, there, back, NULL, kCount, CAD2SLAM_OUTSIDE_ERROR);
  size_t inside = 0;
  for (int k = 0; k < kCount; ++k) {
    cad2slam_pose pose = start[k];
    const int single = cad2slam_slam_from_blueprint(projector, &pose, &pose, CAD2SLAM_OUTSIDE_AS_FILE);
    CHECK(single == status[k]);
    if (status[k] != CAD2SLAM_INSIDE) {
      CHECK(isnan(there[k].x));
      CHECK(cad2slam_slam_from_blueprint(projector, &start[k], &pose, CAD2SLAM_OUTSIDE_RIGID) == CAD2SLAM_EXTRAPOLATED);
      continue;
    }
    ++inside;
    CHECK(pose.x == there[k].x && pose.y == there[k].y && pose.heading == there[k].heading);
    CHECK(hypot(back[k].x - start[k].x, back[k].y - start[k].y) < 1e-6);
  }
  CHECK(inside == answered);

  cad2slam_pose pose = {NAN, 0.0, 0.0};
  CHECK(cad2slam_slam_from_blueprint(projector, &pose, &pose, 0) == CAD2SLAM_INVALID);
  CHECK(cad2slam_slam_from_blueprint(projector, &start[0], &pose, 9) == CAD2SLAM_INVALID);
  CHECK(cad2slam_slam_from_blueprint(projector, NULL, &pose, 0) == CAD2SLAM_INVALID);
  CHECK(cad2slam_slam_from_blueprint(projector, &start[0], NULL, 0) == CAD2SLAM_INVALID);
  CHECK(cad2slam_slam_from_blueprint_many(projector, start, NULL, NULL, kCount, 0) == 0);
  CHECK(cad2slam_slam_from_blueprint_many(projector, NULL, NULL, NULL, 0, 0) == 0);
  cad2slam_free(projector);
  return failures == 0 ? 0 : 1;
}
