#include "geometry/rect_union.h"

namespace mapwright::geometry {

void RectUnion::set(std::size_t at, const WorldRect& rect) {
  if (levels_.empty() || at >= levels_.front().size()) {
    if (rect.empty()) return;
    if (levels_.empty()) levels_.emplace_back();
    std::size_t size = at + 1;
    for (std::size_t level = 0;; ++level) {
      if (level == levels_.size()) {
        // The former single top level gets siblings.
        levels_.emplace_back();
        WorldRect all;
        for (const WorldRect& part : levels_[level - 1]) all.extend(part);
        levels_.back().push_back(all);
      }
      if (levels_[level].size() < size) levels_[level].resize(size);
      if (size == 1) break;
      size = (size + kFan - 1) / kFan;
    }
  }
  levels_.front()[at] = rect;
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    at /= kFan;
    const std::vector<WorldRect>& parts = levels_[level - 1];
    WorldRect all;
    for (std::size_t part = at * kFan; part < parts.size() && part < (at + 1) * kFan; ++part)
      all.extend(parts[part]);
    levels_[level][at] = all;
  }
}

}  // namespace mapwright::geometry
