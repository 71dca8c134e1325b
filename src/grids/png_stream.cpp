#include "grids/png_stream.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include "grids/faults.h"
#include "grids/png_header.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

constexpr std::size_t kInput = std::size_t(64) << 10;  // a piece goes through checksum and inflate while hot
constexpr std::size_t kWindow = std::size_t(256) << 10;  // unpacked at a time

}  // namespace

PngStream::PngStream(ByteSource bytes, std::uint64_t at)
    : bytes_(std::move(bytes)), at_(at), state_(std::make_unique<inflate_state>()) {
  isal_inflate_init(state_.get());
  state_->crc_flag = ISAL_ZLIB;
}

PngStream::~PngStream() = default;

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
    problem_ = {fault::ChecksumWrong, {words::grouped(std::int64_t(at_))}};
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

}  // namespace mapwright::grids
