// Which topics of a ROS robot bring which kind of data: by what the server says of them, else by their usual
// names. Pure. Source: docs/protocols/rosbridge.md; REP 105; the names of map_server, move_base, nav2, amcl,
// slam_toolbox.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "map/stream.h"

namespace mapwright::robot::ros {

/// Topics and services with longer names are passed over.
inline constexpr std::size_t kLongestTopicName = 256;

/// What a message of a topic is read as.
enum class Form {
  Grid,                // nav_msgs/OccupancyGrid; chosen: also that of a map_msgs/ProjectedMap
  GridPatch,           // map_msgs/OccupancyGridUpdate
  MapService,          // nav_msgs/GetMap: no topic, but a service that is asked
  Path,                // nav_msgs/Path
  PoseStamped,         // geometry_msgs/PoseStamped
  PoseArray,           // geometry_msgs/PoseArray
  PoseWithCovariance,  // geometry_msgs/PoseWithCovarianceStamped
  Odometry,            // nav_msgs/Odometry
  LaserScan,           // sensor_msgs/LaserScan
  PointCloud,          // sensor_msgs/PointCloud2
  Polygon,             // geometry_msgs/PolygonStamped
  Battery,             // sensor_msgs/BatteryState
  Markers,             // visualization_msgs/MarkerArray
  Tf,                  // tf2_msgs/TFMessage (tf/tfMessage of old)
  StaticTf,
};

/// A topic as the server tells of it; an empty type is one that it does not know.
struct FoundTopic {
  std::string name, type;
  bool operator==(const FoundTopic&) const = default;
};

/// A topic that brings a kind of data.
struct Source {
  map::Stream stream = map::Stream::Pose;
  Form form = Form::Grid;
  std::string topic;
  std::string type;  // as the server writes it; empty = not known, or not asked
  std::string base;  // of a patch: the topic of the grid that it changes; of a service: that it stands in for
  bool found = false;  // the server says that it is there
  bool operator==(const Source&) const = default;
};

/// Every source that there is, the better ones of a stream first. Without a list of topics (nullopt: the
/// server does not tell) the usual names. What lies below `ns` goes before all else.
std::vector<Source> sourcesOf(const std::optional<std::vector<FoundTopic>>& found, const std::string& ns);

/// How a topic of that type is read for `stream` where people choose it; nullopt: it cannot be.
std::optional<Form> formFor(map::Stream stream, const std::string& type);
/// Every topic of `found` that `stream` can be taken from; by name.
std::vector<std::string> choicesFor(map::Stream stream, const std::vector<FoundTopic>& found);
/// What people have chosen, by the kind of data.
using Choices = std::map<map::Stream, std::string>;
/// Takes each chosen kind of data from its topic and no other. One that is not there, or of no type that
/// fits, is asked for all the same: it may come.
void choose(std::vector<Source>& sources, const Choices& choices,
            const std::optional<std::vector<FoundTopic>>& found);

/// The services that are called like those that give a map (`names`), the better ones first.
std::vector<std::string> likeMapServices(const std::vector<std::string>& names, const std::string& ns);
/// The usual ones, where nobody says what there is.
std::vector<std::string> usualMapServices(const std::string& ns);
/// What gives the map when asked, after all that brings it: `services` of type nav_msgs/GetMap.
void addMapServices(std::vector<Source>& sources, const std::vector<std::string>& services);

/// Those of one stream.
std::vector<Source> sourcesFor(map::Stream stream, const std::vector<Source>& all);

/// Whether what comes by this form has to be placed by transforms.
bool needsTransforms(Form form);

/// "map" of "/robot1/map".
std::string_view lastPart(std::string_view topic);

}  // namespace mapwright::robot::ros
