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
#include "robot/ros/read_messages.h"
#include "robot/ros/ros_topics.h"
#include "robot/ros/seen_markers.h"
#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

/// What became of one message.
struct WorldResult {
  std::string topic;
  double received_s = 0;             // when the message came (seconds since the epoch)
  std::optional<double> recorded_s;  // its own stamp
  std::optional<map::TopicMessage> message;
  std::optional<Fault> unreadable;  // it cannot be read
  std::optional<Fault> unplaced;    // there is no transform for it (yet): which one
  std::vector<Fault> notes;         // what is odd about it
};
using WorldResults = std::vector<WorldResult>;

/// Puts the patch into a grid of its own frame; false: the grid is newer than it, and stays as it is.
Read<bool> patchGrid(Grid& grid, const GridPatch& patch);

/// All that is kept between two messages. The fixed frame is that of the map; without a map it is called
/// `map`, and where no such frame has come a while after the first transform, it is the root of the robot's
/// own. Where nothing at all says how the robot's frames lie, it is the one that its scans are in, and each
/// message that is placed there says so. What needs a transform that is not there is not placed: a transform
/// is waited for, then named, never guessed. One thread.
class RosWorld {
 public:
  static constexpr double kPatienceS = 1;     // for a transform, before its absence is told
  static constexpr std::size_t kWaiting = 8;  // messages of a topic

  /// `ns`: frames below this namespace are looked for first.
  explicit RosWorld(std::string ns = {}) : ns_(std::move(ns)) {}

  /// For recordings, whose later transforms are taken first: this is the fixed frame from now on, whatever
  /// comes, and a message whose transform is not there when it is taken is `unplaced` at once. Markers wait.
  /// `own`: it is that of the robot's scans, for want of a map and of transforms.
  void placeAtOnce(std::string fixed_frame, bool own = false) {
    if (own) own_frame_ = fixed_frame;
    given_frame_ = std::move(fixed_frame);
  }
  /// Grids of these topics are kept whole, for patches.
  void keepGrids(std::set<std::string> topics);
  /// A message of `source`. Transforms may place what has waited: more than one result.
  WorldResults take(const Source& source, const Field& msg, double received_s);
  /// A grid that was read already.
  WorldResult take(const Source& source, const Grid& grid, double received_s);
  /// As seen by the last message of markers, or by overdue().
  const map::SeenObjectsMessage& seenObjects() const { return markers_.seen(); }
  /// When the next marker has lived its time; infinity: none will.
  double nextMarkerEnd() const { return markers_.nextEnd(); }
  /// What has waited for its transform for too long, at `now_s`; and the markers, where time or transforms
  /// have changed what is to be seen of them.
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
  std::optional<tl::expected<geometry::Pose2, Fault>> pose() const;
  struct Located {
    tl::expected<geometry::Pose2, Fault> pose;
    std::string topic;           // that tells it; empty: transforms do
    std::optional<double> at_s;  // the stamp for which the transforms tell it; nullopt: they never change
    bool operator==(const Located&) const = default;
  };
  /// The same, and what it rests on.
  std::optional<Located> located() const;
  const Transforms& transforms() const { return transforms_; }
  /// Messages that made way for newer ones while they waited for a transform.
  std::size_t gaveWay() const { return gave_way_; }
  /// How old the newest stamp of each pair is at `now_s` (as received), by the clock of the robot; the oldest
  /// first.
  std::vector<std::pair<Transforms::Newest, double>> ages(double now_s) const;
  /// Where scans are shown whose frame is `frame`, as long as nothing says how it lies to others: what it
  /// hangs on.
  std::string ownFrameOf(const std::string& frame) const { return transforms_.rootAbove(frame); }

 private:
  using Content = std::variant<Grid, Outline, Points, Placed, Poses>;
  struct Waiting {
    Source source;
    Content content;
    double received_s = 0;
  };
  /// The messages of one topic. Those of a fast one make way for each other sooner than any of them is late:
  /// what counts is how long none has been placed.
  struct Queue {
    std::deque<Waiting> messages;  // the oldest first
    double since_s = 0;
    bool told = false;  // that there is no transform
  };
  using Placing = tl::expected<map::TopicMessage, Transforms::Missing>;

  void takeTf(const Source& source, const Field& msg, WorldResult& result);
  void takePatch(const Source& source, const Field& msg, WorldResult& result);
  void takeContent(const Source& source, Content content, WorldResult& result);
  /// The frame of the map, or a root of the robot's frames: all but the fallbacks.
  std::optional<std::string> toldFrame() const;
  bool inOwnFrame() const { return !own_frame_.empty() && fixedFrame() == own_frame_; }
  /// As RosFramesApart from nothing: there is no other frame.
  void noteOwnFrame(const Source& source, WorldResult& result);
  void leaveOwnFrame(double now_s, WorldResults& results);
  static const Header& headerOf(const Content& content);
  /// A scan is placed point by point, once all of its sweep is known; or as it lay at its beginning.
  enum class Sweep { Whole, Beginning };
  Placing place(const Source& source, const Content& content, Sweep sweep) const;
  Placing placeScan(const Points& points, const std::string& topic, const std::string& into,
                    const Transform3& beginning, Sweep sweep) const;
  bool looksAtMarkers(double now_s) const;
  void lookAtMarkers(double now_s, WorldResults& results);
  WorldResults placeWaiting();
  tl::expected<geometry::Pose2, Transforms::Missing> inFixedFrame(const Placed& placed) const;

  std::string ns_;
  Transforms transforms_;
  /// By topic and frame: its last transform was no numbers or no rotation (tf2 takes no such, either).
  std::set<std::pair<std::string, std::string>> unusable_;
  std::string map_frame_;
  std::string given_frame_;                      // placeAtOnce(); empty: frames are found
  std::string own_frame_;                        // of scans, where nothing tells; empty: none is needed
  std::set<std::string> in_own_frame_;           // topics with points there
  double first_transform_s_ = 0, latest_s_ = 0;  // when they came; 0 = none yet
  std::set<std::string> kept_topics_;
  std::map<std::string, Grid> grids_;     // by topic
  std::map<std::string, Queue> waiting_;  // by topic
  struct Told {
    Form form;
    Placed placed;
  };
  std::map<std::string, Told> told_poses_;  // by topic
  SeenMarkers markers_;
  double markers_looked_s_ = 0;
  std::size_t gave_way_ = 0;
};

}  // namespace mapwright::robot::ros
