#include "recorder/message_forms.h"

#include <QByteArray>

#include "net/rosbridge/frame.h"
#include "recorder/layout.h"
#include "recorder/ros_encode.h"
#include "recording/ros_decode.h"

namespace mapwright::recorder {
namespace {

using net::rosbridge::Frame;

constexpr const char* kAnyObject = R"({"type":"object"})";

QByteArray bytesOf(const std::string& text) { return {text.data(), qsizetype(text.size())}; }

std::shared_ptr<const Frame> frameOf(const Entry& message, const std::string& bytes) {
  return Frame::read(bytesOf(bytes), message.encoding == "cbor" ? Frame::Wire::Binary : Frame::Wire::Text);
}

bool isText(const Entry& message) { return message.encoding == "json" || message.encoding == "cbor"; }

}  // namespace

bool MessageForms::ready(const Entry& message) const {
  return message.schema.empty() || definitions_.contains(message.schema);
}

void MessageForms::define(const Entry& definition) {
  Definition known;
  if (!definition.bytes.empty()) {
    known.encoding = definition.encoding;
    known.text = definition.bytes;
    if (const auto dialect = recording::rosDialect(known.encoding)) {
      auto schema = recording::parseRosSchema(definition.name, known.text, *dialect);
      if (schema) known.ros = std::move(*schema);
    }
  }
  Definition& held = definitions_[definition.name];
  if (held.encoding.empty()) held = std::move(known);
}

void MessageForms::giveUp(const std::string& type) { definitions_.try_emplace(type); }

MessageForms::Formed MessageForms::formed(const Entry& message, std::string bytes) const {
  const auto found = definitions_.find(message.schema);
  if (found == definitions_.end() || found->second.encoding.empty()) return asJson(message, std::move(bytes));
  const Definition& definition = found->second;
  Formed formed{message.encoding, message.schema, definition.encoding, definition.text, {}};
  if (message.encoding == definition.encoding) {  // "protobuf"
    formed.bytes = std::move(bytes);
    return formed;
  }
  if (!definition.ros || !isText(message)) return asJson(message, std::move(bytes));
  const bool ros2 = recording::rosDialect(definition.encoding) == recording::RosDialect::Ros2;
  const auto frame = frameOf(message, bytes);
  auto encoded =
      encodeRos(*definition.ros, ros2 ? recording::RosWire::Cdr : recording::RosWire::Ros1, frame->root());
  // A message that does not match its definition is written as received.
  if (!encoded) return asJson(message, std::move(bytes));
  formed.encoding = ros2 ? "cdr" : "ros1";
  formed.bytes = std::move(*encoded);
  return formed;
}

MessageForms::Formed MessageForms::asJson(const Entry& message, std::string bytes) {
  Formed formed{"json", message.schema.empty() ? kPlainJson : message.schema, "jsonschema", kAnyObject, {}};
  if (message.encoding == "json") {
    formed.bytes = std::move(bytes);
  } else if (message.encoding == "cbor") {
    formed.bytes = frameOf(message, bytes)->root().toWholeJson().toStdString();
  } else {
    formed.schema_name = kAxbotBinarySchema;
    formed.bytes = "{\"base64\":\"" + bytesOf(bytes).toBase64().toStdString() + "\"}";
  }
  return formed;
}

}  // namespace mapwright::recorder
