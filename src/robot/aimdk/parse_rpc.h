// Parses AimDK answers. Pure functions, any thread. Source: docs/protocols/agibot-aimdk.md.
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

/// What an answer (HTTP 200) contains instead of the result.
struct RpcError {
  bool refused = false;  // the robot reports a failure; otherwise the answer is unreadable
  std::string code;      // the robot's own; empty = none
  std::string detail;    // refused: its text, may be empty
  Fault cause;           // what is wrong with the answer, instead of detail
};
template <typename T>
using Read = tl::expected<T, RpcError>;

/// GetStoredMapNames, in the robot's order.
Read<std::vector<map::CatalogueEntry>> parseMapNames(std::string_view body);
/// GetCurrentWorkingMap: an id, empty if none is in use.
Read<std::string> parseCurrentMap(std::string_view body);
/// Get2DWholeMap.
struct ParsedMap {
  map::WholeMap map;
  /// From world metres to pixels, according to the robot: u = u0 + x * scale, v = v0 - y * scale.
  double pixels_per_m = 0, u0 = 0, v0 = 0;
};
Read<ParsedMap> parseWholeMap(std::string_view body, const map::MapKey& asked);
/// GetTopoMsgs. Without `frame` pixels are not compared with metres.
Read<map::WaypointList> parseTopology(std::string_view body, const ParsedMap* frame);

/// The requests. One call takes ids as text, the other as a number, digit by digit; GetTopoMsgs is impossible
/// for an id that is not a number.
QByteArray mapNamesRequest();
QByteArray currentMapRequest();
QByteArray wholeMapRequest(std::string_view map_id);
std::optional<QByteArray> topologyRequest(std::string_view map_id);

}  // namespace mapwright::robot::aimdk
