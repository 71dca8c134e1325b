#include <algorithm>
#include <cstdint>

#include "ui/scene/legend.h"
#include "ui/scene/walls_off.h"

namespace mapwright::ui::scene {
namespace {

std::size_t offStepOf(double off_m) {
  std::size_t step = 0;
  while (step + 1 < kOffSteps_m.size() && off_m > kOffSteps_m[step + 1]) ++step;
  return step;
}

class WallsOffLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (!context_.walls_off) return;
    // Zoomed out, many walls share a place on screen: the worst of them is drawn.
    constexpr int kPlacePx = 2;
    const geometry::ViewTransform& view = context_.view;
    const int columns = view.width_px / kPlacePx + 1, rows = view.height_px / kPlacePx + 1;
    std::vector<std::uint8_t> places(std::size_t(columns) * std::size_t(rows));
    for (const OffWall& wall : context_.walls_off->walls) {
      const Eigen::Vector2d at = view.pixelFromWorld(wall.at_m) / kPlacePx;
      if (!(at.x() >= 0 && at.y() >= 0 && at.x() < columns && at.y() < rows)) continue;
      std::uint8_t& place = places[std::size_t(at.y()) * std::size_t(columns) + std::size_t(at.x())];
      place = std::max(place, std::uint8_t(offStepOf(wall.off_m) + 1));
    }
    const double cell_px = context_.walls_off->cell_m / view.scale_m_per_px;
    std::array<std::vector<QRectF>, kOffSteps_m.size()> marks;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const int place = places[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
        if (place == 0) continue;
        const double edge = std::max(kOffMarks_px[std::size_t(place - 1)], cell_px);
        const QPointF middle = QPointF(column + 0.5, row + 0.5) * kPlacePx;
        marks[std::size_t(place - 1)].emplace_back(middle - QPointF(edge / 2, edge / 2), QSizeF(edge, edge));
      }
    }
    painter->setPen(Qt::NoPen);
    for (std::size_t step = 0; step < marks.size(); ++step) {
      painter->setBrush(offColor(step));
      painter->drawRects(marks[step].data(), int(marks[step].size()));
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (!context_.walls_off) return bounds;
    for (const OffWall& wall : context_.walls_off->walls) bounds.extend(wall.at_m);
    return bounds;
  }
};

void wallsOffLegend(Legend& legend) {
  const QString steps[] = {LegendText::tr("Walls off by more than 10 cm"),
                           LegendText::tr("Walls off by more than 30 cm"),
                           LegendText::tr("Walls off by more than 1 m")};
  for (std::size_t step = 0; step < kOffSteps_m.size(); ++step) {
    legend.addSample(steps[step], [step](LegendSample& sample) {
      auto off = std::make_shared<WallsOff>();
      for (double px = -sample.reachPx(); px <= sample.reachPx(); px += 2)
        off->walls.push_back({LegendSample::at(px, 0), kOffSteps_m[step] * 1.1});
      sample.context.walls_off = std::move(off);
    });
  }
}

}  // namespace

QColor offColor(std::size_t step) {
  // The ground is light in the dark theme, too.
  constexpr std::array<QRgb, 3> kColors{0xffe09a1f, 0xffd2431c, 0xff7a0f3c};
  return QColor(kColors[step]);
}

template <>
LayerSpec layerSpec<Layer::WallsOff>() {
  return {.name = "walls-off",
          .title = QT_TRANSLATE_NOOP("scene", "Walls that are off"),
          .shown = false,
          .left_alone = LayerSet::Navigation | LayerSet::Mapping | LayerSet::MapOnly,
          .follows_robot = false,
          .in_all = false,  // a reference map lies in the window alone
          .why_empty = neverEmpty,
          .items = oneItem<WallsOffLayer>,
          .legend = wallsOffLegend};
}

}  // namespace mapwright::ui::scene
