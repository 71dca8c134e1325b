// Waypoints: saved and unsaved ones, selected ones, ten thousand of them.
#include <array>
#include <cmath>
#include <unordered_set>

#include <QPainter>

#include "scene/live_layers.h"
#include "words/qt_plain.h"

namespace mapwright::scene {
namespace {

constexpr double kNameFromMPerPx = 0.12;  // names appear when a pixel is no larger than this
constexpr int kLongestName = 40;
constexpr double kRadiusPx = 5;
constexpr std::size_t kCrowd = 500;  // of so many, those that would hide each other are drawn once
constexpr double kCrowdPx = 4;

QString shortName(const std::string& name) {
  const QString text = words::plainName(name);
  return text.size() > kLongestName ? text.left(kLongestName - 1) + QChar(0x2026) : text;
}

QColor colorOf(const MapTheme& theme, WaypointMark mark) {
  switch (mark) {
    case WaypointMark::Saved:
      return theme.place;
    case WaypointMark::Conflict:
      return theme.bad;
    default:
      return theme.warn;
  }
}

/// A saved one as a finished picture: thousands of them are drawn in a moment. Its middle is the middle.
QImage dot(const MapTheme& theme, qreal ratio) {
  constexpr double kSide = 2 * (kRadiusPx + 2);
  QImage image(QSize(int(std::ceil(kSide * ratio)), int(std::ceil(kSide * ratio))),
               QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  paintWaypointMark(painter, QPointF(kSide / 2, kSide / 2), kRadiusPx, WaypointMark::Saved, theme.place,
                    theme.text_halo);
  return image;
}

}  // namespace

void paintWaypointMark(QPainter& painter, const QPointF& at, double radius, WaypointMark mark,
                       const QColor& fill, const QColor& edge) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(edge, 1.5));
  painter.setBrush(fill);
  const QRectF square(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
  switch (mark) {
    case WaypointMark::Saved:
      painter.drawEllipse(at, radius, radius);
      return;
    case WaypointMark::Unsaved:
      painter.drawRect(square);
      return;
    case WaypointMark::Sent:
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(fill, 2));
      painter.drawRect(square);
      return;
    case WaypointMark::Conflict:
      const double r = radius * 1.4;
      painter.drawPolygon(
          QPolygonF{at + QPointF(0, -r), at + QPointF(r, r * 0.8), at + QPointF(-r, r * 0.8)});
      return;
  }
}

WaypointsLayer::WaypointsLayer(const LayerContext& context, const std::vector<DrawnWaypoint>& points)
    : LayerItem(context), points_(points) {}

void WaypointsLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const geometry::ViewTransform& view = context_.view;
  const MapTheme& theme = context_.theme;
  const QRectF seen = QRectF(0, 0, view.width_px, view.height_px).adjusted(-220, -20, 20, 20);
  const bool crowd = points_.size() > kCrowd && view.scale_m_per_px > kNameFromMPerPx;
  const QImage sprite = crowd ? dot(theme, painter->device()->devicePixelRatioF()) : QImage();
  const double half = crowd ? sprite.width() / sprite.devicePixelRatio() / 2 : 0;
  std::unordered_set<std::uint64_t> taken;
  painter->setRenderHint(QPainter::Antialiasing);
  // What stands out lies on top of the others.
  for (const bool special : {false, true}) {
    for (const DrawnWaypoint& point : points_) {
      if ((point.selected || point.mark != WaypointMark::Saved) != special) continue;
      const QPointF at = toPoint(view.pixelFromWorld(point.position_m));
      if (!seen.contains(at)) continue;
      if (!special && crowd) {
        const auto cell = [](double px) { return std::uint64_t(std::uint32_t(std::int32_t(px / kCrowdPx))); };
        if (!taken.insert(cell(at.x()) << 32 | cell(at.y())).second) continue;
        painter->drawImage(QPointF(std::round(at.x() - half), std::round(at.y() - half)), sprite);
        continue;
      }
      const QColor color = colorOf(theme, point.mark);
      if (point.selected) {
        painter->setBrush(Qt::NoBrush);
        for (const auto& [ring, width] : {std::pair(theme.text_halo, 4.0), std::pair(theme.accent, 2.0)}) {
          painter->setPen(QPen(ring, width));
          painter->drawEllipse(at, 10, 10);
        }
      }
      if (point.yaw_rad && std::isfinite(*point.yaw_rad))
        drawHeading(*painter, context_, at, *point.yaw_rad, color);
      paintWaypointMark(*painter, at, kRadiusPx, point.mark, color, theme.text_halo);
      if (view.scale_m_per_px <= kNameFromMPerPx) {
        const double reach = point.selected ? 11 : kRadiusPx;
        drawName(*painter, context_, QRectF(at - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach)),
                 shortName(point.name), theme.text);
      }
    }
  }
}

}  // namespace mapwright::scene
