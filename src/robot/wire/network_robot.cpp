#include "robot/wire/network_robot.h"

#include <utility>

#include <QPointer>

#include "net/trust.h"

namespace mapwright::robot::wire {

std::unique_ptr<QThread> startThread(const QString& name, const std::function<QObject*()>& make) {
  auto thread = std::make_unique<QThread>();
  thread->setObjectName(name);
  QObject on_thread;
  on_thread.moveToThread(thread.get());
  thread->start();
  QMetaObject::invokeMethod(
      &on_thread,
      [&] {
        QObject* const made = make();
        QObject::connect(thread.get(), &QThread::finished, made, &QObject::deleteLater);
        on_thread.moveToThread(thread->thread());
      },
      Qt::BlockingQueuedConnection);
  return thread;
}

NetworkRobot::NetworkRobot(QString address, RobotLink* link, std::unique_ptr<QThread> thread, QObject* parent)
    : Robot(parent),
      outputs_(link->outputs()),
      address_(std::move(address)),
      thread_(std::move(thread)),
      link_(link) {
  qRegisterMetaType<ConnectionState>();
  qRegisterMetaType<map::StampedMessage>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  qRegisterMetaType<RawMessage>();
  connect(link_, &RobotLink::silenceChanged, this, [this](const QDateTime& since) {
    if (std::exchange(silent_since_, since) != since) Q_EMIT connectionChanged();
  });
  connect(link_, &RobotLink::stateChanged, this, &NetworkRobot::onState);
  connect(link_, &RobotLink::topicReceived, this, &NetworkRobot::onTopic);
  connect(link_, &RobotLink::mailArrived, this, &NetworkRobot::onMail);
  connect(link_, &RobotLink::rawReceived, this, &Robot::rawReceived);
  connect(link_, &RobotLink::problemFound, this, [this](map::Problem problem) {
    link_->unsaid().hideIn(problem);
    Q_EMIT problemFound(problem);
  });
  connect(link_, &RobotLink::recovered, this, &Robot::recovered);
}

NetworkRobot::~NetworkRobot() { stopLink(); }

void NetworkRobot::stopLink() {
  if (!thread_->isRunning()) return;
  link_->disconnect(this);
  thread_->quit();
  thread_->wait();
}

void NetworkRobot::connectToRobot() { QMetaObject::invokeMethod(link_, &RobotLink::open); }

void NetworkRobot::disconnectFromRobot() { QMetaObject::invokeMethod(link_, &RobotLink::close); }

void NetworkRobot::trustCertificate(const QString& sha256) {
  QMetaObject::invokeMethod(link_, [link = link_, pin = net::fingerprintFrom(sha256)] { link->trust(pin); });
}

void NetworkRobot::onTopic(const map::StampedMessage& message) { Q_EMIT topicReceived(message); }

void NetworkRobot::onState(ConnectionState state) {
  link_->unsaid().hideIn(state);
  if (state == state_) return;
  const bool online = state.phase == ConnectionPhase::Online && state_.phase != ConnectionPhase::Online;
  state_ = std::move(state);
  const QPointer<NetworkRobot> alive(this);
  Q_EMIT connectionChanged();
  if (alive && online) cameOnline();
}

void NetworkRobot::onMail() {
  const QPointer<NetworkRobot> alive(this);
  for (const map::StampedMessage& message : outputs_->mailbox.take()) {
    if (alive) Q_EMIT topicReceived(message);
  }
}

}  // namespace mapwright::robot::wire

#include "moc_network_robot.cpp"
