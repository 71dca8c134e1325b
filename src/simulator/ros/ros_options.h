// How the simulated ROS robot speaks, and what may go wrong with it (docs/protocols/rosbridge.md,
// docs/protocols/kabam-map-manager.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mapwright::simulator {

/// Which ROS the types, times and headers are of.
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

/// A map dispatcher beside the robot, of a building of five storeys
/// (docs/protocols/rep130-map-dispatcher.md). Then nobody sends the map as one.
struct DispatcherOptions {
  bool there = false;
  double edge_m = 1000;       // of the building, whole metres 10..2000: 1000 is 20,000 x 20,000 cells and
                              // 40 million points
  bool planar = true;         // get_map, get_sub_map
  bool spatial = true;        // clouds and projections
  bool writable = false;      // set_map_projections is a ProjectedMapsInfo
  bool other_member = false;  // it answers projected_maps instead of projected_maps_info
  bool map_msg = false;       // types of map_msg instead of map_msgs, as the REP writes some
};

struct RosOptions {
  std::uint16_t port = 0;  // 0 = a free one
  RosDialect dialect = RosDialect::Ros1;
  RosWriter writer = RosWriter::Escaped;
  bool rosapi = true;       // /rosapi/topics and its kin are there
  bool status = false;      // tells of errors in {"op":"status"} without having been asked to (set_level)
  bool needs_auth = false;  // cuts who says anything else before a whole {"op":"auth"}
  bool kabam = true;        // /map_manager/... is there
  DispatcherOptions dispatcher;
  int waypoints = 12;  // on the current map; 0..100,000
  // Readings of what the KABAM document leaves open.
  bool kabam_list_holds_archived = false;  // map_list names archived maps, too
  bool kabam_needs_flags = false;          // deleting without delete_map / delete_waypoint is refused
  bool kabam_empty_tags_keep = false;      // an update with an empty list of tags leaves them
};

/// How clouds of a dispatcher are laid down.
struct CloudOddities {
  bool big_endian = false;
  bool float64 = false;      // coordinates; and the colour is a uint32
  bool odd_offsets = false;  // fields begin anywhere
  bool no_z = false;
  bool nan = false;  // every tenth point is not a number
  double far_m = 0;  // x and y are so much larger
  std::string lie;   // "point-step", "row-step", "width" or "data"; empty = none
};

/// What a dispatcher does differently.
struct DispatcherFaults {
  /// A region that reaches beyond the map is cut; "pad": filled up, and clouds are larger than asked for;
  /// "empty": 0 x 0, and clouds hold nothing; "rotated": in a grid that lies askew; "elsewhere": of another
  /// region; "corner": x and y are taken for the lower left corner.
  std::string answer;
  int most_cells = 0;  // > 0: an answer for a region has no more cells than that
  /// What comes of one that has more: its lower left part; "empty": 0 x 0; "error": an error.
  std::string too_much;
  CloudOddities cloud;              // its lie "data" is about grids, too
  bool resolution_changes = false;  // from call to call
  bool regrids = false;             // every fourth call the grid is laid out anew
};

/// All off unless asked for.
struct RosFaults {
  int slow_ms = 0;                       // delay of every answer to a call; the work is done at once
  bool shuffled_answers = false;         // every second answer is overtaken by those after it
  std::vector<std::string> silent;       // topics that are known and never say anything
  bool wrong_type = false;               // /map, /scan and /odom are of std_msgs/String
  int fragment_bytes = 0;                // > 0: text frames are sent in fragments of so many characters
  int restart_every_s = 0;               // > 0: the server is gone this often, without a closing handshake
  std::vector<std::string> refuse;       // services that answer result:false and do nothing
  std::vector<std::string> lose_answer;  // services that do their work and never answer
  std::vector<std::string> cut_after;    // services that do their work, and then the link is cut
  bool garbage = false;                  // frames that are no messages come between the others
  int other_operator_every_s = 0;        // > 0: somebody else changes waypoints and maps this often
  int waypoints_lag_ms = 0;              // > 0: the topic of waypoints tells everything so much later
  int other_painter_every_s = 0;         // > 0: somebody else paints on the current map this often
  int picture_code = 0;                  // > 0: update_map_image does nothing and answers this code
  bool picture_ignored = false;          // update_map_image does nothing and answers that it did
  bool nan_pose = false;                 // poses, transforms and a waypoint are not a number
  bool zero_quaternion = false;          // orientations are all zeros, or not of length one
  bool tf_loop = false;                  // /tf says that map hangs below base_link, too
  DispatcherFaults dispatcher;
  bool big_endian_cloud = false;  // /points has its numbers the other way round, and says so
};

}  // namespace mapwright::simulator
