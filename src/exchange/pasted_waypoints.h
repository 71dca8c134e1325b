// Waypoints as tables pasted from a spreadsheet (tabs, commas or semicolons), with or without a header, with
// decimal points or commas. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exchange/wanted_waypoint.h"
#include "exchange/waypoint_steps.h"

namespace mapwright::exchange {

/// How to read a table.
struct TableShape {
  char separator = '\t';
  bool header = true;            // the first row contains the column names
  bool decimal_comma = false;    // 1,5
  bool turns_in_degrees = true;  // unless the header says yaw_rad
  bool operator==(const TableShape&) const = default;
};
/// What it looks like.
TableShape shapeOf(std::string_view text);

/// Columns by name (id, name, x, y, yaw_rad or heading, tags, type), in any order. Without a header: a text
/// is the name (two: id and name), the first two adjacent numbers are the position, then a heading, then
/// tags; nameNameless() names rows without a name. The error is a sentence with the line.
WantedFile wantedFromTable(std::string_view text, const TableShape& shape);
/// Gives a unique name to those without id and name: `pattern` with %1 for a number.
void nameNameless(std::vector<WantedWaypoint>& wanted, const WaypointItems& kept, const QString& pattern);

/// With a header, tab-separated, in the columns of waypointsCsv() without frame and map.
std::string waypointsTable(const std::vector<map::Waypoint>& points);

}  // namespace mapwright::exchange
