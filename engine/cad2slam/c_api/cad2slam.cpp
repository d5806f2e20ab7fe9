// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/c_api/cad2slam.h"

#include "cad2slam/io/projector_file.h"
#include "cad2slam/io/projector_metadata.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

using cad2slam::Error;
using cad2slam::ErrorCode;
using cad2slam::OutsidePolicy;
using cad2slam::Pose2;
using cad2slam::Projection;
using cad2slam::ProjectionStatus;
using cad2slam::Projector;
using cad2slam::Result;

static_assert(static_cast<int>(ProjectionStatus::kInside) == CAD2SLAM_INSIDE);
static_assert(static_cast<int>(ProjectionStatus::kExtrapolated) == CAD2SLAM_EXTRAPOLATED);
static_assert(static_cast<int>(ProjectionStatus::kOutside) == CAD2SLAM_OUTSIDE);
static_assert(static_cast<int>(ProjectionStatus::kFolded) == CAD2SLAM_FOLDED);
static_assert(static_cast<int>(ProjectionStatus::kInvalid) == CAD2SLAM_INVALID);

struct cad2slam_projector {
  Projector function;
  cad2slam::ProjectorMetadata metadata;
};

namespace {

/// Cuts a sentence where it does not fit, between two characters of UTF-8.
void tell(std::string_view sentence, char* message, size_t size) {
  if (message == nullptr || size == 0) return;
  size_t length = std::min(sentence.size(), size - 1);
  while (length > 0 && length < sentence.size() && (static_cast<unsigned char>(sentence[length]) & 0xC0U) == 0x80U) {
    --length;
  }
  std::memcpy(message, sentence.data(), length);
  message[length] = '\0';
}

int resultOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::kNotFound:
      return CAD2SLAM_NOT_FOUND;
    case ErrorCode::kUnreadable:
      return CAD2SLAM_UNREADABLE;
    case ErrorCode::kInternal:  // of a reader: an exhausted resource
      return CAD2SLAM_OUT_OF_MEMORY;
    default:
      return CAD2SLAM_MALFORMED;
  }
}

/// Turns what `open` gives into a handle; nothing it throws gets past here.
template <class Open>
int loadWith(const Open& open, cad2slam_projector** projector, char* message, size_t size) noexcept {
  tell("", message, size);
  if (projector == nullptr) {
    tell("cad2slam_load() needs a place for the projector", message, size);
    return CAD2SLAM_INVALID_ARGUMENT;
  }
  *projector = nullptr;
  try {
    Result<Projector> loaded = open();
    if (!loaded) {
      tell(loaded.error().sentence(), message, size);
      return resultOf(loaded.error().code);
    }
    cad2slam::ProjectorMetadata metadata = cad2slam::metadataOf(loaded->info());
    *projector = new cad2slam_projector{std::move(*loaded), std::move(metadata)};
    return CAD2SLAM_OK;
  } catch (const std::bad_alloc&) {
    tell("not enough memory for the projector", message, size);
    return CAD2SLAM_OUT_OF_MEMORY;
  } catch (...) {
    tell("the projector could not be opened because of an internal error", message, size);
    return CAD2SLAM_INTERNAL;
  }
}

std::optional<OutsidePolicy> policyOf(const cad2slam_projector& projector, int outside) {
  switch (outside) {
    case CAD2SLAM_OUTSIDE_AS_FILE:
      return projector.function.info().outside;
    case CAD2SLAM_OUTSIDE_ERROR:
      return OutsidePolicy::kError;
    case CAD2SLAM_OUTSIDE_RIGID:
      return OutsidePolicy::kRigid;
    default:
      return std::nullopt;
  }
}

constexpr auto kForward = [](const Projector& projector, const Pose2& pose, OutsidePolicy outside) {
  return projector.slamFromBlueprint(pose, outside);
};
constexpr auto kBackward = [](const Projector& projector, const Pose2& pose, OutsidePolicy outside) {
  return projector.blueprintFromSlam(pose, outside);
};

