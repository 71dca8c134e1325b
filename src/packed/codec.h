// Compression of chunks in recordings: Zstandard, LZ4 (its frame format) and bzip2. Pure functions, any
// thread. Sources: RFC 8878; "LZ4 Frame Format Description"; the manual of bzip2 1.0.8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "packed/unpack.h"

namespace mapwright::packed {

enum class Codec : std::uint8_t { Zstd, Lz4, Bzip2 };

/// Unpacks to exactly `size` bytes and never allocates more. The caller limits `size`; if `packed` cannot
/// possibly contain that much (where the codec has a limit) it is Corrupt before any memory is allocated.
/// TooLong: there is more than `size`, or not enough memory.
tl::expected<ByteBuffer, UnpackFailure> unpackExactly(Codec codec, std::span<const std::uint8_t> packed,
                                                      std::size_t size);

/// A Zstandard frame that states its length. `level` as in zstd: 1 is fast, 19 is small. Empty if there is
/// not enough memory.
ByteBuffer packZstd(std::span<const std::uint8_t> bytes, int level);

/// One gzip stream of one member. Empty if there is not enough memory.
ByteBuffer packGzip(std::span<const std::uint8_t> bytes);

/// The length that a Zstandard frame states; nullopt: none, or it is no such frame.
std::optional<std::uint64_t> zstdContentSize(std::span<const std::uint8_t> packed);

/// CRC-32 as in zlib and PNG, incremental: `before` is 0, or the result for the preceding bytes.
std::uint32_t crc32(std::uint32_t before, std::span<const std::uint8_t> bytes);

}  // namespace mapwright::packed
