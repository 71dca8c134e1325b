// The container of a Cartographer state file: a signature, then records, each of them a size and one gzip
// stream. Source: docs/protocols/pbstream.md, "Container".
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <google/protobuf/io/zero_copy_stream.h>
#include <tl/expected.hpp>

#include "fault/fault.h"
#include "packed/gunzip_stream.h"

namespace mapwright::pbstream {

inline constexpr std::uint64_t kSignatureBytes = 8;
inline constexpr std::uint64_t kSizeBytes = 8;

struct Record {
  std::uint64_t number = 0;  // the first one is 0
  std::uint64_t offset = 0;  // in the file: where its size stands
  std::uint64_t packed = 0;  // bytes of its gzip stream
  std::uint64_t begin() const { return offset + kSizeBytes; }
  std::uint64_t end() const { return begin() + packed; }
};

/// "Record 12 at byte 3,456: why"
Fault inRecord(const Record& record, Fault why);

/// An open file. Any thread.
class RecordFile {
 public:
  /// Refuses what has another signature.
  static tl::expected<std::shared_ptr<const RecordFile>, Fault> open(const std::string& path);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  std::uint64_t size() const { return size_; }  // when it was opened
  /// False: it cannot be read, or it has become shorter.
  bool read(std::span<std::uint8_t> bytes, std::uint64_t at) const;

 private:
  RecordFile(int fd, std::uint64_t size) : fd_(fd), size_(size) {}
  int fd_;
  std::uint64_t size_;
};

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
