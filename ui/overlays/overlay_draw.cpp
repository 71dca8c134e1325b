#include "ui/overlays/overlay_draw.h"

#include <algorithm>
#include <cmath>

#include "words/fixed.h"

namespace mapwright::ui {

using Eigen::Vector2d;
using overlays::Shape;

namespace {

constexpr double kCornerPx = 4;
constexpr double kLeastAreaPx = 4;  // of what is drawn

}  // namespace

Shape shapeOf(OverlayMode mode) {
  switch (mode) {
    case OverlayMode::Select:
      return Shape::None;
    case OverlayMode::Point:
      return Shape::Point;
    case OverlayMode::Line:
      return Shape::Line;
    case OverlayMode::Polygon:
    case OverlayMode::Rectangle:
    case OverlayMode::Circle:
      break;
  }
  return Shape::Polygon;
}

OverlayDraw::OverlayDraw(OverlayMode mode, edit::OverlayEditing* editing, const scene::MapScene* scene,
                         OverlaySnapping* snapping, QObject* parent)
    : DragTool(scene, parent), mode_(mode), editing_(editing), snapping_(snapping) {
  connect(editing_, &edit::OverlayEditing::opened, this, [this] {
    dragCancelled();
    forget();
  });
}

void OverlayDraw::deactivate() {
  DragTool::deactivate();
  forget();
}

void OverlayDraw::forget() {
  corners_.clear();
  landing_ = {};
  notifyChanged();
}

Vector2d OverlayDraw::caught(const MapPoint& at) {
  const bool bends = wholeAt() == 0 && !corners_.empty();
  landing_ = snapping_->place(at.world_m, at.modifiers, {}, bends ? Corners{corners_.back()} : Corners());
  return landing_.at_m;
}

void OverlayDraw::hovered(const MapPoint& at) {
  hand_ = at.world_m;
  if (editing_->editable()) follow(at);
  notifyChanged();
}

void OverlayDraw::left() {
  hand_.reset();
  landing_ = {};
  Q_EMIT changed();
}

bool OverlayDraw::doubleClicked(const MapPoint&) {
  complete();  // its first press added the last corner
  return true;
}

void OverlayDraw::addCorner(const Vector2d& at_m) {
  if (!editing_->editable()) return;
  corners_.push_back(at_m);
  if (corners_.size() == wholeAt()) complete();
  notifyChanged();
}

QString OverlayDraw::tooFew() const {
  return shapeOf(mode_) == Shape::Line ? tr("A line needs two points.")
                                       : tr("A region needs three points that enclose an area.");
}

void OverlayDraw::complete() {
  if (corners_.empty() || !editing_->editable()) return;
  Corners points = outlineOf(corners_);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const Shape shape = shapeOf(mode_);
  const std::size_t least = shape == Shape::Point ? 1 : shape == Shape::Line ? 2 : 3;
  const double scale = scene().view().scale_m_per_px;
  const bool flat =
      shape == Shape::Polygon && std::abs(overlays::doubleArea(points)) < 2 * kLeastAreaPx * scale * scale;
  const bool drawable = points.size() >= least && !flat;
  if (drawable || wholeAt() > 0) corners_.clear();
  if (drawable) {
    Q_EMIT drawn(points);
  } else {
    Q_EMIT refused(tooFew());
  }
  notifyChanged();
}

bool OverlayDraw::stepBack() {
  const bool any = !corners_.empty();
  forget();
  return any;
}

bool OverlayDraw::keyPressed(const MapKeyPress& press) {
  switch (press.key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      complete();
      return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      if (hold()) return true;
      if (corners_.empty()) return false;
      corners_.pop_back();
      notifyChanged();
      return true;
    default:
      return DragTool::keyPressed(press);
  }
}

void OverlayDraw::paint(QPainter& painter) {
  Corners corners = corners_;
  // With a given radius the next click makes a circle.
  if (mode_ == OverlayMode::Circle && wholeAt() == 1 && corners.empty() && hand_) corners = {*hand_};
  if (!corners.empty()) {
    if (hand_) corners.push_back(*hand_);
    paintOutline(painter, corners);
    painter.setPen(QPen(theme().accent, 1.5));
    painter.setBrush(theme().text_halo);
    for (const Vector2d& corner : corners_) painter.drawRect(scene::squareAround(px(corner), kCornerPx));
  }
  snapping_->paint(painter, landing_);
}

void OverlayDraw::paintOutline(QPainter& painter, const Corners& corners) const {
  QPolygonF outline;
  for (const Vector2d& corner : outlineOf(corners)) outline << px(corner);
  const bool open = mode_ == OverlayMode::Line;
  painter.setBrush(open ? QBrush(Qt::NoBrush) : QBrush(scene::translucent(theme().accent, 30)));
  strokeWithHalo(painter, theme(), 2,
                 [&] { open ? painter.drawPolyline(outline) : painter.drawPolygon(outline); });
}

QString OverlayDraw::hint() const {
  if (mode_ == OverlayMode::Point)
    return snapHint() + tr("Click to add a point. Esc goes back to selecting.");
  if (corners_.empty())
    return snapHint() + (mode_ == OverlayMode::Line
                             ? tr("Click where the line begins. Esc goes back to selecting.")
                             : tr("Click where the outline begins. Esc goes back to selecting."));
  const QString length =
      hand_ ? tr("%1 m. ").arg(words::fixed((*hand_ - corners_.back()).norm(), 2)) : QString();
  return snapHint() + length +
         tr("Click to add points; Enter or a double click ends, Backspace removes the last, Esc cancels.");
}

OverlayDraw::Corners OverlayDrawRectangle::outlineOf(const Corners& corners) const {
  if (corners.size() != 2) return corners;
  // Along the axes of the screen, however the map is turned.
  const geometry::ViewTransform& view = scene().view();
  const Vector2d a = view.pixelFromWorld(corners[0]), c = view.pixelFromWorld(corners[1]);
  return {corners[0], view.worldFromPixel({a.x(), c.y()}), corners[1], view.worldFromPixel({c.x(), a.y()})};
}

bool OverlayDrawRectangle::grab(const MapPoint& at) {
  if (!corners().empty()) return false;  // this is the second click
  if (wholeAt() == 1) return true;
  addCorner(caught(at));
  return !corners().empty();
}

void OverlayDrawRectangle::finish(const MapPoint&) {
  addCorner(wholeAt() == 1 ? caught(hold()->from) : *hand());
}

void OverlayDrawRectangle::click(const MapPoint& at) {
  if (!hold() || wholeAt() == 1) OverlayDraw::click(at);  // otherwise the press has set the first corner
}

QString OverlayDrawRectangle::hint() const {
  return hold() || corners().empty() ? tr("Drag a rectangle. Esc goes back to selecting.")
                                     : tr("Click the opposite corner. Esc cancels.");
}

void OverlayDrawCircle::setRadius(double metres) {
  radius_m_ = metres;
  notifyChanged();
}

double OverlayDrawCircle::radiusOf(const Corners& corners) const {
  if (radius_m_ > 0) return radius_m_;
  return corners.size() >= 2 ? (corners[1] - corners[0]).norm() : 0;
}

OverlayDraw::Corners OverlayDrawCircle::outlineOf(const Corners& corners) const {
  return overlays::circleAround(corners[0], radiusOf(corners));
}

QString OverlayDrawCircle::tooFew() const { return tr("A circle needs a radius: drag from its centre."); }

void OverlayDrawCircle::paintOutline(QPainter& painter, const Corners& corners) const {
  painter.setPen(QPen(theme().accent, 1.5, Qt::DashLine));
  if (radius_m_ <= 0 && radiusOf(corners) > 0) painter.drawLine(px(corners[0]), px(corners[1]));
  OverlayDraw::paintOutline(painter, corners);
}

QString OverlayDrawCircle::hint() const {
  if (radius_m_ > 0)
    return tr("Click where the centre is, or set another radius in the panel. Esc goes back to selecting.");
  if (corners().empty()) return tr("Drag a circle from its centre. Esc goes back to selecting.");
  const double radius_m = hand() ? (*hand() - corners()[0]).norm() : 0;
  return (hand() ? tr("Radius %1 m. ").arg(words::fixed(radius_m, 2)) : QString()) +
         (hold() ? tr("Esc cancels.") : tr("Click where the circle ends. Esc cancels."));
}

}  // namespace mapwright::ui

#include "moc_overlay_draw.cpp"
