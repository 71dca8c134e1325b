// Temporary disk space that is invisible and disappears with the program. Any thread; concurrent ranges must
// not overlap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace mapwright::disk {

/// An unnamed file, opened at the first write.
class ScratchFile {
 public:
  /// In `folder` (created if missing), otherwise in the system's folder for temporary files. That one may be
  /// in memory, which would defeat the purpose.
  explicit ScratchFile(std::string folder) : folder_(std::move(folder)) {}
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// The error is the text after "cannot be written: "; empty on success.
  std::string write(std::span<const std::uint8_t> bytes, std::uint64_t at);
  /// False if that much is not there or cannot be read.
  bool read(std::span<std::uint8_t> bytes, std::uint64_t at) const;

 private:
  void open();
  std::string folder_;
  std::once_flag opened_;
  int file_ = -1;
  int unavailable_reason_ = 0;  // errno of open()
};

}  // namespace mapwright::disk
