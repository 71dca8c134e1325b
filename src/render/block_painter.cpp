#include "render/block_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/dense_cache.h"

namespace mapwright::render {
namespace {

constexpr std::size_t kHeldBytes = std::size_t(16) << 20;
constexpr double kFinestStep =
    8;                     // cells between samples up to which a block fits into the fixed-point range
constexpr int kPart = 16;  // samples; parts of a block this large are tested for being empty
constexpr double kUnit = double(1 << kCoordinateBits);
constexpr double kRounding =
    double(1 << (kCoordinateBits - kWeightBits - 1));  // of a coordinate to its weight
constexpr float kUnobservedIntensity = 128.0F;

std::int32_t fixed(double cells) { return std::int32_t(std::llround(cells * kUnit)); }

std::int32_t fixedLimit(int cells_from_base) {
  const std::int64_t limit = std::int64_t(cells_from_base) * (1 << kCoordinateBits);
  return std::int32_t(std::clamp<std::int64_t>(limit, std::numeric_limits<std::int32_t>::min(),
                                               std::numeric_limits<std::int32_t>::max()));
}

void (*kernelFunction(Kernel kernel))(const BlockPass&, SampleBlock&) {
  if (kernel == Kernel::Portable || !kernelAvailable(Kernel::Avx2)) return paintPortable;
  return paintAvx2;
}

// The taps of samples around (u, v) within the given reach, as a rectangle of cells.
struct TapRange {
  double u0, v0, u1, v1;
};

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

// Sampling positions of a block in the cells of the level that is used.
struct BlockPainter::Sampling {
  int samples = 0;
  double u = 0, v = 0;  // tap coordinates of sample (0, 0)
  double u_per_column = 0, v_per_column = 0, u_per_row = 0, v_per_row = 0;
  double uAt(double column, double row) const { return u + column * u_per_column + row * u_per_row; }
  double vAt(double column, double row) const { return v + column * v_per_column + row * v_per_row; }

