#include "clouds/draw_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "clouds/walk.h"

namespace mapwright::clouds {
namespace {

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

Projection::Projection(const Raster& raster, const Eigen::Vector3d& origin_m)
    : base_(origin_m.head<2>() - raster.origin_m),
      cos_(std::cos(raster.rotation_rad)),
      sin_(std::sin(raster.rotation_rad)),
      per_m_(1 / raster.scale_m_per_px),
      scale_(raster.scale_m_per_px) {}

Projection::Reach Projection::reach(double min_x, double min_y, double max_x, double max_y) const {
  Reach reach{};
  bool first = true;
  for (const double x : {min_x, max_x}) {
    for (const double y : {min_y, max_y}) {
      const double c = std::floor(column(x, y)), r = std::floor(row(x, y));
      reach = first ? Reach{c, r, c, r}
                    : Reach{std::min(reach.column0, c), std::min(reach.row0, r), std::max(reach.column1, c),
                            std::max(reach.row1, r)};
      first = false;
    }
  }
  return reach;
}

Eigen::Vector2d Projection::groundBelow(double column, double row) const {
  const double u = column + 0.5, v = row + 0.5;
  return Eigen::Vector2d((cos_ * u - sin_ * v) * scale_, (-sin_ * u - cos_ * v) * scale_) - base_;
}

Sums::Sums(const Raster& raster, int margin_px, int channel_count)
    : column0(double(raster.first_column) - margin_px),
      row0(double(raster.first_row) - margin_px),
      width(raster.width_px + 2 * margin_px),
      height(raster.height_px + 2 * margin_px),
      margin(margin_px),
      channels(channel_count) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  count.resize(pixels);
  for (int i = 0; i < channels; ++i) value[std::size_t(i)].resize(pixels);
}

void Sums::widen(int edge_px) {
  // A point in pixel q covers q - before .. q + after: a pixel p gets those of p - after .. p + before.
  const int before = (edge_px - 1) / 2, after = edge_px / 2;
  std::vector<std::int64_t> sums(std::size_t(std::max(width, height)) + 1);
  const auto along = [&](std::vector<std::int64_t>& values, std::size_t first, std::size_t step, int length) {
    for (int i = 0; i < length; ++i) {
      sums[std::size_t(i) + 1] = sums[std::size_t(i)] + values[first + std::size_t(i) * step];
    }
    for (int i = 0; i < length; ++i) {
      const auto from = std::size_t(std::max(0, i - after)),
                 to = std::size_t(std::min(length, i + before + 1));
      values[first + std::size_t(i) * step] = sums[to] - sums[from];
    }
  };
  const auto widenOne = [&](std::vector<std::int64_t>& values) {
    for (int y = 0; y < height; ++y) along(values, std::size_t(y) * std::size_t(width), 1, width);
    for (int x = 0; x < width; ++x) along(values, std::size_t(x), std::size_t(width), height);
  };
  widenOne(count);
  for (int i = 0; i < channels; ++i) widenOne(value[std::size_t(i)]);
}

Channels::Channels(const CloudTree& tree, const CloudLook& look)
    : tree_(tree),
      color_(look.color),
      origin_z_(inParts(tree.origin().z())),
      low_intensity_(inParts(look.low_intensity)),
      one_{look.one >> 16 & 255, look.one >> 8 & 255, look.one & 255} {}

std::array<std::int64_t, 3> Channels::of(const CloudNode& node) const {
  const auto count = std::int64_t(node.count);
  switch (color_) {
    case CloudColor::OneColor:
      return {};
    case CloudColor::Height:
      return {node.sum_z + origin_z_ * count, 0, 0};
    case CloudColor::Intensity:
      return {tree_.hasIntensity() ? node.sum_intensity : low_intensity_ * count, 0, 0};
    case CloudColor::Rgb:
      break;
  }
  if (!tree_.hasRgb()) return {one_[0] * count, one_[1] * count, one_[2] * count};
  return {std::int64_t(node.sum_rgb[0]), std::int64_t(node.sum_rgb[1]), std::int64_t(node.sum_rgb[2])};
}

std::array<std::int64_t, 3> Channels::of(std::uint32_t point) const {
  switch (color_) {
    case CloudColor::OneColor:
      return {};
    case CloudColor::Height:
      return {inParts(double(tree_.points()[point].z())) + origin_z_, 0, 0};
    case CloudColor::Intensity:
      return {tree_.hasIntensity() ? inParts(double(tree_.intensity()[point])) : low_intensity_, 0, 0};
    case CloudColor::Rgb:
      break;
  }
  if (!tree_.hasRgb()) return one_;
  const std::uint32_t rgb = tree_.rgb()[point];
  return {rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255};
}

/// Smaller voxels are drawn as points.
constexpr double kLeastVoxelPx = 1.5;
constexpr double kLeastOpacity = 0.35;

bool usable(const Raster& raster) {
  constexpr double kFarthestM = 1e15;
  return raster.width_px > 0 && raster.height_px > 0 && raster.width_px <= kLargestRaster &&
         raster.height_px <= kLargestRaster && raster.scale_m_per_px >= 1e-9 &&
         raster.scale_m_per_px <= 1e9 && std::isfinite(raster.rotation_rad) &&
         std::abs(raster.origin_m.x()) <= kFarthestM && std::abs(raster.origin_m.y()) <= kFarthestM;
}

bool stopped(const std::atomic<bool>* cancelled) { return cancelled && *cancelled; }

void addPoints(Sums& sums, const Raster& raster, const ShownCloud& cloud, const CloudLook& look,
               const std::atomic<bool>* cancelled) {
  const CloudTree& tree = *cloud.tree;
  const Projection pixels(raster, tree.origin());
  const Meant meant(tree, cloud.hidden, look.heights);
  const Channels channels(tree, look);
  const auto points = tree.points();
  walk(
      tree,
      [&](const CloudNode& node) {
        if (stopped(cancelled)) return Visit::Skip;
        const auto reach = pixels.reach(node.min[0], node.min[1], node.max[0], node.max[1]);
        if (!sums.touches(reach)) return Visit::Skip;
        const Visit visit = meant.of(node);
        const bool one_pixel = reach.column0 == reach.column1 && reach.row0 == reach.row1;
        return visit == Visit::Whole && !one_pixel ? Visit::Into : visit;
      },
      [&](const CloudNode& node) {
        const auto reach = pixels.reach(node.min[0], node.min[1], node.max[0], node.max[1]);
        const std::size_t at = sums.at(reach.column0, reach.row0);
        if (at != Sums::npos) sums.add(at, node.count, channels.of(node));
      },
      [&](std::uint32_t i) {
        const Eigen::Vector3f& point = points[i];
        const double x = double(point.x()), y = double(point.y());
        const std::size_t at = sums.at(std::floor(pixels.column(x, y)), std::floor(pixels.row(x, y)));
        if (at != Sums::npos && meant.has(point)) sums.add(at, 1, channels.of(i));
      });
}

/// For voxels larger than a pixel. False: cancelled.
bool addVoxels(Sums& sums, const Raster& raster, const ShownCloud& cloud, const CloudLook& look,
               const std::atomic<bool>* cancelled) {
  const CloudTree& tree = *cloud.tree;
  const auto points = tree.points();
  if (points.empty()) return true;
  const Projection pixels(raster, tree.origin());
  const Meant meant(tree, cloud.hidden, look.heights);
  const Channels channels(tree, look);
  // The cells are those of the lattice of the points: neighbours share an edge to the last bit.
  const double edge = cloud.voxel_m, anchor_x = double(points[0].x()), anchor_y = double(points[0].y());
  const auto cellX = [&](double x) { return std::round((x - anchor_x) / edge); };
  const auto cellY = [&](double y) { return std::round((y - anchor_y) / edge); };
  const auto fill = [&](double i, double j, std::int64_t count, const std::array<std::int64_t, 3>& values) {
    const double x0 = anchor_x + (i - 0.5) * edge, x1 = anchor_x + (i + 0.5) * edge;
    const double y0 = anchor_y + (j - 0.5) * edge, y1 = anchor_y + (j + 0.5) * edge;
    const auto reach = pixels.reach(x0, y0, x1, y1);
    if (!sums.touches(reach)) return;
    const double right = std::min(reach.column1, sums.column0 + sums.width - 1);
    const double bottom = std::min(reach.row1, sums.row0 + sums.height - 1);
    for (double row = std::max(reach.row0, sums.row0); row <= bottom; ++row) {
      for (double column = std::max(reach.column0, sums.column0); column <= right; ++column) {
        const Eigen::Vector2d ground = pixels.groundBelow(column, row);
        if (ground.x() >= x0 && ground.x() < x1 && ground.y() >= y0 && ground.y() < y1) {
          sums.add(sums.at(column, row), count, values);
        }
      }
    }
  };
  const double margin =
      edge;  // a cell extends half of it beyond its point, and the lattice may shift it by as much
  walk(
      tree,
      [&](const CloudNode& node) {
        if (stopped(cancelled)) return Visit::Skip;
        const auto reach = pixels.reach(double(node.min[0]) - margin, double(node.min[1]) - margin,
                                        double(node.max[0]) + margin, double(node.max[1]) + margin);
        if (!sums.touches(reach)) return Visit::Skip;
        const Visit visit = meant.of(node);
        const bool one_cell = cellX(double(node.min[0])) == cellX(double(node.max[0])) &&
                              cellY(double(node.min[1])) == cellY(double(node.max[1]));
        return visit == Visit::Whole && !one_cell ? Visit::Into : visit;
      },
      [&](const CloudNode& node) {
        fill(cellX(double(node.min[0])), cellY(double(node.min[1])), node.count, channels.of(node));
      },
      [&](std::uint32_t i) {
        if (stopped(cancelled)) return;
        const Eigen::Vector3f& point = points[i];
        if (meant.has(point)) fill(cellX(double(point.x())), cellY(double(point.y())), 1, channels.of(i));
      });
  return !stopped(cancelled);
}

class Painter {
 public:
  Painter(const CloudLook& look, double expected) : look_(look) {
    // Twice the expected number is opaque.
    const auto full = std::size_t(std::clamp(std::ceil(2 * expected), 1.0, 4096.0));
    opacity_.resize(full + 1, 1.0);
    for (std::size_t n = 0; n < full; ++n) {
      opacity_[n] = kLeastOpacity + (1 - kLeastOpacity) * std::log1p(double(n)) / std::log1p(double(full));
    }
  }

