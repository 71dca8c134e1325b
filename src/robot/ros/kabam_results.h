// What the result codes of KABAM's services mean. Pure. Source: docs/protocols/kabam-map-manager.md,
// "Results".
#pragma once

#include <optional>
#include <string>

#include "map/failure.h"
#include "net/rosbridge/field.h"

namespace mapwright::robot::ros {

/// nullopt: it was done. Else why not, about `subject`; a code that nobody knows is named by its number.
/// `name`: that the waypoint was to have.
std::optional<map::Failure> waypointResult(const net::rosbridge::Field& values, map::Subject subject,
                                           const std::string& name);
std::optional<map::Failure> updateMapResult(const net::rosbridge::Field& values, map::Subject subject);
std::optional<map::Failure> loadMapResult(const net::rosbridge::Field& values, map::Subject subject);
/// `name`: that the map was to have.
std::optional<map::Failure> saveMapResult(const net::rosbridge::Field& values, map::Subject subject,
                                          const std::string& name);
/// Of a std_srvs/Trigger; what it says is told.
std::optional<map::Failure> triggerResult(const net::rosbridge::Field& values, map::Subject subject);

/// The code of LoadMap for the map that is loaded already.
inline constexpr const char* kAlreadyLoaded = "2";

}  // namespace mapwright::robot::ros
