#include "robot/ros/ros_topics.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "robot/ros/drawn_messages.h"
#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {
namespace {

using map::Stream;

constexpr std::size_t kMostDrawnTopics = 32;  // topics of a type

/// Which topics of a type carry a stream.
struct Rule {
  Stream stream;
  Form form;
  const char* type;
  const char* tails;       // their ends, in whole parts; better ones first
  const char* usual = "";  // names to try if topics are not listed
  bool any = false;        // any other topic of the type is possible, too
  std::size_t most = 1;
  const char* never = nullptr;  // a part of names with another meaning
};
constexpr const char* kRawCostmap = "nav2_msgs/Costmap";
constexpr Rule kRules[] = {
    {Stream::WholeMap, Form::Grid, "nav_msgs/OccupancyGrid", "map", "/map", true, 1, "costmap"},
    {Stream::CostmapLow, Form::Grid, "nav_msgs/OccupancyGrid", "global_costmap/costmap",
     "/global_costmap/costmap /move_base/global_costmap/costmap"},
    {Stream::CostmapHigh, Form::Grid, "nav_msgs/OccupancyGrid", "local_costmap/costmap",
     "/local_costmap/costmap /move_base/local_costmap/costmap"},
    // As Nav2 keeps them, where they do not come as grids.
    {Stream::CostmapLow, Form::Grid, kRawCostmap, "global_costmap/costmap_raw global_costmap/costmap"},
    {Stream::CostmapHigh, Form::Grid, kRawCostmap, "local_costmap/costmap_raw local_costmap/costmap"},
    {Stream::Path, Form::Path, "nav_msgs/Path", "plan global_plan path", "/plan /move_base/NavfnROS/plan",
     true, 1, "local"},
    {Stream::LocalPath, Form::Path, "nav_msgs/Path", "local_plan local_path", "/local_plan"},
    {Stream::Cloud, Form::LaserScan, "sensor_msgs/LaserScan", "scan", "/scan", true, 4},
    {Stream::Cloud, Form::PointCloud, "sensor_msgs/PointCloud2", "points cloud scan_matched_points2",
     "/points", true, 2, "costmap"},
    {Stream::Cloud, Form::LaserScan, "sensor_msgs/MultiEchoLaserScan", "scan", "", true, 2},
    {Stream::Cloud, Form::PointCloud, "sensor_msgs/PointCloud", "points cloud", "", true, 2, "costmap"},
    {Stream::Pose, Form::Tf, "tf2_msgs/TFMessage", "tf", "/tf", false, kMostRobots},
    {Stream::Pose, Form::Tf, "tf/tfMessage", "tf", "", false, kMostRobots},
    {Stream::Pose, Form::StaticTf, "tf2_msgs/TFMessage", "tf_static", "/tf_static", false, kMostRobots},
    {Stream::Pose, Form::PoseWithCovariance, "geometry_msgs/PoseWithCovarianceStamped", "amcl_pose pose",
     "/amcl_pose"},
    {Stream::Pose, Form::PoseStamped, "geometry_msgs/PoseStamped", "tracked_pose robot_pose"},
    {Stream::Pose, Form::Odometry, "nav_msgs/Odometry", "odom", "/odom"},
    {Stream::Model, Form::Polygon, "geometry_msgs/PolygonStamped",
     "local_costmap/published_footprint local_costmap/footprint published_footprint footprint",
     "/local_costmap/published_footprint /move_base/local_costmap/footprint"},
    {Stream::Planning, Form::PoseStamped, "geometry_msgs/PoseStamped",
     "current_goal goal_pose move_base_simple/goal",
     "/goal_pose /move_base/current_goal /move_base_simple/goal"},
    {Stream::SeenObjects, Form::Markers, "visualization_msgs/MarkerArray",
     "markers objects visualization_marker_array marker_array", "", true, kMostDrawnTopics},
    {Stream::SeenObjects, Form::Markers, "visualization_msgs/Marker", "visualization_marker marker", "", true,
     kMostDrawnTopics},
    {Stream::Battery, Form::Battery, "sensor_msgs/BatteryState", "battery_state battery", "/battery_state",
     true},
};

/// The names in a text, separated by blanks.
std::vector<std::string> namesIn(const char* text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

bool endsWith(std::string_view topic, std::string_view tail) {
  if (!topic.ends_with(tail)) return false;
  return topic.size() == tail.size() || topic[topic.size() - tail.size() - 1] == '/';
}

/// The patches of a grid; if topics are not listed, they may exist.
std::optional<Source> patchesOf(const Source& grid, const std::optional<std::vector<Endpoint>>& found) {
  Source patch{grid.stream, Form::GridPatch, grid.topic + "_updates", {}, grid.topic, false};
  if (!found) return patch;
  for (const Endpoint& one : *found) {
    if (one.name != patch.topic || plainType(one.type) != "map_msgs/OccupancyGridUpdate") continue;
    patch.type = one.type;
    patch.found = true;
    return patch;
  }
  return std::nullopt;
}

void addGrids(std::vector<Source>& sources, Source source,
              const std::optional<std::vector<Endpoint>>& found) {
  const bool grid = source.form == Form::Grid;
  sources.push_back(std::move(source));
  if (!grid) return;
  if (auto patches = patchesOf(sources.back(), found)) sources.push_back(std::move(*patches));
}

std::vector<Source> usualSources(const std::string& ns) {
  std::vector<Source> sources;
  for (const Rule& rule : kRules) {
    // Shared topics have the same name for all robots.
    const bool shared =
        rule.form == Form::Tf || rule.form == Form::StaticTf || rule.stream == Stream::WholeMap;
    for (const std::string& topic : namesIn(rule.usual)) {
      if (!ns.empty()) addGrids(sources, {rule.stream, rule.form, ns + topic, {}, {}, false}, {});
      if (ns.empty() || shared) addGrids(sources, {rule.stream, rule.form, topic, {}, {}, false}, {});
    }
  }
  return sources;
}

}  // namespace

std::string_view lastPart(std::string_view topic) { return topic.substr(topic.rfind('/') + 1); }

bool isBelow(std::string_view name, std::string_view ns) {
  return !ns.empty() && name.size() > ns.size() && name.starts_with(ns) && name[ns.size()] == '/';
}

bool needsTransforms(Form form) {
  return form != Form::Tf && form != Form::StaticTf && form != Form::Battery;
}

std::set<std::string> robotsBeside(const std::string& ns, const std::vector<Endpoint>& found) {
  const auto isTransform = [](const std::string& type) {
    return type == "tf2_msgs/TFMessage" || type == "tf/tfMessage";
  };
  const auto isSensor = [](const std::string& type) {
    return type == "sensor_msgs/LaserScan" || type == "nav_msgs/Odometry";
  };
  std::set<std::string> robots;
  if (ns.empty()) return robots;
  const auto add = [&](const std::string& robot) {
    const bool beside = robot != ns && !isBelow(robot, ns) && !isBelow(ns, robot);
    if (!robot.empty() && beside) robots.insert(robot);
  };
  const auto depth = std::count(ns.begin(), ns.end(), '/');
  std::set<std::pair<std::string, std::string>> own;  // below `ns`, without it
  bool is_robot = false;                              // not that of a map dispatcher
  for (const Endpoint& one : found) {
    if (!isBelow(one.name, ns)) continue;
    const std::string type = plainType(one.type);
    is_robot |= isTransform(type) || isSensor(type) || type == "sensor_msgs/PointCloud2";
    own.insert({one.name.substr(ns.size()), one.type});
  }
  if (!is_robot) return robots;
  for (const Endpoint& one : found) {
    const std::string type = plainType(one.type);
    if (isTransform(type) && lastPart(one.name) == "tf") add(one.name.substr(0, one.name.rfind('/')));
    if (!isSensor(type)) continue;
    std::size_t end = one.name.find('/');
    for (auto parts = depth; parts > 0 && end != std::string::npos; --parts)
      end = one.name.find('/', end + 1);
    if (end != std::string::npos && own.contains({one.name.substr(end), one.type}))
      add(one.name.substr(0, end));
  }
  return robots;
}

bool isBelowAny(std::string_view topic, const std::set<std::string>& namespaces) {
  if (namespaces.empty()) return false;
  for (std::size_t end = topic.rfind('/'); end != std::string_view::npos && end > 0;
       end = topic.rfind('/', end - 1)) {
    if (namespaces.contains(std::string(topic.substr(0, end)))) return true;
  }
  return false;
}

std::vector<std::string> robotsIn(const std::vector<Source>& sources, const std::string& ns) {
  std::vector<std::string> robots;
  for (const Source& source : sources) {
    if (source.form != Form::Tf || lastPart(source.topic) != "tf") continue;
    std::string robot = source.topic.substr(0, source.topic.rfind('/'));
    if (std::find(robots.begin(), robots.end(), robot) == robots.end()) robots.push_back(std::move(robot));
  }
  std::sort(robots.begin(), robots.end(), [&](const std::string& a, const std::string& b) {
    const auto rank = [&](const std::string& robot) {
      return std::tuple(!isBelow(robot + '/', ns), robot.size(), robot);
    };
    return rank(a) < rank(b);
  });
  return robots;
}

namespace {

/// What no other layer shows is drawn like markers: paths and outlines of any name, lists of poses. Where a
/// robot may be (PoseWithCovarianceStamped) is shown beside its pose.
void addDrawn(std::vector<Source>& sources, std::vector<Endpoint> found) {
  std::sort(found.begin(), found.end(), [](const Endpoint& a, const Endpoint& b) { return a.name < b.name; });
  std::map<std::string, std::size_t> count;  // by type
  for (const Endpoint& topic : found) {
    const std::string type = plainType(topic.type);
    if (!isDrawn(type) || topic.name.size() > kLongestTopicName) continue;
    // The same outline of the robot, as other nodes see it; and where people tell the robot to be.
    if (type == "geometry_msgs/PolygonStamped" && topic.name.ends_with("footprint")) continue;
    if (lastPart(topic.name) == "initialpose") continue;
    const bool shown = type != "geometry_msgs/PoseWithCovarianceStamped" &&
                       std::any_of(sources.begin(), sources.end(),
                                   [&](const Source& source) { return source.topic == topic.name; });
    if (shown || ++count[type] > kMostDrawnTopics) continue;
    sources.push_back({Stream::SeenObjects, Form::Markers, topic.name, topic.type, {}, true});
  }
}

/// One robot has one topic of each kind of transforms: others are copies, or of a robot that is gone.
void keepOneRobot(std::vector<Source>& sources) {
  if (robotsIn(sources, {}).size() > 1) return;
  std::set<std::pair<Form, std::string>> kinds;
  std::erase_if(sources, [&](const Source& source) {
    const bool transforms = source.form == Form::Tf || source.form == Form::StaticTf;
    return transforms && !kinds.insert({source.form, plainType(source.type)}).second;
  });
}

}  // namespace

std::vector<Source> sourcesOf(const std::optional<std::vector<Endpoint>>& found, const std::string& ns) {
  if (!found) return usualSources(ns);
  const std::set<std::string> others = robotsBeside(ns, *found);
  std::vector<Source> sources;
  for (const Rule& rule : kRules) {
    const bool brought = std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
      return source.stream == rule.stream && source.form == Form::Grid;
    });
    if (rule.type == std::string_view(kRawCostmap) && brought) continue;
    using Rank = std::tuple<bool, std::size_t, std::size_t, std::string_view>;
    const std::vector<std::string> tails = namesIn(rule.tails);
    std::vector<std::pair<Rank, const Endpoint*>> fitting;
    for (const Endpoint& topic : *found) {
      if (plainType(topic.type) != rule.type || topic.name.size() > kLongestTopicName) continue;
      if (isBelowAny(topic.name, others)) continue;
      if (rule.never && topic.name.find(rule.never) != std::string::npos) continue;
      std::size_t rank = 0;
      while (rank < tails.size() && !endsWith(topic.name, tails[rank])) ++rank;
      if (rank == tails.size() && !rule.any) continue;
      fitting.push_back({{!isBelow(topic.name, ns), rank, topic.name.size(), topic.name}, &topic});
    }
    std::sort(fitting.begin(), fitting.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < fitting.size() && i < rule.most; ++i)
      addGrids(sources, {rule.stream, rule.form, fitting[i].second->name, fitting[i].second->type, {}, true},
               found);
  }
  keepOneRobot(sources);
  std::vector<Endpoint> own;
  std::copy_if(found->begin(), found->end(), std::back_inserter(own),
               [&](const Endpoint& topic) { return !isBelowAny(topic.name, others); });
  addDrawn(sources, std::move(own));
  return sources;
}

