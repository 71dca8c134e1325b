#include "scene/layer.h"

#include <array>

namespace mapwright::scene {
namespace {

struct Row {
  Layer layer;
  const char* name;
  const char* title;
  bool shown;
  const char* topics;  // space-separated
};

constexpr std::array kRows{
    Row{Layer::WholeMap, "whole", "Whole map", false, "/map_v2"},
    Row{Layer::Submaps, "submaps", "Submaps", true, ""},
    Row{Layer::Incremental, "incremental", "Incremental", false, "/incremental_map_v2"},
    Row{Layer::EnvMatch, "match", "Match map", false, "/env_match_map"},
    Row{Layer::EnvSymmetry, "symmetry", "Symmetry map", false, "/env_symmetry_map"},
    Row{Layer::CostmapLow, "costmap", "Costmap, coarse", false, "/maps/5cm/1hz"},
    Row{Layer::CostmapHigh, "costmap-high", "Costmap, fine", false, "/maps/1cm/1hz"},
    Row{Layer::Grid, "grid", "Grid", true, ""},
    Row{Layer::Overlays, "overlays", "Overlays", true, "/map/info"},
    Row{Layer::Waypoints, "waypoints", "Nav. points", true, ""},
    Row{Layer::Landmarks, "landmarks", "Landmarks", true, "/landmarks"},
    Row{Layer::Doors, "doors", "Auto doors", true, "/nearby_auto_doors"},
    Row{Layer::Boxes, "boxes", "Pallets, racks", true,
        "/detected_pallets /detected_rack /vision_detected_objects"},
    Row{Layer::Constraints, "constraints", "Constraints", false, "/constraint_list"},
    Row{Layer::Outlines, "outlines", "Outlines", false, ""},
    Row{Layer::Ids, "ids", "Submap ids", false, ""},
    Row{Layer::Trajectory, "trajectory", "Trajectory", false, "/trajectory /trajectory_node_list"},
    Row{Layer::Path, "path", "Path", true, "/path"},
    Row{Layer::LocalPath, "local-path", "Local path", true, "/local_path"},
    Row{Layer::Target, "target", "Target", true, "/planning_state"},
    Row{Layer::Cloud, "cloud", "Lidar points", true, "/scan_matched_points2"},
    Row{Layer::NearbyRobots, "robots", "Nearby robots", true, "/nearby_robots /nearby_robot_footprints"},
    Row{Layer::Trail, "trail", "Trail", true, ""},
    Row{Layer::ExpandedFootprint, "expanded-footprint", "Wide footprint", false, ""},
    Row{Layer::Footprint, "footprint", "Footprint", true, ""},
    Row{Layer::Robot, "robot", "Robot", true, ""},
    Row{Layer::ScaleBar, "scalebar", "Scale bar", true, ""},
};

const Row& rowOf(Layer layer) {
  const Row& row = kRows[std::size_t(layer)];
  Q_ASSERT(row.layer == layer);
  return row;
}

}  // namespace

QString layerName(Layer layer) { return QString::fromLatin1(rowOf(layer).name); }

QString layerTitle(Layer layer) { return QString::fromLatin1(rowOf(layer).title); }

std::vector<Layer> allLayers() {
  std::vector<Layer> layers;
  for (const Row& row : kRows) layers.push_back(row.layer);
  return layers;
}

bool shownByDefault(Layer layer) { return rowOf(layer).shown; }

QStringList layerTopics(Layer layer) {
  return QString::fromLatin1(rowOf(layer).topics).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

bool followsRobot(Layer layer) {
  switch (layer) {
    case Layer::WholeMap:
    case Layer::Grid:
    case Layer::Overlays:
    case Layer::Waypoints:
    case Layer::ScaleBar:
      return false;
    default:
      return true;
  }
}

bool orderFixed(Layer layer) { return layer == Layer::ScaleBar; }

LayerTraits layerTraits(Layer layer) {
  const auto line = [](double width) {
    LayerTraits traits;
    traits.color = true;
    traits.size_px = {1, 12};
    traits.default_size_px = width;
    traits.size_title = QStringLiteral("Line width");
    return traits;
  };
  LayerTraits traits;
  switch (layer) {
    case Layer::WholeMap:
      traits.choice_title = QStringLiteral("Zoomed out");
      traits.choices = {QStringLiteral("Occupied wins"), QStringLiteral("Average")};
      return traits;
    case Layer::Cloud:
      traits.color = true;
      traits.size_px = {1, 8};
      traits.default_size_px = 2;
      traits.size_title = QStringLiteral("Point size");
      traits.choice_title = QStringLiteral("Colour");
      traits.choices = {QStringLiteral("One colour"), QStringLiteral("By intensity"),
                        QStringLiteral("By height")};
      return traits;
    case Layer::Path:
      return line(3);
    case Layer::Trajectory:
    case Layer::Trail:
    case Layer::Constraints:
    case Layer::Footprint:
    case Layer::ExpandedFootprint:
      return line(layer == Layer::Constraints ? 1 : 2);
    case Layer::LocalPath:
    case Layer::NearbyRobots:
    case Layer::Landmarks:
    case Layer::Target:
    case Layer::Boxes:
      traits.color = true;
      return traits;
    default:
      return traits;
  }
}

}  // namespace mapwright::scene
