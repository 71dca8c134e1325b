#include "ui/window/stalls.h"

#include <algorithm>

#include <QEvent>
#include <QMetaEnum>

namespace mapwright::ui {

QString Busy::text() const {
  const char* const name = QMetaEnum::fromType<QEvent::Type>().valueToKey(event);
  return QStringLiteral("%1, %2").arg(name ? QString::fromLatin1(name) : QString::number(event),
                                      QString::fromLatin1(receiver));
}

void Stalls::add(Duration duration, const Busy& busy) {
  const auto below = std::find_if(kBelowMs.begin(), kBelowMs.end(),
                                  [&](int ms) { return duration < std::chrono::milliseconds(ms); });
  ++counts_[std::size_t(below - kBelowMs.begin())];
  if (duration <= longest_) return;
  longest_ = duration;
  during_ = busy;
}

bool StallMeter::begins(int level, Time now, const Busy& busy) {
  if (level == 0) return false;
  if (!events_.empty()) {
    if (events_.back().level >= level) return false;
    pause(now);
  }
  events_.push_back({level, now, busy});
  return true;
}

void StallMeter::ends(Time now) {
  stalls_.add(now - events_.back().since, events_.back().busy);
  events_.pop_back();
  // Perhaps that was the last event of the inner loop.
  if (!events_.empty()) events_.back().since = now;
}

void StallMeter::waits(Time now) {
  if (!events_.empty()) pause(now);
}

void StallMeter::wakes(Time now) {
  if (!events_.empty()) events_.back().since = now;
}

void StallMeter::pause(Time now) {
  Event& event = events_.back();
  if (!event.paused) stalls_.add(now - event.since, event.busy);
  event.paused = true;
}

}  // namespace mapwright::ui
