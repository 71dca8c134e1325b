// Waypoints as tables: CSV (RFC 4180: fields in quotes, quotes doubled, CRLF or LF; a header, decimal points,
// UTF-8 with or without its mark), and what is pasted from a spreadsheet (tabs, commas or semicolons, with or
// without a header, with decimal points or commas). Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exchange/wanted_waypoint.h"
#include "exchange/waypoint_steps.h"
#include "map/waypoint.h"

namespace mapwright::exchange {

struct CsvRecord {
  int line = 0;  // where it begins, counted from 1
  std::vector<std::string> fields;
};
/// Empty lines are left out. The error is a sentence. Between tabs a quote in the middle of a field is a
/// letter: that is how spreadsheets copy.
tl::expected<std::vector<CsvRecord>, QString> csvRecords(std::string_view text, char separator = ',');
/// One line without line ending.
std::string csvLine(const std::vector<std::string>& fields, char separator = ',');

/// "a,b" as tags: a line of CSV itself, so that tags may contain commas. Empty = none.
tl::expected<std::vector<std::string>, QString> tagsOf(std::string_view text);

/// id,name,x,y,yaw_rad,tags,frame,map; also type if any has one. `map`: the id of their map.
std::string waypointsCsv(const std::vector<map::Waypoint>& points, const std::string& map);
/// Columns by name, in any order; id or name is required.
WantedFile wantedFromCsv(std::string_view bytes);

/// How to read a table.
struct TableShape {
  char separator = '\t';
  bool header = true;            // the first row contains the column names
  bool decimal_comma = false;    // 1,5
  bool turns_in_degrees = true;  // unless the header says yaw_rad
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
