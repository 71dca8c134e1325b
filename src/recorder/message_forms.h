// The format of recorded messages, so that other programs can read them: by their type definition, or as JSON
// if there is none (layout.h). One thread.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "recorder/entry_queue.h"
#include "recording/message.h"
#include "recording/ros_schema.h"

namespace mapwright::recorder {

class MessageForms {
 public:
  /// Whether it can be written: its type is defined, never will be, or does not matter.
  bool ready(const Entry& message) const;
  /// A definition (robot::Delivery::Kind::Definition) of type `name` for `encoding`. Empty bytes: not
  /// available. The first valid one counts: messages that do not match it are written as received.
  void define(const Entry& definition);
  /// Stop waiting for the definition. If it still comes it is used from then on.
  void giveUp(const std::string& type);

  /// The message with content `bytes` in its final form, and the encodings and schema of its channel.
  struct Formed {
    std::string encoding, schema_name, schema_encoding, schema_data;
    std::string bytes;
  };
  Formed formed(const Entry& message, std::string bytes) const;

 private:
  struct Definition {
    std::string encoding, text;               // empty: not available
    std::optional<recording::RosSchema> ros;  // for ROS types, if it can be parsed
  };
  static Formed asJson(const Entry& message, std::string bytes);
  std::map<std::string, Definition> definitions_;  // by type
};

}  // namespace mapwright::recorder
