// Marks and texts for the events of a bag, for the timeline and the list. Pure.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <QPixmap>
#include <QString>

#include "replay/events.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/replay/timeline_axis.h"

class QPainter;

namespace mapwright::ui {

enum class EventShape { Triangle, Ring, Tick, Diamond, Square, Disc };

/// Its mark: shape and colour.
struct EventMark {
  EventShape shape = EventShape::Tick;
  Mark mark = Mark::Neutral;
};
EventMark markOf(const replay::Event& event);
/// "Alert ended".
QString kindName(replay::EventKind kind);

/// The name of a group: "Alerts".
QString groupName(replay::EventGroup group);

/// Events that would overlap become one mark with their number.
struct EventCluster {
  std::size_t first = 0, count = 0;  // among the events, in order of time
  double px = 0, half_px = 0;        // centre and half width
  EventMark mark;                    // of the gravest
};
struct ClusterSizes {
  double single_px = 5;  // half of a mark
  double pill_px = 8;    // half of a number's frame without its digits
  double digit_px = 4;   // half of a digit
  double gap_px = 1;
};
/// For those within the axis and slightly beyond; side by side.
std::vector<EventCluster> clustersOf(std::span<const replay::Event> events, const TimelineAxis& axis,
                                     const ClusterSizes& sizes = {});

/// The first event after `at_s`, or the last before it (-1); nullptr: there is none.
const replay::Event* nextEvent(std::span<const replay::Event> events, double at_s, int direction);

struct Stretch {
  double from_s = 0, until_s = 0;
  bool operator==(const Stretch&) const = default;
};
/// Where localization was lost or poor; an open end extends to `last_s`.
std::vector<Stretch> poorStretches(std::span<const replay::Event> events, double last_s);

/// Half of a mark, in pixels.
inline constexpr double kEventMarkPx = 4.5;

QColor eventMarkColor(Mark mark, const UiColors& colors);
/// Around `at`, in the colours of the present theme.
void paintEventMark(QPainter& painter, const QPointF& at, const EventMark& mark, const UiColors& colors);
/// A square of `px` with the mark in its centre; transparent around it.
QPixmap eventMarkPixmap(const EventMark& mark, int px, double pixel_ratio);

}  // namespace mapwright::ui
