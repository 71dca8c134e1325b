// From an address to a robot: the one place that knows every back-end.
#pragma once

#include <memory>

#include <QByteArray>
#include <QString>
#include <tl/expected.hpp>

#include "app/demo_robot.h"
#include "robot/robot.h"

namespace mapwright::app {

/// Makes the robot that `address` names, not yet connected. The error is a sentence.
tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address,
                                                               const QByteArray& secret, DemoTime demo_time);

/// The folder of answers kept on disk (XDG_CACHE_HOME/mapwright/http).
QString httpCacheFolder();

}  // namespace mapwright::app
