// Addresses of Agibot robots: "aimdk+http://192.168.100.110:50807", with "?tf=ws://HOST:9090" for the
// rosbridge that sends the pose.
#pragma once

#include "robot/address.h"

namespace mapwright::robot::aimdk {

AddressScheme addressScheme();
/// The rosbridge for the pose, with port; empty = none.
QUrl tfOf(const Address& address);

}  // namespace mapwright::robot::aimdk
