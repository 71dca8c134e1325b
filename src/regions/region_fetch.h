// One rectangle of a robot's map, fetched once, as a map of its own.
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "regions/region_map.h"

namespace mapwright::regions {

/// What a rectangle came to. What was not fetched, and what lies beyond the map, is unknown.
struct FetchedGrid {
  std::shared_ptr<const grids::GridPyramid> cells;  // null: no cell came; shares them with the sheet
  map::GridReference reference;
  int other_lattices = 0;  // pieces on so many other lattices of cells are left out
};
/// Which cells belong to a rectangle: for a map of its own those whose middles lie in it, for a picture all
/// that reach into it.
enum class CutEdge { Middles, Touched };
/// Cuts `rect` out of what came: of the sheet that has the most of it, turned as that is, and as it is now.
/// Quick for large ones, too: tiles are made when they are looked at.
FetchedGrid cutOut(const std::vector<std::shared_ptr<RegionSheet>>& sheets, const geometry::WorldRect& rect,
                   CutEdge edge = CutEdge::Middles);

/// What is wrong with a whole map that came at once: Unusable, FewerCells or None.
Misfit flawOf(const map::GridPart& part);

/// The same cells as a picture (PGM) that is read back with kPgmReading: what is above 100 is unknown there.
/// `part` has as many cells as it says, one at least.
std::string pgmOf(const map::GridPart& part);
std::string pgmOf(const grids::GridPyramid& cells);
inline constexpr map::CellReading kPgmReading{map::CellReading::Mode::Raw};

/// Asks region by region until all of the rectangle is there, or has failed some times. On the thread of the
/// dispatcher.
class RegionFetch : public QObject {
  Q_OBJECT
 public:
  struct Options {
    int tries = 3;                // of a region, before it counts as failed
    int most_regions = 256;       // a larger rectangle is refused
    Millis retry_after{1'000};    // doubling
    Millis offer_within{10'000};  // a dispatcher that has gone, before nothing more is waited for
    std::function<Millis()> monotonic = {};
  };
  /// `rect`: finite, of some size.
  RegionFetch(robot::MapDispatch& dispatch, const geometry::WorldRect& rect, Options options,
              QObject* parent = nullptr);

  /// `progressed()` and `finished()` come later, never from within.
  void start();
  bool over() const { return over_; }
  /// It is over, and nothing was asked for but the size of a cell: the rectangle has too many of them.
  bool tooLarge() const { return map_.regions().plan().tooFar(); }
  /// It is over, and every region has its answer.
  bool complete() const;
  const geometry::WorldRect& rect() const { return rect_; }
  RegionMap& map() { return map_; }
  const RegionMap& map() const { return map_; }
  RegionCounts counts() const { return map_.regions().counts(); }
  /// The trouble of the first region that has some; Kind::None = none has.
  RegionTrouble trouble() const;

 Q_SIGNALS:
  void progressed();
  void finished();

 private:
  void note();
  void end();

  geometry::WorldRect rect_;
  int tries_;
  RegionMap map_;
  QTimer without_offer_;
  bool started_ = false, over_ = false;
};

}  // namespace mapwright::regions
