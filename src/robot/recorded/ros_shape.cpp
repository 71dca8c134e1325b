#include "robot/recorded/ros_shape.h"

#include <algorithm>
#include <set>

#include "recorder/layout.h"
#include "robot/recorded/foxglove.h"
#include "robot/ros/ros_world.h"

namespace mapwright::robot::recorded {
namespace {

constexpr int kMostLookedAt = 2000;  // transforms at the start of a file
constexpr std::int64_t kLookNs = 3'000'000'000;
constexpr const char* kMap = "map";

bool answersWithMap(const std::string& type) {
  return type == "nav_msgs/GetMapResponse" || type == "nav_msgs/GetMap_Response" || type == "nav_msgs/GetMap";
}

void addOnce(std::vector<std::string>& topics, const std::string& topic) {
  if (std::find(topics.begin(), topics.end(), topic) == topics.end()) topics.push_back(topic);
}

/// More frequent ones are dynamic; less frequent ones stay valid until replaced.
constexpr double kOftenPerS = 0.5;

/// Foxglove's transforms may be on any topic, and stay valid until replaced. Poses and paths on any topic are
/// used if there is nothing better.
void addFoxglove(const recording::Source& file, const std::set<std::string>& others,
                 std::vector<ros::Source>& sources) {
  const recording::Summary summary = file.summary();
  // What a part says of the time before it does not tell how often the topic comes.
  std::map<std::string, std::uint64_t> count_of;
  for (const recording::ChannelPtr& channel : file.channels()) {
    const auto counted = summary.messages_of.find(channel->id);
    if (counted != summary.messages_of.end() && !channel->metadata.contains(recorder::kSaidAt))
      count_of[channel->topic] += counted->second;
  }
  const auto brought = [&](map::Stream stream, ros::Form form) {
    return std::any_of(sources.begin(), sources.end(), [&](const ros::Source& source) {
      return source.stream == stream && source.form == form;
    });
  };
  const bool poses =
      brought(map::Stream::Pose, ros::Form::PoseStamped) || brought(map::Stream::Pose, ros::Form::Odometry);
  for (const recording::ChannelPtr& channel : file.channels()) {
    const auto kind = foxgloveKind(*channel);
    if (!kind || ros::isBelowAny(channel->topic, others)) continue;
    const std::string type = rosTypeOf(*channel);
    const auto known = std::find_if(sources.begin(), sources.end(),
                                    [&](const ros::Source& one) { return one.topic == channel->topic; });
    if (*kind == FoxgloveKind::FrameTransform || *kind == FoxgloveKind::FrameTransforms) {
      const double length_s = double(summary.durationNs()) / 1e9;
      const bool seldom =
          channel->topic.find("static") != std::string::npos ||
          (summary.counted && length_s > 0 && double(count_of[channel->topic]) < kOftenPerS * length_s);
      const ros::Form form = seldom ? ros::Form::StaticTf : ros::Form::Tf;
      if (known != sources.end()) {
        known->form = form;
      } else {
        sources.push_back({map::Stream::Pose, form, channel->topic, type, {}, true});
      }
    } else if (known == sources.end() && *kind == FoxgloveKind::PoseInFrame && !poses &&
               !brought(map::Stream::Pose, ros::Form::PoseStamped)) {
      sources.push_back({map::Stream::Pose, ros::Form::PoseStamped, channel->topic, type, {}, true});
    } else if (known == sources.end() && *kind == FoxgloveKind::PosesInFrame &&
               !brought(map::Stream::Path, ros::Form::Path)) {
      sources.push_back({map::Stream::Path, ros::Form::Path, channel->topic, type, {}, true});
    }
  }
}

/// According to the recorder (recorder/layout.h, metadata "mapwright").
bool recordedOfRos(const recording::Source& file) {
  bool ros = false;
  for (const recording::Metadata& metadata : file.metadata()) {
    const auto kind = metadata.values.find("kind");
    if (metadata.name != recorder::kAbout || kind == metadata.values.end()) continue;
    ros = kind->second == "ros" || kind->second == "kabam" || kind->second == "aimdk";
  }
  return ros;
}

/// The frame of the first map; empty: there is none.
std::string mapFrame(recording::Source& file, MessageFields& fields, const RosShape& shape) {
  recording::Query query;
  for (const ros::Source& source : shape.sources) {
    const bool map = source.form == ros::Form::Grid || source.form == ros::Form::MapService;
    if (map && source.stream == map::Stream::WholeMap) query.topics.push_back(source.topic);
  }
  if (query.topics.empty()) return {};
  const auto cursor = file.messages(query);
  while (const auto message = cursor->next()) {
    const auto frame = fields.read(*message);
    if (!frame) continue;
    const ros::Field root = (*frame)->root(), map = root["map"];
    const std::string name = ros::frameName((map ? map : root)["header"]["frame_id"].text());
    if (!name.empty()) return name;
  }
  return {};
}

/// The transforms at its beginning.
ros::RosWorld firstTransforms(recording::Source& file, MessageFields& fields, const RosShape& shape) {
  ros::RosWorld world(shape.ns);
  world.setRobots(shape.robots);
  if (shape.transforms.empty()) return world;
  recording::Query query;
  query.topics = shape.transforms;
  const auto cursor = file.messages(query);
  std::int64_t first_ns = 0;
  for (int count = 0; count < kMostLookedAt; ++count) {
    const auto message = cursor->next();
    if (!message) break;
    if (count == 0) first_ns = message->log_time_ns;
    if (message->log_time_ns - first_ns > kLookNs) break;
    const auto frame = fields.read(*message);
    if (!frame) continue;
    for (const ros::Source& source : shape.by_topic.at(message->channel->topic))
      world.add(source, (*frame)->root(), recording::secondsOf(message->log_time_ns));
  }
  return world;
}

/// The root of the robot's frames; empty: transforms do not tell.
std::string rootFrame(const ros::RosWorld& world) {
  const std::vector<std::string> frames = world.transforms().frames();
  if (std::binary_search(frames.begin(), frames.end(), std::string(kMap))) return kMap;
  const std::string robot = world.robotFrame();
  for (const std::string& root : world.transforms().roots()) {
    if (!robot.empty() && root != robot && world.transforms().find(root, robot, {})) return root;
  }
  return {};
}

/// The frame of the first scan or cloud; empty: there is none.
std::string frameOfFirstScan(recording::Source& file, MessageFields& fields, const RosShape& shape,
                             const ros::RosWorld& world) {
  recording::Query query;
  for (const ros::Source& source : shape.sources) {
    if (source.stream == map::Stream::Cloud) query.topics.push_back(source.topic);
  }
  if (query.topics.empty()) return {};
  const auto cursor = file.messages(query);
  for (int count = 0; count < kMostLookedAt; ++count) {
    const auto message = cursor->next();
    if (!message) break;
    const auto frame = fields.read(*message);
    if (!frame) continue;
    const std::string name = ros::frameName((*frame)->root()["header"]["frame_id"].text());
    if (!name.empty()) return world.ownFrameOf(name);
  }
  return {};
}

}  // namespace

RosShape shapeOf(recording::Source& file, MessageFields& fields, const ros::Choices& choices,
                 const std::string& ns) {
  RosShape shape;
  shape.ns = ns;
  std::vector<ros::Endpoint> found;
  std::vector<std::string> services;
  shape.untyped_ros = recordedOfRos(file);
  std::set<std::string> untyped;
  std::set<std::pair<std::string, std::string>> known;  // there may be many thousands
  const recording::Summary summary = file.summary();
  for (const recording::ChannelPtr& channel : file.channels()) {
    if (!shape.isRos(*channel)) continue;
    // A topic without a message makes no robot.
    if (summary.counted && !summary.messages_of.contains(channel->id) &&
        ros::plainType(rosTypeOf(*channel)) == "tf2_msgs/TFMessage")
      continue;
    if (isUntyped(*channel)) untyped.insert(channel->topic);
    const ros::Endpoint topic{channel->topic, rosTypeOf(*channel)};
    if (!known.emplace(topic.name, topic.type).second) continue;
    if (answersWithMap(ros::plainType(topic.type))) addOnce(services, topic.name);
    found.push_back(topic);
  }
  if (found.empty()) return shape;
  shape.sources = ros::sourcesOf(found, ns);
  addFoxglove(file, ros::robotsBeside(ns, found), shape.sources);
  for (ros::Source& usual : ros::sourcesOf(std::nullopt, ns)) {
    if (untyped.contains(usual.topic)) shape.sources.push_back(std::move(usual));
  }
  ros::choose(shape.sources, choices, found);
  if (!choices.contains(map::Stream::WholeMap)) ros::addMapServices(shape.sources, services);
  shape.found = std::move(found);
  for (const ros::Source& source : shape.sources) {
    shape.by_topic[source.topic].push_back(source);
    switch (source.form) {
      case ros::Form::StaticTf:
        addOnce(shape.statics, source.topic);
        [[fallthrough]];
      case ros::Form::Tf:
        addOnce(shape.transforms, source.topic);
        break;
      case ros::Form::Markers:
        addOnce(shape.markers, source.topic);
        break;
      case ros::Form::GridPatch:
        shape.patches_of[source.base] = source.topic;
        break;
      default:
        if (source.stream == map::Stream::Pose) addOnce(shape.poses, source.topic);
        break;
    }
  }
  shape.robots = ros::robotsIn(shape.sources, ns);
  if (shape.robots.size() > 1) {
    // The same throughout the file, whatever a part of it tells.
    const ros::RosWorld world = firstTransforms(file, fields, shape);
    shape.root_serves = world.rootServesAll();
    const std::string shown = ns.empty() ? world.shownRobot() : shape.robots.front();
    std::stable_partition(shape.robots.begin(), shape.robots.end(),
                          [&](const std::string& robot) { return robot == shown; });
  }
  shape.fixed_frame = mapFrame(file, fields, shape);
  if (shape.fixed_frame.empty()) {
    const ros::RosWorld world = firstTransforms(file, fields, shape);
    shape.fixed_frame = rootFrame(world);
    if (shape.fixed_frame.empty()) {
      shape.fixed_frame = frameOfFirstScan(file, fields, shape, world);
      shape.own_frame = !shape.fixed_frame.empty();
    }
  }
  shape.fixed_by_file = !shape.fixed_frame.empty();
  if (!shape.fixed_by_file) shape.fixed_frame = kMap;
  return shape;
}

std::vector<std::string> robotNames(recording::Source& file, MessageFields& fields, const RosShape& shape) {
  std::set<std::string> names;
  for (const std::string& robot : ros::robotsIn(ros::sourcesOf(shape.found, {}), {}))
    names.insert(robot.empty() ? "/" : robot);
  if (names.size() < 2) {
    names.clear();
    for (const std::string& frame : firstTransforms(file, fields, shape).transforms().frames()) {
      const std::size_t end = frame.rfind('/');
      const std::string name = frame.substr(end == std::string::npos ? 0 : end + 1);
      if (name == "base_link" || name == "base_footprint")
        names.insert('/' + frame.substr(0, end == std::string::npos ? 0 : end));
    }
  }
  if (names.size() < 2) names.clear();
  return {names.begin(), names.end()};
}

}  // namespace mapwright::robot::recorded
