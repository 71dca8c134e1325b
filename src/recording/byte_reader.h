// Reads consecutive little-endian values from untrusted bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace mapwright::recording {

static_assert(std::endian::native == std::endian::little,
              "little-endian");  // like recordings, which are read in place

/// A view into bytes. Anything beyond the end is zero or empty, and sound() is false from then on.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool sound() const { return sound_; }
  std::size_t left() const { return bytes_.size(); }

  template <typename T>
  T number() {
    T value{};
    const auto raw = take(sizeof(T));
    if (raw.size() == sizeof(T)) std::memcpy(&value, raw.data(), sizeof(T));
    return value;
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
