// What people read where a robot lacks something.
#pragma once

#include <QString>

#include "fault/fault.h"
#include "robot/robot.h"

namespace mapwright::sentences {

/// "There are no submaps here, only whole maps." Plain text.
QString whyAbsent(robot::Capability capability, const robot::Absence& absence);

/// What is to be said of a robot as soon as it is connected: that it can only be looked at, or moves nothing;
/// empty when there is nothing to say.
QString limitsOf(robot::Robot& robot);

/// That a robot lacks it, as a value; wordsOf(it) is whyAbsent().
Fault lackOf(robot::Capability capability, const robot::Absence& absence);

}  // namespace mapwright::sentences
