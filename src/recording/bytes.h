// The bytes of a recording. One thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "disk/file_error.h"

namespace mapwright::recording {

class Bytes {
 public:
  virtual ~Bytes() = default;
  /// The current size: a file may grow or shrink while it is read.
  virtual std::uint64_t size() const = 0;
  /// Fills `out` from `at` on; false: there are not enough bytes, or they cannot be read.
  virtual bool read(std::span<std::uint8_t> out, std::uint64_t at) const = 0;
};

/// A regular file. It is read, not mapped: a mapped file that is truncated would crash the program.
tl::expected<std::unique_ptr<Bytes>, disk::FileError> fileBytes(const std::string& path);

/// Bytes in memory; the owner of the string may append to it.
std::unique_ptr<Bytes> heldBytes(std::shared_ptr<const std::string> bytes);

/// A buffer for small consecutive reads.
class Window {
 public:
  explicit Window(const Bytes& bytes) : bytes_(bytes) {}
  /// `count` bytes from `at` on, valid until the next call; fewer (maybe none) at the end of the file.
  /// `count` is at most kMostInView.
  std::span<const std::uint8_t> look(std::uint64_t at, std::size_t count, std::uint64_t end);
  /// All buffered bytes from `at` on: at least as many as look() would give.
  std::span<const std::uint8_t> rest(std::uint64_t at, std::size_t least, std::uint64_t end);
  static constexpr std::size_t kMostInView = std::size_t(1) << 16;

 private:
  const Bytes& bytes_;
  std::string held_;
  std::uint64_t from_ = 0;
};

}  // namespace mapwright::recording
