#include "exchange/temporary_names.h"

#include <set>
#include <string_view>

#include "map/waypoint.h"

namespace mapwright::exchange {

std::vector<TemporaryName> temporaryNamesIn(const WaypointItems& items) {
  std::vector<TemporaryName> found;
  for (const auto& [key, point] : items) {
    const std::string_view permanent = map::permanentName(point.name);
    if (!permanent.empty()) found.push_back({key, point.name, std::string(permanent)});
  }
  if (found.empty()) return found;
  std::set<std::string> names;
  for (const auto& [key, point] : items) names.insert(point.name);
  // Of two with the same original name only the first can have it back.
  for (TemporaryName& one : found) one.is_free = names.insert(one.permanent).second;
  return found;
}

}  // namespace mapwright::exchange
