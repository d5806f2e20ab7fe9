// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/pixel_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace cad2slam {
namespace {

constexpr std::uint32_t kSaverUnknown = 205;  // what map_saver writes for unknown

/// Both map_servers work on 16-bit samples of their image library; 8-bit samples are stretched.
struct Pixel {
  std::uint32_t red = 0;
  std::uint32_t green = 0;
  std::uint32_t blue = 0;
  std::uint32_t alpha = 65535;
};

CellState stateOf(bool is_free, bool is_occupied) {
  return is_free ? CellState::kFree : is_occupied ? CellState::kOccupied : CellState::kUnknown;
}

/// Rec. 601 luminance in 8 bits, compared in single precision; a value on a threshold belongs to it, and free wins.
class JazzyServer {
 public:
  explicit JazzyServer(const PixelRules& rules) : keeps_alpha_(rules.mode != MapMode::kRaw) {
    const auto occupied_threshold = static_cast<float>(rules.occupied_threshold);
    const auto free_threshold = static_cast<float>(rules.free_threshold);
    for (std::uint32_t grey = 0; grey < states_.size(); ++grey) {
      if (rules.mode == MapMode::kRaw) {
        const float occupancy = static_cast<float>(grey) / 100.0F;
        states_[grey] =
            grey <= 100 ? stateOf(occupancy <= free_threshold, occupancy >= occupied_threshold) : CellState::kUnknown;
      } else {
        const float shade = static_cast<float>(grey) / 255.0F;
        const float occupancy = rules.negate ? shade : 1.0F - shade;
        states_[grey] = stateOf(occupancy <= free_threshold, occupancy >= occupied_threshold);
      }
    }
  }

  CellState operator()(const Pixel& pixel) const {
    if (keeps_alpha_ && pixel.alpha < 65535) return CellState::kUnknown;
    return states_[((299 * pixel.red + 587 * pixel.green + 114 * pixel.blue + 500) / 1000) / 257];
  }

 private:
  bool keeps_alpha_;
  std::array<CellState, 256> states_{};
};

/// Mean of the channels (alpha is one of them in trinary mode), in double precision; a value on a threshold is unknown,
/// and occupied wins.
class HumbleServer {
 public:
  HumbleServer(const PixelRules& rules, bool has_alpha) : rules_(rules), has_alpha_(has_alpha) {}

  CellState operator()(const Pixel& pixel) const {
    double sum = static_cast<double>(pixel.red) + pixel.green + pixel.blue;
    double channels = 3.0;
    if (rules_.mode == MapMode::kTrinary && has_alpha_) {
      sum += pixel.alpha;
      channels = 4.0;
    }
    const double shade = sum / channels / 65535.0;
    if (rules_.mode == MapMode::kScale && pixel.alpha < 65535) return CellState::kUnknown;
    double occupancy = rules_.negate ? shade : 1.0 - shade;
    if (rules_.mode == MapMode::kRaw) {
      const double percent = std::round(shade * 255.0);
      if (percent > 100.0) return CellState::kUnknown;
      occupancy = percent / 100.0;
    }
    const bool is_occupied = occupancy > rules_.occupied_threshold;
    return stateOf(!is_occupied && occupancy < rules_.free_threshold, is_occupied);
  }

 private:
  PixelRules rules_;
  bool has_alpha_;
};

/// Samples as they lie in the raster to 16 bits with white at 65535.
template <class Sample>
class Stretch {
 public:
  explicit Stretch(std::uint32_t full_brightness) {
    constexpr std::uint32_t kLargest = std::numeric_limits<Sample>::max();
    const std::uint32_t white = full_brightness == 0 ? kLargest : full_brightness;
    for (std::uint32_t sample = 0; sample <= kLargest; ++sample) {
      table_[sample] = static_cast<std::uint16_t>((std::min(sample, white) * 65535ULL + white / 2) / white);
    }
  }
  std::uint32_t operator()(Sample sample) const { return table_[sample]; }

 private:
  std::vector<std::uint16_t> table_ = std::vector<std::uint16_t>(std::numeric_limits<Sample>::max() + std::size_t{1});
};

/// What becomes of every opaque grey, which is nearly every pixel of nearly every map.
template <class Sample>
class GreyTable {
 public:
  static constexpr std::size_t kValues = std::numeric_limits<Sample>::max() + std::size_t{1};

  template <class ThisServer, class OtherServer>
  GreyTable(const Stretch<Sample>& stretch, const ThisServer& server, const OtherServer& other_server) {
    for (std::size_t value = 0; value < kValues; ++value) {
      const std::uint32_t grey = stretch(static_cast<Sample>(value));
      states_[value] = server(Pixel{grey, grey, grey});
      differs_[value] = other_server(Pixel{grey, grey, grey}) != states_[value];
      if (grey == kSaverUnknown * 257) saver_unknown_ = value;
    }
  }

