// Grids with the patches sent since. One thread.
#pragma once

#include <map>
#include <string>

#include "recording/source.h"
#include "robot/recorded/message_fields.h"
#include "robot/ros/read_messages.h"

namespace mapwright::robot::recorded {

/// A grid at a time is the last whole one before it with all patches since, whatever was read before. The
/// latest result for each grid is kept, so that continuing only costs the new patches.
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

}  // namespace mapwright::robot::recorded
