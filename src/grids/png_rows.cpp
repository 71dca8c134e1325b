// PNG as a stream of rows.
#include <cstring>
#include <vector>

#include "grids/picture_rows.h"
#include "grids/png_header.h"
#include "grids/png_interlaced.h"
#include "grids/png_pass.h"

namespace mapwright::grids {

namespace {

class PngRows final : public PictureRows {
 public:
  PngRows(const PngHeader& header, ByteSource bytes)
      : format_(header.format),
        stream_(std::move(bytes), header.pixels_at),
        pass_(header, header.format.width) {}

  const PixelFormat& format() const override { return format_; }
  const std::uint8_t* next() override {
    if (row_ == format_.height) return nullptr;
    const std::uint8_t* row = pass_.next(stream_, problem_);
    if (row != nullptr) ++row_;
    return row;
  }
  void checkEnd() override {
    if (!stream_.checkEnd()) problem_ = stream_.problem();
  }

 private:
  PixelFormat format_;
  PngStream stream_;
  PngPass pass_;
  int row_ = 0;
};

}  // namespace

tl::expected<std::unique_ptr<PictureRows>, Fault> openPng(ByteSource bytes) {
  auto header = readPngHeader(bytes);
  if (!header) return tl::unexpected(std::move(header.error()));
  if (header->interlaced) return openInterlacedPng(*header, std::move(bytes));
  return std::make_unique<PngRows>(*header, std::move(bytes));
}

}  // namespace mapwright::grids
