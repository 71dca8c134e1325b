// What is remembered of the layers: order, visibility, opacity, styles.
#pragma once

#include "robot/offers_topics.h"
#include "scene/map_scene.h"

class QSettings;

namespace mapwright::window {

void saveLayers(const scene::MapScene& scene, QSettings& settings);
/// What the settings do not hold, or hold badly, gets its default.
void restoreLayers(scene::MapScene& scene, const QSettings& settings);
/// Which topics were chosen for the robot of that address; without any it is forgotten.
void saveTopics(const robot::TopicChoices& choices, const QString& address, QSettings& settings);
robot::TopicChoices savedTopics(const QString& address, const QSettings& settings);
/// Order, opacity and styles as at first; what is visible stays.
void resetOrderAndStyles(scene::MapScene& scene);
/// Visibility as at first.
void resetVisibility(scene::MapScene& scene);

}  // namespace mapwright::window
