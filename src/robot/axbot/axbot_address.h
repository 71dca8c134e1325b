// Addresses of Autoxing robots: "axbot+http://192.168.25.25:8090", or the host alone.
#pragma once

#include "robot/address.h"

namespace mapwright::robot::axbot {

AddressScheme addressScheme();

}  // namespace mapwright::robot::axbot