std::optional<Form> formFor(Stream stream, const std::string& type) {
  const std::string plain = plainType(type);
  switch (stream) {
    case Stream::WholeMap:
    case Stream::CostmapLow:
    case Stream::CostmapHigh:
      if (plain == "nav_msgs/OccupancyGrid" || plain == "map_msgs/ProjectedMap" || plain == kRawCostmap)
        return Form::Grid;
      break;
    case Stream::Path:
    case Stream::LocalPath:
      if (plain == "nav_msgs/Path") return Form::Path;
      break;
    case Stream::Planning:
      if (plain == "geometry_msgs/PoseStamped") return Form::PoseStamped;
      if (plain == "geometry_msgs/PoseArray") return Form::PoseArray;
      if (plain == "geometry_msgs/PoseWithCovarianceStamped") return Form::PoseWithCovariance;
      break;
    default:
      break;
  }
  return std::nullopt;
}

std::vector<std::string> choicesFor(Stream stream, const std::vector<Endpoint>& found) {
  std::set<std::string> fitting;
  for (const Endpoint& topic : found) {
    if (topic.name.size() <= kLongestTopicName && formFor(stream, topic.type)) fitting.insert(topic.name);
  }
  return {fitting.begin(), fitting.end()};
}

void choose(std::vector<Source>& sources, const Choices& choices,
            const std::optional<std::vector<Endpoint>>& found) {
  for (const auto& [stream, topic] : choices) {
    // The most common form of this kind, until the type is known.
    Source chosen{stream, Form::PoseStamped, topic, {}, {}, false};
    for (const char* const usual : {"nav_msgs/OccupancyGrid", "nav_msgs/Path", "geometry_msgs/PoseStamped"}) {
      if (const auto form = formFor(stream, usual)) chosen.form = *form;
    }
    for (const Endpoint& one : found ? *found : std::vector<Endpoint>()) {
      const auto form = one.name == topic ? formFor(stream, one.type) : std::nullopt;
      if (!form) continue;
      chosen.form = *form;
      chosen.type = one.type;
      chosen.found = true;
    }
    // By name: clang 14 captures no structured binding.
    std::erase_if(sources, [stream = stream, &topic = topic](const Source& source) {
      return source.stream == stream || (source.stream == Stream::SeenObjects && source.topic == topic &&
                                         isDrawn(plainType(source.type)));
    });
    addGrids(sources, std::move(chosen), found);
  }
}

