#include "ui/replay/timeline_view.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <QContextMenuEvent>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include "replay/event_sentence.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr double kTimelineMarginPx = 12;
constexpr double kNearPx = 6;           // of an event that is pointed at
constexpr double kLeastLoopPx = 3;      // shorter ones were meant as clicks
constexpr double kTimelineNotch = 120;  // QWheelEvent
constexpr double kZoomPerNotch = 0.8;
constexpr double kPanPerNotch = 0.1;  // of what is in view
constexpr int kMostWords = 8;
// These mean something else on the map; here they belong to the timeline.
constexpr int kOwnKeys[] = {Qt::Key_Space, Qt::Key_Comma, Qt::Key_Period, Qt::Key_Plus,   Qt::Key_Equal,
                            Qt::Key_Minus, Qt::Key_0,     Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,
                            Qt::Key_Down,  Qt::Key_Home,  Qt::Key_End,    Qt::Key_PageUp, Qt::Key_PageDown};
constexpr double kCountSize = 0.85;  // of the number of several, against other words
constexpr double kLabelGapPx = 18;

QColor with(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

}  // namespace

TimelineView::TimelineView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Timeline"));
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void TimelineView::setContent(TimelineContent content) {
  const bool all = !(until_s_ > from_s_) || content.first_s != content_.first_s;
  content_ = std::move(content);
  poor_ = poorStretches(content_.events, content_.last_s);
  if (all) from_s_ = until_s_ = 0;
  chooseEvents();
}

void TimelineView::setHiddenGroups(std::set<replay::EventGroup> hidden) {
  if (hidden == hidden_) return;
  hidden_ = std::move(hidden);
  chooseEvents();
}

void TimelineView::chooseEvents() {
  shown_.clear();
  for (const replay::Event& event : content_.events) {
    if (!hidden_.contains(replay::groupOf(event.kind))) shown_.push_back(event);
  }
  update();
}

void TimelineView::setAt(double at_s) {
  if (at_s == at_s_) return;
  at_s_ = at_s;
  if (until_s_ > from_s_ && drag_ == Drag::None)
    setAxis(axis().showing(at_s, content_.first_s, content_.last_s));
  describe();
  update();
}

void TimelineView::describe() {
  const QString text = clockText(at_s_, 0);
  if (accessibleDescription() != text) setAccessibleDescription(text);
}

void TimelineView::setLoop(std::optional<replay::Player::Loop> loop) {
  if (drag_ == Drag::Loop) return;
  loop_ = loop;
  update();
}

void TimelineView::setNotice(const QString& sentence) {
  if (sentence == notice_) return;
  notice_ = sentence;
  update();
}

TimelineAxis TimelineView::axis() const {
  TimelineAxis axis;
  axis.from_s = until_s_ > from_s_ ? from_s_ : content_.first_s;
  axis.until_s = until_s_ > from_s_ ? until_s_ : content_.last_s;
  if (!(axis.until_s > axis.from_s)) axis.until_s = axis.from_s + 1;
  axis.left_px = kTimelineMarginPx;
  axis.width_px = std::max(1.0, width() - 2 * kTimelineMarginPx);
  return axis;
}

void TimelineView::setAxis(const TimelineAxis& axis) {
  const bool all = axis.from_s <= content_.first_s && axis.until_s >= content_.last_s;
  from_s_ = all ? 0 : axis.from_s;
  until_s_ = all ? 0 : axis.until_s;
  update();
}

void TimelineView::showAll() {
  from_s_ = until_s_ = 0;
  update();
}

void TimelineView::zoomBy(double factor, double at_s) {
  if (!isEmpty()) setAxis(axis().zoomed(factor, at_s, content_.first_s, content_.last_s));
}

double TimelineView::timeAt(double px) const {
  return std::clamp(axis().timeOf(px), content_.first_s, content_.last_s);
}

QString TimelineView::wordsAt(const QPointF& px) const {
  if (isEmpty() || !notice_.isEmpty()) return notice_;
  const TimelineAxis axis = this->axis();
  QStringList lines;
  std::size_t more = 0;
  for (const EventCluster& cluster : clustersOf(shown_, axis, clusterSizes())) {
    if (std::abs(px.x() - cluster.px) > std::max(cluster.half_px, kNearPx)) continue;
    for (std::size_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
      if (lines.size() >= kMostWords) {
        ++more;
        continue;
      }
      lines << QStringLiteral("%1  %2").arg(clockText(shown_[i].at_s), replay::eventText(shown_[i]));
    }
  }
  if (more > 0) lines << tr("and %1 more").arg(more);
  if (lines.isEmpty()) lines << clockText(timeAt(px.x()));
  const double at_s = axis.timeOf(px.x()), near_s = kNearPx / 2 * axis.secondsPerPixel();
  for (const TimelineRange& range : content_.ranges) {
    const bool here = at_s >= range.from_s - near_s && at_s < range.until_s + near_s;
    if (range.state == RangeState::Failed && here)
      lines << tr("%1 to %2 could not be read: %3")
                   .arg(clockText(range.from_s, 0), clockText(range.until_s, 0), range.why);
  }
  for (const replay::Silence& silence : content_.silences) {
    if (at_s >= silence.from_s - near_s && at_s <= silence.until_s + near_s)
      lines << tr("Nothing was recorded from %1 to %2 (%3).")
                   .arg(clockText(silence.from_s, 1), clockText(silence.until_s, 1),
                        elapsedText(silence.until_s - silence.from_s));
  }
  return lines.join(QLatin1Char('\n'));
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
  if (isEmpty() || !notice_.isEmpty()) return;
  const double px = event->position().x();
  drag_px_ = px;
  if (event->button() == Qt::MiddleButton) {
    drag_ = Drag::Pan;
    setCursor(Qt::ClosedHandCursor);
  } else if (event->button() == Qt::LeftButton && event->modifiers() & Qt::ShiftModifier) {
    drag_ = Drag::Loop;
    drag_from_s_ = timeAt(px);
  } else if (event->button() == Qt::LeftButton) {
    drag_ = Drag::Seek;
    Q_EMIT seekWanted(timeAt(px));
  }
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
  const double px = event->position().x();
  hovered_px_ = px;
  switch (drag_) {
    case Drag::Seek:
      Q_EMIT seekWanted(timeAt(px));
      break;
    case Drag::Loop:
      loop_ = {std::min(drag_from_s_, timeAt(px)), std::max(drag_from_s_, timeAt(px))};
      break;
    case Drag::Pan:
      setAxis(axis().movedBy((drag_px_ - px) * axis().secondsPerPixel(), content_.first_s, content_.last_s));
      drag_px_ = px;
      break;
    case Drag::None:
      break;
  }
  update();
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event) {
  const Drag ended = std::exchange(drag_, Drag::None);
  unsetCursor();
  if (ended != Drag::Loop) return;
  const double px = event->position().x();
  if (std::abs(px - drag_px_) < kLeastLoopPx) {
    Q_EMIT loopWanted(std::nullopt);
  } else {
    Q_EMIT loopWanted(
        replay::Player::Loop{std::min(drag_from_s_, timeAt(px)), std::max(drag_from_s_, timeAt(px))});
  }
}

