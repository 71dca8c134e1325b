// The container of a Cartographer state file: a signature, then records, each of them a size and one gzip
// stream. Source: docs/protocols/pbstream.md, "Container".
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "fault/fault.h"

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

}  // namespace mapwright::pbstream
