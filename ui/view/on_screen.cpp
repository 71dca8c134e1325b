#include "ui/view/on_screen.h"

#include <algorithm>

#include <QCoreApplication>

#include "map/whereabouts.h"
#include "regions/region_map.h"
#include "ui/kit/status_text.h"
#include "ui/view/replay_state.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

using session::MapSlot;

/// Its name, or its state.
QString nameOf(const MapSlot& slot) {
  if (slot.phase() == MapSlot::Phase::Empty) return QCoreApplication::translate("window", "no whole map yet");
  const QString progress = slot.cells() ? QString() : mapProgressText(slot);
  return progress.isEmpty() ? mapOnScreen(slot) : progress;
}

/// Distinguishes it from another map with the same name.
QString markOf(const MapSlot& slot) {
  const map::WholeMap& shown = slot.shown();
  const map::MapKey& key = slot.cells() ? shown.key : slot.key();
  if (shown.state_of) return QCoreApplication::translate("window", "before");
  if (key.kind == map::MapKind::Live) return QCoreApplication::translate("window", "live");
  if (key.kind == map::MapKind::File)
    return plainWords(shown.path.empty() ? map::toText(key) : shown.path, 120);
  return QCoreApplication::translate("window", "id %1").arg(plainWords(map::toText(key), 60));
}

QString submapsCalled(session::Session* session, const scene::MapScene& scene) {
  const QString its = submapsOf(session, scene);
  return its.isEmpty() ? QCoreApplication::translate("window", "Submaps")
                       : QCoreApplication::translate("window", "Submaps of %1").arg(its);
}

}  // namespace

bool comparing(const scene::MapScene& scene) { return scene.compareMode() != scene::CompareMode::Off; }

bool scansInView(const scene::MapScene& scene) {
  if (!scene.session() || !scene.layerVisible(scene::Layer::Cloud)) return false;
  const auto& clouds = scene.session()->live().clouds;
  return std::any_of(clouds.begin(), clouds.end(),
                     [](const auto& cloud) { return cloud.second && !cloud.second->empty(); });
}

MapsInView mapsInView(const scene::MapScene& scene) {
  const regions::RegionMap* const regions = scene.regions();
  const bool by_region = regions && scene.layerVisible(scene::Layer::Regions);
  const bool submaps = comparing(scene) ? scene.compareMode() == scene::CompareMode::Swipe &&
                                              scene.halves().left == scene::HalfContent::Submaps
                                        : scene.layerVisible(scene::Layer::Submaps);
  return {submaps,
          scene.layerVisible(scene::Layer::WholeMap) || comparing(scene),
          by_region,
          by_region && regions->regions().bytes() > 0,
          scene.showsClouds(),
          scansInView(scene)};
}

QString robotCalled(const robot::Robot& robot, const robot::Addresses& addresses) {
  const robot::RobotIdentity identity = robot.identity();
  QString name = identity.name.isEmpty() ? identity.serial : identity.name;
  if (name.trimmed().isEmpty()) name = addresses.hostShown(robot.address());
  if (name.isEmpty()) name = robot.address();
  return words::plainName(name);
}

QString submapsOf(session::Session* session, const scene::MapScene& scene) {
  // While it makes a new map its submaps belong to none yet.
  if (!session || !scene.robotPlace().overlays_fit) return {};
  return plainWords(map::currentMapName(session->live(), session->catalogue().entries()), 60);
}

HalfNames comparedNames(const session::Session& session) {
  HalfNames names{nameOf(session.wholeMap()), nameOf(session.comparedMap())};
  if (names.left != names.right) return names;
  const QString with = QStringLiteral("%1 (%2)");
  return {with.arg(names.left, markOf(session.wholeMap())),
          with.arg(names.right, markOf(session.comparedMap()))};
}

HalfNames halfNames(session::Session* session, const scene::MapScene& scene) {
  if (!session || scene.compareMode() != scene::CompareMode::Swipe) return {};
  const auto called = [&](scene::HalfContent content) {
    switch (content) {
      case scene::HalfContent::Submaps:
        return submapsCalled(session, scene);
      case scene::HalfContent::WholeMap:
        return nameOf(session->wholeMap());
      default:
        return QString();
    }
  };
  const scene::Halves halves = scene.halves();
  if (halves.right == scene::HalfContent::ComparedMap) return comparedNames(*session);
  return {called(halves.left), called(halves.right)};
}

QString windowTitle(session::Session* session, const scene::MapScene& scene, const QString& called) {
  if (!session) return QStringLiteral("mapwright");
  const replay::ReplayRobot* const replayed = replayOf(session);
  const QString robot = plainWords(called, 80);
  const QString name =
      replayed ? QCoreApplication::translate("window", "Replay of %1 – %2").arg(bagCalled(*replayed), robot)
               : robot;
  QString map;
  if (mapsInView(scene).whole) {
    const session::MapSlot& slot = session->wholeMap();
    if (slot.phase() != session::MapSlot::Phase::Empty) map = mapOnScreen(slot);
    if (comparing(scene)) {
      const bool difference = scene.compareMode() == scene::CompareMode::Difference;
      const HalfNames names = difference ? comparedNames(*session) : halfNames(session, scene);
      if (!names.left.isEmpty() && !names.right.isEmpty())
        map = QCoreApplication::translate("window", "%1 | %2").arg(names.left, names.right);
    }
  } else if (mapsInView(scene).submaps && session->robot().submapSource()) {
    map = submapsCalled(session, scene);
  }
  // A map file is named after its map.
  return map.isEmpty() || map == name ? QStringLiteral("%1 – mapwright").arg(name)
                                      : QStringLiteral("%1 – %2 – mapwright").arg(map, name);
}

using scene::Layer;

std::optional<ViewMode> viewMode(const scene::MapScene& scene) {
  const bool submaps = scene.layerVisible(Layer::Submaps), whole = scene.layerVisible(Layer::WholeMap);
  if (submaps && whole) return ViewMode::Both;
  if (submaps) return ViewMode::Submaps;
  return whole ? std::optional(ViewMode::Whole) : std::nullopt;
}

void setViewMode(scene::MapScene& scene, ViewMode mode) {
  if (mode == ViewMode::Both) {
    std::vector<Layer> order = scene.layerOrder();
    const auto whole = std::find(order.begin(), order.end(), Layer::WholeMap);
    const auto submaps = std::find(order.begin(), order.end(), Layer::Submaps);
    if (whole > submaps) {
      std::rotate(submaps, whole, whole + 1);
      scene.setLayerOrder(order);
    }
  }
  scene.setLayerVisible(Layer::WholeMap, mode != ViewMode::Submaps);
  scene.setLayerVisible(Layer::Submaps, mode != ViewMode::Whole);
}

}  // namespace mapwright::ui
