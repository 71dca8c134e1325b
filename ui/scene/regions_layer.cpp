#include <algorithm>
#include <cmath>

#include <QHashFunctions>
#include <QPainterPath>

#include "robot/map_dispatch.h"
#include "robot/robot.h"
#include "sentences/absence_sentence.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

using regions::RegionState;

constexpr double kLeastLabelPx = 120;  // a narrower region has no room for text
constexpr int kHatchAlpha = 70, kQuietAlpha = 90, kExtentAlpha = 190;

QBrush hatching(const MapTheme& theme) {
  return QBrush(translucent(theme.text, kHatchAlpha), Qt::BDiagPattern);
}
QPen extentPen(const MapTheme& theme) { return QPen(translucent(theme.text, kExtentAlpha), 1); }

enum class Mark { Quiet, Busy, Failed, Old };
QPen regionPen(const MapTheme& theme, Mark mark) {
  switch (mark) {
    case Mark::Busy:
      return QPen(theme.accent, 1);
    case Mark::Failed:
      return QPen(theme.bad, 1, Qt::DashLine);
    case Mark::Old:
      return QPen(theme.warn, 1, Qt::DashLine);
    case Mark::Quiet:
      break;
  }
  return QPen(translucent(theme.text, kQuietAlpha), 1, Qt::DotLine);
}

bool isBusy(const regions::RegionView& region) {
  return region.state == RegionState::Fetching || region.refreshing;
}
bool hasFailed(const regions::RegionView& region) {
  return !isBusy(region) && region.trouble.kind != regions::RegionTrouble::Kind::None;
}

/// Marks the parts of a map by regions that have not been fetched: hatched wherever nothing is known, with a
/// line around the reported extent, and outlines for regions being fetched and failed ones. Cells are drawn
/// over it. Draws nothing without a map by regions.
class RegionGround : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  geometry::WorldRect contentBounds() const override {
    return context_.regions && context_.regions_of ? context_.regions_of->bounds() : geometry::WorldRect();
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override;

 private:
  QPolygonF onScreen(const geometry::WorldRect& rect) const;
  void paintHatch(QPainter& painter) const;
  void paintOutlines(QPainter& painter) const;
  void paintExtent(QPainter& painter) const;
};

QPolygonF RegionGround::onScreen(const geometry::WorldRect& rect) const {
  const geometry::ViewTransform& view = context_.view;
  return QPolygonF({toPoint(view.pixelFromWorld({rect.min_x, rect.min_y})),
                    toPoint(view.pixelFromWorld({rect.max_x, rect.min_y})),
                    toPoint(view.pixelFromWorld({rect.max_x, rect.max_y})),
                    toPoint(view.pixelFromWorld({rect.min_x, rect.max_y}))});
}

void RegionGround::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (!context_.regions) return;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing, false);  // no seam may be visible between neighbours
  paintHatch(*painter);
  paintOutlines(*painter);
  paintExtent(*painter);
  painter->restore();
}

void RegionGround::paintHatch(QPainter& painter) const {
  const geometry::ViewTransform& view = context_.view;
  QPainterPath unknown;  // everything without an answer: regions do not overlap
  unknown.setFillRule(Qt::OddEvenFill);
  unknown.addRect(0, 0, view.width_px, view.height_px);
  QPainterPath answered;
  answered.setFillRule(Qt::WindingFill);
  // Thousands of small ones become a few shapes: they come column by column, upwards.
  geometry::WorldRect column;
  const auto add = [&] {
    if (column.empty()) return;
    answered.addPolygon(onScreen(column));
    answered.closeSubpath();
  };
  regions::RegionKey last;
  for (const regions::RegionView& region : context_.regions->regions().answeredIn(view.visibleWorld())) {
    if (region.key.x != last.x || region.key.y != last.y + 1) {
      add();
      column = {};
    }
    column.extend(region.rect);
    last = region.key;
  }
  add();
  unknown.addPath(answered);
  QPainterPath screen;
  screen.addRect(0, 0, view.width_px, view.height_px);
  painter.setClipPath(screen, Qt::IntersectClip);
  painter.setBrushOrigin(hatchOrigin(view));
  painter.fillPath(unknown, hatching(context_.theme));
}

