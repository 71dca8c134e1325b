// Messages for the raw-message inspector. Source: axbot.md, "WebSocket".
#pragma once

#include <string>
#include <string_view>

#include "robot/robot.h"

namespace mapwright::robot::axbot {

/// A text frame as it came, cut at kMaxRawText.
RawMessage rawText(const std::string& topic, std::string_view utf8);
/// A binary frame as readable JSON where its message is known and not too long, else as a hex dump.
RawMessage rawBinary(std::string_view bytes);

/// Lets no more through than a window can take: kMessages and kBytes in each second.
class RawLimit {
 public:
  static constexpr int kMessages = 200;
  static constexpr qint64 kBytes = qint64(32) << 20;
  /// Whether a message of this size may pass at `now_ms` of any clock that does not run backwards.
  bool allow(qint64 now_ms, qint64 bytes);

 private:
  qint64 second_ = -1;
  int messages_ = 0;
  qint64 bytes_ = 0;
};

}  // namespace mapwright::robot::axbot
