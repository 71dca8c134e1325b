// What an Autoxing robot says of itself (/device/info). Pure. Source: docs/protocols/autoxing.md, "Requests".
#pragma once

#include <QByteArray>

#include "robot/robot.h"

namespace mapwright::robot::axbot {

struct DeviceInfo {
  RobotIdentity identity;
  bool takes_topic_lists = false;
  /// No other server would say this.
  bool surely = false;
};

/// Of what is no JSON object everything is empty.
DeviceInfo deviceInfoIn(const QByteArray& body);

}  // namespace mapwright::robot::axbot
