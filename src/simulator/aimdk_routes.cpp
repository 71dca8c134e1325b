#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "simulator/axbot_routes.h"

namespace mapwright::simulator {
namespace {

constexpr std::string_view kPrefix = "/rpc/aimdk.protocol.";
constexpr int kNavigationPoints = 9;
constexpr int kMisplacedPoint = 4;  // whose pixel_pose does not fit its pose
constexpr double kMisplacedPixels = 6;
constexpr std::string_view kFirstMap = "1764059676131";

}  // namespace

struct AimdkMap {
  std::string id;  // 13 digits
  std::string name;
  int index;
  int trajectory;
  double resolution_m;
  double rotate_deg = 0;
  bool data_url = false;  // map_data begins with "data:image/png;base64,"
  int wrong_size = 0;     // what the declared width and height are off by
};

struct AimdkPoint {
  int id = 0;
  std::string name = {}, type = {};
  double x_m = 0, y_m = 0;
  double u = 0, v = 0;
  double angle_deg = 0;  // from +u to +v
};

/// The pixel of the world's origin, and pixels per metre.
struct PixelFrame {
  double origin_u = 0, origin_v = 0, per_metre = 20;
};

namespace {

PixelFrame frameOf(const MapPicture& picture) {
  PixelFrame frame;
  frame.per_metre = std::round(1 / picture.resolution_m);
  frame.origin_u = std::round(-picture.origin_m.x() * frame.per_metre);
  frame.origin_v = std::round(picture.height + picture.origin_m.y() * frame.per_metre);
  return frame;
}

Value error(int code, std::string_view message) {
  return Value::Object{{"error", Value::Object{{"code", code}, {"message", message}}}};
}

/// As newer firmware refuses.
Value refusal(std::string_view code, std::string_view message) {
  return Value::Object{{"header", Value::Object{{"code", code}, {"msg", message}}}};
}

Value data(Value::Object members) { return Value::Object{{"data", std::move(members)}}; }

}  // namespace

struct AimdkState {
  explicit AimdkState(const Robot& robot) : library(robot.library), options(robot.options.aimdk) {
    const AimdkMap all[] = {{"1764137567113", "River Park", 5, 3, 0.05, 0, true},
                            {std::string(kFirstMap), "Park", 3, 0, 0.05, -5.512457272434708},
                            {"1762584133656", "e2-8 <b>大厅</b> 🏭", 2, 2, 0.1, 90, false, 2}};
    for (const AimdkMap& map : all) {
      if (library.scene().find(map.trajectory) != nullptr) maps.push_back(map);
    }
    if (!library.scene().trajectories.empty()) current = kFirstMap;
  }

  AimdkMap* find(std::string_view id) { return byId(maps, id); }
  /// Null if there is no such map.
  MapPicturePtr picture(const AimdkMap* map) {
    return map == nullptr ? nullptr : library.pictures().picture({map->trajectory, map->resolution_m});
  }
  /// Of a map that has a picture. As they are at first: along the route.
  std::vector<AimdkPoint>& pointsOf(const AimdkMap& map, const PixelFrame& frame) {
    const auto [entry, is_new] = points.try_emplace(map.id);
    if (!is_new) return entry->second;
    constexpr std::string_view kTypes[] = {"NaviPointType_NAVI_POINT", "NaviPointType_CHARGE_POINT",
                                           "NaviPointType_ELEVATOR_POINT"};
    const Trajectory* way = library.scene().find(map.trajectory);
    for (int i = 1; way != nullptr && i <= kNavigationPoints; ++i) {
      const geometry::Pose2 at = way->drive.at(way->drive.length_m() * i / (kNavigationPoints + 1));
      AimdkPoint point{i, i == 3 ? "展台 <3>" : "Navigation Point " + std::to_string(i),
                       std::string(kTypes[i == 2   ? 1
                                          : i == 7 ? 2
                                                   : 0])};
      point.x_m = std::round(at.x_m * 1000) / 1000;
      point.y_m = std::round(at.y_m * 1000) / 1000;
      const double off = i == kMisplacedPoint ? kMisplacedPixels : 0;
      point.u = std::round(frame.origin_u + point.x_m * frame.per_metre + off);
      point.v = std::round(frame.origin_v - point.y_m * frame.per_metre);
      point.angle_deg = -std::round(geometry::degreesFromRadians(at.yaw_rad) * 10) / 10;
      entry->second.push_back(std::move(point));
    }
    return entry->second;
  }

