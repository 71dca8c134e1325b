// Draws clouds from above, pixel by pixel. Pure, any thread.
//
// The exact value of a pixel, independent of tile and scale: the colour is the mean height, mean intensity or
// mean red, green and blue of all points in it (those shown, within the heights), and the opacity depends on
// their number. Points do not hide each other. A pixel without points is transparent.
// - A point of `size_px` s covers s x s pixels, unless that exceeds the distance between points: then less,
//   down to a
//   single pixel.
// - Voxels cover the pixels whose centres lie in them, as squares of their size in the map; voxels no
//   larger than a pixel are drawn like points. Points are drawn over voxels.
// - A pixel with at least twice the expected number of points is opaque; one with a single point where many
//   are expected is about a third opaque.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "clouds/newest_clouds.h"

namespace mapwright::clouds {

/// A window of an infinite raster of square pixels: column direction (cos, -sin) of the rotation, row
/// direction "down"; the window's first pixel is (first_column, first_row). Windows of one raster agree.
struct Raster {
  Eigen::Vector2d origin_m{0, 0};  // where column 0 meets row 0
  double scale_m_per_px = 0.05;
  double rotation_rad = 0;
  int width_px = 0, height_px = 0;
  std::int64_t first_column = 0, first_row = 0;
};

enum class CloudColor { OneColor, Intensity, Height, Rgb };

struct CloudLook {
  CloudColor color = CloudColor::Height;
  std::uint32_t one = 0x2060c0;  // 0x00RRGGBB; also used for points without a colour
  int size_px = 1;               // 1 .. kLargestPoint
  HeightRange heights = {};      // which points are shown
  // The ends of the colour scale. Points without intensity get the lowest.
  double low_z_m = 0, high_z_m = 1;
  double low_intensity = 0, high_intensity = 1;
  bool operator==(const CloudLook&) const = default;
};
inline constexpr int kLargestPoint = 16;
inline constexpr int kLargestRaster = 4096;

/// Row-major from the top; 0xAARRGGBB, premultiplied. Empty if there is nothing to see.
struct CloudPixels {
  int width_px = 0, height_px = 0;
  std::vector<std::uint32_t> argb;
  bool operator==(const CloudPixels&) const = default;
};

/// Returns nothing if the raster has no pixels or non-finite numbers, or if it is cancelled.
CloudPixels drawClouds(const Raster& raster, const CloudSet& set, const CloudLook& look,
                       const std::atomic<bool>* cancelled = nullptr);

/// How many points of a set are within the heights and not replaced by newer ones.
std::uint64_t countShown(const CloudSet& set, const HeightRange& heights);

/// The edge of a point on the raster in pixels: `size_px`, or less if points are closer together.
int pointSize(int size_px, double scale_m_per_px, double spacing_m);

/// 0x00RRGGBB, lowest first.
using Shades = std::array<std::uint32_t, 256>;
const Shades& shades();

}  // namespace mapwright::clouds
