// The bounding rectangle of many rectangles that change.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/rect.h"

namespace mapwright::geometry {

/// Rectangles by index. A change costs the depth of a tree, reading the bounds costs nothing.
class RectUnion {
 public:
  /// An empty rectangle removes entry `at`. Indices should be dense: memory is used up to the highest.
  void set(std::size_t at, const WorldRect& rect);
  void clear() { levels_.clear(); }
  WorldRect bounds() const { return levels_.empty() ? WorldRect{} : levels_.back().front(); }

 private:
  static constexpr std::size_t kFan = 16;
  std::vector<std::vector<WorldRect>> levels_;  // the rectangles, then the bounds of kFan of them, up to one
};

}  // namespace mapwright::geometry
