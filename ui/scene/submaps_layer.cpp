#include <algorithm>
#include <array>
#include <charconv>

#include "render/compositor.h"
#include "render/tile_renderer.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "submap/row_version.h"
#include "submap/submap_store.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"
#include "ui/scene/submap_classes.h"
#include "words/listed.h"

namespace mapwright::ui::scene {
namespace {

constexpr int kMapTileEdge = 256;  // of the renderer's tiles

/// The composited submaps.
class SubmapsLayer : public DeviceLayer {
 public:
  using DeviceLayer::DeviceLayer;
  bool settled() const override { return context_.submaps->settled(); }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.outlines); }

 protected:
  void onViewChanged(const geometry::ViewTransform& device_view) override {
    context_.submaps->setView(device_view);
  }
  void paintPixels(QPainter& painter, const QRectF& exposed) override {
    const std::vector<render::DrawnTile> tiles = context_.submaps->drawnTiles();
    const auto first =
        std::find_if(tiles.begin(), tiles.end(), [](const auto& tile) { return !tile.stand_in; });
    const std::span stand_ins(tiles.begin(), first), finished(first, tiles.end());
    if (!stand_ins.empty() && context_.submaps->colors().clear_unknown) {
      // A transparent part of a finished tile shows the layer below, not the stand-in.
      QRegion open(exposed.toAlignedRect());
      for (const render::DrawnTile& tile : finished) {
        open -= QRect(int(tile.to_viewport.dx()), int(tile.to_viewport.dy()), kMapTileEdge, kMapTileEdge);
      }
      painter.save();
      painter.setClipRegion(open, Qt::IntersectClip);
      drawTiles(painter, exposed, stand_ins);
      painter.restore();
    } else {
      drawTiles(painter, exposed, stand_ins);
    }
    drawTiles(painter, exposed, finished);
  }
};

/// The trajectories of each colour: "Trajectory 0", or several where there are more than colours.
void trajectoriesLegend(Legend& legend, const submap::SubmapStore& submaps) {
  constexpr qsizetype kMost = 4;
  std::array<QStringList, render::kClasses> numbers;
  for (const std::int32_t trajectory : trajectoriesOf(submaps))
    numbers[std::size_t(trajectoryClass(trajectory))] << QString::number(trajectory);
  const auto colors = render::classColors(render::ColorMode::Trajectory);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].isEmpty()) continue;
    const bool cut = numbers[i].size() > kMost;
    const QString named = words::listed(numbers[i].mid(0, kMost)) + (cut ? QStringLiteral(" …") : QString());
    const QString text =
        numbers[i].size() == 1 ? LegendText::tr("Trajectory %1") : LegendText::tr("Trajectories %1");
    legend.addCell(text.arg(named), QColor(colors[i]));
  }
}

void classesLegend(Legend& legend) {
  const std::span<const std::uint32_t> colors = render::classColors(legend.colors());
  const std::vector<QColor> ramp(colors.begin(), colors.end());
  switch (legend.colors()) {
    case render::ColorMode::Trajectory:
      if (legend.session()) trajectoriesLegend(legend, legend.session()->submaps());
      break;
    case render::ColorMode::Age:
      legend.addScale(LegendText::tr("older"), LegendText::tr("newer"), ramp);
      break;
    default:
      legend.addScale(LegendText::tr("few scans"),
                      LegendText::tr("%1 and more").arg(kFirstVersionStep << (render::kClasses - 2)), ramp);
      legend.addCell(LegendText::tr("Version unknown"), QColor(render::kUnknownVersionColor));
  }
  legend.addCell(LegendText::tr("Occupied"), QColor(legend.theme().map.occupied));
  legend.addCell(LegendText::tr("Unknown"), QColor(legend.theme().map.unknown));
}

