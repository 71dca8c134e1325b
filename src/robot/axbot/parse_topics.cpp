#include "robot/axbot/parse_topics.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <span>
#include <tuple>

#include <QCoreApplication>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/util/json_util.h>

#include "packed/unpack.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_clouds.h"
#include "robot/axbot/parse_maps.h"
#include "robot/axbot/topic_table.h"
#include "robot/faults.h"
#include "robot/wire/picture_bytes.h"
#include "ros_messages/wrapper.pb.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

constexpr std::size_t kMaxPictureBytes = std::size_t(256) << 20;

int size(const wire::JsonList& pair, std::size_t at) {
  Json value;
  if (pair.at(at).get(value)) return 0;
  const auto cells = wire::asInteger(value);
  return cells && *cells > 0 && *cells <= std::numeric_limits<int>::max() ? int(*cells) : 0;
}

map::GridReference gridOf(const Json& message) {
  map::GridReference grid;
  grid.resolution_m = wire::number(message, {"resolution"}).value_or(wire::kNaN);
  if (const auto pair = wire::list(message, {"size"}); pair && pair->size() >= 2) {
    grid.width = size(*pair, 0);
    grid.height = size(*pair, 1);
  }
  const auto origin = wire::member(message, {"origin"});
  grid.origin =
      (origin ? wire::asPose(*origin) : std::nullopt).value_or(geometry::Pose2{wire::kNaN, wire::kNaN, 0});
  return grid;
}

/// A picture topic: sets frame.message or frame.grid_to_fetch.
void readGridTopic(map::GridKind kind, const Json& message, TextFrame& frame) {
  const auto refuse = [&](Fault why) {
    frame.message =
        map::UnreadableMessage{frame.topic, std::move(why).followedBy(Consequence::PictureBeforeStays)};
  };
  map::GridMessage grid;
  grid.topic = frame.topic;
  grid.kind = kind;
  grid.grid = gridOf(message);
  if (const auto why = map::unusableReason(grid.grid)) return refuse(*why);
  std::string_view data, url;
  if (const auto given = wire::member(message, {"data"})) std::ignore = given->get(data);
  if (const auto given = wire::member(message, {"data_url"})) std::ignore = given->get(url);
  if (data.empty() && url.starts_with("data:")) data = url;
  if (!data.empty()) {
    auto picture = wire::fromBase64(data, kMaxPictureBytes);
    if (!picture || picture->empty()) {
      return refuse(faultText("axbot", "The picture in the message is not valid base64, or too large."));
    }
    grid.fingerprint = wire::fingerprint(*picture);
    grid.png = std::make_shared<const std::string>(std::move(*picture));
    frame.message = std::move(grid);
  } else if (!url.empty()) {
    frame.grid_to_fetch = GridToFetch{std::move(grid), std::string(url)};
  } else {
    refuse(faultText("axbot", "It contains neither a picture nor the address of one."));
  }
}

/// A member that explains an error, of any type.
std::string anyText(const Json& root, std::string_view name) {
  const auto value = wire::member(root, {name});
  if (!value) return {};
  const std::string text = wire::asText(*value);
  return text.empty() ? std::string(simdjson::minify(*value)) : text;
}

// A list of 100,000 submaps takes about 10 MB, a cloud of 2 million points about 20 MB.
constexpr std::size_t kMaxInflated = std::size_t(64) << 20;

/// For gzip or zlib data of unknown size up to kMaxInflated; nullopt if broken, truncated or larger.
std::optional<std::string> unpacked(std::string_view body) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(body.data()), body.size());
  const bool gzip = packed::sniffContainer(bytes) == packed::Container::Gzip;
  const auto out =
      packed::unpack(gzip ? packed::Container::Gzip : packed::Container::Zlib, bytes, kMaxInflated);
  if (!out) return std::nullopt;
  return std::string(reinterpret_cast<const char*>(out->data.get()), out->size);
}

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
    dump += QCoreApplication::translate("axbot", "and %1 bytes more")
                .arg(qulonglong(bytes.size() - shown.size()))
                .toUtf8() +
            '\n';
  }
  return dump;
}

}  // namespace

TextFrame readFrame(const Json& root) { return readFrameOn(wire::text(root, {"topic"}), root); }

TextFrame readFrameOn(const std::string& on_topic, const Json& root) {
  TextFrame frame;
  frame.topic = on_topic;
  if (!frame.topic.empty()) {
    const Topic* const topic = findTopic(frame.topic);
    if (topic && topic->picture) {
      readGridTopic(*topic->picture, root, frame);
      return frame;
    }
    if (topic && topic->read) {
      frame.message = topic->read(root);
    } else if (isCloudTopic(frame.topic)) {
      frame.message = readCloud(frame.topic, root);
    }
    const bool of_the_map = frame.message && std::holds_alternative<map::MapInfo>(*frame.message);
    const auto overlays = of_the_map ? wire::member(root, {"overlays"}) : std::nullopt;
    if (overlays && !parseOverlays(*overlays))
      frame.left_out = map::UnreadableMessage{frame.topic, {fault::MemberIsNoList, {"overlays"}}};
    if (of_the_map) {
      const auto& broken = std::get<map::MapInfo>(*frame.message).broken_overlays;
      if (!broken.empty())
        frame.left_out = map::UnreadableMessage{
            frame.topic, {robot::fault::FeaturesUnreadable, {std::int64_t(broken.size())}}};
    }
    return frame;
  }
  if (const auto topics = wire::list(root, {"enabled_topics"})) {
    frame.enabled_topics.emplace();
    for (const Json topic : *topics) {
      std::string_view name;
      if (!topic.get(name)) frame.enabled_topics->emplace_back(name);
    }
    return frame;
  }
  for (const char* member : {"error", "detail", "message"}) {
    if (frame.error.empty()) frame.error = anyText(root, member);
  }
  return frame;
}

