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
/// One line without line ending.
std::string csvLine(const std::vector<std::string>& fields, char separator = ',');
/// A finite number with a decimal point in any locale; nullopt = invalid.
std::optional<double> csvNumber(const std::string& field);
/// With enough digits to read the same value back.
std::string csvNumber(double value);

/// "a,b" as tags: a line of CSV itself, so that tags may contain commas. Empty = none.
tl::expected<std::vector<std::string>, QString> tagsOf(std::string_view text);

/// id,name,x,y,yaw_rad,tags,frame,map; also type if any has one. `map`: the id of their map.
std::string waypointsCsv(const std::vector<map::Waypoint>& points, const std::string& map);
/// Columns by name, in any order; id or name is required.
WantedFile wantedFromCsv(std::string_view bytes);
/// The same from parsed records; the first record is the header.
WantedFile wantedFromRecords(const std::vector<CsvRecord>& records);

}  // namespace mapwright::exchange
