#include "render/painted_tiles.h"

#include <algorithm>

#include "render/stand_ins.h"
#include "render/tile_workers.h"
#include "render/view_tiles.h"

namespace mapwright::render {
namespace {

constexpr std::size_t kPaintedStandIns = 32;
}

class PaintedTiles::Impl {
 public:
  Impl(PaintedTiles& owner, const GridRenderer::Options& options)
      : owner_(owner),
        previews_(options.previews),
        budget_(options.budget ? options.budget : std::make_shared<TileBudget>()),
        tiles_(!options.previews),
        workers_(work::orOwn(options.workers),
                 [this](std::vector<TileWorkers::Outcome> outcomes) { receive(std::move(outcomes)); }) {}
  ~Impl() { budget_->held -= held_; }

  void setPainter(TilePainter painter) {
    if (!painter && !painter_) return;
    painter_ = painter ? std::make_shared<const TilePainter>(std::move(painter)) : nullptr;
    ++generation_;
    // Work in progress continues: while the user drags a slider its tiles are better than none, and will be
    // remade.
    if (!painter_) {
      cancelAll();
      tiles_.clear();
      tiles_.setView(tiles_.view());
      stand_ins_.clear();
    } else {
      tiles_.forEach([this](ViewTile& tile) { tile.touched = generation_; });
    }
    changed();
  }

  void setView(const geometry::ViewTransform& view) {
    if (tiles_.rasterChanges(view)) {
      ++raster_;
      cancelAll();
      if (previews_ && painter_ && active_) {
        stand_ins_.push(tiles_.pictures(kPaintedStandIns), tiles_.view(), 0);
      }
    }
    tiles_.setView(view);
    dropStandInsWhenCovered();
    changed();
  }

  void setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    if (!active_) cancelAll();
    changed();
  }

  GridRenderer::Drawing drawing() {
    GridRenderer::Drawing drawing;
    if (!painter_) return drawing;
    if (!stand_ins_.empty()) stand_ins_.draw(tiles_.view(), drawing.stand_ins);
    for (const TilePlace& place : tiles_.visible()) {
      const ViewTile* const tile = tiles_.find(place);
      if (!tile || !tile->known) continue;
      const QPointF offset = tiles_.offsetOf(place);
      if (!drawing.stand_ins.empty()) {
        drawing.covered += QRect(int(offset.x()), int(offset.y()), kTileEdge, kTileEdge);
      }
      if (tile->picture.image.isNull()) continue;
      drawing.tiles.push_back(
          {tile->picture.image, QTransform::fromTranslate(offset.x(), offset.y()), false});
    }
    return drawing;
  }

  bool settled() const {
    if (!painter_ || !active_) return true;
    return std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TilePlace& place) {
      const ViewTile* const tile = tiles_.find(place);
      return tile && tile->current();
    });
  }

  std::size_t cacheBytes() const { return tiles_.bytes() + stand_ins_.bytes(); }

 private:
  struct Work {
    TilePlace place;
    std::uint64_t raster = 0, generation = 0;
  };

  void changed() {
    if (announced_) return;
    announced_ = true;
    QMetaObject::invokeMethod(
        &owner_,
        [this] {
          announced_ = false;
          proceed();
          const bool settled_now = settled();
          const bool flipped = settled_now != was_settled_;
          was_settled_ = settled_now;
          Q_EMIT owner_.tilesChanged();
          if (flipped) Q_EMIT owner_.settledChanged();
        },
        Qt::QueuedConnection);
  }

  void proceed() {
    if (!painter_ || !active_) {
      keepWithin(0);
      return;
    }
    for (const TilePlace& place : tiles_.visible()) {
      if (!workers_.hasRoom()) break;
      ViewTile& tile = tiles_.at(place);
      if (tile.current() || tile.exact_work != 0) continue;
      const PixelGrid grid = tiles_.gridOf(place);
      tile.exact_work = workers_.start(
          tile.urgency(), [grid, painter = painter_](const std::atomic<bool>& cancelled) -> TileResult {
            return {nullptr, (*painter)(grid, cancelled), nullptr};
          });
      under_way_[tile.exact_work] = {place, raster_, generation_};
    }
    keepWithin(budget_->bytes);
  }

  /// Visible tiles stay in any case.
  void keepWithin(std::size_t budget) {
    budget_->held -= held_;
    tiles_.trim(budget > budget_->held ? budget - budget_->held : 0);
    held_ = tiles_.bytes();
    budget_->held += held_;
  }

  void receive(std::vector<TileWorkers::Outcome> outcomes) {
    for (TileWorkers::Outcome& outcome : outcomes) {
      const auto found = under_way_.find(outcome.ticket);
      if (found == under_way_.end()) continue;
      const Work work = found->second;
      under_way_.erase(found);
      ViewTile* const tile = work.raster == raster_ ? tiles_.find(work.place) : nullptr;
      if (!tile || outcome.cancelled || tile->exact_work != outcome.ticket) continue;
      tile->exact_work = 0;
      tiles_.setPicture(*tile, nullptr, std::move(outcome.result.image), 0);
      tile->known = tile->exact = true;
      tile->shown = work.generation;
    }
    proceed();
    dropStandInsWhenCovered();
    changed();
  }

  void cancelAll() {
    tiles_.forEach([this](ViewTile& tile) {
      if (tile.exact_work != 0) workers_.cancel(tile.exact_work);
      tile.exact_work = 0;
    });
  }

  void dropStandInsWhenCovered() {
    if (stand_ins_.empty()) return;
    if (std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TilePlace& place) {
          const ViewTile* const tile = tiles_.find(place);
          return tile && tile->known;
        })) {
      stand_ins_.clear();
    }
  }

  PaintedTiles& owner_;
  bool previews_;
  std::shared_ptr<TileBudget> budget_;
  std::size_t held_ = 0;  // of it
  std::shared_ptr<const TilePainter> painter_;
  ViewTiles tiles_;
  StandIns stand_ins_;
  bool active_ = true, announced_ = false, was_settled_ = true;
  std::uint64_t raster_ = 0, generation_ = 1;
  std::unordered_map<TileWorkers::Ticket, Work> under_way_;
  TileWorkers workers_;  // last member: its destructor waits for its work
};

PaintedTiles::PaintedTiles(GridRenderer::Options options, QObject* parent)
    : QObject(parent), impl_(std::make_unique<Impl>(*this, options)) {}

PaintedTiles::~PaintedTiles() = default;

void PaintedTiles::setPainter(TilePainter painter) { impl_->setPainter(std::move(painter)); }
void PaintedTiles::setView(const geometry::ViewTransform& view) { impl_->setView(view); }
void PaintedTiles::setActive(bool active) { impl_->setActive(active); }
GridRenderer::Drawing PaintedTiles::drawing() { return impl_->drawing(); }
bool PaintedTiles::settled() const { return impl_->settled(); }
std::size_t PaintedTiles::cacheBytes() const { return impl_->cacheBytes(); }

}  // namespace mapwright::render

#include "moc_painted_tiles.cpp"
