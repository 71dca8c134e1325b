// Addresses of ROS robots behind a rosbridge server: "ros+ws://192.168.1.7:9090", with "?ns=/robot1" for the
// namespace that is looked into first; "kabam+ws://…" for one that must be a KABAM MapManagerV2 as well.
#pragma once

#include <string>

#include "robot/address.h"

namespace mapwright::robot::ros {

AddressScheme rosAddressScheme();
AddressScheme kabamAddressScheme();

/// "/robot1"; empty = none. Without a slash at its end.
std::string namespaceOf(const Address& address);

}  // namespace mapwright::robot::ros
