// Which topics of a ROS robot carry which kind of data: by the server's list, otherwise by the usual names.
// Pure. Source: docs/protocols/rosbridge.md; REP 105; the names of map_server, move_base, nav2, amcl,
// slam_toolbox.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "map/stream.h"

namespace mapwright::robot::ros {

/// Robots whose transforms are read at once.
inline constexpr std::size_t kMostRobots = 16;

/// Topics and services with longer names are ignored.
inline constexpr std::size_t kLongestTopicName = 256;

/// How to read the messages of a topic.
enum class Form {
  Grid,                // nav_msgs/OccupancyGrid; chosen: also that of a map_msgs/ProjectedMap
  GridPatch,           // map_msgs/OccupancyGridUpdate
  MapService,          // nav_msgs/GetMap: not a topic but a service
  Path,                // nav_msgs/Path
  PoseStamped,         // geometry_msgs/PoseStamped
  PoseArray,           // geometry_msgs/PoseArray
  PoseWithCovariance,  // geometry_msgs/PoseWithCovarianceStamped
  Odometry,            // nav_msgs/Odometry
  LaserScan,           // sensor_msgs/LaserScan, MultiEchoLaserScan
  PointCloud,          // sensor_msgs/PointCloud2, PointCloud
  Polygon,             // geometry_msgs/PolygonStamped
  Battery,             // sensor_msgs/BatteryState
  Markers,             // visualization_msgs/MarkerArray, Marker; what is drawn like them (drawnTypes())
  Tf,                  // tf2_msgs/TFMessage (tf/tfMessage of old)
  StaticTf,
};

/// A topic or service as listed by the server, with its type as the server writes it; empty: unknown.
struct Endpoint {
  std::string name, type;
  bool operator==(const Endpoint&) const = default;
};

/// A topic that carries a kind of data.
struct Source {
  map::Stream stream = map::Stream::Pose;
  Form form = Form::Grid;
  std::string topic;
  std::string type;    // as the server writes it; empty = unknown
  std::string base;    // of a patch: the topic of its grid; of a service: the topic that it replaces
  bool found = false;  // the server lists it
  bool operator==(const Source&) const = default;
};

/// All available sources, better ones of a stream first. Without a list of topics (nullopt: not available)
/// the usual names. Those below `ns` come first; topics of other robots (robotsBeside)
/// are left out.
std::vector<Source> sourcesOf(const std::optional<std::vector<Endpoint>>& found, const std::string& ns);

/// The namespaces of other robots than the one in `ns`: they lie beside it, and have transforms of their own,
/// or the same scan or odometry as `ns`. Without `ns`: none.
std::set<std::string> robotsBeside(const std::string& ns, const std::vector<Endpoint>& found);
/// The topic is below one of them.
bool isBelowAny(std::string_view topic, const std::set<std::string>& namespaces);

/// The namespaces with transforms of their own ("" for "/tf"): RobotTransforms::setNamespaces(). Those within
/// `ns` come first, then short ones.
std::vector<std::string> robotsIn(const std::vector<Source>& sources, const std::string& ns);

/// How a topic of that type is read if the user chooses it for `stream`; nullopt: impossible.
std::optional<Form> formFor(map::Stream stream, const std::string& type);
/// The topics of `found` that can be used for `stream`; by name.
std::vector<std::string> choicesFor(map::Stream stream, const std::vector<Endpoint>& found);
/// The user's choices by kind of data.
using Choices = std::map<map::Stream, std::string>;
/// Uses exactly the chosen topic for each kind of data. It is subscribed even if it does not exist or has the
/// wrong type: that may change.
void choose(std::vector<Source>& sources, const Choices& choices,
            const std::optional<std::vector<Endpoint>>& found);

/// The services whose names suggest that they provide a map (`names`), better ones first.
std::vector<std::string> likeMapServices(const std::vector<std::string>& names, const std::string& ns);
/// The usual ones, if services are not listed.
std::vector<std::string> usualMapServices(const std::string& ns);
/// Adds the services that provide the map on request, after all topics: `services` of type nav_msgs/GetMap.
void addMapServices(std::vector<Source>& sources, const std::vector<std::string>& services);

/// Those of one stream.
std::vector<Source> sourcesFor(map::Stream stream, const std::vector<Source>& all);

/// Whether data of this form has to be placed by transforms.
bool needsTransforms(Form form);

/// "map" of "/robot1/map".
std::string_view lastPart(std::string_view topic);
/// "/robot1/map" is below "/robot1"; nothing is below an empty namespace.
bool isBelow(std::string_view name, std::string_view ns);

}  // namespace mapwright::robot::ros
