// Encodes one message of /ws/v2/topics.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace ros_messages {
class RosMessageWrapper;
}

namespace mapwright::simulator {

struct Frame {
  std::shared_ptr<const std::string> bytes;
  bool binary = false;
};

Frame textFrame(std::string text);
/// Topic length, topic, gzip flag, RosMessageWrapper (gzipped if large).
std::string binaryMessage(std::string_view topic, const ros_messages::RosMessageWrapper& wrapper);

}  // namespace mapwright::simulator
