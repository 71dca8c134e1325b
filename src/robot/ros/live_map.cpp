#include "robot/ros/live_map.h"

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

map::Failure failure(const map::MapKey& key, wire::WaitList::End how) {
  using End = wire::WaitList::End;
  map::Failure failure;
  failure.kind = how == End::TooLate   ? map::FailureKind::TimedOut
                 : how == End::Dropped ? map::FailureKind::Unreachable
                                       : map::FailureKind::Cancelled;
  failure.subject = map::subjectOf(key);
  if (how == End::TooLate) failure.cause = {fault::NoAnswerInTime};
  if (how == End::Dropped) failure.cause = {fault::LinkBrokeOff};
  return failure;
}

}  // namespace

void LiveMap::take(const map::GridMessage& grid) {
  last_ = grid;
  waits_.look();
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

void LiveMap::fetch(const wire::TaskPtr& task, const map::MapKey& key, const std::string& name,
                    OutcomeTo<map::WholeMap> reply, std::chrono::milliseconds longer) {
  waits_.await(
      task, patience_ + longer, [this] { return last_.has_value(); },
      [this, key, name, reply = std::move(reply)](wire::WaitList::End how) {
        if (how == wire::WaitList::End::Held) {
          reply(wholeMap(*last_, key, name));
        } else {
          reply(fail(failure(key, how)));
        }
        Q_EMIT wantedChanged();
      });
  Q_EMIT wantedChanged();
}

}  // namespace mapwright::robot::ros

#include "moc_live_map.cpp"
