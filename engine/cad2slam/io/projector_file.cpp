// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_file.h"

#include "cad2slam/core/large_vector.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/file_descriptor.h"
#include "cad2slam/io/projector_header.h"
#include "cad2slam/io/projector_metadata.h"
#include "cad2slam/io/sha256.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <future>
#include <new>
#include <optional>
#include <system_error>
#include <vector>

namespace cad2slam {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "arrays are read as they lie in the file");

constexpr std::size_t kWorthAThread = std::size_t{1} << 20;  // [bytes] to hash
/// Memory that is filled at once and needs no zeros first.
struct Byte {
  char value;
  Byte() {}  // NOLINT(modernize-use-equals-default): a defaulted one writes zeros
};
using Bytes = LargeVector<Byte>;

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

/// One array of a file, row by row.
template <class Number>
struct Table {
  const Number* numbers = nullptr;
  std::size_t rows = 0;
};

/// The content of a file where it lies; nothing is copied unless it is misaligned.
struct ProjectorView {
  ProjectorInfo info;
  Table<double> node_blueprint;
  Table<double> node_slam;
  Table<double> node_stretch;
  Table<std::int32_t> node_tile;
  Table<std::uint32_t> edges;
  Table<double> anchors;
  Table<double> check_poses;
  std::string_view data;
  std::string data_sha256;
  std::deque<std::vector<double>> aligned;  // copies of what lay on an odd address

  [[nodiscard]] ProjectorArrays arrays() const {
    return {node_blueprint.rows, node_blueprint.numbers, node_slam.numbers, node_stretch.numbers, node_tile.numbers};
  }
};

tl::unexpected<Error> malformed(const std::string& file_name, std::string message) {
  return fail(ErrorCode::kMalformed, std::move(message), file_name);
}

template <class Number>
Result<Table<Number>> findTable(const ProjectorLayout& layout, const std::string& name, std::size_t columns,
                                std::deque<std::vector<double>>& aligned, const std::string& file_name) {
  const auto place = layout.header.arrays.find(name);
  if (place == layout.header.arrays.end()) return malformed(file_name, "has no array " + name);
  const ArrayEntry& entry = place->second;
  if (entry.dtype != kDtype<Number> || entry.shape.size() != 2 || entry.shape[1] != columns) {
    return malformed(file_name, "has an array " + name + " that is not " + kDtype<Number> + " in " +
                                    std::to_string(columns) + " columns");
  }
  Table<Number> table;
  table.rows = static_cast<std::size_t>(entry.shape[0]);
  const char* bytes = layout.data.data() + entry.begin;
  if (reinterpret_cast<std::uintptr_t>(bytes) % alignof(Number) != 0) {
    const std::size_t count = entry.end - entry.begin;
    std::vector<double>& copy = aligned.emplace_back((count + sizeof(double) - 1) / sizeof(double));
    if (count > 0) std::memcpy(copy.data(), bytes, count);
    bytes = reinterpret_cast<const char*>(copy.data());
  }
  table.numbers = reinterpret_cast<const Number*>(bytes);
  return table;
}

bool allFinite(const Table<double>& table, std::size_t columns) {
  return std::all_of(table.numbers, table.numbers + table.rows * columns, [](double x) { return std::isfinite(x); });
}

/// Everything but the nodes, which Projector::create() checks, and the seal of the data.
Result<ProjectorView> openView(std::string_view bytes, const std::string& file_name) {
  const Result<ProjectorLayout> layout = parseProjectorLayout(bytes, file_name);
  if (!layout) return failAs(layout);
  Result<ProjectorInfo> info = infoOf(layout->header.metadata, file_name);
  if (!info) return failAs(info);
  if (!headerSealHolds(layout->header)) return malformed(file_name, "is damaged: its header was changed");

  ProjectorView view;
  view.info = std::move(*info);
  view.data = layout->data;
  std::optional<Error> error;
  const auto find = [&](auto& table, const char* name, std::size_t columns) {
    auto found = findTable<std::remove_cv_t<std::remove_pointer_t<decltype(table.numbers)>>>(*layout, name, columns,
                                                                                             view.aligned, file_name);
    if (found) {
      table = *found;
    } else if (!error) {
      error = found.error();
    }
  };
  find(view.node_blueprint, "node_blueprint", 2);
  find(view.node_slam, "node_slam", 3);
  find(view.node_stretch, "node_stretch", 2);
  find(view.node_tile, "node_tile", 2);
  find(view.edges, "edges", 2);
  find(view.anchors, "anchors", 4);
  find(view.check_poses, "check_poses", 6);
  if (error) return tl::unexpected(*error);

  const std::size_t nodes = view.node_blueprint.rows;
  if (view.node_slam.rows != nodes || view.node_stretch.rows != nodes || view.node_tile.rows != nodes) {
    return malformed(file_name, "has node arrays of different lengths");
  }
  const std::uint32_t* edges = view.edges.numbers;
  if (std::any_of(edges, edges + 2 * view.edges.rows, [nodes](std::uint32_t node) { return node >= nodes; })) {
    return malformed(file_name, "has an edge to a node that does not exist");
  }
  if (!allFinite(view.anchors, 4)) return malformed(file_name, "has an anchor that is not finite");
  if (!allFinite(view.check_poses, 6)) return malformed(file_name, "has a check pose that is not finite");
  const auto seal = layout->header.metadata.find(kDataSealKey);
  if (seal == layout->header.metadata.end()) return malformed(file_name, "has no data_sha256");
  view.data_sha256 = seal->second;
  return view;
}

