// Draws many thin lines quickly.
#pragma once

#include <functional>

#include <QImage>
#include <QPainter>

namespace mapwright::scene {

/// A transparent sheet of the viewport's size. Lines drawn directly onto a view go through the rasteriser one
/// by one (0.2 ms and a round of thread hand-overs each, measured with Qt 6.4); on a separate sheet a thin,
/// opaque, aliased line is a plain loop, and the sheet is blended over the map in one step.
class LineSheet {
 public:
  /// Calls `draw` with a painter in the coordinates of `painter`, then blends the sheet with `opacity`.
  void paint(QPainter& painter, const QSizeF& viewport, double opacity,
             const std::function<void(QPainter&)>& draw);

 private:
  QImage sheet_;
};

}  // namespace mapwright::scene
