// The timeline: mouse and keyboard. Painting: timeline_painting.cpp.
#include "ui/replay/timeline_view.h"

#include <algorithm>
#include <cmath>

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/kit/plain_label.h"

namespace mapwright::window {

namespace {

constexpr double kTimelineMarginPx = 12;
constexpr double kNearPx = 6;           // of an event that is pointed at
constexpr double kLeastLoopPx = 3;      // shorter ones were meant as clicks
constexpr double kTimelineNotch = 120;  // QWheelEvent
constexpr double kZoomPerNotch = 0.8;
constexpr double kPanPerNotch = 0.1;  // of what is in view
constexpr int kMostWords = 8;

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
    take(axis().showing(at_s, content_.first_s, content_.last_s));
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

void TimelineView::take(const TimelineAxis& axis) {
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
  if (!isEmpty()) take(axis().zoomed(factor, at_s, content_.first_s, content_.last_s));
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
      lines << QStringLiteral("%1  %2").arg(clockText(shown_[i].at_s), eventText(shown_[i]));
    }
  }
  if (more > 0) lines << tr("and %1 more").arg(more);
  if (lines.isEmpty()) lines << clockText(timeAt(px.x()));
  const double at_s = axis.timeOf(px.x());
  for (const TimelineRange& range : content_.ranges) {
    if (range.state == RangeState::Failed && at_s >= range.from_s && at_s < range.until_s)
      lines << tr("%1 to %2 could not be read: %3")
                   .arg(clockText(range.from_s, 0), clockText(range.until_s, 0), range.why);
  }
  const double near_s = kNearPx / 2 * axis.secondsPerPixel();
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
      take(axis().movedBy((drag_px_ - px) * axis().secondsPerPixel(), content_.first_s, content_.last_s));
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
    take(
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
    // These keys mean something else on the map; here they belong to the timeline.
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Space:
      case Qt::Key_Comma:
      case Qt::Key_Period:
      case Qt::Key_Plus:
      case Qt::Key_Equal:
      case Qt::Key_Minus:
      case Qt::Key_0:
      case Qt::Key_Left:
      case Qt::Key_Right:
      case Qt::Key_Up:
      case Qt::Key_Down:
      case Qt::Key_Home:
      case Qt::Key_End:
      case Qt::Key_PageUp:
      case Qt::Key_PageDown:
        if (!(static_cast<QKeyEvent*>(event)->modifiers() & Qt::ControlModifier)) {
          event->accept();
          return true;
        }
        break;
      default:
        break;
    }
  }
  return QWidget::event(event);
}

}  // namespace mapwright::window

#include "moc_timeline_view.cpp"
