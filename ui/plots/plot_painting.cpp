// Painting of a plot.
#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>
#include <QPolygonF>

#include "ui/kit/plot_ticks.h"
#include "ui/kit/ui_colors.h"
#include "ui/plots/plot_widget.h"

namespace mapwright::ui {

namespace {

// Neighbours differ in lightness, too.
constexpr std::array<QRgb, kPlotLooks> kLight{0xff0060a8, 0xffc94f00, 0xff007a58, 0xff9c3f86,
                                              0xff8a6a00, 0xff1b1f24, 0xff2a86c8, 0xff8c2d04};
constexpr std::array<QRgb, kPlotLooks> kDark{0xff56b4e9, 0xfff08a3c, 0xff2fc79a, 0xffe39cc4,
                                             0xfff0e442, 0xffe4e8ee, 0xff6f95ff, 0xffc98f6b};

constexpr int kMarkGap_px = 90, kMostLegendLines = 3;
constexpr double kMark_px = 3.2, kFullTurn = 360;

QColor faint(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

}  // namespace

QColor plotColor(int look, bool dark) {
  const auto at = std::size_t(((look % kPlotLooks) + kPlotLooks) % kPlotLooks);
  return QColor(dark ? kDark[at] : kLight[at]);
}

void paintPlotMark(QPainter& painter, int look, const QColor& color, const QPointF& at, double r) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(color);
  painter.setPen(Qt::NoPen);
  const auto polygon = [&](std::initializer_list<QPointF> corners) {
    QPolygonF shape;
    for (const QPointF& corner : corners) shape << at + corner * r;
    painter.drawPolygon(shape);
  };
  switch (((look % kPlotLooks) + kPlotLooks) % kPlotLooks) {
    case 0:
      painter.drawEllipse(at, r, r);
      break;
    case 1:
      painter.drawRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r));
      break;
    case 2:
      polygon({{0, -1.2}, {1.1, 0.9}, {-1.1, 0.9}});
      break;
    case 3:
      polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
      break;
    case 4:
      polygon({{0, 1.2}, {1.1, -0.9}, {-1.1, -0.9}});
      break;
    default: {
      // Hollow ones, and a cross.
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(color, 1.6));
      const int shape = look % kPlotLooks;
      if (shape == 5) {
        painter.drawEllipse(at, r, r);
      } else if (shape == 6) {
        painter.drawRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r));
      } else {
        painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
        painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
      }
    }
  }
  painter.restore();
}

PlotWidget::Legend PlotWidget::legend() const {
  Legend legend;
  const QFontMetrics metrics = fontMetrics();
  const int line = metrics.height() + 4, digits = metrics.horizontalAdvance(QStringLiteral("-0000.000 m/s"));
  int x = 8, y = 2;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const int wanted = 18 + metrics.horizontalAdvance(plotName(curves_[i].selection)) + 8 + digits;
    const int wide = std::min(wanted, std::max(width() - 16, 40));
    if (x > 8 && x + wide > width() - 8) {
      x = 8;
      y += line;
    }
    if (y / line >= kMostLegendLines) break;
    legend.items.push_back({QRect(x, y, wide, line), i});
    x += wide + 14;
  }
  legend.height = y + line;
  return legend;
}

QRect PlotWidget::area() const {
  const QFontMetrics metrics = fontMetrics();
  const int left = metrics.horizontalAdvance(QStringLiteral("-0000.00")) + 12;
  const int top = legend().height + 4, bottom = metrics.height() + 8;
  return QRect(left, top, std::max(width() - left - 8, 10), std::max(height() - top - bottom, 10));
}

