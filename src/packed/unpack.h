// Detects and unpacks the containers of cells and messages. Pure functions, any thread. Source:
// docs/protocols/cartographer-submaps.md, "Containers and cell layouts".
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <tl/expected.hpp>

namespace mapwright::packed {

enum class Container : std::uint8_t { Raw, Png, Gzip, Zlib };

/// By signature only: the content may still be something else.
Container sniffContainer(std::span<const std::uint8_t> bytes);

/// Uninitialised bytes on the heap: unlike in a vector, untouched ones use no memory.
struct ByteBuffer {
  std::unique_ptr<std::uint8_t[]> data;
  std::size_t size = 0;
  std::span<const std::uint8_t> bytes() const { return {data.get(), size}; }
};

enum class UnpackFailure : std::uint8_t {
  Corrupt,  // not a whole, valid stream
  TooLong,  // more bytes than the limit
};

/// DEFLATE expands a byte to at most 1,032 bytes.
inline constexpr std::size_t kMaxDeflateRatio = 1032;

/// Unpacks a gzip stream (of one or several members) or a zlib stream to at most `limit` bytes; never
/// allocates more than that, nor more than `packed` can contain. Bytes after a complete stream are ignored.
/// Precondition: container is Gzip or Zlib.
tl::expected<ByteBuffer, UnpackFailure> unpack(Container container, std::span<const std::uint8_t> packed,
                                               std::size_t limit);

}  // namespace mapwright::packed
