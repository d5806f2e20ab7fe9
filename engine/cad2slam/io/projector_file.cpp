// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_file.h"

#include "cad2slam/core/large_vector.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/byte_source.h"
#include "cad2slam/io/projector_header.h"
#include "cad2slam/io/projector_metadata.h"
#include "cad2slam/io/sha256.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace cad2slam {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "arrays are read as they lie in the file");

/// [bytes] Read and hashed at a time: what was just read is still in the cache of the processor.
constexpr std::size_t kSliceBytes = std::size_t{1} << 18;

/// A check pose may differ by rounding on another machine, not more [m, rad].
constexpr double kCheckTolerance = 1e-6;
constexpr double kCheckRelativeTolerance = 1e-12;

template <class Number>
constexpr const char* kDtype = nullptr;
template <>
constexpr const char* kDtype<double> = "F64";
template <>
constexpr const char* kDtype<std::int32_t> = "I32";
template <>
constexpr const char* kDtype<std::uint32_t> = "U32";

/// What one number of a row is.
template <class Row>
struct NumberOf {
  using Type = typename Row::value_type;
};
template <>
struct NumberOf<TileCoordinate> {
  using Type = std::int32_t;
};

/// A file as it was read.
struct ProjectorContent {
  ProjectorInfo info;
  ProjectorArrays nodes;
  LargeVector<std::array<std::uint32_t, 2>> edges;
  LargeVector<std::array<double, 4>> anchors;
  LargeVector<std::array<double, 6>> check_poses;

  /// Calls visit(name, rows) for each array that every file has.
  template <class Visit>
  void forEachArray(const Visit& visit) {
    visit("node_blueprint", nodes.node_blueprint);
    visit("node_slam", nodes.node_slam);
    visit("node_stretch", nodes.node_stretch);
    visit("node_tile", nodes.node_tile);
    visit("edges", edges);
    visit("anchors", anchors);
    visit("check_poses", check_poses);
  }
};

tl::unexpected<Error> malformed(const std::string& file_name, std::string message) {
  return fail(ErrorCode::kMalformed, std::move(message), file_name);
}

/// Makes room for an array of the header.
template <class Row>
Result<char*> makeRoom(LargeVector<Row>& rows, const ProjectorHeader& header, const std::string& name,
                       const std::string& file_name) {
  using Number = typename NumberOf<Row>::Type;
  constexpr std::size_t kColumns = sizeof(Row) / sizeof(Number);
  const auto place = header.arrays.find(name);
  if (place == header.arrays.end()) return malformed(file_name, "has no array " + name);
  const ArrayEntry& entry = place->second;
  if (entry.dtype != kDtype<Number> || entry.shape.size() != 2 || entry.shape[1] != kColumns) {
    return malformed(file_name, "has an array " + name + " that is not " + kDtype<Number> + " in " +
                                    std::to_string(kColumns) + " columns");
  }
  rows.resize(static_cast<std::size_t>(entry.shape[0]));
  return reinterpret_cast<char*>(rows.data());
}

/// Where the bytes of one array go.
struct Destination {
  std::uint64_t begin = 0;  ///< [bytes] in the data section
  std::uint64_t bytes = 0;
  char* memory = nullptr;  ///< null for an array that is not known, which is only hashed
};

/// Of all arrays, in the order of the file.
Result<std::vector<Destination>> makeRoom(ProjectorContent& content, const ProjectorHeader& header,
                                          const std::string& file_name) {
  std::map<std::string, char*> memory;
  std::optional<Error> error;
  content.forEachArray([&](const char* name, auto& rows) {
    if (error) return;
    const Result<char*> room = makeRoom(rows, header, name, file_name);
    if (room) {
      memory[name] = *room;
    } else {
      error = room.error();
    }
  });
  if (error) return tl::unexpected<Error>(*error);
  const auto& [blueprint, slam, stretch, tile] = content.nodes;
  if (blueprint.size() != tile.size() || slam.size() != tile.size() || stretch.size() != tile.size()) {
    return malformed(file_name, "has node arrays of different lengths");
  }
  std::vector<Destination> destinations;
  for (const auto& [name, entry] : header.arrays) {
    const auto known = memory.find(name);
    destinations.push_back({entry.begin, entry.end - entry.begin, known == memory.end() ? nullptr : known->second});
  }
  std::sort(destinations.begin(), destinations.end(),
            [](const Destination& a, const Destination& b) { return a.begin < b.begin; });
  return destinations;
}

