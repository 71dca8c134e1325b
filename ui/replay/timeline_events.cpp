#include "ui/replay/timeline_events.h"

#include <algorithm>

#include <QCoreApplication>

#include "words/qt_plain.h"

namespace mapwright::window {

using replay::Event;
using replay::EventKind;

namespace {

class TimelineEventsText {
  Q_DECLARE_TR_FUNCTIONS(TimelineEvents)
};

constexpr qsizetype kTextLength = 120;
// Manual steps end exactly at an event.
constexpr double kSameInstantS = 1e-6;

QString said(const std::string& text) { return words::plainName(text).left(kTextLength); }

}  // namespace

EventMark markOf(const Event& event) {
  switch (event.kind) {
    case EventKind::AlertBegan:
      return {EventShape::Triangle, Mark::Bad};
    case EventKind::AlertEnded:
      return {EventShape::Ring, Mark::Good};
    case EventKind::MoveState:
      return {EventShape::Tick, event.text == "failed" ? Mark::Warning : Mark::Neutral};
    case EventKind::PositionJump:
      return {EventShape::Diamond, Mark::Warning};
    case EventKind::MapChanged:
    case EventKind::SessionChanged:
      return {EventShape::Square, Mark::Busy};
    case EventKind::QualityLow:
      return {EventShape::Diamond, Mark::Warning};
    case EventKind::QualityGood:
    case EventKind::EmergencyStopOff:
      return {EventShape::Ring, Mark::Good};
    case EventKind::EmergencyStopOn:
      return {EventShape::Disc, Mark::Bad};
  }
  return {};
}

QString eventText(const Event& event) {
  const QString text = said(event.text);
  switch (event.kind) {
    case EventKind::AlertBegan:
      return text.isEmpty() ? TimelineEventsText::tr("Alert %1").arg(event.code)
                            : TimelineEventsText::tr("Alert %1: %2").arg(QString::number(event.code), text);
    case EventKind::AlertEnded:
      return text.isEmpty()
                 ? TimelineEventsText::tr("Alert %1 ended").arg(event.code)
                 : TimelineEventsText::tr("Alert %1 ended: %2").arg(QString::number(event.code), text);
    case EventKind::MoveState:
      return text.isEmpty() ? TimelineEventsText::tr("Planner: idle")
                            : TimelineEventsText::tr("Planner: %1").arg(text);
    case EventKind::PositionJump:
      return TimelineEventsText::tr("The position jumped by %1 m").arg(event.metres, 0, 'f', 1);
    case EventKind::MapChanged:
      return TimelineEventsText::tr("Map changed: %1").arg(text);
    case EventKind::SessionChanged:
      return TimelineEventsText::tr("New SLAM session");
    case EventKind::QualityLow:
      return TimelineEventsText::tr("Localization is poor or lost");
    case EventKind::QualityGood:
      return TimelineEventsText::tr("Localization is good again");
    case EventKind::EmergencyStopOn:
      return TimelineEventsText::tr("Emergency stop pressed");
    case EventKind::EmergencyStopOff:
      return TimelineEventsText::tr("Emergency stop released");
  }
  return {};
}

QString kindName(EventKind kind) {
  switch (kind) {
    case EventKind::AlertBegan:
      return TimelineEventsText::tr("Alert");
    case EventKind::AlertEnded:
      return TimelineEventsText::tr("Alert ended");
    case EventKind::MoveState:
      return TimelineEventsText::tr("Planner");
    case EventKind::PositionJump:
      return TimelineEventsText::tr("Position jump");
    case EventKind::MapChanged:
      return TimelineEventsText::tr("Map");
    case EventKind::SessionChanged:
      return TimelineEventsText::tr("SLAM session");
    case EventKind::QualityLow:
      return TimelineEventsText::tr("Localization poor");
    case EventKind::QualityGood:
      return TimelineEventsText::tr("Localization good");
    case EventKind::EmergencyStopOn:
      return TimelineEventsText::tr("Emergency stop");
    case EventKind::EmergencyStopOff:
      return TimelineEventsText::tr("Stop released");
  }
  return {};
}

QString groupName(replay::EventGroup group) {
  switch (group) {
    case replay::EventGroup::Alerts:
      return TimelineEventsText::tr("Alerts");
    case replay::EventGroup::Planner:
      return TimelineEventsText::tr("States of the planner");
    case replay::EventGroup::Position:
      return TimelineEventsText::tr("Localization: jumps, poor and good again");
    case replay::EventGroup::Maps:
      return TimelineEventsText::tr("Maps and SLAM sessions");
    case replay::EventGroup::Stops:
      return TimelineEventsText::tr("Emergency stops");
  }
  return {};
}

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

}  // namespace mapwright::window
