#include "clouds/sums.h"

#include <algorithm>
#include <cmath>

namespace mapwright::clouds {

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

}  // namespace mapwright::clouds
