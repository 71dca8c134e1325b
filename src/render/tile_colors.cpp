#include "render/tile_colors.h"

#include <algorithm>

namespace mapwright::render {
namespace {

constexpr int kDimmedPercent = 35;

constexpr std::array<std::string_view, 6> kNames{"normal",     "incremental", "active",
                                                 "trajectory", "age",         "version"};

// Light, so that walls and what is drawn on the map stand out in both themes. Everybody can tell them apart:
// the test map_colors measures it.
constexpr std::array<std::uint32_t, kClasses> kApart{0xffc3c3ff, 0xffc3d75f, 0xffffafc3, 0xff37af87,
                                                     0xffffebc3, 0xffaf87eb, 0xffc3ffff, 0xff9b9b37};
constexpr std::array<std::uint32_t, kClasses> kRamp{0xff8f86f2, 0xff7aa0f0, 0xff5fb9e0, 0xff62ccb0,
                                                    0xff8fda80, 0xffc8e060, 0xfff0ec80, 0xfffffbd6};

ClassBits bitsOf(ColorMode mode) {
  return mode == ColorMode::Trajectory ? kTrajectoryBits : mode == ColorMode::Age ? kAgeBits : kVersionBits;
}

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

std::string_view nameOf(ColorMode mode) { return kNames[std::size_t(mode)]; }

std::optional<ColorMode> colorModeFrom(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  return found == kNames.end() ? std::nullopt : std::optional(ColorMode(found - kNames.begin()));
}

std::span<const std::uint32_t> classColors(ColorMode mode) {
  switch (mode) {
    case ColorMode::Trajectory:
      return kApart;
    case ColorMode::Age:
    case ColorMode::Version:
      return kRamp;
    case ColorMode::Normal:
    case ColorMode::Incremental:
    case ColorMode::Active:
      break;
  }
  return {};
}

ColorTable::ColorTable(const MapColors& colors, ColorMode mode)
    : bits_(bitsOf(mode)), by_class_(!classColors(mode).empty()), transparent_(colors.clear_unknown) {
  const auto by_class = classColors(mode);
  for (unsigned row = 0; row < kRows; ++row) {
    const bool observed = by_class_ ? row > 0 : (row & kObserved) != 0;
    const bool incremental = mode == ColorMode::Incremental && (row & kIncremental) != 0;
    const bool dimmed = mode == ColorMode::Active && (row & kActive) == 0;
    std::uint32_t free = incremental ? colors.incremental_free : colors.free;
    if (by_class_ && observed) free = row <= by_class.size() ? by_class[row - 1] : kUnknownVersionColor;
    for (unsigned intensity = 0; intensity < 256; ++intensity) {
      std::uint32_t color = colors.clear_unknown ? 0 : colors.unknown | 0xff000000;
      if (observed) {
        color = mixed(incremental ? colors.incremental_occupied : colors.occupied, free, int(intensity), 255);
        if (dimmed) color = mixed(colors.unknown, color, kDimmedPercent, 100);
      }
      table_[row << 8 | intensity] = color;
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
    const std::uint16_t* const flags = pixels.flags.data() + start;
    if (by_class_) {
      for (int x = 0; x < pixels.width_px; ++x) line[x] = table_[classRow(flags[x]) << 8 | intensity[x]];
    } else {
      for (int x = 0; x < pixels.width_px; ++x) line[x] = table_[(flags[x] & 15U) << 8 | intensity[x]];
    }
  }
  return image;
}

}  // namespace mapwright::render
