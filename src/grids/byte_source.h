// The bytes of a picture: in memory, or in a file that is read in pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mapwright::grids {

/// Files are read rather than mapped: if one shrinks meanwhile it ends early instead of raising a signal. One
/// thread.
class ByteSource {
 public:
  explicit ByteSource(std::shared_ptr<const std::string> bytes);
  /// nullopt if the file cannot be opened; errno says why.
  static std::optional<ByteSource> open(const std::string& path);
  ByteSource(ByteSource&&) = default;
  ByteSource& operator=(ByteSource&&) = delete;

  /// The same bytes for a second reader: of the same file, even if another one has taken its name.
  ByteSource again() const;

  std::uint64_t size() const { return size_; }
  /// False if not all bytes are there.
  bool readAt(std::uint64_t offset, std::uint8_t* out, std::size_t count) const;
  /// Up to `most` (at least 1) bytes from `offset` on, valid until the next call; empty at the end.
  std::span<const std::uint8_t> window(std::uint64_t offset, std::size_t most);

 private:
  std::shared_ptr<const std::string> bytes_;
  std::shared_ptr<const int> file_;  // its descriptor; null = in memory
  std::uint64_t size_ = 0;
  std::vector<std::uint8_t> buffer_;
  std::uint64_t buffer_at_ = 0;
  std::size_t buffered_ = 0;
};

}  // namespace mapwright::grids
