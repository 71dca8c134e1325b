// A request while the link of a robot works on it: everything that was started for it.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>

#include <QObject>

#include "robot/call.h"

class QTimer;

namespace mapwright::robot::wire {

/// Everything in progress for one request, so that it can be cancelled together. Belongs to the thread of the
/// link; may be created and destroyed anywhere.
class Task {
 public:
  using Listener = std::function<void(Progress)>;
  explicit Task(Listener listener = {}) : listener_(std::move(listener)) {}

  /// Something was started that `stop` cancels, from within cancel(). If already cancelled, `stop` is called
  /// at once. The number is for ended().
  int begun(std::function<void()> stop);
  void ended(int number) { in_progress_.erase(number); }
  /// Cancels everything in progress, and everything started later.
  void cancel();
  void reportProgress(Progress progress) const {
    if (listener_) listener_(progress);
  }

 private:
  Listener listener_;
  std::map<int, std::function<void()>> in_progress_;
  int last_ = 0;
  bool cancelled_ = false;
};
using TaskPtr = std::shared_ptr<Task>;

/// Tasks that wait until something is so. Each wait ends once; those that are left when this is destroyed are
/// dropped silently. Lives on the thread of the link.
class WaitList : public QObject {
 public:
  enum class End { Held, TooLate, Cancelled, Dropped };
  using Then = std::function<void(End)>;

  /// Calls `then` at once if the condition holds already, else from look() or drop(), when `within` has
  /// passed (nullopt: no time limit), or after `task` was cancelled.
  void await(const TaskPtr& task, std::optional<std::chrono::milliseconds> within,
             std::function<bool()> holds, Then then);
  /// Something has changed: waits whose condition holds now end.
  void look();
  /// There is nothing to wait for any more.
  void drop();
  bool empty() const { return waiting_.empty(); }

 private:
  struct Wait {
    std::function<bool()> holds;
    Then then;
    TaskPtr task;
    int number = 0;           // of the task
    QTimer* timer = nullptr;  // a child of this; null: no time limit
  };
  using WaitPtr = std::shared_ptr<Wait>;
  void end(const WaitPtr& wait, End how);

  std::list<WaitPtr> waiting_;
};

}  // namespace mapwright::robot::wire
