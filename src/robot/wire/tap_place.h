// Where whoever wants every frame of a robot sits.
#pragma once

#include <mutex>
#include <utility>

#include "robot/robot.h"

namespace mapwright::robot::wire {

/// Thread-safe: set on one thread, passed through on another.
class TapPlace {
 public:
  /// Returns once the tap of before is not being called any more.
  void set(FrameTap tap) {
    const std::lock_guard lock(mutex_);
    tap_ = std::move(tap);
  }
  void pass(const RawFrame& frame) const {
    const std::lock_guard lock(mutex_);
    if (tap_) tap_(frame);
  }

 private:
  mutable std::mutex mutex_;
  FrameTap tap_;
};

}  // namespace mapwright::robot::wire
