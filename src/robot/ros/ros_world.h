// Places the messages of a ROS robot in one fixed frame, as the map shows them. Pure: time is passed in.
// Source: REP 105 (map, odom, base_link), tf2 (messages waiting for their transform).
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "map/live_topics.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/robot_transforms.h"
#include "robot/ros/ros_topics.h"
#include "robot/ros/seen_markers.h"

namespace mapwright::robot::ros {

/// The result for a message.
struct WorldResult {
  std::string topic;
  double received_s = 0;             // when the message arrived (seconds since the epoch)
  std::optional<double> recorded_s;  // its own stamp
  std::optional<map::TopicMessage> message;
  std::optional<Fault> unreadable;  // it cannot be read
  std::optional<Fault> unplaced;    // the missing transform
  std::vector<Fault> notes;         // what is odd about it
};
using WorldResults = std::vector<WorldResult>;

/// Applies the patch to a grid in its own frame; false: the grid is newer and stays as it is.
Read<bool> patchGrid(Grid& grid, const GridPatch& patch);

/// The state between two messages. The fixed frame is that of the map; without a map it is `map`, and if no
/// such frame has come a while after the first transform, the root of the robot's own frames. If nothing
/// relates the robot's frames, it is the frame of its scans, and each message placed there says so. Data
/// without its transform is not placed: it waits, then the missing transform is reported, never guessed. One
/// thread.
class RosWorld {
 public:
  static constexpr double kLongestWaitS =
      1;  // how long to wait for a transform before it is reported as missing
  static constexpr std::size_t kWaiting = 8;  // waiting messages per topic

  /// `ns`: frames in this namespace are preferred.
  explicit RosWorld(std::string ns = {}) : ns_(std::move(ns)) {}

  /// For recordings, where later transforms are passed in first: this is the fixed frame from now on, and a
  /// message without its transform is `unplaced` at once. Markers wait. `own`: it is the frame of the robot's
  /// scans, for lack of a map and transforms.
  void placeAtOnce(std::string fixed_frame, bool own = false) {
    if (own) own_frame_ = fixed_frame;
    given_frame_ = std::move(fixed_frame);
  }
  // As in RobotTransforms. Live, the root is trusted after a while.
  void setRobots(std::vector<std::string> namespaces) { transforms_.setNamespaces(std::move(namespaces)); }
  void trustRoot() { transforms_.trustRoot(); }
  bool rootServesAll() const { return transforms_.rootServesAll(); }
  /// The namespace of the robot that is shown: the first of those that tell where a robot is. Empty: there is
  /// only one, or it has none.
  std::string shownRobot() const;
  /// Grids of these topics are kept whole, for patches.
  void keepGrids(std::set<std::string> topics);
  /// A message of `source`. Transforms may place waiting messages: several results.
  WorldResults add(const Source& source, const Field& msg, double received_s);
  /// For recordings: it was said before, and tells nothing now.
  void addEarlier(const Source& source, const Field& msg, double received_s);
  /// For recordings: moving frames of which nothing was heard for as long as transforms are kept are unknown.
  void forgetSilent(double now_s);
  /// A parsed grid.
  WorldResult add(const Source& source, const Grid& grid, double received_s);
  /// As of the last marker message, or of overdue().
  const map::SeenObjectsMessage& seenObjects() const { return markers_.seen(); }
  /// Markers that wait for their transforms, by topic.
  const std::map<std::string, int>& waitingMarkers() const { return markers_.waiting(); }
  /// When the next marker expires; infinity: none will.
  double nextMarkerEnd() const { return markers_.nextEnd(); }
  /// Messages that have waited too long for their transform at `now_s`; and the markers, if time or
  /// transforms have changed them.
  WorldResults overdue(double now_s);
  /// Drops everything from a topic.
  void forget(const std::string& topic);
  /// A new connection: drops transforms, grids, poses, everything.
  void forgetAll();

