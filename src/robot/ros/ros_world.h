// Messages of a ROS robot placed in one fixed frame, as the map draws them. Pure: time is handed in.
// Source: REP 105 (map, odom, base_link), tf2 (what waits for its transform).
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "map/live_topics.h"
#include "robot/ros/marker_board.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/ros_topics.h"
#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

/// What became of one message.
struct WorldResult {
  std::string topic;
  double received_s = 0;             // when the message came (seconds since the epoch)
  std::optional<double> recorded_s;  // its own stamp
  std::optional<map::TopicMessage> message;
  std::optional<map::Reason> unreadable;  // it cannot be read
  std::optional<map::Reason> unplaced;    // there is no transform for it (yet): which one
  std::vector<map::Reason> notes;         // what is odd about it
};
using WorldResults = std::vector<WorldResult>;

/// All that is kept between two messages. The fixed frame is that of the map; without a map it is called
/// `map`, and where no such frame has come a while after the first transform, it is the root of the robot's
/// own. What needs a transform that is not there is not placed: a transform is waited for, then named, never
/// guessed. One thread.
class RosWorld {
 public:
  static constexpr double kPatienceS = 1;     // for a transform, before its absence is told
  static constexpr std::size_t kWaiting = 8;  // messages of a topic

  /// `ns`: frames below this namespace are looked for first.
  explicit RosWorld(std::string ns = {}) : ns_(std::move(ns)) {}

  /// Grids of these topics are kept whole, for patches.
  void keepGrids(std::set<std::string> topics);
  /// A message of `source`. Transforms may place what has waited: more than one result.
  WorldResults take(const Source& source, const Field& msg, double received_s);
  /// What has waited for its transform for too long, at `now_s`.
  WorldResults overdue(double now_s);
  /// Nothing of what a topic sent holds any more.
  void forget(const std::string& topic);
  /// Another connection: transforms, grids, poses, all is forgotten.
  void forgetAll();

  std::string fixedFrame() const;
  /// That of the map, as the map says itself; empty while none has come.
  const std::string& mapFrame() const { return map_frame_; }
  /// The fixed frame is that of a map, or called so: no other will take its place.
  bool fixedByMap() const;
  /// Transforms tell where the robot is.
  bool posedByTransforms() const;
  /// base_link or base_footprint, whatever stands before it; empty while none of them is known.
  std::string robotFrame() const;
  /// Where the robot is in the fixed frame, now: by transforms, else by the best topic that tells. nullopt:
  /// nothing was told so far.
  std::optional<tl::expected<geometry::Pose2, map::Reason>> pose() const;
  const Transforms& transforms() const { return transforms_; }

 private:
  struct Board {
    Header header;  // with its frame empty: each marker has its own
    std::vector<Marker> markers;
  };
  using Content = std::variant<Grid, Outline, Points, Placed, Board>;
  struct Waiting {
    Source source;
    Content content;
    double received_s = 0;
    bool told = false;  // that it has no transform
  };
  using Placing = tl::expected<map::TopicMessage, Transforms::Missing>;

  void takeTf(const Source& source, const Field& msg, WorldResult& result);
  void takePatch(const Source& source, const Field& msg, WorldResult& result);
  void takeContent(const Source& source, Content content, WorldResult& result);
  static const Header& headerOf(const Content& content);
  Placing place(const Source& source, const Content& content) const;
  Placing boxes(const std::vector<Marker>& markers) const;
  WorldResults placeWaiting();
  tl::expected<geometry::Pose2, Transforms::Missing> inFixedFrame(const Placed& placed) const;

  std::string ns_;
  Transforms transforms_;
  std::string map_frame_;
  double first_transform_s_ = 0, latest_s_ = 0;  // when they came; 0 = none yet
  std::set<std::string> kept_topics_;
  std::map<std::string, Grid> grids_;  // by topic
  std::map<std::string, std::deque<Waiting>> waiting_;
  struct Told {
    Form form;
    Placed placed;
  };
  std::map<std::string, Told> told_poses_;     // by topic
  std::map<std::string, MarkerBoard> boards_;  // by topic
};

}  // namespace mapwright::robot::ros
