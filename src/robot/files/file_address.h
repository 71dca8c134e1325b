// Addresses of local maps: "file:/maps/office.yaml", or just the path; for a plain picture with
// "?resolution=0.05&origin=-10,-7.5,0.1"; for a recording of several robots with "?ns=/robot1".
#pragma once

#include <string>

#include "robot/address.h"
#include "robot/files/local_maps.h"

namespace mapwright::robot::files {

AddressScheme addressScheme();
/// The position of a plain picture, if the address states it.
PicturePlace placeOf(const Address& address);
/// "/robot1": the robot to be shown of a recording; empty: it does not say.
std::string namespaceOf(const Address& address);

}  // namespace mapwright::robot::files
