#include "grids/byte_source.h"

#include <algorithm>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

#include "disk/read_file.h"

namespace mapwright::grids {

namespace {

constexpr std::size_t kBuffer = std::size_t(1) << 20;

}  // namespace

ByteSource::ByteSource(std::shared_ptr<const std::string> bytes)
    : bytes_(std::move(bytes)), size_(bytes_ == nullptr ? 0 : bytes_->size()) {}

std::optional<ByteSource> ByteSource::open(const std::string& path) {
  const int fd = disk::openToRead(path);
  if (fd < 0) return std::nullopt;
  struct stat about {};
  ByteSource source(nullptr);
  source.size_ = ::fstat(fd, &about) == 0 ? std::uint64_t(about.st_size) : 0;
  source.file_ = std::shared_ptr<const int>(new int(fd), [](const int* opened) {
    ::close(*opened);
    delete opened;
  });
  return source;
}

ByteSource ByteSource::again() const {
  ByteSource source(bytes_);
  source.file_ = file_;
  source.size_ = size_;
  return source;
}

bool ByteSource::readAt(std::uint64_t offset, std::uint8_t* out, std::size_t count) const {
  if (offset > size_ || count > size_ - offset) return false;
  if (file_) return disk::readAt(*file_, {out, count}, offset);
  std::memcpy(out, bytes_->data() + offset, count);
  return true;
}

std::span<const std::uint8_t> ByteSource::window(std::uint64_t offset, std::size_t most) {
  if (offset >= size_) return {};
  most = std::size_t(std::min<std::uint64_t>(most, size_ - offset));
  if (!file_) return {reinterpret_cast<const std::uint8_t*>(bytes_->data()) + offset, most};
  if (offset < buffer_at_ || offset >= buffer_at_ + buffered_) {
    buffer_.resize(kBuffer);
    buffer_at_ = offset;
    const ssize_t got = ::pread(*file_, buffer_.data(), buffer_.size(), off_t(offset));
    buffered_ = got > 0 ? std::size_t(got) : 0;
  }
  const std::size_t skip = std::size_t(offset - buffer_at_);
  return {buffer_.data() + skip, std::min(most, buffered_ - skip)};
}

}  // namespace mapwright::grids
