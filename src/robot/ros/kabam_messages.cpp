#include "robot/ros/kabam_messages.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "geometry/pose.h"
#include "map/waypoint.h"
#include "robot/faults.h"
#include "robot/ros/faults.h"
#include "robot/ros/transforms.h"
#include "robot/wire/faults.h"
#include "robot/wire/picture_bytes.h"
#include "words/text.h"

namespace mapwright::robot::ros {
namespace {

constexpr int kMostNotes = 20;
/// how many
constexpr FaultCode kMoreLeftOut{"ros", QT_TRANSLATE_N_NOOP("ros", "%1 more waypoints were left out.")};
/// how many
constexpr FaultCode kMoreOdd{
    "ros", QT_TRANSLATE_N_NOOP("ros", "%1 more waypoints have no direction, or a frame that is unknown.")};

using words::text;

QByteArray compact(const QJsonObject& object) { return QJsonDocument(object).toJson(QJsonDocument::Compact); }

/// ROS times, seconds, or ISO 8601.
std::optional<double> timeOf(const Field& field) {
  if (const auto time = field.time()) return time;
  if (const auto seconds = field.number()) return *seconds > 0 ? seconds : std::nullopt;
  const QDateTime date = QDateTime::fromString(text(field.text()), Qt::ISODateWithMs);
  return date.isValid() ? std::optional(double(date.toMSecsSinceEpoch()) / 1000) : std::nullopt;
}

std::optional<KabamMap> rowOf(const Field& row, bool archived) {
  KabamMap map{row["map_id"].text(), row["map_name"].text(), row["map_label"].text(), archived};
  // Ids are texts; a manager that numbers its maps sends digits.
  if (map.id.empty()) {
    if (const auto number = row["map_id"].integer()) map.id = std::to_string(*number);
  }
  if (map.id.empty()) return std::nullopt;
  return map;
}

struct Turn {
  double yaw_rad = 0;
  bool zero = false;
};

Turn turnOf(double x, double y, double z, double w) {
  const auto pose = geometry::toIsometry({0, 0, 0, x, y, z, w});
  if (!pose) return {0, true};
  return {geometry::projectToPlane(*pose).yaw_rad, false};
}

double memberOf(const QJsonObject& object, const char* name) {
  return object.value(QLatin1String(name)).toDouble();
}

Turn turnOf(const QJsonObject& q) {
  return turnOf(memberOf(q, "x"), memberOf(q, "y"), memberOf(q, "z"), memberOf(q, "w"));
}

struct ReadWaypoint {
  map::Waypoint point;
  bool zero_turn = false;
};

/// A row as a waypoint; nullopt: it has no position.
std::optional<ReadWaypoint> waypointOf(const Field& row) {
  ReadWaypoint read;
  map::Waypoint& point = read.point;
  point.id = row["id"].text();
  point.name = row["name"].text();
  const Field position = row["pose"]["position"], q = row["pose"]["orientation"];
  const auto x = position["x"].number(), y = position["y"].number();
  if (!x || !y) return std::nullopt;
  point.position_m = {*x, *y};
  const Turn turn = turnOf(q["x"].number().value_or(0), q["y"].number().value_or(0),
                           q["z"].number().value_or(0), q["w"].number().value_or(0));
  read.zero_turn = turn.zero;
  point.yaw_rad = turn.yaw_rad;
  row["waypoint_tags"].each([&](const Field& tag) { point.tags.push_back(tag.text()); });
  point.source = compact(QJsonDocument::fromJson(row.toWholeJson()).object()).toStdString();
  return read;
}

using map::Applied;
using map::FailureKind;
using net::rosbridge::Field;

/// What a code means. Without a cause it was done.
struct Code {
  std::int64_t code;
  FaultCode cause = {};
  bool of_name = false;  // the cause names what it is about
  FailureKind kind = FailureKind::RejectedByRobot;
};

constexpr Code kOfWaypoints[] = {
    {0},  // created
    {3},  // updated
    {5},  // deleted
    {1, fault::ResultMapUnknown},
    {2, robot::fault::WaypointNameTaken, true},
    {4, faultText("ros", "the waypoint no longer exists"), false,
     FailureKind::Conflict},  // somebody else has deleted it
    {6, fault::ResultUndefined},
};
constexpr Code kOfUpdates[] = {
    {0},  // updated
    {1},  // deleted
    {2, fault::ResultMapUnknown},
    {3, fault::ResultInvalid},
    {4, fault::ResultUndefined},
};
constexpr Code kOfLoads[] = {
    {0},
    {1, fault::ResultMapUnknown},
    {2, faultText("ros", "it already uses this map")},
    {3,
     faultText("ros", "it considers the request invalid; it may need to know at which waypoint it stands")},
    {4, fault::ResultUndefined},
};
constexpr Code kOfSaves[] = {
    {0},
    {1,
     faultText(
         "ros",
         "it considers the request invalid; there may be nothing to save, or the name may not be allowed")},
    {2, fault::ResultMapNameTaken, true},
    {3, fault::ResultUndefined},
};

map::Failure withoutCode(map::Subject subject) {
  return {.kind = FailureKind::MalformedAnswer,
          .subject = std::move(subject),
          .applied = Applied::Maybe,
          .asked_for = map::AskedFor::Change,
          .cause = {fault::AnswerWithoutResult}};
}

/// A std_srvs/Trigger; its message is shown.
std::optional<map::Failure> triggerResult(const Field& values, map::Subject subject) {
  const auto success = values["success"].flag();
  if (!success) return withoutCode(std::move(subject));
  if (*success) return std::nullopt;
  return map::Failure{.kind = FailureKind::RejectedByRobot,
                      .subject = std::move(subject),
                      .detail = values["message"].text().substr(0, 300),
                      .asked_for = map::AskedFor::Change};
}

}  // namespace

const std::string& calledOf(const KabamMap& map) { return map.label.empty() ? map.name : map.label; }

std::optional<std::vector<KabamMap>> readMapList(const Field& msg, bool archived) {
  if (!msg["maps"].isList()) return std::nullopt;
  std::vector<KabamMap> maps;
  msg["maps"].each([&](const Field& row) {
    if (auto map = rowOf(row, archived)) maps.push_back(std::move(*map));
  });
  return maps;
}

std::optional<KabamCurrent> readMapInfo(const Field& msg) {
  if (!msg.isObject()) return std::nullopt;
  KabamCurrent current;
  current.map = rowOf(msg, false).value_or(KabamMap{});
  current.state = msg["map_manager_state"].text();
  current.created_s = timeOf(msg["created_at"]);
  current.updated_s = timeOf(msg["updated_at"]);
  return current;
}

std::optional<StoredWaypoints> readWaypoints(const Field& msg, const std::string& map_id,
                                             const std::string& fixed_frame) {
  // A topic's message is the list; an answer may nest it in another message.
  Field rows = msg["waypoints"];
  if (rows.isObject()) rows = rows["waypoints"];
  if (!rows.isList()) return std::nullopt;
  StoredWaypoints stored;
  std::set<std::string> ids;
  std::int64_t nameless = 0, placeless = 0, left_out = 0, odd = 0;
  const auto addNote = [&](FaultCode code, std::vector<FaultArgument> arguments, std::int64_t& more) {
    if (int(stored.notes.size()) < kMostNotes) {
      stored.notes.push_back({code, std::move(arguments)});
    } else {
      ++more;
    }
  };
  rows.each([&](const Field& row) {
    const std::string of = row["map_id"].text();
    if (!of.empty() && of != map_id) return;
    const std::string frame = frameName(row["frame_id"].text());
    auto read = waypointOf(row);
    map::Waypoint* const point = read ? &read->point : nullptr;
    if (read && read->zero_turn)
      addNote(fault::WaypointTurnIsZero, {point->name.empty() ? point->id : point->name}, odd);
    if (!point) {
      ++placeless;
    } else if (point->id.empty()) {
      ++nameless;
    } else if (!frame.empty() && !fixed_frame.empty() && frame != fixed_frame) {
      addNote(faultText("ros", "Waypoint \"%1\" is in the frame %2 instead of %3. It was left out."),
              {point->name.empty() ? point->id : point->name, frame, fixed_frame}, left_out);
    } else if (!ids.insert(point->id).second) {
      addNote(robot::wire::fault::WaypointIdTwice, {point->id}, left_out);
    } else {
      // Without a map its frame is unknown: this is the usual name.
      if (!frame.empty() && fixed_frame.empty() && frame != "map")
        addNote(fault::WaypointFrameUnknown, {point->name.empty() ? point->id : point->name, frame}, odd);
      if (read->zero_turn) stored.zero_turns.insert(point->id);
      stored.points.push_back(std::move(*point));
    }
  });
  for (const auto& [code, count] : {std::pair(kMoreLeftOut, left_out), std::pair(kMoreOdd, odd),
                                    std::pair(robot::wire::fault::RowsWithoutId, nameless),
                                    std::pair(robot::wire::fault::PointsUnplaced, placeless)}) {
    if (count > 0) stored.notes.push_back({code, {count}});
  }
  stored.revision = revisionOf(stored.points);
  return stored;
}

std::string revisionOf(const std::vector<map::Waypoint>& points) {
  std::vector<std::string> rows;
  for (const map::Waypoint& point : points) rows.push_back(point.source);
  std::sort(rows.begin(), rows.end());
  std::string all;
  for (const std::string& row : rows) all += row + '\n';
  return wire::fingerprint(all);
}

QByteArray waypointJson(const map::Waypoint& point, const std::string& id, const std::string& map_id,
                        const std::string& fixed_frame) {
  QJsonObject message = QJsonDocument::fromJson(QByteArray::fromStdString(point.source)).object();
  // A copied one, or one from a file, has another kind of source.
  if (!message.value(QLatin1String("pose")).isObject()) message = {};
  const bool came = !message.isEmpty();
  QJsonObject pose = message.value(QLatin1String("pose")).toObject();
  QJsonObject position = pose.value(QLatin1String("position")).toObject();
  QJsonObject orientation = pose.value(QLatin1String("orientation")).toObject();
  position[QStringLiteral("x")] = point.position_m.x();
  position[QStringLiteral("y")] = point.position_m.y();
  if (!position.contains(QLatin1String("z"))) position[QStringLiteral("z")] = 0;
  const double yaw = point.yaw_rad.value_or(0);
  if (!came || !map::sameHeading(turnOf(orientation).yaw_rad, yaw)) {
    orientation = {{QStringLiteral("x"), 0.0},
                   {QStringLiteral("y"), 0.0},
                   {QStringLiteral("z"), std::sin(yaw / 2)},
                   {QStringLiteral("w"), std::cos(yaw / 2)}};
  }
  for (const char* member : {"x", "y", "z", "w"}) {
    if (!orientation.value(QLatin1String(member)).isDouble()) orientation[QLatin1String(member)] = 0;
  }
  pose[QStringLiteral("position")] = position;
  pose[QStringLiteral("orientation")] = orientation;
  QJsonArray tags;
  for (const std::string& tag : point.tags) tags << text(tag);
  message[QStringLiteral("pose")] = pose;
  message[QStringLiteral("id")] = text(id);
  message[QStringLiteral("name")] = text(point.name);
  message[QStringLiteral("map_id")] = text(map_id);
  message[QStringLiteral("waypoint_tags")] = tags;
  if (!came) message[QStringLiteral("frame_id")] = text(fixed_frame.empty() ? "map" : fixed_frame);
  return compact(message);
}

QByteArray manageWaypointArgs(const QByteArray& waypoint, bool delete_waypoint) {
  return compact({{QStringLiteral("waypoint_info"), QJsonDocument::fromJson(waypoint).object()},
                  {QStringLiteral("delete_waypoint"), delete_waypoint}});
}

QByteArray getWaypointArgs(const std::string& map_id, const std::string& waypoint_id) {
  return compact(
      {{QStringLiteral("map_id"), text(map_id)}, {QStringLiteral("waypoint_id"), text(waypoint_id)}});
}

QByteArray loadMapArgs(const std::string& map_id, const std::string& waypoint_name) {
  return compact(
      {{QStringLiteral("map_id"), text(map_id)}, {QStringLiteral("loc_waypoint_name"), text(waypoint_name)}});
}

QByteArray updateMapArgs(const KabamMap& map, const std::string& label, bool archived, bool delete_map) {
  // The server fills in the header: those of ROS 1 and ROS 2 differ, and omitted members are zero.
  const QJsonObject no_image{{QStringLiteral("height"), 0},
                             {QStringLiteral("width"), 0},
                             {QStringLiteral("encoding"), QString()},
                             {QStringLiteral("is_bigendian"), 0},
                             {QStringLiteral("step"), 0},
                             {QStringLiteral("data"), QString()}};
  // All flags, whichever the service uses.
  return compact({{QStringLiteral("map_id"), text(map.id)},
                  {QStringLiteral("updated_image"), no_image},
                  {QStringLiteral("new_map_label"), text(label)},
                  {QStringLiteral("set_archive"), archived},
                  {QStringLiteral("delete_map"), delete_map}});
}

QByteArray updateImageHead(const KabamMap& map, int width, int height) {
  const QJsonObject image{{QStringLiteral("height"), height},
                          {QStringLiteral("width"), width},
                          {QStringLiteral("encoding"), QStringLiteral("mono8")},
                          {QStringLiteral("is_bigendian"), 0},
                          {QStringLiteral("step"), width}};
  QByteArray all = compact({{QStringLiteral("map_id"), text(map.id)},
                            {QStringLiteral("new_map_label"), QString()},
                            {QStringLiteral("set_archive"), map.archived},
                            {QStringLiteral("delete_map"), false}});
  QByteArray picture = compact(image);
  all.chop(1);
  picture.chop(1);
  return all + ",\"updated_image\":" + picture + ",\"data\":\"";
}

QByteArray saveMapArgs(const std::string& name) {
  return compact({{QStringLiteral("map_name"), text(name)}});
}

bool sameBesidesTags(const map::Waypoint& a, const map::Waypoint& b) {
  return a.name == b.name && map::samePlace(a.position_m, b.position_m) &&
         map::sameHeading(a.yaw_rad.value_or(0), b.yaw_rad.value_or(0));
}

std::optional<map::Failure> resultOf(std::string_view service, const Field& values, map::Subject subject,
                                     const std::string& name) {
  if (service.ends_with("_mapping")) return triggerResult(values, std::move(subject));
  std::span<const Code> codes = kOfUpdates;
  if (service.ends_with("_waypoint")) codes = kOfWaypoints;
  if (service == "load_map") codes = kOfLoads;
  if (service == "save_map") codes = kOfSaves;
  const auto code = values["result"].integer();
  if (!code) return withoutCode(std::move(subject));
  map::Failure failure{.kind = FailureKind::RejectedByRobot,
                       .subject = std::move(subject),
                       .applied = Applied::Maybe,
                       .robot_code = std::to_string(*code),
                       .asked_for = map::AskedFor::Change,
                       .cause = {fault::ResultUnknown, {*code}}};
  const auto known =
      std::find_if(codes.begin(), codes.end(), [&](const Code& one) { return one.code == *code; });
  if (known == codes.end()) return failure;
  if (known->cause == FaultCode()) return std::nullopt;
  failure.kind = known->kind;
  failure.cause = known->cause;
  if (known->of_name) failure.cause.arguments = {name};
  // What is not known to have been refused may have been done.
  if (known->cause != fault::ResultUndefined) failure.applied = Applied::No;
  return failure;
}

}  // namespace mapwright::robot::ros
