// Addresses of ROS robots behind a rosbridge server: "ros+ws://192.168.1.7:9090", with "?ns=/robot1" for the
// namespace that is looked into first; "kabam+ws://…" for one that must be a KABAM MapManagerV2 as well;
// "rep130+ws://…" for one with a map dispatcher, with "?ns=/map_dispatcher" for the namespace of that and
// "&get_sub_map=/other/name" for what is called otherwise than in REP 130.
#pragma once

#include <string>

#include "robot/address.h"
#include "robot/ros/dispatch_names.h"

namespace mapwright::robot::ros {

AddressScheme rosAddressScheme();
AddressScheme kabamAddressScheme();
AddressScheme rep130AddressScheme();

/// "/robot1"; empty = none. Without a slash at its end.
std::string namespaceOf(const Address& address);
/// What it says of a map dispatcher; of a robot of any other kind, where several are looked for first.
DispatchWish dispatchWishOf(const Address& address);

}  // namespace mapwright::robot::ros
