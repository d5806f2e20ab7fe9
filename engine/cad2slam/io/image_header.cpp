// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/image_header.h"

#include "cad2slam/io/file_descriptor.h"
#include "cad2slam/io/text.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace cad2slam {
namespace {

constexpr std::uint64_t kLongestSide = std::uint64_t{1} << 20;  // of OpenCV's decoders
/// No picture with anything on it is packed tighter, in any of the formats.
constexpr std::uint64_t kMostPixelsPerByte = std::uint64_t{1} << 16;

enum class ByteOrder { kLittle, kBig };

/// One image file and the errors that name it. Numbers beyond the end of the file read as nothing.
class ImageFile {
 public:
  ImageFile(FileDescriptor file, std::uintmax_t size, std::string name)
      : file_(std::move(file)), size_(size), name_(std::move(name)) {}

  [[nodiscard]] std::uintmax_t size() const { return size_; }
  [[nodiscard]] Result<std::string> bytes(std::uintmax_t offset, std::size_t count) const {
    return file_.readAt(offset, count);
  }
  [[nodiscard]] tl::unexpected<Error> malformed(std::string message) const {
    return fail(ErrorCode::kMalformed, std::move(message), name_);
  }
  [[nodiscard]] tl::unexpected<Error> cutOff() const { return malformed("is cut off: the image is not complete"); }

  /// The unsigned number of `count` bytes at `offset`.
  [[nodiscard]] std::optional<std::uint64_t> number(std::uintmax_t offset, std::size_t count, ByteOrder order) const {
    const Result<std::string> raw = bytes(offset, count);
    if (!raw || raw->size() < count) return std::nullopt;
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = order == ByteOrder::kBig ? k : count - 1 - k;
      value = (value << 8) | static_cast<unsigned char>((*raw)[at]);
    }
    return value;
  }

 private:
  FileDescriptor file_;
  std::uintmax_t size_;
  std::string name_;
};

Result<void> checkSize(const ImageFile& file, const ImageHeader& header) {
  const std::string size = std::to_string(header.width_px) + " x " + std::to_string(header.height_px) + " pixels";
  if (header.width_px == 0 || header.height_px == 0) return file.malformed("is an image of " + size);
  if (header.width_px > kLongestSide || header.height_px > kLongestSide ||
      header.width_px * header.height_px > kMostPixels) {
    return file.malformed("is an image of " + size + "; at most 30000 x 30000 are read");
  }
  if (header.width_px * header.height_px > kMostPixelsPerByte * file.size()) {
    return file.malformed("claims " + size + ", which its " + std::to_string(file.size()) + " bytes cannot hold");
  }
  return {};
}

/// For raw pixels and for formats with a known tightest packing.
Result<void> checkHolds(const ImageFile& file, std::uint64_t needed_bytes) {
  if (file.size() < needed_bytes) return file.cutOff();
  return {};
}

// --- PNM: text header, then pixels as text or bytes ------------------------------------------------------------------

/// The next number of a PNM header; skips blanks and comments.
std::optional<std::uint64_t> pnmNumber(std::string_view text, std::size_t& at) {
  while (at < text.size() && (isBlank(text[at]) || text[at] == '\n' || text[at] == '\r' || text[at] == '#')) {
    at = text[at] == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
  }
  const std::size_t begin = at;
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  return parseInteger<std::uint64_t>(text.substr(begin, at - begin));
}

Result<ImageHeader> readPnm(const ImageFile& file, char kind) {
  const Result<std::string> head = file.bytes(0, 4096);
  if (!head) return failAs(head);
  std::size_t at = 2;
  const std::optional<std::uint64_t> width = pnmNumber(*head, at);
  const std::optional<std::uint64_t> height = pnmNumber(*head, at);
  const bool is_bitmap = kind == '1' || kind == '4';
  const std::optional<std::uint64_t> maximum = is_bitmap ? 1 : pnmNumber(*head, at);
  if (!width || !height || !maximum || *maximum < 1 || *maximum > 65535) {
    return file.malformed("is no image: its PNM header does not say width, height and largest value");
  }
  ImageHeader header{*width, *height};
  header.pnm_kind = kind;
  if (const Result<void> sane = checkSize(file, header); !sane) return failAs(sane);
  const bool is_text = kind <= '3';
  const bool is_wide = *maximum > 255;
  const std::uint64_t samples = (kind == '3' || kind == '6' ? 3 : 1) * *width;
  if (is_text) {
    // Every sample is a digit and, unless it is a bit, at least a blank.
    const std::uint64_t row_bytes = is_bitmap ? samples : 2 * samples;
    if (const Result<void> holds = checkHolds(file, at + row_bytes * *height); !holds) return failAs(holds);
  } else {
    const std::uint64_t row_bytes = is_bitmap ? (samples + 7) / 8 : samples * (is_wide ? 2 : 1);
    header.pixels_at = at + 1;  // one blank ends the header
    if (const Result<void> holds = checkHolds(file, header.pixels_at + row_bytes * *height); !holds)
      return failAs(holds);
  }
  // The decoder stretches 8-bit text to 255 and leaves everything else as it stands in the file.
  const bool is_stretched = is_bitmap || (is_text && !is_wide);
  if (!is_stretched) header.full_brightness = static_cast<std::uint32_t>(*maximum);
  return header;
}

