// Clouds from above, pixel by pixel. Pure, any thread.
//
// What a pixel is, exactly, whatever tile it is in and however coarse the picture: of all points in it (the
// shown ones, within the heights) the mean height, the mean intensity or the mean of red, green and blue
// gives the colour, and how many they are how opaque it is. No point lies over another. A pixel without a
// point is clear.
// - A point of `size_px` s covers s x s pixels, unless that were more ground than there is between points:
// then
//   less, down to the pixel that it lies in.
// - Voxels cover the pixels whose middles lie in them, as squares of their size in the map; where they are no
//   larger than a pixel they are like points. Points lie over voxels.
// - A pixel with as many points as are to be expected there twice over is opaque; one with a single point is
//   about a third, where many were to be expected.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "clouds/cloud_book.h"

namespace mapwright::clouds {

/// A window of an endless raster of square pixels: column direction (cos, -sin) of the rotation, row
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
  std::uint32_t one = 0x2060c0;  // 0x00RRGGBB; also for what has no colour of its own
  int size_px = 1;               // 1 .. kLargestPoint
  HeightRange heights = {};      // which points are shown
  // The ends of the colour scale. What has no intensity has the least.
  double low_z_m = 0, high_z_m = 1;
  double low_intensity = 0, high_intensity = 1;
  bool operator==(const CloudLook&) const = default;
};
inline constexpr int kLargestPoint = 16;
inline constexpr int kLargestRaster = 4096;

/// Row-major from the top; 0xAARRGGBB, premultiplied. Without pixels: there is nothing to be seen.
struct CloudPixels {
  int width_px = 0, height_px = 0;
  std::vector<std::uint32_t> argb;
  bool operator==(const CloudPixels&) const = default;
};

/// A raster without pixels, or whose numbers are not finite, gives nothing; so does one that is cancelled.
CloudPixels drawClouds(const Raster& raster, const CloudSet& set, const CloudLook& look,
                       const std::atomic<bool>* cancelled = nullptr);

/// How many points of a set are within the heights and not replaced by newer ones.
std::uint64_t countShown(const CloudSet& set, const HeightRange& heights);

/// The edge of a point on the raster, pixels: `size_px`, or less where points lie closer.
int pointSize(int size_px, double scale_m_per_px, double spacing_m);

}  // namespace mapwright::clouds
