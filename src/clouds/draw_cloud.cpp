#include "clouds/draw_cloud.h"

#include <algorithm>
#include <cmath>

#include "clouds/shades.h"
#include "clouds/sums.h"
#include "clouds/walk.h"

namespace mapwright::clouds {
namespace {

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
        if (stopped(cancelled)) return Way::Skip;
        const auto reach = pixels.reach(node.min[0], node.min[1], node.max[0], node.max[1]);
        if (!sums.touches(reach)) return Way::Skip;
        const Way way = meant.of(node);
        const bool one_pixel = reach.column0 == reach.column1 && reach.row0 == reach.row1;
        return way == Way::Whole && !one_pixel ? Way::Into : way;
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

}  // namespace mapwright::clouds
