// Writes a grid to files that other programs read back as the same cells. Any thread. Source: ROS map_server
// / nav2 map_io (map.yaml), ESRI world files.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"

namespace mapwright::grids {

// disk::WrittenFile describes which paths are possible ("-", a device, a link).

/// 8-bit PNG of level 0, row by row. Gray codes: the bytes as they are (ClearGray: 128 transparent).
/// Occupancy code: the map_saver gray levels (254 free, 0 occupied, 205 unknown) if there are no other
/// values, otherwise gray+alpha (intensity; unknown = transparent). nullopt = written (aside, then moved into
/// place), otherwise why not.
std::optional<Fault> writeGridPng(const GridPyramid& grid, const std::string& path,
                                  const std::function<bool(double done)>& proceed = {});

/// The two files of a map for map_server, from the path of either or the name without extension.
struct MapServerFiles {
  std::string pgm, yaml;
};
MapServerFiles mapServerFiles(const std::string& path);

/// Writes `base`.pgm and `base`.yaml (given the path of either). Trinary with map_saver's gray levels if all
/// cells are unknown, 0 or 100; otherwise mode raw with the cells as bytes: map_server reads both back as the
/// same cells.
std::optional<Fault> writeMapServer(const GridPyramid& grid, const map::GridReference& reference,
                                    const std::string& path,
                                    const std::function<bool(double done)>& proceed = {});

/// The six lines of a world file (.pgw) for a picture at `reference` (rotation included): centre of the top
/// left pixel.
std::string worldFileText(const map::GridReference& reference);
/// The text of map.yaml.
std::string mapYamlText(const map::GridReference& reference, const std::string& image, bool raw);

}  // namespace mapwright::grids
