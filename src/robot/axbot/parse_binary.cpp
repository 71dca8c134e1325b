#include <algorithm>
#include <limits>
#include <zlib.h>

#include "robot/axbot/parse_binary_cloud.h"
#include "robot/axbot/parse_submap.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/topic_subjects.h"
#include "ros_messages/wrapper.pb.h"

namespace mapwright::robot::axbot {
namespace {

// A list of 100,000 submaps takes about 10 MB, a cloud of 2 million points about 20 MB.
constexpr std::size_t kMaxInflated = std::size_t(64) << 20;

/// Inflates gzip or zlib data of unknown size up to kMaxInflated; nullopt when broken, cut off or larger.
std::optional<std::string> inflateBounded(std::string_view packed) {
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) return std::nullopt;
  std::string out;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  int result = Z_OK;
  while (result == Z_OK && out.size() < kMaxInflated) {
    const std::size_t had = out.size();
    out.resize(std::min(kMaxInflated, std::max<std::size_t>(had * 2, packed.size() * 4 + 4096)));
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + had);
    stream.avail_out = uInt(out.size() - had);
    result = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    if (result == Z_OK && stream.avail_in == 0 && stream.avail_out > 0) break;  // cut off
  }
  inflateEnd(&stream);
  if (result != Z_STREAM_END) return std::nullopt;
  return out;
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
        map::UnreadableMessage{kUnknownTopic, "A binary message of " + std::to_string(bytes.size()) +
                                                  " bytes is too short to be read. It was left out."});
  }
  BinaryFrame frame;
  frame.topic = bytes.substr(1, length);
  const std::string_view body = bytes.substr(length + 2);
  if (bytes[length + 1] == 0) {
    frame.body = body;
    return frame;
  }
  auto unpacked = inflateBounded(body);
  if (!unpacked) {
    return tl::make_unexpected(map::UnreadableMessage{
        frame.topic, "A compressed message could not be unpacked. What was shown before stays."});
  }
  frame.body = std::move(*unpacked);
  return frame;
}

std::optional<map::TopicMessage> parseBinaryFrame(std::string_view bytes) {
  const auto frame = unpackBinaryFrame(bytes);
  if (!frame) return frame.error();
  ros_messages::RosMessageWrapper wrapper;
  const bool read = frame->body.size() <= std::size_t(std::numeric_limits<int>::max()) &&
                    wrapper.ParseFromArray(frame->body.data(), int(frame->body.size()));
  if (isCloudTopic(frame->topic)) {
    if (read && wrapper.has_point_cloud()) return readCloud(frame->topic, wrapper.point_cloud());
    return map::UnreadableMessage{frame->topic, "A binary message holds no points that can be read."};
  }
  if (frame->topic != "/submap_list") return std::nullopt;
  if (!read || !wrapper.has_submap_list()) {
    return map::UnreadableMessage{frame->topic,
                                  "A binary message could not be read. The list before it stays."};
  }
  return toSubmapList(wrapper.submap_list());
}

}  // namespace mapwright::robot::axbot
