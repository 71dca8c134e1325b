// Places ROS messages so that the result does not depend on what was read before.
// Time is divided into blocks that begin at multiples of kBlockNs since the epoch. The result for a message
// in a block depends on the messages from kBeforeNs before its block on, not on the requested range:
// transforms from that time to kAheadNs after the message (data that is late on a robot is available here),
// static ones from the start of the file and the last before, the last poses and markers before, grids with
// all their patches. Source: REP 105, tf2 (history of 10 s).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recording/source.h"
#include "robot/recorded/message_fields.h"
#include "robot/recorded/ros_shape.h"
#include "robot/ros/ros_world.h"

namespace mapwright::robot::recorded {

/// The static transforms needed at a time. One thread.
class StaticTransforms {
 public:
  StaticTransforms(recording::Source& file, MessageFields& fields, const RosShape& shape)
      : file_(file), fields_(fields), shape_(shape) {}
  struct Transform {
    std::string topic;
    std::int64_t at_ns = 0;
    FramePtr frame;
  };
  /// Those of the file's first minute and the last ones before `at_ns`, in order.
  const std::vector<Transform>& until(std::int64_t at_ns);

 private:
  void add(std::vector<Transform>& all, const recording::Message& message);
  recording::Source& file_;
  MessageFields& fields_;
  const RosShape& shape_;
  std::optional<std::vector<Transform>> first_;  // of the first minute
  std::vector<Transform> until_;
  std::int64_t last_ns_ = -1;  // the last one before, for which until_ is valid
};

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
  StaticTransforms& statics;
  GridFolds& folds;
};

/// One block, its messages one after the other. One thread.
class BlockPlacing {
 public:
  static constexpr std::int64_t kBlockNs = 8'000'000'000, kBeforeNs = 10'000'000'000,
                                kAheadNs = 1'000'000'000;
  static constexpr std::int64_t kMarkersEveryNs = 250'000'000;
  static std::int64_t blockOf(std::int64_t at_ns);  // where it begins

  /// Reads what comes before `from_ns`, which lies in the block.
  BlockPlacing(const PlacingParts& parts, std::int64_t block_ns, std::int64_t from_ns, std::int64_t until_ns);

  /// The result for the message; call it for each message of the shape's topics, in order. `frame`: the
  /// parsed message. May include results of other topics (markers).
  ros::WorldResults take(const recording::Message& message, const FramePtr& frame);
  /// The markers visible at the start of the block, and changes since then without a message: call it before
  /// each message and at the end of the range.
  ros::WorldResults before(std::int64_t at_ns);

 private:
  void readStatics();
  void readBefore(std::int64_t from_ns);
  void advance(std::int64_t until_ns);
  /// Removes markers whose lifetime is over, each at its time.
  void endMarkers(std::int64_t until_ns, ros::WorldResults& results);
  ros::WorldResults takeNow(const recording::Message& message, const FramePtr& frame);
  ros::WorldResult takeGrid(const ros::Source& source, const ros::Field& msg, std::int64_t at_ns);
  ros::WorldResult takePatch(const ros::Source& source, const ros::Field& msg, std::int64_t at_ns);
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
  std::optional<ros::RosWorld::Located> located_;  // as it was told last
  std::set<std::string> folded_;                   // grids whose present state is in GridFolds
};

}  // namespace mapwright::robot::recorded
