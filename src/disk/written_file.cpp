#include "disk/written_file.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <random>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <climits>

namespace mapwright::disk {

namespace {

constexpr std::size_t kBuffer = std::size_t(1) << 18;
constexpr int kMostLinks = 40, kMostNames = 100;
constexpr auto kReaderComesWithin = std::chrono::seconds(5);  // at the other end of a named pipe
constexpr auto kLookForReaderEvery = std::chrono::milliseconds(10);
constexpr int kReaderSilentMs = 60'000;

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

/// The target of links, even if it does not exist yet; empty: a circle.
std::string followed(std::string path) {
  for (int links = 0; links < kMostLinks; ++links) {
    std::array<char, PATH_MAX> to;
    const ssize_t size = ::readlink(path.c_str(), to.data(), to.size());
    if (size < 0) return path;
    const std::string next(to.data(), std::size_t(size));
    path = next.starts_with('/') ? next : folderOf(path) + '/' + next;
  }
  return {};
}

std::string nameBeside(const std::string& target, unsigned number) {
  return folderOf(target) + "/.mapwright-" + std::to_string(number) + ".part";
}

/// "/maps/office-2.yaml"
std::string numbered(const std::string& path, int number) {
  const std::filesystem::path name(path);
  return name.parent_path() /
         (name.stem().string() + '-' + std::to_string(number) + name.extension().string());
}

/// False, with errno: there is something of that name already, or another reason.
bool renameToNothing(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  // Not known to this file system: the name is taken first.
  const int taken = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (taken < 0) return false;
  ::close(taken);
  if (::rename(from.c_str(), to.c_str()) == 0) return true;
  const int why = errno;
  ::unlink(to.c_str());
  errno = why;
  return false;
}

/// The umask; nullopt: unknown. (The system call to read it would change it.)
std::optional<mode_t> umaskNow() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("Umask:")) return mode_t(std::strtoul(line.c_str() + 6, nullptr, 8));
  }
  return std::nullopt;
}

/// An open file, whether or not it has a name.
std::string linkOf(int fd) { return "/proc/self/fd/" + std::to_string(fd); }

bool isNowhereToKeep(int error) { return error == EINVAL || error == ENOSYS || error == ENOTSUP; }

/// False if the disk reports that not everything was written. Some file systems cannot tell.
bool synced(int fd) {
  int done = 0;
  do {
    done = ::fsync(fd);
  } while (done != 0 && errno == EINTR);
  return done == 0 || isNowhereToKeep(errno);
}

}  // namespace

Existing existingNow(const std::string& path) {
  return ::access(path.c_str(), F_OK) == 0 ? Existing::Replace : Existing::Refuse;
}