TextFrame TopicReader::read(std::string_view utf8) {
  const auto root = json_.read(utf8);
  TextFrame frame;
  if (root && root->is_object()) {
    frame = readFrame(*root);
    if (!frame.topic.empty()) frame.stamp_s = wire::epochSeconds(*root, {"stamp"});
    return frame;
  }
  frame.message = map::UnreadableMessage{kUnknownTopic, {fault::MessageNotJson, {std::int64_t(utf8.size())}}};
  return frame;
}

TextFrame parseTextFrame(std::string_view utf8) { return TopicReader().read(utf8); }

std::string topicOfBinaryFrame(std::string_view bytes) {
  const std::size_t length = bytes.empty() ? 0 : std::uint8_t(bytes[0]);
  return bytes.size() < length + 2 ? std::string() : std::string(bytes.substr(1, length));
}

tl::expected<BinaryFrame, map::UnreadableMessage> unpackBinaryFrame(std::string_view bytes) {
  const std::size_t length = bytes.empty() ? 0 : std::uint8_t(bytes[0]);
  if (bytes.size() < length + 2) {
    return tl::make_unexpected(
        map::UnreadableMessage{kUnknownTopic, {fault::BinaryTooShort, {std::int64_t(bytes.size())}}});
  }
  BinaryFrame frame;
  frame.topic = bytes.substr(1, length);
  const std::string_view body = bytes.substr(length + 2);
  if (bytes[length + 1] == 0) {
    frame.body = body;
    return frame;
  }
  auto content = unpacked(body);
  if (!content) {
    return tl::make_unexpected(map::UnreadableMessage{
        frame.topic,
        faultText("axbot", "A compressed message could not be unpacked. The previous data stays.")});
  }
  frame.body = std::move(*content);
  return frame;
}

std::string binaryTypeDefinition() {
  google::protobuf::FileDescriptorSet files;
  std::set<std::string> taken;
  // Each after its dependencies.
  const std::function<void(const google::protobuf::FileDescriptor&)> addFile =
      [&](const google::protobuf::FileDescriptor& file) {
        if (!taken.insert(file.name()).second) return;
        for (int i = 0; i < file.dependency_count(); ++i) addFile(*file.dependency(i));
        file.CopyTo(files.add_file());
      };
  addFile(*ros_messages::RosMessageWrapper::descriptor()->file());
  return files.SerializeAsString();
}

std::optional<std::string> jsonOfBinaryBody(std::string_view body) {
  ros_messages::RosMessageWrapper wrapper;
  std::string json;
  const bool known = !body.empty() && body.size() <= std::size_t(std::numeric_limits<int>::max()) &&
                     wrapper.ParseFromArray(body.data(), int(body.size())) &&
                     wrapper.message_case() != ros_messages::RosMessageWrapper::MESSAGE_NOT_SET &&
                     google::protobuf::util::MessageToJsonString(wrapper, &json).ok();
  return known ? std::optional(std::move(json)) : std::nullopt;
}

std::optional<map::TopicMessage> parseBinaryBody(const std::string& topic, std::string_view body) {
  ros_messages::RosMessageWrapper wrapper;
  const bool read = body.size() <= std::size_t(std::numeric_limits<int>::max()) &&
                    wrapper.ParseFromArray(body.data(), int(body.size()));
  if (isCloudTopic(topic)) {
    if (read && wrapper.has_point_cloud()) return readCloud(topic, wrapper.point_cloud());
    return map::UnreadableMessage{topic, faultText("axbot", "A binary message contains no readable points.")};
  }
  if (topic != "/submap_list") return std::nullopt;
  if (!read || !wrapper.has_submap_list())
    return map::UnreadableMessage{
        topic, faultText("axbot", "A binary message could not be read. The previous list stays.")};
  return toSubmapList(wrapper.submap_list());
}

std::optional<map::TopicMessage> parseBinaryFrame(std::string_view bytes) {
  const auto frame = unpackBinaryFrame(bytes);
  if (!frame) return frame.error();
  return parseBinaryBody(frame->topic, frame->body);
}

RawMessage rawText(const std::string& topic, std::string_view utf8) {
  RawMessage message = started(topic, utf8.size(), false);
  message.text = beginning(utf8);
  return message;
}

RawMessage rawBinary(std::string_view bytes) {
  const auto frame = unpackBinaryFrame(bytes);
  RawMessage message = started(frame ? frame->topic : frame.error().topic, bytes.size(), true);
  const auto json = frame && frame->body.size() <= kReadable ? jsonOfBinaryBody(frame->body) : std::nullopt;
  message.text = json ? beginning(*json) : hexDump(frame ? std::string_view(frame->body) : bytes);
  return message;
}

}  // namespace mapwright::robot::axbot
