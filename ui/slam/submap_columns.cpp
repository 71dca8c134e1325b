#include "ui/slam/submap_columns.h"

#include <algorithm>

namespace mapwright::window {

ColumnWidths shareColumns(int available, const ColumnNeeds& needs) {
  const int status_wanted = std::max(needs.status_wanted, needs.status_least);
  const int badges_wanted = std::max(needs.badges_wanted, needs.badges_least);
  const int room = std::max(available - needs.name - needs.locate, needs.total);
  ColumnWidths widths;
  widths.locate = needs.locate;
  widths.badges = std::clamp(room - status_wanted, needs.badges_least, badges_wanted);
  widths.status = std::clamp(room - widths.badges, needs.status_least, status_wanted);
  // A total may be wider than both: rather empty space than a truncated number.
  widths.status = std::max(widths.status, needs.total - widths.badges);
  widths.name = std::max(needs.name, available - widths.badges - widths.status - widths.locate);
  return widths;
}

}  // namespace mapwright::window
