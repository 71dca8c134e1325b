// PNG as a stream of rows. Source: PNG specification (third edition), "IDAT Image data", "Interlacing"; RFC
// 1950. Not libspng: of 20,000 x 20,000 pixels this takes 0.16 s where libspng's progressive mode takes 0.54
// s (plain areas), and 0.35 s instead of 1.13 s (noise), because ISA-L inflates three times as fast as zlib.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <memory>
#include <vector>

#include "grids/faults.h"
#include "grids/picture_rows.h"
#include "grids/png_header.h"
#include "packed/png_unfilter.h"
#include "packed/unpack.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

constexpr std::size_t kInput = std::size_t(64) << 10;  // a piece goes through checksum and inflate while hot
constexpr std::size_t kWindow = std::size_t(256) << 10;  // unpacked at a time

/// The maximum unpacked size of an interlaced picture (16,384 x 16,384 grays): all seven passes are needed
/// before the first row is complete, so a small file must not demand unlimited memory. No program that writes
/// maps interlaces them.
constexpr std::uint64_t kMaxInterlacedBytes = std::uint64_t(1) << 28;

/// The unpacked bytes of the pixel stream (IDAT).
class PngStream {
 public:
  /// `at`: offset of the first IDAT chunk.
  PngStream(ByteSource bytes, std::uint64_t at);
  /// The next `count` bytes, valid until the next call; null if they are missing: see problem().
  const std::uint8_t* take(std::size_t count);
  /// Checks the checksums after the last byte that is needed. False: see problem().
  bool checkEnd();
  /// "its data ends", "its checksum is wrong", .. ; empty = nothing is wrong.
  const Fault& problem() const { return problem_; }

 private:
  bool nextInput();
  bool enterChunk();
  bool endChunk();
  bool fill(std::size_t count);

  ByteSource bytes_;
  std::uint64_t at_;        // of the next input byte or chunk
  std::uint32_t left_ = 0;  // input bytes of the chunk not yet used
  bool in_chunk_ = false;
  std::uint32_t sum_ = 0;
  std::unique_ptr<inflate_state> state_;
  std::vector<std::uint8_t> window_;
  std::size_t begin_ = 0, end_ = 0;  // unpacked, not yet taken
  Fault problem_;
};

PngStream::PngStream(ByteSource bytes, std::uint64_t at)
    : bytes_(std::move(bytes)), at_(at), state_(std::make_unique<inflate_state>()) {
  isal_inflate_init(state_.get());
  state_->crc_flag = ISAL_ZLIB;
}

bool PngStream::enterChunk() {
  const auto chunk = pngChunkAt(bytes_, at_);
  if (!chunk || !chunk->is("IDAT")) {
    problem_ = fault::DataEnds;
    return false;
  }
  sum_ = crc32_gzip_refl(0, reinterpret_cast<const std::uint8_t*>(chunk->type.data()), chunk->type.size());
  left_ = chunk->length;
  at_ += 8;
  in_chunk_ = true;
  return true;
}

bool PngStream::endChunk() {
  std::array<std::uint8_t, 4> stored{};
  if (!bytes_.readAt(at_, stored.data(), stored.size())) {
    problem_ = fault::DataEnds;
    return false;
  }
  const std::uint32_t expected = std::uint32_t(stored[0]) << 24 | std::uint32_t(stored[1]) << 16 |
                                 std::uint32_t(stored[2]) << 8 | stored[3];
  if (expected != sum_) {
    problem_ = {faultText("grids", "a checksum in it is wrong (near byte %1)"),
                {words::grouped(std::int64_t(at_))}};
    return false;
  }
  at_ += stored.size();
  in_chunk_ = false;
  return true;
}

bool PngStream::nextInput() {
  while (left_ == 0) {
    if (in_chunk_ && !endChunk()) return false;
    if (!enterChunk()) return false;
  }
  const auto piece = bytes_.window(at_, std::min<std::size_t>(kInput, left_));
  if (piece.empty()) {
    problem_ = fault::DataEnds;
    return false;
  }
  sum_ = crc32_gzip_refl(sum_, piece.data(), piece.size());
  state_->next_in = const_cast<std::uint8_t*>(piece.data());
  state_->avail_in = std::uint32_t(piece.size());
  at_ += piece.size();
  left_ -= std::uint32_t(piece.size());
  return true;
}

