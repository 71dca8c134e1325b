// Swapping names of waypoints: one of them gets a temporary name, "Dock ~1", until the wanted name is free.
// If the swap is interrupted the name stays on the robot, and is recognized by its form. Pure.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::map {

/// "Dock ~2"; counts from 1.
std::string temporaryName(std::string_view name, int number);
/// "Dock" for "Dock ~2" and "Dock ~1 ~2"; empty = not a temporary name.
std::string_view permanentName(std::string_view temporary);
/// Whether `name` is a temporary name for `permanent`.
bool isTemporaryFor(std::string_view name, std::string_view permanent);

}  // namespace mapwright::map