// --- PNG: chunks of length, name, bytes, checksum --------------------------------------------------------------------

Result<ImageHeader> readPngSize(const ImageFile& file) {
  const auto width = file.number(16, 4, ByteOrder::kBig);
  const auto height = file.number(20, 4, ByteOrder::kBig);
  const auto depth = file.number(24, 1, ByteOrder::kBig);
  if (!width || !height || !depth) return file.cutOff();
  const ImageHeader header{*width, *height};
  if (const Result<void> sane = checkSize(file, header); !sane) return failAs(sane);
  // Deflate packs 1032 bytes into one at best.
  const std::uint64_t raw_bytes = *width * *height * std::max<std::uint64_t>(*depth, 1) / 8;
  if (const Result<void> holds = checkHolds(file, raw_bytes / 1032); !holds) return failAs(holds);
  return header;
}

Result<void> checkPngChunks(const ImageFile& file) {
  constexpr std::size_t kPieceBytes = std::size_t{1} << 18;
  std::uintmax_t offset = 8;
  while (true) {
    const auto length = file.number(offset, 4, ByteOrder::kBig);
    if (!length || *length > file.size() || offset + 12 + *length > file.size()) return file.cutOff();
    const std::uintmax_t end = offset + 8 + *length;
    const Result<std::string> name = file.bytes(offset + 4, 4);
    if (!name) return failAs(name);
    uLong checksum = crc32(0, nullptr, 0);
    for (std::uintmax_t at = offset + 4; at < end; at += kPieceBytes) {
      const Result<std::string> piece = file.bytes(at, std::min<std::uintmax_t>(kPieceBytes, end - at));
      if (!piece) return failAs(piece);
      checksum = crc32(checksum, reinterpret_cast<const Bytef*>(piece->data()), static_cast<uInt>(piece->size()));
    }
    if (file.number(end, 4, ByteOrder::kBig) != checksum) {
      return file.malformed("is damaged: wrong checksum in the PNG chunk at byte " + std::to_string(offset));
    }
    if (*name == "IEND") return {};
    offset = end + 4;
  }
}

Result<ImageHeader> readPng(const ImageFile& file, ImageCheck check) {
  Result<ImageHeader> header = readPngSize(file);
  if (!header || check == ImageCheck::kSize) return header;
  if (const Result<void> intact = checkPngChunks(file); !intact) return failAs(intact);
  return header;
}

// --- JPEG: a sequence of marked segments -----------------------------------------------------------------------------

