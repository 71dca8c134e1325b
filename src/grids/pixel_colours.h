// The colour of pixels in any format.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "grids/picture_rows.h"

namespace mapwright::grids {

using Argb = std::uint32_t;  // not premultiplied

inline Argb argbOf(int a, int r, int g, int b) {
  return Argb(a) << 24 | Argb(r) << 16 | Argb(g) << 8 | Argb(b);
}

class PixelColours {
 public:
  /// `format` outlives this.
  explicit PixelColours(const PixelFormat& format) : format_(format) {}
  /// `pixel`: the first of its bytes in a row. Samples of 16 bits are rounded to 8.
  Argb at(const std::uint8_t* pixel) const {
    if (format_.indexed) {
      const PixelFormat::Colour& colour = format_.table[*pixel];
      return argbOf(colour.a, colour.r, colour.g, colour.b);
    }
    const int channels = format_.channels;
    const bool colours = channels >= 3;
    const std::array<int, 3> rgb{sample(pixel, 0), sample(pixel, colours ? 1 : 0),
                                 sample(pixel, colours ? 2 : 0)};
    int alpha = channels % 2 == 0 ? byteOf(sample(pixel, channels - 1)) : 255;
    if (format_.transparent) {
      const auto& key = *format_.transparent;
      if (rgb[0] == key[0] && (!colours || (rgb[1] == key[1] && rgb[2] == key[2]))) alpha = 0;
    }
    return argbOf(alpha, byteOf(rgb[0]), byteOf(rgb[1]), byteOf(rgb[2]));
  }

 private:
  int sample(const std::uint8_t* pixel, int channel) const {
    return format_.sample_bytes == 1 ? pixel[channel] : pixel[2 * channel] << 8 | pixel[2 * channel + 1];
  }
  int byteOf(int sample) const {
    return (std::min(sample, format_.sample_max) * 2 * 255 + format_.sample_max) / (2 * format_.sample_max);
  }

  const PixelFormat& format_;
};

}  // namespace mapwright::grids
