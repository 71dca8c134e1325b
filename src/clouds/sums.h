// What the points of each pixel come to. Private to this room.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clouds/draw_cloud.h"

namespace mapwright::clouds {

/// From the ground to the pixels of a raster, in the one way that all of this room reckons in: monotone in
/// every coordinate, so that what holds for the corners of a box holds for all in it.
class Projection {
 public:
  Projection(const Raster& raster, const Eigen::Vector3d& origin_m);
  /// Of a point beside the origin: its pixel in the endless raster, before it is rounded down.
  double column(double x, double y) const {
    return (cos_ * (base_.x() + x) - sin_ * (base_.y() + y)) * per_m_;
  }
  double row(double x, double y) const { return -(sin_ * (base_.x() + x) + cos_ * (base_.y() + y)) * per_m_; }
  struct Reach {
    double column0, row0, column1, row1;  // pixels, both ends belong to it
  };
  /// The pixels that anything in a box may lie in.
  Reach reach(double min_x, double min_y, double max_x, double max_y) const;
  /// The ground below the middle of a pixel of the endless raster, beside the origin.
  Eigen::Vector2d groundBelow(double column, double row) const;

 private:
  Eigen::Vector2d base_;
  double cos_, sin_, per_m_, scale_;
};

/// Sums over a window of the raster with a margin around it.
class Sums {
 public:
  Sums(const Raster& raster, int margin_px, int channels);

  /// Window with the margin, in the endless raster.
  double column0, row0;
  int width, height, margin, channels;
  std::vector<std::int64_t> count;
  std::array<std::vector<std::int64_t>, 3> value;  // as many of them as there are channels

  bool touches(const Projection::Reach& reach) const {
    return reach.column1 >= column0 && reach.row1 >= row0 && reach.column0 < column0 + width &&
           reach.row0 < row0 + height;
  }
  /// The place of a pixel (whole numbers), which lies in the window or outside of it (npos).
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
  /// Every pixel gets the sum of those whose points, as squares of that edge, cover it.
  void widen(int edge_px);
};

/// What is added up for a colour.
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

/// Voxels that are larger than a pixel. False: cancelled.
bool addVoxels(Sums& sums, const Raster& raster, const ShownCloud& cloud, const CloudLook& look,
               const std::atomic<bool>* cancelled);

}  // namespace mapwright::clouds
