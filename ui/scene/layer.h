// The layers of the map: their names, what data they need, and how they can be styled.
#pragma once

#include <optional>
#include <vector>

#include <QColor>
#include <QString>
#include <QStringList>

#include "map/stream.h"

namespace mapwright::scene {

/// Everything that can be shown, in the default order, bottom first.
enum class Layer {
  WholeMap,
  Regions,  // a map too large to be sent whole, as far as it has been fetched
  Submaps,
  Incremental,
  EnvMatch,
  EnvSymmetry,
  CostmapLow,
  CostmapHigh,
  DispatchedCloud,  // of the map, in space
  Grid,
  Overlays,
  Waypoints,
  Landmarks,
  Doors,
  Boxes,  // pallets, racks, seen objects
  Constraints,
  Outlines,
  Ids,
  Trajectory,
  Path,
  LocalPath,
  Target,
  Cloud,
  NearbyRobots,
  Trail,
  Track,  // of a whole bag
  ExpandedFootprint,
  Footprint,
  Robot,
  ScaleBar,
};

/// For the command line and settings: "whole", "submaps", "costmap", "cloud", …
QString layerName(Layer layer);
/// For display, short: "Whole map", "Costmap, coarse", …
QString layerTitle(Layer layer);
/// The default order, bottom first.
std::vector<Layer> allLayers();
bool shownByDefault(Layer layer);
/// The data that it needs from a robot, besides what is always on.
map::Streams layerStreams(Layer layer);
/// True if it shows the robot's state, sensor data or plans: it is meaningless on a map that the robot is not
/// in. (The open map's own landmarks and trajectories stay.)
bool followsRobot(Layer layer);
/// True if its position is fixed (the scale bar is always on top).
bool orderFixed(Layer layer);

/// How a layer is drawn. Settings that styleTraits() does not offer have no effect.
struct LayerStyle {
  QColor color;     // invalid = the theme's own
  double size = 0;  // px; 0 = the default
  int choice = 0;   // index into LayerTraits::choices
  bool operator==(const LayerStyle&) const = default;
};

/// The settings that a layer offers.
struct LayerTraits {
  bool color = false;
  std::optional<std::pair<double, double>> size_px;  // least, most
  double default_size_px = 0;
  QString size_title;    // "Point size", "Line width"
  QString choice_title;  // "Zooming out", "Colour by"
  QStringList choices;   // empty = none
  bool any() const { return color || size_px || !choices.isEmpty(); }
};
LayerTraits layerTraits(Layer layer);

/// The choices of the layers that have some.
enum class WholeMapChoice { OccupiedWins, Average };
enum class TrackChoice { Time, Speed, Quality };
enum class CloudChoice { OneColor, Intensity, Height };
enum class DispatchedCloudChoice { Height, Intensity, Rgb, OneColor };

/// How two maps are compared on screen.
enum class CompareMode { Off, Swipe, Difference };

/// The content of the halves of a swipe.
enum class HalfContent { Nothing, Submaps, WholeMap, ComparedMap };
struct Halves {
  HalfContent left = HalfContent::WholeMap, right = HalfContent::Nothing;
};

}  // namespace mapwright::scene
