// Texts about a map by regions. Pure functions.
#pragma once

#include <optional>

#include <QString>

#include "regions/map_regions.h"
#include "robot/map_dispatch.h"
#include "ui/kit/status_text.h"

namespace mapwright::ui {

/// "7 of 9 regions, 6.2 MB".
QString regionsStatus(const regions::MapRegions& map);
/// "1,024 × 512 m".
QString areaText(const geometry::WorldRect& rect);
/// The nearest one whose edges are edges of cells, as far as these are known: as many are fetched as were
/// drawn.
geometry::WorldRect wholeCells(const regions::MapRegions& map, const geometry::WorldRect& rect);
/// "60.0 × 24.0 m: 1,200 × 480 cells, about 576 KB"; without cells if their size is unknown.
QString rectangleText(const regions::MapRegions& map, const geometry::WorldRect& rect);
/// The size of the whole map: as reported (`extent`), otherwise estimated from what arrived. `map` may be
/// null.
QString wholeSizeText(const regions::MapRegions* map, const std::optional<robot::MapExtent>& extent);
/// Why the whole map cannot be fetched at once; empty = no known reason.
QString notWholeReason(const std::optional<robot::MapExtent>& extent);
/// The progress text: `bytes` have arrived after `seconds`.
QString wholeProgressText(qint64 bytes, qint64 seconds, const std::optional<robot::MapExtent>& extent);

/// Why a place on the map is blank or old; empty = it is up to date. `offered`: the robot sends regions.
/// `online`: it is connected.
QString regionReason(const regions::MapRegions& map, const Eigen::Vector2d& world_m, bool offered,
                     bool online);

/// The notice above the map; an empty sentence: none.
struct RegionsNotice {
  enum class Offer { None, Whole, Region, Retry };
  Mark mark = Mark::None;
  QString sentence;
  Offer offer = Offer::None;
  bool operator==(const RegionsNotice&) const = default;
};
/// `whole`: the whole map can be requested.
RegionsNotice regionsNotice(const regions::MapRegions& map, bool whole,
                            const std::optional<robot::MapExtent>& extent);

}  // namespace mapwright::ui
