// A picture file with other cells in it. Any thread.
#pragma once

#include <optional>
#include <string>

#include "grids/grid_pyramid.h"

namespace mapwright::grids {

/// By the name of the file: PGM and PNG can be written, others only read.
bool canRewrite(const std::string& path);
/// Unknown ground can be written into such a picture: it has a shade that is read so, or can be transparent.
bool holdsUnknown(const map::CellReading& reading, CellCode code, const std::string& path);

/// Writes `cells` into the picture at `path` (PGM: P5; PNG: 8-bit gray, with alpha where it needs some),
/// whole or not at all, so that it reads back to the same cells by `reading`: then it is read back and
/// compared. Pixels of 8-bit grays stay as they are where they read to the wanted cell already. `cells` has
/// the picture's size and its code. nullopt = written, else why not.
std::optional<Fault> rewritePicture(const GridPyramid& cells, const std::string& path,
                                    const map::CellReading& reading);

}  // namespace mapwright::grids