  TapRange tapsOf(int first_column, int first_row, int columns, int rows) const {
    const double half_columns = (columns - 1) / 2.0, half_rows = (rows - 1) / 2.0;
    const double centre_u = uAt(first_column + half_columns, first_row + half_rows);
    const double centre_v = vAt(first_column + half_columns, first_row + half_rows);
    // A thousandth of a cell for the rounding of the increments.
    const double reach_u = half_columns * std::abs(u_per_column) + half_rows * std::abs(u_per_row) + 1e-3;
    const double reach_v = half_columns * std::abs(v_per_column) + half_rows * std::abs(v_per_row) + 1e-3;
    return {std::floor(centre_u - reach_u), std::floor(centre_v - reach_v),
            std::floor(centre_u + reach_u) + 1, std::floor(centre_v + reach_v) + 1};
  }
};

BlockPainter::BlockPainter(DenseCache& cache, Kernel kernel, std::size_t placements)
    : cache_(cache), kernel_(kernelFunction(kernel)), held_(placements) {}

const TapCells& BlockPainter::cellsOf(const Placement& placement, std::size_t index) {
  if (!held_[index]) {
    if (held_bytes_ > kHeldBytes) {
      for (const std::size_t held : held_indexes_) held_[held].reset();
      held_indexes_.clear();
      held_bytes_ = 0;
    }
    held_[index] = cache_.get(placement.placed->texture, placement.level);
    held_indexes_.push_back(index);
    held_bytes_ += held_[index]->bytes();
  }
  return *held_[index];
}

void BlockPainter::begin(int samples) {
  if (begun_) return;
  begun_ = true;
  const int columns = (samples + 7) / 8 * 8;  // whole vectors, as the kernels paint them
  for (int j = 0; j < samples; ++j) {
    std::fill_n(block_->intensity + j * kBlockEdge, columns, kUnobservedIntensity);
    std::fill_n(block_->flags + j * kBlockEdge, columns, 0);
  }
}

bool BlockPainter::paint(const PixelSquare& square, int samples, std::span<const Placement> placements,
                         std::span<const std::uint32_t> candidates) {
  begun_ = false;
  for (const std::uint32_t index : candidates) paintTexture(square, samples, placements[index], index);
  return begun_;
}

void BlockPainter::paintTexture(const PixelSquare& square, int samples, const Placement& p,
                                std::size_t index) {
  const double step = square.edge / samples;
  const double cell = 1.0 / double(1 << p.level);
  const double tap_offset = p.nearest ? 0.0 : -0.5;
  const double column = square.column + step / 2, row = square.row + step / 2;
  Sampling s;
  s.samples = samples;
  s.u = (p.u + column * p.u_per_column + row * p.u_per_row) * cell + tap_offset;
  s.v = (p.v + column * p.v_per_column + row * p.v_per_row) * cell + tap_offset;
  s.u_per_column = p.u_per_column * step * cell, s.u_per_row = p.u_per_row * step * cell;
  s.v_per_column = p.v_per_column * step * cell, s.v_per_row = p.v_per_row * step * cell;

  const TapCells& cells = cellsOf(p, index);
  const cells::DenseCells& level = cells.level;
  const TapRange taps = s.tapsOf(0, 0, samples, samples);
  if (!(taps.u1 >= 0 && taps.u0 < level.width && taps.v1 >= 0 && taps.v0 < level.height)) return;
  if (std::hypot(s.u_per_column, s.v_per_column) > kFinestStep) {
    paintCoarse(s, cells, p);
  } else {
    paintFine(s, cells, p);
  }
}

// Far fewer samples than cells, as in a preview from far away: one tap per sample, in doubles.
void BlockPainter::paintCoarse(const Sampling& s, const TapCells& tap_cells, const Placement& p) {
  const cells::DenseCells& cells = tap_cells.level;
  for (int j = 0; j < s.samples; ++j) {
    for (int i = 0; i < s.samples; ++i) {
      const double u = std::floor(s.uAt(i, j) + 0.5), v = std::floor(s.vAt(i, j) + 0.5);
      if (!(u >= 0 && v >= 0 && u < cells.width && v < cells.height)) continue;
      constexpr int kBorder = cells::DenseCells::kBorder;
      const std::ptrdiff_t at = std::ptrdiff_t(int(v) + kBorder) * cells.stride + (int(u) + kBorder);
      const std::uint8_t* cell = tap_cells.taps.get() + at * TapCells::kBytesPerCell;
      int value = 0, alpha = 0;
      if (cells.layout == cells::CellLayout::Pairs) {
        value = cell[0], alpha = cell[1];
      } else {
        const int d = *reinterpret_cast<const std::int8_t*>(cell);
        value = std::max(d, 0), alpha = std::max(-d, 0);
      }
      if (value == 0 && alpha == 0) continue;
      begin(s.samples);
      const int sample = j * kBlockEdge + i;
      float& intensity = block_->intensity[sample];
      intensity = std::min(intensity - intensity * (float(alpha) / 255.0F) + float(value), 255.0F);
      block_->flags[sample] = p.placed->flags | kObserved;
    }
  }
}

void BlockPainter::paintFine(const Sampling& s, const TapCells& tap_cells, const Placement& p) {
  const cells::DenseCells& cells = tap_cells.level;
  constexpr int kBorder = cells::DenseCells::kBorder;
  const double middle = (s.samples - 1) / 2.0;
  const int base_u = int(std::clamp(std::floor(s.uAt(middle, middle)), -1.0, double(cells.width)));
  const int base_v = int(std::clamp(std::floor(s.vAt(middle, middle)), -1.0, double(cells.height)));
  BlockPass pass;
  pass.cells = tap_cells.taps.get() + (std::ptrdiff_t(base_v + kBorder) * cells.stride + (base_u + kBorder)) *
                                          TapCells::kBytesPerCell;
  pass.stride = cells.stride;
  pass.layout = cells.layout;
  pass.u = fixed(s.u - base_u) + (p.nearest ? 0 : std::int32_t(kRounding));
  pass.v = fixed(s.v - base_v) + (p.nearest ? 0 : std::int32_t(kRounding));
  pass.u_per_column = fixed(s.u_per_column), pass.v_per_column = fixed(s.v_per_column);
  pass.u_per_row = fixed(s.u_per_row), pass.v_per_row = fixed(s.v_per_row);
  pass.u_low = fixedLimit(-1 - base_u), pass.u_high = fixedLimit(cells.width - base_u);
  pass.v_low = fixedLimit(-1 - base_v), pass.v_high = fixedLimit(cells.height - base_v);
  pass.nearest = p.nearest;
  pass.flags = p.placed->flags | kObserved;

  for (int row = 0; row < s.samples; row += kPart) {
    const int rows = std::min(kPart, s.samples - row);
    // Adjacent parts of a row with content are painted together.
    int run_start = -1;
    bool run_inside = true;
    const auto flush = [&](int end) {
      if (run_start < 0) return;
      begin(s.samples);
      pass.first_column = run_start, pass.columns = end - run_start;
      pass.first_row = row, pass.rows = rows;
      pass.inside = run_inside;
      kernel_(pass, *block_);
      run_start = -1;
      run_inside = true;
    };
    for (int column = 0; column < s.samples; column += kPart) {
      // Whole vectors: up to 7 extra samples are painted.
      const int columns = std::min(kPart, (s.samples - column + 7) / 8 * 8);
      const TapRange taps = s.tapsOf(column, row, columns, rows);
      const bool touches = taps.u1 >= 0 && taps.u0 < cells.width && taps.v1 >= 0 && taps.v0 < cells.height &&
                           !cells.emptyWithin(int(std::max(taps.u0, 0.0)), int(std::max(taps.v0, 0.0)),
                                              int(std::min(taps.u1, cells.width - 1.0)),
                                              int(std::min(taps.v1, cells.height - 1.0)));
      if (!touches) {
        flush(column);
        continue;
      }
      if (run_start < 0) run_start = column;
      run_inside =
          run_inside && taps.u0 >= -1 && taps.u1 <= cells.width && taps.v0 >= -1 && taps.v1 <= cells.height;
      if (column + columns >= s.samples) flush(column + columns);
    }
  }
}

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
