// What robots on a network have in common, on the thread that made them.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include <QThread>

#include "robot/delivery.h"
#include "robot/robot.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::wire {

/// A link on a thread of its own, which is running. It is deleted there when the thread ends.
template <typename Link>
struct StartedLink {
  std::unique_ptr<QThread> thread;
  Link* link = nullptr;
};

/// Runs `make` on a new thread called `name`, and waits for it.
std::unique_ptr<QThread> startThread(const QString& name, const std::function<QObject*()>& make);

/// Made on its own thread, so that all that it holds belongs there.
template <typename Link, typename Options>
StartedLink<Link> startLink(const QString& thread, Options options) {
  StartedLink<Link> started;
  started.thread = startThread(thread, [&] { return started.link = new Link(std::move(options)); });
  return started;
}

/// The half of a robot that is asked, and the thread of its link.
class NetworkRobot : public Robot, public Delivers {
  Q_OBJECT
 public:
  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override;
  ConnectionState connection() const override { return state_; }
  QDateTime silentSince() const override { return silent_since_; }
  void setDeliveryTap(DeliveryTap tap) override { outputs_->deliveries.set(std::move(tap)); }

 protected:
  NetworkRobot(QString address, RobotLink* link, std::unique_ptr<QThread> thread, QObject* parent);
  ~NetworkRobot() override;
  /// The first thing that the destructor of a robot does: its capabilities outlive the thread of the link.
  void stopLink();
  /// A message that did not come by mail.
  virtual void onTopic(const map::StampedMessage& message);
  /// It is online, after connectionChanged() has told so.
  virtual void cameOnline() {}

  const std::shared_ptr<LinkOutputs> outputs_;

 private:
  void onState(ConnectionState state);
  void onMail();

  QString address_;
  std::unique_ptr<QThread> thread_;
  RobotLink* link_;  // lives on thread_, deleted when it ends
  ConnectionState state_;
  QDateTime silent_since_;
};

}  // namespace mapwright::robot::wire
