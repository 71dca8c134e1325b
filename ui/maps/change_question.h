// The question to ask before a map of the robot is changed, as a value. Pure.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "map/catalogue.h"
#include "map/waypoint.h"
#include "robot/map_administration.h"

namespace mapwright::window {

struct ChangeQuestion {
  robot::MapOrder order;  // as far as known
  QString title, text, accept;
  std::optional<QString> name = {};  // asks for a name, with this initial value
  bool asks_place = false;           // asks where the robot is
  QString typed = {};                // must be typed to prevent accidents; empty = nothing
  bool ends_something = false;       // it cannot be undone: Enter does not trigger it
  QString done = {};                 // the message on success; %1 is the new name of the map
};

/// `map`: null for changes without a map. `current`: the robot's current map, if any.
ChangeQuestion questionFor(robot::MapChange change, const map::CatalogueEntry* map,
                           const map::CatalogueEntry* current);

/// The names of `points`, sorted by how likely the robot is there: those tagged for localization, then entry
/// points, then the others; each by name.
std::vector<std::string> placesToStand(const std::vector<map::Waypoint>& points);

}  // namespace mapwright::window
