// Distributes the width of the submap tree over its columns. Pure.
#pragma once

namespace mapwright::window {

/// Widths in pixels. `name` and `total` are never truncated: `total` ("244 of 300") is shown on a group's row
/// across the two columns after the name.
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

/// If there is not enough room, the badges are reduced first, then the status; if that is not enough the tree
/// scrolls beyond `available`. Extra room goes to the name.
ColumnWidths shareColumns(int available, const ColumnNeeds& needs);

}  // namespace mapwright::window
