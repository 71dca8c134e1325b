#include "robot/ros/live_map.h"

#include <algorithm>
#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {
namespace {

map::WholeMap wholeMap(const map::GridMessage& grid, const map::MapKey& key, const std::string& name) {
  map::WholeMap map;
  map.key = key;
  map.name = name;
  map.grid = grid.grid;
  map.reading = grid.reading;
  map.bytes = grid.png;
  map.body_bytes = grid.png ? grid.png->size() : 0;
  map.fingerprint = grid.fingerprint;
  return map;
}

map::Failure failure(const map::MapKey& key, map::FailureKind kind, FaultCode cause) {
  map::Failure failure;
  failure.kind = kind;
  failure.subject = map::subjectOf(key);
  failure.cause = {cause};
  return failure;
}

}  // namespace

void LiveMap::take(const map::GridMessage& grid) {
  last_ = grid;
  const std::list<Entry> now = waiting_;
  for (const Entry& entry : now) end(entry, wholeMap(grid, entry->key, entry->name));
  Q_EMIT came();
}

std::shared_ptr<void> LiveMap::listen() {
  if (std::shared_ptr<void> held = listeners_.lock()) return held;
  const std::shared_ptr<void> made(static_cast<void*>(this), [self = QPointer<LiveMap>(this)](void*) {
    if (self) Q_EMIT self->wantedChanged();
  });
  listeners_ = made;
  Q_EMIT wantedChanged();
  return made;
}

void LiveMap::fetch(const wire::ErrandPtr& errand, const map::MapKey& key, const std::string& name,
                    OutcomeTo<map::WholeMap> reply, std::chrono::milliseconds longer) {
  if (last_) return reply(wholeMap(*last_, key, name));
  const auto entry = std::make_shared<Waiting>();
  entry->key = key;
  entry->name = name;
  entry->reply = std::move(reply);
  entry->errand = errand;
  entry->patience = std::make_unique<QTimer>();
  entry->patience->setSingleShot(true);
  const auto endAs = [this, held = std::weak_ptr(entry)](map::FailureKind kind, FaultCode cause) {
    if (const Entry now = held.lock()) end(now, tl::make_unexpected(failure(now->key, kind, cause)));
  };
  connect(entry->patience.get(), &QTimer::timeout, this,
          [endAs] { endAs(map::FailureKind::TimedOut, fault::NoAnswerInTime); });
  entry->patience->start(patience_ + longer);
  waiting_.push_back(entry);
  entry->number = errand->begun([this, endAs] {
    QMetaObject::invokeMethod(
        this, [endAs] { endAs(map::FailureKind::Cancelled, FaultCode()); }, Qt::QueuedConnection);
  });
  Q_EMIT wantedChanged();
}

void LiveMap::end(const Entry& entry, Outcome<map::WholeMap> outcome) {
  const auto found = std::find(waiting_.begin(), waiting_.end(), entry);
  if (found == waiting_.end()) return;
  waiting_.erase(found);
  entry->patience->stop();
  entry->patience->setParent(this);          // deleted with this at the latest
  entry->patience.release()->deleteLater();  // it may be emitting the current signal
  entry->errand->ended(entry->number);
  entry->reply(std::move(outcome));
  Q_EMIT wantedChanged();
}

void LiveMap::endAll(const map::Failure& failure) {
  const std::list<Entry> now = waiting_;
  for (const Entry& entry : now) {
    map::Failure own = failure;
    own.subject = map::subjectOf(entry->key);
    end(entry, tl::make_unexpected(std::move(own)));
  }
}

}  // namespace mapwright::robot::ros

#include "moc_live_map.cpp"
