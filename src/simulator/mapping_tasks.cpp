#include "simulator/mapping_tasks.h"

#include <cmath>

#include "simulator/stamp.h"

namespace mapwright::simulator {
namespace {

constexpr int kLiveTrajectory = 1, kFinishedMap = 0, kGatehouse = 3;

std::int64_t stampNow(const RobotState& state) {
  return static_cast<std::int64_t>(std::floor(stampOf(state.time())));
}

PictureSpec wholeOf(int trajectory) {
  PictureSpec spec;
  spec.trajectory = trajectory;
  return spec;
}

}  // namespace

PictureSpec specOf(const MappingSpan& span, bool new_only) {
  PictureSpec spec = wholeOf(kLiveTrajectory);
  spec.from_m = span.from_m;
  spec.scans = span.scans;
  if (span.mapping == Mapping::Continue && !new_only) spec.base = kFinishedMap;
  return spec;
}

MappingTasks::MappingTasks(RobotState& state) : state_(state) {
  if (state.scene().trajectories.empty()) return;
  tasks_ = {{48, "finished", false, 1717401600, 1717405100, wholeOf(kFinishedMap)},
            {47, "cancelled", false, 1647494329, std::nullopt, std::nullopt},
            {31, "finished", false, 1643001000, 1643006900, wholeOf(kGatehouse)},
            {30, "failed", false, 1643000000, 1643000100, std::nullopt}};
  next_id_ = tasks_.front().id + 1;
}

std::vector<MappingTask> MappingTasks::tasks() const {
  const std::lock_guard lock(mutex_);
  return tasks_;
}

std::optional<MappingTask> MappingTasks::find(int id) const {
  for (MappingTask& task : tasks()) {
    if (task.id == id) return std::move(task);
  }
  return std::nullopt;
}

std::optional<MappingTask> MappingTasks::running() const {
  const std::lock_guard lock(mutex_);
  if (!runs()) return std::nullopt;
  return tasks_.front();
}

std::optional<MappingTask> MappingTasks::start(Mapping mapping) {
  const std::lock_guard lock(mutex_);
  if (runs()) return std::nullopt;
  state_.setMapping(mapping);
  MappingTask task;
  task.id = next_id_++;
  task.state = "running";
  task.continues = mapping == Mapping::Continue;
  task.started_s = stampNow(state_);
  tasks_.insert(tasks_.begin(), task);
  return task;
}

std::optional<MappingTask> MappingTasks::end(End how) {
  const std::lock_guard lock(mutex_);
  const std::optional<MappingSpan> span = state_.mapping();
  if (!runs() || !span) return std::nullopt;
  MappingTask& task = tasks_.front();
  task.ended_s = stampNow(state_);
  task.state = how == End::Cancelled ? "cancelled" : "finished";
  if (how != End::Cancelled) task.spec = specOf(*span, how == End::FinishedNewOnly);
  state_.setMapping(Mapping::Off);
  return task;
}

MappingTasks::Removal MappingTasks::remove(int id) {
  const std::lock_guard lock(mutex_);
  if (runs() && tasks_.front().id == id) return Removal::Running;
  return std::erase_if(tasks_, [&](const MappingTask& task) { return task.id == id; }) > 0 ? Removal::Removed
                                                                                           : Removal::Missing;
}

MappingTasks::Removal MappingTasks::removeAll() {
  const std::lock_guard lock(mutex_);
  if (runs()) return Removal::Running;
  tasks_.clear();
  return Removal::Removed;
}

}  // namespace mapwright::simulator
