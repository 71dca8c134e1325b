// An Autoxing robot, an Agibot one and a ROS one with KABAM's map manager on three loopback ports, for demos
// and tests. All live in the same building. Written from the documents (docs/protocols/autoxing.md,
// docs/protocols/cartographer-submaps.md, docs/protocols/agibot-aimdk.md, docs/protocols/rosbridge.md,
// docs/protocols/kabam-map-manager.md); shares no code with the client except the generated protobuf classes
// and the map's value types.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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

/// What may happen to a request, and to its answer.
enum class FaultKind {
  Delay,       // the answer comes `number` milliseconds late,
  Jitter,      // and up to so many more
  Drop,        // nothing is done, and the connection is closed without an answer
  Refuse,      // nothing is done; the answer is an error, with the HTTP status or result code `number`
  Ignore,      // nothing is done, and the answer says that all was well (writes only)
  Cut,         // all is done, and the connection is closed without an answer
  Silence,     // all is done, and no answer comes
  Truncate,    // half of the body with the whole Content-Length, then the connection is closed (HTTP only)
  WrongSize,   // of a submap: width and height do not fit the cells,
  Corrupt,     // the protobuf is garbage,
  StatusError  // its StatusResponse is an error
};

/// Which requests; they can be combined.
using Requests = unsigned;
inline constexpr Requests kReads = 1;
// POST, PUT, PATCH, DELETE, calls of AimDK and of ROS services that change something.
inline constexpr Requests kWrites = 2;
inline constexpr Requests kSubmaps = 4;
inline constexpr Requests kMaps = 8;        // about maps, mappings, bags and static files, and all of AimDK
inline constexpr Requests kMapList = 16;    // for the list of maps
inline constexpr Requests kDownloads = 32;  // for a .pbstream
inline constexpr Requests kServices = 64;   // calls of ROS services
inline constexpr Requests kAllRequests = kReads | kWrites;

/// A row of the table of faults. Of several rows at most one takes effect, besides delays: the first one by
/// the lot of the request. Lots are drawn by seed, request and try, so that a run can be repeated.
struct RequestFault {
  FaultKind kind = FaultKind::Drop;
  Requests of = kAllRequests;
  double rate = 1;        // the share of these requests, 0..1
  int number = 0;         // see FaultKind; 0 = any status
  std::string path = {};  // only this path or service, and what is below it; empty = all
};

/// What is wrong with topics and messages of the ROS robot.
struct RosFaults {
  bool shuffled_answers = false;   // every second response arrives after the ones that follow it
  bool wrong_type = false;         // /map, /scan and /odom have type std_msgs/String
  int fragment_bytes = 0;          // > 0: messages are sent in fragments of this many characters
  int restart_every_s = 0;         // > 0: the server restarts this often, without a closing handshake
  bool garbage = false;            // frames that are not messages in between
  int other_operator_every_s = 0;  // > 0: another client changes waypoints and maps this often
  int waypoints_lag_ms = 0;        // > 0: the waypoint topic is this much late
  int other_painter_every_s = 0;   // > 0: another client paints on the current map this often
  bool nan_pose = false;           // poses, transforms and a waypoint are NaN
  bool zero_quaternion = false;    // quaternions are zero, or not normalised
  bool tf_loop = false;            // /tf says that map is below base_link, too
  DispatcherFaults dispatcher;
  bool big_endian_cloud = false;  // /points has big-endian numbers, and says so
};

/// What may go wrong on request. All off by default.
struct Faults {
  std::vector<RequestFault> requests;  // of all robots
  std::vector<std::string> silent;     // topics of all robots that are listed and never publish
  int websocket_drop_every_s = 0;      // > 0: the WebSocket is cut this often
  int uuid_change_every_s = 0;         // > 0: the SLAM session restarts this often
  // /submap_list also holds NaN poses, zero quaternions, duplicates, a version going back
  bool bad_entries = false;
  bool silent_websocket = false;  // accepts, then never sends nor pongs
  // Whole maps and picture topics.
  bool truncated_maps = false;    // every map's PNG is cut in half (the HTTP answer is whole)
  bool lying_map_size = false;    // every map's PNG declares 60,000 x 60,000
  bool foreign_data_url = false;  // data_url points to http://127.0.0.2:1/
  bool garbage_base64 = false;    // `data` of picture topics is no base64
  // "zero-resolution", "negative-resolution", "no-resolution" or "no-origin" in picture topics and map
  // details
  std::string grid_fault;
  bool sees_nothing = false;     // no charger, rack, pallet or trailer; nothing was collected
  int overlay_edit_every_s = 0;  // > 0: somebody else changes the overlays of the current map this often
  bool overlay_edit_before_writes = false;  // and right before every change of them
  RosFaults ros;
};

