// Texts about what is on screen. Pure functions of the session and the scene; names in them are one line of
// plain text.
#pragma once

#include <optional>

#include <QString>

#include "robot/address.h"
#include "session/session.h"
#include "ui/scene/map_scene.h"
#include "ui/view/empty_state.h"

namespace mapwright::ui {

bool comparing(const scene::MapScene& scene);
/// Sensor points of the robot are drawn.
bool scansInView(const scene::MapScene& scene);
MapsInView mapsInView(const scene::MapScene& scene);
/// Its name, or another distinguishing text.
QString robotCalled(const robot::Robot& robot, const robot::Addresses& addresses);
/// The map that the submaps belong to; empty if unknown.
QString submapsOf(session::Session* session, const scene::MapScene& scene);
/// The labels of the halves of a swipe, distinguishable even if both have the same name; empty: there is no
/// swipe.
struct HalfNames {
  QString left, right;
};
HalfNames halfNames(session::Session* session, const scene::MapScene& scene);
/// The same for the open map and the one that it is compared with.
HalfNames comparedNames(const session::Session& session);
/// "Ground floor – dock-3 – mapwright", `called`: dock-3. Null: no robot.
QString windowTitle(session::Session* session, const scene::MapScene& scene, const QString& called);

enum class ViewMode { Submaps, Whole, Both };

/// nullopt: neither is visible.
std::optional<ViewMode> viewMode(const scene::MapScene& scene);
/// Both: the whole map is moved below the submaps.
void setViewMode(scene::MapScene& scene, ViewMode mode);

}  // namespace mapwright::ui
