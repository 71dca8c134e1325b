#include "scene/ground_drawings.h"

#include <algorithm>
#include <cmath>

#include "words/qt_plain.h"

namespace mapwright::scene {
namespace {

using Kind = map::GroundDrawing::Kind;

constexpr double kThinnestPx = 1.5, kWidestPx = 400;
constexpr double kLeastPointPx = 2;
constexpr qsizetype kLongestText = 80;

double pixelsOf(const LayerContext& context, double metres, double least) {
  return std::clamp(metres / context.view.scale_m_per_px, least, kWidestPx);
}

bool inView(const LayerContext& context, const QRectF& rect) {
  return rect.intersects(QRectF(0, 0, context.view.width_px, context.view.height_px));
}

class Brush {
 public:
  Brush(QPainter& painter, const LayerContext& context, const map::GroundDrawing& drawing,
        const QColor& color)
      : painter_(painter),
        context_(context),
        drawing_(drawing),
        own_(drawing.rgba ? colorFrom(*drawing.rgba) : color),
        coloured_(drawing.colors.size() == drawing.points.size()) {}

  void draw() {
    switch (drawing_.kind) {
      case Kind::Line:
        coloured_ ? drawPairs(1) : drawLine();
        break;
      case Kind::Segments:
        drawPairs(2);
        break;
      case Kind::Triangles:
        drawTriangles();
        break;
      case Kind::Points:
        drawPoints();
        break;
      case Kind::Text:
        drawText();
        break;
    }
  }

 private:
  QPointF at(std::size_t i) const { return toPoint(context_.view.pixelFromWorld(drawing_.points[i])); }
  QColor colorOf(std::size_t i) const { return coloured_ ? colorFrom(drawing_.colors[i]) : own_; }
  QPen pen(const QColor& color) const {
    const double width = pixelsOf(context_, drawing_.size_m, kThinnestPx);
    return QPen(color, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  }

  void drawLine() {
    const QPen own = pen(own_);
    painter_.setPen(own);
    painter_.setBrush(Qt::NoBrush);
    for (const QPolygonF& line : visibleLines(context_.view, drawing_.points, own.widthF() + 2))
      painter_.drawPolyline(line);
  }

  /// From each `step`-th point to the next.
  void drawPairs(std::size_t step) {
    for (std::size_t i = 0; i + 1 < drawing_.points.size(); i += step) {
      const QPen own = pen(colorOf(i));
      const QLineF line(at(i), at(i + 1));
      const double margin = own.widthF() + 1;
      if (!inView(context_,
                  QRectF(line.p1(), line.p2()).normalized().adjusted(-margin, -margin, margin, margin)))
        continue;
      painter_.setPen(own);
      painter_.drawLine(line);
    }
  }

  void drawTriangles() {
    painter_.setPen(Qt::NoPen);
    for (std::size_t i = 0; i + 2 < drawing_.points.size(); i += 3) {
      const QPolygonF triangle{at(i), at(i + 1), at(i + 2)};
      if (!inView(context_, triangle.boundingRect().adjusted(-1, -1, 1, 1))) continue;
      painter_.setBrush(colorOf(i));
      painter_.drawPolygon(triangle);
    }
  }

  void drawPoints() {
    const double edge = pixelsOf(context_, drawing_.size_m, kLeastPointPx);
    for (std::size_t i = 0; i < drawing_.points.size(); ++i) {
      const QRectF square(at(i) - QPointF(edge / 2, edge / 2), QSizeF(edge, edge));
      if (inView(context_, square)) painter_.fillRect(square, colorOf(i));
    }
  }

  void drawText() {
    if (drawing_.points.empty()) return;
    QString text = words::plainName(drawing_.text);
    if (text.size() > kLongestText) text = text.left(kLongestText - 1) + QChar(0x2026);
    const QRectF mark(at(0) - QPointF(1, 1), QSizeF(2, 2));
    // Readable like any other label, and dropped if there is no room.
    if (inView(context_, mark)) drawName(painter_, context_, mark, text, readable(own_, context_.theme));
  }

  QPainter& painter_;
  const LayerContext& context_;
  const map::GroundDrawing& drawing_;
  QColor own_;
  bool coloured_;
};

}  // namespace

QColor colorFrom(std::uint32_t rgba) {
  return QColor(int(rgba >> 24 & 255), int(rgba >> 16 & 255), int(rgba >> 8 & 255), int(rgba & 255));
}

void drawGroundDrawings(QPainter& painter, const LayerContext& context,
                        const std::vector<map::GroundDrawing>& drawings, const QColor& color) {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const map::GroundDrawing& drawing : drawings) Brush(painter, context, drawing, color).draw();
}

}  // namespace mapwright::scene
