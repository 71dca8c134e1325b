// Replaces the cells in a picture file. Any thread.
#pragma once

#include <optional>
#include <string>

#include "grids/grid_pyramid.h"

namespace mapwright::grids {

/// By the file name: PGM and PNG can be written, others are read-only.
bool canRewrite(const std::string& path);
/// Unknown cells can be written to such a picture: one of its gray levels means unknown, or it can be
/// transparent.
bool holdsUnknown(const map::CellReading& reading, CellCode code, const std::string& path);

/// Writes `cells` into the picture at `path` (PGM: P5; PNG: 8-bit gray, with alpha if needed), completely or
/// not at all, so that it reads back to the same cells with `reading`: reads it back and compares. 8-bit gray
/// pixels that already give the wanted cell are not changed. `cells` has the picture's size and code. nullopt
/// = written, otherwise why not.
std::optional<Fault> rewritePicture(const GridPyramid& cells, const std::string& path,
                                    const map::CellReading& reading);

}  // namespace mapwright::grids
