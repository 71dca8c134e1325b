// How the simulated ROS robot speaks, and what may go wrong with it (rosbridge.md, kabam.md).
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

struct RosOptions {
  std::uint16_t port = 0;  // 0 = a free one
  RosDialect dialect = RosDialect::Ros1;
  RosWriter writer = RosWriter::Escaped;
  bool rosapi = true;       // /rosapi/topics and its kin are there
  bool status = false;      // tells of errors in {"op":"status"} without having been asked to (set_level)
  bool needs_auth = false;  // cuts who says anything else before a whole {"op":"auth"}
  bool kabam = true;        // /map_manager/... is there
  int waypoints = 12;       // on the current map; 0..100,000
  // Readings of what the KABAM document leaves open.
  bool kabam_list_holds_archived = false;  // map_list names archived maps, too
  bool kabam_needs_flags = false;          // deleting without delete_map / delete_waypoint is refused
  bool kabam_empty_tags_keep = false;      // an update with an empty list of tags leaves them
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
  bool nan_pose = false;                 // poses, transforms and a waypoint are not a number
  bool zero_quaternion = false;          // orientations are all zeros, or not of length one
  bool tf_loop = false;                  // /tf says that map hangs below base_link, too
  bool big_endian_cloud = false;         // /points has its numbers the other way round, and says so
};

}  // namespace mapwright::simulator
