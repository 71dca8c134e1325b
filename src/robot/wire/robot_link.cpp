#include "robot/wire/robot_link.h"

#include <utility>

namespace mapwright::robot::wire {

void RobotLink::pass(map::StampedMessage message) {
  if (!TopicMailbox::takes(message.message)) {
    Q_EMIT topicReceived(message);
  } else if (places_->mailbox.put(std::move(message))) {
    Q_EMIT mailArrived();
  }
}

DeliveryPlace::Parcel RobotLink::parcelOf(std::string name, std::shared_ptr<const std::string> body,
                                          double received_s) {
  DeliveryPlace::Parcel parcel;
  parcel.name = std::move(name);
  parcel.bytes = *body;
  parcel.held_bytes = body->size();
  parcel.keeps = std::move(body);
  parcel.received_s = received_s;
  return parcel;
}

}  // namespace mapwright::robot::wire

#include "moc_robot_link.cpp"
