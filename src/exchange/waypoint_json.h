// Waypoints as JSON and GeoJSON, in the shape of `waypoints list --json` (docs/command-line.md). Pure
// functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

#include "exchange/wanted_waypoint.h"
#include "map/waypoint.h"

namespace mapwright::exchange {

/// {"id","name","x","y","yaw_rad","tags","frame","map"}; also "type" where it has one. `map`: the id of its.
QJsonObject waypointJson(const map::Waypoint& point, const std::string& map);
QJsonArray waypointsJson(const std::vector<map::Waypoint>& points, const std::string& map);
/// The reverse. The error is a sentence without its place.
tl::expected<WantedWaypoint, QString> wantedFromJson(const QJsonObject& row);
/// With everything that it does not say empty, except for `position_m`, which must be there.
tl::expected<map::Waypoint, QString> waypointFromJson(const QJsonObject& row);

/// A FeatureCollection of Points in metres of the map, not in degrees; properties as above.
QByteArray waypointsGeoJson(const std::vector<map::Waypoint>& points, const std::string& map);
/// Of a place it is the coordinates that count, not the properties x and y. What is no Point is left out,
/// with a note.
WantedFile wantedFromGeoJson(std::string_view bytes);

}  // namespace mapwright::exchange
