#include "raster/aside_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mapwright::raster {

AsideFile::AsideFile(std::string path) : path_(std::move(path)), aside_(path_ + ".part-XXXXXX") {
  const int fd = ::mkostemp(aside_.data(), O_CLOEXEC);
  if (fd >= 0) {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(fd, 0666 & ~mask);  // as any other file that a user saves
    file_ = ::fdopen(fd, "wb");
  }
  if (file_ == nullptr) error_ = errno;
}

AsideFile::~AsideFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  ::unlink(aside_.c_str());
}

void AsideFile::write(const void* bytes, std::size_t count) {
  if (!good()) return;
  if (std::fwrite(bytes, 1, count, file_) != count) error_ = errno;
}

std::optional<std::string> AsideFile::place() {
  if (file_ != nullptr) {
    if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) error_ = errno;
    if (error_ == 0 && ::rename(aside_.c_str(), path_.c_str()) != 0) error_ = errno;
    if (error_ != 0) ::unlink(aside_.c_str());
  }
  if (error_ == 0) return std::nullopt;
  return path_ + " cannot be written: " + std::strerror(error_) + ".";
}

}  // namespace mapwright::raster
