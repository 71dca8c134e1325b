#include <functional>
#include <limits>
#include <set>
#include <span>

#include <google/protobuf/descriptor.pb.h>

#include "packed/unpack.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_binary_cloud.h"
#include "robot/axbot/parse_submap.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/topic_subjects.h"
#include "ros_messages/wrapper.pb.h"

namespace mapwright::robot::axbot {
namespace {

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

}  // namespace

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
    return tl::make_unexpected(map::UnreadableMessage{frame.topic, fault::NotUnpacked});
  }
  frame.body = std::move(*content);
  return frame;
}

std::string binaryTypeDefinition() {
  google::protobuf::FileDescriptorSet files;
  std::set<std::string> taken;
  // Each after its dependencies.
  const std::function<void(const google::protobuf::FileDescriptor&)> take =
      [&](const google::protobuf::FileDescriptor& file) {
        if (!taken.insert(file.name()).second) return;
        for (int i = 0; i < file.dependency_count(); ++i) take(*file.dependency(i));
        file.CopyTo(files.add_file());
      };
  take(*ros_messages::RosMessageWrapper::descriptor()->file());
  return files.SerializeAsString();
}

std::optional<map::TopicMessage> parseBinaryBody(const std::string& topic, std::string_view body) {
  ros_messages::RosMessageWrapper wrapper;
  const bool read = body.size() <= std::size_t(std::numeric_limits<int>::max()) &&
                    wrapper.ParseFromArray(body.data(), int(body.size()));
  if (isCloudTopic(topic)) {
    if (read && wrapper.has_point_cloud()) return readCloud(topic, wrapper.point_cloud());
    return map::UnreadableMessage{topic, fault::BinaryWithoutPoints};
  }
  if (topic != "/submap_list") return std::nullopt;
  if (!read || !wrapper.has_submap_list()) return map::UnreadableMessage{topic, fault::BinaryWithoutList};
  return toSubmapList(wrapper.submap_list());
}

std::optional<map::TopicMessage> parseBinaryFrame(std::string_view bytes) {
  const auto frame = unpackBinaryFrame(bytes);
  if (!frame) return frame.error();
  return parseBinaryBody(frame->topic, frame->body);
}

}  // namespace mapwright::robot::axbot
