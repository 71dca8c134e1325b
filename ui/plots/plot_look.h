// The look of curves in a plot: colours, and shapes of their marks.
#pragma once

#include <QColor>
#include <QPainter>

namespace mapwright::window {

inline constexpr int kPlotLooks = 8;

/// Of curve `look` (any number; they repeat). At least 3:1 against the background of both themes, and
/// distinguishable for colour-blind people. After Okabe and Ito, "Color Universal Design" (2008).
QColor plotColor(int look, bool dark);

/// Its mark: a disc, a square, a triangle … around `at`.
void paintPlotMark(QPainter& painter, int look, const QColor& color, const QPointF& at, double radius_px);

}  // namespace mapwright::window
