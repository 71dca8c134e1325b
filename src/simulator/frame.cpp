#include "simulator/frame.h"

#include "ros_messages/wrapper.pb.h"
#include "simulator/cell_encoding.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kGzipFrom = 4096;

}  // namespace

Frame textFrame(std::string text) { return {std::make_shared<const std::string>(std::move(text)), false}; }

std::string binaryMessage(std::string_view topic, const ros_messages::RosMessageWrapper& wrapper) {
  std::string payload = wrapper.SerializeAsString();
  const bool zipped = payload.size() >= kGzipFrom;
  if (zipped) payload = gzip(payload);
  std::string frame;
  frame += static_cast<char>(topic.size());
  frame += topic;
  frame += static_cast<char>(zipped ? 1 : 0);
  return frame + payload;
}

}  // namespace mapwright::simulator
