#include "scene/layer.h"

#include <array>

#include <QCoreApplication>

namespace mapwright::scene {
namespace {

struct Row {
  Layer layer;
  const char* name;
  const char* title;
  bool shown;
};

constexpr std::array kRows{
    Row{Layer::WholeMap, "whole", QT_TRANSLATE_NOOP("scene", "Whole map"), false},
    Row{Layer::Regions, "regions", QT_TRANSLATE_NOOP("scene", "Map by regions"), true},
    Row{Layer::Submaps, "submaps", QT_TRANSLATE_NOOP("scene", "Submaps"), true},
    Row{Layer::Incremental, "incremental", QT_TRANSLATE_NOOP("scene", "Incremental"), false},
    Row{Layer::EnvMatch, "match", QT_TRANSLATE_NOOP("scene", "Match map"), false},
    Row{Layer::EnvSymmetry, "symmetry", QT_TRANSLATE_NOOP("scene", "Symmetry map"), false},
    Row{Layer::CostmapLow, "costmap", QT_TRANSLATE_NOOP("scene", "Costmap, coarse"), false},
    Row{Layer::CostmapHigh, "costmap-high", QT_TRANSLATE_NOOP("scene", "Costmap, fine"), false},
    Row{Layer::DispatchedCloud, "dispatched-cloud", QT_TRANSLATE_NOOP("scene", "Point cloud of the map"),
        true},
    Row{Layer::Grid, "grid", QT_TRANSLATE_NOOP("scene", "Grid"), true},
    Row{Layer::Overlays, "overlays", QT_TRANSLATE_NOOP("scene", "Overlays"), true},
    Row{Layer::Waypoints, "waypoints", QT_TRANSLATE_NOOP("scene", "Waypoints"), true},
    Row{Layer::Landmarks, "landmarks", QT_TRANSLATE_NOOP("scene", "Landmarks"), true},
    Row{Layer::Doors, "doors", QT_TRANSLATE_NOOP("scene", "Auto doors"), true},
    Row{Layer::Boxes, "boxes", QT_TRANSLATE_NOOP("scene", "Pallets, racks"), true},
    Row{Layer::Constraints, "constraints", QT_TRANSLATE_NOOP("scene", "Constraints"), false},
    Row{Layer::Outlines, "outlines", QT_TRANSLATE_NOOP("scene", "Outlines"), false},
    Row{Layer::Ids, "ids", QT_TRANSLATE_NOOP("scene", "Submap ids"), false},
    Row{Layer::Trajectory, "trajectory", QT_TRANSLATE_NOOP("scene", "Trajectory"), false},
    Row{Layer::Path, "path", QT_TRANSLATE_NOOP("scene", "Path"), true},
    Row{Layer::LocalPath, "local-path", QT_TRANSLATE_NOOP("scene", "Local path"), true},
    Row{Layer::Target, "target", QT_TRANSLATE_NOOP("scene", "Target"), true},
    Row{Layer::Cloud, "cloud", QT_TRANSLATE_NOOP("scene", "Lidar points"), true},
    Row{Layer::NearbyRobots, "robots", QT_TRANSLATE_NOOP("scene", "Nearby robots"), true},
    Row{Layer::Trail, "trail", QT_TRANSLATE_NOOP("scene", "Trail"), true},
    Row{Layer::Track, "track", QT_TRANSLATE_NOOP("scene", "Track of the bag"), true},
    Row{Layer::ExpandedFootprint, "expanded-footprint", QT_TRANSLATE_NOOP("scene", "Wide footprint"), false},
    Row{Layer::Footprint, "footprint", QT_TRANSLATE_NOOP("scene", "Footprint"), true},
    Row{Layer::Robot, "robot", QT_TRANSLATE_NOOP("scene", "Robot"), true},
    Row{Layer::ScaleBar, "scalebar", QT_TRANSLATE_NOOP("scene", "Scale bar"), true},
};

const Row& rowOf(Layer layer) {
  const Row& row = kRows[std::size_t(layer)];
  Q_ASSERT(row.layer == layer);
  return row;
}

}  // namespace

QString layerName(Layer layer) { return QString::fromLatin1(rowOf(layer).name); }

QString layerTitle(Layer layer) { return QCoreApplication::translate("scene", rowOf(layer).title); }

std::vector<Layer> allLayers() {
  std::vector<Layer> layers;
  for (const Row& row : kRows) layers.push_back(row.layer);
  return layers;
}

bool shownByDefault(Layer layer) { return rowOf(layer).shown; }

map::Streams layerStreams(Layer layer) {
  using map::Stream;
  switch (layer) {
    case Layer::WholeMap:
      return {Stream::WholeMap};
    case Layer::Incremental:
      return {Stream::Incremental};
    case Layer::EnvMatch:
      return {Stream::EnvMatch};
    case Layer::EnvSymmetry:
      return {Stream::EnvSymmetry};
    case Layer::CostmapLow:
      return {Stream::CostmapLow};
    case Layer::CostmapHigh:
      return {Stream::CostmapHigh};
    case Layer::Overlays:
      return {Stream::MapInfo};
    case Layer::Landmarks:
      return {Stream::Landmarks};
    case Layer::Doors:
      return {Stream::Doors};
    case Layer::Boxes:
      return {Stream::Pallets, Stream::Racks, Stream::SeenObjects};
    case Layer::Constraints:
      return {Stream::Constraints};
    case Layer::Trajectory:
      return {Stream::Trajectory};
    case Layer::Path:
      return {Stream::Path};
    case Layer::LocalPath:
      return {Stream::LocalPath};
    case Layer::Target:
      return {Stream::Planning};
    case Layer::Cloud:
      return {Stream::Cloud};
    case Layer::NearbyRobots:
      return {Stream::NearbyRobots, Stream::NearbyFootprints};
    case Layer::Regions:
    case Layer::Submaps:
    case Layer::DispatchedCloud:  // is requested region by region
    case Layer::Grid:
    case Layer::Waypoints:
    case Layer::Outlines:
    case Layer::Ids:
    case Layer::Track:
    case Layer::Trail:
    case Layer::ExpandedFootprint:
    case Layer::Footprint:
    case Layer::Robot:
    case Layer::ScaleBar:
      break;
  }
  return {};
}

bool followsRobot(Layer layer) {
  switch (layer) {
    case Layer::WholeMap:
    case Layer::Regions:
    case Layer::DispatchedCloud:
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
    traits.size_title = QCoreApplication::translate("scene", "Line width");
    return traits;
  };
  LayerTraits traits;
  switch (layer) {
    case Layer::WholeMap:
      traits.choice_title = QCoreApplication::translate("scene", "Zoomed out");
      traits.choices = {QCoreApplication::translate("scene", "Occupied wins"),
                        QCoreApplication::translate("scene", "Average")};
      return traits;
    case Layer::Cloud:
      traits.color = true;
      traits.size_px = {1, 8};
      traits.default_size_px = 2;
      traits.size_title = QCoreApplication::translate("scene", "Point size");
      traits.choice_title = QCoreApplication::translate("scene", "Colour");
      traits.choices = {QCoreApplication::translate("scene", "One colour"),
                        QCoreApplication::translate("scene", "By intensity"),
                        QCoreApplication::translate("scene", "By height")};
      return traits;
    case Layer::DispatchedCloud:
      traits.color = true;
      traits.size_px = {1, 8};
      traits.default_size_px = 2;
      traits.size_title = QCoreApplication::translate("scene", "Point size");
      traits.choice_title = QCoreApplication::translate("scene", "Colour");
      traits.choices = {QCoreApplication::translate("scene", "By height"),
                        QCoreApplication::translate("scene", "By intensity"),
                        QCoreApplication::translate("scene", "Own colour"),
                        QCoreApplication::translate("scene", "One colour")};
      return traits;
    case Layer::Track:
      traits = line(3);
      traits.color = false;
      traits.choice_title = QCoreApplication::translate("scene", "Colour");
      traits.choices = {QCoreApplication::translate("scene", "By time"),
                        QCoreApplication::translate("scene", "By speed"),
                        QCoreApplication::translate("scene", "By localization quality")};
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