void RegionGround::paintExtent(QPainter& painter) const {
  if (!context_.regions_of) return;
  const geometry::ViewTransform& view = context_.view;
  const double right = context_.regions_of->width, bottom = context_.regions_of->height;
  QPolygonF shape;
  for (const Eigen::Vector2d& cell : {Eigen::Vector2d(0, 0), Eigen::Vector2d(right, 0),
                                      Eigen::Vector2d(right, bottom), Eigen::Vector2d(0, bottom)})
    shape << toPoint(view.pixelFromWorld(context_.regions_of->worldFromCell(cell)));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(extentPen(context_.theme));
  painter.drawPolygon(shape);
}

void RegionGround::paintOutlines(QPainter& painter) const {
  const MapTheme& theme = context_.theme;
  painter.setBrush(Qt::NoBrush);
  // Prominent ones are drawn over the others.
  for (const bool quiet : {true, false}) {
    for (const regions::RegionView& region : context_.regions->regions().inView()) {
      const bool busy = isBusy(region), failed = hasFailed(region);
      const bool open = region.state == RegionState::NotAsked || region.state == RegionState::Nothing;
      if (quiet == (busy || failed) || (quiet && !open)) continue;
      Mark mark = busy ? Mark::Busy : Mark::Quiet;
      if (failed) mark = region.state == RegionState::Failed ? Mark::Failed : Mark::Old;
      painter.setPen(regionPen(theme, mark));
      const QPolygonF shape = onScreen(region.rect);
      painter.drawPolygon(shape);
    }
  }
}

void regionsLegend(Legend& legend) {
  addCells(legend, legend.theme().map);
  const MapTheme& theme = legend.theme();
  const auto add = [&](const QString& text, const QPen& pen, const QBrush& brush = Qt::NoBrush) {
    legend.add(text, [&](QPainter& painter, const QRectF& room) {
      painter.fillRect(room, QColor(theme.map.unknown));
      painter.setRenderHint(QPainter::Antialiasing, false);
      painter.setPen(pen);
      painter.setBrush(brush);
      painter.drawRect(room.adjusted(5, 4, -6, -5));
    });
  };
  add(QCoreApplication::translate("scene", "Not fetched yet"), Qt::NoPen, hatching(theme));
  add(QCoreApplication::translate("scene", "Being fetched"), regionPen(theme, Mark::Busy));
  add(QCoreApplication::translate("scene", "Fetch failed"), regionPen(theme, Mark::Failed));
  add(QCoreApplication::translate("scene", "Old: could not be fetched again"), regionPen(theme, Mark::Old));
  add(QCoreApplication::translate("scene", "Fetched; the map is empty here"), regionPen(theme, Mark::Quiet));
  add(QCoreApplication::translate("scene", "Edge of the map"), extentPen(theme));
}

void RegionGround::collectLabels(LabelCollector& labels) const {
  if (!context_.regions) return;
  for (const regions::RegionView& region : context_.regions->regions().inView()) {
    const QRectF box = onScreen(region.rect).boundingRect();
    if (box.width() < kLeastLabelPx || region.state == RegionState::Held) continue;
    QString words;
    if (region.state == RegionState::Nothing) words = QCoreApplication::translate("scene", "empty");
    if (isBusy(region)) words = QCoreApplication::translate("scene", "being fetched…");
    if (hasFailed(region)) words = QCoreApplication::translate("scene", "fetch failed");
    labels.add(LabelWish::Position::Within, LabelRank::Id, box, qHashMulti(0, region.key.x, region.key.y),
               words, hasFailed(region) ? context_.theme.bad : context_.theme.text);
  }
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Regions>() {
  return {
      .name = "regions",
      .title = QT_TRANSLATE_NOOP("scene", "Map by regions"),
      .left_alone = LayerSet::Navigation | LayerSet::Mapping | LayerSet::MapOnly,
      .follows_robot = false,
      .in_all = false,  // --region says which
      .in_fit = true,
      .why_empty =
          [](robot::Robot& robot) {
            const robot::MapDispatch* const dispatch = robot.mapDispatch();
            if (!dispatch)
              return sentences::absenceReason(robot::Capability::Dispatch,
                                              robot.unavailableReason(robot::Capability::Dispatch));
            // If it has disappeared, received data stays.
            const auto offers = dispatch->offers();
            const bool gone =
                std::none_of(offers.begin(), offers.end(), [](const auto& offer) { return offer.offered; });
            return gone || dispatch->offered(robot::DispatchService::GridRegion)
                       ? QString()
                       : QCoreApplication::translate("scene", "This robot only sends its map as a whole.");
          },
      .items = oneItem<RegionGround>,
      .legend = regionsLegend};
}

}  // namespace mapwright::ui::scene
