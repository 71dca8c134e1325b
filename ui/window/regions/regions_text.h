// What the window says of a map by regions. Pure functions.
#pragma once

#include <optional>

#include <QString>

#include "regions/map_regions.h"
#include "window/status/status_text.h"

namespace mapwright::window {

/// "7 of 9 regions, 6.2 MB".
QString regionsStatus(const regions::MapRegions& map);
/// "1,024 × 512 m".
QString areaText(const geometry::WorldRect& rect);
/// "60.0 × 24.0 m: 1,200 × 480 cells, about 576 KB"; without cells where their size is not known.
QString rectangleText(const regions::MapRegions& map, const geometry::WorldRect& rect);
/// How large the whole map would be, as far as that can be told.
QString wholeSizeText(const regions::MapRegions& map);

/// What is to be said above the map; an empty sentence: nothing is.
struct RegionsNotice {
  enum class Offer { None, Whole, Retry };
  Mark mark = Mark::None;
  QString sentence;
  Offer offer = Offer::None;
  bool operator==(const RegionsNotice&) const = default;
};
/// `whole`: the whole map can be asked for.
RegionsNotice regionsNotice(const regions::MapRegions& map, bool whole);

}  // namespace mapwright::window
