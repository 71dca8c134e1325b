#include "recording/append_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mapwright::recording {
namespace {

class AppendFile final : public AppendTarget {
 public:
  AppendFile(std::string path, int fd) : path_(std::move(path)), fd_(fd) {}
  ~AppendFile() override { ::close(fd_); }
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  std::optional<disk::FileError> append(std::span<const std::uint8_t> bytes) override {
    // An incomplete record at the end would precede whatever follows.
    if (torn_ && ::ftruncate(fd_, off_t(size_)) != 0) return disk::systemError(path_, errno);
    torn_ = false;
    std::uint64_t at = size_;
    while (!bytes.empty()) {
      const ssize_t wrote = ::pwrite(fd_, bytes.data(), bytes.size(), off_t(at));
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote <= 0) {
        const int why = wrote < 0 ? errno : ENOSPC;
        torn_ = ::ftruncate(fd_, off_t(size_)) != 0;
        return disk::systemError(path_, why);
      }
      bytes = bytes.subspan(std::size_t(wrote));
      at += std::uint64_t(wrote);
    }
    size_ = at;
    return std::nullopt;
  }

  std::optional<disk::FileError> settle() override {
    if (::fdatasync(fd_) == 0) return std::nullopt;
    return disk::systemError(path_, errno);
  }

 private:
  std::string path_;
  int fd_;
  std::uint64_t size_ = 0;
  bool torn_ = false;
};

}  // namespace

tl::expected<std::unique_ptr<AppendTarget>, disk::FileError> appendFile(const std::string& path,
                                                                        Existing existing) {
  const int flags =
      O_WRONLY | O_CREAT | O_CLOEXEC | O_NOCTTY | O_NONBLOCK | (existing == Existing::Refuse ? O_EXCL : 0);
  const int fd = ::open(path.c_str(), flags, 0666);
  if (fd < 0) return tl::unexpected(disk::systemError(path, errno));
  // Two writers of one file would both lose data; where files cannot be locked, this is undetectable.
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(fd);
    return tl::unexpected(disk::systemError(path, ETXTBSY));
  }
  struct stat about {};
  if (::fstat(fd, &about) != 0 || !S_ISREG(about.st_mode) || ::ftruncate(fd, 0) != 0) {
    disk::FileError error = disk::systemError(path, errno);
    if (about.st_mode != 0 && !S_ISREG(about.st_mode)) error.cause = disk::fault::NotARegularFile;
    ::close(fd);
    return tl::unexpected(std::move(error));
  }
  return std::make_unique<AppendFile>(path, fd);
}

}  // namespace mapwright::recording
