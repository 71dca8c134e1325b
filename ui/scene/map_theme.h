// The colours and the type of the map, light and dark.
#pragma once

#include <QColor>
#include <QFont>

#include "render/tile_colors.h"

namespace mapwright::ui::scene {

struct MapTheme {
  render::MapColors map;
  QColor grid_minor, grid_major, axis;
  QColor text, text_halo;
  QColor accent, robot, robot_outline, trail, outline, outline_frozen, measure, stale_veil;
  QColor cloud, path, trajectory, target, other_robot, constraint, region, place;
  QColor good, warn, bad;
  QFont label_font;
  bool dark = false;
};

MapTheme lightMapTheme();
MapTheme darkMapTheme();

}  // namespace mapwright::ui::scene
