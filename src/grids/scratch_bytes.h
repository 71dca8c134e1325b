// Space for something big that is written once and read once. One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mapwright::grids {

/// Initially zero. In memory if small; otherwise in an unnamed temporary file, whose disk space is reserved
/// in advance so that a full disk is noticed at once.
class ScratchBytes {
 public:
  static constexpr std::size_t kInMemory = std::size_t(64) << 20;
  /// nullopt: not enough space.
  static std::optional<ScratchBytes> take(std::size_t size);
  ~ScratchBytes();
  ScratchBytes(ScratchBytes&& other) noexcept;
  ScratchBytes(const ScratchBytes&) = delete;
  ScratchBytes& operator=(const ScratchBytes&) = delete;
  ScratchBytes& operator=(ScratchBytes&&) = delete;
  std::uint8_t* data() const { return data_; }

 private:
  ScratchBytes(std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace mapwright::grids
