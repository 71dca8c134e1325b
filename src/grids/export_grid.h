// Writes a grid to files that other programs read back as the same cells. Any thread. Source: ROS map_server
// / nav2 map_io (map.yaml), AMCL, nav2's static layer, ESRI world files.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "disk/existing.h"
#include "grids/cell_counts.h"
#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"

namespace mapwright::grids {

// disk::WrittenFile describes which paths are possible ("-", a device, a link).

/// 8-bit PNG of level 0, row by row. Gray codes: the bytes as they are (ClearGray: 128 transparent).
/// Occupancy code: the map_saver gray levels (254 free, 0 occupied, 205 unknown) if there are no other
/// values, otherwise gray+alpha (intensity; unknown = transparent). nullopt = written (aside, then moved into
/// place), otherwise why not.
std::optional<Fault> writeGridPng(const GridPyramid& grid, const std::string& path,
                                  const std::function<bool(double done)>& proceed = {},
                                  disk::Existing existing = disk::Existing::Replace);

/// How a map.yaml has its picture read.
struct MapServerForm {
  using Mode = map::CellReading::Mode;
  Mode mode = Mode::Trinary;  // not Picture
  /// 0..1. None given: 0.65 and 0.196, and shades for which map_server gives what we show: in trinary the
  /// same walls, free and unknown cells, in scale and raw the percentages. One given: a cell's shade is its
  /// probability, as Cartographer's tools write it, and the thresholds decide.
  std::optional<double> occupied_thresh = {}, free_thresh = {};
};
/// Why no picture can be written so; nullopt if one can.
std::optional<Fault> flawOf(const MapServerForm& form);

/// The two files of a map for map_server, from the path of either or the name without extension. The picture
/// is a PGM; in mode scale a PNG, where transparent pixels are unknown.
struct MapServerFiles {
  std::string picture, yaml;
};
MapServerFiles mapServerFiles(const std::string& path,
                              MapServerForm::Mode mode = MapServerForm::Mode::Trinary);

/// What robots see of a map that map_server reads. AMCL and nav2's static layer take 100 for a wall; 0 is
/// free.
struct SeenByRobots {
  CellCounts shown;                  // as everywhere in the program
  std::int64_t walls = 0, free = 0;  // of these, the ones they see as such
  std::int64_t walls_as_free = 0;    // of `shown.occupied`, the ones that map_server reads as 0
  bool whole() const { return walls == shown.occupied && free == shown.free; }
};

/// Writes the picture and the map.yaml (given the path of either). Trinary without thresholds: map_saver's
/// gray levels if all cells are unknown, 0 or 100; otherwise a gray picture that keeps the order of shades,
/// in which every wall is a wall by the thresholds.
tl::expected<SeenByRobots, Fault> writeMapServer(const GridPyramid& grid, const map::GridReference& reference,
                                                 const std::string& path, const MapServerForm& form = {},
                                                 const std::function<bool(double done)>& proceed = {},
                                                 disk::Existing existing = disk::Existing::Replace);

/// The six lines of a world file (.pgw, .wld) for a picture at `reference` (rotation included): centre of the
/// top left pixel.
std::string worldFileText(const map::GridReference& reference);
/// The text of map.yaml; `reading` is none of mode Picture.
std::string mapYamlText(const map::GridReference& reference, const std::string& image,
                        const map::CellReading& reading);

}  // namespace mapwright::grids
