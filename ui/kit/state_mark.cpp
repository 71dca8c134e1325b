#include "ui/kit/state_mark.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPixmapCache>

namespace mapwright::ui {

namespace {

struct MarkColors {
  QColor UiColors::*shape, UiColors::*text;
};

MarkColors colorsOf(Mark mark) {
  switch (mark) {
    case Mark::Good:
      return {&UiColors::ok, &UiColors::ok_text};
    case Mark::Busy:
      return {&UiColors::focus, &UiColors::accent_text};
    case Mark::Warning:
      return {&UiColors::warning, &UiColors::warning_text};
    case Mark::Bad:
      return {&UiColors::error, &UiColors::error_text};
    case Mark::Neutral:
    case Mark::None:
      break;
  }
  return {&UiColors::neutral, &UiColors::secondary_text};
}

}  // namespace

QColor markColor(Mark mark, const UiColors& colors) { return colors.*colorsOf(mark).shape; }

QColor markTextColor(Mark mark, const UiColors& colors) { return colors.*colorsOf(mark).text; }

void paintMark(QPainter* painter, const QRectF& rect, Mark mark, const UiColors& colors) {
  if (mark == Mark::None) return;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QColor color = markColor(mark, colors);
  const QRectF r = rect.adjusted(1, 1, -1, -1);
  painter->setPen(QPen(color, 1.5));
  switch (mark) {
    case Mark::Good:
      painter->setBrush(color);
      painter->drawEllipse(r);
      break;
    case Mark::Busy:
      painter->setBrush(Qt::NoBrush);
      painter->drawEllipse(r);
      painter->setBrush(color);
      painter->drawChord(r, 90 * 16, 180 * 16);
      break;
    case Mark::Warning: {
      QPainterPath triangle;
      triangle.moveTo(r.center().x(), r.top());
      triangle.lineTo(r.right(), r.bottom());
      triangle.lineTo(r.left(), r.bottom());
      triangle.closeSubpath();
      painter->setBrush(color);
      painter->setPen(QPen(color, 1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter->drawPath(triangle);
      break;
    }
    case Mark::Bad:
      painter->setPen(QPen(color, 2.2, Qt::SolidLine, Qt::RoundCap));
      painter->drawLine(r.topLeft(), r.bottomRight());
      painter->drawLine(r.topRight(), r.bottomLeft());
      break;
    case Mark::Neutral:
    case Mark::None:
      painter->setBrush(Qt::NoBrush);
      painter->drawEllipse(r);
      break;
  }
  painter->restore();
}

QPixmap markPixmap(Mark mark) {
  constexpr int kEdgePx = 14;
  const double ratio = qApp->devicePixelRatio();
  // One for all cells: the style keeps something for each picture that it is given.
  const QString key =
      QStringLiteral("mark %1 %2 %3").arg(int(mark)).arg(ratio).arg(markColor(mark, appColors()).rgba());
  if (QPixmap kept; QPixmapCache::find(key, &kept)) return kept;
  QPixmap pixmap(QSize(kEdgePx, kEdgePx) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  paintMark(&painter, QRectF(2, 2, kEdgePx - 4, kEdgePx - 4), mark, appColors());
  painter.end();
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

}  // namespace mapwright::ui
