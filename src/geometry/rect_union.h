// The rectangle around many rectangles that come, move and go.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/rect.h"

namespace mapwright::geometry {

/// Rectangles by number. A change costs the depth of a tree, asking costs nothing, however many there are.
class RectUnion {
 public:
  /// An empty rectangle takes number `at` out. Numbers should be dense: room is kept up to the highest.
  void set(std::size_t at, const WorldRect& rect);
  void clear() { levels_.clear(); }
  WorldRect bounds() const { return levels_.empty() ? WorldRect{} : levels_.back().front(); }

 private:
  static constexpr std::size_t kFan = 16;
  std::vector<std::vector<WorldRect>> levels_;  // the rectangles, then what kFan of them come to, up to one
};

}  // namespace mapwright::geometry
