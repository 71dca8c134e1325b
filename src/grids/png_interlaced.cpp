#include "grids/png_interlaced.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "grids/faults.h"
#include "grids/png_pass.h"
#include "grids/scratch_bytes.h"
#include "packed/unpack.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

struct Pass {
  int left, top, step_x, step_y;
};
constexpr std::array<Pass, 7> kPasses{
    {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};

int stepsIn(int size, int start, int step) { return size > start ? (size - start + step - 1) / step : 0; }

class InterlacedRows final : public PictureRows {
 public:
  InterlacedRows(const PngHeader& header, ByteSource bytes, ScratchBytes picture)
      : header_(header), stream_(std::move(bytes), header.pixels_at), picture_(std::move(picture)) {}

  const PixelFormat& format() const override { return header_.format; }
  const std::uint8_t* next() override {
    if (!read_) readPasses();
    if (row_ >= whole_rows_) return nullptr;
    return rowAt(row_++);
  }
  bool rewind() override {
    row_ = 0;
    return true;
  }
  void stopWhen(const std::atomic<bool>& cancelled) override { cancelled_ = &cancelled; }
  void checkEnd() override {
    if (!problem_.any() && !stream_.checkEnd()) problem_ = stream_.problem();
  }

 private:
  std::uint8_t* rowAt(int row) { return picture_.data() + std::size_t(row) * header_.format.rowBytes(); }

  void readPasses() {
    read_ = true;
    const int width = header_.format.width, height = header_.format.height;
    for (const Pass& pass : kPasses) {
      const int columns = stepsIn(width, pass.left, pass.step_x);
      const int rows = stepsIn(height, pass.top, pass.step_y);
      if (columns == 0 || rows == 0) continue;
      PngPass reader(header_, columns);
      for (int row = 0; row < rows; ++row) {
        if (cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed)) {
          problem_ = fault::ReadingStopped;
          return;
        }
        const std::uint8_t* from = reader.next(stream_, problem_);
        if (from == nullptr) {
          // Rows above the failure are only complete in the last pass.
          whole_rows_ = pass.step_x == 1 ? pass.top + row * pass.step_y : 0;
          return;
        }
        scatter(from, columns, pass, rowAt(pass.top + row * pass.step_y));
      }
    }
    whole_rows_ = height;
  }

  void scatter(const std::uint8_t* from, int columns, const Pass& pass, std::uint8_t* to) const {
    const std::size_t unit = header_.format.pixelBytes();
    if (pass.step_x == 1) {
      std::memcpy(to, from, std::size_t(columns) * unit);
      return;
    }
    to += std::size_t(pass.left) * unit;
    for (int column = 0; column < columns; ++column, from += unit, to += std::size_t(pass.step_x) * unit) {
      std::memcpy(to, from, unit);
    }
  }

  PngHeader header_;
  PngStream stream_;
  ScratchBytes picture_;
  const std::atomic<bool>* cancelled_ = nullptr;
  bool read_ = false;
  int whole_rows_ = 0, row_ = 0;
};

}  // namespace

tl::expected<std::unique_ptr<PictureRows>, Fault> openInterlacedPng(const PngHeader& header,
                                                                    ByteSource bytes) {
  const PixelFormat& format = header.format;
  // Space is reserved for the whole picture, so these bytes must be able to contain it.
  const std::uint64_t stored =
      std::uint64_t(header.storedRowBytes(format.width)) * std::uint64_t(format.height);
  if (stored / packed::kMaxDeflateRatio > bytes.size()) {
    return tl::unexpected(Fault(fault::PngTooShortForPixels, {words::dimensions(format.width, format.height),
                                                              words::grouped(std::int64_t(bytes.size()))}));
  }
  const std::uint64_t unpacked = std::uint64_t(format.rowBytes()) * std::uint64_t(format.height);
  if (unpacked > kMaxInterlacedBytes) {
    return tl::unexpected(Fault(
        fault::InterlacedTooLarge,
        {words::dimensions(format.width, format.height), words::grouped(std::int64_t(kMaxInterlacedBytes))}));
  }
  auto picture = ScratchBytes::take(format.rowBytes() * std::size_t(format.height));
  if (!picture) {
    return tl::unexpected(
        Fault(fault::InterlacedWithoutRoom, {words::dimensions(format.width, format.height)}));
  }
  return std::make_unique<InterlacedRows>(header, std::move(bytes), std::move(*picture));
}

}  // namespace mapwright::grids
