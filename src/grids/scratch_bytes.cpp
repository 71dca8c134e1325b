#include "grids/scratch_bytes.h"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace mapwright::grids {

namespace {

int unnamedFile() {
  std::error_code failed;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(failed);
  if (failed) return -1;
  const int fd = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (fd >= 0) return fd;
  std::string name = (folder / "mapwright-XXXXXX").string();
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

}  // namespace

std::optional<ScratchBytes> ScratchBytes::take(std::size_t size) {
  int fd = -1;
  int flags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
  if (size > kInMemory) {
    fd = unnamedFile();
    if (fd < 0) return std::nullopt;
    flags = MAP_SHARED;
    if (::posix_fallocate(fd, 0, off_t(size)) != 0) {
      ::close(fd);
      return std::nullopt;
    }
  }
  void* mapped = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, flags, fd, 0);
  if (fd >= 0) ::close(fd);
  if (mapped == MAP_FAILED) return std::nullopt;
  return ScratchBytes(static_cast<std::uint8_t*>(mapped), size);
}

ScratchBytes::~ScratchBytes() {
  if (data_ != nullptr) ::munmap(data_, size_);
}

ScratchBytes::ScratchBytes(ScratchBytes&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}

}  // namespace mapwright::grids
