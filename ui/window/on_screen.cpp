#include "window/on_screen.h"

#include <QCoreApplication>

#include "map/whereabouts.h"
#include "regions/region_map.h"
#include "scene/map_clouds.h"
#include "scene/regions_on_map.h"
#include "window/replay/replay_state.h"
#include "window/status/status_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

bool comparing(const scene::MapScene& scene) { return scene.compareMode() != scene::CompareMode::Off; }

MapsInView mapsInView(const scene::MapScene& scene) {
  const regions::RegionMap* const regions = scene::RegionsOnMap::of(scene).map();
  const bool by_region = regions && scene.layerVisible(scene::Layer::Regions);
  return {scene.layerVisible(scene::Layer::Submaps),
          scene.layerVisible(scene::Layer::WholeMap) || comparing(scene), by_region,
          by_region && regions->regions().bytes() > 0,
          scene.layerVisible(scene::Layer::DispatchedCloud) && !scene::MapClouds::of(scene).empty()};
}

QString robotCalled(const robot::Robot& robot) {
  const robot::RobotIdentity identity = robot.identity();
  QString name = identity.name.isEmpty() ? identity.serial : identity.name;
  if (name.trimmed().isEmpty()) name = robot.address();
  return words::plainName(name);
}

QString submapsOf(session::Session* session, const scene::MapScene& scene) {
  // While it makes a new map its submaps are of none yet.
  if (!session || !scene.robotPlace().overlays_fit) return {};
  return plainWords(map::currentMapName(session->live(), session->catalogue().entries()), 60);
}

QString windowTitle(session::Session* session, const scene::MapScene& scene) {
  if (!session) return QStringLiteral("mapwright");
  const replay::ReplayRobot* const replayed = replayOf(session);
  const QString robot = robotCalled(session->robot()).left(80);
  const QString name =
      replayed ? QCoreApplication::translate("window", "Replay of %1 – %2").arg(bagCalled(*replayed), robot)
               : robot;
  QString map;
  if (mapsInView(scene).whole) {
    const session::MapSlot& slot = session->wholeMap();
    if (slot.phase() != session::MapSlot::Phase::Empty) map = mapOnScreen(slot);
    const session::MapSlot& second = session->comparedMap();
    if (comparing(scene) && second.cells()) {
      map = QCoreApplication::translate("window", "%1 | %2").arg(map, mapOnScreen(second));
    }
  } else if (mapsInView(scene).submaps && session->robot().submapSource()) {
    const QString its = submapsOf(session, scene);
    map = its.isEmpty() ? QCoreApplication::translate("window", "Submaps")
                        : QCoreApplication::translate("window", "Submaps of %1").arg(its);
  }
  // A map file is called like its map.
  return map.isEmpty() || map == name ? QStringLiteral("%1 – mapwright").arg(name)
                                      : QStringLiteral("%1 – %2 – mapwright").arg(map, name);
}

}  // namespace mapwright::window
