// Maps intensities and flags to colours. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <QImage>

#include "render/compositor.h"

namespace mapwright::render {

/// How intensities are mapped to colours. The last three tint by the classes of render/pixel_flags.h.
enum class ColorMode { Normal, Incremental, Active, Trajectory, Age, Version };
/// In the words of commands and settings: normal, incremental ...
std::string_view nameOf(ColorMode mode);
std::optional<ColorMode> colorModeFrom(std::string_view name);

/// The free ground of class 0 .. kClasses - 1: colours that are told apart, or a ramp of them. Empty: the
/// mode has no classes.
std::span<const std::uint32_t> classColors(ColorMode mode);
/// Of submaps without a known version.
inline constexpr std::uint32_t kUnknownVersionColor = 0xff78746c;

/// Plain RGB (0xffRRGGBB) of the palette.
struct MapColors {
  std::uint32_t unknown = 0xff778899, free = 0xffffffff, occupied = 0xff15181c;
  std::uint32_t incremental_free = 0xff8fb8f0, incremental_occupied = 0xffe04b4b;
  /// Unobserved pixels are transparent instead of `unknown`, because another layer is below the submaps.
  bool clear_unknown = false;
  bool operator==(const MapColors&) const = default;
};

/// The colour of every (flags, intensity): `unknown` if not observed, otherwise from occupied (0) to free
/// (255), linear. Incremental: kIncremental pixels use the incremental colours. Active: pixels without
/// kActive are dimmed to 35 % over `unknown`. By class: free ground has the colour of the pixel's class.
class ColorTable {
 public:
  ColorTable(const MapColors& colors, ColorMode mode);
  std::uint32_t at(std::uint16_t flags, std::uint8_t intensity) const {
    return table_[(by_class_ ? classRow(flags) : flags & 15U) << 8 | intensity];
  }
  /// An image of the whole composition: RGB32, or ARGB32_Premultiplied if unknown is transparent.
  QImage paint(const Composition& pixels) const;

 private:
  /// Row 0: unobserved; then the classes.
  unsigned classRow(unsigned flags) const {
    return (flags & kObserved) != 0 ? 1 + (flags >> bits_.shift & bits_.mask) : 0;
  }

  static constexpr unsigned kRows = 17;  // of flags or of classes
  std::array<std::uint32_t, std::size_t(kRows) * 256> table_;
  ClassBits bits_;  // of the class that tints
  bool by_class_, transparent_;
};

}  // namespace mapwright::render
