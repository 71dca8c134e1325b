#include "pbstream/record_stream.h"

#include <algorithm>
#include <utility>

namespace mapwright::pbstream {
namespace {

constexpr std::size_t kWindowBytes = 64 << 10;
constexpr std::size_t kBufferBytes = 64 << 10;
constexpr std::size_t kFirstBufferBytes = 256;  // most records are skipped after a few bytes

}  // namespace

std::span<const std::uint8_t> FileWindow::at(std::uint64_t offset, std::size_t least) {
  const std::uint64_t end = from_ + bytes_.size();
  if (offset < from_ || offset + least > end) {
    const std::uint64_t there = offset < file_.size() ? file_.size() - offset : 0;
    bytes_.resize(std::size_t(std::min<std::uint64_t>(there, kWindowBytes)));
    from_ = offset;
    if (!file_.read(bytes_, offset)) bytes_.clear();
    return bytes_;
  }
  return std::span<const std::uint8_t>(bytes_).subspan(std::size_t(offset - from_));
}

std::uint64_t sizeAt(FileWindow& window, std::uint64_t offset) {
  const auto bytes = window.at(offset, kSizeBytes);
  std::uint64_t value = 0;
  for (std::size_t i = std::min<std::size_t>(bytes.size(), kSizeBytes); i-- > 0;)
    value = value << 8 | bytes[i];
  return value;
}

RecordStream::RecordStream(FileWindow& window) : window_(window), gunzip_({}) {}

packed::GunzipStream::More RecordStream::source() {
  return [this]() -> std::span<const std::uint8_t> {
    if (at_ >= end_) return {};
    const auto here = window_.at(at_, 1);
    const auto piece = here.first(std::size_t(std::min<std::uint64_t>(here.size(), end_ - at_)));
    at_ += piece.size();
    return piece;
  };
}

void RecordStream::start(const Record& record) {
  at_ = record.begin();
  end_ = record.end();
  gunzip_.restart(source());
  filled_ = 0;
  unpacked_ = behind_ = 0;
  too_long_ = false;
}

bool RecordStream::Next(const void** data, int* size) {
  if (behind_ > 0) {
    *data = buffer_.data() + filled_ - std::size_t(behind_);
    *size = int(std::exchange(behind_, 0));
    return true;
  }
  if (unpacked_ > kMostUnpacked - std::int64_t(kBufferBytes)) {
    too_long_ = true;
    return false;
  }
  const std::size_t most = unpacked_ == 0 ? kFirstBufferBytes : kBufferBytes;
  if (buffer_.size() < most) buffer_.resize(most);
  filled_ = gunzip_.read({buffer_.data(), most});
  unpacked_ += std::int64_t(filled_);
  *data = buffer_.data();
  *size = int(filled_);
  return filled_ > 0;
}

void RecordStream::BackUp(int count) { behind_ += count; }

bool RecordStream::Skip(int count) {
  const void* data = nullptr;
  int size = 0;
  while (count > 0) {
    if (!Next(&data, &size)) return false;
    if (size > count) BackUp(size - count);
    count -= std::min(size, count);
  }
  return true;
}

Fault RecordStream::fault() const {
  using State = packed::GunzipStream::State;
  if (too_long_) return faultText("pbstream", "it unpacks to more than 2 GB");
  if (gunzip_.state() == State::Corrupt) return faultText("pbstream", "its gzip stream is damaged");
  if (gunzip_.state() == State::Cut) return faultText("pbstream", "its gzip stream ends too early");
  return {};
}

void RecordStream::finish() {
  const void* data = nullptr;
  int size = 0;
  while (Next(&data, &size)) {
  }
}

}  // namespace mapwright::pbstream
