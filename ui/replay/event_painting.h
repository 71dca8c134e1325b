// The marks of events, for the timeline and the list.
#pragma once

#include <QPainter>
#include <QPixmap>

#include "ui/kit/ui_colors.h"
#include "ui/replay/timeline_events.h"

namespace mapwright::window {

/// Half of a mark, in pixels.
inline constexpr double kEventMarkPx = 4.5;

QColor eventMarkColor(Mark mark, const UiColors& colors);
/// Around `at`, in the colours of the present theme.
void paintEventMark(QPainter& painter, const QPointF& at, const EventMark& mark, const UiColors& colors);
/// A square of `px` with the mark in its centre; transparent around it.
QPixmap eventMarkPixmap(const EventMark& mark, int px, double pixel_ratio);

}  // namespace mapwright::window