  MapLibrary& library;
  const AimdkOptions options;
  std::mutex mutex;
  std::vector<AimdkMap> maps;
  std::string current;
  bool mapping = false;
  std::int64_t next_id = 1'764'200'000'001;
  std::map<std::string, std::vector<AimdkPoint>> points;  // by map
};

namespace {

Value pointValue(const AimdkPoint& point) {
  const Value pixel = Value::Object{{"u", point.u}, {"v", point.v}};
  return Value::Object{
      {"point_id", point.id},
      {"name", point.name},
      {"point_type", point.type},
      {"pixel_pose", Value::Object{{"position", pixel}, {"angle", point.angle_deg}}},
      {"pose", Value::Object{{"position", Value::Object{{"x", point.x_m}, {"y", point.y_m}, {"z", 0}}}}}};
}

Value storedMapNames(AimdkState& state, const Faults&, const Value&) {
  Value::List maps;
  for (const AimdkMap& map : state.maps)
    maps.push_back(Value::Object{{"map_id", map.id}, {"map_name", map.name}, {"map_index", map.index}});
  return data({{"map_lists", std::move(maps)}});
}

Value currentAimdkMap(AimdkState& state, const Faults&, const Value&) {
  if (state.current.empty()) return data({});
  return data({{"map_id", state.current}});
}

Value wholeMap(AimdkState& state, const Faults& faults, const Value& request) {
  // The id is a text in this call.
  const auto* id = request["map_id"].as<std::string>();
  if (id == nullptr) return error(-32602, "map_id has to be a string.");
  const AimdkMap* map = state.find(*id);
  const MapPicturePtr picture = state.picture(map);
  if (!picture) return data({});
  const PixelFrame frame = frameOf(*picture);
  const double resolution = state.options.centimetres ? 100 / frame.per_metre : frame.per_metre;
  Value::Object members{{"map_id", map->id},
                        {"map_name", map->name},
                        {"width", picture->width + map->wrong_size},
                        {"height", picture->height + map->wrong_size}};
  if (const auto told = faultyResolution(resolution, faults.grid_fault))
    members.emplace_back("resolution", *told);
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

Value topoMessages(AimdkState& state, const Faults&, const Value& request) {
  // The id is a number in this call.
  const auto* id = request["map_id"].as<std::int64_t>();
  if (id == nullptr) return error(-32602, "map_id has to be a number.");
  const AimdkMap* map = state.find(std::to_string(*id));
  const MapPicturePtr picture = state.picture(map);
  if (!picture) return error(-1, "There is no topology for this map.");
  Value::List points;
  for (const AimdkPoint& point : state.pointsOf(*map, frameOf(*picture))) points.push_back(pointValue(point));
  return data({{"points", std::move(points)}, {"paths", Value::List{}}, {"regions", Value::List{}}});
}

// What newer firmware has.

Value noSuchAimdkMap() { return refusal("1001", "There is no such map."); }

Value realtimeMap(AimdkState& state, const Faults&, const Value&) {
  const MapPicturePtr picture = state.mapping ? state.picture(state.find(state.current)) : nullptr;
  if (!picture) return data({});
  const Value position = Value::Object{{"u", 10}, {"v", 10}};
  return data({{"map_data", base64(*picture->png)},
               {"cur_pos", Value::Object{{"position", position}}},
               {"lidar_points", Value::List{}},
               {"trajectory", Value::List{}}});
}

Value startAimdkMapping(AimdkState& state, const Faults&, const Value&) {
  if (std::exchange(state.mapping, true)) return refusal("1002", "Mapping is under way.");
  return data({});
}

Value stopAimdkMapping(AimdkState& state, const Faults&, const Value& request) {
  if (!state.mapping) return refusal("1003", "Mapping is not under way.");
  if (request["command"].text() == "MappingCommand_SAVING_MAP") {
    const AimdkMap* const like = state.find(state.current);
    if (like == nullptr || request["map_name"].text().empty())
      return refusal("1004", "The map needs a name.");
    AimdkMap made{std::to_string(state.next_id++), request["map_name"].text(), 1, like->trajectory, 0.05};
    for (const AimdkMap& map : state.maps) made.index = std::max(made.index, map.index + 1);
    state.points[made.id] = {};  // nobody has set any
    state.maps.push_back(std::move(made));
  }
  state.mapping = false;
  return data({});
}

Value renameAimdkMap(AimdkState& state, const Faults&, const Value& request) {
  AimdkMap* const map = state.find(request["map_id"].text());
  if (map == nullptr) return noSuchAimdkMap();
  if (map->name != request["old_name"].text()) return refusal("1005", "It has another name.");
  map->name = request["new_name"].text();
  return data({});
}

Value useAimdkMap(AimdkState& state, const Faults&, const Value& request) {
  const AimdkMap* const map = state.find(request["map_id"].text());
  if (map == nullptr) return noSuchAimdkMap();
  state.current = map->id;
  return data({});
}

Value deleteAimdkMap(AimdkState& state, const Faults&, const Value& request) {
  const AimdkMap* const map = state.find(request["map_id"].text());
  if (map == nullptr) return noSuchAimdkMap();
  if (map->id == state.current) return refusal("1006", "The map is in use.");
  state.points.erase(map->id);
  std::erase_if(state.maps, [&](const AimdkMap& one) { return &one == map; });
  return data({});
}

Value setNaviPoint(AimdkState& state, const Faults&, const Value& request) {
  const auto* const id = request["map_id"].as<std::int64_t>();
  const AimdkMap* const map = id == nullptr ? nullptr : state.find(std::to_string(*id));
  const MapPicturePtr picture = state.picture(map);
  if (!picture) return noSuchAimdkMap();
  const Value& wanted = request["point"];
  const Value& pixel = wanted["pixel_pose"]["position"];
  const auto *const u = pixel["u"].as<std::int64_t>(), *const v = pixel["v"].as<std::int64_t>();
  if (u == nullptr || v == nullptr) return refusal("1007", "u and v have to be whole numbers.");
  const PixelFrame frame = frameOf(*picture);
  std::vector<AimdkPoint>& points = state.pointsOf(*map, frame);
  int number = static_cast<int>(wanted["point_id"].number()), last = 0;
  for (const AimdkPoint& point : points) last = std::max(last, point.id);
  if (number == 0) {
    number = last + 1;
    points.push_back({number});
  }
  AimdkPoint* const point = byId(points, number);
  if (point == nullptr) return refusal("1008", "There is no such point.");
  *point = {number,
            wanted["name"].text(),
            wanted["point_type"].text(),
            (double(*u) - frame.origin_u) / frame.per_metre,
            (frame.origin_v - double(*v)) / frame.per_metre,
            double(*u),
            double(*v),
            wanted["pixel_pose"]["angle"].number()};
  return data({{"point_id", number}});
}

struct AimdkCall {
  std::string_view method, command;
  Value (*answer)(AimdkState& state, const Faults& faults, const Value& request);
  bool newer = false, changes = false;
  std::string_view other_command = {};
};
constexpr AimdkCall kCalls[] = {
    {"MappingService/GetStoredMapNames", "MappingCommand_GET_STORED_MAP_NAME", storedMapNames},
    {"MappingService/GetCurrentWorkingMap", "MappingCommand_GET_CURRENT_WORKING_MAP", currentAimdkMap},
    {"MappingService/Get2DWholeMap", "MappingCommand_GET_2D_WHOLE_MAP", wholeMap},
    {"LocalizationService/GetTopoMsgs", "TopoCommand_GET_TOPO_MSG", topoMessages},
    {"MappingService/GetRealtimeMapData", "MappingCommand_GET_REALTIME_MAP", realtimeMap, true},
    {"MappingService/StartMapping", "MappingCommand_START_MAPPING", startAimdkMapping, true, true},
    {"MappingService/StopMapping", "MappingCommand_STOP_MAPPING", stopAimdkMapping, true, true,
     "MappingCommand_SAVING_MAP"},
    {"MappingService/RenameMap", "MappingCommand_RENAME_MAP", renameAimdkMap, true, true},
    {"MappingService/SetCurrentWorkingMap", "MappingCommand_SET_CURRENT_WORKING_MAP", useAimdkMap, true,
     true},
    {"MappingService/DeleteMap", "MappingCommand_DELETE_MAP", deleteAimdkMap, true, true},
    {"LocalizationService/SetNaviPoint", "TopoCommand_SET_NAVI_POINT", setNaviPoint, true, true}};

/// The one that a path names; null if it is unknown to this firmware.
const AimdkCall* callOf(const HttpQuestion& question, bool newer) {
  const std::string_view path = pathOf(question.target);
  for (const AimdkCall& call : kCalls) {
    if (path.starts_with(kPrefix) && call.method == path.substr(kPrefix.size()) && (newer || !call.newer))
      return &call;
  }
  return nullptr;
}

HttpAnswer saidAnswer(Value said, bool newer) {
  if (newer && !said.has("header") && !said.has("error"))
    said.set("header", Value::Object{{"code", "0"}, {"msg", ""}});
  return valueAnswer(200, said);
}

}  // namespace

AimdkRoutes::AimdkRoutes(const Robot& robot)
    : Answerer(robot.faults), state_(std::make_unique<AimdkState>(robot)) {}

AimdkRoutes::~AimdkRoutes() = default;

unsigned AimdkRoutes::kindsOf(const HttpQuestion& question) const {
  const AimdkCall* const call = callOf(question, state_->options.newer);
  if (call == nullptr) return 0;
  return kMaps | (call->changes ? kWrites : kReads) | (call->answer == storedMapNames ? kMapList : 0U);
}

HttpAnswer AimdkRoutes::answered(const HttpQuestion& question, const Verdict&) {
  const bool newer = state_->options.newer;
  const AimdkCall* const call = callOf(question, newer);
  if (call == nullptr) return valueAnswer(404, error(404, "There is no such method."));
  if (question.method != "POST") {
    HttpAnswer answer = valueAnswer(405, error(405, "Only POST is understood here."));
    answer.headers = {{"Allow", "POST"}};
    return answer;
  }
  const Value request = fromJson(question.body).value_or(Value());
  const auto* command = request["command"].as<std::string>();
  if (command == nullptr)
    return valueAnswer(400, error(400, "The request is no JSON object with a command."));
  if (*command != call->command && (call->other_command.empty() || *command != call->other_command))
    return saidAnswer(error(-32602, "The command does not belong to this method."), newer);
  const std::lock_guard lock(state_->mutex);
  return saidAnswer(call->answer(*state_, faults(), request), newer);
}

HttpAnswer AimdkRoutes::refused(const HttpQuestion&, const Verdict& verdict) const {
  const int status = verdict.number > 0 ? verdict.number : 500;
  return valueAnswer(status, error(status, "It could not be carried out."));
}

HttpAnswer AimdkRoutes::ignored(const HttpQuestion&) { return saidAnswer(data({}), state_->options.newer); }

}  // namespace mapwright::simulator
