// gzip, zlib and PNG files for the tests. The PNG writer is a plain one of our own, so that the decoder's
// library is not checked against itself.
#pragma once

#include <array>
#include <zlib.h>

#include "cell_samples.h"

namespace mapwright::cells::samples {

inline constexpr int kGzipBits = 15 + 16;
inline constexpr int kZlibBits = 15;

inline Bytes deflated(std::span<const std::uint8_t> plain, int window_bits,
                      int effort = Z_DEFAULT_COMPRESSION) {
  z_stream stream{};
  deflateInit2(&stream, effort, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  Bytes packed(deflateBound(&stream, uLong(plain.size())) + 64);
  stream.next_in = const_cast<Bytef*>(plain.data());
  stream.avail_in = uInt(plain.size());
  stream.next_out = packed.data();
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.erase(packed.end() - std::ptrdiff_t(stream.avail_out), packed.end());
  deflateEnd(&stream);
  return packed;
}

enum class Colour : std::uint8_t { Gray = 0, Rgb = 2, Palette = 3, GrayAlpha = 4, Rgba = 6 };

inline int channelsOf(Colour colour) {
  switch (colour) {
    case Colour::Rgb:
      return 3;
    case Colour::GrayAlpha:
      return 2;
    case Colour::Rgba:
      return 4;
    default:
      return 1;
  }
}

struct Picture {
  int width = 0, height = 0;
  Colour colour = Colour::Gray;
  int depth = 8;
  bool interlaced = false;
  std::vector<std::uint16_t> samples;  // row-major, channels side by side, each below 2^depth
};

inline void appendBigEndian(Bytes& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(std::uint8_t(number >> shift));
  }
}

inline void appendChunk(Bytes& bytes, const char (&name)[5], std::span<const std::uint8_t> content) {
  appendBigEndian(bytes, std::uint32_t(content.size()));
  const std::size_t start = bytes.size();
  bytes.insert(bytes.end(), name, name + 4);
  bytes.insert(bytes.end(), content.begin(), content.end());
  appendBigEndian(bytes, std::uint32_t(crc32(0, bytes.data() + start, uInt(bytes.size() - start))));
}

/// The rows of every `dx`th column from x0 and every `dy`th row from y0, each after a filter byte of 0.
inline void appendPass(Bytes& rows, const Picture& picture, int x0, int y0, int dx, int dy) {
  const int channels = channelsOf(picture.colour);
  for (int y = y0; y < picture.height && x0 < picture.width; y += dy) {
    rows.push_back(0);
    unsigned pending = 0;
    int bits = 0;
    for (int x = x0; x < picture.width; x += dx) {
      for (int channel = 0; channel < channels; ++channel) {
        const std::uint16_t sample =
            picture.samples[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) *
                                std::size_t(channels) +
                            std::size_t(channel)];
        pending = pending << picture.depth | sample;
        for (bits += picture.depth; bits >= 8; bits -= 8) {
          rows.push_back(std::uint8_t(pending >> (bits - 8)));
        }
      }
    }
    if (bits > 0) {
      rows.push_back(std::uint8_t(pending << (8 - bits)));
    }
  }
}

/// `announced_*` replace the size in the header when they are not 0.
inline Bytes png(const Picture& picture, std::uint32_t announced_width = 0,
                 std::uint32_t announced_height = 0) {
  Bytes bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes header;
  appendBigEndian(header, announced_width != 0 ? announced_width : std::uint32_t(picture.width));
  appendBigEndian(header, announced_height != 0 ? announced_height : std::uint32_t(picture.height));
  header.insert(header.end(), {std::uint8_t(picture.depth), std::uint8_t(picture.colour), 0, 0,
                               std::uint8_t(picture.interlaced ? 1 : 0)});
  appendChunk(bytes, "IHDR", header);
  if (picture.colour == Colour::Palette) {
    Bytes palette;
    for (int i = 0; i < 1 << picture.depth; ++i) {
      palette.insert(palette.end(), {std::uint8_t(255 - i), std::uint8_t(i * 7), 13});
    }
    appendChunk(bytes, "PLTE", palette);
  }
  Bytes rows;
  if (picture.interlaced) {
    constexpr std::array<std::array<int, 4>, 7> kAdam7{
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    for (const auto& [x0, y0, dx, dy] : kAdam7) {
      appendPass(rows, picture, x0, y0, dx, dy);
    }
  } else {
    appendPass(rows, picture, 0, 0, 1, 1);
  }
  appendChunk(bytes, "IDAT", deflated(rows, kZlibBits));
  appendChunk(bytes, "IEND", {});
  return bytes;
}

/// Every sample drawn from the whole range of the depth.
inline Picture noise(int width, int height, Colour colour, int depth, bool interlaced,
                     std::uint32_t seed = 1) {
  Picture picture{width, height, colour, depth, interlaced, {}};
  std::minstd_rand random(seed);
  picture.samples.resize(std::size_t(width) * std::size_t(height) * std::size_t(channelsOf(colour)));
  for (std::uint16_t& sample : picture.samples) {
    sample = std::uint16_t((random() >> 4) & ((1u << depth) - 1));
  }
  return picture;
}

}  // namespace mapwright::cells::samples
