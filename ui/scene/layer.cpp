#include "ui/scene/layer.h"

#include <algorithm>
#include <iterator>

#include <QCoreApplication>

#include "robot/robot.h"
#include "robot/slam_file.h"
#include "sentences/absence_sentence.h"
#include "ui/scene/layer_reason.h"

namespace mapwright::ui::scene {

const LayerSpec& specOf(Layer layer) {
#define MAPWRIGHT_LAYER(name) layerSpec<Layer::name>(),
  static const std::vector<LayerSpec> specs{MAPWRIGHT_LAYERS(MAPWRIGHT_LAYER)};
#undef MAPWRIGHT_LAYER
  return specs[std::size_t(layer)];
}

const std::vector<Layer>& allLayers() {
#define MAPWRIGHT_LAYER(name) Layer::name,
  static const std::vector<Layer> layers{MAPWRIGHT_LAYERS(MAPWRIGHT_LAYER)};
#undef MAPWRIGHT_LAYER
  return layers;
}

std::set<Layer> layersIn(LayerSet set) {
  std::set<Layer> layers;
  std::copy_if(allLayers().begin(), allLayers().end(), std::inserter(layers, layers.end()),
               [set](Layer layer) { return specOf(layer).sets.testFlag(set); });
  return layers;
}

QString layerName(Layer layer) { return QString::fromLatin1(specOf(layer).name); }

std::optional<Layer> layerNamed(const QString& name) {
  const auto found = std::find_if(allLayers().begin(), allLayers().end(),
                                  [&](Layer layer) { return layerName(layer) == name; });
  return found == allLayers().end() ? std::nullopt : std::optional(*found);
}

QString layerTitle(Layer layer) { return QCoreApplication::translate("scene", specOf(layer).title); }

QString groupName(LayerGroup group) {
  switch (group) {
    case LayerGroup::Robot:
      return QStringLiteral("robot");
    case LayerGroup::Environment:
      return QStringLiteral("environment");
    case LayerGroup::Annotations:
      return QStringLiteral("annotations");
    case LayerGroup::Map:
      break;
  }
  return QStringLiteral("map");
}

QString groupTitle(LayerGroup group) {
  switch (group) {
    case LayerGroup::Robot:
      return QCoreApplication::translate("scene", "Robot");
    case LayerGroup::Environment:
      return QCoreApplication::translate("scene", "Environment");
    case LayerGroup::Annotations:
      return QCoreApplication::translate("scene", "Annotations");
    case LayerGroup::Map:
      break;
  }
  return QCoreApplication::translate("scene", "Map");
}

map::Streams layerStreams(Layer layer) { return specOf(layer).streams; }

std::optional<map::Stream> chosenStream(Layer layer) {
  const LayerSpec& spec = specOf(layer);
  return spec.topic_chosen ? std::optional(*spec.streams.begin()) : std::nullopt;
}

LayerTraits lineTraits(double width_px) {
  return {.color = true,
          .size_px = std::pair(1.0, 12.0),
          .default_size_px = width_px,
          .size_title = QCoreApplication::translate("scene", "Line width")};
}

QString neverEmpty(robot::Robot&) { return {}; }

QString noLiveDataReason(robot::Robot& robot) {
  return robot.liveTopics() || robot.submapSource()
             ? QString()
             : QCoreApplication::translate("scene", "There is no live data here, so this layer stays empty.");
}

QString noSubmapsReason(robot::Robot& robot) {
  return robot.submapSource() ? QString()
                              : sentences::absenceReason(robot::Capability::Submaps,
                                                         robot.unavailableReason(robot::Capability::Submaps));
}

QString noPoseGraphReason(robot::Robot& robot) {
  return robot.poseGraphSource()
             ? QString()
             : sentences::absenceReason(robot::Capability::PoseGraph,
                                        robot.unavailableReason(robot::Capability::PoseGraph));
}

QString noMapFeaturesReason(robot::Robot& robot) {
  return robot.wholeMapSource() || robot.liveTopics()
             ? QString()
             : QCoreApplication::translate("scene", "This robot does not provide this.");
}

QString whyEmpty(Layer layer, robot::Robot& robot) {
  const LayerSpec& spec = specOf(layer);
  const QString why = spec.why_empty(robot);
  robot::LiveTopics* const live = robot.liveTopics();
  if (!why.isEmpty() || !live || robot::slamFileOf(robot).isEmpty()) return why;
  // A state file knows all that it has.
  map::Streams needed = spec.streams;
  needed.insert(spec.always_on.begin(), spec.always_on.end());
  if (needed.empty() && spec.why_empty != noLiveDataReason) return {};
  const bool has = std::any_of(needed.begin(), needed.end(),
                               [&](map::Stream stream) { return !live->topicsOf(stream).isEmpty(); });
  return has ? QString() : QCoreApplication::translate("scene", "There is nothing of the kind in this file.");
}

}  // namespace mapwright::ui::scene
