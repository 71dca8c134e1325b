#include "simulator/axbot_routes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "ros_messages/slam.pb.h"
#include "simulator/axbot_topics.h"
#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr std::string_view kSubmapPrefix = "/ros/slam/submaps/";
constexpr double kFinestM = 0.005, kCoarsestM = 10;
constexpr double kFarthestM = 1e5;

HttpAnswer protobufAnswer(std::shared_ptr<const std::string> body) {
  return {.content_type = "application/x-protobuf",
          .headers = {{"Cache-Control", "no-cache"}},
          .body = std::move(body)};
}

HttpAnswer protobufAnswer(std::string body) {
  return protobufAnswer(std::make_shared<const std::string>(std::move(body)));
}

/// The protobuf `body` with a width and height that do not match its cells.
std::string withWrongSize(const std::string& body) {
  ros_messages::slam::SubmapQueryV2Response response;
  if (!response.ParseFromString(body)) return body;
  for (ros_messages::slam::SubmapTexture& texture : *response.mutable_textures()) {
    texture.set_width(texture.width() + 7);
    texture.set_height(texture.height() + 3);
  }
  return response.SerializeAsString();
}

/// An answer whose StatusResponse reports an error.
std::string statusAnswer(int code, const std::string& message) {
  ros_messages::slam::SubmapQueryV2Response response;
  response.mutable_status()->set_code(static_cast<ros_messages::slam::StatusCode>(code));
  response.mutable_status()->set_message(message);
  return response.SerializeAsString();
}

bool isUuid(std::string_view text) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), isWordCharacter);
}

HttpAnswer submapError(int status) {
  return errorAnswer(status, status == 400   ? "Invalid path parameters."
                             : status == 404 ? "The submap was not found."
                             : status == 502 ? "The ROS service call failed."
                             : status == 504 ? "The ROS service was unavailable before the timeout."
                                             : "The answer could not be serialized.");
}

HttpAnswer submap(const Robot& robot, const HttpQuestion& question) {
  std::string_view rest = pathOf(question.target).substr(kSubmapPrefix.size());
  const std::string_view asked = partOf(rest, '/');
  const auto trajectory = numberFrom<std::int32_t>(partOf(rest, '/')), index = numberFrom<std::int32_t>(rest);
  if (!isUuid(asked) || !trajectory || !index) return submapError(400);
  const std::string uuid = robot.state.uuid();
  if (asked != uuid)
    return protobufAnswer(
        statusAnswer(ros_messages::slam::UUID_MISMATCH, "The SLAM session has another uuid."));
  const std::optional<SubmapSource> source = robot.state.find({*trajectory, *index});
  if (!source) return submapError(404);

  const std::string tag = '"' + uuid + '-' + std::to_string(*trajectory) + '-' + std::to_string(*index) +
                          '-' + std::to_string(source->version) + '"';
  BodyCache& bodies = isOfSceneAlone(*source) ? robot.made.bodies : robot.bodies;
  HttpAnswer answer =
      matchesTag(question.if_none_match, tag)
          ? emptyAnswer(304)
          : protobufAnswer(bodies.get({source->session, source->id, source->version}, [&] {
              return std::make_shared<const std::string>(makeSubmapBody(robot.state.plan(), *source));
            }));
  const bool versioned = !queryValue(question.target, "ver").empty();
  answer.headers = {{"Cache-Control", versioned ? "public, max-age=31536000, immutable" : "no-cache"},
                    {"ETag", versioned ? tag : "W/" + tag}};
  return answer;
}

HttpAnswer mapImage(const Robot& robot, const Request& request) {
  const std::string_view target = request.question.target, asked = queryValue(target, "resolution");
  PictureSpec spec;
  if (const std::optional<MappingSpan> span = robot.state.mapping())
    spec = specOf(*span, queryValue(target, "new_trajectory_only") == "true");
  const std::optional<double> resolution = asked.empty() ? spec.resolution_m : numberFrom<double>(asked);
  if (!resolution || !std::isfinite(*resolution) || *resolution < kFinestM || *resolution > kCoarsestM)
    return errorAnswer(400, "The resolution must lie between 0.005 and 10 metres.");
  if (const std::string_view id = queryValue(target, "trajectory_id"); !id.empty()) {
    const std::optional<int> number = numberFrom<int>(id);
    if (!number) return errorAnswer(400, "Invalid query parameters.");
    if (*number >= 0 && *number != spec.trajectory) {
      spec = {*number};
    }
  }
  spec.resolution_m = *resolution;
  const MapPicturePtr made = robot.library.pictures().picture(spec);
  if (!made) return errorAnswer(502, "The ROS service call failed.");
  ros_messages::slam::GetMapImageResponse response;
  response.set_origin_x(made->origin_m.x());
  response.set_origin_y(made->origin_m.y());
  response.set_resolution(made->resolution_m);
  response.set_png_bytes(faultyPng(*made->png, robot.faults.faults()));
  return protobufAnswer(response.SerializeAsString());
}

