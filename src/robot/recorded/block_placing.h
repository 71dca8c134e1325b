// Places ROS messages so that the result does not depend on what was read before.
// Time is divided into blocks that begin at multiples of kBlockNs since the epoch. The result for a message
// in a block depends on the file, not on the requested range: on all that was said before its block and still
// counts (Lasting), on the messages of its block until then, on transforms to kAheadNs after it (data that is
// late on a robot is available here), and on grids with all their patches. Moving frames of which nothing was
// heard for 10 s are unknown. Source: REP 105, tf2 (history of 10 s).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recording/source.h"
#include "robot/recorded/lasting.h"
#include "robot/recorded/message_fields.h"
#include "robot/recorded/ros_shape.h"
#include "robot/ros/ros_world.h"

namespace mapwright::robot::recorded {

/// A grid at a time is the last whole one before it with all patches since, whatever was read before. The
/// latest result for each grid is kept, so that continuing only costs the new patches. One thread.
class GridFolds {
 public:
  GridFolds(recording::Source& file, MessageFields& fields) : file_(file), fields_(fields) {}

  /// A whole grid arrived.
  void set(const std::string& topic, const ros::Grid& grid, std::int64_t at_ns);
  /// The grid of `topic` as it was before `at_ns`; null: there is none. Valid until the next call.
  ros::Grid* before(const std::string& topic, const std::string& patches, std::int64_t at_ns);
  /// The latest result without a check for newer data; null: there is none.
  ros::Grid* made(const std::string& topic);
  /// The patches up to then have been applied.
  void patched(const std::string& topic, std::int64_t at_ns);

 private:
  struct Fold {
    ros::Grid grid;
    std::int64_t whole_ns = 0;  // when the whole grid was sent
    std::int64_t until_ns = 0;  // patches up to this time are applied
  };
  recording::Source& file_;
  MessageFields& fields_;
  std::map<std::string, Fold> folds_;  // by topic
};

/// What messages are placed by.
struct PlacingParts {
  recording::Source& file;
  MessageFields& fields;
  const RosShape& shape;
  Lasting& lasting;
  GridFolds& folds;
};

/// One block, its messages one after the other. One thread.
class BlockPlacing {
 public:
  static constexpr std::int64_t kBlockNs = 8'000'000'000, kBeforeNs = Lasting::kHistoryNs,
                                kAheadNs = 1'000'000'000;
  static constexpr std::int64_t kMarkersEveryNs = 250'000'000;
  static std::int64_t blockOf(std::int64_t at_ns);  // where it begins

  /// Reads what comes before `from_ns`, which lies in the block.
  BlockPlacing(const PlacingParts& parts, std::int64_t block_ns, std::int64_t from_ns, std::int64_t until_ns);

  /// The result for the message; call it for each message of the shape's topics, in order. `frame`: the
  /// parsed message. May include results of other topics (markers).
  ros::WorldResults add(const recording::Message& message, const FramePtr& frame);
  /// The markers visible at the start of the block, and changes since then without a message: call it before
  /// each message and at the end of the range.
  ros::WorldResults before(std::int64_t at_ns);

 private:
  void readEarlier();
  void readBefore(std::int64_t from_ns);
  void advance(std::int64_t until_ns);
  /// Removes markers whose lifetime is over, each at its time.
  void endMarkers(std::int64_t until_ns, ros::WorldResults& results);
  /// Derived results come when their messages come.
  void shift(ros::WorldResults& results) const;
  ros::WorldResult onGrid(const ros::Source& source, const ros::Field& msg, std::int64_t at_ns);
  ros::WorldResult applyMapPatch(const ros::Source& source, const ros::Field& msg, std::int64_t at_ns);
  /// A recording may begin between a message and the transform for its position.
  bool isOfBeginning(const ros::WorldResult& result, std::int64_t at_ns) const;
  void addPose(ros::WorldResults& results, const std::string& topic, std::int64_t at_ns);

  PlacingParts parts_;
  std::int64_t block_ns_, start_ns_;  // where the block begins, and the file
  ros::RosWorld ahead_;               // knows the transforms until kAheadNs later: places what has a stamp
  ros::RosWorld now_;                 // knows what has been said by now: where the robot is, and markers
  std::unique_ptr<recording::Cursor> leading_;
  std::optional<recording::Message> lead_;  // the next transform of ahead_
  std::int64_t next_look_ns_;               // at markers
  bool told_beginning_ = false, any_markers_ = false;
  std::optional<double> part_begins_s_;  // what a part says of the time before it, it says at its beginning
  std::optional<ros::RosWorld::Located> located_;  // as it was told last
  std::set<std::string> folded_;                   // grids whose present state is in GridFolds
};

}  // namespace mapwright::robot::recorded
