#include "robot/robot.h"

namespace mapwright::robot {

void Robot::trustCertificate(const QString&) {}

}  // namespace mapwright::robot

#include "moc_robot.cpp"
