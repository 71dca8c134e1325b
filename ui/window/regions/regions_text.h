// What the window says of a map by regions. Pure functions.
#pragma once

#include <optional>

#include <QString>

#include "regions/map_regions.h"
#include "robot/map_dispatch.h"
#include "window/status/status_text.h"

namespace mapwright::window {

/// "7 of 9 regions, 6.2 MB".
QString regionsStatus(const regions::MapRegions& map);
/// "1,024 × 512 m".
QString areaText(const geometry::WorldRect& rect);
/// "60.0 × 24.0 m: 1,200 × 480 cells, about 576 KB"; without cells where their size is not known.
QString rectangleText(const regions::MapRegions& map, const geometry::WorldRect& rect);
/// How large the whole map would be: as the robot says (`extent`), else as far as that can be told of what
/// came. `map` may be null.
QString wholeSizeText(const regions::MapRegions* map, const std::optional<robot::MapExtent>& extent);
/// Why the whole map cannot come at once; empty = nothing is known to stand against it.
QString whyNotWhole(const std::optional<robot::MapExtent>& extent);
/// What is said while it comes: `bytes` of it are there after `seconds`.
QString wholeProgressText(qint64 bytes, qint64 seconds, const std::optional<robot::MapExtent>& extent);

/// Why there is nothing of the map at a place, or only what is old; empty = what is there is the newest.
/// `offered`: regions can be asked for. `online`: the robot can be.
QString regionReason(const regions::MapRegions& map, const Eigen::Vector2d& world_m, bool offered,
                     bool online);

/// What is to be said above the map; an empty sentence: nothing is.
struct RegionsNotice {
  enum class Offer { None, Whole, Region, Retry };
  Mark mark = Mark::None;
  QString sentence;
  Offer offer = Offer::None;
  bool operator==(const RegionsNotice&) const = default;
};
/// `whole`: the whole map can be asked for.
RegionsNotice regionsNotice(const regions::MapRegions& map, bool whole,
                            const std::optional<robot::MapExtent>& extent);

}  // namespace mapwright::window
