// Addresses of ROS robots behind a rosbridge server: "ros+ws://192.168.1.7:9090", with "?ns=/robot1" for the
// preferred namespace; "kabam+ws://…" for one that must be a KABAM MapManagerV2 as well; "rep130+ws://…" for
// one with a map dispatcher, with "?ns=/map_dispatcher" for its namespace and "&get_sub_map=/other/name" for
// names that differ from REP 130.
#pragma once

#include <string>

#include "robot/address.h"
#include "robot/ros/dispatch_names.h"

namespace mapwright::robot::ros {

AddressScheme rosAddressScheme();
AddressScheme kabamAddressScheme();
AddressScheme rep130AddressScheme();

/// "/robot1"; empty = none. Without a trailing slash.
std::string namespaceOf(const Address& address);
/// What it says about a map dispatcher; for other kinds of robots, where to look first.
DispatchSettings dispatchSettingsOf(const Address& address);

}  // namespace mapwright::robot::ros
