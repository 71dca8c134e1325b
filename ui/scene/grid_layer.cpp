#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/scene/legend.h"
#include "ui/scene/lengths.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kMinorSpacingPx = 30;
constexpr int kMaxLines = 400;

/// Vertical (axis 0) or horizontal (axis 1) world lines every `step` metres across the visible area, in
/// pixels.
QList<QLineF> gridLines(const geometry::ViewTransform& view, double step, int axis) {
  const geometry::WorldRect world = view.visibleWorld();
  const double from = axis == 0 ? world.min_x : world.min_y, to = axis == 0 ? world.max_x : world.max_y;
  const double first = std::ceil(from / step);
  const double count = std::floor(to / step) - first + 1;
  QList<QLineF> lines;
  if (!(count > 0) || count > kMaxLines) return lines;
  for (int i = 0; i < int(count); ++i) {
    const double at = (first + i) * step;
    const Eigen::Vector2d a = axis == 0 ? Eigen::Vector2d(at, world.min_y) : Eigen::Vector2d(world.min_x, at);
    const Eigen::Vector2d b = axis == 0 ? Eigen::Vector2d(at, world.max_y) : Eigen::Vector2d(world.max_x, at);
    lines << QLineF(toPoint(view.pixelFromWorld(a)), toPoint(view.pixelFromWorld(b)));
  }
  return lines;
}

struct LineSet {
  QList<QLineF> lines;
  QColor color;
};

/// Upright lines on whole pixels: crisp, and quicker than any line. The standing ones are painted into a few
/// rows of transparent ground that are laid down the viewport one after the other: a strip for each line
/// would touch a new cache line at every pixel.
void drawUpright(QPainter& painter, const std::array<LineSet, 3>& sets, const QRectF& exposed) {
  constexpr int kRows = 32;
  const qreal ratio = painter.device()->devicePixelRatioF();
  const QRect seen = QRectF(exposed.topLeft() * ratio, exposed.size() * ratio).toAlignedRect();
  QImage rows(seen.width(), kRows, QImage::Format_ARGB32_Premultiplied);
  if (rows.isNull()) return;
  rows.fill(Qt::transparent);
  QPainter on_rows(&rows);
  painter.save();
  painter.scale(1 / ratio, 1 / ratio);
  for (const LineSet& set : sets) {
    for (const QLineF& line : set.lines) {
      if (std::abs(line.dx()) < std::abs(line.dy())) {
        on_rows.fillRect(int(std::floor(line.x1() * ratio)) - seen.x(), 0, 1, kRows, set.color);
      } else if (const int y = int(std::floor(line.y1() * ratio)); y >= seen.top() && y <= seen.bottom()) {
        painter.fillRect(seen.x(), y, seen.width(), 1, set.color);
      }
    }
  }
  on_rows.end();
  for (int y = seen.top(); y <= seen.bottom(); y += kRows) {
    painter.drawImage(seen.x(), y, rows, 0, 0, seen.width(), std::min(kRows, seen.bottom() + 1 - y));
  }
  painter.restore();
}

/// The adaptive metric grid: minor and major lines, the world's axes.
class GridLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    const geometry::ViewTransform& view = context_.view;
    const auto [minor, major] = gridSteps(view);
    std::array<LineSet, 3> sets{LineSet{{}, context_.theme.grid_minor},
                                LineSet{{}, context_.theme.grid_major}, LineSet{{}, context_.theme.axis}};
    for (const int axis : {0, 1}) {
      sets[0].lines += gridLines(view, minor, axis);
      sets[1].lines += gridLines(view, major, axis);
    }
    const geometry::WorldRect world = view.visibleWorld();
    if (world.min_y <= 0 && world.max_y >= 0) {
      sets[2].lines << QLineF(toPoint(view.pixelFromWorld({world.min_x, 0})),
                              toPoint(view.pixelFromWorld({world.max_x, 0})));
    }
    if (world.min_x <= 0 && world.max_x >= 0) {
      sets[2].lines << QLineF(toPoint(view.pixelFromWorld({0, world.min_y})),
                              toPoint(view.pixelFromWorld({0, world.max_y})));
    }
    const QSizeF viewport(view.width_px, view.height_px);
    if (view.rotation_rad == 0) {
      drawUpright(*painter, sets, option->exposedRect & QRectF(QPointF(), viewport));
      return;
    }
    for (const LineSet& set : sets) {
      if (set.lines.isEmpty()) continue;
      sheet_.paint(*painter, viewport, set.color.alphaF(), [&](QPainter& on_sheet) {
        on_sheet.setPen(QPen(translucent(set.color, 255), 0));
        on_sheet.drawLines(set.lines);
      });
    }
  }

 private:
  LineSheet sheet_;
};

void gridLegend(Legend& legend) {
  const auto add = [&](const QString& text, const QColor& color) {
    legend.add(text, [&](QPainter& painter, const QRectF& room) {
      painter.fillRect(QRectF(0, room.center().y(), room.width(), 1), color);
      painter.fillRect(QRectF(room.center().x(), 0, 1, room.height()), color);
    });
  };
  add(LegendText::tr("Grid line"), legend.theme().grid_minor);
  add(LegendText::tr("Line of the coarse grid"), legend.theme().grid_major);
  add(LegendText::tr("Axes: x = 0 and y = 0"), legend.theme().axis);
}

}  // namespace

GridSteps gridSteps(const geometry::ViewTransform& view) {
  const double least = kMinorSpacingPx * view.scale_m_per_px;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  if (power >= least) return {power, power * 10};
  if (2 * power >= least) return {2 * power, 10 * power};
  if (5 * power >= least) return {5 * power, 50 * power};
  return {10 * power, 100 * power};
}

double roundDown125(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0}) {
    if (value >= factor * power) return factor * power;
  }
  return power;
}

template <>
LayerSpec layerSpec<Layer::Grid>() {
  return {.name = "grid",
          .title = QT_TRANSLATE_NOOP("scene", "Grid"),
          .group = LayerGroup::Annotations,
          .sets = LayerSet::Navigation | LayerSet::Mapping | LayerSet::Report | LayerSet::Snapshot,
          .follows_robot = false,
          .why_empty = neverEmpty,
          .items = oneItem<GridLayer>,
          .legend = gridLegend};
}

}  // namespace mapwright::ui::scene
