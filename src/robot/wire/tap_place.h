// The current tap for a robot's frames.
#pragma once

#include <mutex>
#include <utility>

#include "robot/robot.h"

namespace mapwright::robot::wire {

/// Thread-safe: set on one thread, called on another.
class TapPlace {
 public:
  /// Returns when the previous tap is no longer being called.
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
