// The bytes that a recording is read from. One thread.
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
  /// As it is now: a file may grow, or be cut, while it is read.
  virtual std::uint64_t size() const = 0;
  /// All of `out`, from `at` on; false: so much is not there, or cannot be read.
  virtual bool read(std::span<std::uint8_t> out, std::uint64_t at) const = 0;
};

/// A regular file. It is read and never mapped: one that is cut while it is looked at would end the program.
tl::expected<std::unique_ptr<Bytes>, disk::FileError> fileBytes(const std::string& path);

/// Bytes in memory; whoever keeps the string may let it grow.
std::unique_ptr<Bytes> heldBytes(std::shared_ptr<const std::string> bytes);

/// A window that follows whoever reads small things one behind the other.
class Window {
 public:
  explicit Window(const Bytes& bytes) : bytes_(bytes) {}
  /// `count` bytes from `at` on, valid until the next call; fewer (maybe none) where so much is not there.
  /// `count` is at most kMostInView.
  std::span<const std::uint8_t> look(std::uint64_t at, std::size_t count, std::uint64_t end);
  /// All that is at hand from `at` on: as many as look() would give, or more.
  std::span<const std::uint8_t> rest(std::uint64_t at, std::size_t least, std::uint64_t end);
  static constexpr std::size_t kMostInView = std::size_t(1) << 16;

 private:
  const Bytes& bytes_;
  std::string held_;
  std::uint64_t from_ = 0;
};

}  // namespace mapwright::recording
