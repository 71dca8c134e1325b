// What chunks of recordings are packed with: Zstandard, LZ4 (its frame format) and bzip2. Pure functions, any
// thread. Sources: RFC 8878; "LZ4 Frame Format Description"; the manual of bzip2 1.0.8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <tl/expected.hpp>

#include "packed/unpack.h"

namespace mapwright::packed {

enum class Codec : std::uint8_t { Zstd, Lz4, Bzip2 };

/// Unpacks to exactly `size` bytes, and never takes memory for more. Whoever calls bounds `size`; one that
/// `packed` could not ever fill (as far as the codec has a limit) is Corrupt before memory is taken.
/// TooLong: more than `size` come out, or there is no memory for them.
tl::expected<ByteBuffer, UnpackFailure> unpackExactly(Codec codec, std::span<const std::uint8_t> packed,
                                                      std::size_t size);

/// A Zstandard frame that says its length. `level` as of zstd: 1 is fast, 19 is small. Without bytes when
/// there is no memory for it.
ByteBuffer packZstd(std::span<const std::uint8_t> bytes, int level);

/// CRC-32 of zlib and PNG, continued: `before` is 0, or what the bytes before came to.
std::uint32_t crc32(std::uint32_t before, std::span<const std::uint8_t> bytes);

}  // namespace mapwright::packed
