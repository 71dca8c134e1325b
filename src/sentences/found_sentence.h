// What is said of a robot that was found at an address.
#pragma once

#include <QString>

#include "robot/probe.h"

namespace mapwright::sentences {

/// "dock-3, AX-200, 2.11.0", "ROS 1, 24 topics, 61 services", "asks for a secret": what it tells of itself;
/// empty: nothing. Untrusted plain text.
QString foundCalled(const robot::FoundRobot& robot);

}  // namespace mapwright::sentences
