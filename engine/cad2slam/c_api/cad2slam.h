/* SPDX-FileCopyrightText: 2026 The CAD2SLAM authors */
/* SPDX-License-Identifier: Apache-2.0 */
#pragma once

/* Reads projector files and projects poses between blueprint and SLAM map, in C. Shared library: libcad2slam.so.0.
 *
 *     char message[256];
 *     cad2slam_projector* projector = NULL;
 *     if (cad2slam_load("office.c2s", &projector, message, sizeof message) != CAD2SLAM_OK) return fail(message);
 *     cad2slam_pose goal = {12.5, 7.25, 0.0};
 *     if (cad2slam_slam_from_blueprint(projector, &goal, &goal, CAD2SLAM_OUTSIDE_AS_FILE) <= CAD2SLAM_EXTRAPOLATED)
 *       drive(goal);
 *     cad2slam_free(projector);
 *
 * Metres and radians, counter-clockwise. A projector never changes: any number of threads may query it at once.
 * Queries neither allocate nor lock and cannot fail other than by their status. No exception leaves a function.
 * Null pointers are errors, never crashes. Binary interface: only grows within libcad2slam.so.0.
 */
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of functions that can fail. Values are part of the interface. */
enum cad2slam_result {
  CAD2SLAM_OK = 0,
  CAD2SLAM_NOT_FOUND = 1,        /* no such file */
  CAD2SLAM_UNREADABLE = 2,       /* it is there, but cannot be read */
  CAD2SLAM_MALFORMED = 3,        /* it is no projector file, or a damaged one */
  CAD2SLAM_INVALID_ARGUMENT = 4, /* a null pointer, an unknown policy */
  CAD2SLAM_OUT_OF_MEMORY = 5,
  CAD2SLAM_INTERNAL = 6
};

/* Of a query. */
enum cad2slam_status {
  CAD2SLAM_INSIDE = 0,       /* the query lies on the mesh */
  CAD2SLAM_EXTRAPOLATED = 1, /* beyond the mesh, answered rigidly because caller or file asked for it */
  CAD2SLAM_OUTSIDE = 2,      /* beyond the mesh and not answered: the pose is NaN, here and below */
  CAD2SLAM_FOLDED = 3,       /* the mesh folds or overlaps here: there is no unique answer */
  CAD2SLAM_INVALID = 4       /* the query is not finite, or an argument is invalid */
};

/* What a query beyond the mesh becomes. */
enum cad2slam_outside {
  CAD2SLAM_OUTSIDE_AS_FILE = 0, /* as the maker of the file chose */
  CAD2SLAM_OUTSIDE_ERROR = 1,   /* CAD2SLAM_OUTSIDE */
  CAD2SLAM_OUTSIDE_RIGID = 2    /* CAD2SLAM_EXTRAPOLATED: the nearest place of the mesh carries the query along */
};

typedef struct cad2slam_pose {
  double x;       /* [m] */
  double y;       /* [m] */
  double heading; /* [rad] */
} cad2slam_pose;

typedef struct cad2slam_projector cad2slam_projector;

/* "0.1.0" */
const char* cad2slam_version(void);

/* Opens a projector file and checks all of it. The file is read once and closed: what happens to it afterwards does not
 * matter, and one that is rewritten meanwhile is a damaged one. On failure *projector is NULL and, where `message` is
 * not NULL, one sentence of at most size - 1 bytes of UTF-8 stands there. Returns an enum cad2slam_result. */
int cad2slam_load(const char* path, cad2slam_projector** projector, char* message, size_t size);
/* The same for the bytes of a file, which are not needed any more afterwards. `name` is for the message, or NULL. */
int cad2slam_load_bytes(const void* bytes, size_t count, const char* name, cad2slam_projector** projector,
                        char* message, size_t size);
void cad2slam_free(cad2slam_projector* projector);

/* A value of the file's metadata, e.g. "slam_image_sha256" (docs/projector-file.md), or NULL. Lives as long as the
 * projector. */
const char* cad2slam_metadata(const cad2slam_projector* projector, const char* key);
size_t cad2slam_node_count(const cad2slam_projector* projector);

/* One pose. `in` and `out` may be the same. Returns an enum cad2slam_status. */
int cad2slam_slam_from_blueprint(const cad2slam_projector* projector, const cad2slam_pose* in, cad2slam_pose* out,
                                 int outside);
int cad2slam_blueprint_from_slam(const cad2slam_projector* projector, const cad2slam_pose* in, cad2slam_pose* out,
                                 int outside);

/* `count` poses. `in` and `out` may be the same; `status` may be NULL. Returns how many were answered. */
size_t cad2slam_slam_from_blueprint_many(const cad2slam_projector* projector, const cad2slam_pose* in,
                                         cad2slam_pose* out, uint8_t* status, size_t count, int outside);
size_t cad2slam_blueprint_from_slam_many(const cad2slam_projector* projector, const cad2slam_pose* in,
                                         cad2slam_pose* out, uint8_t* status, size_t count, int outside);

#ifdef __cplusplus
}
#endif
