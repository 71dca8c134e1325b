#include "ui/slam/submap_stepper.h"

#include <utility>

#include "submap/submap_store.h"

namespace mapwright::ui {

void SubmapStepper::setSession(session::Session* session) {
  giveBack();
  session_ = session;
}

bool SubmapStepper::wanted(map::SubmapId id, bool visible) const {
  const auto held = held_.find(id);
  return held != held_.end() && visible == held->second.now ? held->second.before : visible;
}

void SubmapStepper::showOnly(const std::vector<map::SubmapId>& ids, std::size_t shown) {
  if (!session_) return;
  std::map<map::SubmapId, bool> visible;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const submap::SubmapRow* const row = session_->submaps().find(ids[i]);
    if (!row) continue;
    const bool before = wanted(ids[i], row->visible);
    held_[ids[i]] = {before, i == shown};
    visible[ids[i]] = i == shown;
  }
  setVisible(visible);
}

void SubmapStepper::giveBack() {
  std::map<map::SubmapId, bool> visible;
  for (const auto& [id, held] : std::exchange(held_, {})) {
    const submap::SubmapRow* const row = session_ ? session_->submaps().find(id) : nullptr;
    if (row && row->visible == held.now) visible[id] = held.before;
  }
  setVisible(visible);
}

void SubmapStepper::setVisible(const std::map<map::SubmapId, bool>& visible) {
  for (const bool shows : {true, false}) {
    std::vector<map::SubmapId> ids;
    for (const auto& [id, is_shown] : visible) {
      if (is_shown == shows) ids.push_back(id);
    }
    if (!ids.empty() && session_) session_->setVisible(ids, shows);
  }
}

}  // namespace mapwright::ui
