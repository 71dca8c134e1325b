#include "reference.h"

#include <algorithm>
#include <cmath>

#include "cells/cell_texture.h"
#include "render/dense_cache.h"

namespace mapwright::testing {
namespace {

constexpr double kDoubt = 2e-3;  // cells

struct Sample {
  double value = 0, alpha = 0;
  bool observed = false, surely_observed = false, perhaps_observed = false, certain = true;
};

bool observed(const cells::CellPair& cell) { return cell.value != 0 || cell.alpha != 0; }

Sample nearestSample(const PlainTexture& texture, double u, double v) {
  const int column = int(std::floor(u)), row = int(std::floor(v));
  const cells::CellPair cell = texture.at(column, row);
  Sample s;
  s.value = cell.value;
  s.alpha = cell.alpha;
  s.observed = s.surely_observed = s.perhaps_observed = observed(cell);
  for (const double du : {-kDoubt, kDoubt}) {
    for (const double dv : {-kDoubt, kDoubt}) {
      if (texture.at(int(std::floor(u + du)), int(std::floor(v + dv))) != cell) s.certain = false;
    }
  }
  return s;
}

Sample bilinearSample(const PlainTexture& texture, double u, double v) {
  Sample s;
  const double tu = u - 0.5, tv = v - 0.5;
  const int column = int(std::floor(tu)), row = int(std::floor(tv));
  // One more on every side: what rounding could reach.
  for (int y = row - 1; y <= row + 2; ++y) {
    for (int x = column - 1; x <= column + 2; ++x) {
      const cells::CellPair cell = texture.at(x, y);
      const double reach_u = 1 - std::abs(tu - x), reach_v = 1 - std::abs(tv - y);
      const double weight = std::max(0.0, reach_u) * std::max(0.0, reach_v);
      s.value += weight * cell.value;
      s.alpha += weight * cell.alpha;
      if (!observed(cell)) continue;
      if (weight > 0) s.observed = true;
      if (weight > kDoubt) s.surely_observed = true;
      if (reach_u > -kDoubt && reach_v > -kDoubt) s.perhaps_observed = true;
    }
  }
  return s;
}

ReferencePixel composedSample(const Eigen::Vector2d& world, double scale_m_per_px,
                              const std::vector<PlainTexture>& textures) {
  ReferencePixel pixel;
  for (const PlainTexture& texture : textures) {
    // inverse(world_from_texture) * world, by its definition.
    const geometry::Pose2& pose = texture.placed.world_from_texture;
    const double dx = world.x() - pose.x_m, dy = world.y() - pose.y_m;
    const double x = texture.cos_yaw * dx + texture.sin_yaw * dy,
                 y = -texture.sin_yaw * dx + texture.cos_yaw * dy;
    const double u = -y / texture.resolution_m, v = -x / texture.resolution_m;
    if (u < -2 || v < -2 || u > texture.width + 2 || v > texture.height + 2) continue;
    const bool nearest = scale_m_per_px < texture.resolution_m / 4;
    const Sample s = nearest ? nearestSample(texture, u, v) : bilinearSample(texture, u, v);
    pixel.intensity = std::min(255.0, s.value + pixel.intensity * (255 - s.alpha) / 255);
    if (!s.certain) pixel.intensity_certain = false;
    if (s.perhaps_observed != s.surely_observed) pixel.flags_certain = false;
    if (s.observed) pixel.flags = std::uint16_t(texture.placed.flags | render::kObserved);
  }
  return pixel;
}

void addRoom(int width, int height, std::vector<cells::CellPair>& cells, std::mt19937& random) {
  const auto below = [&](int end) { return int(random() % unsigned(std::max(1, end))); };
  const int w = std::max(2, width / 8 + below(width / 3)), h = std::max(2, height / 8 + below(height / 3));
  const int x0 = below(width - w), y0 = below(height - h);
  for (int y = y0; y < std::min(height, y0 + h); ++y) {
    for (int x = x0; x < std::min(width, x0 + w); ++x) {
      const bool wall = x == x0 || y == y0 || x == x0 + w - 1 || y == y0 + h - 1;
      const auto strength = std::uint8_t(20 + below(100));
      cells[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
          wall ? cells::CellPair{0, strength} : cells::CellPair{strength, 0};
    }
  }
}

}  // namespace

cells::CellPair PlainTexture::at(int column, int row) const {
  if (column < 0 || row < 0 || column >= width || row >= height) return {};
  return cells[std::size_t(row) * std::size_t(width) + std::size_t(column)];
}

PlainTexture plainTexture(int width, int height, double resolution_m, std::vector<cells::CellPair> cells,
                          geometry::Pose2 pose, int index, std::uint16_t flags) {
  PlainTexture plain{
      width, height, resolution_m, std::move(cells), {}, std::cos(pose.yaw_rad), std::sin(pose.yaw_rad)};
  plain.placed.id = {0, index};
  plain.placed.texture = cells::CellTexture::fromPairs(width, height, resolution_m, plain.cells);
  plain.placed.world_from_texture = pose;
  plain.placed.flags = flags;
  return plain;
}

std::vector<cells::CellPair> randomCells(int width, int height, Content content, std::mt19937& random) {
  std::vector<cells::CellPair> cells(std::size_t(width) * std::size_t(height));
  if (content == Content::Folding) {
    for (int room = 0; room < 8; ++room) addRoom(width, height, cells, random);
    return cells;
  }
  for (cells::CellPair& cell : cells) {
    if (random() % 3 == 0) continue;
    const bool bright = content == Content::Saturating;
    cell = {std::uint8_t(bright ? 120 + random() % 136 : random() % 256),
            std::uint8_t(bright ? random() % 40 : random() % 256)};
  }
  return cells;
}

std::vector<ReferencePixel> referenceComposition(const render::PixelGrid& grid,
                                                 const std::vector<PlainTexture>& textures) {
  std::vector<ReferencePixel> out(std::size_t(grid.width_px) * std::size_t(grid.height_px));
  const double resolution = textures.empty() ? grid.scale_m_per_px : textures.front().resolution_m;
  const int k = std::max(1, int(std::ceil(grid.scale_m_per_px / resolution - 1e-6)));
  std::size_t at = 0;
  for (int row = 0; row < grid.height_px; ++row) {
    for (int column = 0; column < grid.width_px; ++column) {
      ReferencePixel pixel{0, 0, true, true};
      for (int j = 0; j < k; ++j) {
        for (int i = 0; i < k; ++i) {
          const Eigen::Vector2d world = grid.worldFromPixel(column + (i + 0.5) / k, row + (j + 0.5) / k);
          const ReferencePixel sample = composedSample(world, grid.scale_m_per_px, textures);
          pixel.intensity += sample.intensity / (double(k) * k);
          // The properties of all samples, the classes of the one with the greatest.
          const int classes = std::max(pixel.flags >> 4, sample.flags >> 4);
          pixel.flags = std::uint16_t(classes << 4 | ((pixel.flags | sample.flags) & 15));
          pixel.intensity_certain = pixel.intensity_certain && sample.intensity_certain;
          pixel.flags_certain = pixel.flags_certain && sample.flags_certain;
        }
      }
      out[at++] = pixel;
    }
  }
  return out;
}

std::vector<render::PlacedTexture> placedOf(const std::vector<PlainTexture>& textures) {
  std::vector<render::PlacedTexture> placed;
  for (const PlainTexture& texture : textures) placed.push_back(texture.placed);
  return placed;
}

render::PixelGrid gridAround(const Eigen::Vector2d& centre, double scale, double rotation, int width,
                             int height) {
  render::PixelGrid grid;
  grid.scale_m_per_px = scale;
  grid.rotation_rad = rotation;
  grid.width_px = width;
  grid.height_px = height;
  grid.origin_m = centre - grid.worldFromPixel(width / 2.0, height / 2.0);
  return grid;
}

render::Composition composeAll(const render::PixelGrid& grid, const std::vector<PlainTexture>& textures,
                               render::Quality quality, render::Kernel kernel) {
  render::DenseCache cache;
  const auto placed = placedOf(textures);
  return render::compose(grid, placed, quality, cache, kernel);
}

int pixelAt(const render::Composition& picture, int column, int row) {
  return picture.intensity[std::size_t(row) * std::size_t(picture.width_px) + std::size_t(column)];
}

int flagsAt(const render::Composition& picture, int column, int row) {
  return picture.flags[std::size_t(row) * std::size_t(picture.width_px) + std::size_t(column)];
}

PlainTexture uniformTexture(cells::CellPair cell, int index, std::uint16_t flags, double resolution_m) {
  return plainTexture(20, 20, resolution_m, std::vector<cells::CellPair>(400, cell),
                      {10 * resolution_m, 10 * resolution_m, 0}, index, flags);
}

}  // namespace mapwright::testing