bool isFrameMarker(std::uint64_t marker) {  // SOF0 to SOF15 without DHT, JPG and DAC
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

Result<ImageHeader> readJpeg(const ImageFile& file) {
  constexpr std::uint64_t kStartOfScan = 0xDA;
  constexpr std::size_t kTailBytes = std::size_t{1} << 16;
  std::optional<ImageHeader> header;
  std::uintmax_t offset = 2;
  while (true) {
    const auto prefix = file.number(offset, 1, ByteOrder::kBig);
    const auto marker = file.number(offset + 1, 1, ByteOrder::kBig);
    if (!prefix || !marker) return file.cutOff();
    if (*prefix != 0xFF) return file.malformed("is damaged: no JPEG segment at byte " + std::to_string(offset));
    if (*marker == 0xFF) {  // padding
      ++offset;
      continue;
    }
    if (*marker == kStartOfScan) break;
    const auto length = file.number(offset + 2, 2, ByteOrder::kBig);
    if (!length) return file.cutOff();
    if (*length < 2) return file.malformed("is damaged: empty JPEG segment at byte " + std::to_string(offset));
    if (isFrameMarker(*marker)) {
      const auto height = file.number(offset + 5, 2, ByteOrder::kBig);
      const auto width = file.number(offset + 7, 2, ByteOrder::kBig);
      if (!height || !width) return file.cutOff();
      header = ImageHeader{*width, *height};
      if (const Result<void> sane = checkSize(file, *header); !sane) return failAs(sane);
    }
    offset += 2 + *length;
  }
  if (!header) return file.malformed("is damaged: a JPEG without a frame header");
  // The decoder fills what is missing with grey and says nothing; so the end mark must be there.
  const std::uintmax_t tail_begin =
      std::max<std::uintmax_t>(offset, file.size() - std::min<std::uintmax_t>(file.size(), kTailBytes));
  const Result<std::string> tail = file.bytes(tail_begin, kTailBytes);
  if (!tail) return failAs(tail);
  if (tail->find("\xff\xd9") == std::string::npos) return file.cutOff();
  return *header;
}

// --- BMP -------------------------------------------------------------------------------------------------------------

Result<ImageHeader> readBmp(const ImageFile& file) {
  constexpr auto kLittle = ByteOrder::kLittle;
  const auto pixels_at = file.number(10, 4, kLittle);
  const auto header_bytes = file.number(14, 4, kLittle);
  if (!pixels_at || !header_bytes) return file.cutOff();
  const bool is_os2 = *header_bytes == 12;
  const auto width = is_os2 ? file.number(18, 2, kLittle) : file.number(18, 4, kLittle);
  const auto height = is_os2 ? file.number(20, 2, kLittle) : file.number(22, 4, kLittle);
  const auto bits = file.number(is_os2 ? 24 : 28, 2, kLittle);
  const auto compression = is_os2 ? std::optional<std::uint64_t>(0) : file.number(30, 4, kLittle);
  if (!width || !height || !bits || !compression) return file.cutOff();
  // A negative height says that the first row is the top one.
  const std::uint64_t rows = !is_os2 && *height > 0x7fffffffU ? 0x100000000ULL - *height : *height;
  const ImageHeader header{*width, rows};
  if (const Result<void> sane = checkSize(file, header); !sane) return failAs(sane);
  const bool is_raw = *compression == 0 || *compression == 3;
  const std::uint64_t row_bytes = (*width * *bits + 31) / 32 * 4;
  if (is_raw) {
    if (const Result<void> holds = checkHolds(file, *pixels_at + row_bytes * rows); !holds) return failAs(holds);
  }
  return header;
}

// --- TIFF: the tags of the first image -------------------------------------------------------------------------------

Result<ImageHeader> readTiff(const ImageFile& file, ByteOrder order, bool is_big) {
  constexpr std::uint64_t kMostTags = 4096;
  const std::size_t word = is_big ? 8 : 4;
  const auto directory = file.number(is_big ? 8 : 4, word, order);
  const auto count = directory ? file.number(*directory, is_big ? 8 : 2, order) : std::nullopt;
  if (!count) return file.cutOff();
  if (*count > kMostTags) return file.malformed("is no image: its TIFF directory has too many entries");
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t compression = 1;
  const std::uintmax_t first = *directory + (is_big ? 8 : 2);
  for (std::uint64_t k = 0; k < *count; ++k) {
    const std::uintmax_t entry = first + k * (is_big ? 20 : 12);
    const auto tag = file.number(entry, 2, order);
    const auto type = file.number(entry + 2, 2, order);
    if (!tag || !type) return file.cutOff();
    if (*tag != 256 && *tag != 257 && *tag != 259) continue;
    const std::size_t bytes = *type == 3 ? 2 : *type == 4 ? 4 : *type == 16 && is_big ? 8 : 0;
    const auto value = bytes > 0 ? file.number(entry + (is_big ? 12 : 8), bytes, order) : std::nullopt;
    if (!value) return file.malformed("is no image: its TIFF directory does not say width and height");
    (*tag == 256 ? width : *tag == 257 ? height : compression) = *value;
  }
  const ImageHeader header{width, height};
  if (const Result<void> sane = checkSize(file, header); !sane) return failAs(sane);
  if (compression == 1) {  // one bit a pixel is the least
    if (const Result<void> holds = checkHolds(file, (width + 7) / 8 * height); !holds) return failAs(holds);
  }
  return header;
}

}  // namespace

Result<ImageHeader> readImageHeader(const std::filesystem::path& image, ImageCheck check) {
  Result<FileDescriptor> descriptor = openRegularFile(image);
  if (!descriptor) return failAs(descriptor);
  const Result<std::uintmax_t> size = descriptor->size();
  if (!size) return failAs(size);
  const ImageFile file(std::move(*descriptor), *size, image.string());
  const Result<std::string> head = file.bytes(0, 8);
  if (!head) return failAs(head);
  if (head->empty()) return file.malformed("is empty");

  const auto begins = [&head](std::string_view magic) { return head->compare(0, magic.size(), magic) == 0; };
  const auto as = [](ImageFormat format, Result<ImageHeader> header) {
    if (header) header->format = format;
    return header;
  };
  const auto tiff = [&](ByteOrder order, bool is_big) { return as(ImageFormat::kTiff, readTiff(file, order, is_big)); };
  if (begins("\x89PNG\r\n\x1a\n")) return as(ImageFormat::kPng, readPng(file, check));
  if (begins("\xff\xd8")) return as(ImageFormat::kJpeg, readJpeg(file));
  if (begins("BM")) return as(ImageFormat::kBmp, readBmp(file));
  if (begins(std::string_view("II*\0", 4))) return tiff(ByteOrder::kLittle, false);
  if (begins(std::string_view("MM\0*", 4))) return tiff(ByteOrder::kBig, false);
  if (begins(std::string_view("II+\0", 4))) return tiff(ByteOrder::kLittle, true);
  if (begins(std::string_view("MM\0+", 4))) return tiff(ByteOrder::kBig, true);
  if (head->size() >= 3 && (*head)[0] == 'P' && (*head)[1] >= '1' && (*head)[1] <= '6')
    return as(ImageFormat::kPnm, readPnm(file, (*head)[1]));
  return file.malformed("is no image that can be read: PGM, PNG, JPG, BMP and TIFF can");
}

}  // namespace cad2slam
