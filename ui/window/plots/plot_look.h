// How the curves of a plot are told apart: by colour, and by the shape of the marks on them.
#pragma once

#include <QColor>
#include <QPainter>

namespace mapwright::window {

inline constexpr int kPlotLooks = 8;

/// Of curve `look` (any number; they repeat). At least 3:1 against the ground of either theme, and apart from
/// each other for those who see no red or no green. After Okabe and Ito, "Color Universal Design" (2008).
QColor plotColor(int look, bool dark);

/// Its mark: a disc, a square, a triangle … around `at`.
void paintPlotMark(QPainter& painter, int look, const QColor& color, const QPointF& at, double radius_px);

}  // namespace mapwright::window