bool isStandardOutput(const std::string& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

WrittenFile::WrittenFile(std::string path, Existing existing) : path_(std::move(path)), existing_(existing) {
  buffer_.reserve(kBuffer);
  if (isStandardOutput(path_)) {
    mode_ = Mode::Through;
    patient_ = true;
    fd_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (fd_ < 0) fail(errno);
    return;
  }
  struct stat about {};
  const bool present = ::stat(path_.c_str(), &about) == 0;
  if (!present || S_ISREG(about.st_mode)) {
    openAside();
  } else if (S_ISDIR(about.st_mode)) {
    fail(fault::IsAFolder);
  } else if (S_ISCHR(about.st_mode) || S_ISFIFO(about.st_mode)) {
    openThrough(S_ISFIFO(about.st_mode));
  } else {
    fail(S_ISBLK(about.st_mode) ? faultText("disk", "it is a block device, not a file")
                                : faultText("disk", "it is a socket, not a file"));
  }
}

WrittenFile::~WrittenFile() {
  if (fd_ >= 0) ::close(fd_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

void WrittenFile::openAside() {
  target_ = followed(path_);
  if (target_.empty()) return fail(ELOOP);
  struct stat before {};
  // What may replace nothing is made all the same: it may have taken long, and is kept beside.
  const bool replaces = existing_ == Existing::Replace && ::stat(target_.c_str(), &before) == 0;
  if (replaces && !S_ISREG(before.st_mode)) return fail(EINVAL);  // it has become something else
  // Moving a file into place only needs permission for the folder.
  if (replaces && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) return fail(errno);
  replaces_ = replaces;
  const mode_t mode = replaces ? before.st_mode & 0777 : 0666;
  if (!openUnnamed(mode)) openNamed(mode);
  if (fd_ < 0) {
    const int why = errno;
    aside_.clear();
    if (why != EACCES && why != EROFS) return fail(why);
    return fail({fault::NoFileInFolder, {folderOf(target_), std::strerror(why)}});
  }
  if (!replaces) return;
  // It keeps its owner, if that is permitted.
  if (before.st_uid != ::geteuid() || before.st_gid != ::getegid()) {
    if (::fchown(fd_, before.st_uid, before.st_gid) != 0 && ::fchown(fd_, uid_t(-1), before.st_gid) != 0) {
      // Otherwise it belongs to the writer, like a new one.
    }
  }
  if (::fchmod(fd_, mode) != 0 && errno != EPERM) fail(errno);
}

bool WrittenFile::openUnnamed(mode_t mode) {
  fd_ = ::open(folderOf(target_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, mode);
  if (fd_ < 0) return false;
  // The link gives it its name. Old kernels ignore the umask for such files.
  const auto umask = umaskNow();
  unnamed_ = umask && ::access(linkOf(fd_).c_str(), F_OK) == 0 && ::fchmod(fd_, mode & ~*umask) == 0;
  if (!unnamed_) ::close(std::exchange(fd_, -1));
  return unnamed_;
}

void WrittenFile::openNamed(mode_t mode) {
  std::random_device random;
  for (int tries = 0; tries < kMostNames && fd_ < 0; ++tries) {
    aside_ = nameBeside(target_, random());
    fd_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (fd_ < 0 && errno != EEXIST) break;
  }
}

bool WrittenFile::give(const std::string& name) {
  return ::linkat(AT_FDCWD, linkOf(fd_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

void WrittenFile::nameAside() {
  bool given = false;
  std::random_device random;
  for (int tries = 0; tries < kMostNames && !given; ++tries) {
    aside_ = nameBeside(target_, random());
    given = give(aside_);
    if (!given && errno != EEXIST) break;
  }
  if (!given) copyAside();
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

void WrittenFile::copyAside() {
  // Some file systems support unnamed files but cannot name them.
  const int from = std::exchange(fd_, -1);
  aside_.clear();
  struct stat about {};
  if (::fstat(from, &about) != 0) fail(errno);
  if (good()) openNamed(about.st_mode & 0777);
  if (good() && fd_ < 0) {
    fail(errno);
    aside_.clear();
  }
  buffer_.resize(kBuffer);
  off_t at = 0;
  while (good()) {
    const ssize_t some = ::pread(from, buffer_.data(), kBuffer, at);
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) fail(errno);
    if (some <= 0) break;
    at += some;
    buffer_.resize(std::size_t(some));
    flush();
    buffer_.resize(kBuffer);
  }
  buffer_.clear();
  ::close(from);
  if (good() && !synced(fd_)) fail(errno);
  if (fd_ >= 0 && ::close(std::exchange(fd_, -1)) != 0 && errno != EINTR) fail(errno);
}

void WrittenFile::openThrough(bool pipe) {
  mode_ = Mode::Through;
  const auto until = std::chrono::steady_clock::now() + kReaderComesWithin;
  for (;;) {
    // A pipe without a reader would block the program forever.
    fd_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd_ >= 0) return;
    if (!pipe || errno != ENXIO) return fail(errno);
    if (std::chrono::steady_clock::now() > until)
      return fail(faultText("disk", "nothing reads from this pipe"));
    std::this_thread::sleep_for(kLookForReaderEvery);
  }
}

void WrittenFile::fail(Fault cause) {
  if (!problem_) problem_ = FileError{path_, std::move(cause)};
}

void WrittenFile::fail(int error) { fail(systemError(path_, error).cause); }

void WrittenFile::write(const void* bytes, std::size_t count) {
  const char* const from = static_cast<const char*>(bytes);
  std::size_t taken = 0;
  while (good() && taken < count) {
    const std::size_t part = std::min(count - taken, kBuffer - buffer_.size());
    buffer_.insert(buffer_.end(), from + taken, from + taken + part);
    taken += part;
    if (buffer_.size() == kBuffer) flush();
  }
}

bool WrittenFile::waitForRoom() {
  pollfd room{fd_, POLLOUT, 0};
  const int ready = ::poll(&room, 1, patient_ ? -1 : kReaderSilentMs);
  if (ready > 0 || (ready < 0 && errno == EINTR)) return true;
  ready == 0 ? fail(faultText("disk", "the program that reads from it is blocked")) : fail(errno);
  return false;
}

void WrittenFile::flush() {
  std::size_t written = 0;
  while (good() && written < buffer_.size()) {
    const ssize_t some = ::write(fd_, buffer_.data() + written, buffer_.size() - written);
    if (some >= 0) {
      written += std::size_t(some);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      waitForRoom();
    } else if (errno != EINTR) {
      fail(errno);
    }
  }
  buffer_.clear();
}

bool WrittenFile::finish() {
  if (std::exchange(finished_, true)) return good();
  flush();
  if (fd_ < 0) return good();
  if (good() && mode_ == Mode::Aside && !synced(fd_)) fail(errno);
  if (unnamed_) return good();  // unnamed until it gets its name
  // The final error of a network file system, or of a quota.
  if (::close(std::exchange(fd_, -1)) != 0 && errno != EINTR) fail(errno);
  return good();
}

std::string WrittenFile::whereNow() const {
  if (placed_) return target_;
  return aside_.empty() ? linkOf(fd_) : aside_;
}

void WrittenFile::moveIntoPlace() {
  // A link can create a name but not replace a file: an existing one is replaced by renaming.
  if (unnamed_ && !replaces_ && give(target_)) return;
  if (unnamed_) nameAside();
  if (!good()) return;
  if (auto problem = moveInto(aside_, target_, existing_)) {
    fail(problem->cause);
    if (problem->cause.code != fault::NameTaken) return;
    target_ = std::get<std::string>(problem->cause.arguments[0]);
  }
  aside_.clear();
}

std::optional<FileError> WrittenFile::place() {
  finish();
  if (good() && !std::exchange(placed_, true) && mode_ == Mode::Aside) {
    moveIntoPlace();
    // So that the new name survives a power cut, too; if the folder does not support this, it is still there.
    const int folder = ::open(folderOf(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
      synced(folder);
      ::close(folder);
    }
  }
  return problem_;
}

std::optional<FileError> moveInto(const std::string& from, const std::string& to, Existing existing) {
  const bool moved =
      existing == Existing::Replace ? ::rename(from.c_str(), to.c_str()) == 0 : renameToNothing(from, to);
  if (moved) return std::nullopt;
  if (existing == Existing::Replace || errno != EEXIST) return systemError(to, errno);
  std::string kept = from;
  for (int number = 1; number <= kMostNames; ++number) {
    const std::string beside = numbered(to, number);
    if (renameToNothing(from, beside)) kept = beside;
    if (kept != from || errno != EEXIST) break;
  }
  return FileError{to, {fault::NameTaken, {kept}}};
}

std::optional<FileError> writeFile(const std::string& path, std::string_view bytes, Existing existing) {
  WrittenFile file(path, existing);
  file.write(bytes);
  return file.place();
}

}  // namespace mapwright::disk
