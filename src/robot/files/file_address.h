// Addresses of local maps: "file:/maps/office.yaml", or the path alone; of a bare picture with
// "?resolution=0.05&origin=-10,-7.5,0.1".
#pragma once

#include "robot/address.h"
#include "robot/files/local_maps.h"

namespace mapwright::robot::files {

AddressScheme addressScheme();
/// How a bare picture lies, where the address says so.
PicturePlace placeOf(const Address& address);

}  // namespace mapwright::robot::files
