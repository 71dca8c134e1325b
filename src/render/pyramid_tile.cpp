#include "render/pyramid_tile.h"

#include <algorithm>
#include <cmath>

namespace mapwright::render {
namespace {

constexpr std::uint16_t kUnobserved = 128 << 8;
constexpr int kMostTilesAcross = 16;  // a view tile needs at most 8 at the levels that are used

// The patch as one raster, so that sampling needs no tile look-ups.
struct PatchRaster {
  int width = 0, height = 0;
  std::vector<std::uint16_t> intensity;
  std::vector<std::uint16_t> flags;
};

PatchRaster joined(const PyramidPatch& patch) {
  PatchRaster raster;
  raster.width = patch.columns * kTileEdge;
  raster.height = patch.rows * kTileEdge;
  const std::size_t pixels = std::size_t(raster.width) * std::size_t(raster.height);
  raster.intensity.assign(pixels, kUnobserved);
  raster.flags.assign(pixels, 0);
  for (int ty = 0; ty < patch.rows; ++ty) {
    for (int tx = 0; tx < patch.columns; ++tx) {
      const PyramidTilePtr& tile = patch.tiles[std::size_t(ty * patch.columns + tx)];
      if (!tile) continue;
      for (int y = 0; y < kTileEdge; ++y) {
        const auto from = std::ptrdiff_t(y) * kTileEdge;
        const auto to = std::ptrdiff_t(ty * kTileEdge + y) * raster.width + std::ptrdiff_t(tx) * kTileEdge;
        std::copy_n(tile->intensity.begin() + from, kTileEdge, raster.intensity.begin() + to);
        std::copy_n(tile->flags.begin() + from, kTileEdge, raster.flags.begin() + to);
      }
    }
  }
  return raster;
}

// Sum of n x n samples.
struct SampleSum {
  std::uint32_t intensity = 0;
  std::int32_t all_flags = 0, highest_flags = 0, last_flags = 0;  // united() when all are in
};

constexpr int kBits = 8;  // fraction of a raster coordinate

void addSample(const PatchRaster& raster, std::int64_t x, std::int64_t y, SampleSum& sum) {
  // Fixed-point tap coordinates; outside, the nearest pixel of the raster stands (the patch reaches a pixel
  // further).
  const int column = int(std::clamp<std::int64_t>(x >> kBits, 0, raster.width - 2));
  const int row = int(std::clamp<std::int64_t>(y >> kBits, 0, raster.height - 2));
  const std::uint32_t fx = std::uint32_t(x) & 255, fy = std::uint32_t(y) & 255;
  const std::size_t at = std::size_t(row) * std::size_t(raster.width) + std::size_t(column);
  const std::uint16_t* const top = raster.intensity.data() + at;
  const std::uint16_t* const bottom = top + raster.width;
  const std::uint32_t upper = (top[0] * (256 - fx) + top[1] * fx) >> 8;
  const std::uint32_t lower = (bottom[0] * (256 - fx) + bottom[1] * fx) >> 8;
  sum.intensity += (upper * (256 - fy) + lower * fy) >> 8;
  const std::int32_t flags =
      raster.flags[at + (fx >= 128 ? 1 : 0) + (fy >= 128 ? std::size_t(raster.width) : 0)];
  if (flags == sum.last_flags) return;  // as nearly always
  sum.last_flags = flags;
  sum.all_flags |= flags;
  sum.highest_flags = std::max(sum.highest_flags, flags);
}

}  // namespace

PixelGrid gridOf(const PyramidKey& key, double base_m_per_px) {
  PixelGrid grid;
  grid.scale_m_per_px = std::ldexp(base_m_per_px, key.level);
  grid.first_column = key.x * kTileEdge;
  grid.first_row = key.y * kTileEdge;
  grid.width_px = grid.height_px = kTileEdge;
  return grid;
}

PyramidTilePtr pyramidTileOf(const Composition& pixels) {
  if (std::all_of(pixels.flags.begin(), pixels.flags.end(), [](std::uint16_t f) { return f == 0; }))
    return nullptr;
  auto tile = std::make_shared<PyramidTile>();
  tile->intensity.reserve(pixels.intensity.size());
  for (const std::uint8_t intensity : pixels.intensity)
    tile->intensity.push_back(std::uint16_t(intensity << 8));
  tile->flags = pixels.flags;
  return tile;
}

PyramidTilePtr halved(const std::array<PyramidTilePtr, 4>& parts) {
  if (std::all_of(parts.begin(), parts.end(), [](const auto& part) { return !part; })) return nullptr;
  constexpr int kHalf = kTileEdge / 2;
  auto tile = std::make_shared<PyramidTile>();
  tile->intensity.assign(std::size_t(kTileEdge) * kTileEdge, kUnobserved);
  tile->flags.assign(std::size_t(kTileEdge) * kTileEdge, 0);
  for (std::size_t p = 0; p < 4; ++p) {
    if (!parts[p]) continue;
    const std::size_t x0 = (p % 2) * kHalf, y0 = (p / 2) * kHalf;
    for (std::size_t y = 0; y < kHalf; ++y) {
      const std::uint16_t* const top = parts[p]->intensity.data() + 2 * y * kTileEdge;
      const std::uint16_t* const bottom = top + kTileEdge;
      const std::uint16_t* const top_flags = parts[p]->flags.data() + 2 * y * kTileEdge;
      const std::uint16_t* const bottom_flags = top_flags + kTileEdge;
      std::uint16_t* const out = tile->intensity.data() + (y0 + y) * kTileEdge + x0;
      std::uint16_t* const out_flags = tile->flags.data() + (y0 + y) * kTileEdge + x0;
      for (std::size_t x = 0; x < kHalf; ++x) {
        const std::uint32_t sum =
            std::uint32_t(top[2 * x]) + top[2 * x + 1] + bottom[2 * x] + bottom[2 * x + 1];
        out[x] = std::uint16_t((sum + 2) / 4);
        const auto a = std::int16_t(top_flags[2 * x]), b = std::int16_t(top_flags[2 * x + 1]);
        const auto c = std::int16_t(bottom_flags[2 * x]), d = std::int16_t(bottom_flags[2 * x + 1]);
        const auto all = std::int16_t(a | b | c | d);
        out_flags[x] = std::uint16_t(united(all, std::max(std::max(a, b), std::max(c, d))));
      }
    }
  }
  return tile;
}

PyramidPatch patchFor(const PixelGrid& grid, int level, double base_m_per_px) {
  PyramidPatch patch;
  patch.m_per_px = std::ldexp(base_m_per_px, level);
  const geometry::WorldRect rect = grid.bounds().grown(2 * patch.m_per_px);
  const double tile_m = patch.m_per_px * kTileEdge;
  const double x0 = std::floor(rect.min_x / tile_m), x1 = std::floor(rect.max_x / tile_m);
  const double y0 = std::floor(-rect.max_y / tile_m), y1 = std::floor(-rect.min_y / tile_m);
  constexpr double kFarthest = double(std::int64_t(1) << 44);
  const bool sane = std::abs(x0) < kFarthest && std::abs(y0) < kFarthest && x1 - x0 < kMostTilesAcross &&
                    y1 - y0 < kMostTilesAcross;
  if (!sane) return patch;
  patch.first = {level, std::int64_t(x0), std::int64_t(y0)};
  patch.columns = int(x1 - x0) + 1;
  patch.rows = int(y1 - y0) + 1;
  patch.tiles.resize(std::size_t(patch.columns) * std::size_t(patch.rows));
  return patch;
}

Composition resampled(const PixelGrid& grid, const PyramidPatch& patch, const std::atomic<bool>& cancelled) {
  Composition out;
  const PatchRaster raster = joined(patch);
  const std::size_t pixels = std::size_t(grid.width_px) * std::size_t(grid.height_px);
  out.intensity.reserve(pixels);
  out.flags.reserve(pixels);

  const double ratio = grid.scale_m_per_px / patch.m_per_px;
  const int n = std::clamp(int(std::ceil(ratio - 1e-6)), 1, 8);
  // Raster coordinates of tap 0 (pixel centres at whole numbers) in fixed point, affine in the samples.
  const auto rasterOf = [&](double column, double row) {
    const Eigen::Vector2d world = grid.worldFromPixel(column, row);
    return Eigen::Vector2d(world.x() / patch.m_per_px - double(patch.first.x) * kTileEdge - 0.5,
                           -world.y() / patch.m_per_px - double(patch.first.y) * kTileEdge - 0.5);
  };
  constexpr int kFineBits = 24;
  const auto fixed = [](double v) { return std::int64_t(std::llround(v * double(1 << kFineBits))); };
  const double step = 1.0 / n;
  const Eigen::Vector2d start = rasterOf(step / 2, step / 2);
  const Eigen::Vector2d across = rasterOf(step / 2 + step, step / 2) - start;
  const Eigen::Vector2d down = rasterOf(step / 2, step / 2 + step) - start;
  const std::int64_t x0 = fixed(start.x()), y0 = fixed(start.y());
  const std::int64_t xi = fixed(across.x()), yi = fixed(across.y()), xj = fixed(down.x()),
                     yj = fixed(down.y());
  const std::uint32_t share = std::uint32_t(n * n) << 8;

  for (int row = 0; row < grid.height_px; ++row) {
    if (cancelled.load(std::memory_order_relaxed)) return {};
    for (int column = 0; column < grid.width_px; ++column) {
      SampleSum sum;
      for (int j = row * n; j < (row + 1) * n; ++j) {
        std::int64_t x = x0 + j * xj + std::int64_t(column) * n * xi;
        std::int64_t y = y0 + j * yj + std::int64_t(column) * n * yi;
        for (int i = 0; i < n; ++i, x += xi, y += yi) {
          addSample(raster, x >> (kFineBits - kBits), y >> (kFineBits - kBits), sum);
        }
      }
      out.intensity.push_back(std::uint8_t((sum.intensity + share / 2) / share));
      out.flags.push_back(std::uint16_t(united(sum.all_flags, sum.highest_flags)));
    }
  }
  out.width_px = grid.width_px;
  out.height_px = grid.height_px;
  return out;
}

}  // namespace mapwright::render
