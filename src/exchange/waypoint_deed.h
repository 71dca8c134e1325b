// What a change of a waypoint does, in words. Pure functions.
#pragma once

#include <optional>

#include <QString>

#include "map/waypoint.h"

namespace mapwright::exchange {

/// A name, or what stands for it, as one line that is not too long for a menu.
QString shortWaypointName(const map::Waypoint& point, int limit = 40);
/// "90.0°", empty without a heading.
QString yawText(const std::optional<double>& yaw_rad);
/// "Create Corr 2", "Move Dock by 0.40 m", "Rename A to B, turn it by 15.0°".
QString deedText(const std::optional<map::Waypoint>& before, const std::optional<map::Waypoint>& after);

}  // namespace mapwright::exchange
