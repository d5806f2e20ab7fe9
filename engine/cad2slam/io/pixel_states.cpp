// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/pixel_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
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

template <class Sample, class ThisServer, class OtherServer>
PixelStates classifyGrey(cv::Mat picture, const Stretch<Sample>& stretch, const ThisServer& server,
                         const OtherServer& other_server) {
  constexpr std::size_t kValues = std::numeric_limits<Sample>::max() + std::size_t{1};
  std::vector<CellState> state_of(kValues);
  std::vector<std::size_t> count_of(kValues);
  for (std::size_t value = 0; value < kValues; ++value) {
    const std::uint32_t grey = stretch(static_cast<Sample>(value));
    state_of[value] = server(Pixel{grey, grey, grey});
  }
  PixelStates result;
  // Copies of a cv::Mat share their pixels; those of a caller must not change.
  const bool in_place = picture.type() == CV_8UC1 && picture.u != nullptr && picture.u->refcount == 1;
  result.states = in_place ? picture : cv::Mat(picture.rows, picture.cols, CV_8UC1);
  for (int row = 0; row < picture.rows; ++row) {
    const Sample* from = picture.ptr<Sample>(row);
    std::uint8_t* to = result.states.ptr<std::uint8_t>(row);
    for (int column = 0; column < picture.cols; ++column) {
      const Sample value = from[column];
      ++count_of[value];
      to[column] = static_cast<std::uint8_t>(state_of[value]);
    }
  }
  for (std::size_t value = 0; value < kValues; ++value) {
    const std::uint32_t grey = stretch(static_cast<Sample>(value));
    if (count_of[value] == 0) continue;
    if (other_server(Pixel{grey, grey, grey}) != state_of[value]) result.read_differently += count_of[value];
    if (grey == kSaverUnknown * 257 && state_of[value] == CellState::kFree) result.grey_205_is_free = true;
  }
  return result;
}

template <class Sample, class ThisServer, class OtherServer>
PixelStates classifyColour(const cv::Mat& picture, const Stretch<Sample>& stretch, const ThisServer& server,
                           const OtherServer& other_server) {
  const int channels = picture.channels();
  PixelStates result;
  result.states.create(picture.rows, picture.cols, CV_8UC1);
  for (int row = 0; row < picture.rows; ++row) {
    const Sample* from = picture.ptr<Sample>(row);
    std::uint8_t* to = result.states.ptr<std::uint8_t>(row);
    for (int column = 0; column < picture.cols; ++column, from += channels) {
      Pixel pixel{stretch(from[2]), stretch(from[1]), stretch(from[0])};
      if (channels == 4) pixel.alpha = stretch(from[3]);
      const CellState state = server(pixel);
      to[column] = static_cast<std::uint8_t>(state);
      if (other_server(pixel) != state) ++result.read_differently;
      const bool is_205 = pixel.red == kSaverUnknown * 257 && pixel.red == pixel.green && pixel.red == pixel.blue;
      if (is_205 && state == CellState::kFree) result.grey_205_is_free = true;
    }
  }
  return result;
}

template <class Sample>
PixelStates classify(cv::Mat picture, const PixelRules& rules) {
  const Stretch<Sample> stretch(rules.full_brightness);
  const JazzyServer jazzy(rules);
  const HumbleServer humble(rules, picture.channels() == 4);
  const auto run = [&](const auto& server, const auto& other_server) {
    return picture.channels() == 1 ? classifyGrey<Sample>(std::move(picture), stretch, server, other_server)
                                   : classifyColour<Sample>(picture, stretch, server, other_server);
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
  if (picture.depth() == CV_8U) return classify<std::uint8_t>(std::move(picture), rules);
  if (picture.depth() == CV_16U) return classify<std::uint16_t>(std::move(picture), rules);
  return fail(ErrorCode::kMalformed, "is an image with neither 8 nor 16 bits a sample");
}

}  // namespace cad2slam