template <class Query>
size_t projectMany(const Query& query, const cad2slam_projector* projector, const cad2slam_pose* in, cad2slam_pose* out,
                   uint8_t* status, size_t count, int outside) noexcept {
  if (count == 0 || out == nullptr) return 0;
  const std::optional<OutsidePolicy> policy = projector == nullptr ? std::nullopt : policyOf(*projector, outside);
  size_t answered = 0;
  for (size_t i = 0; i < count; ++i) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    Projection found{{{kNaN, kNaN}, kNaN}, ProjectionStatus::kInvalid};
    if (policy && in != nullptr) found = query(projector->function, {{in[i].x, in[i].y}, in[i].heading}, *policy);
    out[i] = {found.pose.translation.x(), found.pose.translation.y(), found.pose.heading};
    if (status != nullptr) status[i] = static_cast<uint8_t>(found.status);
    if (found.ok()) ++answered;
  }
  return answered;
}

template <class Query>
int projectOne(const Query& query, const cad2slam_projector* projector, const cad2slam_pose* in, cad2slam_pose* out,
               int outside) noexcept {
  uint8_t status = CAD2SLAM_INVALID;
  projectMany(query, projector, in, out, &status, 1, outside);
  return status;
}

}  // namespace

const char* cad2slam_version() {
  return CAD2SLAM_VERSION;
}

int cad2slam_load(const char* path, cad2slam_projector** projector, char* message, size_t size) {
  const auto open = [path]() -> Result<Projector> {
    if (path == nullptr) return cad2slam::fail(ErrorCode::kNotFound, "cad2slam_load() needs the path of a file");
    return cad2slam::loadProjector(std::filesystem::path(path));
  };
  return loadWith(open, projector, message, size);
}

int cad2slam_load_bytes(const void* bytes, size_t count, const char* name, cad2slam_projector** projector,
                        char* message, size_t size) {
  const auto open = [=] {
    const std::string_view content(static_cast<const char*>(bytes), bytes == nullptr ? 0 : count);
    return cad2slam::loadProjector(content, name == nullptr ? "projector" : name);
  };
  return loadWith(open, projector, message, size);
}

void cad2slam_free(cad2slam_projector* projector) {
  delete projector;
}

const char* cad2slam_metadata(const cad2slam_projector* projector, const char* key) {
  if (projector == nullptr || key == nullptr) return nullptr;
  const auto place = std::find_if(projector->metadata.begin(), projector->metadata.end(), [key](const auto& entry) {
    return std::strcmp(entry.first.c_str(), key) == 0;
  });  // no allocation
  return place == projector->metadata.end() ? nullptr : place->second.c_str();
}

size_t cad2slam_node_count(const cad2slam_projector* projector) {
  return projector == nullptr ? 0 : projector->function.nodeCount();
}

int cad2slam_slam_from_blueprint(const cad2slam_projector* projector, const cad2slam_pose* in, cad2slam_pose* out,
                                 int outside) {
  return projectOne(kForward, projector, in, out, outside);
}

int cad2slam_blueprint_from_slam(const cad2slam_projector* projector, const cad2slam_pose* in, cad2slam_pose* out,
                                 int outside) {
  return projectOne(kBackward, projector, in, out, outside);
}

size_t cad2slam_slam_from_blueprint_many(const cad2slam_projector* projector, const cad2slam_pose* in,
                                         cad2slam_pose* out, uint8_t* status, size_t count, int outside) {
  return projectMany(kForward, projector, in, out, status, count, outside);
}

size_t cad2slam_blueprint_from_slam_many(const cad2slam_projector* projector, const cad2slam_pose* in,
                                         cad2slam_pose* out, uint8_t* status, size_t count, int outside) {
  return projectMany(kBackward, projector, in, out, status, count, outside);
}
