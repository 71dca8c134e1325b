// The mapping tasks of the simulated robot: past ones, and the running one.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "simulator/map_pictures.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

struct MappingTask {
  int id = 0;
  std::string state;  // running, finished, cancelled, failed
  bool continues = false;
  std::int64_t started_s = 0;
  std::optional<std::int64_t> ended_s;
  std::optional<PictureSpec> spec;  // what it made
};

/// What a mapping has seen so far; `new_only` excludes the map that it continues.
PictureSpec specOf(const MappingSpan& span, bool new_only);

/// Safe from any thread. While a task runs, the robot's SLAM session is that mapping.
class MappingTasks {
 public:
  explicit MappingTasks(RobotState& state);

  std::vector<MappingTask> tasks() const;  // newest first
  std::optional<MappingTask> find(int id) const;
  std::optional<MappingTask> running() const;

  /// nullopt if one is already running.
  std::optional<MappingTask> start(Mapping mapping);
  enum class End { Finished, FinishedNewOnly, Cancelled };
  /// nullopt when none runs.
  std::optional<MappingTask> end(End how);

  enum class Removal { Removed, Missing, Running };
  Removal remove(int id);
  /// Running, with nothing removed, while one is running.
  Removal removeAll();

 private:
  bool runs() const { return !tasks_.empty() && tasks_.front().state == "running"; }

  RobotState& state_;
  mutable std::mutex mutex_;
  std::vector<MappingTask> tasks_;
  int next_id_ = 1;
};

}  // namespace mapwright::simulator
