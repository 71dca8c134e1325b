#include "ui/plots/plot_look.h"

#include <array>

#include <QPolygonF>

namespace mapwright::window {

namespace {

// Neighbours differ in lightness, too.
constexpr std::array<QRgb, kPlotLooks> kLight{0xff0060a8, 0xffc94f00, 0xff007a58, 0xff9c3f86,
                                              0xff8a6a00, 0xff1b1f24, 0xff2a86c8, 0xff8c2d04};
constexpr std::array<QRgb, kPlotLooks> kDark{0xff56b4e9, 0xfff08a3c, 0xff2fc79a, 0xffe39cc4,
                                             0xfff0e442, 0xffe4e8ee, 0xff6f95ff, 0xffc98f6b};

}  // namespace

QColor plotColor(int look, bool dark) {
  const auto at = std::size_t(((look % kPlotLooks) + kPlotLooks) % kPlotLooks);
  return QColor(dark ? kDark[at] : kLight[at]);
}

void paintPlotMark(QPainter& painter, int look, const QColor& color, const QPointF& at, double r) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(color);
  painter.setPen(Qt::NoPen);
  const auto polygon = [&](std::initializer_list<QPointF> corners) {
    QPolygonF shape;
    for (const QPointF& corner : corners) shape << at + corner * r;
    painter.drawPolygon(shape);
  };
  switch (((look % kPlotLooks) + kPlotLooks) % kPlotLooks) {
    case 0:
      painter.drawEllipse(at, r, r);
      break;
    case 1:
      painter.drawRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r));
      break;
    case 2:
      polygon({{0, -1.2}, {1.1, 0.9}, {-1.1, 0.9}});
      break;
    case 3:
      polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
      break;
    case 4:
      polygon({{0, 1.2}, {1.1, -0.9}, {-1.1, -0.9}});
      break;
    default: {
      // Hollow ones, and a cross.
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(color, 1.6));
      const int shape = look % kPlotLooks;
      if (shape == 5) {
        painter.drawEllipse(at, r, r);
      } else if (shape == 6) {
        painter.drawRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r));
      } else {
        painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
        painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
      }
    }
  }
  painter.restore();
}

}  // namespace mapwright::window
