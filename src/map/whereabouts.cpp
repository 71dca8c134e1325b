#include "map/whereabouts.h"

#include <algorithm>

namespace mapwright::map {
namespace {

bool maps(const LiveState& live) { return live.slam.state == "slam"; }

Whereabouts hereIf(bool here) { return here ? Whereabouts::Here : Whereabouts::Elsewhere; }

}  // namespace

Whereabouts whereabouts(const MapKey& key, const std::string& name, const LiveState& live,
                        const std::vector<CatalogueEntry>& catalogue, bool maps_afresh) {
  if (key.kind == MapKind::Live) return Whereabouts::Here;
  const CatalogueEntry* const shown = entryOf(catalogue, key);
  if (key.kind == MapKind::Mapping && maps(live) && shown && shown->state == "running")
    return Whereabouts::Here;
  if (key.kind == MapKind::File)
    return !name.empty() && name == currentMapName(live, catalogue) ? Whereabouts::Here
                                                                    : Whereabouts::Unknown;
  if (maps_afresh) return Whereabouts::Elsewhere;
  const CatalogueEntry* const current = currentOf(catalogue);
  const auto& info = live.map_info;
  if (info && !info->uid.empty()) {
    if (shown && !shown->uid.empty()) return hereIf(shown->uid == info->uid);
    // Another entry has it.
    const bool another = std::any_of(catalogue.begin(), catalogue.end(),
                                     [&](const CatalogueEntry& row) { return row.uid == info->uid; });
    if (another) return Whereabouts::Elsewhere;
  }
  if (current) return hereIf(current->key == key);
  if (info && !info->name.empty()) {
    const std::string& called = shown ? shown->name : name;
    const auto same = std::count_if(catalogue.begin(), catalogue.end(),
                                    [&](const CatalogueEntry& row) { return row.name == called; });
    if (!called.empty() && (called != info->name || same < 2)) return hereIf(called == info->name);
  }
  return Whereabouts::Unknown;
}

std::string currentMapName(const LiveState& live, const std::vector<CatalogueEntry>& catalogue) {
  if (live.map_info && !live.map_info->name.empty()) return live.map_info->name;
  const CatalogueEntry* const current = currentOf(catalogue);
  return current ? current->name : std::string();
}

bool mapsAfresh(const LiveState& live, std::optional<bool> of_stored) {
  return maps(live) && of_stored == false;
}

}  // namespace mapwright::map