void PlotWidget::paintAxes(QPainter& painter) const {
  const UiColors colors = appColors();
  const QRect area = this->area();
  const QFontMetrics metrics = fontMetrics();
  painter.fillRect(area, colors.base);
  const auto [least, greatest] = values();
  painter.setPen(faint(colors.border, 160));
  const auto value_ticks = valueTicks(least, greatest, std::max(area.height() / (metrics.height() * 2), 2));
  for (const PlotTick& tick : value_ticks)
    painter.drawLine(QPointF(area.left(), yOf(tick.at)), QPointF(area.right(), yOf(tick.at)));
  const int widest = metrics.horizontalAdvance(QStringLiteral("00:00:00.000")) + 24;
  const auto time_ticks = timeTicks(span_.first, span_.second, std::max(area.width() / widest, 1), since_s_);
  for (const PlotTick& tick : time_ticks)
    painter.drawLine(QPointF(xOf(tick.at), area.top()), QPointF(xOf(tick.at), area.bottom()));
  painter.setPen(colors.secondary_text);
  int above = height();
  for (const PlotTick& tick : value_ticks) {
    QRect box(0, int(yOf(tick.at)) - metrics.height() / 2, area.left() - 6, metrics.height());
    box.moveTop(std::clamp(box.top(), 0, area.bottom() - metrics.height() + metrics.height() / 2));
    if (box.bottom() > above) continue;  // they would overlap
    painter.drawText(box, Qt::AlignRight | Qt::AlignVCenter, tick.text);
    above = box.top();
  }
  // Other parts of the window use UTC: the time zone is shown next to the times.
  const QString zone = since_s_ ? tr("s") : zoneText(span_.first);
  painter.drawText(QRect(0, area.bottom() + 4, area.left() - 6, metrics.height()), Qt::AlignRight, zone);
  int right = area.left() - 2;
  for (const PlotTick& tick : time_ticks) {
    const int wide = metrics.horizontalAdvance(tick.text);
    const int x = std::clamp(int(xOf(tick.at)) - wide / 2, 0, std::max(width() - wide - 2, 0));
    if (x < right) continue;
    painter.drawText(QRect(x, area.bottom() + 4, wide + 2, metrics.height()), Qt::AlignLeft, tick.text);
    right = x + wide + 12;
  }
  painter.setPen(colors.border);
  painter.drawRect(area.adjusted(0, 0, -1, -1));
}

void PlotWidget::paintCurve(QPainter& painter, const PlotCurve& curve) const {
  const QColor color = plotColor(curve.look, appColors().dark);
  const auto* const quantity = std::get_if<series::Quantity>(&curve.selection);
  const bool stepped = quantity && series::isStepped(*quantity);
  const bool turns = quantity && *quantity == series::Quantity::Yaw;
  const QRect area = this->area();
  painter.setPen(QPen(color, 1.4));
  double last_mark_px = -1e9;
  std::vector<QPointF> marks;
  QPolygonF line;
  const auto flush = [&] {
    if (line.size() == 1) painter.drawEllipse(line[0], 1, 1);
    if (line.size() > 1) painter.drawPolyline(line);
    line.clear();
  };
  // Points far outside would only cost time.
  const auto clampedY = [&](double value) { return std::clamp(yOf(value), -1e5, 1e5); };
  const auto clampedX = [&](double at_s) { return std::clamp(xOf(at_s), -1e5, 1e5); };
  for (const series::Stroke& stroke : curve.series->strokes(span_.first, span_.second, area.width())) {
    flush();
    double before = stroke.front().value;
    for (const series::Sample& point : stroke) {
      const QPointF at(clampedX(point.at_s), clampedY(point.value));
      // A heading that passes half a turn does not jump.
      if (turns && std::abs(point.value - before) > kFullTurn / 2) flush();
      if (stepped && !line.isEmpty()) line << QPointF(at.x(), line.last().y());
      line << at;
      before = point.value;
      if (curves_.size() > 1 && at.x() >= last_mark_px + kMarkGap_px && at.x() >= area.left()) {
        marks.push_back(at);
        last_mark_px = at.x();
      }
    }
    // A value that holds until the next one is drawn to the end of the known range.
    if (stepped && !line.isEmpty()) {
      const double until_s = std::min(span_.second, bounds_.second);
      if (curve.series->isCovered(stroke.back().at_s, until_s) && stroke.back().at_s < until_s &&
          curve.series->at(until_s))
        line << QPointF(clampedX(until_s), line.last().y());
    }
  }
  flush();
  // At different positions: overlapping curves are both visible.
  for (const QPointF& mark : marks) paintPlotMark(painter, curve.look, color, mark, kMark_px);
}

