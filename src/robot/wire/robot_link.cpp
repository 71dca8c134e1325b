#include "robot/wire/robot_link.h"

#include <utility>

namespace mapwright::robot::wire {

double secondsOfDay() { return double(QDateTime::currentMSecsSinceEpoch()) / 1000; }

std::string hostOf(const QUrl& url) {
  return QStringLiteral("%1:%2").arg(url.host()).arg(url.port()).toStdString();
}

RobotLink::RobotLink(const QLoggingCategory& log, const QUrl& server)
    : server_(hostOf(server)), link_log_(log, server_) {
  clock_.start();
}

void RobotLink::report(map::Severity severity, Fault reason) {
  link_log_.note(reason);
  Q_EMIT problemFound({severity, map::Subject(map::SubjectKind::Robot, server_), std::move(reason)});
}

bool RobotLink::passesRaw(qint64 bytes) { return watching_ && raw_limit_.allow(clock_.elapsed(), bytes); }

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