bool PngStream::fill(std::size_t count) {
  if (begin_ > 0) std::memmove(window_.data(), window_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const std::size_t size = std::max(kWindow, count + kWindow / 2);
  if (window_.size() < size) window_.resize(size);
  while (end_ < count) {
    if (state_->block_state == ISAL_BLOCK_FINISH) {
      problem_ = fault::DataEnds;
      return false;
    }
    if (state_->avail_in == 0 && state_->block_state != ISAL_BLOCK_INPUT_DONE && !nextInput()) {
      // Data unpacked but still held back belongs to rows that have arrived.
      if (problem_.code != fault::DataEnds) return false;
      state_->next_in = nullptr;
    }
    state_->next_out = window_.data() + end_;
    state_->avail_out = std::uint32_t(window_.size() - end_);
    const std::uint32_t before = state_->avail_out;
    const int result = isal_inflate(state_.get());
    end_ += before - state_->avail_out;
    if (result < 0) {
      problem_ = result == ISAL_INCORRECT_CHECKSUM ? fault::PixelChecksumWrong : fault::DataDamaged;
      return end_ >= count;
    }
    if (problem_.any() && before == state_->avail_out) return false;
  }
  return true;
}

const std::uint8_t* PngStream::take(std::size_t count) {
  if (end_ - begin_ < count) {
    if (problem_.any() || !fill(count)) return nullptr;
  }
  const std::uint8_t* taken = window_.data() + begin_;
  begin_ += count;
  return taken;
}

bool PngStream::checkEnd() {
  if (problem_.code == fault::DataEnds)
    problem_ = {};  // the pixels are complete, only the trailer is missing
  while (!problem_.any() && state_->block_state != ISAL_BLOCK_FINISH) {
    std::array<std::uint8_t, 64> beyond;
    if (state_->avail_in == 0 && !nextInput()) break;
    state_->next_out = beyond.data();
    state_->avail_out = std::uint32_t(beyond.size());
    const int result = isal_inflate(state_.get());
    if (result == ISAL_INCORRECT_CHECKSUM) problem_ = fault::PixelChecksumWrong;
    // More pixels than declared, or garbage after the last one: not a valid map.
    if (result < 0 || state_->avail_out < beyond.size()) break;
  }
  while (!problem_.any() && in_chunk_) {
    if (left_ == 0) {
      endChunk();
      break;
    }
    state_->avail_in = 0;
    if (!nextInput()) break;
  }
  if (problem_.code == fault::DataEnds) problem_ = {};
  return !problem_.any();
}

/// The rows of one pass, or of the whole picture if it is not interlaced.
class PngPass {
 public:
  /// `width`: pixels per row of this pass, at least 1.
  PngPass(const PngHeader& header, int width);
  /// The next row, unpacked to header.format's pixels; null: see `problem`.
  const std::uint8_t* next(PngStream& stream, Fault& problem);

 private:
  int width_, bit_depth_;
  std::size_t stored_bytes_, unit_;
  std::vector<std::uint8_t> row_, above_, unpacked_;
};

PngPass::PngPass(const PngHeader& header, int width)
    : width_(width),
      bit_depth_(header.bit_depth),
      stored_bytes_(header.storedRowBytes(width)),
      unit_(std::size_t(std::max(1, header.stored_channels * header.bit_depth / 8))),
      row_(stored_bytes_),
      above_(stored_bytes_),
      unpacked_(header.bit_depth < 8 ? std::size_t(width) : 0) {}

const std::uint8_t* PngPass::next(PngStream& stream, Fault& problem) {
  const std::uint8_t* filtered = stream.take(1 + stored_bytes_);
  if (filtered == nullptr) {
    problem = stream.problem();
    return nullptr;
  }
  row_.swap(above_);
  if (!packed::unfilterRow(filtered[0], filtered + 1, above_.data(), stored_bytes_, unit_, row_.data())) {
    problem = fault::DataDamaged;
    return nullptr;
  }
  if (bit_depth_ >= 8) return row_.data();
  packed::unpackBits(row_.data(), std::size_t(width_), bit_depth_, unpacked_.data());
  return unpacked_.data();
}

struct Pass {
  int left, top, step_x, step_y;
};
constexpr std::array<Pass, 7> kPasses{
    {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};

int stepsIn(int size, int start, int step) { return size > start ? (size - start + step - 1) / step : 0; }

/// Untouched memory is not taken.
struct FreePicture {
  void operator()(std::uint8_t* bytes) const { std::free(bytes); }
};
using Picture = std::unique_ptr<std::uint8_t[], FreePicture>;

class InterlacedRows final : public PictureRows {
 public:
  InterlacedRows(const PngHeader& header, ByteSource bytes, Picture picture)
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
  std::uint8_t* rowAt(int row) { return picture_.get() + std::size_t(row) * header_.format.rowBytes(); }

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
          problem_ = faultText("grids", "reading was cancelled");
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
  Picture picture_;
  const std::atomic<bool>* cancelled_ = nullptr;
  bool read_ = false;
  int whole_rows_ = 0, row_ = 0;
};

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

tl::expected<std::unique_ptr<PictureRows>, Fault> openInterlacedPng(const PngHeader& header,
                                                                    ByteSource bytes) {
  const PixelFormat& format = header.format;
  // Memory is taken for the whole picture, so these bytes must be able to contain it.
  const std::uint64_t stored =
      std::uint64_t(header.storedRowBytes(format.width)) * std::uint64_t(format.height);
  if (stored / packed::kMaxDeflateRatio > bytes.size()) {
    return tl::unexpected(
        Fault(faultText("grids", "Its header says %1 pixels, but its %2 bytes cannot hold so many."),
              {words::dimensions(format.width, format.height), words::grouped(std::int64_t(bytes.size()))}));
  }
  const std::uint64_t unpacked = std::uint64_t(format.rowBytes()) * std::uint64_t(format.height);
  if (unpacked > kMaxInterlacedBytes) {
    return tl::unexpected(Fault(
        faultText("grids",
                  "It is an interlaced picture of %1 pixels. Interlaced pictures are read up to "
                  "%2 bytes unpacked: save it without interlacing."),
        {words::dimensions(format.width, format.height), words::grouped(std::int64_t(kMaxInterlacedBytes))}));
  }
  Picture picture(static_cast<std::uint8_t*>(std::calloc(std::size_t(format.height), format.rowBytes())));
  if (!picture) {
    return tl::unexpected(Fault(
        faultText(
            "grids",
            "It is an interlaced picture of %1 pixels, and there is not enough memory to unpack it. Save the "
            "picture without interlacing."),
        {words::dimensions(format.width, format.height)}));
  }
  return std::make_unique<InterlacedRows>(header, std::move(bytes), std::move(picture));
}

}  // namespace

tl::expected<std::unique_ptr<PictureRows>, Fault> openPng(ByteSource bytes) {
  auto header = readPngHeader(bytes);
  if (!header) return tl::unexpected(std::move(header.error()));
  if (header->interlaced) return openInterlacedPng(*header, std::move(bytes));
  return std::make_unique<PngRows>(*header, std::move(bytes));
}

}  // namespace mapwright::grids