std::vector<std::string> usualMapServices(const std::string& ns) {
  std::vector<std::string> names = namesIn("/static_map /map_server/map /dynamic_map");
  if (ns.empty()) return names;
  std::vector<std::string> own;
  for (const std::string& name : names) own.push_back(ns + name);
  own.insert(own.end(), names.begin(), names.end());
  return own;
}

std::vector<std::string> likeMapServices(const std::vector<std::string>& names, const std::string& ns) {
  constexpr std::size_t kMost = 6;
  constexpr std::string_view kTails[] = {"static_map", "map_server/map", "dynamic_map", "map", "get_map"};
  using Rank = std::tuple<bool, std::size_t, std::size_t, std::string_view>;
  std::vector<std::pair<Rank, std::string>> fitting;
  for (const std::string& name : names) {
    if (name.size() > kLongestTopicName) continue;
    std::size_t rank = 0;
    while (rank < std::size(kTails) && !endsWith(name, kTails[rank])) ++rank;
    if (rank < std::size(kTails)) fitting.push_back({{!isBelow(name, ns), rank, name.size(), name}, name});
  }
  std::sort(fitting.begin(), fitting.end());
  std::vector<std::string> like;
  for (std::size_t i = 0; i < fitting.size() && i < kMost; ++i) like.push_back(fitting[i].second);
  return like;
}

void addMapServices(std::vector<Source>& sources, const std::vector<std::string>& services) {
  const auto topic = std::find_if(sources.begin(), sources.end(), [](const Source& source) {
    return source.stream == Stream::WholeMap && source.form == Form::Grid;
  });
  const std::string base = topic == sources.end() ? std::string() : topic->topic;
  for (const std::string& service : services)
    sources.push_back({Stream::WholeMap, Form::MapService, service, {}, base, true});
}

std::vector<Source> sourcesFor(map::Stream stream, const std::vector<Source>& all) {
  std::vector<Source> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const Source& source) { return source.stream == stream; });
  return some;
}

}  // namespace mapwright::robot::ros
