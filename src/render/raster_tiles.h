// The tiles of one layer for the current view: where they lie, what stands in for them, what memory they take
// and what is in progress. What they show is a subclass's.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include <QImage>
#include <QObject>
#include <QRegion>

#include "geometry/view_transform.h"
#include "render/stand_ins.h"
#include "render/tile_workers.h"
#include "render/view_tiles.h"
#include "work/budgets.h"

namespace mapwright::render {

/// What several layers may keep together, bytes. GUI thread.
struct TileBudget {
  std::size_t bytes = work::budgetsFrom().grid_tiles;
  std::size_t held = 0;  // by those that have it
};

/// GUI-thread object; makes pictures on the thread pool: tiles lie in the grid of the view and are drawn at
/// integer offsets; a picture of another view or of older content stands in until the new one is there.
class RasterTiles : public QObject {
  Q_OBJECT
 public:
  struct Options {
    std::shared_ptr<TileBudget> budget = {};      // null = one of its own
    std::shared_ptr<work::Workers> workers = {};  // null = a thread pool of its own
    bool previews = true;                         // false: only exact tiles are ever shown (snapshots)
  };
  ~RasterTiles() override;

  /// A view without pixels shows nothing. Device pixels.
  void setView(const geometry::ViewTransform& view);
  /// While switched off nothing is made; switching on makes what is missing.
  void setActive(bool active);

  /// What to paint now: stand-ins (outside `covered`) first, then finished tiles.
  struct Drawing {
    std::vector<DrawnTile> stand_ins, tiles;
    QRegion covered;  // viewport pixels that need no stand-in
  };
  Drawing drawing();

  /// Every visible tile shows the present content.
  bool settled() const;
  std::size_t cacheBytes() const { return tiles_.bytes() + stand_ins_.bytes(); }

 Q_SIGNALS:
  void tilesChanged();  // repaint; coalesced
  void settledChanged();

 protected:
  /// `stand_ins_out_of_view`: as many pictures of tiles out of view stand in as well.
  RasterTiles(Options options, std::size_t stand_ins_out_of_view, QObject* parent);

  /// There is something to show.
  virtual bool hasContent() const = 0;
  /// It can be painted now.
  virtual bool paintable() const { return hasContent(); }
  /// Precondition: paintable(). Starts what is missing, as far as workers().hasRoom().
  virtual void startMissing() = 0;
  virtual bool settled(const ViewTile& tile) const { return tile.current(); }
  /// The tile is about to be drawn, or to stand in.
  virtual void refresh(ViewTile& /*tile*/) {}
  /// The colour behind the tiles, for stand-ins; 0 = transparent.
  virtual std::uint32_t background() const { return 0; }
  /// Other tiles are visible.
  virtual void viewChanged() {}
  /// The result of work that start() has not started.
  virtual void onOther(const TileWorkers::Outcome& /*outcome*/) {}
  /// Drops what is out of view; what is in view stays all the same.
  virtual void keepWithin(std::size_t budget);

  bool previews() const { return options_.previews; }
  std::uint64_t generation() const { return generation_; }  // of the content, from 1
  ViewTiles& tiles() { return tiles_; }
  const ViewTiles& tiles() const { return tiles_; }
  StandIns& standIns() { return stand_ins_; }
  const StandIns& standIns() const { return stand_ins_; }
  TileWorkers& workers() { return workers_; }

  /// Other content from now on. Work in progress goes on: its tile is better than none, and is made once
  /// more.
  void nextGeneration() { ++generation_; }
  void outdateAll();
  /// There is no content any more.
  void forgetAll();
  /// Something is to be started, or drawn anew: soon, once for all that changed until then.
  void changed();
  /// `exact`: what it makes is no preview. `colors`: the revision of the colours that it is painted in.
  TileWorkers::Ticket start(const TileKey& key, const ViewTile& tile, TileWorkers::Work work, bool exact,
                            std::uint64_t colors = 0);
  void cancelAll();
  void cancelExact();
  void cancel(ViewTile& tile);
  std::uint64_t taken() const { return taken_; }  // results
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct WorkInProgress {
    TileKey key;
    std::uint64_t raster = 0, generation = 0, colors = 0;
    bool exact = false;
  };

  void proceed();
  void receive(std::vector<TileWorkers::Outcome> outcomes);
  void dropStandInsWhenCovered();

  const Options options_;
  const std::size_t stand_ins_out_of_view_;
  const std::shared_ptr<TileBudget> budget_;
  std::size_t held_ = 0;  // of it
  ViewTiles tiles_;
  StandIns stand_ins_;
  bool active_ = true, announced_ = false, was_settled_ = true;
  std::uint64_t raster_ = 0, generation_ = 1, taken_ = 0, dropped_ = 0;
  std::unordered_map<TileWorkers::Ticket, WorkInProgress> in_progress_;
  TileWorkers workers_;  // last: it waits for its work when destroyed
};

/// Paints the window of a raster: ARGB32_Premultiplied or RGB32 of its size, null if it is empty. A pure
/// function, called on any thread; polls the flag, after which its result is ignored.
using TilePainter = std::function<QImage(const PixelGrid&, const std::atomic<bool>& cancelled)>;

/// Without previews there are no stand-ins.
class PaintedTiles : public RasterTiles {
  Q_OBJECT
 public:
  explicit PaintedTiles(Options options, QObject* parent = nullptr);

  /// Paints with this from now on; null = nothing.
  void setPainter(TilePainter painter);

 protected:
  bool hasContent() const override { return painter_ != nullptr; }
  void startMissing() override;

 private:
  std::shared_ptr<const TilePainter> painter_;
};

}  // namespace mapwright::render
