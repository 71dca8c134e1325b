#include "grids/byte_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mapwright::grids {

namespace {

constexpr std::size_t kBuffer = std::size_t(1) << 20;

}  // namespace

ByteSource::ByteSource(std::shared_ptr<const std::string> bytes)
    : bytes_(std::move(bytes)), size_(bytes_ == nullptr ? 0 : bytes_->size()) {}

ByteSource::ByteSource(int fd, std::uint64_t size) : fd_(fd), size_(size), buffer_(kBuffer) {}

ByteSource::ByteSource(ByteSource&& other) noexcept
    : bytes_(std::move(other.bytes_)),
      fd_(std::exchange(other.fd_, -1)),
      size_(other.size_),
      buffer_(std::move(other.buffer_)),
      buffer_at_(other.buffer_at_),
      buffered_(other.buffered_) {}

ByteSource::~ByteSource() {
  if (fd_ >= 0) ::close(fd_);
}

std::optional<ByteSource> ByteSource::open(const std::string& path) {
  // Non-blocking: a named pipe must not block the thread before it is detected.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) return std::nullopt;
  struct stat about {};
  if (::fstat(fd, &about) != 0 || !S_ISREG(about.st_mode)) {
    ::close(fd);
    errno = S_ISDIR(about.st_mode) ? EISDIR : EINVAL;
    return std::nullopt;
  }
  return ByteSource(fd, std::uint64_t(about.st_size));
}

std::optional<ByteSource> ByteSource::again() const {
  if (fd_ < 0) return ByteSource(bytes_);
  const int fd = ::fcntl(fd_, F_DUPFD_CLOEXEC, 0);
  if (fd < 0) return std::nullopt;
  return ByteSource(fd, size_);
}

bool ByteSource::readAt(std::uint64_t offset, std::uint8_t* out, std::size_t count) const {
  if (offset > size_ || count > size_ - offset) return false;
  if (bytes_ != nullptr) {
    std::memcpy(out, bytes_->data() + offset, count);
    return true;
  }
  while (count > 0) {
    const ssize_t got = ::pread(fd_, out, count, off_t(offset));
    if (got <= 0) return false;
    out += got;
    offset += std::uint64_t(got);
    count -= std::size_t(got);
  }
  return true;
}

std::span<const std::uint8_t> ByteSource::window(std::uint64_t offset, std::size_t most) {
  if (offset >= size_) return {};
  most = std::size_t(std::min<std::uint64_t>(most, size_ - offset));
  if (bytes_ != nullptr) {
    return {reinterpret_cast<const std::uint8_t*>(bytes_->data()) + offset, most};
  }
  if (offset < buffer_at_ || offset >= buffer_at_ + buffered_) {
    buffer_at_ = offset;
    const ssize_t got = ::pread(fd_, buffer_.data(), buffer_.size(), off_t(offset));
    buffered_ = got > 0 ? std::size_t(got) : 0;
  }
  const std::size_t skip = std::size_t(offset - buffer_at_);
  return {buffer_.data() + skip, std::min(most, buffered_ - skip)};
}

}  // namespace mapwright::grids