  std::uint8_t operator()(Sample value) {
    ++counts_[value];
    return static_cast<std::uint8_t>(states_[value]);
  }
  /// Adds what the pixels that were looked up amount to.
  void report(PixelStates& result) const {
    for (std::size_t value = 0; value < kValues; ++value) {
      if (differs_[value]) result.read_differently += counts_[value];
    }
    const bool has_205 = saver_unknown_ && counts_[*saver_unknown_] > 0;
    result.grey_205_is_free = has_205 && states_[*saver_unknown_] == CellState::kFree;
  }

 private:
  std::vector<CellState> states_ = std::vector<CellState>(kValues);
  std::vector<std::uint8_t> differs_ = std::vector<std::uint8_t>(kValues);
  std::vector<std::size_t> counts_ = std::vector<std::size_t>(kValues);
  std::optional<std::size_t> saver_unknown_;
};

template <class Sample>
PixelStates classifyGrey(const cv::Mat& picture, GreyTable<Sample>& table) {
  PixelStates result;
  // Copies of a cv::Mat share their pixels; those of a caller must not change.
  const bool in_place = picture.type() == CV_8UC1 && picture.u != nullptr && picture.u->refcount == 1;
  result.states = in_place ? picture : cv::Mat(picture.rows, picture.cols, CV_8UC1);
  for (int row = 0; row < picture.rows; ++row) {
    const Sample* from = picture.ptr<Sample>(row);
    std::uint8_t* to = result.states.ptr<std::uint8_t>(row);
    for (int column = 0; column < picture.cols; ++column) to[column] = table(from[column]);
  }
  table.report(result);
  return result;
}

template <class Sample, class ThisServer, class OtherServer>
PixelStates classifyColour(const cv::Mat& picture, GreyTable<Sample>& table, const Stretch<Sample>& stretch,
                           const ThisServer& server, const OtherServer& other_server) {
  constexpr Sample kOpaque = std::numeric_limits<Sample>::max();
  const int channels = picture.channels();
  PixelStates result;
  result.states.create(picture.rows, picture.cols, CV_8UC1);
  std::size_t read_differently = 0;
  for (int row = 0; row < picture.rows; ++row) {
    const Sample* from = picture.ptr<Sample>(row);
    std::uint8_t* to = result.states.ptr<std::uint8_t>(row);
    for (int column = 0; column < picture.cols; ++column, from += channels) {
      const Sample alpha = channels == 4 ? from[3] : kOpaque;
      if (from[0] == from[1] && from[1] == from[2] && alpha == kOpaque) {
        to[column] = table(from[0]);
        continue;
      }
      const Pixel pixel{stretch(from[2]), stretch(from[1]), stretch(from[0]),
                        alpha == kOpaque ? 65535U : stretch(alpha)};
      const CellState state = server(pixel);
      to[column] = static_cast<std::uint8_t>(state);
      if (other_server(pixel) != state) ++read_differently;
    }
  }
  table.report(result);
  result.read_differently += read_differently;
  return result;
}

template <class Sample>
PixelStates classify(const cv::Mat& picture, const PixelRules& rules) {
  const Stretch<Sample> stretch(rules.full_brightness);
  const JazzyServer jazzy(rules);
  const HumbleServer humble(rules, picture.channels() == 4);
  const auto run = [&](const auto& server, const auto& other_server) {
    GreyTable<Sample> table(stretch, server, other_server);
    return picture.channels() == 1 ? classifyGrey<Sample>(picture, table)
                                   : classifyColour<Sample>(picture, table, stretch, server, other_server);
  };
  return rules.semantics == MapSemantics::kJazzy ? run(jazzy, humble) : run(humble, jazzy);
}

}  // namespace

Result<PixelStates> classifyPixels(cv::Mat picture, const PixelRules& rules) {
  const int channels = picture.channels();
  if (picture.empty() || (channels != 1 && channels != 3 && channels != 4)) {
    return fail(ErrorCode::kMalformed,
                "is an image of an unusual kind: grey, colour, or colour with alpha can be read");
  }
  if (picture.depth() == CV_8U) return classify<std::uint8_t>(picture, rules);
  if (picture.depth() == CV_16U) return classify<std::uint16_t>(picture, rules);
  return fail(ErrorCode::kMalformed, "is an image with neither 8 nor 16 bits a sample");
}

}  // namespace cad2slam
