// The dialect of the simulated ROS robot, and its faults (docs/protocols/rosbridge.md,
// docs/protocols/kabam-map-manager.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mapwright::simulator {

/// The ROS version of types, times and headers.
enum class RosDialect {
  Ros1,  // pkg/Type, secs and nsecs, headers count in seq
  Ros2   // pkg/msg/Type, sec and nanosec
};

/// How the server writes JSON.
enum class RosWriter {
  Escaped,  // no blanks, "\/" and "\u00e9"
  Spaced,   // blanks behind commas and colons, "/" and "\u00e9"
  Plain     // no blanks, "/" and UTF-8
};

/// A map dispatcher next to the robot, with a building of five storeys
/// (docs/protocols/rep130-map-dispatcher.md). Nobody publishes the map as a topic then.
struct DispatcherOptions {
  bool there = false;
  double edge_m = 1000;       // of the building, whole metres 10..2000: 1000 is 20,000 x 20,000 cells and
                              // 40 million points
  bool planar = true;         // get_map, get_sub_map
  bool spatial = true;        // clouds and projections
  bool writable = false;      // set_map_projections is a ProjectedMapsInfo
  bool other_member = false;  // it answers projected_maps instead of projected_maps_info
  bool map_msg = false;       // types of map_msg instead of map_msgs, as sometimes written in the REP
};

struct RosOptions {
  std::uint16_t port = 0;  // 0 = a free one
  RosDialect dialect = RosDialect::Ros1;
  RosWriter writer = RosWriter::Escaped;
  bool rosapi = true;       // /rosapi/topics and related services exist
  bool status = false;      // reports errors in {"op":"status"} without being asked to (set_level)
  bool needs_auth = false;  // disconnects clients whose first message is not a complete {"op":"auth"}
  bool kabam = true;        // /map_manager/... is there
  DispatcherOptions dispatcher;
  int waypoints = 12;  // on the current map; 0..100,000
  // Alternatives where the KABAM document is ambiguous.
  bool kabam_list_holds_archived = false;  // map_list includes archived maps
  bool kabam_needs_flags = false;          // deleting without delete_map / delete_waypoint is refused
  bool kabam_empty_tags_keep = false;      // an update with an empty tag list leaves the tags unchanged
};

/// The layout of a dispatcher's clouds.
struct CloudOddities {
  bool big_endian = false;
  bool float64 = false;      // coordinates; and the colour is a uint32
  bool odd_offsets = false;  // fields begin anywhere
  bool no_z = false;
  bool nan = false;  // every tenth point is NaN
  double far_m = 0;  // shift of x and y
  std::string lie;   // "point-step", "row-step", "width" or "data"; empty = none
};

/// Variations of a dispatcher.
struct DispatcherFaults {
  /// A region that reaches beyond the map is cut; "pad": filled up, and clouds are larger than asked for;
  /// "empty": 0 x 0, and clouds hold nothing; "rotated": in a grid that lies askew; "elsewhere": of another
  /// region; "corner": x and y are taken for the lower left corner.
  std::string answer;
  int most_cells = 0;  // > 0: maximum number of cells in the answer for a region
  /// What it returns for a larger one: its lower left part; "empty": 0 x 0; "error": an error.
  std::string too_much;
  CloudOddities cloud;              // its lie "data" also applies to grids
  bool resolution_changes = false;  // from call to call
  bool regrids = false;             // the layout of the grid changes every fourth call
};

/// All off by default.
struct RosFaults {
  int slow_ms = 0;                       // delay of every response; the work is done at once
  bool shuffled_answers = false;         // every second response arrives after the ones that follow it
  std::vector<std::string> silent;       // listed topics that never publish
  bool wrong_type = false;               // /map, /scan and /odom have type std_msgs/String
  int fragment_bytes = 0;                // > 0: messages are sent in fragments of this many characters
  int restart_every_s = 0;               // > 0: the server restarts this often, without a closing handshake
  std::vector<std::string> refuse;       // services that respond result:false and do nothing
  std::vector<std::string> lose_answer;  // services that do their work but never respond
  std::vector<std::string> cut_after;    // services that do their work, then close the connection
  bool garbage = false;                  // frames that are not messages in between
  int other_operator_every_s = 0;        // > 0: another client changes waypoints and maps this often
  int waypoints_lag_ms = 0;              // > 0: the waypoint topic is this much late
  int other_painter_every_s = 0;         // > 0: another client paints on the current map this often
  int picture_code = 0;                  // > 0: update_map_image does nothing and returns this code
  bool picture_ignored = false;          // update_map_image does nothing but reports success
  bool nan_pose = false;                 // poses, transforms and a waypoint are NaN
  bool zero_quaternion = false;          // quaternions are zero, or not normalised
  bool tf_loop = false;                  // /tf says that map is below base_link, too
  DispatcherFaults dispatcher;
  bool big_endian_cloud = false;  // /points has big-endian numbers, and says so
};

}  // namespace mapwright::simulator
