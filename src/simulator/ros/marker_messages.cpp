// Markers as planners and operators' tools draw them: one of each common kind.
#include "simulator/ros/ros_messages.h"
#include "simulator/ros/shapes.h"

namespace mapwright::simulator::ros {
namespace {

enum MarkerType {
  kArrow = 0,
  kCube = 1,
  kSphere = 2,
  kCylinder = 3,
  kLineStrip = 4,
  kPointList = 8,
  kTextFacing = 9
};
constexpr std::size_t kMostNamed = 200;

Value colour(double r, double g, double b, double a) {
  return Value::Object{{"r", float32(r)}, {"g", float32(g)}, {"b", float32(b)}, {"a", float32(a)}};
}

Value marker(const Moment& moment, std::string_view ns, std::size_t id, MarkerType type, Value pose,
             Value scale) {
  const Value duration = moment.dialect() == RosDialect::Ros1 ? Value::Object{{"secs", 0}, {"nsecs", 0}}
                                                              : Value::Object{{"sec", 0}, {"nanosec", 0}};
  return Value::Object{{"header", headerOf("map", moment.time_s, moment.dialect())},
                       {"ns", ns},
                       {"id", id},
                       {"type", static_cast<int>(type)},
                       {"action", 0},
                       {"pose", std::move(pose)},
                       {"scale", std::move(scale)},
                       {"color", colour(0.1, 0.5, 0.9, 0.8)},
                       {"lifetime", duration},
                       {"frame_locked", false},
                       {"points", Value::List{}},
                       {"colors", Value::List{}},
                       {"text", ""},
                       {"mesh_resource", ""},
                       {"mesh_use_embedded_materials", false}};
}

}  // namespace

Value markersMessage(const Moment& moment, const std::optional<KabamMap>& map) {
  Value::List markers;
  if (map) {
    for (std::size_t i = 0; i < std::min(map->waypoints.size(), kMostNamed); ++i) {
      const KabamWaypoint& waypoint = map->waypoints[i];
      markers.push_back(marker(moment, "waypoints", 2 * i, kArrow, waypoint.pose, xyz(0.6, 0.1, 0.1)));
      Value text = marker(moment, "waypoints", 2 * i + 1, kTextFacing, waypoint.pose, xyz(0, 0, 0.3));
      text.set("text", waypoint.name);
      markers.push_back(std::move(text));
    }
  }
  Value trail = marker(moment, "plan", 0, kLineStrip, poseOf(geometry::Pose2{}), xyz(0.05, 0, 0));
  Value dots = marker(moment, "plan", 1, kPointList, poseOf(geometry::Pose2{}), xyz(0.1, 0.1, 0));
  Value::List points;
  for (double s = 0; s <= 6; s += 0.5) {
    const geometry::Pose2 at = moment.robot.poseAhead(s);
    points.push_back(xyz(at.x_m, at.y_m, 0));
  }
  const Value ahead = poseOf(moment.robot.poseAhead(6));
  Value label = marker(moment, "plan", 3, kTextFacing, ahead, xyz(0, 0, 0.3));
  label.set("text", "6 m ahead");
  markers.push_back(marker(moment, "plan", 2, kArrow, ahead, xyz(0.6, 0.1, 0.1)));
  markers.push_back(std::move(label));
  trail.set("points", points);
  dots.set("points", points);
  markers.push_back(std::move(trail));
  markers.push_back(std::move(dots));
  const geometry::Pose2 beside = moment.pose * geometry::Pose2{1.5, 1, 0.4};
  markers.push_back(marker(moment, "people", 0, kCylinder, poseOf(beside, 0.85), xyz(0.5, 0.5, 1.7)));
  markers.push_back(marker(moment, "people", 1, kSphere, poseOf(beside, 1.8), xyz(0.3, 0.3, 0.3)));
  const geometry::Pose2 behind = moment.pose * geometry::Pose2{-1.5, -0.5, 0.2};
  markers.push_back(marker(moment, "crates", 0, kCube, poseOf(behind, 0.3), xyz(0.6, 0.4, 0.6)));
  return Value::Object{{"markers", std::move(markers)}};
}

}  // namespace mapwright::simulator::ros
