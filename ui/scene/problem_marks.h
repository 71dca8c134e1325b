// Submaps that have a place on the map but no picture, found by their place.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <QString>

#include "geometry/rect.h"
#include "map/grid_reference.h"
#include "map/submap.h"

namespace mapwright::ui::scene {

enum class MarkKind { Missing, Failed, Corrupt, NoSlice, Unreadable };

/// What is missing at a point of the map, for those who ask there. Plain text.
struct ProblemMark {
  QString title;               // "Submap 12-3"
  QString reason;              // a sentence
  Eigen::Vector2d at_m{0, 0};  // the middle of the mark
  MarkKind kind = MarkKind::Unreadable;
  std::optional<map::SubmapId> submap = {};  // nullopt: an overlay, or a map
  bool operator==(const ProblemMark&) const = default;
};

struct PlacedMark {
  MarkKind kind = MarkKind::Missing;
  Eigen::Vector2d at_m{0, 0};
  std::optional<std::array<Eigen::Vector2d, 4>> corners = {};  // nullopt: its size is not known
  bool operator==(const PlacedMark&) const = default;
  geometry::WorldRect bounds() const;
};

/// A map that could not be loaded, or not completely.
struct MapTrouble {
  std::array<Eigen::Vector2d, 4> corners;  // all the same where its size is not known
  bool nothing_shown = true;               // nothing of it could be read
  QString title, reason;
  bool operator==(const MapTrouble&) const = default;
};
std::array<Eigen::Vector2d, 4> gridCorners(const map::GridReference& grid);

/// A hundred thousand of them cost no more than those in view.
class SubmapMarks {
 public:
  using Entry = std::pair<map::SubmapId, PlacedMark>;

  SubmapMarks();
  ~SubmapMarks();

  /// Adds or changes. False: it is there, just like that.
  bool put(map::SubmapId id, const PlacedMark& mark);
  /// False: there was none.
  bool remove(map::SubmapId id);
  void clear();
  std::size_t size() const;

  /// Those that touch the area, ascending; nullopt: more than `most` do.
  std::optional<std::vector<Entry>> within(const geometry::WorldRect& area, std::size_t most) const;
  bool any(const geometry::WorldRect& area) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace mapwright::ui::scene
