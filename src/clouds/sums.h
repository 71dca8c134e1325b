// Sums of the points in each pixel. Private to this room.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clouds/draw_cloud.h"

namespace mapwright::clouds {

/// From the ground to raster pixels, the same way everywhere in this room: monotone in every coordinate, so
/// that the corners of a box bound everything in it.
class Projection {
 public:
  Projection(const Raster& raster, const Eigen::Vector3d& origin_m);
  /// The unrounded pixel of a point relative to the origin, in the infinite raster.
  double column(double x, double y) const {
    return (cos_ * (base_.x() + x) - sin_ * (base_.y() + y)) * per_m_;
  }
  double row(double x, double y) const { return -(sin_ * (base_.x() + x) + cos_ * (base_.y() + y)) * per_m_; }
  struct Reach {
    double column0, row0, column1, row1;  // pixels, both ends inclusive
  };
  /// The pixels that anything in a box may fall into.
  Reach reach(double min_x, double min_y, double max_x, double max_y) const;
  /// The ground position of a pixel's centre in the infinite raster, relative to the origin.
  Eigen::Vector2d groundBelow(double column, double row) const;

 private:
  Eigen::Vector2d base_;
  double cos_, sin_, per_m_, scale_;
};

/// Sums over a window of the raster with a margin around it.
class Sums {
 public:
  Sums(const Raster& raster, int margin_px, int channels);

  /// The window with its margin, in the infinite raster.
  double column0, row0;
  int width, height, margin, channels;
  std::vector<std::int64_t> count;
  std::array<std::vector<std::int64_t>, 3> value;  // one per channel

  bool touches(const Projection::Reach& reach) const {
    return reach.column1 >= column0 && reach.row1 >= row0 && reach.column0 < column0 + width &&
           reach.row0 < row0 + height;
  }
  /// The index of a pixel (whole numbers); npos outside the window.
  std::size_t at(double column, double row) const {
    const double x = column - column0, y = row - row0;
    if (!(x >= 0 && y >= 0 && x < width && y < height)) return npos;
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  }
  static constexpr std::size_t npos = std::size_t(-1);
  void add(std::size_t at, std::int64_t points, const std::array<std::int64_t, 3>& values) {
    count[at] += points;
    for (int i = 0; i < channels; ++i) value[std::size_t(i)][at] += values[std::size_t(i)];
  }
  /// Gives every pixel the sum of all points that cover it as squares of that edge.
  void widen(int edge_px);
};

/// The values that are summed for a colour.
class Channels {
 public:
  Channels(const CloudTree& tree, const CloudLook& look);
  static int countOf(CloudColor color) {
    return color == CloudColor::OneColor ? 0 : color == CloudColor::Rgb ? 3 : 1;
  }
  std::array<std::int64_t, 3> of(const CloudNode& node) const;
  std::array<std::int64_t, 3> of(std::uint32_t point) const;

 private:
  const CloudTree& tree_;
  CloudColor color_;
  std::int64_t origin_z_, low_intensity_;
  std::array<std::int64_t, 3> one_;
};

/// For voxels larger than a pixel. False: cancelled.
bool addVoxels(Sums& sums, const Raster& raster, const ShownCloud& cloud, const CloudLook& look,
               const std::atomic<bool>* cancelled);

}  // namespace mapwright::clouds
