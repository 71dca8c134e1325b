#include "robot/axbot/parse_topics.h"

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_overlays.h"
#include "robot/axbot/topic_subjects.h"

namespace mapwright::robot::axbot {
namespace {

/// A member that explains an error, of any type.
std::string anyText(const wire::Json& root, std::string_view name) {
  const auto value = wire::member(root, {name});
  if (!value) return {};
  const std::string text = wire::asText(*value);
  return text.empty() ? std::string(simdjson::minify(*value)) : text;
}

}  // namespace

TextFrame readFrame(const wire::Json& root, const std::string& of_topic) {
  TextFrame frame;
  frame.topic = wire::text(root, {"topic"});
  if (frame.topic.empty()) frame.topic = of_topic;
  if (!frame.topic.empty()) {
    if (const auto kind = gridKindOf(frame.topic)) {
      readGridTopic(*kind, root, frame);
      return frame;
    }
    for (const auto read :
         {readSubmapTopic, readMotionTopic, readStateTopic, readWorldTopic, readCloudTopic}) {
      if (!frame.message) frame.message = read(frame.topic, root);
    }
    const bool of_the_map = frame.message && std::holds_alternative<map::MapInfo>(*frame.message);
    const auto overlays = of_the_map ? wire::member(root, {"overlays"}) : std::nullopt;
    if (overlays && !readableOverlays(*overlays))
      frame.left_out = map::UnreadableMessage{frame.topic, {fault::MemberIsNoList, {"overlays"}}};
    return frame;
  }
  if (const auto topics = wire::list(root, {"enabled_topics"})) {
    frame.enabled_topics.emplace();
    for (const wire::Json topic : *topics) {
      std::string_view name;
      if (!topic.get(name)) frame.enabled_topics->emplace_back(name);
    }
    return frame;
  }
  for (const char* member : {"error", "detail", "message"}) {
    if (frame.error.empty()) frame.error = anyText(root, member);
  }
  return frame;
}

TextFrame TopicReader::read(std::string_view utf8) {
  const auto root = json_.read(utf8);
  TextFrame frame;
  if (root && root->is_object()) {
    frame = readFrame(*root);
    if (!frame.topic.empty()) frame.stamp_s = wire::epochSeconds(*root, {"stamp"});
    return frame;
  }
  frame.message = map::UnreadableMessage{kUnknownTopic, {fault::MessageNotJson, {std::int64_t(utf8.size())}}};
  return frame;
}

TextFrame parseTextFrame(std::string_view utf8) { return TopicReader().read(utf8); }

QStringList knownTopics() {
  return {QStringLiteral("/map"),
          QStringLiteral("/map_v2"),
          QStringLiteral("/map/costmap_v2"),
          QStringLiteral("/maps/5cm/1hz"),
          QStringLiteral("/maps/1cm/1hz"),
          QStringLiteral("/incremental_map"),
          QStringLiteral("/incremental_map_v2"),
          QStringLiteral("/env_match_map"),
          QStringLiteral("/env_symmetry_map"),
          QStringLiteral("/submap_list"),
          QStringLiteral("/tracked_pose"),
          QStringLiteral("/robot_model"),
          QStringLiteral("/path"),
          QStringLiteral("/local_path"),
          QStringLiteral("/trajectory"),
          QStringLiteral("/trajectory_node_list"),
          QStringLiteral("/scan_matched_points2"),
          QStringLiteral("/semantic_points"),
          QStringLiteral("/left_laser_2d/matched"),
          QStringLiteral("/right_laser_2d/matched"),
          QStringLiteral("/matched_depth_points/forward"),
          QStringLiteral("/matched_depth_points/downward"),
          QStringLiteral("/matched_depth_points/upward"),
          QStringLiteral("/slam/state"),
          QStringLiteral("/planning_state"),
          QStringLiteral("/map/info"),
          QStringLiteral("/alerts"),
          QStringLiteral("/battery_state"),
          QStringLiteral("/detailed_battery_state"),
          QStringLiteral("/wheel_state"),
          QStringLiteral("/sensor_manager_state"),
          QStringLiteral("/nearby_robots"),
          QStringLiteral("/nearby_robot_footprints"),
          QStringLiteral("/landmarks"),
          QStringLiteral("/nearby_auto_doors"),
          QStringLiteral("/detected_pallets"),
          QStringLiteral("/detected_rack"),
          QStringLiteral("/global_positioning_state"),
          QStringLiteral("/constraint_list"),
          QStringLiteral("/vision_detected_objects"),
          QStringLiteral("/collected_barcode")};
}

}  // namespace mapwright::robot::axbot
