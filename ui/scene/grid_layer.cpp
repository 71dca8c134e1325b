#include <cmath>

#include <QPainter>

#include "scene/map_layers.h"

namespace mapwright::scene {
namespace {

constexpr double kMinorSpacingPx = 16;
constexpr int kMaxLines = 400;

/// Vertical (axis 0) or horizontal (axis 1) world lines every `step` metres across what is visible.
void drawLines(QPainter& painter, const geometry::ViewTransform& view, double step, int axis) {
  const geometry::WorldRect world = view.visibleWorld();
  const double from = axis == 0 ? world.min_x : world.min_y, to = axis == 0 ? world.max_x : world.max_y;
  const double first = std::ceil(from / step);
  const double count = std::floor(to / step) - first + 1;
  if (!(count > 0) || count > kMaxLines) return;
  QList<QLineF> lines;
  for (int i = 0; i < int(count); ++i) {
    const double at = (first + i) * step;
    const Eigen::Vector2d a = axis == 0 ? Eigen::Vector2d(at, world.min_y) : Eigen::Vector2d(world.min_x, at);
    const Eigen::Vector2d b = axis == 0 ? Eigen::Vector2d(at, world.max_y) : Eigen::Vector2d(world.max_x, at);
    QLineF line(toPoint(view.pixelFromWorld(a)), toPoint(view.pixelFromWorld(b)));
    // Upright lines lie on whole pixels: crisp, and the same on every run.
    if (view.rotation_rad == 0) {
      if (axis == 0) line.setLine(std::floor(line.x1()) + 0.5, line.y1(), std::floor(line.x1()) + 0.5, line.y2());
      else line.setLine(line.x1(), std::floor(line.y1()) + 0.5, line.x2(), std::floor(line.y1()) + 0.5);
    }
    lines << line;
  }
  painter.drawLines(lines);
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
  // The smallest decade whose lines are not closer than kMinorSpacingPx.
  const double minor = std::pow(10.0, std::ceil(std::log10(kMinorSpacingPx * view.scale_m_per_px) - 1e-9));
  painter->setRenderHint(QPainter::Antialiasing, view.rotation_rad != 0);
  for (const int axis : {0, 1}) {
    painter->setPen(QPen(context_.theme.grid_minor, 1));
    drawLines(*painter, view, minor, axis);
    painter->setPen(QPen(context_.theme.grid_major, 1));
    drawLines(*painter, view, minor * 10, axis);
  }
  painter->setPen(QPen(context_.theme.axis, 1));
  const geometry::WorldRect world = view.visibleWorld();
  painter->drawLine(toPoint(view.pixelFromWorld({world.min_x, 0})), toPoint(view.pixelFromWorld({world.max_x, 0})));
  painter->drawLine(toPoint(view.pixelFromWorld({0, world.min_y})), toPoint(view.pixelFromWorld({0, world.max_y})));
}

}  // namespace mapwright::scene
