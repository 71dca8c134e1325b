#include "ui/replay/timeline_events.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPen>
#include <QPolygonF>

#include "ui/kit/icons.h"

namespace mapwright::ui {

using replay::Event;
using replay::EventKind;

namespace {

class TimelineEventsText {
  Q_DECLARE_TR_FUNCTIONS(TimelineEvents)
};

// Manual steps end exactly at an event.
constexpr double kSameInstantS = 1e-6;

/// By kind.
struct KindLook {
  EventMark mark;
  const char* name;
};
constexpr KindLook kKinds[] = {
    {{EventShape::Triangle, Mark::Bad}, QT_TRANSLATE_NOOP("TimelineEvents", "Alert")},
    {{EventShape::Ring, Mark::Good}, QT_TRANSLATE_NOOP("TimelineEvents", "Alert ended")},
    {{EventShape::Tick, Mark::Neutral}, QT_TRANSLATE_NOOP("TimelineEvents", "Planner")},
    {{EventShape::Diamond, Mark::Warning}, QT_TRANSLATE_NOOP("TimelineEvents", "Position jump")},
    {{EventShape::Square, Mark::Busy}, QT_TRANSLATE_NOOP("TimelineEvents", "Map")},
    {{EventShape::Square, Mark::Busy}, QT_TRANSLATE_NOOP("TimelineEvents", "SLAM session")},
    {{EventShape::Diamond, Mark::Warning}, QT_TRANSLATE_NOOP("TimelineEvents", "Localization poor")},
    {{EventShape::Ring, Mark::Good}, QT_TRANSLATE_NOOP("TimelineEvents", "Localization good")},
    {{EventShape::Disc, Mark::Bad}, QT_TRANSLATE_NOOP("TimelineEvents", "Emergency stop")},
    {{EventShape::Ring, Mark::Good}, QT_TRANSLATE_NOOP("TimelineEvents", "Stop released")}};
/// By group.
constexpr const char* kGroups[] = {
    QT_TRANSLATE_NOOP("TimelineEvents", "Alerts"),
    QT_TRANSLATE_NOOP("TimelineEvents", "States of the planner"),
    QT_TRANSLATE_NOOP("TimelineEvents", "Localization: jumps, poor and good again"),
    QT_TRANSLATE_NOOP("TimelineEvents", "Maps and SLAM sessions"),
    QT_TRANSLATE_NOOP("TimelineEvents", "Emergency stops")};

}  // namespace

EventMark markOf(const Event& event) {
  if (event.kind == EventKind::MoveState && event.text == "failed") return {EventShape::Tick, Mark::Warning};
  return kKinds[std::size_t(event.kind)].mark;
}

QString kindName(EventKind kind) { return TimelineEventsText::tr(kKinds[std::size_t(kind)].name); }

QString groupName(replay::EventGroup group) { return TimelineEventsText::tr(kGroups[std::size_t(group)]); }

std::vector<EventCluster> clustersOf(std::span<const Event> events, const TimelineAxis& axis,
                                     const ClusterSizes& sizes) {
  constexpr double kBesidePx = 60;
  const double from_s = axis.timeOf(axis.left_px - kBesidePx);
  const double until_s = axis.timeOf(axis.left_px + axis.width_px + kBesidePx);
  const auto reach = [&](std::size_t count) {
    if (count == 1) return sizes.single_px;
    int digits = 1;
    for (std::size_t rest = count; rest >= 10; rest /= 10) ++digits;
    return sizes.pill_px + sizes.digit_px * digits;
  };
  struct Open {
    EventCluster cluster;
    double first_px = 0, last_px = 0;
  };
  std::vector<Open> open;
  const auto first = std::partition_point(events.begin(), events.end(),
                                          [&](const Event& event) { return event.at_s < from_s; });
  for (auto event = first; event != events.end() && event->at_s <= until_s; ++event) {
    const double px = axis.pixelOf(event->at_s);
    open.push_back({{std::size_t(event - events.begin()), 1, px, reach(1), markOf(*event)}, px, px});
    // A merged one may overlap the one before.
    while (open.size() > 1) {
      Open& before = open[open.size() - 2];
      const Open& last = open.back();
      if (last.cluster.px - last.cluster.half_px >= before.cluster.px + before.cluster.half_px + sizes.gap_px)
        break;
      EventCluster& both = before.cluster;
      both.count += last.cluster.count;
      before.last_px = last.last_px;
      both.px = (before.first_px + before.last_px) / 2;
      both.half_px = reach(both.count);
      if (last.cluster.mark.mark > both.mark.mark) both.mark = last.cluster.mark;
      open.pop_back();
    }
  }
  std::vector<EventCluster> clusters;
  clusters.reserve(open.size());
  for (const Open& one : open) clusters.push_back(one.cluster);
  return clusters;
}

const Event* nextEvent(std::span<const Event> events, double at_s, int direction) {
  if (direction > 0) {
    const auto found = std::partition_point(
        events.begin(), events.end(), [&](const Event& event) { return event.at_s <= at_s + kSameInstantS; });
    return found == events.end() ? nullptr : &*found;
  }
  const auto found = std::partition_point(
      events.begin(), events.end(), [&](const Event& event) { return event.at_s < at_s - kSameInstantS; });
  return found == events.begin() ? nullptr : &*std::prev(found);
}

std::vector<Stretch> poorStretches(std::span<const Event> events, double last_s) {
  std::vector<Stretch> stretches;
  bool poor = false;
  for (const Event& event : events) {
    if (event.kind == EventKind::QualityLow && !poor) {
      stretches.push_back({event.at_s, last_s});
      poor = true;
    } else if (event.kind == EventKind::QualityGood && poor) {
      stretches.back().until_s = event.at_s;
      poor = false;
    }
  }
  return stretches;
}

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
  const int edge = int(std::ceil(px * pixel_ratio));
  QImage picture(edge, edge, QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(pixel_ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  paintEventMark(painter, QPointF(px / 2.0, px / 2.0), mark, appColors());
  painter.end();
  return sharedPixmap(picture);
}

}  // namespace mapwright::ui
