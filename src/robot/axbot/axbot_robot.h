// An Autoxing robot behind the port. Source: axbot.md.
#pragma once

#include <unordered_map>

#include <QThread>

#include "robot/axbot/axbot_link.h"
#include "robot/robot.h"

namespace mapwright::robot::axbot {

class AxbotRobot : public Robot, private SubmapSource {
  Q_OBJECT
 public:
  AxbotRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~AxbotRobot() override;

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override { return identity_; }
  SubmapSource* submapSource() override { return this; }

 private:
  void fetch(const map::SubmapKey& key, Reply reply) override;
  void cancelAll() override;
  void cancel(const map::SubmapKey& key) override;

  QString address_;
  QThread thread_;
  AxbotLink* link_;  // lives on thread_, deleted when it ends
  ConnectionState state_;
  RobotIdentity identity_;
  quint64 next_ticket_ = 1;
  std::unordered_map<quint64, Reply> replies_;
};

}  // namespace mapwright::robot::axbot
