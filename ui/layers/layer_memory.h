// Saves the layers' settings: order, visibility, opacity, styles.
#pragma once

#include "robot/offers_topics.h"
#include "scene/map_scene.h"

class QSettings;

namespace mapwright::window {

void saveLayers(const scene::MapScene& scene, QSettings& settings);
/// Missing or invalid settings get their defaults.
void restoreLayers(scene::MapScene& scene, const QSettings& settings);
/// The chosen topics for the robot with that address; without any it is removed.
void saveTopics(const robot::TopicChoices& choices, const QString& address, QSettings& settings);
robot::TopicChoices savedTopics(const QString& address, const QSettings& settings);
/// Restores the original order, opacity and styles; visibility stays.
void resetOrderAndStyles(scene::MapScene& scene);
/// Visibility as at first.
void resetVisibility(scene::MapScene& scene);

}  // namespace mapwright::window