  std::uint32_t color(const Sums& sums, std::size_t at) const {
    const double points = double(sums.count[at]);
    const auto mean = [&](std::size_t channel) { return double(sums.value[channel][at]) / points; };
    switch (look_.color) {
      case CloudColor::OneColor:
        return look_.one;
      case CloudColor::Intensity:
        return shade(mean(0) / kParts, look_.low_intensity, look_.high_intensity);
      case CloudColor::Height:
        return shade(mean(0) / kParts, look_.low_z_m, look_.high_z_m);
      case CloudColor::Rgb:
        break;
    }
    return std::uint32_t(std::lround(mean(0))) << 16 | std::uint32_t(std::lround(mean(1))) << 8 |
           std::uint32_t(std::lround(mean(2)));
  }
  double opacity(std::int64_t points) const {
    return opacity_[std::min(std::size_t(points), opacity_.size() - 1)];
  }

 private:
  static std::uint32_t shade(double value, double low, double high) {
    const double part = high > low ? (value - low) / (high - low) : 0.5;
    return shades()[std::size_t(std::lround(std::clamp(part, 0.0, 1.0) * 255))];
  }
  const CloudLook& look_;
  std::vector<double> opacity_;
};

std::uint32_t premultiplied(std::uint32_t rgb, double opacity) {
  std::uint32_t color = std::uint32_t(std::lround(opacity * 255)) << 24;
  for (const int shift : {16, 8, 0}) {
    color |= std::uint32_t(std::lround(double(rgb >> shift & 255) * opacity)) << shift;
  }
  return color;
}

std::uint32_t over(std::uint32_t rgb, double opacity, std::uint32_t below) {
  std::uint32_t color = 0;
  for (const int shift : {16, 8, 0}) {
    const double mixed = double(rgb >> shift & 255) * opacity + double(below >> shift & 255) * (1 - opacity);
    color |= std::uint32_t(std::lround(mixed)) << shift;
  }
  return color;
}

// Viridis with a lighter dark end: low points must not vanish on a dark map.
constexpr std::array<std::array<double, 3>, 6> kStops{
    {{76, 60, 160}, {58, 110, 190}, {32, 150, 150}, {70, 185, 90}, {190, 200, 40}, {250, 130, 30}}};

Shades make() {
  Shades made{};
  for (std::size_t i = 0; i < made.size(); ++i) {
    const double at = double(i) / double(made.size() - 1) * double(kStops.size() - 1);
    const auto below = std::size_t(std::min(at, double(kStops.size() - 2)));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double from = kStops[below][channel], to = kStops[below + 1][channel];
      made[i] = made[i] << 8 | std::uint32_t(std::lround(from + (to - from) * (at - double(below))));
    }
  }
  return made;
}

}  // namespace