void submapsLegend(Legend& legend) {
  if (!render::classColors(legend.colors()).empty()) return classesLegend(legend);
  const render::ColorTable table(legend.theme().map, legend.colors());
  const auto cell = [&](int flags, int intensity) {
    return QColor(table.at(std::uint16_t(render::kObserved | flags), std::uint8_t(intensity)));
  };
  addCells(legend, legend.theme().map);
  if (legend.colors() == render::ColorMode::Incremental) {
    legend.addCell(LegendText::tr("Free, of incremental submaps"), cell(render::kIncremental, 255));
    legend.addCell(LegendText::tr("Occupied, of incremental submaps"), cell(render::kIncremental, 0));
  }
  if (legend.colors() == render::ColorMode::Active) {
    legend.addCell(LegendText::tr("Free, of frozen submaps"), cell(0, 255));
    legend.addCell(LegendText::tr("Occupied, of frozen submaps"), cell(0, 0));
  }
}

}  // namespace

std::optional<map::SubmapId> submapOf(const ObjectId& id) {
  if (id.layer != Layer::Submaps) return std::nullopt;
  // "12-3"; a trajectory may be negative.
  const std::size_t dash = id.key.find('-', 1);
  if (dash == std::string::npos) return std::nullopt;
  const char* const end = id.key.data() + id.key.size();
  map::SubmapId submap;
  const auto first = std::from_chars(id.key.data(), id.key.data() + dash, submap.trajectory);
  const auto second = std::from_chars(id.key.data() + dash + 1, end, submap.index);
  const bool whole = first.ec == std::errc() && second.ec == std::errc() && second.ptr == end;
  return whole ? std::optional(submap) : std::nullopt;
}

std::optional<MapObject> submapObject(const LayerContext& context, const session::Session& session,
                                      const ObjectId& id) {
  const auto wanted = submapOf(id);
  const auto found = wanted ? context.outlines.find(*wanted) : context.outlines.end();
  if (found == context.outlines.end()) return std::nullopt;
  const auto& [submap, outline] = *found;
  const submap::SubmapRow* const row = session.submaps().find(submap);
  if (!row) return std::nullopt;
  MapObject object;
  object.id = id;
  object.form = ObjectForm::Area;
  object.kind = ObjectText::tr("Submap");
  object.name = QString::fromStdString(map::toText(submap));
  object.at_m = outline.center;
  object.parts = {{outline.corners.begin(), outline.corners.end()}};
  object.look = outline.frozen ? 1 : 0;
  object.topic = map::topicIndex<map::SubmapList>();
  if (const auto pose = geometry::toIsometry(row->entry.pose))
    object.yaw_rad = geometry::projectToPlane(*pose).yaw_rad;
  const auto add = [&](const QString& name, const QString& value) {
    if (!value.isEmpty()) object.properties.push_back({name, value});
  };
  const std::int32_t version = submap::versionOf(*row);
  const bool as_listed = row->shown_version < 0 || row->shown_version == version;
  add(ObjectText::tr("Version"),
      version == map::kNoVersion ? ObjectText::tr("unknown")
      : as_listed                ? QString::number(version)
                                 : ObjectText::tr("%1, on screen %2").arg(version).arg(row->shown_version));
  add(ObjectText::tr("State"), row->entry.is_frozen ? ObjectText::tr("frozen") : ObjectText::tr("active"));
  add(ObjectText::tr("Trajectory"), QString::number(submap.trajectory));
  if (row->slices.size() > 1) add(ObjectText::tr("Slices"), QString::number(row->slices.size()));
  add(ObjectText::tr("Problem"), sentences::sentenceOf(session.reason(submap)));
  return object;
}

template <>
LayerSpec layerSpec<Layer::Submaps>() {
  return {.name = "submaps",
          .title = QT_TRANSLATE_NOOP("scene", "Submaps"),
          .left_alone = LayerSet::Navigation | LayerSet::Mapping | LayerSet::MapOnly,
          .shows_submaps = true,
          .in_all = false,  // --mode decides about them
          .why_empty = noSubmapsReason,
          .items = oneItem<SubmapsLayer>,
          .legend = submapsLegend};
}

}  // namespace mapwright::ui::scene
