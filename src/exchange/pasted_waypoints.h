// Waypoints as tables that people copy: out of a spreadsheet (tabs, or commas, or semicolons), with a header
// or without, with decimal points or commas. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exchange/wanted_waypoint.h"
#include "exchange/waypoint_steps.h"

namespace mapwright::exchange {

/// How a table is to be read.
struct TableShape {
  char separator = '\t';
  bool header = true;            // the first row names the columns
  bool decimal_comma = false;    // 1,5
  bool turns_in_degrees = true;  // unless the header says yaw_rad
  bool operator==(const TableShape&) const = default;
};
/// What it looks like.
TableShape shapeOf(std::string_view text);

/// Columns by their names (id, name, x, y, yaw_rad or heading, tags, type), in any order. Without a header: a
/// text is the name (two: id and name), the first two numbers side by side are the place, then a turn, then
/// tags; rows without a name are called by nameNameless(). The error is a sentence with its line.
WantedFile wantedFromTable(std::string_view text, const TableShape& shape);
/// Gives a name that no other has to those without id and name: `pattern` with %1 for a number.
void nameNameless(std::vector<WantedWaypoint>& wanted, const WaypointItems& kept, const QString& pattern);

/// With a header, between tabs, in the columns of waypointsCsv() without frame and map.
std::string waypointsTable(const std::vector<map::Waypoint>& points);

}  // namespace mapwright::exchange
