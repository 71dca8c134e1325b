// The bytes of a picture: in memory, or in a file that is read piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mapwright::grids {

/// A file is read and not mapped: one that shrinks meanwhile ends early instead of raising a signal. One
/// thread.
class ByteSource {
 public:
  explicit ByteSource(std::shared_ptr<const std::string> bytes);
  /// nullopt when the file cannot be opened; errno says why.
  static std::optional<ByteSource> open(const std::string& path);
  ~ByteSource();
  ByteSource(ByteSource&& other) noexcept;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  ByteSource& operator=(ByteSource&&) = delete;

  /// The same bytes for another reader: of the same file, even when another one has taken its name meanwhile.
  /// nullopt when no more files can be opened.
  std::optional<ByteSource> again() const;

  std::uint64_t size() const { return size_; }
  /// False when the bytes are not all there.
  bool readAt(std::uint64_t offset, std::uint8_t* out, std::size_t count) const;
  /// Up to `most` (at least 1) bytes from `offset` on, valid until the next call; empty at the end.
  std::span<const std::uint8_t> window(std::uint64_t offset, std::size_t most);

 private:
  explicit ByteSource(int fd, std::uint64_t size);
  std::shared_ptr<const std::string> bytes_;
  int fd_ = -1;
  std::uint64_t size_ = 0;
  std::vector<std::uint8_t> buffer_;
  std::uint64_t buffer_at_ = 0;
  std::size_t buffered_ = 0;
};

}  // namespace mapwright::grids
