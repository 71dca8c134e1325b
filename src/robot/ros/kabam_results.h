// The result codes of KABAM's services. Pure. Source: docs/protocols/kabam-map-manager.md, "Results".
#pragma once

#include <optional>
#include <string>

#include "map/failure.h"
#include "net/rosbridge/field.h"

namespace mapwright::robot::ros {

/// nullopt: success. Otherwise the failure about `subject`; unknown codes are shown as numbers. `name`: the
/// requested name of the waypoint.
std::optional<map::Failure> waypointResult(const net::rosbridge::Field& values, map::Subject subject,
                                           const std::string& name);
std::optional<map::Failure> updateMapResult(const net::rosbridge::Field& values, map::Subject subject);
std::optional<map::Failure> loadMapResult(const net::rosbridge::Field& values, map::Subject subject);
/// `name`: the requested name of the map.
std::optional<map::Failure> saveMapResult(const net::rosbridge::Field& values, map::Subject subject,
                                          const std::string& name);
/// For a std_srvs/Trigger; its message is shown.
std::optional<map::Failure> triggerResult(const net::rosbridge::Field& values, map::Subject subject);

/// The code of LoadMap if the map is already loaded.
inline constexpr const char* kAlreadyLoaded = "2";

}  // namespace mapwright::robot::ros
