#include "render/tile_renderer.h"

#include <algorithm>
#include <cmath>

#include "render/tile_work.h"

namespace mapwright::render {

class TileRenderer::Impl {
 public:
  Impl(TileRenderer& owner, const Options& options) : work(options, [this] { changed(); }), owner_(owner) {}

  // Continues, and emits the signal once per turn of the event loop.
  void changed() {
    if (announced_) return;
    announced_ = true;
    QMetaObject::invokeMethod(
        &owner_, [this] { announce(); }, Qt::QueuedConnection);
  }

  TileWork work;

 private:
  void announce() {
    announced_ = false;
    work.proceed();
    const bool settled = work.settled();
    const bool flipped = settled != was_settled_;
    was_settled_ = settled;
    Q_EMIT owner_.tilesChanged();
    if (flipped) Q_EMIT owner_.settledChanged();
  }

  TileRenderer& owner_;
  bool announced_ = false;
  bool was_settled_ = true;
};

TileRenderer::TileRenderer(Options options, QObject* parent)
    : QObject(parent), impl_(std::make_unique<Impl>(*this, options)) {}

TileRenderer::~TileRenderer() = default;

void TileRenderer::upsert(std::vector<PlacedTexture> placed) {
  std::vector<geometry::WorldRect> changed;
  for (PlacedTexture& texture : placed) {
    const auto change = impl_->work.index().upsert(std::move(texture));
    if (!change) continue;
    if (!change->before.empty()) changed.push_back(change->before);
    if (!change->after.empty() && !(change->after == change->before)) changed.push_back(change->after);
  }
  if (changed.empty()) return;
  impl_->work.contentChanged(changed);
  impl_->changed();
}

void TileRenderer::remove(const std::vector<map::SubmapId>& ids) {
  std::vector<geometry::WorldRect> changed;
  for (const map::SubmapId id : ids) {
    if (const auto before = impl_->work.index().remove(id)) changed.push_back(*before);
  }
  if (changed.empty()) return;
  impl_->work.contentChanged(changed);
  impl_->changed();
}

void TileRenderer::clear() {
  if (textureCount() == 0) return;
  impl_->work.index().clear();
  impl_->work.contentCleared();
  impl_->changed();
}

geometry::WorldRect TileRenderer::contentBounds() const { return impl_->work.index().bounds(); }

std::size_t TileRenderer::textureCount() const { return impl_->work.index().size(); }

void TileRenderer::setView(const geometry::ViewTransform& view) {
  impl_->work.setView(view);
  impl_->changed();
}

void TileRenderer::setColors(const MapColors& colors, ColorMode mode) {
  impl_->work.setColors(colors, mode);
  impl_->changed();
}

const MapColors& TileRenderer::colors() const { return impl_->work.colors(); }

std::vector<DrawnTile> TileRenderer::drawnTiles() {
  TileWork& work = impl_->work;
  std::vector<DrawnTile> drawn;
  work.standIns().draw(work.tiles().view(), drawn);
  const bool over_stand_ins = !drawn.empty();
  QImage unknown;
  for (const TilePlace& place : work.tiles().visible()) {
    const ViewTile* const tile = work.tiles().find(place);
    if (tile == nullptr || !tile->known) continue;
    const QPointF offset = work.tiles().offsetOf(place);
    QImage image = work.imageOf(place);
    if (image.isNull()) {
      // It is empty, and has to hide its stand-in.
      if (!over_stand_ins) continue;
      if (work.colors().clear_unknown) {
        drawn.push_back({{}, QTransform::fromTranslate(offset.x(), offset.y()), false});
        continue;
      }
      if (unknown.isNull()) {
        unknown = QImage(kTileEdge, kTileEdge, QImage::Format_RGB32);
        unknown.fill(work.colors().unknown);
      }
      image = unknown;
    }
    drawn.push_back({std::move(image), QTransform::fromTranslate(offset.x(), offset.y()), false});
  }
  return drawn;
}

bool TileRenderer::settled() const { return impl_->work.settled(); }

TileCounts TileRenderer::counts() const { return impl_->work.counts(); }

Composition TileRenderer::composition() const {
  const ViewTiles& tiles = impl_->work.tiles();
  Composition whole;
  if (tiles.visible().empty()) return whole;
  whole.width_px = tiles.view().width_px;
  whole.height_px = tiles.view().height_px;
  const std::size_t pixels = std::size_t(whole.width_px) * std::size_t(whole.height_px);
  whole.intensity.assign(pixels, 128);
  whole.flags.assign(pixels, 0);
  for (const TilePlace& place : tiles.visible()) {
    const ViewTile* const tile = tiles.find(place);
    if (tile == nullptr || !tile->picture.pixels) continue;
    const Composition& part = *tile->picture.pixels;
    const QPointF offset = tiles.offsetOf(place);
    const int left = int(offset.x()), top = int(offset.y());
    const int first = std::max(0, -left), last = std::min(part.width_px, whole.width_px - left);
    for (int row = std::max(0, -top); row < std::min(part.height_px, whole.height_px - top); ++row) {
      const auto from = std::ptrdiff_t(row) * part.width_px + first;
      const auto to = std::ptrdiff_t(top + row) * whole.width_px + left + first;
      std::copy_n(part.intensity.begin() + from, last - first, whole.intensity.begin() + to);
      std::copy_n(part.flags.begin() + from, last - first, whole.flags.begin() + to);
    }
  }
  return whole;
}

std::optional<int> TileRenderer::intensityAt(const Eigen::Vector2d& world_m) const {
  const ViewTiles& tiles = impl_->work.tiles();
  const auto pixel = tiles.pixelAt(world_m);
  const ViewTile* const tile = pixel ? tiles.find(pixel->place) : nullptr;
  if (tile == nullptr || !tile->picture.pixels) return std::nullopt;
  const Composition& pixels = *tile->picture.pixels;
  if (pixel->column >= pixels.width_px || pixel->row >= pixels.height_px) return std::nullopt;
  const std::size_t at = std::size_t(pixel->row) * std::size_t(pixels.width_px) + std::size_t(pixel->column);
  if (pixels.flags[at] == 0) return std::nullopt;
  return pixels.intensity[at];
}

}  // namespace mapwright::render

#include "moc_tile_renderer.cpp"
