#include "render/painted_tiles.h"

namespace mapwright::render {
namespace {

constexpr std::size_t kPaintedStandIns = 32;
}

PaintedTiles::PaintedTiles(Options options, QObject* parent)
    : RasterTiles(std::move(options), kPaintedStandIns, parent) {}

void PaintedTiles::setPainter(TilePainter painter) {
  if (!painter && !painter_) return;
  painter_ = painter ? std::make_shared<const TilePainter>(std::move(painter)) : nullptr;
  nextGeneration();
  if (!painter_) {
    forgetAll();
  } else {
    outdateAll();
  }
  changed();
}

void PaintedTiles::startMissing() {
  for (const TilePlace& place : tiles().visible()) {
    if (!workers().hasRoom()) break;
    ViewTile& tile = tiles().at(place);
    if (tile.current() || tile.exact_work != 0) continue;
    const auto work = [grid = tiles().gridOf(place),
                       painter = painter_](const std::atomic<bool>& cancelled) -> TileResult {
      return {nullptr, (*painter)(grid, cancelled), nullptr};
    };
    tile.exact_work = start(place, tile, work, true);
  }
}

}  // namespace mapwright::render

#include "moc_painted_tiles.cpp"
