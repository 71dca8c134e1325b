#include "disk/read_file.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mapwright::disk {

int openToRead(const std::string& path) {
  // Opening a pipe blocks until there is a writer, unless told not to.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (fd < 0) return -1;
  struct stat about {};
  if (::fstat(fd, &about) == 0 && S_ISREG(about.st_mode)) return fd;
  const int why = S_ISDIR(about.st_mode) ? EISDIR : EINVAL;
  ::close(fd);
  errno = why;
  return -1;
}

bool readAt(int fd, std::span<std::uint8_t> bytes, std::uint64_t at) {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(fd, bytes.data(), bytes.size(), off_t(at));
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = 0;
    if (got <= 0) return false;
    bytes = bytes.subspan(std::size_t(got));
    at += std::uint64_t(got);
  }
  return true;
}

bool writeAt(int fd, std::span<const std::uint8_t> bytes, std::uint64_t at) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(fd, bytes.data(), bytes.size(), off_t(at));
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;
    if (written <= 0) return false;
    bytes = bytes.subspan(std::size_t(written));
    at += std::uint64_t(written);
  }
  return true;
}

bool isGitLfsPointer(std::string_view begin) {
  return begin.starts_with("version https://git-lfs.github.com/spec/") ||
         begin.starts_with("version https://hawser.github.com/spec/");
}

tl::expected<std::string, FileError> readFile(const std::string& path, std::size_t most) {
  const int fd = openToRead(path);
  if (fd < 0) {
    const int why = errno;
    FileError error = systemError(path, why);
    if (why == EINVAL) error.cause = fault::NotARegularFile;
    return tl::make_unexpected(std::move(error));
  }
  constexpr std::size_t kPiece = std::size_t(1) << 20;
  // Most files are small and have the stated size: one more byte detects the end.
  struct stat about {};
  std::size_t piece = ::fstat(fd, &about) == 0 ? std::size_t(about.st_size) + 1 : kPiece;
  std::string bytes;
  ssize_t got = 1;
  while (got > 0 && bytes.size() < most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(std::exchange(piece, kPiece), most - before));
    do {
      got = ::read(fd, bytes.data() + before, bytes.size() - before);
    } while (got < 0 && errno == EINTR);
    bytes.resize(before + std::size_t(std::max<ssize_t>(got, 0)));
    if (before == 0 && got > 0 && std::size_t(got) == std::size_t(about.st_size)) break;
  }
  const int why = errno;
  ::close(fd);
  if (got < 0) return tl::make_unexpected(systemError(path, why));
  if (isGitLfsPointer(bytes)) return tl::make_unexpected(FileError{path, fault::GitLfsPointer});
  return bytes;
}

tl::expected<std::string, FileError> readStandardInput(std::size_t most) {
  constexpr std::size_t kPiece = std::size_t(1) << 16;
  std::string bytes;
  ssize_t got = 1;
  while (got > 0 && bytes.size() < most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(kPiece, most - before));
    do {
      got = ::read(STDIN_FILENO, bytes.data() + before, bytes.size() - before);
    } while (got < 0 && errno == EINTR);
    const int why = errno;
    bytes.resize(before + std::size_t(std::max<ssize_t>(got, 0)));
    if (got < 0) return tl::make_unexpected(systemError("-", why));
  }
  return bytes;
}

bool sameFile(const std::string& one, const std::string& other) {
  struct stat a {
  }, b{};
  return ::stat(one.c_str(), &a) == 0 && ::stat(other.c_str(), &b) == 0 && a.st_dev == b.st_dev &&
         a.st_ino == b.st_ino;
}

}  // namespace mapwright::disk
