#include "robot/wire/task.h"

#include <algorithm>
#include <utility>

#include <QTimer>

namespace mapwright::robot::wire {

int Task::begun(std::function<void()> stop) {
  const int number = ++last_;
  if (cancelled_) {
    stop();
  } else {
    in_progress_[number] = std::move(stop);
  }
  return number;
}

void Task::cancel() {
  cancelled_ = true;
  for (const auto& [number, stop] : std::exchange(in_progress_, {})) stop();
}

void WaitList::await(const TaskPtr& task, std::optional<std::chrono::milliseconds> within,
                     std::function<bool()> holds, Then then) {
  if (holds()) return then(End::Held);
  const auto wait = std::make_shared<Wait>(Wait{std::move(holds), std::move(then), task});
  const auto ends = [this, held = std::weak_ptr(wait)](End how) {
    if (const WaitPtr now = held.lock()) end(now, how);
  };
  if (within) {
    wait->timer = new QTimer(this);
    wait->timer->setSingleShot(true);
    connect(wait->timer, &QTimer::timeout, this, [ends] { ends(End::TooLate); });
    wait->timer->start(*within);
  }
  waiting_.push_back(wait);
  // Later: nothing ends from within its beginning.
  wait->number = task->begun([this, ends] {
    QMetaObject::invokeMethod(
        this, [ends] { ends(End::Cancelled); }, Qt::QueuedConnection);
  });
}

void WaitList::end(const WaitPtr& wait, End how) {
  const auto found = std::find(waiting_.begin(), waiting_.end(), wait);
  if (found == waiting_.end()) return;
  const WaitPtr ending = wait;
  waiting_.erase(found);
  if (ending->timer) {
    ending->timer->stop();
    ending->timer->deleteLater();  // it may be the sender of the current signal
  }
  ending->task->ended(ending->number);
  ending->then(how);
}

void WaitList::look() {
  const std::list<WaitPtr> now = waiting_;
  for (const WaitPtr& wait : now) {
    if (wait->holds()) end(wait, End::Held);
  }
}

void WaitList::drop() {
  const std::list<WaitPtr> now = waiting_;
  for (const WaitPtr& wait : now) end(wait, End::Dropped);
}

}  // namespace mapwright::robot::wire
