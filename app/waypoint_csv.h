// Waypoints as CSV: RFC 4180 (fields in quotes, quotes doubled, CRLF or LF), a header, decimal points, UTF-8
// with or without its mark. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/wanted_waypoint.h"
#include "map/waypoint.h"

namespace mapwright::app {

struct CsvRecord {
  int line = 0;  // where it begins, counted from 1
  std::vector<std::string> fields;
};
/// Empty lines are left out. The error is a sentence.
tl::expected<std::vector<CsvRecord>, QString> csvRecords(std::string_view text);
/// One line without its end.
std::string csvLine(const std::vector<std::string>& fields);

/// "a,b" as tags: they are a line of CSV themselves, so that they may hold commas. Empty = none.
tl::expected<std::vector<std::string>, QString> tagsOf(std::string_view text);

/// id,name,x,y,yaw_rad,tags,frame,map; also type where any has one. `map`: the id of theirs.
std::string waypointsCsv(const std::vector<map::Waypoint>& points, const std::string& map);
/// Columns by their names, in any order; id or name must be among them.
WantedFile wantedFromCsv(std::string_view bytes);

}  // namespace mapwright::app
