// Texts for what a robot cannot do, ever or at present.
#pragma once

#include <QString>

#include "fault/fault.h"
#include "robot/map_administration.h"
#include "robot/robot.h"

namespace mapwright::sentences {

/// "There are no submaps here, only whole maps." Plain text.
QString absenceReason(robot::Capability capability, const robot::Absence& absence);

/// "This is not confirmed by the robot's maker: ..."; empty if the robot lacks it, or it is confirmed.
QString unconfirmedOf(robot::Robot& robot, robot::Capability capability);

/// A notice to show right after connecting: that the robot is read-only, has no live data, or is
/// changed in a way that is not confirmed; empty if there
/// is nothing to say.
QString limitsOf(robot::Robot& robot);

/// Why a map cannot be changed: "It is archived: restore it from the archive first." Plain text.
QString notNowReason(robot::MapChange change, robot::Obstacle obstacle);

/// The missing capability as a fault; wordsOf(it) is absenceReason().
Fault lackOf(robot::Capability capability, const robot::Absence& absence);

}  // namespace mapwright::sentences