int pointSize(int size_px, double scale_m_per_px, double spacing_m) {
  const double room = spacing_m > 0 ? std::floor(spacing_m / scale_m_per_px) : kLargestPoint;
  return int(std::clamp(std::min(double(size_px), std::max(1.0, room)), 1.0, double(kLargestPoint)));
}

CloudPixels drawClouds(const Raster& raster, const CloudSet& set, const CloudLook& look,
                       const std::atomic<bool>* cancelled) {
  if (!usable(raster) || set.clouds.empty()) return {};
  const int edge = pointSize(look.size_px, raster.scale_m_per_px, set.spacing_m);
  Sums points(raster, edge, Channels::countOf(look.color));
  const bool has_voxels = std::any_of(set.clouds.begin(), set.clouds.end(),
                                      [](const ShownCloud& each) { return each.kind == PointKind::Voxel; });
  std::optional<Sums> voxels;
  if (has_voxels) voxels.emplace(raster, 0, Channels::countOf(look.color));
  for (const ShownCloud& cloud : set.clouds) {
    if (cloud.kind == PointKind::Point) {
      addPoints(points, raster, cloud, look, cancelled);
    } else if (cloud.voxel_m / raster.scale_m_per_px < kLeastVoxelPx) {
      addPoints(*voxels, raster, cloud, look, cancelled);
    } else if (!addVoxels(*voxels, raster, cloud, look, cancelled)) {
      return {};
    }
    if (stopped(cancelled)) return {};
  }
  if (edge > 1) points.widen(edge);

  CloudPixels pixels{raster.width_px, raster.height_px, {}};
  pixels.argb.resize(std::size_t(raster.width_px) * std::size_t(raster.height_px));
  const double expected = set.spacing_m > 0 ? std::pow(raster.scale_m_per_px / set.spacing_m, 2) : 0;
  const Painter painter(look, expected);
  bool any = false;
  for (int row = 0; row < raster.height_px; ++row) {
    for (int column = 0; column < raster.width_px; ++column) {
      const auto in = [&](const Sums& sums) {
        return std::size_t(row + sums.margin) * std::size_t(sums.width) + std::size_t(column + sums.margin);
      };
      const std::size_t at = in(points), below = voxels ? in(*voxels) : 0;
      const bool has_voxel = voxels && voxels->count[below] > 0;
      std::uint32_t color = 0;
      if (points.count[at] > 0) {
        const std::uint32_t rgb = painter.color(points, at);
        const double opacity = painter.opacity(points.count[at]);
        color = has_voxel ? 0xff000000 | over(rgb, opacity, painter.color(*voxels, below))
                          : premultiplied(rgb, opacity);
      } else if (has_voxel) {
        color = 0xff000000 | painter.color(*voxels, below);
      }
      any = any || color != 0;
      pixels.argb[std::size_t(row) * std::size_t(raster.width_px) + std::size_t(column)] = color;
    }
  }
  return any ? pixels : CloudPixels{};
}

std::uint64_t countShown(const CloudSet& set, const HeightRange& heights) {
  std::uint64_t count = 0;
  for (const ShownCloud& cloud : set.clouds) {
    const Meant meant(*cloud.tree, cloud.hidden, heights);
    const auto points = cloud.tree->points();
    walk(
        *cloud.tree, [&](const CloudNode& node) { return meant.of(node); },
        [&](const CloudNode& node) { count += node.count; },
        [&](std::uint32_t i) { count += meant.has(points[i]) ? 1 : 0; });
  }
  return count;
}

const Shades& shades() {
  static const Shades made = make();
  return made;
}

}  // namespace mapwright::clouds
