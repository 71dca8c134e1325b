// Grids with the patches that were sent since. One thread.
#pragma once

#include <map>
#include <string>

#include "recording/source.h"
#include "robot/recorded/message_fields.h"
#include "robot/ros/read_messages.h"

namespace mapwright::robot::recorded {

/// What a grid is at a time is made of the last whole one before and of all patches since: the same whatever
/// was read before. What was made last of each grid is kept, so that going on costs the new patches alone.
class GridFolds {
 public:
  GridFolds(recording::Source& file, MessageFields& fields) : file_(file), fields_(fields) {}

  /// A whole one came.
  void set(const std::string& topic, const ros::Grid& grid, std::int64_t at_ns);
  /// The grid of `topic` as it was before `at_ns`; null: there is none. Valid until the next call.
  ros::Grid* before(const std::string& topic, const std::string& patches, std::int64_t at_ns);
  /// The same without looking whether there is anything newer than what was made last; null: nothing was.
  ros::Grid* made(const std::string& topic);
  /// The patches until then have been put into it.
  void patched(const std::string& topic, std::int64_t at_ns);

 private:
  struct Fold {
    ros::Grid grid;
    std::int64_t whole_ns = 0;  // when the whole one came
    std::int64_t until_ns = 0;  // patches of this time are in it
  };
  recording::Source& file_;
  MessageFields& fields_;
  std::map<std::string, Fold> folds_;  // by topic
};

}  // namespace mapwright::robot::recorded
