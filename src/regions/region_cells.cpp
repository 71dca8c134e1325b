#include "regions/region_cells.h"

#include <algorithm>
#include <cmath>

#include "regions/region_sheet.h"

namespace mapwright::regions {

Misfit RegionCells::misfitOf(const map::GridPart& part) const {
  const map::GridReference& grid = part.grid;
  if (grid.width < 0 || grid.height < 0 || map::unusableReason(grid) || !std::isfinite(grid.origin.yaw_rad))
    return Misfit::Unusable;
  const std::int64_t count = std::int64_t(grid.width) * grid.height;
  if (count > kMostOfPiece || std::max(grid.width, grid.height) > grids::kMaxGridEdge / 4)
    return Misfit::TooLarge;
  if (!part.cells || std::int64_t(part.cells->size()) < count) return Misfit::FewerCells;
  if (!part.frame.empty() && !frame_.empty() && part.frame != frame_) return Misfit::OtherFrame;
  if (map::unusableReason(RegionSheet(grid).reference())) return Misfit::Unusable;
  return Misfit::None;
}

bool RegionCells::put(const map::GridPart& part) {
  if (misfitOf(part) != Misfit::None) return false;
  if (part.grid.width == 0 || part.grid.height == 0) return true;
  if (frame_.empty()) frame_ = part.frame;
  auto found = std::find_if(sheets_.begin(), sheets_.end(),
                            [&](const auto& sheet) { return sheet->holds(part.grid); });
  auto sheet = found == sheets_.end() ? std::make_shared<RegionSheet>(part.grid) : *found;
  // Its own sheet is overwritten; the others must not show anything there any more.
  if (found != sheets_.end()) sheets_.erase(found);
  for (const auto& other : sheets_) other->forgetUnder(part.grid);
  std::erase_if(sheets_, [](const auto& other) { return other->empty(); });
  if (sheets_.size() >= kMostSheets) sheets_.erase(sheets_.begin());
  sheet->put(part.grid, *part.cells);
  sheets_.push_back(std::move(sheet));
  reach_.extend(part.grid.bounds());
  return true;
}

bool RegionCells::forget(const geometry::WorldRect& rect) {
  bool any = false;
  for (const auto& sheet : sheets_) any = sheet->forget(rect) || any;
  std::erase_if(sheets_, [](const auto& sheet) { return sheet->empty(); });
  return any;
}

std::size_t RegionCells::bytes() const {
  std::size_t bytes = 0;
  for (const auto& sheet : sheets_) bytes += sheet->bytes();
  return bytes;
}

}  // namespace mapwright::regions
