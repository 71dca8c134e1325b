#include "robot/recorded/message_fields.h"

#include <cstdlib>
#include <utility>

#include "recorder/layout.h"
#include "recording/known_definitions.h"
#include "recording/ros_cbor.h"
#include "recording/ros_idl.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_topics.h"
#include "robot/recorded/faults.h"
#include "robot/recorded/foxglove.h"
#include "robot/recorded/recording_reasons.h"
#include "robot/ros/faults.h"

namespace mapwright::robot::recorded {

using net::rosbridge::Frame;

namespace {

tl::expected<FramePtr, Fault> frameOf(const QByteArray& bytes, Frame::Wire wire) {
  FramePtr frame = Frame::read(bytes, wire);
  switch (frame->fault()) {
    case Frame::Fault::None:
      return frame;
    case Frame::Fault::NotJson:
      return tl::unexpected(Fault(robot::axbot::fault::MessageNotJson, {std::int64_t(bytes.size())}));
    default:
      return tl::unexpected(Fault(robot::ros::fault::MessageNotUnderstood));
  }
}

Fault missing(const recording::Channel& channel) { return {fault::RosSchemaMissing, {channel.schema_name}}; }

tl::expected<recording::RosSchema, Fault> rosSchemaOf(const recording::Channel& channel,
                                                      std::span<const std::uint8_t> message) {
  const auto dialect = recording::rosDialect(channel.schema_encoding);
  const auto reason = [&](const recording::RosSchemaFault& fault) {
    return reasonOf(fault, channel.schema_name);
  };
  if (channel.schema_data.empty() && channel.message_encoding == "cdr") {
    // Recorders may leave out the definition. Of several releases that one counts which the message fits.
    const std::vector<std::string> known = recording::knownDefinitions(channel.schema_name);
    for (const std::string& text : known) {
      if (&text == &known.back() || recording::fitsDefinition(channel.schema_name, text, message))
        return recording::parseRosSchema(channel.schema_name, text, recording::RosDialect::Ros2)
            .map_error(reason);
    }
  }
  if (channel.schema_data.empty() && !dialect) return tl::unexpected(missing(channel));
  if (channel.schema_encoding == "ros2idl")
    return recording::parseRosIdl(channel.schema_name, channel.schema_data).map_error(reason);
  if (!dialect)
    return tl::unexpected(
        Fault(fault::RosEncodingUnknown, {channel.message_encoding, channel.schema_encoding}));
  return recording::parseRosSchema(channel.schema_name, channel.schema_data, *dialect).map_error(reason);
}

/// The schema of a channel, which is read once.
template <typename Known, typename Read>
const auto& schemaOf(Known& all, const recording::ChannelPtr& channel, Read read) {
  const auto known = all.find(channel->id);
  if (known != all.end() && known->second.channel == channel) return known->second.schema;
  return all.insert_or_assign(channel->id, typename Known::mapped_type{channel, read(*channel)})
      .first->second.schema;
}

/// The maximum size of a message without members: CDR has a header, a byte for the members, and padding.
std::size_t bytesOfNothing(recording::RosWire wire) { return wire == recording::RosWire::Cdr ? 8 : 0; }

constexpr std::int64_t kNsOfASecond = 1'000'000'000;
constexpr qsizetype kMostText = qsizetype(8) << 10;  // of a message with truncated lists
constexpr std::size_t kMostWhole = std::size_t(16) << 10;
constexpr std::int64_t kStampRoundingNs = 2'000;  // of a double for seconds since 1970

std::string secondsText(std::int64_t ns) {
  const std::int64_t whole = ns / kNsOfASecond - (ns % kNsOfASecond < 0), rest = ns - whole * kNsOfASecond;
  std::string digits = std::to_string(rest);
  return std::to_string(whole) + '.' + std::string(9 - digits.size(), '0') + digits;
}

bool isStamp(double stamp_s, std::int64_t time_ns) {
  return std::abs(recording::nanosecondsOf(stamp_s) - time_ns) <= kStampRoundingNs;
}

std::string_view viewOf(const QByteArray& bytes) { return {bytes.constData(), std::size_t(bytes.size())}; }

/// Numbers that robots send although they are not valid JSON.
bool holdsNoNumbers(std::string_view json) {
  return json.find("NaN") != json.npos || json.find("nan") != json.npos || json.find("nf") != json.npos;
}

}  // namespace

bool isRos(const recording::Channel& channel, bool untyped) {
  const std::string& encoding = channel.message_encoding;
  if (encoding == "protobuf" || encoding == "json") {
    if (foxgloveKind(channel)) return true;
  }
  if (recording::rosWire(encoding) || encoding == "cbor") return true;
  if (encoding != "json") return false;
  return isUntyped(channel) ? untyped : channel.schema_name.find('/') != std::string::npos;
}

bool isUntyped(const recording::Channel& channel) {
  return channel.schema_name.empty() || channel.schema_name == recorder::kPlainJson;
}

std::string rosTypeOf(const recording::Channel& channel) {
  const auto kind = foxgloveKind(channel);
  if (kind) return rosTypeOf(*kind);
  return isUntyped(channel) ? std::string() : channel.schema_name;
}

tl::expected<FramePtr, Fault> MessageFields::read(const recording::Message& message) {
  auto frame = readAsItIs(message);
  const auto kind = frame ? foxgloveKind(*message.channel) : std::nullopt;
  if (!kind) return frame;
  const auto cbor = foxgloveToRos(*kind, (*frame)->root());
  if (!cbor) return tl::unexpected(cbor.error());
  return frameOf(*cbor, Frame::Wire::Binary);
}

tl::expected<FramePtr, Fault> MessageFields::readAsItIs(const recording::Message& message) {
  beyond_ = 0;
  if (message.channel->message_encoding == "protobuf") {
    const auto& schema = schemaOf(protobuf_schemas_, message.channel, ProtobufSchema::of);
    if (!schema) return tl::unexpected(schema.error());
    const auto cbor = schema->toCbor(message.bytes);
    if (!cbor) return tl::unexpected(cbor.error());
    return frameOf(*cbor, Frame::Wire::Binary);
  }
  const std::string& encoding = message.channel->message_encoding;
  const auto wire = recording::rosWire(encoding);
  if (!wire) {
    // A CBOR frame shares its bytes, so they must be owned.
    const QByteArray bytes(reinterpret_cast<const char*>(message.bytes.data()),
                           qsizetype(message.bytes.size()));
    return frameOf(bytes, encoding == "cbor" ? Frame::Wire::Binary : Frame::Wire::Text);
  }
  const auto& schema = schemaOf(ros_schemas_, message.channel, [&](const recording::Channel& channel) {
    return rosSchemaOf(channel, message.bytes);
  });
  if (!schema) return tl::unexpected(schema.error());
  // An empty definition means a type without members (std_msgs/Empty), if the message agrees.
  if (message.channel->schema_data.empty() && schema->types.front().fields.empty() &&
      message.bytes.size() > bytesOfNothing(*wire))
    return tl::unexpected(missing(*message.channel));
  constexpr std::size_t kMostPadding = 7;  // of CDR
  std::size_t left = 0;
  const auto cbor = recording::rosToCbor(*schema, *wire, message.bytes, &left);
  if (!cbor) return tl::unexpected(reasonOf(cbor.error(), encoding));
  if (wire == recording::RosWire::Ros1 || left > kMostPadding) beyond_ = left;
  return frameOf(*cbor, Frame::Wire::Binary);
}

tl::expected<FramePtr, Fault> MessageFields::readOther(const recording::Message& message) {
  const std::string& encoding = message.channel->message_encoding;
  if (encoding == "protobuf") return readAsItIs(message);
  return tl::unexpected(Fault(
      faultText("recorded", "Messages with encoding \"%1\" are not supported, only their bytes are shown."),
      {encoding}));
}

std::string jsonText(std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (std::uint8_t(c) < 0x20) {
      out += {'\\', 'u', '0', '0', kHex[std::uint8_t(c) >> 4], kHex[c & 15]};
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string_view MessageText::bytes() const {
  return {reinterpret_cast<const char*>(message_.bytes.data()), message_.bytes.size()};
}

std::string MessageText::wrapped(std::string_view member, std::string_view json) const {
  std::string text =
      "{\"topic\":" + jsonText(message_.channel->topic) + ",\"__stamp\":" + secondsText(message_.log_time_ns);
  if (!isUntyped(*message_.channel)) text += ",\"type\":" + jsonText(message_.channel->schema_name);
  return text.append(",\"").append(member).append("\":").append(json).append("}");
}

std::string MessageText::whole(const FramePtr& frame) const {
  if (message_.channel->message_encoding == "json" && !holdsNoNumbers(bytes()))
    return wrapped("msg", bytes());
  return wrapped("msg", viewOf(frame->root().toWholeJson()));
}

std::string MessageText::ofRos(const tl::expected<FramePtr, Fault>& frame, MessageFields& fields) const {
  if (programs_) {
    // The recorded message, not the ROS message made from it for layers.
    const auto recorded = foxgloveKind(*message_.channel) ? fields.readAsItIs(message_) : frame;
    return recorded ? whole(*recorded) : ofBytes();
  }
  if (!frame) return ofBytes();
  const bool as_it_is = message_.channel->message_encoding == "json" && message_.bytes.size() <= kMostWhole;
  return wrapped("msg", as_it_is ? bytes() : viewOf((*frame)->root().toJson(kMostText)));
}

std::string MessageText::ofFrame(const wire::Json& root) const {
  const bool has_topic = root["topic"].error() == simdjson::SUCCESS;
  const bool has_stamp = root["__stamp"].error() == simdjson::SUCCESS;
  // Its own members stay what they are, and those of the recording are told as well.
  // A number in a text is another value: whoever reads the line expects a number there.
  const auto stamp_s = root["__stamp"].is_number() ? wire::number(root, {"__stamp"}) : std::nullopt;
  const bool other_stamp =
      has_stamp &&
      !(stamp_s && (isStamp(*stamp_s, message_.log_time_ns) || isStamp(*stamp_s, message_.publish_time_ns)));
  if (other_stamp || (has_topic && wire::text(root, {"topic"}) != message_.channel->topic))
    return wrapped("msg", bytes());
  std::string added;
  if (!has_topic) added += ",\"topic\":" + jsonText(message_.channel->topic);
  if (!has_stamp) added += ",\"__stamp\":" + secondsText(message_.log_time_ns);
  std::string text(bytes());
  const std::size_t end = text.rfind('}');
  if (added.empty() || end == text.npos) return text;
  simdjson::dom::object members;
  const bool alone = root.get(members) == simdjson::SUCCESS && members.size() == 0;
  return text.insert(end, alone ? added.substr(1) : added);
}

std::string MessageText::ofBinaryFrame() const {
  if (programs_) return ofBytes();
  const QByteArray raw = axbot::rawBinary(bytes()).text;
  const bool json = raw.startsWith('{') && std::size_t(raw.size()) <= kMostWhole;
  return json ? wrapped("msg", viewOf(raw)) : ofBytes();
}

std::string MessageText::ofOther(const tl::expected<FramePtr, Fault>& frame) const {
  if (!frame) return ofBytes();
  return programs_ ? whole(*frame) : wrapped("msg", viewOf((*frame)->root().toJson(kMostText)));
}

std::string MessageText::ofBytes() const {
  std::string count = std::to_string(message_.bytes.size());
  if (!programs_) return wrapped("bytes", count);
  const QByteArray base64 =
      QByteArray::fromRawData(bytes().data(), qsizetype(message_.bytes.size())).toBase64();
  return wrapped("bytes", count.append(",\"base64\":\"").append(viewOf(base64)).append("\""));
}

}  // namespace mapwright::robot::recorded