void TimelineView::leaveEvent(QEvent* event) {
  hovered_px_.reset();
  update();
  QWidget::leaveEvent(event);
}

void TimelineView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (isEmpty()) return;
  const QPoint turned = event->angleDelta();
  const bool sideways = turned.x() != 0 && std::abs(turned.x()) > std::abs(turned.y());
  const double notches = (sideways ? turned.x() : turned.y()) / kTimelineNotch;
  if (sideways || event->modifiers() & Qt::ShiftModifier) {
    const TimelineAxis now = axis();
    setAxis(
        now.movedBy(-notches * kPanPerNotch * (now.until_s - now.from_s), content_.first_s, content_.last_s));
  } else {
    zoomBy(std::pow(kZoomPerNotch, notches), timeAt(event->position().x()));
  }
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
  if (isEmpty()) return QWidget::keyPressEvent(event);
  const double step_s = event->modifiers() & Qt::ShiftModifier ? 0.01
                        : event->modifiers() & Qt::AltModifier ? 0.5
                                                               : 0.1;
  event->accept();
  switch (event->key()) {
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) Q_EMIT playWanted();
      return;
    case Qt::Key_Left:
      return Q_EMIT stepWanted(-step_s);
    case Qt::Key_Right:
      return Q_EMIT stepWanted(step_s);
    case Qt::Key_Comma:
      return Q_EMIT messageWanted(-1);
    case Qt::Key_Period:
      return Q_EMIT messageWanted(1);
    case Qt::Key_PageUp:
      return Q_EMIT eventWanted(-1);
    case Qt::Key_PageDown:
      return Q_EMIT eventWanted(1);
    case Qt::Key_Home:
      return Q_EMIT seekWanted(content_.first_s);
    case Qt::Key_End:
      return Q_EMIT seekWanted(content_.last_s);
    case Qt::Key_Up:
      return Q_EMIT speedWanted(1);
    case Qt::Key_Down:
      return Q_EMIT speedWanted(-1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoomBy(kZoomPerNotch, at_s_);
    case Qt::Key_Minus:
      return zoomBy(1 / kZoomPerNotch, at_s_);
    case Qt::Key_0:
      return showAll();
    case Qt::Key_Escape:
      // First ends the loop, then does what Esc means elsewhere.
      if (loop_) return Q_EMIT loopWanted(std::nullopt);
      break;
    default:
      break;
  }
  event->ignore();
}

void TimelineView::contextMenuEvent(QContextMenuEvent* event) {
  if (isEmpty()) return;
  const bool keyboard = event->reason() == QContextMenuEvent::Keyboard;
  const double at_s = keyboard ? at_s_ : timeAt(event->pos().x());
  const QPoint at(int(axis().pixelOf(at_s)), height() / 2);
  Q_EMIT menuWanted(keyboard ? mapToGlobal(at) : event->globalPos(), at_s);
}

bool TimelineView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* const help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), plainToolTip(wordsAt(help->pos())), this);
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* const key = static_cast<QKeyEvent*>(event);
    const bool own = std::find(std::begin(kOwnKeys), std::end(kOwnKeys), key->key()) != std::end(kOwnKeys);
    if (own && !(key->modifiers() & Qt::ControlModifier)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

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
      case RangeState::InProgress:
        painter.fillRect(part, QBrush(colors.accent, Qt::BDiagPattern));
        break;
      case RangeState::Read:
        painter.fillRect(part, with(colors.accent, 90));
        break;
      case RangeState::Held:
        painter.fillRect(part, with(colors.accent, 170));
        break;
      case RangeState::Failed:
        break;
    }
  }
  // A second that is missing in a bag of hours is seen, too.
  for (const TimelineRange& range : content_.ranges) {
    if (range.state != RangeState::Failed || range.until_s < axis.from_s || range.from_s > axis.until_s)
      continue;
    QRectF part = bar(range.from_s, range.until_s);
    part.setWidth(std::max(part.width(), 3.0));
    // A pattern is not seen on a narrow one.
    painter.fillRect(part, with(colors.error, part.width() > 8 ? 60 : 255));
    painter.fillRect(part, QBrush(colors.error, Qt::DiagCrossPattern));
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

}  // namespace mapwright::ui

#include "moc_timeline_view.cpp"
