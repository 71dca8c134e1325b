#include "robot/recorded/grid_folds.h"

#include "robot/ros/ros_world.h"

namespace mapwright::robot::recorded {

void GridFolds::set(const std::string& topic, const ros::Grid& grid, std::int64_t at_ns) {
  folds_.insert_or_assign(topic, Fold{grid, at_ns, at_ns});
}

ros::Grid* GridFolds::made(const std::string& topic) {
  const auto known = folds_.find(topic);
  return known == folds_.end() ? nullptr : &known->second.grid;
}

void GridFolds::patched(const std::string& topic, std::int64_t at_ns) {
  if (const auto known = folds_.find(topic); known != folds_.end()) known->second.until_ns = at_ns;
}

ros::Grid* GridFolds::before(const std::string& topic, const std::string& patches, std::int64_t at_ns) {
  const std::vector<recording::Message> last = file_.lastBefore(at_ns, {topic});
  if (last.empty()) return nullptr;
  const std::int64_t whole_ns = last.front().log_time_ns;
  const auto known = folds_.find(topic);
  if (known == folds_.end() || known->second.whole_ns != whole_ns || known->second.until_ns > at_ns) {
    const auto frame = fields_.read(last.front());
    if (!frame) return nullptr;
    auto grid = ros::readGrid((*frame)->root());
    if (!grid) return nullptr;
    set(topic, *grid, whole_ns);
  }
  Fold& fold = folds_.at(topic);
  recording::Query query;
  query.first_ns = fold.until_ns;
  query.last_ns = at_ns - 1;
  query.topics = {patches};
  if (query.last_ns <= query.first_ns) return &fold.grid;
  const bool anew = fold.until_ns == fold.whole_ns;
  const auto cursor = file_.messages(query);
  while (const auto message = cursor->next()) {
    if (!anew && message->log_time_ns == fold.until_ns) continue;  // already applied
    const auto frame = fields_.read(*message);
    if (!frame) continue;
    // Its errors are reported where it is played.
    if (const auto patch = ros::readGridPatch((*frame)->root())) (void)ros::patchGrid(fold.grid, *patch);
  }
  fold.until_ns = query.last_ns;
  return &fold.grid;
}

}  // namespace mapwright::robot::recorded
