#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QImage>
#include <QPainter>

#include "scene/map_layers.h"

namespace mapwright::scene {
namespace {

constexpr double kMinorSpacingPx = 30;
constexpr int kMaxLines = 400;

/// Vertical (axis 0) or horizontal (axis 1) world lines every `step` metres across what is visible, in
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

/// Steps of 1, 2 or 5 times a power of ten, the minor one at least `least`; major lines fall on round
/// numbers.
std::pair<double, double> gridSteps(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  if (power >= least) return {power, power * 10};
  if (2 * power >= least) return {2 * power, 10 * power};
  if (5 * power >= least) return {5 * power, 50 * power};
  return {10 * power, 100 * power};
}

/// An upright grid line is a strip one pixel wide, copied onto whole pixels: crisp, and quicker than any
/// line.
void drawUpright(QPainter& painter, const QList<QLineF>& lines, const QColor& color, const QSizeF& viewport) {
  const qreal ratio = painter.device()->devicePixelRatioF();
  const QSize size = (viewport * ratio).toSize();
  QImage strip(1, std::max(size.width(), size.height()), QImage::Format_ARGB32_Premultiplied);
  strip.fill(color);
  const QImage lying = strip.transformed(QTransform().rotate(90));
  painter.save();
  painter.scale(1 / ratio, 1 / ratio);
  for (const QLineF& line : lines) {
    const bool standing = std::abs(line.dx()) < std::abs(line.dy());
    if (standing)
      painter.drawImage(QPoint(int(std::floor(line.x1() * ratio)), 0), strip);
    else
      painter.drawImage(QPoint(0, int(std::floor(line.y1() * ratio))), lying);
  }
  painter.restore();
}

}  // namespace

double roundDown125(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0}) {
    if (value >= factor * power) return factor * power;
  }
  return power;
}

void GridLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const geometry::ViewTransform& view = context_.view;
  const auto [minor, major] = gridSteps(kMinorSpacingPx * view.scale_m_per_px);
  QList<QLineF> minor_lines, major_lines, axes;
  for (const int axis : {0, 1}) {
    minor_lines += gridLines(view, minor, axis);
    major_lines += gridLines(view, major, axis);
  }
  const geometry::WorldRect world = view.visibleWorld();
  if (world.min_y <= 0 && world.max_y >= 0) {
    axes << QLineF(toPoint(view.pixelFromWorld({world.min_x, 0})),
                   toPoint(view.pixelFromWorld({world.max_x, 0})));
  }
  if (world.min_x <= 0 && world.max_x >= 0) {
    axes << QLineF(toPoint(view.pixelFromWorld({0, world.min_y})),
                   toPoint(view.pixelFromWorld({0, world.max_y})));
  }
  const std::array<std::pair<const QList<QLineF>*, QColor>, 3> sets{
      {{&minor_lines, context_.theme.grid_minor},
       {&major_lines, context_.theme.grid_major},
       {&axes, context_.theme.axis}}};
  const QSizeF viewport(view.width_px, view.height_px);
  if (view.rotation_rad == 0) {
    for (const auto& [lines, color] : sets) drawUpright(*painter, *lines, color, viewport);
    return;
  }
  for (const auto& [lines, color] : sets) {
    if (lines->isEmpty()) continue;
    QColor opaque = color;
    opaque.setAlpha(255);
    sheet_.paint(*painter, viewport, color.alphaF(), [&, shown = lines](QPainter& on_sheet) {
      on_sheet.setPen(QPen(opaque, 0));
      on_sheet.drawLines(*shown);
    });
  }
}

}  // namespace mapwright::scene
