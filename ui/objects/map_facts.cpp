#include "ui/objects/map_facts.h"

#include <QCoreApplication>
#include <QDateTime>

#include "ui/kit/status_text.h"
#include "ui/scene/lengths.h"
#include "words/decimal.h"

namespace mapwright::ui {
namespace {

class MapText {
  Q_DECLARE_TR_FUNCTIONS(MapFacts)
};

constexpr double kFinestScale = 0.001;

QString share(std::int64_t cells, const map::GridReference& grid, std::int64_t all) {
  const double m2 = double(cells) * grid.resolution_m * grid.resolution_m;
  return MapText::tr("%1 (%2 %, %3)")
      .arg(countText(cells))
      .arg(all > 0 ? 100.0 * double(cells) / double(all) : 0, 0, 'f', 1)
      .arg(scene::areaText(m2));
}

}  // namespace

std::vector<scene::ObjectProperty> mapFacts(const session::MapSlot& slot, const session::Session& session,
                                            const std::optional<grids::CellCounts>& counts) {
  std::vector<scene::ObjectProperty> facts;
  const auto add = [&](const QString& name, const QString& value) {
    if (!value.isEmpty()) facts.push_back({name, value});
  };
  const map::WholeMap& shown = slot.shown();
  const map::GridReference& grid = slot.reference();
  const map::CatalogueEntry* const entry = map::entryOf(session.catalogue().entries(), shown.key);
  const bool file = shown.key.kind == map::MapKind::File;
  if (!file) add(MapText::tr("Id"), plainWords(map::toText(shown.key), 200));
  if (entry) {
    add(MapText::tr("Uid"), plainWords(entry->uid, 200));
    add(MapText::tr("Map name"), plainWords(entry->file_name, 200));
    add(MapText::tr("State"), plainWords(entry->state, 40));
    if (entry->map_version) add(MapText::tr("Version"), QString::number(*entry->map_version));
    if (entry->overlays_version)
      add(MapText::tr("Overlays version"), QString::number(*entry->overlays_version));
    if (entry->is_current && !file) add(MapText::tr("Used by the robot"), MapText::tr("yes"));
    if (entry->modified_s)
      add(MapText::tr("Changed"), QDateTime::fromSecsSinceEpoch(qint64(*entry->modified_s))
                                      .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")));
  }
  const bool no_cells = file && shown.path.empty();  // overlays alone
  if (!no_cells)
    add(MapText::tr("Size"), MapText::tr("%1 × %2 cells").arg(countText(grid.width), countText(grid.height)));
  add(MapText::tr("Extent"),
      QStringLiteral("%1 × %2").arg(scene::lengthText(grid.width * grid.resolution_m),
                                    scene::lengthText(grid.height * grid.resolution_m)));
  if (!no_cells)
    add(MapText::tr("Resolution"), MapText::tr("%1 m per cell").arg(words::decimal(grid.resolution_m)));
  add(MapText::tr("Origin"), coordinatesText({grid.origin.x_m, grid.origin.y_m}, kFinestScale));
  add(MapText::tr("Turned by"), rotationText(grid.origin.yaw_rad));
  const geometry::WorldRect bounds = grid.bounds();
  add(MapText::tr("From"), coordinatesText({bounds.min_x, bounds.min_y}, kFinestScale));
  add(MapText::tr("To"), coordinatesText({bounds.max_x, bounds.max_y}, kFinestScale));
  if (counts && !no_cells) {
    add(MapText::tr("Free cells"), share(counts->free, grid, counts->all()));
    add(MapText::tr("Occupied cells"), share(counts->occupied, grid, counts->all()));
    add(MapText::tr("Unknown cells"), share(counts->unknown, grid, counts->all()));
  }
  add(MapText::tr("File"), plainWords(shown.path, 1000));
  if (shown.path.empty())
    add(file ? MapText::tr("File") : MapText::tr("Robot"),
        plainWords(session.robot().address().toStdString(), 300));
  return facts;
}

}  // namespace mapwright::ui
