#include "session/safety_watch.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "map/live_state.h"

namespace mapwright::session {

SafetyWatch::SafetyWatch(const map::LiveState& live, std::function<double()> now_s, QObject* parent)
    : QObject(parent), live_(live), now_s_(std::move(now_s)) {
  expiry_.setSingleShot(true);
  connect(&expiry_, &QTimer::timeout, this, &SafetyWatch::look);
}

void SafetyWatch::look() {
  const double now_s = now_s_();
  const std::vector<map::SafetyCondition> before = std::exchange(conditions_, map::safetyOf(live_, now_s));
  if (const auto next_s = map::safetyChangesAt(live_, now_s)) {
    expiry_.start(std::max(1, int((*next_s - now_s) * 1000) + 1));
  } else {
    expiry_.stop();
  }
  if (before == conditions_) return;
  std::multimap<std::string, const map::SafetyCondition*> known;
  for (const map::SafetyCondition& each : before) known.emplace(map::safetyIdentity(each), &each);
  for (const map::SafetyCondition& each : conditions_) {
    const auto same = known.find(map::safetyIdentity(each));
    const bool fresh =
        same == known.end() || same->second->times != each.times || same->second->since_s != each.since_s;
    if (same != known.end()) known.erase(same);
    if (fresh && !each.ended_s) Q_EMIT began(each);
  }
  std::set<std::string> still;  // by the names of their subjects
  for (const map::SafetyCondition& each : conditions_) still.insert(map::problemOf(each).subject.id);
  for (const auto& [identity, gone] : known) {
    if (!still.contains(map::problemOf(*gone).subject.id)) Q_EMIT ended(*gone);
  }
  Q_EMIT changed();
}

}  // namespace mapwright::session

#include "moc_safety_watch.cpp"