/// Reads the data section from front to end, each array straight into its own memory, so that nothing of the file is
/// there twice. Gives the SHA-256 of all bytes.
Result<std::string> readData(ByteSource& source, const std::vector<Destination>& destinations) {
  Sha256 hash;
  std::vector<char> unknown;
  for (const Destination& to : destinations) {
    if (to.memory == nullptr) unknown.resize(kSliceBytes);
    for (std::uint64_t done = 0; done < to.bytes;) {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kSliceBytes, to.bytes - done));
      char* slice = to.memory == nullptr ? unknown.data() : to.memory + done;
      if (const Result<void> read = source.read(slice, count); !read) return failAs(read);
      hash.add(slice, count);
      done += count;
    }
  }
  return hash.finish();
}

template <std::size_t columns>
bool allFinite(const LargeVector<std::array<double, columns>>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const auto& row) {
    return std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
  });
}

/// Everything but the nodes, which Projector::create() checks.
Result<void> checkRows(const ProjectorContent& content, const std::string& file_name) {
  const std::size_t nodes = content.nodes.node_tile.size();
  for (const std::array<std::uint32_t, 2>& edge : content.edges) {
    if (edge[0] >= nodes || edge[1] >= nodes) {
      return malformed(file_name, "has an edge to a node that does not exist");
    }
  }
  if (!allFinite(content.anchors)) return malformed(file_name, "has an anchor that is not finite");
  if (!allFinite(content.check_poses)) return malformed(file_name, "has a check pose that is not finite");
  return {};
}

Result<ProjectorContent> readContent(ByteSource& source) {
  const std::string& file_name = source.name();
  const Result<ProjectorHeader> header = readProjectorHeader(source);
  if (!header) return failAs(header);
  Result<ProjectorInfo> info = infoOf(header->metadata, file_name);
  if (!info) return failAs(info);
  if (!headerSealHolds(*header)) return malformed(file_name, "is damaged: its header was changed");
  const auto seal = header->metadata.find(kDataSealKey);
  if (seal == header->metadata.end()) return malformed(file_name, "has no data_sha256");

  ProjectorContent content;
  content.info = std::move(*info);
  const Result<std::vector<Destination>> destinations = makeRoom(content, *header, file_name);
  if (!destinations) return failAs(destinations);
  const Result<std::string> hash = readData(source, *destinations);
  if (!hash) return failAs(hash);
  if (*hash != seal->second) {
    return malformed(file_name, "is damaged: its data do not have the SHA-256 they should");
  }
  if (const Result<void> checked = checkRows(content, file_name); !checked) return failAs(checked);
  return content;
}

std::vector<CheckPose> checksOf(const ProjectorContent& content) {
  std::vector<CheckPose> checks;
  for (const auto& [x, y, heading, slam_x, slam_y, slam_heading] : content.check_poses) {
    checks.push_back({Pose2{{x, y}, heading}, Pose2{{slam_x, slam_y}, slam_heading}});
  }
  return checks;
}

bool isNear(const Pose2& a, const Pose2& b) {
  const double tolerance_m = kCheckTolerance + kCheckRelativeTolerance * b.translation.norm();
  return (a.translation - b.translation).norm() <= tolerance_m &&
         std::abs(wrapAngle(a.heading - b.heading)) <= kCheckTolerance;
}

/// The projector gives the poses its maker got, so it means the same function.
Result<void> proveItself(const Projector& projector, const std::vector<CheckPose>& checks, const std::string& where) {
  for (std::size_t k = 0; k < checks.size(); ++k) {
    const Projection projected = projector.slamFromBlueprint(checks[k].in_blueprint, OutsidePolicy::kRigid);
    if (!projected.ok() || !isNear(projected.pose, checks[k].in_slam)) {
      return malformed(where, "does not reproduce its own check pose " + std::to_string(k + 1));
    }
  }
  return {};
}

/// Uses the content up.
Result<Projector> projectorOf(ProjectorContent&& content, const std::string& file_name) {
  freeMemory(content.edges);  // of no use for the function, and as large as the nodes
  const Result<Projector> projector = Projector::create(content.info, std::move(content.nodes));
  if (!projector) return fail(projector.error().code, projector.error().message, file_name);
  if (const Result<void> proof = proveItself(*projector, checksOf(content), file_name); !proof) return failAs(proof);
  return projector;
}

Result<Projector> functionOf(ByteSource& source) {
  Result<ProjectorContent> content = readContent(source);
  if (!content) return failAs(content);
  return projectorOf(std::move(*content), source.name());
}

Result<ProjectorData> dataOf(ByteSource& source) {
  Result<ProjectorContent> content = readContent(source);
  if (!content) return failAs(content);
  ProjectorData data;
  data.info = content->info;
  setNodes(data, content->nodes);
  data.edges.assign(content->edges.begin(), content->edges.end());
  data.anchors.assign(content->anchors.begin(), content->anchors.end());
  data.check_poses = checksOf(*content);
  const Result<Projector> projector = projectorOf(std::move(*content), source.name());
  if (!projector) return failAs(projector);
  return data;
}

