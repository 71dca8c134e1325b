// The small shape in front of a state: a disc, a ring, a triangle, a cross; each has its colour.
#pragma once

#include <QColor>
#include <QRectF>

#include "window/look/ui_colors.h"
#include "window/status/status_text.h"

class QPainter;

namespace mapwright::window {

QColor markColor(Mark mark, const UiColors& colors);
/// The same for text: readable on the background of windows and lists.
QColor markTextColor(Mark mark, const UiColors& colors);
/// Good: filled disc. Busy: half disc. Neutral: ring. Warning: triangle. Bad: cross in an octagon.
void paintMark(QPainter* painter, const QRectF& rect, Mark mark, const UiColors& colors);

}  // namespace mapwright::window
