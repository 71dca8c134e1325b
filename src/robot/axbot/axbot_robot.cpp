#include "robot/axbot/axbot_robot.h"

#include <utility>

namespace mapwright::robot::axbot {

AxbotRobot::AxbotRobot(QString address, LinkOptions options, QObject* parent)
    : Robot(parent), address_(std::move(address)), link_(new AxbotLink(std::move(options))) {
  qRegisterMetaType<ConnectionState>();
  qRegisterMetaType<RobotIdentity>();
  qRegisterMetaType<map::TopicMessage>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::SubmapAnswer>();
  link_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("axbot link"));
  connect(&thread_, &QThread::finished, link_, &QObject::deleteLater);
  connect(link_, &AxbotLink::stateChanged, this, [this](const ConnectionState& state) {
    if (state == state_) return;
    state_ = state;
    Q_EMIT connectionChanged();
  });
  connect(link_, &AxbotLink::identityChanged, this, [this](const RobotIdentity& identity) {
    if (identity == identity_) return;
    identity_ = identity;
    Q_EMIT identityChanged();
  });
  connect(link_, &AxbotLink::topicReceived, this, &Robot::topicReceived);
  connect(link_, &AxbotLink::problemFound, this, &Robot::problemFound);
  connect(link_, &AxbotLink::answered, this, [this](quint64 ticket, const map::SubmapAnswer& answer) {
    auto entry = replies_.extract(ticket);
    if (!entry.empty()) entry.mapped()(answer);
  });
  thread_.start();
}

AxbotRobot::~AxbotRobot() {
  link_->disconnect(this);
  thread_.quit();
  thread_.wait();
}

void AxbotRobot::connectToRobot() { QMetaObject::invokeMethod(link_, &AxbotLink::open); }

void AxbotRobot::disconnectFromRobot() { QMetaObject::invokeMethod(link_, &AxbotLink::close); }

void AxbotRobot::fetch(const map::SubmapKey& key, Reply reply) {
  const quint64 ticket = next_ticket_++;
  replies_.emplace(ticket, std::move(reply));
  QMetaObject::invokeMethod(link_, [link = link_, ticket, key] { link->fetch(ticket, key); });
}

void AxbotRobot::cancelAll() { QMetaObject::invokeMethod(link_, &AxbotLink::cancelAll); }

void AxbotRobot::cancel(const map::SubmapKey& key) {
  QMetaObject::invokeMethod(link_, [link = link_, key] { link->cancel(key); });
}

}  // namespace mapwright::robot::axbot
