// The frame of the chosen object, and the marker of a place that the user went to.
#include <array>

#include <QLineF>

#include "ui/scene/drawing.h"
#include "ui/scene/label_ink.h"
#include "ui/scene/layer_item.h"
#include "ui/scene/layer_objects.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kRingPx = 13, kCrossPx = 14;
constexpr double kLiesDotPx = 9, kExpectedSquarePx = 17, kPlaceNamePx = 14;  // the last: from the place

void strokeTwice(QPainter& painter, const MapTheme& theme, double width, const std::function<void()>& draw) {
  painter.setBrush(Qt::NoBrush);
  for (const auto& [color, px] : {std::pair(theme.text_halo, width + 2.5), std::pair(theme.accent, width)}) {
    painter.setPen(QPen(color, px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    draw();
  }
}

/// A loop closure has two places. As in its layer, a square is where the robot should lie.
bool hasPlaces(const MapObject& object) {
  return object.id.layer == Layer::Closures && object.parts.size() == 1 && object.parts.front().size() == 2;
}
QString liesText() { return ObjectText::tr("lies here"); }
QString expectedText() { return ObjectText::tr("should lie here"); }

/// In the viewport: from where the robot lies to where it should lie.
QLineF placesOf(const LayerContext& context, const map::Polyline& line) {
  return {toPoint(context.view.pixelFromWorld(line.front())),
          toPoint(context.view.pixelFromWorld(line.back()))};
}

struct PlaceName {
  QRectF box;
  QString text;
};
/// Away from each other.
std::array<PlaceName, 2> namesOf(const LayerContext& context, const QLineF& places) {
  const double length_px = places.length();
  const QPointF along = length_px > 1 ? (places.p2() - places.p1()) / length_px : QPointF(1, 0);
  const auto named = [&](const QPointF& place, const QPointF& away, const QString& text) {
    QRectF box(QPointF(), context.ink->sizeOf(text, context.theme));
    box.moveCenter(place + away * kPlaceNamePx +
                   QPointF(away.x() * box.width() / 2, away.y() * box.height() / 2));
    return PlaceName{box, text};
  };
  return {named(places.p1(), -along, liesText()), named(places.p2(), along, expectedText())};
}

void paintPlaces(QPainter& painter, const LayerContext& context, const map::Polyline& line) {
  const QLineF places = placesOf(context, line);
  strokeTwice(painter, context.theme, kLiesDotPx, [&] { painter.drawPoint(places.p1()); });
  strokeTwice(painter, context.theme, 2,
              [&] { painter.drawRect(squareAround(places.p2(), kExpectedSquarePx / 2)); });
  for (const PlaceName& name : namesOf(context, places))
    context.ink->draw(painter, name.box.topLeft(), name.text, context.theme,
                      readable(context.theme.accent, context.theme));
}

}  // namespace

QRectF MarkItem::covers() const {
  QRectF covered;
  if (context_.marked) {
    const geometry::WorldRect bounds = context_.marked->bounds();
    QPolygonF corners;
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(bounds.min_x, bounds.min_y), Eigen::Vector2d(bounds.max_x, bounds.min_y),
          Eigen::Vector2d(bounds.max_x, bounds.max_y), Eigen::Vector2d(bounds.min_x, bounds.max_y)})
      corners << toPoint(context_.view.pixelFromWorld(corner));
    double reach = kRingPx + 4;
    if (hasPlaces(*context_.marked) && context_.ink)
      for (const QString& text : {liesText(), expectedText()})
        reach = std::max(reach, context_.ink->sizeOf(text, context_.theme).width() + kPlaceNamePx + 4);
    covered |= corners.boundingRect().adjusted(-reach, -reach, reach, reach);
  }
  if (context_.marker) {
    const QPointF at = toPoint(context_.view.pixelFromWorld(*context_.marker));
    const double reach = kCrossPx + 4;
    covered |= QRectF(at.x() - reach, at.y() - reach, 2 * reach, 2 * reach);
  }
  return covered;
}

/// No label lies under the line of a closure: it is drawn over them.
void MarkItem::collectLabels(LabelCollector& labels) const {
  if (!context_.marked || !hasPlaces(*context_.marked) || !context_.ink) return;
  const QLineF places = placesOf(context_, context_.marked->parts.front());
  for (const PlaceName& name : namesOf(context_, places)) labels.symbol(name.box);
  labels.symbol(squareAround(places.p1(), kLiesDotPx));
  labels.symbol(squareAround(places.p2(), kExpectedSquarePx / 2 + 2));
  constexpr double kCasedPx = 14, kStepPx = 10;
  for (const QPolygonF& line : visibleLines(context_.view, context_.marked->parts.front(), kCasedPx)) {
    for (qsizetype i = 1; i < line.size(); ++i) {
      const QLineF leg(line[i - 1], line[i]);
      for (double at = 0; at < leg.length(); at += kStepPx)
        labels.symbol(squareAround(leg.pointAt(at / leg.length()), kCasedPx / 2));
    }
  }
}

/// On both sides of its lines: what they look like stays visible between them.
void MarkItem::paintCasing(QPainter& painter, const MapObject& object) const {
  constexpr double kBetweenPx = 7, kCasingPx = 2, kHaloPx = 1.25;
  std::vector<QPolygonF> lines;
  for (map::Polyline part : object.parts) {
    if (object.form == ObjectForm::Area && !part.empty()) part.push_back(part.front());
    for (QPolygonF& line : visibleLines(context_.view, part, 8)) lines.push_back(std::move(line));
  }
  sheet_.paint(painter, boundingRect().size(), 1, [&](QPainter& on_sheet) {
    on_sheet.setRenderHint(QPainter::Antialiasing);
    const auto stroke = [&](const QColor& color, double width) {
      on_sheet.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      for (const QPolygonF& line : lines) on_sheet.drawPolyline(line);
    };
    stroke(context_.theme.text_halo, kBetweenPx + 2 * (kCasingPx + kHaloPx));
    stroke(context_.theme.accent, kBetweenPx + 2 * kCasingPx);
    on_sheet.setCompositionMode(QPainter::CompositionMode_DestinationOut);
    stroke(Qt::black, kBetweenPx);
  });
}

void MarkItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (const auto& object = context_.marked) {
    strokeTwice(*painter, context_.theme, 2.5, [&] {
      if (object->parts.empty())
        painter->drawEllipse(toPoint(context_.view.pixelFromWorld(object->at_m)), kRingPx, kRingPx);
    });
    if (!object->parts.empty()) paintCasing(*painter, *object);
    if (hasPlaces(*object) && context_.ink) paintPlaces(*painter, context_, object->parts.front());
  }
  if (context_.marker) {
    const QPointF at = toPoint(context_.view.pixelFromWorld(*context_.marker));
    strokeTwice(*painter, context_.theme, 2, [&] {
      painter->drawEllipse(at, 7, 7);
      for (const QPointF& direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter->drawLine(at + direction * 4, at + direction * kCrossPx);
    });
  }
}

}  // namespace mapwright::ui::scene
