// Pictures for tests, made by plain encoders that share no code with the readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include <zlib.h>

namespace mapwright::test {

using Samples = std::vector<std::uint16_t>;  // row-major, channels interleaved

struct PngRecipe {
  int width = 1, height = 1;
  int depth = 8, colour_type = 0;  // as in IHDR
  bool interlaced = false;
  int filter = -1;                // -1: all five in turn
  std::string palette = {};       // PLTE, when not empty
  std::string transparency = {};  // tRNS, when not empty
  std::size_t chunk = 1000;       // bytes of an IDAT
  int level = 6;
};

inline std::string bigEndian(std::uint32_t number) {
  return {char(number >> 24), char(number >> 16), char(number >> 8), char(number)};
}

inline std::string pngChunk(const std::string& type, const std::string& content) {
  const std::string body = type + content;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()));
  return bigEndian(std::uint32_t(content.size())) + body + bigEndian(std::uint32_t(sum));
}

inline int pngChannels(int colour_type) {
  return colour_type == 2 ? 3 : colour_type == 4 ? 2 : colour_type == 6 ? 4 : 1;
}

/// The rows of one pass, filtered.
inline std::string pngPass(const PngRecipe& recipe, const Samples& samples, int left, int top, int step_x,
                           int step_y) {
  const int channels = pngChannels(recipe.colour_type);
  std::vector<std::uint8_t> above;
  std::string out;
  int number = 0;
  for (int y = top; y < recipe.height; y += step_y) {
    std::vector<std::uint8_t> row;
    int bits = 0;
    for (int x = left; x < recipe.width; x += step_x) {
      for (int c = 0; c < channels; ++c) {
        const std::uint16_t sample =
            samples[(std::size_t(y) * std::size_t(recipe.width) + std::size_t(x)) * std::size_t(channels) +
                    std::size_t(c)];
        if (recipe.depth == 16) {
          row.push_back(std::uint8_t(sample >> 8));
          row.push_back(std::uint8_t(sample));
        } else {
          if (bits % 8 == 0) row.push_back(0);
          row.back() = std::uint8_t(row.back() | sample << (8 - recipe.depth - bits % 8));
          bits += recipe.depth;
        }
      }
    }
    if (row.empty()) return {};
    if (above.empty()) above.resize(row.size());
    const std::size_t unit = std::size_t(std::max(1, channels * recipe.depth / 8));
    const int filter = recipe.filter >= 0 ? recipe.filter : number++ % 5;
    out.push_back(char(filter));
    for (std::size_t n = 0; n < row.size(); ++n) {
      const int a = n >= unit ? row[n - unit] : 0, b = above[n], c = n >= unit ? above[n - unit] : 0;
      const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
      const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      const int guess[] = {0, a, b, (a + b) / 2, paeth};
      out.push_back(char(row[n] - guess[filter]));
    }
    above = row;
  }
  return out;
}

inline std::string deflated(const std::string& plain, int level) {
  uLongf size = compressBound(uLong(plain.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
            uLong(plain.size()), level);
  packed.resize(size);
  return packed;
}

inline std::string pngHead(const PngRecipe& recipe) {
  std::string head = "\x89PNG\r\n\x1a\n";
  std::string ihdr = bigEndian(std::uint32_t(recipe.width)) + bigEndian(std::uint32_t(recipe.height));
  ihdr += {char(recipe.depth), char(recipe.colour_type), 0, 0, char(recipe.interlaced ? 1 : 0)};
  head += pngChunk("IHDR", ihdr);
  head += pngChunk("tEXt", std::string("Comment\0a map", 13));
  if (!recipe.palette.empty()) head += pngChunk("PLTE", recipe.palette);
  if (!recipe.transparency.empty()) head += pngChunk("tRNS", recipe.transparency);
  return head;
}

inline std::string pngTail(const PngRecipe& recipe, const std::string& packed) {
  std::string tail;
  for (std::size_t at = 0; at < packed.size(); at += recipe.chunk) {
    tail += pngChunk("IDAT", packed.substr(at, recipe.chunk));
  }
  return tail + pngChunk("IEND", "");
}

inline std::string png(const PngRecipe& recipe, const Samples& samples) {
  std::string plain;
  if (recipe.interlaced) {
    const int passes[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    for (const auto& pass : passes) plain += pngPass(recipe, samples, pass[0], pass[1], pass[2], pass[3]);
  } else {
    plain = pngPass(recipe, samples, 0, 0, 1, 1);
  }
  return pngHead(recipe) + pngTail(recipe, deflated(plain, recipe.level));
}

inline std::shared_ptr<const std::string> shared(std::string bytes) {
  return std::make_shared<const std::string>(std::move(bytes));
}

/// Reproducible numbers that look like noise.
inline std::uint32_t noise(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352d;
  seed ^= seed >> 15;
  seed *= 0x846ca68b;
  return seed ^ seed >> 16;
}

/// Rooms with thin walls, mostly unknown around: what a map looks like. 8-bit grays.
inline Samples roomGrays(int width, int height) {
  Samples samples(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t dice = noise(std::uint32_t(y * 7919 + x)) % 64;
      std::uint16_t gray = 255;
      if (x % 97 == 13 || y % 71 == 29)
        gray = 0;
      else if ((x / 60 + y / 50) % 3 == 0)
        gray = 128;
      else if (dice == 0)
        gray = std::uint16_t(noise(std::uint32_t(x + y * 31)) % 256);
      samples[std::size_t(y) * std::size_t(width) + std::size_t(x)] = gray;
    }
  }
  return samples;
}

}  // namespace mapwright::test
