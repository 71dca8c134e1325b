// Waypoints as JSON and GeoJSON, in the shape of `waypoints list --json` (docs/json.md). Pure
// functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "exchange/wanted_waypoint.h"
#include "map/waypoint.h"

namespace mapwright::exchange {

/// The frame in which its robot keeps it, if that says so; else "map".
std::string frameOf(const map::Waypoint& point);
/// {"id","name","x","y","yaw_rad","tags","frame","map"}; also "type" if it has one. `map`: the id of its map.
QJsonObject waypointJson(const map::Waypoint& point, const std::string& map);
QJsonArray waypointsJson(const std::vector<map::Waypoint>& points, const std::string& map);
/// The reverse. The error is a sentence without the location.
tl::expected<WantedWaypoint, QString> wantedFromJson(const QJsonObject& row);
/// Missing members become empty, except `position_m`, which is required.
tl::expected<map::Waypoint, QString> waypointFromJson(const QJsonObject& row);

/// A FeatureCollection of Points in metres of the map, not in degrees; properties as above.
QByteArray waypointsGeoJson(const std::vector<map::Waypoint>& points, const std::string& map);
/// The coordinates count, not the properties x and y; features other than Points are left out, with a note
/// each. Longitude and latitude are refused; a note says where a file does not tell that it is in metres. Of
/// a route graph of Nav2 the nodes are read.
WantedFile wantedFromGeoJson(std::string_view bytes, AngleUnit angles = AngleUnit::Guess);
WantedFile wantedFromGeoJson(const QJsonObject& collection, AngleUnit angles);
/// The error is a sentence with the position.
tl::expected<QJsonDocument, QString> jsonOf(std::string_view bytes);

}  // namespace mapwright::exchange
