// Records of a state file as streams of bytes, for protobuf.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <google/protobuf/io/zero_copy_stream.h>

#include "packed/gunzip_stream.h"
#include "pbstream/record_file.h"

namespace mapwright::pbstream {

/// Reads a file from front to back, jumping over what is not wanted. One thread.
class FileWindow {
 public:
  /// `file` outlives this.
  explicit FileWindow(const RecordFile& file) : file_(file) {}
  /// At least `least` bytes (at most 64 KiB) from there; fewer, or none, where the file ends or cannot be
  /// read. Valid until the next call.
  std::span<const std::uint8_t> at(std::uint64_t offset, std::size_t least);

 private:
  const RecordFile& file_;
  std::vector<std::uint8_t> bytes_;
  std::uint64_t from_ = 0;
};

/// The size that stands at the beginning of a record; 0 where the file ends.
std::uint64_t sizeAt(FileWindow& window, std::uint64_t offset);

/// What one record unpacks to, for protobuf. One thread.
class RecordStream final : public google::protobuf::io::ZeroCopyInputStream {
 public:
  /// protobuf counts the bytes of a message in an int.
  static constexpr std::int64_t kMostUnpacked = (std::int64_t(1) << 31) - (1 << 20);

  /// `window` outlives this.
  explicit RecordStream(FileWindow& window);
  void start(const Record& record);

  bool Next(const void** data, int* size) override;
  void BackUp(int count) override;
  bool Skip(int count) override;
  std::int64_t ByteCount() const override { return unpacked_ - behind_; }

  /// Why it ended before its end; none: it did not.
  Fault fault() const;
  /// Unpacks the rest; then fault() tells of all of it.
  void finish();

 private:
  packed::GunzipStream::More source();
  FileWindow& window_;
  std::uint64_t at_ = 0, end_ = 0;
  packed::GunzipStream gunzip_;
  std::vector<std::uint8_t> buffer_;
  std::size_t filled_ = 0;
  std::int64_t unpacked_ = 0, behind_ = 0;
  bool too_long_ = false;
};

}  // namespace mapwright::pbstream
