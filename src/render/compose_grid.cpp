#include "render/compose_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "grids/faults.h"
#include "render/faults.h"

namespace mapwright::render {
namespace {

constexpr int kStrip = 256;      // rows
constexpr int kColumns = 2'048;  // of one composed window

/// Percent occupied of every intensity.
std::array<std::uint8_t, 256> percents() {
  std::array<std::uint8_t, 256> table{};
  for (int intensity = 0; intensity < 256; ++intensity) {
    table[std::size_t(intensity)] = std::uint8_t(std::lround((1.0 - intensity / 255.0) * 100.0));
  }
  return table;
}

}  // namespace

tl::expected<ComposedGrid, Fault> composeGrid(std::span<const PlacedTexture> textures, double resolution_m,
                                              DenseCache& cache, const std::function<bool(double)>& proceed,
                                              const grids::Resources& resources) {
  const auto fail = [](FaultCode code) { return tl::make_unexpected(Fault(code)); };
  if (!(resolution_m > 0) || !std::isfinite(resolution_m))
    return fail(faultText("render", "The resolution must be greater than 0."));
  std::vector<geometry::WorldRect> rects;
  geometry::WorldRect bounds;
  for (const PlacedTexture& texture : textures) {
    rects.push_back(boundsOf(texture));
    bounds.extend(rects.back());
  }
  if (bounds.empty()) return fail(fault::NoSubmapToExport);
  const double left = std::floor(bounds.min_x / resolution_m),
               bottom = std::floor(bounds.min_y / resolution_m);
  const double columns = std::ceil(bounds.max_x / resolution_m) - left;
  const double rows = std::ceil(bounds.max_y / resolution_m) - bottom;
  if (!(columns >= 1 && rows >= 1 && columns <= grids::kMaxGridEdge && rows <= grids::kMaxGridEdge &&
        columns * rows <= double(grids::kMaxGridCells))) {
    return fail(faultText("render",
                          "The map is too large for one picture at this resolution. Choose a coarser one."));
  }
  const int width = int(columns), height = int(rows);
  ComposedGrid made;
  made.reference.width = width;
  made.reference.height = height;
  made.reference.resolution_m = resolution_m;
  // In decimals: 0.05 times a whole number often is none (-55.650000000000006), and it ends in files.
  const auto metres = [](double value) { return std::round(value * 1e9) / 1e9; };
  made.reference.origin = {metres(left * resolution_m), metres(bottom * resolution_m), 0};
  const auto builder =
      grids::buildGrid(width, height, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins, resources);
  const std::array<std::uint8_t, 256> percent = percents();

  PixelGrid window;
  window.origin_m = {left * resolution_m, (bottom + rows) * resolution_m};
  window.scale_m_per_px = resolution_m;
  std::vector<std::uint8_t> strip;
  std::vector<PlacedTexture> touching;
  for (int row = 0; row < height; row += kStrip) {
    if (proceed && !proceed(double(row) / height)) return fail(grids::fault::WritingStopped);
    window.first_row = row;
    window.height_px = std::min(kStrip, height - row);
    strip.assign(std::size_t(width) * std::size_t(window.height_px), grids::kUnknownOccupancy);
    for (int column = 0; column < width; column += kColumns) {
      window.first_column = column;
      window.width_px = std::min(kColumns, width - column);
      const geometry::WorldRect ground = window.bounds().grown(32 * resolution_m);
      touching.clear();
      for (std::size_t i = 0; i < textures.size(); ++i) {
        if (rects[i].intersects(ground)) touching.push_back(textures[i]);
      }
      if (touching.empty()) continue;
      const Composition pixels = compose(window, touching, Quality::Exact, cache);
      for (int y = 0; y < window.height_px; ++y) {
        for (int x = 0; x < window.width_px; ++x) {
          const std::size_t from = std::size_t(y) * std::size_t(window.width_px) + std::size_t(x);
          if (pixels.flags[from] == 0) continue;
          strip[std::size_t(y) * std::size_t(width) + std::size_t(column + x)] =
              percent[pixels.intensity[from]];
        }
      }
    }
    for (int y = 0; y < window.height_px; ++y) {
      builder->pushRow(std::span(strip).subspan(std::size_t(y) * std::size_t(width), std::size_t(width)));
    }
  }
  builder->finish();
  made.cells = builder->pyramid();
  return made;
}

}  // namespace mapwright::render
