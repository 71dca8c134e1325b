// Names of waypoints that are exchanged: one of them has a temporary name, "Dock ~1", until the one
// that it is to have is free. Where that breaks off, the name stays on the robot, and is known by its look.
// Pure.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::map {

/// "Dock ~2"; counted from 1.
std::string temporaryName(std::string_view name, int number);
/// "Dock" of "Dock ~2" and of "Dock ~1 ~2"; empty = it does not look like a temporary name.
std::string_view permanentName(std::string_view temporary);
/// Whether `name` is a temporary name of what is called `permanent`.
bool isTemporaryFor(std::string_view name, std::string_view permanent);

}  // namespace mapwright::map
