#include "robot/wire/errand.h"

#include <utility>

namespace mapwright::robot::wire {

int Errand::begun(std::function<void()> stop) {
  const int number = ++last_;
  if (cancelled_) {
    stop();
  } else {
    under_way_[number] = std::move(stop);
  }
  return number;
}

void Errand::cancel() {
  cancelled_ = true;
  for (const auto& [number, stop] : std::exchange(under_way_, {})) stop();
}

}  // namespace mapwright::robot::wire
