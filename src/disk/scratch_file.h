// Room on the disk that nobody sees and that is gone with the program. Any thread; ranges must not overlap in
// time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace mapwright::disk {

/// A file without a name, opened when it is first written to.
class ScratchFile {
 public:
  /// In `folder` (made when it is not there), else where the system keeps what is temporary. The folder of
  /// what is temporary may lie in memory, which is what this is there to save.
  explicit ScratchFile(std::string folder) : folder_(std::move(folder)) {}
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// The error is what follows "cannot be written: "; empty when all went well.
  std::string write(std::span<const std::uint8_t> bytes, std::uint64_t at);
  /// False when so much is not there or cannot be read.
  bool read(std::span<std::uint8_t> bytes, std::uint64_t at) const;

 private:
  void open();
  std::string folder_;
  std::once_flag opened_;
  int file_ = -1;
  int why_not_ = 0;  // errno of open()
};

}  // namespace mapwright::disk
