// What `mapwright maps` tells of one map, besides its cells.
#pragma once

#include <optional>
#include <vector>

#include <QJsonArray>
#include <QString>
#include <QStringList>

#include "app/map_reading.h"

namespace mapwright::app {

/// "2026-11-22 10:00"; "-" = it is not known. `epoch_s`: seconds since 1970.
QString dateText(std::optional<double> epoch_s);

/// [{"id","name","type","x","y","yaw"}], metres and radians.
QJsonArray pointsJson(const std::vector<map::Waypoint>& points);
/// Rows for people: the same; and what the list of maps says of one.
void addPoints(std::vector<QStringList>& table, const std::vector<map::Waypoint>& points);
void addRow(std::vector<QStringList>& table, const map::CatalogueEntry& row);

/// What there is of the map that `reading` has opened and that the robot sends no picture of
/// (session::lacksPicture()): its name, its row and its waypoints; in JSON "grid" is null. That the
/// picture is missing is said, and the command is not complete.
CommandResult<int> showWithoutPicture(MapReading& reading, bool json);

}  // namespace mapwright::app
