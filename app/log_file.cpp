#include "app/log_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/command_text.h"
#include "words/plain.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

/// The first line of each: nothing else is written on.
constexpr std::string_view kLogBegins = "# mapwright log\n";

bool writeAllOf(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(std::size_t(written));
  }
  return true;
}

QString noLog(const std::string& path, const QString& why) {
  return Text::tr("There is no log in %1: %2").arg(words::plainName(QString::fromStdString(path)), why);
}

QString lastError() { return QString::fromLocal8Bit(std::strerror(errno)); }

int openToAppend(const std::string& path) {
  return ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0600);
}

bool isFile(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

std::size_t sizeOf(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 ? std::size_t(status.st_size) : 0;
}

bool beginsAsLog(int file) {
  std::array<char, kLogBegins.size()> first{};
  return ::pread(file, first.data(), first.size(), 0) == ssize_t(first.size()) &&
         std::string_view(first.data(), first.size()) == kLogBegins;
}

std::string numbered(const std::string& path, int number) {
  return number == 0 ? path : path + '.' + std::to_string(number);
}

}  // namespace

LogFile::~LogFile() {
  if (file_ >= 0) ::close(file_);
}

std::optional<QString> LogFile::open(const std::string& path) {
  const std::lock_guard lock(mutex_);
  // Links are followed when it is turned, too.
  char* const target = ::realpath(path.c_str(), nullptr);
  path_ = target ? target : path;
  std::free(target);
  // A pipe without a reader must not stop the program.
  file_ = openToAppend(path);
  if (file_ < 0) return noLog(path, Text::tr("%1.").arg(lastError()));
  const auto refuse = [&](const QString& why) {
    ::close(file_);
    file_ = -1;
    return noLog(path, why);
  };
  if (!isFile(file_)) return refuse(Text::tr("it is no file."));
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) return refuse(Text::tr("another mapwright is writing there."));
  bytes_ = sizeOf(file_);
  if (bytes_ > 0 && !beginsAsLog(file_)) return refuse(Text::tr("the file is something else."));
  char last = '\n';
  cut_ = bytes_ > 0 && ::pread(file_, &last, 1, off_t(bytes_ - 1)) == 1 && last != '\n';
  // They will be written over.
  for (int number = 1; number < limits_.files; ++number) {
    const std::string name = numbered(path_, number);
    const int older = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (older < 0 && errno == ENOENT) continue;
    const bool log = older >= 0 && isFile(older) && (sizeOf(older) == 0 || beginsAsLog(older));
    if (older >= 0) ::close(older);
    if (!log)
      return refuse(
          Text::tr("%1 beside it is something else.").arg(words::plainName(QString::fromStdString(name))));
  }
  return std::nullopt;
}

std::optional<QString> LogFile::write(std::string_view line) {
  const std::lock_guard lock(mutex_);
  if (file_ < 0) return std::nullopt;
  const bool full = bytes_ > kLogBegins.size() && bytes_ + line.size() + 1 > limits_.bytes;
  if (!full || turn()) {
    // In one piece: a full disk cuts it at most once.
    const std::string text =
        (bytes_ == 0 ? std::string(kLogBegins) : std::string(cut_ ? "\n" : "")) + std::string(line) + '\n';
    if (writeAllOf(file_, text)) {
      bytes_ += text.size();
      cut_ = false;
      return std::nullopt;
    }
  }
  const QString why = lastError();
  cut_ = cut_ || sizeOf(file_) != bytes_;
  bytes_ = sizeOf(file_);
  if (said_) return std::nullopt;
  said_ = true;
  return Text::tr("The log in %1 lacks lines: %2.").arg(words::plainName(QString::fromStdString(path_)), why);
}

bool LogFile::turn() {
  // The new one first: where it cannot be made, the old ones stay as they are.
  const std::string made = path_ + ".new";
  ::unlink(made.c_str());
  const int file = openToAppend(made);
  if (file < 0) return false;
  for (int number = limits_.files - 1; number > 0; --number)
    std::rename(numbered(path_, number - 1).c_str(), numbered(path_, number).c_str());
  if (std::rename(made.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    ::close(file);
    errno = error;
    return false;
  }
  ::close(file_);
  file_ = file;
  ::flock(file_, LOCK_EX | LOCK_NB);
  bytes_ = 0;
  cut_ = false;
  return true;
}

}  // namespace mapwright::app
