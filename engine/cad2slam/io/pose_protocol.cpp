// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/pose_protocol.h"

#include "cad2slam/io/text.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace cad2slam {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 5> kKeys = {"id", "op", "outside", "pose", "poses"};

/// Takes a request event by event: a batch of a million poses needs no document tree.
class RequestReader : public json::json_sax_t {
 public:
  explicit RequestReader(std::string& id) : id_(id) {}

  [[nodiscard]] Result<PoseRequest> finish() {
    if (complaint_.empty()) checkWhole();
    if (!complaint_.empty()) return fail(ErrorCode::kMalformed, complaint_);
    request_.id = id_;
    return std::move(request_);
  }
  void complain(std::string complaint) {
    if (complaint_.empty()) complaint_ = std::move(complaint);
  }

  bool null() override { return isKey("id") ? take("null") : unexpected(); }
  bool boolean(bool) override { return unexpected(); }
  bool number_integer(number_integer_t value) override {
    return isKey("id") ? take(std::to_string(value)) : number(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return isKey("id") ? take(std::to_string(value)) : number(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t& as_sent) override {
    return isKey("id") ? take(as_sent) : number(value);
  }
  bool binary(binary_t&) override { return unexpected(); }
  bool string(string_t& value) override {
    if (isKey("id")) return take(json(value).dump(-1, ' ', false, json::error_handler_t::replace));
    if (isKey("op")) return takeOperation(value);
    if (isKey("outside")) return takePolicy(value);
    return unexpected();
  }
  bool start_object(std::size_t) override {
    if (depth_ != 0) return unexpected();
    depth_ = 1;
    return true;
  }
  bool end_object() override {
    depth_ = 0;
    return true;
  }
  bool key(string_t& name) override {
    for (std::size_t k = 0; k < kKeys.size(); ++k) {
      if (name != kKeys[k]) continue;
      if (std::exchange(seen_[k], true)) return refuse("has the key " + excerpt(name) + " twice");
      key_ = kKeys[k];
      return true;
    }
    return refuse("has the unknown key " + excerpt(name));
  }
  bool start_array(std::size_t) override {
    const bool list_of_poses = depth_ == 1 && key_ == "poses";
    const bool pose = (depth_ == 1 && key_ == "pose") || (depth_ == 2 && key_ == "poses");
    if (!list_of_poses && !pose) return unexpected();
    ++depth_;
    if (pose) {
      in_pose_ = true;
      count_ = 0;
      numbers_ = {};
    }
    return true;
  }
  bool end_array() override {
    --depth_;
    if (!std::exchange(in_pose_, false)) return true;
    if (count_ < 2) return refuse("has a pose that is not x, y or x, y, heading");
    request_.poses.push_back({{numbers_[0], numbers_[1]}, numbers_[2]});
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const json::exception&) override {
    return refuse("is not valid JSON at byte " + std::to_string(position));
  }

 private:
  [[nodiscard]] bool isKey(std::string_view key) const { return depth_ == 1 && key_ == key; }
  [[nodiscard]] bool wasGiven(std::string_view key) const {
    for (std::size_t k = 0; k < kKeys.size(); ++k) {
      if (kKeys[k] == key) return seen_[k];
    }
    return false;
  }
  bool refuse(std::string complaint) {
    complain("the request " + std::move(complaint));
    return false;
  }
  bool unexpected() { return refuse(depth_ == 0 ? "is no JSON object" : "has a wrong value under " + excerpt(key_)); }
  bool take(std::string id) {
    id_ = std::move(id);
    return true;
  }
  bool number(double value) {
    if (!in_pose_ || count_ == numbers_.size()) return unexpected();
    numbers_[count_++] = value;
    return true;
  }
  bool takeOperation(const std::string& name) {
    if (name == "project") {
      request_.kind = PoseRequest::Kind::kProject;
    } else if (name == "unproject") {
      request_.kind = PoseRequest::Kind::kUnproject;
    } else if (name == "info") {
      request_.kind = PoseRequest::Kind::kInfo;
    } else {
      return refuse("has the unknown op " + excerpt(name));
    }
    return true;
  }
  bool takePolicy(const std::string& name) {
    if (name != "error" && name != "rigid") return refuse("must have outside error or rigid");
    request_.outside = name == "rigid" ? OutsidePolicy::kRigid : OutsidePolicy::kError;
    return true;
  }
  void checkWhole() {
    const bool asks_poses = request_.kind != PoseRequest::Kind::kInfo;
    request_.single = wasGiven("pose");
    if (!wasGiven("op")) return complain("the request has no op");
    if (wasGiven("pose") && wasGiven("poses")) return complain("the request has both pose and poses");
    if (asks_poses != (wasGiven("pose") || wasGiven("poses"))) {
      complain(asks_poses ? "the request has no poses" : "the request has poses for an op that takes none");
    }
  }

  std::string& id_;
  PoseRequest request_;
  std::string complaint_;
  std::string_view key_;
  std::array<bool, kKeys.size()> seen_{};
  std::array<double, 3> numbers_{};
  std::size_t count_ = 0;
  int depth_ = 0;  // open objects and lists
  bool in_pose_ = false;
};

void appendNumber(double value, std::string& out) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  if (error == std::errc()) out.append(text, end);
}

void appendPose(const Projection& answer, std::string& out) {
  if (!answer.ok()) {
    out += "null";
    return;
  }
  out += '[';
  appendNumber(answer.pose.translation.x(), out);
  out += ',';
  appendNumber(answer.pose.translation.y(), out);
  out += ',';
  appendNumber(answer.pose.heading, out);
  out += ']';
}

void appendStatus(const Projection& answer, std::string& out) {
  out += '"';
  out += nameOf(answer.status);
  out += '"';
}

void openAnswer(const std::string& id, std::string& out) {
  out += '{';
  if (!id.empty()) out.append("\"id\":").append(id).append(",");
}

std::string_view codeName(ErrorCode code) {
  switch (code) {
    case ErrorCode::kMalformed:
      return "malformed";
    case ErrorCode::kOutOfDomain:
      return "out_of_domain";
    default:
      return "internal";
  }
}

}  // namespace

