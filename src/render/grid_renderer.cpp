#include "render/grid_renderer.h"

#include <algorithm>

namespace mapwright::render {
namespace {

constexpr std::size_t kStandInsOutOfView = 32;

/// The colour of a mean without one of its own: between those of the known bytes on both sides.
std::uint32_t between(const GridPalette& palette, std::size_t byte) {
  std::size_t below = byte, above = byte;
  while (below > 0 && palette[below] >> 24 == 0) --below;
  while (above < 255 && palette[above] >> 24 == 0) ++above;
  std::uint32_t color = 0;
  for (const int shift : {0, 8, 16, 24}) {
    const double from = palette[below] >> shift & 255, to = palette[above] >> shift & 255;
    const double part = above > below ? double(byte - below) / double(above - below) : 0;
    color |= std::uint32_t(from + (to - from) * part + 0.5) << shift;
  }
  return color;
}

/// RGB32 if everything is opaque: that is drawn several times faster.
QImage paint(const Composition& pixels, const GridPalette& palette) {
  QImage image(pixels.width_px, pixels.height_px, QImage::Format_ARGB32_Premultiplied);
  std::uint32_t all = 0xff000000, any = 0;
  std::size_t at = 0;
  for (int row = 0; row < pixels.height_px; ++row) {
    auto* line = reinterpret_cast<std::uint32_t*>(image.scanLine(row));
    for (int column = 0; column < pixels.width_px; ++column, ++at) {
      const std::uint16_t flags = pixels.flags[at];
      const std::uint8_t byte = pixels.intensity[at];
      const std::uint32_t color = !flags ? 0 : (flags & kKnownMean) ? between(palette, byte) : palette[byte];
      line[column] = color;
      all &= color;
      any |= color;
    }
  }
  if (any == 0) return {};
  if (all >> 24 == 0xff) image.reinterpretAsFormat(QImage::Format_RGB32);
  return image;
}

}  // namespace

GridRenderer::GridRenderer(Options options, QObject* parent)
    : RasterTiles(std::move(options), kStandInsOutOfView, parent) {
  palette_.fill(0);
}

void GridRenderer::setGrid(std::optional<PlacedGrid> placed, std::optional<PlacedGrid> compared) {
  if (placed == placed_ && compared == compared_) return;
  rows_seen_ = placed && placed->cells ? placed->cells->rowsReady() : 0;
  const bool had = placed_.has_value();
  placed_ = std::move(placed);
  compared_ = std::move(compared);
  nextGeneration();
  cancelAll();
  if (!placed_) {
    forgetAll();
  } else if (had) {
    outdateAll();
  }
  changed();
}

void GridRenderer::rowsArrived() {
  if (!placed_ || !placed_->cells) return;
  const int ready = placed_->cells->rowsReady();
  // A band more above: coarse levels come a band late, and reduced pixels reach over the edge.
  const int from = std::max(0, rows_seen_ - 2 * grids::GridPyramid::kTileEdge);
  rows_seen_ = ready;
  geometry::WorldRect rect;
  for (const double x : {0.0, double(placed_->reference.width)}) {
    for (const double y : {double(from), double(placed_->reference.height)}) {
      rect.extend(placed_->reference.worldFromCell({x, y}));
    }
  }
  touch(rect);
}

void GridRenderer::cellsChanged(const geometry::WorldRect& where) {
  if (!placed_ || where.empty()) return;
  // A pixel shows what the cells around it come to, so it reaches over the edge.
  touch(where.grown(tiles().view().scale_m_per_px + placed_->reference.resolution_m));
}

void GridRenderer::touch(const geometry::WorldRect& where) {
  nextGeneration();
  tiles().touch({where}, generation(), [](ViewTile&) {});
  changed();
}

void GridRenderer::setPalette(const GridPalette& palette) {
  if (palette == palette_) return;
  palette_ = palette;
  ++colors_;
  standIns().clear();
  changed();
}

bool GridRenderer::settled(const ViewTile& tile) const {
  return finishable() ? tile.settled() : tile.current();
}

/// A quick look at every tile comes first, the exact ones after that.
void GridRenderer::startMissing() {
  bool all_seen = true;
  if (previews()) {
    for (const TileKey& key : tiles().visible()) {
      ViewTile& tile = tiles().at(key);
      if (tile.current() || tile.preview_work != 0) continue;
      all_seen = false;
      if (!workers().hasRoom()) {
        cancelExact();  // what somebody waits for goes before what only gets better
        break;
      }
      tile.preview_work = start(key, tile, Sampling::Quick);
    }
  }
  if (!all_seen || !finishable()) return;
  for (const TileKey& key : tiles().visible()) {
    if (!workers().hasRoom()) break;
    ViewTile& tile = tiles().at(key);
    if (!tile.settled() && tile.exact_work == 0 && tile.preview_work == 0) {
      tile.exact_work = start(key, tile, Sampling::Exact);
    }
  }
}

/// While a window's map is still being read, every tile would be made exact several times.
bool GridRenderer::finishable() const {
  return !previews() ||
         (placed_->cells->complete() && (!compared_ || !compared_->cells || compared_->cells->complete()));
}

TileWorkers::Ticket GridRenderer::start(const TileKey& key, const ViewTile& tile, Sampling sampling) {
  const PixelGrid grid = tiles().gridOf(key);
  const bool exact = sampling == Sampling::Exact || (finishable() && quickIsExact(grid, *placed_) &&
                                                     (!compared_ || quickIsExact(grid, *compared_)));
  return RasterTiles::start(
      key, tile,
      [grid, sampling, first = *placed_, second = compared_,
       palette = palette_](const std::atomic<bool>& cancelled) -> TileResult {
        Composition pixels = second ? compareGrids(grid, first, *second, &cancelled, sampling)
                                    : sampleGrid(grid, first, &cancelled, sampling);
        if (pixels.width_px == 0) return {};
        QImage image = paint(pixels, palette);
        return {std::make_shared<const Composition>(std::move(pixels)), std::move(image), nullptr};
      },
      exact, colors_);
}

void GridRenderer::refresh(ViewTile& tile) {
  if (tile.colors == colors_ || !tile.picture.pixels) return;
  tiles().setPicture(tile, tile.picture.pixels, paint(*tile.picture.pixels, palette_), colors_);
}

}  // namespace mapwright::render

#include "moc_grid_renderer.cpp"
