// Parses AimDK answers. Pure functions, any thread. Source: docs/protocols/agibot-aimdk.md.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
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

/// GetStoredMapNames, in the robot's order. `left_out`: how many rows have no id.
Read<std::vector<map::CatalogueEntry>> parseMapNames(std::string_view body, std::int64_t* left_out = nullptr);
/// GetCurrentWorkingMap: an id, empty if none is in use.
Read<std::string> parseCurrentMap(std::string_view body);
/// Get2DWholeMap, placed as its `resolution` is read: pixels per metre until place() says otherwise.
struct ParsedMap {
  map::WholeMap map;
  double resolution = 0;  // as the robot says
  /// From world metres to pixels: u = u0 + x * scale, v = v0 - y * scale.
  double pixels_per_m = 0, u0 = 0, v0 = 0;
};
Read<ParsedMap> parseWholeMap(std::string_view body, const map::MapKey& asked);
/// What the points of a map say of its `resolution`, which some read as pixels per metre, others as
/// centimetres per pixel.
struct Scale {
  double pixels_per_m = 0;
  bool certain = false;  // the points fit it, and no other reading
  Fault note = {};       // what is to be said of it; none = it is as the maker says
};
/// Nothing tells: as the maker says.
Scale untoldScale(const ParsedMap& map);
void place(ParsedMap& map, const Scale& scale);
/// GetTopoMsgs. Points without metres are placed by their pixels. Without `frame` pixels tell nothing, and
/// the scale is untold.
struct Topology {
  map::WaypointList list;  // each with its source
  bool degrees = false;    // the unit of their angles; otherwise radians
  Scale scale = {};
  std::set<std::string> two_places = {};  // ids of points whose pixels are not where their metres are
};
Read<Topology> parseTopology(std::string_view body, const ParsedMap* frame);

// The newer services (docs/protocols/agibot-aimdk.md, "Newer services").

/// Whether an answer, of any status, can come from firmware that has the service.
bool knowsService(int status, std::string_view body);
/// GetRealtimeMapData: whether it is mapping.
Read<bool> parseRealtimeMap(std::string_view body);
/// A change that was accepted, or why not.
Read<void> parseAcceptance(std::string_view body);
/// SetNaviPoint: the id of a point that was created; empty if the robot does not send it.
std::string createdPoint(std::string_view body);

/// The requests. One call takes ids as text, the other as a number, digit by digit, if they are numbers.
QByteArray mapNamesRequest();
QByteArray currentMapRequest();
QByteArray wholeMapRequest(std::string_view map_id);
QByteArray topologyRequest(std::string_view map_id);
QByteArray realtimeMapRequest();
/// A change of maps: a command with texts.
QByteArray changeRequest(const char* command,
                         const std::vector<std::pair<const char*, std::string>>& texts = {});
inline constexpr const char* kUsualPointType = "NaviPointType_NAVI_POINT";
/// SetNaviPoint: `point` as it is to be, on that pixel (nullopt: the one that its source says).
struct PixelPose {
  std::int64_t u = 0, v = 0;
  std::optional<double> angle = {};  // nullopt: as it was
};
QByteArray pointRequest(std::string_view map_id, const map::Waypoint& point,
                        const std::optional<PixelPose>& pose);

}  // namespace mapwright::robot::aimdk