std::string deviceText(const Robot& robot) {
  std::string sn = "71822";
  Dice dice(hashOf(robot.options.seed, 61));
  for (int i = 0; i < 8; ++i) sn += static_cast<char>('0' + dice.integer(0, 9));
  return ",\"device\":" +
         toJson(Value::Object{
             {"model", "hygeia"}, {"sn", sn}, {"name", "robot-" + sn}, {"nickname", "Simulated robot"}});
}

HttpAnswer deviceInfo(const Robot& robot, const Request&) {
  std::string body =
      R"({"rosversion":"noetic","distro":"focal","axbot_version":"2.11.0","rest_version":"2.11.0")" +
      deviceText(robot) +
      R"(,"baseboard":{"firmware_version":"22a32218"},"wheel_control":{"firmware_version":"amps_20211103"},)"
      R"("robot":{"footprint":[[0.3,-0.2],[0.35,0.0],[0.3,0.2],[-0.25,0.27],[-0.32,0.0],[-0.25,-0.27]],)"
      R"("inscribed_radius":0.24,"height":1.23,"thickness":0.5,"wheel_distance":0.36,"width":0.54},"gitinfo":[],)"
      // Only what this robot has.
      R"("caps":{"supportsSetControlModeService":true,"supportsSetEmergencyStopService":true,)"
      R"("supportsWheelStateTopic":true,"supportsWsV2":true,"supportsInitialPositionAdjustment":true,)"
      R"("supportsCachedTopics":true,"supportsBags":true,"supportsSemanticPoints":true,"supportsBagPlayer":true,)"
      R"("supportsSensorList":true,"supportsSubmaps":true,"supportsEnableTopicList":)";
  body += robot.options.enable_topic_list ? "true" : "false";
  return jsonAnswer(200, body + "}}");
}

HttpAnswer deviceBrief(const Robot& robot, const Request&) {
  return jsonAnswer(200, R"({"rosversion":"noetic","axbot_version":"2.11.0")" + deviceText(robot) + "}");
}

HttpAnswer bootProgress(const Robot&, const Request&) {
  return jsonAnswer(200,
                    R"({"start_time":1717403100.125,"progress":1.0,"logs":[)"
                    R"({"stamp":1717403100.125,"progress":0.0,"msg":"=== Simulated robot starting up ==="},)"
                    R"({"stamp":1717403131.5,"progress":1.0,"msg":"Ready."}]})");
}

HttpAnswer sensors(const Robot&, const Request&) {
  return jsonAnswer(
      200,
      R"({"depth_cameras":[],"laser_scanners":[{"name":"lidar_node","scan_topic":"/left_laser_2d/matched"}],)"
      R"("rgb_cameras":[]})");
}

HttpAnswer topicNames(const Robot&, const Request&) {
  std::set<std::string_view> names;
  for (const AxbotTopic& topic : axbotTopics()) names.insert(topic.name);
  return valueAnswer(200, Value::Object{{"names", Value::List(names.begin(), names.end())}});
}

HttpAnswer setPose(const Robot& robot, const Request& request) {
  const RequestFields& fields = request.fields;
  const std::optional<std::vector<double>> position = fields.numbers("position");
  const std::optional<double> ori = fields.number("ori");
  // Two numbers are enough: the third is always 0.
  if (!position || position->size() < 2 || position->size() > 3 ||
      !(std::abs((*position)[0]) <= kFarthestM) || !(std::abs((*position)[1]) <= kFarthestM))
    return errorAnswer(400, "position: must be [x, y, 0] in metres.");
  if (!ori || std::abs(*ori) > kFarthestM) return errorAnswer(400, "ori: must be a number of radians.");
  const std::optional<bool> adjust = fields.flag("adjust_position", false);
  if (!adjust) return errorAnswer(400, "adjust_position: must be true or false.");
  if (robot.state.mapping()) return errorAnswer(400, "A mapping task is running.");
  robot.state.setPose({(*position)[0], (*position)[1], geometry::normalizeAngle(*ori)}, *adjust);
  return jsonAnswer(200, "{}");
}

