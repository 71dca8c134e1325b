// Fetches one rectangle of a robot's map as a map of its own.
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "regions/region_map.h"

namespace mapwright::grids {
class GridPyramid;
}

namespace mapwright::regions {

/// The result for a rectangle. Missing parts, and those beyond the map, are unknown.
struct FetchedGrid {
  std::shared_ptr<const grids::GridPyramid> cells;  // null: no cells arrived; shares them with the sheet
  map::GridReference reference;
  int other_lattices = 0;  // pieces on this many other cell lattices are left out
};
/// Which cells belong to a rectangle: for a map those whose centres are in it, for a picture all that overlap
/// it.
enum class CutEdge { Middles, Touched };
/// Cuts `rect` out of the received cells: from the sheet that covers most of it, with its rotation, and in
/// its present state. Fast even if large: tiles are created on demand.
FetchedGrid cutOut(const std::vector<std::shared_ptr<RegionSheet>>& sheets, const geometry::WorldRect& rect,
                   CutEdge edge = CutEdge::Middles);

/// What is wrong with a whole map received in one answer: Unusable, FewerCells or None.
Misfit flawOf(const map::GridPart& part);

/// The cells of level 0 as a whole map has them.
map::OccupancyCells cellsOf(const grids::GridPyramid& grid);

/// Fetches a rectangle region by region until it is complete, or has failed several times. Lives on the
/// dispatcher's thread.
class RegionFetch : public QObject {
  Q_OBJECT
 public:
  struct Options {
    int tries = 3;                // for each region, before it counts as failed
    int most_regions = 256;       // larger rectangles are refused
    Millis retry_after{1'000};    // doubling
    Millis offer_within{10'000};  // how long to wait for a dispatcher that has disappeared
    std::function<Millis()> monotonic = {};
  };
  /// `rect` must be finite and not empty.
  RegionFetch(robot::MapDispatch& dispatch, const geometry::WorldRect& rect, Options options,
              QObject* parent = nullptr);

  /// `progressed()` and `finished()` are emitted later, never from within.
  void start();
  bool over() const { return over_; }
  /// Finished without any request except for the cell size: the rectangle has too many cells.
  bool tooLarge() const { return map_.regions().plan().tooFar(); }
  /// Finished, and every region has its answer.
  bool complete() const;
  const geometry::WorldRect& rect() const { return rect_; }
  RegionMap& map() { return map_; }
  const RegionMap& map() const { return map_; }
  RegionCounts counts() const { return map_.regions().counts(); }
  /// The problem of the first region that has one; Kind::None = none.
  RegionTrouble trouble() const;

 Q_SIGNALS:
  void progressed();
  void finished();

 private:
  void onChanged();
  void end();

  geometry::WorldRect rect_;
  int tries_;
  RegionMap map_;
  QTimer without_offer_;
  bool started_ = false, over_ = false;
};

}  // namespace mapwright::regions
