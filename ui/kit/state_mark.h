// The small shape in front of a state: a disc, a ring, a triangle, a cross; each has its colour.
#pragma once

#include <QColor>
#include <QPixmap>
#include <QRectF>

#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"

class QPainter;

namespace mapwright::ui {

QColor markColor(Mark mark, const UiColors& colors);
/// The same for text: readable on the background of windows and lists.
QColor markTextColor(Mark mark, const UiColors& colors);
/// Good: filled disc. Busy: half disc. Neutral: ring. Warning: triangle. Bad: cross in an octagon.
void paintMark(QPainter* painter, const QRectF& rect, Mark mark, const UiColors& colors);
/// For a cell of a table, in the present colours.
QPixmap markPixmap(Mark mark);

}  // namespace mapwright::ui
