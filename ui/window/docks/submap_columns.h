// How the columns of the tree of submaps share its width. Pure.
#pragma once

namespace mapwright::window {

/// Widths in pixels. `name` and `total` are never cut: `total` ("244 of 300") stands on a group's row across
/// the two columns after the name.
struct ColumnNeeds {
  int name = 0, total = 0, locate = 0;
  int badges_wanted = 0, badges_least = 0;
  int status_wanted = 0, status_least = 0;
};

struct ColumnWidths {
  int name = 0, badges = 0, status = 0, locate = 0;
  int sum() const { return name + badges + status + locate; }
  bool operator==(const ColumnWidths&) const = default;
};

/// Where there is not room for all, the badges give way first, then the words of the status; what they may
/// not give up goes beyond `available`, and the tree can be scrolled. Room to spare goes to the name.
ColumnWidths shareColumns(int available, const ColumnNeeds& needs);

}  // namespace mapwright::window
