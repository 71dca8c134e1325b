#include "recording/bytes.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "disk/read_file.h"

namespace mapwright::recording {
namespace {

class FileBytes final : public Bytes {
 public:
  explicit FileBytes(int fd) : fd_(fd) {}
  ~FileBytes() override { ::close(fd_); }
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  std::uint64_t size() const override {
    struct stat about {};
    return ::fstat(fd_, &about) == 0 && about.st_size > 0 ? std::uint64_t(about.st_size) : 0;
  }

  bool read(std::span<std::uint8_t> out, std::uint64_t at) const override {
    while (!out.empty()) {
      const ssize_t got = ::pread(fd_, out.data(), out.size(), off_t(at));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      out = out.subspan(std::size_t(got));
      at += std::uint64_t(got);
    }
    return true;
  }

 private:
  int fd_;
};

class HeldBytes final : public Bytes {
 public:
  explicit HeldBytes(std::shared_ptr<const std::string> bytes) : bytes_(std::move(bytes)) {}
  std::uint64_t size() const override { return bytes_->size(); }
  bool read(std::span<std::uint8_t> out, std::uint64_t at) const override {
    if (at > bytes_->size() || out.size() > bytes_->size() - at) return false;
    if (!out.empty()) std::memcpy(out.data(), bytes_->data() + at, out.size());
    return true;
  }

 private:
  std::shared_ptr<const std::string> bytes_;
};

}  // namespace

tl::expected<std::unique_ptr<Bytes>, disk::FileError> fileBytes(const std::string& path) {
  const int fd = disk::openToRead(path);
  if (fd < 0) {
    const int why = errno;
    disk::FileError error = disk::systemError(path, why);
    if (why == EINVAL) error.cause = disk::fault::NotARegularFile;
    if (why == EISDIR) error.cause = disk::fault::IsAFolder;
    return tl::unexpected(std::move(error));
  }
  return std::make_unique<FileBytes>(fd);
}

std::unique_ptr<Bytes> heldBytes(std::shared_ptr<const std::string> bytes) {
  return std::make_unique<HeldBytes>(std::move(bytes));
}

std::span<const std::uint8_t> Window::look(std::uint64_t at, std::size_t count, std::uint64_t end) {
  const auto all = rest(at, count, end);
  return all.first(std::min(all.size(), count));
}

std::span<const std::uint8_t> Window::rest(std::uint64_t at, std::size_t least, std::uint64_t end) {
  if (at >= end) return {};
  least = std::size_t(std::min<std::uint64_t>({least, kMostInView, end - at}));
  if (at < from_ || at + least > from_ + held_.size()) {
    held_.resize(std::size_t(std::min<std::uint64_t>(kMostInView, end - at)));
    from_ = at;
    if (!bytes_.read({reinterpret_cast<std::uint8_t*>(held_.data()), held_.size()}, at)) held_.clear();
    if (held_.empty()) return {};
  }
  const std::uint64_t held = from_ + held_.size() - at;
  return {reinterpret_cast<const std::uint8_t*>(held_.data()) + (at - from_),
          std::size_t(std::min<std::uint64_t>(held, end - at))};
}

}  // namespace mapwright::recording
