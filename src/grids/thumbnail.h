// A small picture of a whole map, for lists.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "map/catalogue.h"

namespace mapwright::grids {

/// What reading takes no more than a moment.
inline constexpr std::int64_t kMostThumbnailCells = 40'000'000;

/// A PGM with the longer edge between 96 and 192 pixels, smaller for smaller maps; unknown cells are gray,
/// and of several cells the most occupied one is seen. Blocks. `wanted_no_more` is asked now and then.
tl::expected<std::string, Fault> thumbnailOf(const map::WholeMap& whole,
                                             const std::function<bool()>& wanted_no_more = {},
                                             std::int64_t most_cells = kMostThumbnailCells);

}  // namespace mapwright::grids