CheckPose checkPoseOf(const double* row) {
  return {Pose2{{row[0], row[1]}, row[2]}, Pose2{{row[3], row[4]}, row[5]}};
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

std::vector<CheckPose> checksOf(const ProjectorView& view) {
  std::vector<CheckPose> checks(view.check_poses.rows);
  for (std::size_t k = 0; k < checks.size(); ++k) checks[k] = checkPoseOf(view.check_poses.numbers + 6 * k);
  return checks;
}

/// Builds the projector and hashes the data at the same time: both read everything once. Building may see bytes that
/// the hash then refuses; Projector::create() takes any bytes.
Result<Projector> projectorOf(const ProjectorView& view, const std::string& file_name) {
  const auto hash = [&view] { return sha256Hex(view.data.data(), view.data.size()) == view.data_sha256; };
  std::future<bool> seal_holds;
  if (view.data.size() >= kWorthAThread) {
    try {
      seal_holds = std::async(std::launch::async, hash);
    } catch (const std::system_error&) {
      // No thread to be had: one after the other, then.
    }
  }
  if (!seal_holds.valid()) seal_holds = std::async(std::launch::deferred, hash);
  Result<Projector> projector = Projector::create(view.info, view.arrays());
  if (!seal_holds.get()) return malformed(file_name, "is damaged: its data do not have the SHA-256 they should");
  if (!projector) return fail(projector.error().code, projector.error().message, file_name);
  if (const Result<void> proof = proveItself(*projector, checksOf(view), file_name); !proof) return failAs(proof);
  return projector;
}

Result<Projector> functionOf(std::string_view bytes, const std::string& file_name) {
  const Result<ProjectorView> view = openView(bytes, file_name);
  if (!view) return failAs(view);
  return projectorOf(*view, file_name);
}

Result<ProjectorData> dataOf(std::string_view bytes, const std::string& file_name) {
  Result<ProjectorView> view = openView(bytes, file_name);
  if (!view) return failAs(view);
  const Result<Projector> projector = projectorOf(*view, file_name);
  if (!projector) return failAs(projector);

  ProjectorData data;
  data.info = std::move(view->info);
  const std::size_t nodes = view->node_blueprint.rows;
  data.node_blueprint.resize(nodes);
  data.node_slam.resize(nodes);
  data.node_stretch.resize(nodes);
  data.node_tile.resize(nodes);
  for (std::size_t k = 0; k < nodes; ++k) {
    const double* slam = view->node_slam.numbers + 3 * k;
    data.node_blueprint[k] = {view->node_blueprint.numbers[2 * k], view->node_blueprint.numbers[2 * k + 1]};
    data.node_slam[k] = Pose2{{slam[0], slam[1]}, slam[2]};
    data.node_stretch[k] = {view->node_stretch.numbers[2 * k], view->node_stretch.numbers[2 * k + 1]};
    data.node_tile[k] = {view->node_tile.numbers[2 * k], view->node_tile.numbers[2 * k + 1]};
  }
  data.edges.resize(view->edges.rows);
  for (std::size_t k = 0; k < data.edges.size(); ++k)
    std::copy_n(view->edges.numbers + 2 * k, 2, data.edges[k].begin());
  data.anchors.resize(view->anchors.rows);
  for (std::size_t k = 0; k < data.anchors.size(); ++k) {
    std::copy_n(view->anchors.numbers + 4 * k, 4, data.anchors[k].begin());
  }
  data.check_poses = checksOf(*view);
  return data;
}

/// The whole file as it is now, in memory of our own. A mapped file would change under the checks when another program
/// writes to it, and end the process (SIGBUS) when it is cut.
Result<Bytes> readWhole(const std::filesystem::path& path) {
  Result<FileDescriptor> file = openRegularFile(path);
  if (!file) return failAs(file);
  const Result<std::uintmax_t> size = file->size();
  if (!size) return failAs(size);
  if (*size > kLargestProjectorPrefix) {  // before memory is taken for what may be no projector at all
    const Result<std::string> start = file->readAt(0, kLargestProjectorPrefix);
    if (!start) return failAs(start);
    const Result<void> check = checkProjectorPrefix(*start, *size, path.string());
    if (!check) return failAs(check);
  }
  Bytes bytes(static_cast<std::size_t>(*size));
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const Result<std::size_t> count = file->read(&bytes[filled].value, bytes.size() - filled);
    if (!count) return failAs(count);
    if (*count == 0) break;  // it was cut meanwhile, which the checks find
    filled += *count;
  }
  bytes.resize(filled);
  return bytes;
}

