// What people are asked before a map of the robot is changed, as a value. Pure.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "map/catalogue.h"
#include "map/waypoint.h"
#include "robot/map_administration.h"

namespace mapwright::window {

struct ChangeQuestion {
  robot::MapOrder order;  // as far as it is known
  QString title, text, accept;
  std::optional<QString> name = {};  // it is asked for, and this stands there at first
  bool asks_place = false;           // where the robot stands
  QString typed = {};                // must be typed, so that nobody does it by mistake; empty = nothing
  bool ends_something = false;       // that cannot be had back: Enter does not do it
  QString done = {};                 // what is said when it is done; %1 is the name of the map then
};

/// `map`: which one, null for changes of none. `current`: the map that the robot works with, if any.
ChangeQuestion questionFor(robot::MapChange change, const map::CatalogueEntry* map,
                           const map::CatalogueEntry* current);

/// The names of `points` in the order in which somebody looks for the place of the robot: those that are
/// tagged for localisation, then where a map is entered, then the others; each by name.
std::vector<std::string> placesToStand(const std::vector<map::Waypoint>& points);

}  // namespace mapwright::window