std::string_view nameOf(ProjectionStatus status) {
  switch (status) {
    case ProjectionStatus::kInside:
      return "inside";
    case ProjectionStatus::kExtrapolated:
      return "extrapolated";
    case ProjectionStatus::kOutside:
      return "outside";
    case ProjectionStatus::kFolded:
      return "folded";
    case ProjectionStatus::kInvalid:
      break;
  }
  return "invalid";
}

Result<PoseRequest> parsePoseRequest(std::string_view line, std::string& id) {
  id.clear();
  RequestReader reader(id);
  // The parser takes a zero byte for the end of the text.
  if (line.find('\0') != std::string_view::npos) {
    reader.complain("the request is no text: it holds zero bytes");
  } else {
    (void)json::sax_parse(line.begin(), line.end(), &reader);
  }
  return reader.finish();
}

void appendAnswer(const PoseRequest& request, const Projection* answers, std::string& out) {
  const std::size_t count = request.poses.size();
  openAnswer(request.id, out);
  if (request.single) {
    out += "\"pose\":";
    appendPose(answers[0], out);
    out += ",\"status\":";
    appendStatus(answers[0], out);
  } else {
    out += "\"poses\":[";
    for (std::size_t k = 0; k < count; ++k) {
      if (k > 0) out += ',';
      appendPose(answers[k], out);
    }
    out += "],\"status\":[";
    for (std::size_t k = 0; k < count; ++k) {
      if (k > 0) out += ',';
      appendStatus(answers[k], out);
    }
    out += ']';
  }
  out += "}\n";
}

void appendInfo(const PoseRequest& request, const Projector& projector, std::string& out) {
  const ProjectorInfo& info = projector.info();
  const auto frame = [](const FrameInfo& described) {
    return json{{"name", described.name}, {"image_sha256", described.image_sha256}};
  };
  const json document = {{"model", info.model},
                         {"nodes", projector.nodeCount()},
                         {"cell_size_m", info.lattice.cell_size},
                         {"scale", info.scale},
                         {"outside", info.outside == OutsidePolicy::kRigid ? "rigid" : "error"},
                         {"blueprint", frame(info.blueprint)},
                         {"slam", frame(info.slam)}};
  openAnswer(request.id, out);
  out += "\"info\":" + document.dump(-1, ' ', false, json::error_handler_t::replace) + "}\n";
}

void appendError(const std::string& id, const Error& error, std::string& out) {
  openAnswer(id, out);
  const json document = {{"code", codeName(error.code)}, {"message", error.message}};
  out += "\"error\":" + document.dump(-1, ' ', false, json::error_handler_t::replace) + "}\n";
}

}  // namespace cad2slam
