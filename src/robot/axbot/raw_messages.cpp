#include "robot/axbot/raw_messages.h"

#include <algorithm>

#include <google/protobuf/util/json_util.h>

#include "robot/axbot/parse_topics.h"
#include "ros_messages/wrapper.pb.h"

namespace mapwright::robot::axbot {
namespace {

constexpr std::size_t kReadable = std::size_t(512)
                                  << 10;  // longer messages would take longer to format than to read
constexpr std::size_t kDumped = std::size_t(64) << 10;
constexpr std::size_t kRow = 16;

RawMessage started(const std::string& topic, std::size_t bytes, bool binary) {
  RawMessage message;
  message.topic = QString::fromStdString(topic);
  message.received = QDateTime::currentDateTimeUtc();
  message.bytes = qint64(bytes);
  message.binary = binary;
  return message;
}

/// The beginning of a text, without splitting a character.
QByteArray beginning(std::string_view utf8) {
  std::size_t end = std::min(utf8.size(), std::size_t(kMaxRawText));
  while (end > 0 && end < utf8.size() && (std::uint8_t(utf8[end]) & 0xc0) == 0x80) --end;
  return QByteArray(utf8.data(), qsizetype(end));
}

QByteArray hexDump(std::string_view bytes) {
  QByteArray dump;
  const std::string_view shown = bytes.substr(0, kDumped);
  for (std::size_t at = 0; at < shown.size(); at += kRow) {
    const std::string_view row = shown.substr(at, kRow);
    dump += QByteArray::number(qulonglong(at), 16).rightJustified(8, '0') + "  " +
            QByteArray::fromRawData(row.data(), qsizetype(row.size()))
                .toHex(' ')
                .leftJustified(qsizetype(3 * kRow));
    for (const char c : row) dump += c >= 0x20 && c < 0x7f ? c : '.';
    dump += '\n';
  }
  if (shown.size() < bytes.size()) {
    dump += "and " + QByteArray::number(qulonglong(bytes.size() - shown.size())) + " bytes more\n";
  }
  return dump;
}

}  // namespace

RawMessage rawText(const std::string& topic, std::string_view utf8) {
  RawMessage message = started(topic, utf8.size(), false);
  message.text = beginning(utf8);
  return message;
}

RawMessage rawBinary(std::string_view bytes) {
  const auto frame = unpackBinaryFrame(bytes);
  RawMessage message = started(frame ? frame->topic : frame.error().topic, bytes.size(), true);
  ros_messages::RosMessageWrapper wrapper;
  std::string json;
  const bool readable = frame && frame->body.size() <= kReadable && !frame->body.empty() &&
                        wrapper.ParseFromString(frame->body) &&
                        wrapper.message_case() != ros_messages::RosMessageWrapper::MESSAGE_NOT_SET &&
                        google::protobuf::util::MessageToJsonString(wrapper, &json).ok();
  message.text = readable ? beginning(json) : hexDump(frame ? std::string_view(frame->body) : bytes);
  return message;
}

}  // namespace mapwright::robot::axbot
