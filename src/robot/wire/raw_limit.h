// Rate limit for raw messages shown in a window.
#pragma once

#include <algorithm>

#include "robot/robot.h"

namespace mapwright::robot::wire {

/// Allows at most kMessages and kBytes per second.
class RawLimit {
 public:
  static constexpr int kMessages = 200;
  static constexpr qint64 kBytes = qint64(32) << 20;
  /// Whether a message of this size may pass at `now_ms` of any monotonic clock.
  bool allow(qint64 now_ms, qint64 bytes) {
    if (now_ms / 1000 != second_) {
      second_ = now_ms / 1000;
      messages_ = 0;
      bytes_ = 0;
    }
    if (messages_ >= kMessages || bytes_ >= kBytes) return false;
    ++messages_;
    bytes_ += std::min<qint64>(bytes, kMaxRawText);
    return true;
  }

 private:
  qint64 second_ = -1;
  int messages_ = 0;
  qint64 bytes_ = 0;
};

}  // namespace mapwright::robot::wire