  std::string fixedFrame() const;
  /// The frame stated by the map; empty while none has arrived.
  const std::string& mapFrame() const { return map_frame_; }
  /// The fixed frame is that of a map, or named so: it will not be replaced.
  bool fixedByMap() const;
  /// Transforms give the robot's pose.
  bool posedByTransforms() const;
  /// base_link or base_footprint, with any prefix; empty while unknown.
  std::string robotFrame() const;
  /// The robot's present pose in the fixed frame: from transforms, otherwise from the best topic. nullopt:
  /// nothing received so far.
  std::optional<tl::expected<geometry::Pose2, Fault>> pose() const;
  struct Located {
    tl::expected<geometry::Pose2, Fault> pose;
    std::string topic;           // its source; empty: transforms
    std::optional<double> at_s;  // the stamp of the transforms; nullopt: static
    bool operator==(const Located&) const = default;
  };
  /// The same with its source.
  std::optional<Located> located() const;
  /// Of the robot that is shown.
  const Transforms& transforms() const { return transforms_.robot(); }
  /// Messages replaced by newer ones while waiting for a transform.
  std::size_t replaced() const { return replaced_; }
  /// The age of the newest stamp of each pair at `now_s` (as received), by the robot's clock; oldest first.
  std::vector<std::pair<Transforms::Newest, double>> ages(double now_s) const;
  /// Where scans in `frame` are shown while nothing relates it to other frames: its root.
  std::string ownFrameOf(const std::string& frame) const { return transforms().rootAbove(frame); }

 private:
  using Content = std::variant<Grid, Outline, Points, Placed, Poses>;
  struct Waiting {
    Source source;
    Content content;
    double received_s = 0;
  };
  /// The waiting messages of one topic. On a fast topic messages are replaced before they are late: what
  /// counts is how long none has been placed.
  struct Queue {
    std::deque<Waiting> messages;  // the oldest first
    double since_s = 0;
    bool told = false;  // the missing transform was reported
  };
  using Placing = tl::expected<map::TopicMessage, Transforms::Missing>;

  void onTransforms(const Source& source, const Field& msg, WorldResult& result);
  void applyMapPatch(const Source& source, const Field& msg, WorldResult& result);
  void onContent(const Source& source, Content content, WorldResult& result);
  /// The frame of the map, or a root of the robot's frames, without the fallbacks.
  std::optional<std::string> toldFrame() const;
  bool inOwnFrame() const { return !own_frame_.empty() && fixedFrame() == own_frame_; }
  /// Like RosFramesApart, but there is no other frame.
  void learnOwnFrame(const Source& source, WorldResult& result);
  void leaveOwnFrame(double now_s, WorldResults& results);
  static const Header& headerOf(const Content& content);
  /// A scan is placed point by point once the transforms of its whole sweep are known; or with the pose at
  /// its beginning.
  enum class Sweep { Whole, Beginning };
  Placing place(const Source& source, const Content& content, Sweep sweep) const;
  Placing placeScan(const Points& points, const std::string& topic, const std::string& into,
                    const Transform3& beginning, Sweep sweep) const;
  bool looksAtMarkers(double now_s) const;
  void lookAtMarkers(double now_s, WorldResults& results);
  WorldResults placeWaiting();
  tl::expected<geometry::Pose2, Transforms::Missing> inFixedFrame(const std::string& topic,
                                                                  const Placed& placed) const;
  /// `robot`: its namespace; empty: the root's, or the only one.
  std::string robotFrameOf(const std::string& robot) const;

  std::string ns_;
  RobotTransforms transforms_;
  /// By topic and frame: its last transform was invalid (tf2 rejects it, too).
  std::set<std::pair<std::string, std::string>> unusable_;
  std::string map_frame_;
  std::string given_frame_;                      // placeAtOnce(); empty: frames are found
  std::string own_frame_;                        // of scans, if nothing else is known; empty: not needed
  std::set<std::string> in_own_frame_;           // topics with points there
  double first_transform_s_ = 0, latest_s_ = 0;  // arrival times; 0 = none yet
  std::set<std::string> kept_topics_;
  std::map<std::string, Grid> grids_;     // by topic
  std::map<std::string, Queue> waiting_;  // by topic
  struct TopicPose {
    Form form;
    Placed placed;
  };
  std::map<std::string, TopicPose> topic_poses_;  // by topic
  /// Of moving frames, by robot and name, in recordings: when it was heard of them last.
  std::map<std::pair<std::string, std::string>, double> heard_s_;
  bool earlier_ = false;  // addEarlier()
  SeenMarkers markers_;
  double markers_looked_s_ = 0;
  std::size_t replaced_ = 0;
};

}  // namespace mapwright::robot::ros