/// What it has recorded.
struct BagOptions {
  /// Besides the usual ones: eight hours with more than 100,000 messages, a clock that was set back, equal
  /// stamps, a gap, messages after the end that is told, one message, none.
  bool odd = false;
  bool end_exclusive = false;  // a range ends before its end_time
  bool ranges = true;          // downloads can go on (Range)
};

/// The Agibot robot beyond what its maker documents (docs/protocols/agibot-aimdk.md, "Newer services").
struct AimdkOptions {
  bool newer = false;        // maps and points can be changed, and it can map
  bool centimetres = false;  // `resolution` is centimetres per pixel, not pixels per metre
};

/// How the robot behaves and what it offers.
struct Options {
  std::uint16_t port = 0;        // 0 = a free one
  std::uint16_t aimdk_port = 0;  // 0 = a free one
  std::string scene = "office";  // see sceneNames()
  int submaps = 0;               // > 0: a map of about this many submaps, overriding the scene's own size
  std::uint32_t seed = 1;
  double speed = 1;               // simulated seconds per real second
  double start_at_s = 0;          // simulated time at start
  bool paused = false;            // simulated time stands still: every answer is the same on every run
  bool enable_topic_list = true;  // supportsEnableTopicList
  bool binary_topics = true;      // understands ?pb=1
  bool positioning_asks = false;  // what global positioning finds has to be confirmed
  std::string secret;             // when set, requests without `Secret: <it>` get 401 (not by AimDK)
  int points_per_scan = 720;      // of /scan_matched_points2 and its kin; 0..1,000,000
  double scan_hz = 5;             // how often they come; above 0, at most 100
  int costmap_cells = 200;        // edge of /maps/5cm/1hz; 20..4000
  double pose_hz = 10;            // how often /tracked_pose comes; above 0, at most 100
  BagOptions bags;
  AimdkOptions aimdk;
  RosOptions ros;
  Faults faults;
};

/// One line of the request log. Of the ROS robot: CALL of a service, SUBSCRIBE, UNSUBSCRIBE and PUBLISH of a
/// topic as method and target; status 200, 400 (result:false), 503 (refused on request), 0 (no answer).
struct RequestRecord {
  double at_s = 0;      // real seconds since start
  double until_s = -1;  // when the answer was written or given up; -1 while in progress
  std::string method;
  std::string target;       // path and query
  int status = 0;           // 0: dropped without an answer
  std::size_t bytes = 0;    // body sent
  int concurrent = 0;       // requests to /ros/slam/submaps/ in progress, this one included, when it came
  bool had_secret = false;  // a Secret header was present (its value is not kept)
  std::string if_none_match;
};

/// Runs on threads of its own from start() to stop() or destruction. Members may be called from any thread.
class Simulator {
 public:
  explicit Simulator(Options options);
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// Opens 127.0.0.1:port. An error is a sentence; nullopt means it runs.
  std::optional<std::string> start();
  void stop();
  std::uint16_t port() const;
  std::string address() const;  // "axbot+http://127.0.0.1:PORT"
  std::uint16_t aimdkPort() const;
  std::string aimdkAddress() const;  // "aimdk+http://127.0.0.1:PORT"
  std::uint16_t rosPort() const;
  std::string rosAddress() const;     // "ros+ws://127.0.0.1:PORT"
  std::string kabamAddress() const;   // the same robot: "kabam+ws://127.0.0.1:PORT"
  std::string rep130Address() const;  // likewise: "rep130+ws://127.0.0.1:PORT"

  std::vector<RequestRecord> requestLog() const;
  void clearRequestLog();
  void setFaults(const Faults& faults);

  // Scripted moments, for tests and demos; they take effect at once and are published.
  void advance(double simulated_s);  // moves the paused or running clock forward
  void closeLoop();                  // every pose moves, no version changes
  void restartSlam();                // a new uuid
  void dropWebSockets();             // of the Autoxing robot and of the ROS robot
  // The rosbridge server stalls, as a process that is stopped does: its sockets stay open, and it reads,
  // answers, sends and accepts nothing, not even pongs. What other members do to it is done afterwards.
  void stallRos();
  void unstallRos();
  void removeSubmap(int trajectory, int index);
  void bumpVersion(int trajectory, int index);  // new version, new cells
  void publishMapChange();                      // the current map gets a new picture and a new version
  bool setCurrentMap(int id);                   // false when there is no such map
  std::string uuid() const;
  int openWebSockets() const;
  int openRosLinks() const;
  void otherPainter();   // somebody else paints on the current map of the ROS robot
  void otherOperator();  // somebody else changes a waypoint or a map of the ROS robot

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Names of the scenes that Options::scene takes, with one sentence each.
std::vector<std::pair<std::string, std::string>> sceneNames();

}  // namespace mapwright::simulator
