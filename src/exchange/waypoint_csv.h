// Waypoints as CSV: RFC 4180 (fields in quotes, quotes doubled, CRLF or LF), a header, decimal points, UTF-8
// with or without its mark. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/wanted_waypoint.h"
#include "map/waypoint.h"

namespace mapwright::exchange {

struct CsvRecord {
  int line = 0;  // where it begins, counted from 1
  std::vector<std::string> fields;
};
/// Empty lines are left out. The error is a sentence. Between tabs a quote in the middle of a field is a
/// letter: that is how spreadsheets copy.
tl::expected<std::vector<CsvRecord>, QString> csvRecords(std::string_view text, char separator = ',');
/// One line without its end.
std::string csvLine(const std::vector<std::string>& fields, char separator = ',');
/// A finite number with a decimal point, whatever the locale; nullopt = it is none.
std::optional<double> csvNumber(const std::string& field);
/// With every digit that it takes to read it back.
std::string csvNumber(double value);

/// "a,b" as tags: they are a line of CSV themselves, so that they may hold commas. Empty = none.
tl::expected<std::vector<std::string>, QString> tagsOf(std::string_view text);

/// id,name,x,y,yaw_rad,tags,frame,map; also type where any has one. `map`: the id of theirs.
std::string waypointsCsv(const std::vector<map::Waypoint>& points, const std::string& map);
/// Columns by their names, in any order; id or name must be among them.
WantedFile wantedFromCsv(std::string_view bytes);
/// The same of what has been read already; the first record is the header.
WantedFile wantedFromRecords(const std::vector<CsvRecord>& records);

}  // namespace mapwright::exchange
