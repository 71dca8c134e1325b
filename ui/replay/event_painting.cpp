#include "ui/replay/event_painting.h"

#include <cmath>

#include <QPen>
#include <QPolygonF>

namespace mapwright::window {

QColor eventMarkColor(Mark mark, const UiColors& colors) {
  switch (mark) {
    case Mark::Good:
      return colors.ok;
    case Mark::Warning:
      return colors.warning;
    case Mark::Bad:
      return colors.error;
    case Mark::Busy:
      return colors.accent;
    default:
      return colors.neutral;
  }
}

void paintEventMark(QPainter& painter, const QPointF& at, const EventMark& mark, const UiColors& colors) {
  const QColor color = eventMarkColor(mark.mark, colors);
  const bool hollow = mark.shape == EventShape::Ring;
  painter.setPen(QPen(hollow ? color : colors.base, hollow ? 1.5 : 1));
  painter.setBrush(hollow ? QBrush(colors.base) : QBrush(color));
  const double r = kEventMarkPx;
  switch (mark.shape) {
    case EventShape::Triangle:
      painter.drawPolygon(
          QPolygonF{{at.x(), at.y() - r}, {at.x() + r, at.y() + r}, {at.x() - r, at.y() + r}});
      break;
    case EventShape::Diamond:
      painter.drawPolygon(
          QPolygonF{{at.x(), at.y() - r}, {at.x() + r, at.y()}, {at.x(), at.y() + r}, {at.x() - r, at.y()}});
      break;
    case EventShape::Square:
      painter.drawRect(QRectF(at.x() - r + 1, at.y() - r + 1, 2 * r - 2, 2 * r - 2));
      break;
    case EventShape::Tick:
      painter.setPen(QPen(color, 1.5));
      painter.drawLine(QPointF(at.x(), at.y() - r + 1), QPointF(at.x(), at.y() + r - 1));
      break;
    case EventShape::Ring:
      painter.drawEllipse(at, r - 1.5, r - 1.5);
      break;
    case EventShape::Disc:
      painter.drawEllipse(at, r, r);
      break;
  }
}

QPixmap eventMarkPixmap(const EventMark& mark, int px, double pixel_ratio) {
  QPixmap pixmap(int(std::ceil(px * pixel_ratio)), int(std::ceil(px * pixel_ratio)));
  pixmap.setDevicePixelRatio(pixel_ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintEventMark(painter, QPointF(px / 2.0, px / 2.0), mark, appColors());
  return pixmap;
}

}  // namespace mapwright::window
