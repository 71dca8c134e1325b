#include "raster/export_grid.h"

namespace mapwright::raster {

std::optional<std::string> writeGridPng(const GridPyramid&, const std::string&,
                                        const std::function<bool(double done)>&) {
  return "Not written yet.";
}
std::optional<std::string> writeMapServer(const GridPyramid&, const map::GridReference&, const std::string&,
                                          const std::function<bool(double done)>&) {
  return "Not written yet.";
}
std::string worldFileText(const map::GridReference&) { return {}; }
std::string mapYamlText(const map::GridReference&, const std::string&, bool) { return {}; }

}  // namespace mapwright::raster
