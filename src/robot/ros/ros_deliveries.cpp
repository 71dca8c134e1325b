#include "robot/ros/ros_deliveries.h"

#include <algorithm>
#include <utility>

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::TopicMessage;

constexpr const char* kAskedMap = "nav_msgs/GetMapResponse";

/// A robot's frames are told by many, each of some: one message does not stand for the others.
std::string slotOf(const TopicMessage& message) {
  std::string slot = message.topic;
  if (lastPart(message.topic) != "tf_static") return slot;
  message.msg["transforms"].each(
      [&](const net::rosbridge::Field& transform) { slot += '\n' + transform["child_frame_id"].text(); });
  return slot;
}

}  // namespace

void RosDeliveries::beginAnew() {
  ++round_;
  connected_ = true;
  defining_ = false;
  tap_.forget();
  types_.clear();
  defined_.clear();
}

void RosDeliveries::pause() {
  ++round_;
  connected_ = false;
}

void RosDeliveries::deliver(const std::string& name, std::string type, std::string slot,
                            const std::shared_ptr<const net::rosbridge::Frame>& frame, const char* member,
                            std::optional<double> said_s, double received_s) {
  if (!type.empty() && types_.insert(type).second) define();
  wire::DeliveryTapSlot::Parcel parcel;
  parcel.name = name;
  parcel.schema = std::move(type);
  parcel.encoding = frame->wire() == net::rosbridge::Frame::Wire::Binary ? "cbor" : "json";
  parcel.slot = std::move(slot);
  parcel.keeps = frame;
  parcel.held_bytes = std::size_t(frame->bytes()) * (parcel.encoding[0] == 'j' ? 3 : 1);
  parcel.find = [frame = frame.get(), member] { return frame->rawMember(member); };
  parcel.received_s = received_s;
  parcel.said_s = said_s;
  tap_.pass(std::move(parcel));
}

void RosDeliveries::define() {
  if (defining_ || !connected_ || !tap_.taken()) return;
  const auto next = std::find_if(types_.begin(), types_.end(),
                                 [&](const std::string& type) { return !defined_.contains(type); });
  if (next == types_.end()) return;
  const std::string type = *next;
  defined_.insert(type);
  defining_ = true;
  // rosapi does not know kAskedMap: that service answers with a map, so the definition of a map is asked for.
  const bool ros2 =
      graph_.topics && std::any_of(graph_.topics->begin(), graph_.topics->end(), [](const Endpoint& one) {
        return one.type.find("/msg/") != std::string::npos;
      });
  const std::string map = ros2 ? "nav_msgs/msg/OccupancyGrid" : "nav_msgs/OccupancyGrid";
  const bool asked_map = type == kAskedMap;
  api_.define(asked_map ? map : type,
              [this, round = round_, type, map, asked_map](std::optional<RosDefinition> definition) {
                if (round != round_) return;
                defining_ = false;
                if (definition && asked_map) definition = definitionAround(*definition, map, "map");
                deliverDefinition(type, definition);
                define();
              });
}

void RosDeliveries::deliverDefinition(const std::string& type,
                                      const std::optional<RosDefinition>& definition) {
  wire::DeliveryTapSlot::Parcel parcel;
  parcel.kind = Delivery::Kind::Definition;
  parcel.name = type;
  parcel.encoding = definition && definition->ros2 ? "ros2msg" : "ros1msg";
  parcel.slot = "definition of " + type;
  if (definition) {
    const auto text = std::make_shared<const std::string>(definition->text);
    parcel.bytes = *text;
    parcel.held_bytes = text->size();
    parcel.keeps = text;
  }
  parcel.received_s = wall_s_();
  tap_.pass(std::move(parcel));
}

void RosDeliveries::onMessage(const TopicMessage& message) {
  std::string type = typeOf(graph_, message.topic);
  if (type.empty()) {
    // Asked for by its usual name.
    const auto source = std::find_if(sources_.begin(), sources_.end(),
                                     [&](const Source& one) { return one.topic == message.topic; });
    if (source != sources_.end()) type = source->type;
  }
  deliver(message.topic, std::move(type), slotOf(message), message.frame, "msg",
          message.msg["header"]["stamp"].time(), message.received_s);
}

void RosDeliveries::onMap(const std::string& service, const net::rosbridge::CallAnswer& answer) {
  deliver(service, kAskedMap, service, answer.frame, "values", answer.values["map"]["header"]["stamp"].time(),
          wall_s_());
}

}  // namespace mapwright::robot::ros