/// Robots may be built without exceptions: what is left of them, where memory runs out, ends here.
template <class Read>
auto withinMemory(const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kInternal, "needs more memory than there is", "projector");
  }
}

/// Collects arrays one behind the other and describes them.
class DataSection {
 public:
  template <class Row>
  void add(const char* name, const LargeVector<Row>& rows) {
    using Number = typename NumberOf<Row>::Type;
    ArrayEntry& entry = header_.arrays[name];
    entry.dtype = kDtype<Number>;
    entry.shape = {rows.size(), sizeof(Row) / sizeof(Number)};
    entry.begin = bytes_.size();
    if (!rows.empty()) bytes_.append(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(Row));
    entry.end = bytes_.size();
  }
  /// The whole file. Too long a note is the only thing that can make the header too long.
  [[nodiscard]] Result<std::string> seal(ProjectorMetadata metadata) {
    header_.metadata = std::move(metadata);
    sealProjectorHeader(header_, bytes_);
    const std::string prefix = formatProjectorPrefix(header_);
    if (prefix.size() > kLargestProjectorHeader) {
      return fail(ErrorCode::kOutOfDomain, "the names and notes of the projector are too long to be written");
    }
    bytes_.insert(0, prefix);
    return std::move(bytes_);
  }

 private:
  ProjectorHeader header_;
  std::string bytes_;
};

Result<void> checkWritable(const ProjectorData& data) {
  const Result<ProjectorInfo> info = infoOf(metadataOf(data.info), "projector");
  if (!info) return failAs(info);
  const Result<Projector> projector = Projector::create(data);
  if (!projector) return failAs(projector);
  const std::size_t nodes = data.node_blueprint.size();
  for (const std::array<std::uint32_t, 2>& edge : data.edges) {
    if (edge[0] >= nodes || edge[1] >= nodes) {
      return fail(ErrorCode::kMalformed, "the projector has an edge to a node that does not exist");
    }
  }
  for (const std::array<double, 4>& anchor : data.anchors) {
    if (!std::all_of(anchor.begin(), anchor.end(), [](double x) { return std::isfinite(x); })) {
      return fail(ErrorCode::kMalformed, "the projector has an anchor that is not finite");
    }
  }
  return proveItself(*projector, data.check_poses, "projector");
}

}  // namespace

Result<std::string> formatProjectorFile(const ProjectorData& data) {
  if (const Result<void> writable = checkWritable(data); !writable) return failAs(writable);
  ProjectorContent content;
  content.nodes = arraysOf(data);
  content.edges.assign(data.edges.begin(), data.edges.end());
  content.anchors.assign(data.anchors.begin(), data.anchors.end());
  for (const auto& [in_blueprint, in_slam] : data.check_poses) {
    content.check_poses.push_back({in_blueprint.translation.x(), in_blueprint.translation.y(), in_blueprint.heading,
                                   in_slam.translation.x(), in_slam.translation.y(), in_slam.heading});
  }
  DataSection section;
  content.forEachArray([&section](const char* name, const auto& rows) { section.add(name, rows); });
  return section.seal(metadataOf(data.info));
}

Result<void> writeProjectorFile(const std::filesystem::path& path, const ProjectorData& data) {
  const Result<std::string> bytes = formatProjectorFile(data);
  if (!bytes) return failAs(bytes);
  return writeFileAtomically(path, *bytes);
}

Result<ProjectorData> parseProjectorFile(std::string_view bytes, const std::string& file_name) {
  return withinMemory([&] {
    ByteSource source = ByteSource::ofMemory(bytes, file_name);
    return dataOf(source);
  });
}

Result<ProjectorData> readProjectorFile(const std::filesystem::path& path) {
  return withinMemory([&]() -> Result<ProjectorData> {
    Result<ByteSource> source = ByteSource::ofFile(path);
    if (!source) return failAs(source);
    return dataOf(*source);
  });
}

Result<Projector> loadProjector(const std::filesystem::path& path) {
  return withinMemory([&]() -> Result<Projector> {
    Result<ByteSource> source = ByteSource::ofFile(path);
    if (!source) return failAs(source);
    return functionOf(*source);
  });
}

Result<Projector> loadProjector(std::string_view bytes, const std::string& file_name) {
  return withinMemory([&] {
    ByteSource source = ByteSource::ofMemory(bytes, file_name);
    return functionOf(source);
  });
}

}  // namespace cad2slam
