#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "simulator/axbot_routes.h"

namespace mapwright::simulator {
namespace {

constexpr std::string_view kPrefix = "/rpc/aimdk.protocol.";
constexpr double kDegreesOfTurn = 180 / std::numbers::pi;
constexpr int kNavigationPoints = 9;
constexpr int kMisplacedPoint = 4;  // whose pixel_pose does not fit its pose
constexpr double kMisplacedPixels = 6;

struct AimdkMap {
  std::string_view id;  // 13 digits
  std::string_view name;
  int index;
  int trajectory;
  double resolution_m;
  double rotate_deg;
  bool data_url;   // map_data begins with "data:image/png;base64,"
  int wrong_size;  // what the declared width and height are off by
};
constexpr std::array<AimdkMap, 3> kMaps{{{"1764137567113", "River Park", 5, 3, 0.05, 0, true, 0},
                                         {"1764059676131", "Park", 3, 0, 0.05, -5.512457272434708, false, 0},
                                         {"1762584133656", "e2-8 <b>大厅</b> 🏭", 2, 2, 0.1, 90, false, 2}}};
constexpr std::string_view kCurrent = "1764059676131";

Value error(int code, std::string_view message) {
  return Value::Object{{"error", Value::Object{{"code", code}, {"message", message}}}};
}

Value data(Value::Object members) { return Value::Object{{"data", std::move(members)}}; }

/// The pixel of the world's origin, and pixels per metre.
struct PixelFrame {
  double origin_u = 0, origin_v = 0, per_metre = 20;
};

PixelFrame frameOf(const MapPicture& picture) {
  PixelFrame frame;
  frame.per_metre = std::round(1 / picture.resolution_m);
  frame.origin_u = std::round(-picture.origin_m.x() * frame.per_metre);
  frame.origin_v = std::round(picture.height + picture.origin_m.y() * frame.per_metre);
  return frame;
}

PictureSpec specOf(const AimdkMap& map) {
  PictureSpec spec;
  spec.trajectory = map.trajectory;
  spec.resolution_m = map.resolution_m;
  return spec;
}

Value navigationPoint(int number, const geometry::Pose2& pose, const PixelFrame& frame) {
  constexpr std::array<std::string_view, 3> kTypes{"NaviPointType_NAVI_POINT", "NaviPointType_CHARGE_POINT",
                                                   "NaviPointType_ELEVATOR_POINT"};
  const double off = number == kMisplacedPoint ? kMisplacedPixels : 0;
  const double x = std::round(pose.x_m * 1000) / 1000, y = std::round(pose.y_m * 1000) / 1000;
  const Value pixel = Value::Object{{"u", std::round(frame.origin_u + x * frame.per_metre + off)},
                                    {"v", std::round(frame.origin_v - y * frame.per_metre)}};
  const double degrees = std::round(pose.yaw_rad * kDegreesOfTurn * 10) / 10;
  return Value::Object{{"point_id", number},
                       {"name", number == 3 ? "展台 <3>" : "Navigation Point " + std::to_string(number)},
                       {"point_type", number == 2   ? kTypes[1]
                                      : number == 7 ? kTypes[2]
                                                    : kTypes[0]},
                       {"pixel_pose", Value::Object{{"position", pixel}, {"angle", degrees}}},
                       {"pose", Value::Object{{"position", Value::Object{{"x", x}, {"y", y}, {"z", 0}}}}}};
}

Value storedMapNames(MapLibrary& library, const Faults&, const Value&) {
  Value::List maps;
  for (const AimdkMap& map : kMaps) {
    if (library.scene().find(map.trajectory) == nullptr) continue;
    maps.push_back(Value::Object{{"map_id", map.id}, {"map_name", map.name}, {"map_index", map.index}});
  }
  return data({{"map_lists", std::move(maps)}});
}

Value currentAimdkMap(MapLibrary& library, const Faults&, const Value&) {
  if (library.scene().trajectories.empty()) return data({});
  return data({{"map_id", kCurrent}});
}

Value wholeMap(MapLibrary& library, const Faults& faults, const Value& map_id) {
  // The id is a text in this call.
  const auto* id = map_id.as<std::string>();
  if (id == nullptr) return error(-32602, "map_id has to be a string.");
  const AimdkMap* map = byId(kMaps, *id);
  const MapPicturePtr picture = map == nullptr ? nullptr : library.pictures().picture(specOf(*map));
  if (!picture) return data({});
  const PixelFrame frame = frameOf(*picture);
  Value::Object members{{"map_id", map->id},
                        {"map_name", map->name},
                        {"width", picture->width + map->wrong_size},
                        {"height", picture->height + map->wrong_size}};
  if (faults.grid_fault != "no-resolution") {
    members.emplace_back("resolution", faults.grid_fault == "zero-resolution"       ? 0
                                       : faults.grid_fault == "negative-resolution" ? -frame.per_metre
                                                                                    : frame.per_metre);
  }
  if (faults.grid_fault != "no-origin") {
    members.emplace_back("origin_x", frame.origin_u);
    members.emplace_back("origin_y", frame.origin_v);
  }
  const std::string png =
      faults.garbage_base64 ? "*** this is no base64 ***" : base64(faultyPng(*picture->png, faults));
  members.emplace_back("map_data", (map->data_url ? "data:image/png;base64," : "") + png);
  members.emplace_back("rotate_angle", map->rotate_deg);
  members.emplace_back("map_url", "");
  return data(std::move(members));
}

Value topoMessages(MapLibrary& library, const Faults&, const Value& map_id) {
  // The id is a number in this call.
  const auto* id = map_id.as<std::int64_t>();
  if (id == nullptr) return error(-32602, "map_id has to be a number.");
  const AimdkMap* map = byId(kMaps, std::to_string(*id));
  const Trajectory* way = map == nullptr ? nullptr : library.scene().find(map->trajectory);
  const MapPicturePtr picture = way == nullptr ? nullptr : library.pictures().picture(specOf(*map));
  if (!picture) return error(-1, "There is no topology for this map.");
  const PixelFrame frame = frameOf(*picture);
  Value::List points;
  for (int i = 1; i <= kNavigationPoints; ++i) {
    const geometry::Pose2 at = way->drive.at(way->drive.length_m() * i / (kNavigationPoints + 1));
    points.push_back(navigationPoint(i, at, frame));
  }
  return data({{"points", std::move(points)}, {"paths", Value::List{}}, {"regions", Value::List{}}});
}

struct Call {
  std::string_view method, command;
  Value (*answer)(MapLibrary& library, const Faults& faults, const Value& map_id);
};
constexpr Call kCalls[] = {
    {"MappingService/GetStoredMapNames", "MappingCommand_GET_STORED_MAP_NAME", storedMapNames},
    {"MappingService/GetCurrentWorkingMap", "MappingCommand_GET_CURRENT_WORKING_MAP", currentAimdkMap},
    {"MappingService/Get2DWholeMap", "MappingCommand_GET_2D_WHOLE_MAP", wholeMap},
    {"LocalizationService/GetTopoMsgs", "TopoCommand_GET_TOPO_MSG", topoMessages}};

}  // namespace

HttpAnswer AimdkRoutes::answer(const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  if (!path.starts_with(kPrefix)) return valueAnswer(404, error(404, "There is no such service."));
  const std::string_view method = path.substr(kPrefix.size());
  const auto* const call = std::find_if(std::begin(kCalls), std::end(kCalls),
                                        [&](const Call& one) { return one.method == method; });
  if (call == std::end(kCalls)) return valueAnswer(404, error(404, "There is no such method."));
  if (question.method != "POST") {
    HttpAnswer answer = valueAnswer(405, error(405, "Only POST is understood here."));
    answer.headers = {{"Allow", "POST"}};
    return answer;
  }
  const Faults faults = faults_.faults();
  if (faults.map_list_error && call->answer == storedMapNames)
    return valueAnswer(500, error(500, "The map store is locked."));

  const Value request = fromJson(question.body).value_or(Value());
  const auto* command = request["command"].as<std::string>();
  if (command == nullptr)
    return valueAnswer(400, error(400, "The request is no JSON object with a command."));
  HttpAnswer answer = valueAnswer(200, *command == call->command
                                           ? call->answer(library_, faults, request["map_id"])
                                           : error(-32602, "The command does not belong to this method."));
  answer.delay_ms = faults.map_latency_ms;
  return answer;
}

}  // namespace mapwright::simulator
