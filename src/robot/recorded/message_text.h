// A message of a recording as one JSON object: for people (the inspector) or for programs (frames, export).
// Pure. Source: docs/command-line.md, "mapwright bags" (frames).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "recording/message.h"
#include "robot/recorded/message_fields.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::recorded {

/// A text as JSON.
std::string jsonText(std::string_view text);

/// All of them contain "topic" and "__stamp", the log time. Messages that are not JSON are put into {"topic",
/// "__stamp", "type", "msg"}.
class MessageText {
 public:
  /// People see the beginnings of long lists and texts (net::rosbridge::Field::toJson); for programs nothing
  /// is truncated, and unreadable data is included as bytes.
  enum class For { People, Programs };
  /// The message outlives it.
  MessageText(const recording::Message& message, For whom)
      : message_(message), programs_(whom == For::Programs) {}

  std::string_view bytes() const;
  /// `frame` is the result of MessageFields::read().
  std::string ofRos(const tl::expected<FramePtr, Fault>& frame, MessageFields& fields) const;
  /// A JSON object as recorded, with missing members appended.
  std::string ofFrame(const wire::Json& root) const;
  /// A non-text frame of Autoxing.
  std::string ofBinaryFrame() const;
  /// For an encoding that no layer uses.
  std::string ofOther(MessageFields& fields) const;
  /// {"bytes": how many}; for programs also "base64".
  std::string ofBytes() const;

 private:
  std::string wrapped(std::string_view member, std::string_view json) const;
  std::string whole(const FramePtr& frame) const;

  const recording::Message& message_;
  bool programs_;
};

}  // namespace mapwright::robot::recorded
