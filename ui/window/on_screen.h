// What is on screen, in words. Pure functions of the session and the scene; names in them are one line of
// plain text.
#pragma once

#include <QString>

#include "scene/map_scene.h"
#include "session/session.h"
#include "window/map/empty_state.h"

namespace mapwright::window {

bool comparing(const scene::MapScene& scene);
/// Points that the robot scans, or did, are drawn.
bool scansInView(const scene::MapScene& scene);
MapsInView mapsInView(const scene::MapScene& scene);
/// Its name, or what else tells it from others.
QString robotCalled(const robot::Robot& robot);
/// The map that the submaps belong to; empty where none is known.
QString submapsOf(session::Session* session, const scene::MapScene& scene);
/// What the halves of a swipe really show, told apart where both have one name; empty: there is no swipe.
struct HalfNames {
  QString left, right;
};
HalfNames halfNames(session::Session* session, const scene::MapScene& scene);
/// The open map and the one that it is compared with, likewise.
HalfNames comparedNames(const session::Session& session);
/// "Ground floor – dock-3 – mapwright". Null: no robot.
QString windowTitle(session::Session* session, const scene::MapScene& scene);

}  // namespace mapwright::window
