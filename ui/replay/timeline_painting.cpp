// The timeline: painting.
#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>

#include "ui/kit/ui_colors.h"
#include "ui/replay/event_painting.h"
#include "ui/replay/timeline_view.h"

namespace mapwright::window {

namespace {

constexpr double kCountSize = 0.85;  // of the number of several, against other words
constexpr double kLabelGapPx = 18;

QColor with(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

}  // namespace

/// From top to bottom.
struct TimelineView::Rows {
  double labels_bottom, events_y, ranges_top, ranges_bottom, poor_bottom;
};

TimelineView::Rows TimelineView::rows() const {
  const double labels = QFontMetricsF(font()).height() + 6;
  const double rest = std::max(36.0, height() - labels);
  const double ranges_top = labels + rest * 0.5;
  return {labels, labels + rest * 0.25, ranges_top, ranges_top + std::clamp(rest * 0.22, 8.0, 18.0),
          ranges_top + std::clamp(rest * 0.22, 8.0, 18.0) + 6};
}

void TimelineView::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.fillRect(rect(), colors.base);
  if (!notice_.isEmpty() || isEmpty()) {
    painter.setPen(colors.secondary_text);
    painter.drawText(rect().adjusted(12, 4, -12, -4), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                     notice_);
  } else {
    painter.setRenderHint(QPainter::Antialiasing);
    const Rows rows = this->rows();
    paintTicks(painter, rows);
    paintLoop(painter, rows);
    paintRanges(painter, rows);
    paintEvents(painter, rows);
    paintCursor(painter, rows);
  }
  if (!hasFocus()) return;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(colors.focus);
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void TimelineView::paintTicks(QPainter& painter, const Rows& rows) const {
  const UiColors colors = appColors();
  const QFontMetricsF metrics(font());
  const TimelineAxis axis = this->axis();
  const double label_px = metrics.horizontalAdvance(QStringLiteral("00:00:00.000")) + kLabelGapPx;
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (const AxisTick& tick : axisTicks(axis, label_px)) {
    const double x = std::round(axis.pixelOf(tick.at_s));
    painter.setPen(with(colors.neutral, tick.label.isEmpty() ? 70 : 140));
    painter.drawLine(QPointF(x, rows.labels_bottom - (tick.label.isEmpty() ? 3 : 6)),
                     QPointF(x, rows.labels_bottom));
    if (tick.label.isEmpty()) continue;
    painter.setPen(with(colors.neutral, 40));
    painter.drawLine(QPointF(x, rows.labels_bottom), QPointF(x, height()));
    const double wide = metrics.horizontalAdvance(tick.label);
    // Those at the edges stay complete.
    const double left = std::clamp(x - wide / 2, 2.0, std::max(2.0, width() - wide - 2));
    painter.setPen(colors.secondary_text);
    painter.drawText(QPointF(left, metrics.ascent() + 1), tick.label);
  }
  painter.setRenderHint(QPainter::Antialiasing);
}

void TimelineView::paintRanges(QPainter& painter, const Rows& rows) const {
  const UiColors colors = appColors();
  const TimelineAxis axis = this->axis();
  const auto between = [&](double from_s, double until_s, double top, double bottom) {
    const double left = axis.pixelOf(std::max({from_s, content_.first_s, axis.from_s}));
    const double right = axis.pixelOf(std::min({until_s, content_.last_s, axis.until_s}));
    return QRectF(QPointF(left, top), QPointF(std::max(left, right), bottom));
  };
  const auto bar = [&](double from_s, double until_s) {
    return between(from_s, until_s, rows.ranges_top, rows.ranges_bottom);
  };
  painter.setPen(Qt::NoPen);
  painter.fillRect(bar(content_.first_s, content_.last_s), with(colors.neutral, 45));
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (const TimelineRange& range : content_.ranges) {
    const QRectF part = bar(range.from_s, range.until_s);
    if (part.width() <= 0) continue;
    switch (range.state) {
      case RangeState::Unread:
        break;
      case RangeState::UnderWay:
        painter.fillRect(part, QBrush(colors.accent, Qt::BDiagPattern));
        break;
      case RangeState::Read:
        painter.fillRect(part, with(colors.accent, 90));
        break;
      case RangeState::Held:
        painter.fillRect(part, with(colors.accent, 170));
        break;
      case RangeState::Failed:
        painter.fillRect(part, with(colors.error, 60));
        painter.fillRect(part, QBrush(colors.error, Qt::DiagCrossPattern));
        break;
    }
  }
  for (const replay::Silence& silence : content_.silences) {
    // The band has a hole there: it was read, and it is empty.
    QRectF part = bar(silence.from_s, silence.until_s);
    if (silence.until_s < axis.from_s || silence.from_s > axis.until_s) continue;
    part.setWidth(std::max(part.width(), 2.0));
    painter.fillRect(part, colors.base);
    painter.setPen(QPen(colors.secondary_text, 1, Qt::DotLine));
    painter.drawLine(QPointF(part.left() + 2, part.center().y()),
                     QPointF(part.right() - 2, part.center().y()));
    painter.setPen(Qt::NoPen);
  }
  for (const Stretch& stretch : poor_) {
    QRectF part = between(stretch.from_s, stretch.until_s, rows.ranges_bottom + 2, rows.poor_bottom);
    part.setWidth(std::max(part.width(), 2.0));
    if (stretch.until_s >= axis.from_s && stretch.from_s <= axis.until_s)
      painter.fillRect(part, colors.warning);
  }
  painter.setPen(with(colors.neutral, 120));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(bar(content_.first_s, content_.last_s));
  painter.setRenderHint(QPainter::Antialiasing);
}

void TimelineView::paintEvents(QPainter& painter, const Rows& rows) const {
  const UiColors colors = appColors();
  const TimelineAxis axis = this->axis();
  const std::vector<EventCluster> clusters = clustersOf(shown_, axis, clusterSizes());
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * kCountSize);
  painter.setFont(small);
  for (const EventCluster& cluster : clusters) {
    if (cluster.px < -cluster.half_px || cluster.px > width() + cluster.half_px) continue;
    const QPointF at(cluster.px, rows.events_y);
    if (cluster.count == 1) {
      paintEventMark(painter, at, cluster.mark, colors);
      continue;
    }
    const QColor color = eventMarkColor(cluster.mark.mark, colors);
    const double high = QFontMetricsF(small).height() / 2 + 1;
    const QRectF frame(at.x() - cluster.half_px, at.y() - high, 2 * cluster.half_px, 2 * high);
    painter.setPen(QPen(color, 1.5));
    painter.setBrush(colors.base);
    painter.drawRoundedRect(frame, high, high);
    painter.setBrush(with(color, 50));
    painter.drawRoundedRect(frame, high, high);
    painter.setPen(colors.text);
    painter.drawText(frame, Qt::AlignCenter, QString::number(cluster.count));
  }
  painter.setFont(font());
}

ClusterSizes TimelineView::clusterSizes() const {
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * kCountSize);
  ClusterSizes sizes;
  sizes.single_px = kEventMarkPx + 0.5;
  sizes.digit_px = QFontMetricsF(small).horizontalAdvance(QLatin1Char('0')) / 2;
  sizes.pill_px = 5;
  return sizes;
}

