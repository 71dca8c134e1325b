// From AimDK answers to values. Pure functions, any thread. Source: docs/protocols/agibot-aimdk.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>
#include <tl/expected.hpp>

#include "map/catalogue.h"
#include "map/waypoint.h"

namespace mapwright::robot::aimdk {

/// What an answer (HTTP 200) says instead of what was asked for.
struct RpcError {
  bool refused = false;  // the robot says that the call failed; else it cannot be read
  std::string code;      // the robot's own; empty = none
  std::string detail;    // refused: its words, may be empty
  Fault cause;           // what is wrong with what came, in place of detail
};
template <typename T>
using Read = tl::expected<T, RpcError>;

/// GetStoredMapNames, in the robot's order of rows.
Read<std::vector<map::CatalogueEntry>> parseMapNames(std::string_view body);
/// GetCurrentWorkingMap: an id, empty when none is in use.
Read<std::string> parseCurrentMap(std::string_view body);
/// Get2DWholeMap.
struct ParsedMap {
  map::WholeMap map;
  /// How world metres become pixels, as the robot says: u = u0 + x * scale, v = v0 - y * scale.
  double pixels_per_m = 0, u0 = 0, v0 = 0;
};
Read<ParsedMap> parseWholeMap(std::string_view body, const map::MapKey& asked);
/// GetTopoMsgs. Without `frame` the pixels are not compared with the metres.
Read<map::WaypointList> parseTopology(std::string_view body, const ParsedMap* frame);

/// The requests. Ids are sent as text in one call and as a number in the other, digit by digit; a GetTopoMsgs
/// for an id that is no number has no request.
QByteArray mapNamesRequest();
QByteArray currentMapRequest();
QByteArray wholeMapRequest(std::string_view map_id);
std::optional<QByteArray> topologyRequest(std::string_view map_id);

}  // namespace mapwright::robot::aimdk
