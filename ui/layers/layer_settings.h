// What the user has set for the layers, on its way to the settings and back.
#pragma once

#include <QSettings>
#include <QString>

#include "robot/offers_topics.h"
#include "ui/scene/map_scene.h"

namespace mapwright::ui {

/// All that can be set for one layer, besides its position.
struct LayerLook {
  bool shown = true;
  double opacity = 1;
  scene::LayerStyle style = {};
  bool operator==(const LayerLook&) const = default;
};

LayerLook lookOf(const scene::MapScene& scene, scene::Layer layer);
/// Opacity and style; not whether it is shown.
void setStyles(scene::MapScene& scene, scene::Layer layer, const LayerLook& look);
/// Under "layers/NAME/", within the settings' present group.
void writeLook(QSettings& settings, scene::Layer layer, const LayerLook& look);
/// Missing or invalid values get their defaults.
LayerLook readLook(const QSettings& settings, scene::Layer layer);
/// There is something about this layer.
bool holdsLook(const QSettings& settings, scene::Layer layer);

/// Order, visibility, opacity, styles.
void saveLayers(const scene::MapScene& scene, QSettings& settings);
void restoreLayers(scene::MapScene& scene, const QSettings& settings);
/// The chosen topics for the robot with that address; without any it is removed.
void saveTopics(const robot::TopicChoices& choices, const QString& address, QSettings& settings);
robot::TopicChoices savedTopics(const QString& address, const QSettings& settings);
/// Restores the original order, opacity and styles; visibility stays.
void resetOrderAndStyles(scene::MapScene& scene);
/// Visibility as at first.
void resetVisibility(scene::MapScene& scene);

}  // namespace mapwright::ui
