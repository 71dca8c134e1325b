// Files of waypoints of any format that is known. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <QString>

#include "exchange/wanted_waypoint.h"

namespace mapwright::exchange {

enum class WaypointFormat {
  Table,  // CSV, and what spreadsheets write
  Json,   // GeoJSON, or a list of poses
  Yaml,   // lists of poses
};
/// "csv", "geojson", "yaml", "yml", …, as file names end or options are called, in lower case.
std::optional<WaypointFormat> waypointFormatCalled(const QString& word);
/// What it looks like: of a file without a name.
WaypointFormat waypointFormatOf(std::string_view bytes);

WantedFile wantedFromFile(std::string_view bytes, WaypointFormat format, AngleUnit angles);

}  // namespace mapwright::exchange
