// The bytes of a recording, and the values in them: little-endian, untrusted. One thread.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "disk/file_error.h"

namespace mapwright::recording {

static_assert(std::endian::native == std::endian::little);  // like recordings, which are read in place

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

/// Reads consecutive values. Anything beyond the end is zero or empty, and sound() is false from then on.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool sound() const { return sound_; }
  std::size_t left() const { return bytes_.size(); }
  void fail() { sound_ = false; }

  template <typename T>
  T number() {
    T value{};
    const auto raw = take(sizeof(T));
    if (raw.size() == sizeof(T)) std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }
  template <typename... T>
  void numbers(T&... values) {
    ((values = number<T>()), ...);
  }

  std::span<const std::uint8_t> take(std::uint64_t count) {
    if (!sound_ || count > bytes_.size()) {
      sound_ = false;
      return {};
    }
    const auto taken = bytes_.first(std::size_t(count));
    bytes_ = bytes_.subspan(std::size_t(count));
    return taken;
  }
  std::span<const std::uint8_t> rest() { return take(left()); }

  /// Preceded by its length as uint32.
  std::span<const std::uint8_t> piece() { return take(number<std::uint32_t>()); }
  std::string_view text() { return textOf(piece()); }

  static std::string_view textOf(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool sound_ = true;
};

}  // namespace mapwright::recording