void TimelineView::paintLoop(QPainter& painter, const Rows& rows) const {
  if (!loop_) return;
  const UiColors colors = appColors();
  const TimelineAxis axis = this->axis();
  const double left = std::max(axis.pixelOf(loop_->from_s), 0.0);
  const double right = std::min(axis.pixelOf(loop_->until_s), double(width()));
  if (right < left) return;
  painter.fillRect(QRectF(QPointF(left, rows.labels_bottom), QPointF(right, height() - 1)),
                   with(colors.accent, 38));
  painter.setPen(QPen(colors.accent, 2));
  for (const double x : {left, right})
    painter.drawLine(QPointF(x, rows.labels_bottom), QPointF(x, height() - 1));
}

void TimelineView::paintCursor(QPainter& painter, const Rows& rows) const {
  const UiColors colors = appColors();
  const TimelineAxis axis = this->axis();
  if (hovered_px_ && drag_ != Drag::Pan) {
    painter.setPen(QPen(with(colors.neutral, 160), 1, Qt::DotLine));
    painter.drawLine(QPointF(*hovered_px_, rows.labels_bottom), QPointF(*hovered_px_, height()));
  }
  const double x = axis.pixelOf(at_s_);
  if (x < -8 || x > width() + 8) return;
  // In the text colour: all others have a meaning here.
  const QColor color = QGuiApplication::palette().color(QPalette::WindowText);
  painter.setPen(QPen(color, 2));
  painter.drawLine(QPointF(x, rows.labels_bottom - 2), QPointF(x, height() - 1));
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF{
      {x - 6, rows.labels_bottom - 8}, {x + 6, rows.labels_bottom - 8}, {x, rows.labels_bottom + 1}});
}

}  // namespace mapwright::window
