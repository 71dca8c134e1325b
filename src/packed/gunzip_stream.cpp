#include "packed/gunzip_stream.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>
#include <zlib.h>

namespace mapwright::packed {
namespace {

constexpr int kGzipOnly = 16 + MAX_WBITS;

}  // namespace

struct GunzipStream::Inflater {
  Inflater() {
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream); }
  z_stream stream{};
};

GunzipStream::GunzipStream(More more) : more_(std::move(more)), inflater_(std::make_unique<Inflater>()) {}
GunzipStream::~GunzipStream() = default;

void GunzipStream::restart(More more) {
  more_ = std::move(more);
  inflateReset(&inflater_->stream);
  inflater_->stream.avail_in = 0;
  state_ = State::Going;
}

std::size_t GunzipStream::read(std::span<std::uint8_t> out) {
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
  z_stream& stream = inflater_->stream;
  std::size_t filled = 0;
  while (state_ == State::Going && filled < out.size()) {
    if (stream.avail_in == 0) {
      const std::span<const std::uint8_t> packed = more_();
      if (packed.empty()) {
        state_ = State::Cut;
        break;
      }
      stream.next_in = const_cast<Bytef*>(packed.data());  // zlib only reads it
      stream.avail_in = uInt(std::min(packed.size(), kMost));
    }
    stream.next_out = out.data() + filled;
    stream.avail_out = uInt(std::min(out.size() - filled, kMost));
    const uInt room = stream.avail_out;
    const int result = inflate(&stream, Z_NO_FLUSH);
    filled += room - stream.avail_out;
    if (result == Z_STREAM_END) state_ = State::Ended;
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) state_ = State::Corrupt;
  }
  return filled;
}

}  // namespace mapwright::packed
