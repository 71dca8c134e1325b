// The ROS messages that show something on a map, as values in their own frame. Member names are those of ROS
// 1 and ROS 2, which agree for everything that is read here. Source: nav_msgs, map_msgs, geometry_msgs,
// sensor_msgs, tf2_msgs, visualization_msgs; rosbridge v2 ("JSON details": NaN and infinities arrive as
// null).
// Pure; any thread. Messages are untrusted: missing or absurd values give a Fault that names the field, sizes
// are checked before memory is allocated, texts are plain and untrusted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "geometry/pose.h"
#include "map/live_topics.h"
#include "net/rosbridge/field.h"
#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

using net::rosbridge::Field;

template <class T>
using Read = tl::expected<T, Fault>;

/// std_msgs/Header. The frame without a leading slash, empty if there is none. A stamp of 0 counts as none:
/// in ROS it means "the latest".
struct Header {
  std::string frame;
  std::optional<double> stamp_s;
};

/// nav_msgs/OccupancyGrid. `origin`: pose of the outer corner of cell (0, 0), which is the lower left one.
struct Grid {
  Header header;
  int width = 0, height = 0;       // at least 1
  double resolution_m = 0;         // usable (map::unusableReason)
  geometry::Pose2 origin;          // usable
  std::vector<std::int8_t> cells;  // row 0 = bottom, as sent; -1 unknown, 0..100
  std::vector<Fault> notes;        // what is odd about it
};

/// map_msgs/OccupancyGridUpdate: a rectangle of an earlier grid, starting at the cell (x, y).
struct GridPatch {
  Header header;
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<std::int8_t> cells;
  std::vector<Fault> notes;
};

/// A pose in the plane.
struct Placed {
  Header header;
  geometry::Pose2 pose;
  bool upright = false;     // its quaternion was zero or not a number; the yaw is 0
  std::string child_frame;  // of nav_msgs/Odometry: the frame of the pose; otherwise empty
};

/// Poses in the plane with a common header.
struct Poses {
  Header header;
  std::vector<geometry::Pose2> poses;  // at most kMostPoses
};
inline constexpr std::size_t kMostPoses = 10'000;

/// A cloud or a scan.
struct Points {
  Header header;
  std::vector<map::CloudPoint> points;  // at most kMostPoints
  std::size_t left_out = 0;             // not a number, out of range, absurdly far away
  std::vector<Fault> notes;             // that it was thinned
  /// For a scan taken over some time: its duration, and the time of each point (0..1 of it). The stamp is
  /// that of its beginning. 0 and empty: all at once.
  double sweep_s = 0;
  std::vector<float> when;
};
inline constexpr std::size_t kMostPoints = 2'000'000;

/// A line or an outline, thinned beyond kMostOutlinePoints.
struct Outline {
  Header header;
  map::Polyline points;
  std::size_t left_out = 0;  // points that were not numbers
};
inline constexpr std::size_t kMostOutlinePoints = 100'000;

/// visualization_msgs/Marker.
struct Marker {
  enum class Kind {
    Arrow,
    Cube,
    Sphere,
    Cylinder,
    LineStrip,
    LineList,
    CubeList,
    SphereList,
    Points,
    Text,
    Triangles,
    Mesh,  // a file elsewhere: only its place is known
    Other
  };
  enum class Action { Add, Delete, DeleteAll };
  Header header;
  std::string ns;
  std::int64_t id = 0;
  Kind kind = Kind::Other;
  Action action = Action::Add;
  Transform3 pose;                   // of the marker in its frame
  bool upright = false;              // its quaternion was zero or not a number
  Eigen::Vector3d scale_m{1, 1, 1};  // size along its axes; for lines x is the width, for a text z the height
  std::uint32_t rgba = 0xffffffff;   // 0xRRGGBBAA
  std::vector<Eigen::Vector3d> points;  // in the marker's own coordinates
  std::vector<std::uint32_t> colors;    // one per point, or none
  bool frame_locked = false;            // it moves with its frame; otherwise it stays where it was placed
  std::string text;
  double lifetime_s = 0;  // 0 = forever
};

/// A row of tf2_msgs/TFMessage.
struct TfRow {
  std::string parent, child;
  Transform3 transform;  // as sent: Transforms rejects invalid ones
  double stamp_s = 0;
};

Read<Grid> readGrid(const Field& msg);
Read<GridPatch> readGridPatch(const Field& msg);
/// Applies the patch to the grid. If it does not lie completely inside: the error, and the grid is unchanged.
std::optional<Fault> applyPatch(Grid& grid, const GridPatch& patch);

/// nav_msgs/Path. Without a frame of its own it uses that of its first pose.
Read<Outline> readPath(const Field& msg);
/// geometry_msgs/PolygonStamped.
Read<Outline> readPolygon(const Field& msg);

/// geometry_msgs/PoseStamped, PoseWithCovarianceStamped and nav_msgs/Odometry.
Read<Placed> readPoseStamped(const Field& msg);
Read<Placed> readPoseWithCovariance(const Field& msg);
Read<Placed> readOdometry(const Field& msg);
/// geometry_msgs/PoseArray. If there are too many, each n-th; poses without numbers are skipped.
Read<Poses> readPoseArray(const Field& msg);

/// sensor_msgs/LaserScan: the ends of rays that hit something, z = 0. A range_max that is not a number or not
/// above range_min is ignored. With a time_increment the points have times (Points::when).
Read<Points> readLaserScan(const Field& msg);
/// sensor_msgs/MultiEchoLaserScan: every echo.
Read<Points> readMultiEchoScan(const Field& msg);
/// sensor_msgs/PointCloud, with its channel "intensity" or "intensities".
Read<Points> readPointCloud1(const Field& msg);
/// sensor_msgs/PointCloud2: x, y, z and intensity, of any type at any offset; colours are ignored.
Read<Points> readPointCloud2(const Field& msg);

/// visualization_msgs/MarkerArray, or a single Marker. Markers without readable numbers are skipped.
/// `left_out`: how many of them, or of too many, or without some of their points.
Read<std::vector<Marker>> readMarkers(const Field& msg, std::int64_t* left_out = nullptr);

/// tf2_msgs/TFMessage. Entries without frame names are skipped.
std::vector<TfRow> readTf(const Field& msg);

/// The type without its ROS version: "nav_msgs/msg/OccupancyGrid" (ROS 2) and "nav_msgs/OccupancyGrid" (ROS
/// 1) both give the latter.
std::string plainType(std::string_view type);

}  // namespace mapwright::robot::ros
