// The colour of pixels in any format.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "grids/picture_rows.h"

namespace mapwright::grids {

using Argb = std::uint32_t;      // not premultiplied
using DeepArgb = std::uint64_t;  // the same, 16 bits each

inline Argb argbOf(int a, int r, int g, int b) {
  return Argb(a) << 24 | Argb(r) << 16 | Argb(g) << 8 | Argb(b);
}

class PixelColours {
 public:
  /// `format` outlives this.
  explicit PixelColours(const PixelFormat& format) : format_(format) {}
  /// `pixel`: the first of its bytes in a row. Samples of 16 bits are rounded to 8.
  Argb at(const std::uint8_t* pixel) const {
    const auto [a, r, g, b] = valuesOf<255>(pixel);
    return argbOf(a, r, g, b);
  }
  /// Without rounding.
  DeepArgb deepAt(const std::uint8_t* pixel) const {
    const auto [a, r, g, b] = valuesOf<65535>(pixel);
    return DeepArgb(a) << 48 | DeepArgb(r) << 32 | DeepArgb(g) << 16 | DeepArgb(b);
  }

 private:
  /// Alpha, red, green, blue, each from 0 to kMost.
  template <int kMost>
  std::array<int, 4> valuesOf(const std::uint8_t* pixel) const {
    if (format_.indexed) {
      const PixelFormat::Colour& colour = format_.table[*pixel];
      constexpr int kTimes = kMost / 255;
      return {colour.a * kTimes, colour.r * kTimes, colour.g * kTimes, colour.b * kTimes};
    }
    const int channels = format_.channels;
    const bool colours = channels >= 3;
    const std::array<int, 3> rgb{sample(pixel, 0), sample(pixel, colours ? 1 : 0),
                                 sample(pixel, colours ? 2 : 0)};
    int alpha = channels % 2 == 0 ? scaled<kMost>(sample(pixel, channels - 1)) : kMost;
    if (format_.transparent) {
      const auto& key = *format_.transparent;
      if (rgb[0] == key[0] && (!colours || (rgb[1] == key[1] && rgb[2] == key[2]))) alpha = 0;
    }
    return {alpha, scaled<kMost>(rgb[0]), scaled<kMost>(rgb[1]), scaled<kMost>(rgb[2])};
  }
  int sample(const std::uint8_t* pixel, int channel) const {
    return format_.sample_bytes == 1 ? pixel[channel] : pixel[2 * channel] << 8 | pixel[2 * channel + 1];
  }
  template <int kMost>
  int scaled(int sample) const {
    const int most = format_.sample_max, value = std::min(sample, most);
    return most == kMost ? value : int((std::int64_t(value) * 2 * kMost + most) / (2 * most));
  }

  const PixelFormat& format_;
};

}  // namespace mapwright::grids