/// Gives the content of a file to a reader of bytes.
template <class Read>
auto withContent(const std::filesystem::path& path, const Read& read) -> decltype(read({}, {})) {
  const Result<Bytes> bytes = readWhole(path);
  if (!bytes) return failAs(bytes);
  return read({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path.string());
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
  template <class Number>
  void add(const char* name, std::size_t rows, std::size_t columns, const std::vector<Number>& numbers) {
    ArrayEntry& entry = header_.arrays[name];
    entry.dtype = kDtype<Number>;
    entry.shape = {rows, columns};
    entry.begin = bytes_.size();
    if (!numbers.empty()) bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
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
  const std::size_t nodes = data.node_blueprint.size();
  std::vector<double> numbers;
  DataSection section;
  for (const Eigen::Vector2d& center : data.node_blueprint) numbers.insert(numbers.end(), {center.x(), center.y()});
  section.add("node_blueprint", nodes, 2, numbers);
  numbers.clear();
  for (const Pose2& pose : data.node_slam) {
    numbers.insert(numbers.end(), {pose.translation.x(), pose.translation.y(), pose.heading});
  }
  section.add("node_slam", nodes, 3, numbers);
  numbers.clear();
  for (const Eigen::Vector2d& stretch : data.node_stretch) numbers.insert(numbers.end(), {stretch.x(), stretch.y()});
  section.add("node_stretch", nodes, 2, numbers);
  std::vector<std::int32_t> tiles;
  for (const TileCoordinate& tile : data.node_tile) tiles.insert(tiles.end(), {tile.column, tile.row});
  section.add("node_tile", nodes, 2, tiles);
  std::vector<std::uint32_t> edges;
  for (const std::array<std::uint32_t, 2>& edge : data.edges) edges.insert(edges.end(), edge.begin(), edge.end());
  section.add("edges", data.edges.size(), 2, edges);
  numbers.clear();
  for (const std::array<double, 4>& anchor : data.anchors) numbers.insert(numbers.end(), anchor.begin(), anchor.end());
  section.add("anchors", data.anchors.size(), 4, numbers);
  numbers.clear();
  for (const CheckPose& check : data.check_poses) {
    for (const Pose2& pose : {check.in_blueprint, check.in_slam}) {
      numbers.insert(numbers.end(), {pose.translation.x(), pose.translation.y(), pose.heading});
    }
  }
  section.add("check_poses", data.check_poses.size(), 6, numbers);
  return section.seal(metadataOf(data.info));
}

Result<void> writeProjectorFile(const std::filesystem::path& path, const ProjectorData& data) {
  const Result<std::string> bytes = formatProjectorFile(data);
  if (!bytes) return failAs(bytes);
  return writeFileAtomically(path, *bytes);
}

Result<ProjectorData> parseProjectorFile(std::string_view bytes, const std::string& file_name) {
  return withinMemory([&] { return dataOf(bytes, file_name); });
}

Result<ProjectorData> readProjectorFile(const std::filesystem::path& path) {
  return withinMemory([&] { return withContent(path, dataOf); });
}

Result<Projector> loadProjector(const std::filesystem::path& path) {
  return withinMemory([&] { return withContent(path, functionOf); });
}

Result<Projector> loadProjector(std::string_view bytes, const std::string& file_name) {
  return withinMemory([&] { return functionOf(bytes, file_name); });
}

}  // namespace cad2slam
