#include "robot/wire/wait_list.h"

#include <algorithm>
#include <utility>

#include <QTimer>

namespace mapwright::robot::wire {

void WaitList::await(const ErrandPtr& errand, std::optional<std::chrono::milliseconds> within,
                     std::function<bool()> holds, Then then) {
  if (holds()) return then(End::Held);
  const auto entry = std::make_shared<Waiting>();
  entry->holds = std::move(holds);
  entry->then = std::move(then);
  entry->errand = errand;
  const auto ends = [this, held = std::weak_ptr(entry)](End how) {
    if (const Entry now = held.lock()) end(now, how);
  };
  if (within) {
    entry->timer = new QTimer(this);
    entry->timer->setSingleShot(true);
    connect(entry->timer, &QTimer::timeout, this, [ends] { ends(End::TooLate); });
    entry->timer->start(*within);
  }
  waiting_.push_back(entry);
  // Later: nothing ends from within its beginning.
  entry->number = errand->begun([this, ends] {
    QMetaObject::invokeMethod(
        this, [ends] { ends(End::Cancelled); }, Qt::QueuedConnection);
  });
}

void WaitList::end(const Entry& entry, End how) {
  const auto found = std::find(waiting_.begin(), waiting_.end(), entry);
  if (found == waiting_.end()) return;
  const Entry ending = entry;
  waiting_.erase(found);
  if (ending->timer) {
    ending->timer->stop();
    ending->timer->deleteLater();  // it may be the one that is speaking
  }
  ending->errand->ended(ending->number);
  ending->then(how);
}

void WaitList::look() {
  const std::list<Entry> now = waiting_;
  for (const Entry& entry : now) {
    if (entry->holds()) end(entry, End::Held);
  }
}

void WaitList::drop() {
  const std::list<Entry> now = waiting_;
  for (const Entry& entry : now) end(entry, End::Dropped);
}

}  // namespace mapwright::robot::wire
