// A request while the robot's link works on it.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "robot/call.h"

namespace mapwright::robot::wire {

/// Everything in progress for one request, so that it can be cancelled together. Belongs to the thread of the
/// link; may be created and destroyed anywhere.
class Errand {
 public:
  using Told = std::function<void(Progress)>;
  explicit Errand(Told told = {}) : told_(std::move(told)) {}

  /// Something was started that `stop` cancels, from within cancel(). If already cancelled, `stop` is called
  /// at once. The number is for ended().
  int begun(std::function<void()> stop);
  void ended(int number) { under_way_.erase(number); }
  /// Cancels everything in progress, and everything started later.
  void cancel();
  void tell(Progress progress) const {
    if (told_) told_(progress);
  }

 private:
  Told told_;
  std::map<int, std::function<void()>> under_way_;
  int last_ = 0;
  bool cancelled_ = false;
};
using ErrandPtr = std::shared_ptr<Errand>;

}  // namespace mapwright::robot::wire
