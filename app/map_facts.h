// What `mapwright maps` shows about a map, besides its cells.
#pragma once

#include <optional>
#include <vector>

#include <QJsonArray>
#include <QString>
#include <QStringList>

#include "app/map_reading.h"

namespace mapwright::app {

/// "2026-11-22 10:00"; "-" = unknown. `epoch_s`: seconds since 1970.
QString dateText(std::optional<double> epoch_s);

/// [{"id","name","type","x","y","yaw"}], metres and radians.
QJsonArray pointsJson(const std::vector<map::Waypoint>& points);
/// The same as table rows; and the catalogue's data about a map.
void addPoints(std::vector<QStringList>& table, const std::vector<map::Waypoint>& points);
void addRow(std::vector<QStringList>& table, const map::CatalogueEntry& row);

/// Shows what is known of a map without a picture (session::lacksPicture()): its name, catalogue entry and
/// waypoints; "grid" is null in JSON. Reports the missing picture, and the result is incomplete.
CommandResult<int> showWithoutPicture(MapReading& reading, bool json);

}  // namespace mapwright::app