HttpAnswer overlays(const Robot& robot, const Request&) {
  const std::optional<StoredMap> map = robot.library.current();
  if (!map) return errorAnswer(404, "There is no current map.");
  HttpAnswer answer =
      jsonAnswer(200, map->overlays && !map->overlays->empty() ? *map->overlays : noOverlays());
  answer.headers = {{"Cache-Control", "no-cache"}};
  return answer;
}

HttpAnswer setOverlays(const Robot& robot, const Request& request) {
  const std::string_view body = request.question.body;
  if (!robot.library.current()) return errorAnswer(404, "There is no current map.");
  if (body.empty() || !isOverlays(body))
    return errorAnswer(400, "The request is no GeoJSON FeatureCollection.");
  return robot.library.setCurrentOverlays(std::string(body))
             ? jsonAnswer(200, R"({"success":true,"message":""})")
             : errorAnswer(404, "There is no current map.");
}

HttpAnswer setControlMode(const Robot& robot, const Request& request) {
  const std::string mode = request.fields.text("control_mode").value_or("");
  if (mode != "auto" && mode != "manual" && mode != "remote")
    return errorAnswer(400, "control_mode: must be auto, manual or remote.");
  robot.state.setControlMode(mode);
  return jsonAnswer(200, "{}");
}

HttpAnswer setEmergencyStop(const Robot& robot, const Request& request) {
  const std::optional<bool> enable = request.fields.flag("enable");
  if (!enable) return errorAnswer(400, "enable: must be true or false.");
  robot.state.setEmergencyStop(*enable);
  return jsonAnswer(200, "{}");
}

HttpAnswer relocate(const Robot& robot, const Request&) {
  robot.state.relocate(robot.options.positioning_asks);
  return jsonAnswer(200, "{}");
}

using Body = Route::Body;
constexpr Route kRoutes[] = {
    {"GET", "/ros/slam/map_image", mapImage},
    {"GET", "/device/info", deviceInfo},
    {"GET", "/device/info/brief", deviceBrief},
    {"GET", "/device/boot_progress", bootProgress},
    {"GET", "/device/sensors", sensors},
    {"GET", "/ros/rosmaster/topics/published_names", topicNames},
    {"GET", "/ros/map/overlays", overlays},
    {"PUT", "/ros/map/overlays", setOverlays},
    {"POST", "/chassis/pose", setPose, Body::Json},
    {"POST", "/services/wheel_control/set_control_mode", setControlMode, Body::Json},
    {"POST", "/services/wheel_control/set_emergency_stop", setEmergencyStop, Body::Json},
    {"POST", "/services/start_global_positioning", relocate}};

/// What stands for the star or the id; nullopt if the path is another one.
std::optional<std::string_view> matched(std::string_view pattern, std::string_view path) {
  if (pattern.ends_with('/')) {
    pattern.remove_suffix(1);
    if (path.ends_with('/')) path.remove_suffix(1);
  }
  const std::size_t star = pattern.find_first_of("*#");
  if (star == std::string_view::npos)
    return path == pattern ? std::optional(path.substr(0, 0)) : std::nullopt;
  const std::string_view before = pattern.substr(0, star), behind = pattern.substr(star + 1);
  if (path.size() <= pattern.size() - 1 || !path.starts_with(before) || !path.ends_with(behind))
    return std::nullopt;
  path = path.substr(star, path.size() - before.size() - behind.size());
  const bool fits = path.find_first_of(pattern[star] == '#' ? "/." : "/") == std::string_view::npos;
  return fits ? std::optional(path) : std::nullopt;
}

}  // namespace

bool isSubmapPath(std::string_view path) { return path.starts_with(kSubmapPrefix); }

bool AxbotRoutes::opensTopics(std::string_view secret) const {
  return robot_.options.secret.empty() || secret == robot_.options.secret;
}

