// In which form messages are written, so that others can read them: by the definition of their type, or as
// JSON where nobody can tell that (layout.h). One thread.
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
  /// Whether it can be written: its type is defined, will not be, or does not matter.
  bool ready(const Entry& message) const;
  /// A definition (robot::Delivery::Kind::Definition): of a type `name`, as `encoding` writes it. Empty
  /// bytes: it cannot be had. The first that can counts: messages that do not fit it are written as they
  /// came.
  void define(const Entry& definition);
  /// Nobody has waited any longer. A definition that comes later counts from then on.
  void giveUp(const std::string& type);

  /// The message, whose content is `bytes`, in its form, and the encodings and schema of the channel that it
  /// belongs to.
  struct Formed {
    std::string encoding, schema_name, schema_encoding, schema_data;
    std::string bytes;
  };
  Formed formed(const Entry& message, std::string bytes) const;

 private:
  struct Definition {
    std::string encoding, text;               // empty: none is to be had
    std::optional<recording::RosSchema> ros;  // of ROS, where it can be read
  };
  static Formed asJson(const Entry& message, std::string bytes);
  std::map<std::string, Definition> definitions_;  // by type
};

}  // namespace mapwright::recorder
