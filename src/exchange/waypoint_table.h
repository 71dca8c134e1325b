// Waypoints as tables: CSV (RFC 4180: fields in quotes, quotes doubled, CRLF or LF; UTF-8 with or without its
// mark) and what is pasted from a spreadsheet: tabs, commas or semicolons, with or without a header, with
// decimal points or commas. Written with a header, commas and decimal points. Pure functions.
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
/// A table as a file: of the shape that it looks like, its rows as long as its header.
WantedFile wantedFromCsv(std::string_view bytes, AngleUnit angles = AngleUnit::Guess);

/// How to read a table.
struct TableShape {
  char separator = '\t';
  bool header = true;          // the first row contains the column names
  bool decimal_comma = false;  // 1,5
  AngleUnit angles = AngleUnit::Guess;
  bool ragged = true;  // rows may lack their last cells, as spreadsheets copy them
};
/// What it looks like.
TableShape shapeOf(std::string_view text);

/// Columns by name (waypoint_reading.h), in any order. Without a header: a text is the name (two: id and
/// name), the first two adjacent numbers are the position, then a heading or (z and) a quaternion, then tags;
/// a note says so. The error is a sentence with the line.
WantedFile wantedFromTable(std::string_view text, const TableShape& shape);

/// Those without id and name that lie where one of `kept` is, turned alike, are that one: the same file twice
/// changes nothing.
void knowByPlace(std::vector<WantedWaypoint>& wanted, const WaypointItems& kept);
/// "Waypoint 7". It is stored, so it is the same whatever language is spoken.
inline std::string madeUpName(std::size_t number) { return "Waypoint " + std::to_string(number); }
/// Gives a made-up name of its own to each that has none. Returns a sentence that says so; empty = all have
/// one.
QString nameNameless(std::vector<WantedWaypoint>& wanted, const WaypointItems& kept);

/// With a header, tab-separated, in the columns of waypointsCsv() without frame and map.
std::string waypointsTable(const std::vector<map::Waypoint>& points);

}  // namespace mapwright::exchange
