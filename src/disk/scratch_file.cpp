#include "disk/scratch_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

#include "disk/read_file.h"

namespace mapwright::disk {
namespace {

int unnamedFileIn(const std::filesystem::path& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  std::string name = (folder / "scratch-XXXXXX").string();
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

}  // namespace

ScratchFile::~ScratchFile() {
  if (file_ >= 0) ::close(file_);
}

void ScratchFile::open() {
  std::error_code failed;
  if (!folder_.empty()) {
    std::filesystem::create_directories(folder_, failed);
    file_ = unnamedFileIn(folder_);
  }
  if (file_ >= 0) return;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(failed);
  if (!failed) file_ = unnamedFileIn(temporary);
  if (file_ < 0) unavailable_reason_ = failed ? failed.value() : errno;
}

std::string ScratchFile::write(std::span<const std::uint8_t> bytes, std::uint64_t at) {
  std::call_once(opened_, [this] { open(); });
  if (file_ < 0) return std::strerror(unavailable_reason_);
  return writeAt(file_, bytes, at) ? std::string() : std::strerror(errno);
}

bool ScratchFile::read(std::span<std::uint8_t> bytes, std::uint64_t at) const {
  return readAt(file_, bytes, at);
}

}  // namespace mapwright::disk