void PlotWidget::paintStill(QPainter& painter) const {
  const UiColors colors = appColors();
  painter.fillRect(rect(), colors.window);
  paintAxes(painter);
  const QRect area = this->area();
  painter.save();
  painter.setClipRect(area);
  painter.setRenderHint(QPainter::Antialiasing);
  bool any = false;
  for (const PlotCurve& curve : curves_) {
    if (!curve.series || curve.series->empty()) continue;
    any = true;
    paintCurve(painter, curve);
  }
  painter.restore();
  if (!any && !hint_.isEmpty()) {
    painter.setPen(colors.secondary_text);
    painter.drawText(area.adjusted(12, 4, -12, -4), Qt::AlignCenter | Qt::TextWordWrap, hint_);
  }
}

void PlotWidget::paintMoving(QPainter& painter) const {
  const UiColors colors = appColors();
  const QRect area = this->area();
  const QFontMetrics metrics = fontMetrics();
  const auto line = [&](double at_s, const QPen& pen) {
    const double x = std::round(xOf(at_s));
    if (x < area.left() || x > area.right()) return;
    painter.setPen(pen);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  };
  if (cursor_s_) line(*cursor_s_, QPen(colors.focus, 2));
  if (pointed_s_) {
    line(*pointed_s_, QPen(colors.secondary_text, 1, Qt::DashLine));
    const QString text = timeText(*pointed_s_, since_s_);
    const int wide = metrics.horizontalAdvance(text) + 10, x = int(xOf(*pointed_s_));
    if (x >= area.left() && x <= area.right()) {
      const QRect box(std::clamp(x - wide / 2, area.left(), std::max(area.right() - wide, area.left())),
                      area.bottom() + 2, wide, metrics.height() + 4);
      painter.fillRect(box, colors.hover);
      painter.setPen(colors.text);
      painter.drawText(box, Qt::AlignCenter, text);
    }
  }
  const std::optional<double> at_s = pointed_s_ ? pointed_s_ : cursor_s_;
  for (const auto& [rect, index] : legend().items) {
    const PlotCurve& curve = curves_[index];
    const QColor color = plotColor(curve.look, colors.dark);
    const double y = rect.center().y() + 0.5;
    painter.setPen(QPen(color, 1.4));
    painter.drawLine(QPointF(rect.left(), y), QPointF(rect.left() + 12, y));
    paintPlotMark(painter, curve.look, color, QPointF(rect.left() + 6, y), kMark_px);
    const QString value = valueAtCursor(index);
    const int value_wide = metrics.horizontalAdvance(value);
    const QString name = metrics.elidedText(plotName(curve.selection), Qt::ElideMiddle,
                                            std::max(rect.width() - 18 - 8 - value_wide, 10));
    painter.setPen(colors.secondary_text);
    painter.drawText(rect.adjusted(18, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, name);
    painter.setPen(colors.text);
    painter.drawText(rect.adjusted(18 + metrics.horizontalAdvance(name) + 8, 0, 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, value);
    // The intersection with the curve.
    if (!at_s || !curve.series) continue;
    const auto sample = curve.series->at(*at_s);
    const QPointF met(xOf(*at_s), sample ? yOf(sample->value) : 0);
    if (sample && QRectF(area).contains(met)) {
      painter.setRenderHint(QPainter::Antialiasing);
      painter.setPen(QPen(colors.base, 1));
      painter.setBrush(color);
      painter.drawEllipse(met, 3.5, 3.5);
    }
  }
  if (hasFocus()) {
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(colors.focus);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void PlotWidget::paintEvent(QPaintEvent*) {
  const double ratio = devicePixelRatioF();
  if (stale_ || still_.size() != size() * ratio) {
    auto_.reset();
    still_ = QPixmap(size() * ratio);
    still_.setDevicePixelRatio(ratio);
    QPainter painter(&still_);
    painter.setFont(font());
    paintStill(painter);
    stale_ = false;
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, still_);
  paintMoving(painter);
}

}  // namespace mapwright::ui