unsigned AxbotRoutes::kindsOf(const HttpQuestion& question) const {
  constexpr std::string_view kOfMaps[] = {
      "/map",      "/chassis/current-map", "/static-files/", "/bags", "/recording",
      "/ros/map/", "/ros/slam/map_image"};
  const std::string_view path = pathOf(question.target);
  const bool reads = question.method == "GET" || question.method == "HEAD";
  unsigned kinds = reads ? kReads : kWrites;
  if (isSubmapPath(path)) kinds |= kSubmaps;
  if (std::any_of(std::begin(kOfMaps), std::end(kOfMaps),
                  [&](auto prefix) { return path.starts_with(prefix); }))
    kinds |= kMaps;
  if (reads && (path == "/maps/" || path == "/maps")) kinds |= kMapList;
  if (path.ends_with(".pbstream")) kinds |= kDownloads;
  return opensTopics(question.secret) ? kinds : 0;
}

HttpAnswer AxbotRoutes::answered(const HttpQuestion& question, const Verdict& verdict) {
  using namespace ros_messages::slam;
  constexpr std::array kCodes{INTERNAL, UNAVAILABLE, DEADLINE_EXCEEDED, RESOURCE_EXHAUSTED};
  if (verdict.is(FaultKind::StatusError))
    return protobufAnswer(
        statusAnswer(kCodes[verdict.dice % kCodes.size()], "The submap could not be queried."));
  HttpAnswer answer = routed(question);
  if (!answer.body || answer.status != 200) return answer;
  if (verdict.is(FaultKind::WrongSize))
    answer.body = std::make_shared<const std::string>(withWrongSize(*answer.body));
  if (verdict.is(FaultKind::Corrupt))
    answer.body = std::make_shared<const std::string>(garbage(verdict.dice));
  return answer;
}

HttpAnswer AxbotRoutes::refused(const HttpQuestion& question, const Verdict& verdict) const {
  constexpr std::array kStatuses{500, 502, 503};
  if (isSubmapPath(pathOf(question.target))) return submapError(verdict.number > 0 ? verdict.number : 500);
  const int status = verdict.number > 0 ? verdict.number : kStatuses[verdict.dice % kStatuses.size()];
  HttpAnswer answer = errorAnswer(status, "The request could not be carried out.");
  if (status == 502) {  // as a proxy in front of the robot writes it
    answer.content_type = "text/html";
    answer.body = std::make_shared<const std::string>(
        "<html><head><title>502 Bad Gateway</title></head><body><h1>502 Bad Gateway</h1></body></html>");
  }
  return answer;
}

HttpAnswer AxbotRoutes::ignored(const HttpQuestion& question) {
  if (question.method != "PATCH")
    return question.method == "DELETE" ? emptyAnswer(204) : jsonAnswer(200, "{}");
  HttpQuestion look = question;
  look.method = "GET";
  return routed(look);
}

HttpAnswer AxbotRoutes::routed(const HttpQuestion& question) {
  if (!opensTopics(question.secret)) return errorAnswer(401, "A valid Secret header is required.");
  const std::string_view path = pathOf(question.target),
                         method = question.method == "HEAD" ? "GET" : question.method;
  std::string allowed;
  std::string_view pattern;  // the first that fits
  if (isSubmapPath(path)) {
    if (method == "GET") return submap(robot_, question);
    allowed = "GET";
  }
  for (const std::span<const Route> routes :
       {std::span<const Route>(kRoutes), mapRoutes(), bagRoutes(), sightingRoutes()}) {
    for (const Route& route : routes) {
      const std::optional<std::string_view> name = matched(route.path, path);
      if (!name || (!pattern.empty() && pattern != route.path)) continue;
      pattern = route.path;
      allowed.append(allowed.empty() ? "" : ", ").append(route.method);
      if (route.method != method) continue;
      const bool is_form = route.body == Route::Body::JsonOrForm;
      std::optional<RequestFields> fields =
          route.body == Route::Body::Any
              ? RequestFields()
              : RequestFields::read(is_form ? question.content_type : std::string_view(), question.body);
      return fields ? route.answer(robot_, {question, *name, std::move(*fields)})
                    : errorAnswer(400, is_form ? "The request is no JSON object and no form."
                                               : "The request is no JSON object.");
    }
  }
  if (allowed.empty()) return errorAnswer(404, "Not found.");
  HttpAnswer answer = errorAnswer(405, "Method \"" + std::string(question.method) + "\" not allowed.");
  answer.headers = {{"Allow", allowed}};
  return answer;
}

}  // namespace mapwright::simulator
