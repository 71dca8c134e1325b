#include "render/tile_colors.h"

namespace mapwright::render {
namespace {

constexpr int kDimmedPercent = 35;

// a at part = 0, b at part = whole, opaque.
std::uint32_t mixed(std::uint32_t a, std::uint32_t b, int part, int whole) {
  std::uint32_t out = 0xff000000;
  for (const int shift : {0, 8, 16}) {
    const int from = int(a >> shift & 255), to = int(b >> shift & 255);
    const int channel = (from * (whole - part) + to * part + whole / 2) / whole;
    out |= std::uint32_t(channel) << shift;
  }
  return out;
}

}  // namespace

ColorTable::ColorTable(const MapColors& colors, ColorMode mode) : transparent_(colors.clear_unknown) {
  for (int flags = 0; flags < 16; ++flags) {
    const bool incremental = mode == ColorMode::Incremental && (flags & kIncremental) != 0;
    const bool dimmed = mode == ColorMode::Active && (flags & kActive) == 0;
    for (int intensity = 0; intensity < 256; ++intensity) {
      std::uint32_t color = colors.clear_unknown ? 0 : colors.unknown | 0xff000000;
      if ((flags & kObserved) != 0) {
        color = mixed(incremental ? colors.incremental_occupied : colors.occupied,
                      incremental ? colors.incremental_free : colors.free, intensity, 255);
        if (dimmed) color = mixed(colors.unknown, color, kDimmedPercent, 100);
      }
      table_[std::size_t(flags << 8 | intensity)] = color;
    }
  }
}

QImage ColorTable::paint(const Composition& pixels) const {
  QImage image(pixels.width_px, pixels.height_px,
               transparent_ ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
  for (int y = 0; y < image.height(); ++y) {
    auto* const line = reinterpret_cast<std::uint32_t*>(image.scanLine(y));
    const std::size_t start = std::size_t(y) * std::size_t(pixels.width_px);
    const std::uint8_t* const intensity = pixels.intensity.data() + start;
    const std::uint8_t* const flags = pixels.flags.data() + start;
    for (int x = 0; x < pixels.width_px; ++x) line[x] = at(flags[x], intensity[x]);
  }
  return image;
}

}  // namespace mapwright::render
