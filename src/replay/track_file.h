// Tracks in files as track.h writes them, read back. Pure.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "replay/track.h"

namespace mapwright::replay {

/// By its ending: .csv, .geojson, .json, .tum or .txt.
bool isTrackName(std::string_view path);
/// CSV, GeoJSON or TUM; which one is seen from the text. Other columns and properties may be there, too;
/// speeds and qualities are not read. Numbers may be NaN. A TUM file is one piece. The error is the line that
/// cannot be read; 0 = the whole. `maps`: becomes what the file calls the maps of TrackPoint::map, which is
/// empty where it does not say.
tl::expected<std::vector<TrackPoint>, std::size_t> trackFrom(std::string_view text,
                                                             std::vector<map::MapIdentity>* maps = nullptr);

}  // namespace mapwright::replay
