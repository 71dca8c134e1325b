#include "ui/shot/view_facts.h"

#include <QCryptographicHash>

#include "grids/grid_pyramid.h"
#include "replay/replay_robot.h"
#include "submap/submap_store.h"
#include "ui/scene/layer.h"

namespace mapwright::ui::shot {
namespace {

/// Larger ones take more than a moment.
constexpr std::int64_t kMostSummedCells = 200'000'000;

void sumCells(const grids::GridPyramid& cells, suite::MapFact& map) {
  if (std::int64_t(cells.width()) * cells.height() > kMostSummedCells) return;
  QCryptographicHash sum(QCryptographicHash::Sha256);
  map.blocks = suite::CellBlocks(cells.width(), cells.height());
  grids::GridRows rows(cells);
  for (int y = 0; y < cells.height(); ++y) {
    const std::uint8_t* const row = rows.row(y);
    sum.addData(QByteArrayView(reinterpret_cast<const char*>(row), cells.width()));
    map.blocks.addRow(y, row);
  }
  map.cells = sum.result().toHex().left(32).toStdString();
}

void addMap(const session::Session& session, bool with_overlays, suite::Facts& facts) {
  const session::MapSlot& slot = session.wholeMap();
  const map::WholeMap& shown = slot.shown();
  const bool live = shown.key.kind == map::MapKind::Live;
  const auto& info = session.live().map_info;
  suite::MapFact map;
  map.id = map::toText(shown.key);
  map.name = slot.name().toStdString();
  if (const map::CatalogueEntry* const entry = map::entryOf(session.catalogue().entries(), shown.key)) {
    map.uid = entry->uid;
    map.version = entry->map_version;
    map.overlays_version = entry->overlays_version;
  }
  if (live && info) {
    map.uid = info->uid;
    map.version = info->map_version;
    map.overlays_version = info->overlays_version;
  }
  sumCells(*slot.cells(), map);
  map.box = slot.reference().bounds();
  map.origin = slot.reference().origin;
  map.resolution_m = slot.reference().resolution_m;
  facts.map = map;
  if (with_overlays && !live) facts.overlays = suite::overlaysText(shown.overlays);
}

void addSubmaps(const session::Session& session, suite::Facts& facts) {
  facts.session = session.submaps().uuid();
  for (const auto& [id, row] : session.submaps().rows()) {
    const auto pose = geometry::toIsometry(row.entry.pose);
    facts.submaps[id] = {row.shown_version >= 0 ? row.shown_version : row.entry.version,
                         pose ? geometry::projectToPlane(*pose) : geometry::Pose2(),
                         session.submaps().bounds(id, session.slice())};
  }
}

}  // namespace

suite::Facts factsOf(const Look& look, const session::Session& session) {
  using scene::Layer;
  const auto draws = [&](Layer layer) { return look.layers.contains(layer); };
  suite::Facts facts;
  facts.view = look.view;
  facts.theme = look.dark ? "dark" : "light";
  for (const Layer layer : scene::allLayers()) {
    if (draws(layer)) facts.layers.push_back(scene::layerName(layer).toStdString());
  }
  const bool whole = draws(Layer::WholeMap) && session.wholeMap().cells();
  if (whole) addMap(session, draws(Layer::Overlays), facts);
  if (draws(Layer::Submaps)) addSubmaps(session, facts);
  const auto& info = session.live().map_info;
  if (draws(Layer::Overlays) && facts.overlays.empty() && info)
    facts.overlays = suite::overlaysText(info->overlays);
  if (!facts.map && info) {
    facts.map =
        suite::MapFact{"live", info->name, info->uid, info->map_version, info->overlays_version, {}, {}};
  }
  if (whole && draws(Layer::Waypoints)) facts.waypoints = session.wholeMap().waypoints().points;
  if (draws(Layer::Robot)) facts.robot = session.live().robot_pose;
  if (const auto* const replayed = qobject_cast<const replay::ReplayRobot*>(&session.robot()))
    facts.stamps = replayed->topics();
  return facts;
}

}  // namespace mapwright::ui::shot
