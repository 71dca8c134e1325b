#include "render/placement.h"

#include <algorithm>
#include <cmath>

namespace mapwright::render {
namespace {

constexpr double kFadeCells =
    1.0;  // bilinear reach beyond the outermost cell edges is half a cell; the rest is margin

// The level whose cells are closest to the size of a pixel.
int previewLevel(const cells::CellTexture& texture, double scale_m_per_px) {
  const double octaves = std::round(std::log2(scale_m_per_px / texture.resolutionM()));
  return int(std::clamp(octaves, 0.0, double(texture.levels() - 1)));
}

bool allFinite(const Placement& p) {
  return std::isfinite(p.u) && std::isfinite(p.u_per_column) && std::isfinite(p.u_per_row) &&
         std::isfinite(p.v) && std::isfinite(p.v_per_column) && std::isfinite(p.v_per_row) &&
         std::isfinite(p.first_row) && std::isfinite(p.last_row);
}

void setAffine(const PixelGrid& grid, Placement& p) {
  const auto& pose = p.placed->world_from_texture;
  const double grid_c = std::cos(grid.rotation_rad), grid_s = std::sin(grid.rotation_rad);
  const double pose_c = std::cos(pose.yaw_rad), pose_s = std::sin(pose.yaw_rad);
  // inverse(world_from_texture) * vector, then column = -y / res, row = -x / res.
  const auto cellsFrom = [&](double world_dx, double world_dy) {
    const double x = pose_c * world_dx + pose_s * world_dy;
    const double y = -pose_s * world_dx + pose_c * world_dy;
    return Eigen::Vector2d(-y / p.resolution_m, -x / p.resolution_m);
  };
  const double scale = grid.scale_m_per_px;
  const Eigen::Vector2d start = cellsFrom(grid.origin_m.x() - pose.x_m, grid.origin_m.y() - pose.y_m);
  const Eigen::Vector2d column = cellsFrom(grid_c * scale, -grid_s * scale);
  const Eigen::Vector2d row = cellsFrom(-grid_s * scale, -grid_c * scale);
  p.u = start.x(), p.v = start.y();
  p.u_per_column = column.x(), p.v_per_column = column.y();
  p.u_per_row = row.x(), p.v_per_row = row.y();
}

// The rotation is rigid, so the inverse of the 2x2 part is its transpose divided by the square of the scale
// in cells.
void setRows(const PixelGrid& grid, Placement& p) {
  const double cells_per_px = grid.scale_m_per_px / p.resolution_m;
  const double squared = cells_per_px * cells_per_px;
  bool first = true;
  for (const double u : {-kFadeCells, p.width + kFadeCells}) {
    for (const double v : {-kFadeCells, p.height + kFadeCells}) {
      const double row = ((u - p.u) * p.u_per_row + (v - p.v) * p.v_per_row) / squared;
      p.first_row = first ? row : std::min(p.first_row, row);
      p.last_row = first ? row : std::max(p.last_row, row);
      first = false;
    }
  }
}

}  // namespace

Footprint Placement::footprintOf(const PixelSquare& square) const {
  const double half = square.edge / 2;
  const double column = square.column + half, row = square.row + half;
  return {u + column * u_per_column + row * u_per_row, v + column * v_per_column + row * v_per_row,
          half * (std::abs(u_per_column) + std::abs(u_per_row)),
          half * (std::abs(v_per_column) + std::abs(v_per_row))};
}

bool Placement::touches(const PixelSquare& square) const {
  const Footprint f = footprintOf(square);
  // A reduced level has cells of 2^level: its fade reaches as much further.
  const double fade = kFadeCells * double(1 << level);
  return f.u + f.reach_u > -fade && f.u - f.reach_u < width + fade && f.v + f.reach_v > -fade &&
         f.v - f.reach_v < height + fade;
}

std::vector<Placement> placeTextures(const PixelGrid& grid, std::span<const PlacedTexture> textures,
                                     Quality quality) {
  std::vector<Placement> placements;
  placements.reserve(textures.size());
  for (const PlacedTexture& placed : textures) {
    if (!placed.texture) continue;
    Placement p;
    p.placed = &placed;
    p.width = placed.texture->width();
    p.height = placed.texture->height();
    p.resolution_m = placed.texture->resolutionM();
    p.nearest = grid.scale_m_per_px < p.resolution_m / 4;
    p.level = quality == Quality::Preview ? previewLevel(*placed.texture, grid.scale_m_per_px) : 0;
    setAffine(grid, p);
    setRows(grid, p);
    const double fade_rows = kFadeCells * double(1 << p.level) * p.resolution_m / grid.scale_m_per_px;
    p.first_row -= fade_rows;
    p.last_row += fade_rows;
    if (allFinite(p)) placements.push_back(p);
  }
  return placements;
}

}  // namespace mapwright::render
