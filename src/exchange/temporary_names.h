// Temporary names that a swap of names has left behind (map/temporary_name.h). Pure functions.
#pragma once

#include <string>
#include <vector>

#include "exchange/waypoint_steps.h"

namespace mapwright::exchange {

struct TemporaryName {
  edit::Key key;
  std::string name;       // "Dock ~1"
  std::string permanent;  // "Dock"
  bool is_free = true;    // nobody else is called so now
};
std::vector<TemporaryName> temporaryNamesIn(const WaypointItems& items);

}  // namespace mapwright::exchange
