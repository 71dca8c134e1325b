// The tiles of one layer for the current view: where they lie, what stands in for them, what memory they take
// and what is under way. What they show is a subclass's.
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include <QObject>
#include <QRegion>

#include "geometry/view_transform.h"
#include "render/stand_ins.h"
#include "render/tile_renderer.h"
#include "render/tile_workers.h"
#include "render/view_tiles.h"

namespace mapwright::render {

/// What several layers may keep together, bytes. GUI thread.
struct TileBudget {
  std::size_t bytes = work::budgetsFrom().grid_tiles;
  std::size_t held = 0;  // by those that have it
};

/// GUI-thread object; makes pictures on the crew, like TileRenderer: tiles lie in the grid of the view and
/// are drawn at integer offsets; a picture of another view or of older content stands in until the new one is
/// there.
class RasterTiles : public QObject {
  Q_OBJECT
 public:
  struct Options {
    std::shared_ptr<TileBudget> budget = {};      // null = one of its own
    std::shared_ptr<work::Workers> workers = {};  // null = a crew of its own
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

  bool previews() const { return options_.previews; }
  std::uint64_t generation() const { return generation_; }  // of the content, from 1
  ViewTiles& tiles() { return tiles_; }
  const ViewTiles& tiles() const { return tiles_; }
  StandIns& standIns() { return stand_ins_; }
  const TileWorkers& workers() const { return workers_; }

  /// Other content from now on. Work under way goes on: its tile is better than none, and is made once more.
  void nextGeneration() { ++generation_; }
  void outdateAll();
  /// There is no content any more.
  void forgetAll();
  /// Something is to be started, or drawn anew: soon, once for all that changed until then.
  void changed();
  /// `exact`: what it makes is no preview. `colors`: the revision of the colours that it is painted in.
  TileWorkers::Ticket start(const TilePlace& place, const ViewTile& tile, TileWorkers::Work work, bool exact,
                            std::uint64_t colors = 0);
  void cancelAll();
  void cancelExact();

 private:
  struct UnderWay {
    TilePlace place;
    std::uint64_t raster = 0, generation = 0, colors = 0;
    bool exact = false;
  };

  void proceed();
  void keepWithin(std::size_t budget);
  void receive(std::vector<TileWorkers::Outcome> outcomes);
  void dropStandInsWhenCovered();

  const Options options_;
  const std::size_t stand_ins_out_of_view_;
  const std::shared_ptr<TileBudget> budget_;
  std::size_t held_ = 0;  // of it
  ViewTiles tiles_;
  StandIns stand_ins_;
  bool active_ = true, announced_ = false, was_settled_ = true;
  std::uint64_t raster_ = 0, generation_ = 1;
  std::unordered_map<TileWorkers::Ticket, UnderWay> under_way_;
  TileWorkers workers_;  // last: it waits for its work when destroyed
};

}  // namespace mapwright::render
