// The chunks of a PNG before its pixels. Source: PNG specification (third edition), "Chunk specifications".
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include "grids/byte_source.h"
#include "grids/picture_rows.h"

namespace mapwright::grids {

struct PngHeader {
  PixelFormat format;       // of rows unpacked to whole bytes
  int bit_depth = 8;        // 1, 2, 4, 8, 16, as stored
  int stored_channels = 1;  // samples per pixel, as stored
  bool interlaced = false;
  bool animated = false;        // it holds more pictures (APNG), which are not read
  std::uint64_t pixels_at = 0;  // offset of the first IDAT chunk

  std::size_t storedRowBytes(int width) const {
    return (std::size_t(width) * std::size_t(stored_channels * bit_depth) + 7) / 8;
  }
};

struct PngChunk {
  static constexpr std::uint64_t kAround = 12;  // bytes for length, type and checksum
  std::uint32_t length = 0;
  std::array<char, 4> type{};
  bool is(const char* name) const { return std::string(type.data(), 4) == name; }
};

/// Length and type of the chunk at `offset`; nullopt at the end of the file.
std::optional<PngChunk> pngChunkAt(const ByteSource& bytes, std::uint64_t offset);

tl::expected<PngHeader, Fault> readPngHeader(const ByteSource& bytes);

}  // namespace mapwright::grids
