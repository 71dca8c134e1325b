#include "simulator/noise.h"
#include "simulator/routes.h"
#include "simulator/topic_schedule.h"
#include "simulator/value_json.h"

namespace mapwright::simulator {
namespace {

std::string deviceText(const Robot& robot) {
  std::string sn = "71822";
  Dice dice(hashOf(robot.options.seed, 61));
  for (int i = 0; i < 8; ++i) sn += static_cast<char>('0' + dice.integer(0, 9));
  return ",\"device\":" +
         toJson(Value::Object{
             {"model", "hygeia"}, {"sn", sn}, {"name", "robot-" + sn}, {"nickname", "Simulated robot"}});
}

std::string deviceInfo(const Robot& robot) {
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
  return body + "}}";
}

}  // namespace

std::optional<HttpAnswer> deviceAnswer(const Robot& robot, const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  std::string body;
  if (path == "/device/info") {
    body = deviceInfo(robot);
  } else if (path == "/device/info/brief") {
    body = R"({"rosversion":"noetic","axbot_version":"2.11.0")" + deviceText(robot) + "}";
  } else if (path == "/device/boot_progress") {
    body = R"({"start_time":1717403100.125,"progress":1.0,"logs":[)"
           R"({"stamp":1717403100.125,"progress":0.0,"msg":"=== Simulated robot starting up ==="},)"
           R"({"stamp":1717403131.5,"progress":1.0,"msg":"Ready."}]})";
  } else if (path == "/device/sensors") {
    body =
        R"({"depth_cameras":[],"laser_scanners":[{"name":"lidar_node","scan_topic":"/left_laser_2d/matched"}],)"
        R"("rgb_cameras":[]})";
  } else if (path == "/ros/rosmaster/topics/published_names") {
    const std::vector<std::string_view> topics = publishedTopics();
    body = toJson(Value::Object{{"names", Value::List(topics.begin(), topics.end())}});
  } else {
    return std::nullopt;
  }
  if (auto refused = refusedMethod(question, "GET")) return refused;
  return jsonAnswer(200, std::move(body));
}

}  // namespace mapwright::simulator
