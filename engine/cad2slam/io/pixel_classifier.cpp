// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/pixel_classifier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
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

  std::uint8_t operator()(Sample value, std::size_t times = 1) {
    counts_[value] += times;
    return static_cast<std::uint8_t>(states_[value]);
  }
  /// What the pixels that were looked up amount to.
  [[nodiscard]] PixelNotes notes() const {
    PixelNotes notes;
    for (std::size_t value = 0; value < kValues; ++value) {
      if (differs_[value]) notes.read_differently += counts_[value];
    }
    const bool has_205 = saver_unknown_ && counts_[*saver_unknown_] > 0;
    notes.grey_205_is_free = has_205 && states_[*saver_unknown_] == CellState::kFree;
    return notes;
  }

 private:
  std::vector<CellState> states_ = std::vector<CellState>(kValues);
  std::vector<std::uint8_t> differs_ = std::vector<std::uint8_t>(kValues);
  std::vector<std::size_t> counts_ = std::vector<std::size_t>(kValues);
  std::optional<std::size_t> saver_unknown_;
};

/// Of equal samples from `first` on; looks at eight bytes at once where it can.
template <class Sample>
const Sample* endOfRun(const Sample* first, const Sample* end) {
  constexpr std::ptrdiff_t kSamples = sizeof(std::uint64_t) / sizeof(Sample);
  const Sample* at = first + 1;
  if (end - at >= kSamples) {
    const std::uint64_t same = std::numeric_limits<std::uint64_t>::max() / std::numeric_limits<Sample>::max() * *first;
    for (std::uint64_t samples = 0; end - at >= kSamples; at += kSamples) {
      std::memcpy(&samples, at, sizeof samples);
      if (samples != same) break;
    }
  }
  return std::find_if(at, end, [first](Sample sample) { return sample != *first; });
}

template <class Sample, class ThisServer, class OtherServer>
class ClassifierOf : public PixelClassifier {
 public:
  ClassifierOf(int channels, const PixelRules& rules, ThisServer server, OtherServer other_server)
      : channels_(channels),
        stretch_(rules.full_brightness),
        server_(std::move(server)),
        other_server_(std::move(other_server)),
        table_(stretch_, server_, other_server_) {}

  cv::Mat classify(const cv::Mat& piece) override {
    cv::Mat states(piece.rows, piece.cols, CV_8UC1);
    for (int row = 0; row < piece.rows; ++row) {
      const Sample* from = piece.ptr<Sample>(row);
      std::uint8_t* to = states.ptr<std::uint8_t>(row);
      if (channels_ == 1) {
        classifyGreys(from, from + piece.cols, to);
      } else {
        for (int column = 0; column < piece.cols; ++column, from += channels_) to[column] = ofColour(from);
      }
    }
    return states;
  }

  [[nodiscard]] PixelNotes notes() const override {
    PixelNotes notes = table_.notes();
    notes.read_differently += read_differently_;
    return notes;
  }

 private:
  /// Run by run: most of a map is long runs of the same grey.
  void classifyGreys(const Sample* from, const Sample* end, std::uint8_t* to) {
    while (from != end) {
      const Sample* run_end = endOfRun(from, end);
      const auto length = static_cast<std::size_t>(run_end - from);
      std::memset(to, table_(*from, length), length);
      to += length;
      from = run_end;
    }
  }

  std::uint8_t ofColour(const Sample* bgra) {
    constexpr Sample kOpaque = std::numeric_limits<Sample>::max();
    const Sample alpha = channels_ == 4 ? bgra[3] : kOpaque;
    if (bgra[0] == bgra[1] && bgra[1] == bgra[2] && alpha == kOpaque) return table_(bgra[0]);
    const Pixel pixel{stretch_(bgra[2]), stretch_(bgra[1]), stretch_(bgra[0]),
                      alpha == kOpaque ? 65535U : stretch_(alpha)};
    const CellState state = server_(pixel);
    if (other_server_(pixel) != state) ++read_differently_;
    return static_cast<std::uint8_t>(state);
  }

  int channels_;
  Stretch<Sample> stretch_;
  ThisServer server_;
  OtherServer other_server_;
  GreyTable<Sample> table_;
  std::size_t read_differently_ = 0;
};

template <class Sample>
std::unique_ptr<PixelClassifier> createFor(int channels, const PixelRules& rules) {
  JazzyServer jazzy(rules);
  HumbleServer humble(rules, channels == 4);
  if (rules.semantics == MapSemantics::kJazzy) {
    return std::make_unique<ClassifierOf<Sample, JazzyServer, HumbleServer>>(channels, rules, jazzy, humble);
  }
  return std::make_unique<ClassifierOf<Sample, HumbleServer, JazzyServer>>(channels, rules, humble, jazzy);
}

}  // namespace

Result<std::unique_ptr<PixelClassifier>> PixelClassifier::create(int type, const PixelRules& rules) {
  const int channels = CV_MAT_CN(type);
  if (channels != 1 && channels != 3 && channels != 4) {
    return fail(ErrorCode::kMalformed,
                "is an image of an unusual kind: grey, colour, or colour with alpha can be read");
  }
  if (CV_MAT_DEPTH(type) == CV_8U) return createFor<std::uint8_t>(channels, rules);
  if (CV_MAT_DEPTH(type) == CV_16U) return createFor<std::uint16_t>(channels, rules);
  return fail(ErrorCode::kMalformed, "is an image with neither 8 nor 16 bits a sample");
}

}  // namespace cad2slam
