#include "ui/slam/work_pace.h"

namespace mapwright::ui {

void WorkPace::update(Ms now, bool busy, bool current) {
  now_ = now;
  if (!busy) {
    busy_since_.reset();
  } else if (!busy_since_) {
    busy_since_ = now;
  }
  if (current) {
    if (!current_since_) current_since_ = now;
  } else if (current_since_) {
    current_since_.reset();
    first_ = false;
  }
}

std::optional<WorkPace::Ms> WorkPace::changesIn() const {
  if (busy_since_ && !isLong()) return *busy_since_ + kLong - now_;
  if (current_since_ && !isSettled()) return *current_since_ + kQuiet - now_;
  return std::nullopt;
}

}  // namespace mapwright::ui
