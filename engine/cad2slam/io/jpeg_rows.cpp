// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/picture_decoders.h"

#include <array>
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>  // after <cstdio>, which it needs

namespace cad2slam {
namespace {

/// libjpeg reports errors by longjmp, so every call into it sits in a member that holds no object to destroy.
class JpegRows : public PictureRows {
 public:
  explicit JpegRows(const std::filesystem::path& image) : PictureRows(image) {}
  ~JpegRows() override {
    if (created_) jpeg_destroy_decompress(&jpeg_);
    if (file_ != nullptr) std::fclose(file_);
  }

  /// False when the file cannot be read row by row.
  bool start() {
    file_ = std::fopen(image().c_str(), "rb");
    if (file_ == nullptr) return false;
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = &JpegRows::onError;
    errors_.emit_message = [](j_common_ptr, int) {};
    errors_.output_message = [](j_common_ptr) {};
    jpeg_.client_data = this;
    return readHeader();
  }

 private:
  bool readHeader() {
    if (setjmp(jump_) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    created_ = true;
    jpeg_stdio_src(&jpeg_, file_);
    if (jpeg_read_header(&jpeg_, TRUE) != JPEG_HEADER_OK) return false;
    if (jpeg_.data_precision != 8 || (jpeg_.num_components != 1 && jpeg_.num_components != 3)) return false;
    jpeg_.out_color_space = jpeg_.num_components == 1 ? JCS_GRAYSCALE : JCS_EXT_BGR;
    if (jpeg_start_decompress(&jpeg_) == FALSE) return false;
    describe(static_cast<int>(jpeg_.output_width), static_cast<int>(jpeg_.output_height),
             jpeg_.num_components == 1 ? CV_8UC1 : CV_8UC3);
    return jpeg_.output_components == CV_MAT_CN(type());
  }

  Result<void> decode(int /*first*/, cv::Mat& rows) override {
    for (int row = 0; row < rows.rows; ++row) {
      if (!readRow(rows.ptr(row))) return damaged(message_);
    }
    return {};
  }

  bool readRow(std::uint8_t* row) {
    if (setjmp(jump_) != 0) return false;
    return jpeg_read_scanlines(&jpeg_, &row, 1) == 1;
  }

  static void onError(j_common_ptr jpeg) {
    auto* self = static_cast<JpegRows*>(jpeg->client_data);
    std::array<char, JMSG_LENGTH_MAX> text{};
    (*jpeg->err->format_message)(jpeg, text.data());
    self->message_ = text.data();
    std::longjmp(self->jump_, 1);
  }

  std::FILE* file_ = nullptr;
  jpeg_decompress_struct jpeg_{};
  jpeg_error_mgr errors_{};
  std::jmp_buf jump_{};
  bool created_ = false;
  std::string message_;
};

}  // namespace

std::unique_ptr<PictureRows> openJpegRows(const std::filesystem::path& image) {
  return startedRows<JpegRows>(image);
}

}  // namespace cad2slam
