// The layers of the map. Everything about one stands in its own file, except its row here.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include <QColor>
#include <QString>
#include <QStringList>

#include "map/stream.h"

namespace mapwright::map {
enum class GridKind;
}
namespace mapwright::robot {
class Robot;
}

namespace mapwright::ui::scene {

/// Everything that can be shown, in the default order, bottom first. A new layer is a row here, and a file
/// that defines its layerSpec(): docs/how-to/add-a-layer.md.
#define MAPWRIGHT_LAYERS(ROW) \
  ROW(Reference)              \
  ROW(WholeMap)               \
  ROW(Regions)                \
  ROW(Submaps)                \
  ROW(Incremental)            \
  ROW(EnvMatch)               \
  ROW(EnvSymmetry)            \
  ROW(CostmapLow)             \
  ROW(CostmapHigh)            \
  ROW(DispatchedCloud)        \
  ROW(Coverage)               \
  ROW(Disagreement)           \
  ROW(WallsOff)               \
  ROW(Problems)               \
  ROW(Grid)                   \
  ROW(Overlays)               \
  ROW(Waypoints)              \
  ROW(Landmarks)              \
  ROW(Doors)                  \
  ROW(Boxes)                  \
  ROW(Constraints)            \
  ROW(Closures)               \
  ROW(Outlines)               \
  ROW(Ids)                    \
  ROW(Trajectory)             \
  ROW(Path)                   \
  ROW(LocalPath)              \
  ROW(Target)                 \
  ROW(Cloud)                  \
  ROW(NearbyRobots)           \
  ROW(Trail)                  \
  ROW(Track)                  \
  ROW(ExpandedFootprint)      \
  ROW(Footprint)              \
  ROW(Robot)                  \
  ROW(ScaleBar)

#define MAPWRIGHT_LAYER(name) name,
enum class Layer { MAPWRIGHT_LAYERS(MAPWRIGHT_LAYER) };
#undef MAPWRIGHT_LAYER

/// How a layer is drawn. Settings that LayerTraits does not offer have no effect.
struct LayerStyle {
  QColor color;     // invalid = the theme's own
  double size = 0;  // px; 0 = the default
  int choice = 0;   // index into LayerTraits::choices
  bool operator==(const LayerStyle&) const = default;
};

/// The settings that a layer offers.
struct LayerTraits {
  bool color = false;
  std::optional<std::pair<double, double>> size_px = {};  // least, most
  double default_size_px = 0;
  QString size_title = {};    // "Point size", "Line width"
  QString choice_title = {};  // "Zooming out", "Colour by"
  QStringList choices = {};   // empty = none
  bool any() const { return color || size_px || !choices.isEmpty(); }
};

/// What belongs together in the list of layers.
enum class LayerGroup { Robot, Environment, Annotations, Map };
inline constexpr LayerGroup kLayerGroups[] = {LayerGroup::Robot, LayerGroup::Environment,
                                              LayerGroup::Annotations, LayerGroup::Map};

/// The sets of layers that are built in: presets of the window, the picture of a report, a snapshot without
/// `--layers`.
enum class LayerSet { Navigation = 1, Mapping = 2, MapOnly = 4, Report = 8, Snapshot = 16 };
Q_DECLARE_FLAGS(LayerSets, LayerSet)
Q_DECLARE_OPERATORS_FOR_FLAGS(LayerSets)

class LayerItem;
struct LayerContext;
struct LayerObjects;
struct LegendSample;
enum class ObjectForm;
class Legend;

/// Why a robot has no data for a layer, as a sentence; empty if it has.
using WhyEmpty = QString (*)(robot::Robot& robot);
QString neverEmpty(robot::Robot& robot);
QString noLiveDataReason(robot::Robot& robot);
QString noSubmapsReason(robot::Robot& robot);
QString noPoseGraphReason(robot::Robot& robot);
QString noMapFeaturesReason(robot::Robot& robot);

/// What is known about a layer.
struct LayerSpec {
  const char* name;   // for the command line and settings: "whole", "submaps", "costmap", …
  const char* title;  // for display, short; in the translation context "scene"
  LayerGroup group = LayerGroup::Map;
  bool shown = true;             // at first
  LayerSets sets = {};           // those that show it; presets hide it otherwise
  LayerSets left_alone = {};     // presets that neither show nor hide it
  map::Streams streams = {};     // the data that it needs from a robot, besides what is always on
  map::Streams always_on = {};   // what it needs of that: a snapshot waits for it
  std::vector<int> topics = {};  // map::topicIndex() of the messages that change what it shows
  /// It shows the robot's state, sensor data or plans: it is meaningless on a map that the robot is not in.
  /// (The open map's own landmarks and trajectories stay.)
  bool follows_robot = true;
  bool topic_chosen = false;  // the user may choose from which topic its data comes
  /// It changes many times a second: layers above the lowest such layer are painted without a kept picture.
  bool lively = false;
  bool shows_submaps = false;               // it changes with the submaps
  bool in_all = true;                       // part of "--layers all"
  const char* not_in_all_reason = nullptr;  // for its help; null: other options decide about the layer
  bool order_fixed = false;                 // its position in the order is
  bool in_fit = false;  // what it holds belongs into the view that shows everything, as maps do
  LayerTraits (*traits)() = [] { return LayerTraits(); };
  WhyEmpty why_empty = noLiveDataReason;
  /// The grid of the robot that it shows; drawn by RasterStack.
  std::optional<map::GridKind> grid = {};
  /// The graphics items that draw it, bottom first; null: RasterStack makes them.
  std::vector<LayerItem*> (*items)(const LayerContext& context) = nullptr;
  /// The things that it shows, one by one (scene/layer_objects.h); null: none that can be told apart.
  const LayerObjects* objects = nullptr;
  /// One thing, made up, that looks as MapObject::look says: for the legend, cards and lists.
  void (*sample)(LegendSample& sample, ObjectForm form, std::int64_t look) = nullptr;
  /// What its colours and shapes mean (scene/legend.h); null: nothing that needs to be said.
  void (*legend)(Legend& legend) = nullptr;
};

/// Defined in the file of each layer.
template <Layer>
LayerSpec layerSpec();
#define MAPWRIGHT_LAYER(name) \
  template <>                 \
  LayerSpec layerSpec<Layer::name>();
MAPWRIGHT_LAYERS(MAPWRIGHT_LAYER)
#undef MAPWRIGHT_LAYER

const LayerSpec& specOf(Layer layer);
/// The default order, bottom first.
const std::vector<Layer>& allLayers();
std::set<Layer> layersIn(LayerSet set);
QString layerName(Layer layer);
std::optional<Layer> layerNamed(const QString& name);
QString layerTitle(Layer layer);
QString groupName(LayerGroup group);  // for settings
QString groupTitle(LayerGroup group);
map::Streams layerStreams(Layer layer);
/// The kind of data whose topic can be chosen; nullopt: no choice.
std::optional<map::Stream> chosenStream(Layer layer);
/// Of a layer that consists of lines.
LayerTraits lineTraits(double width_px);

/// The choices of the layers that have some.
enum class WholeMapChoice { OccupiedWins, Average };
enum class TrackChoice { Time, Speed, Quality };
enum class CloudChoice { OneColor, Intensity, Height };
enum class DispatchedCloudChoice { Height, Intensity, Rgb, OneColor };

/// Lidar points by height: the colours reach from the ground to here.
inline constexpr float kLidarFullHeightM = 2.5F;

/// How two maps are compared on screen.
enum class CompareMode { Off, Swipe, Difference };

/// The content of the halves of a swipe.
enum class HalfContent { Nothing, Submaps, WholeMap, ComparedMap };
struct Halves {
  HalfContent left = HalfContent::WholeMap, right = HalfContent::Nothing;
};

}  // namespace mapwright::ui::scene
