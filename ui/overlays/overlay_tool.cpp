#include "ui/overlays/overlay_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QLocale>
#include <QPainter>
#include <QPixmap>

#include "geometry/pose.h"
#include "overlays/overlay_arrange.h"
#include "overlays/overlay_shapes.h"
#include "overlays/overlay_types.h"
#include "scene/drawing.h"
#include "ui/overlays/overlay_text.h"
#include "words/fixed.h"

namespace mapwright::window {

using Eigen::Vector2d;
using overlays::Shape;
using overlays::Vertex;

namespace {

constexpr double kVertexPx = 4, kGripPx = 6;
constexpr double kLeastSidePx = 36;  // of shorter ones no middle is offered
constexpr double kLeastAreaPx = 4;   // of what is drawn
constexpr double kNudgeM = 0.05;
constexpr int kFar = 10;             // with Shift
constexpr double kStraightDeg = 90;  // sides of what is reshaped
constexpr double kTurnStep = std::numbers::pi / 12;

double away(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

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

OverlayTool::OverlayTool(OverlayEditing* editing, const scene::MapScene* scene, const OverlaysOnMap* on_map,
                         OverlaySnapping* snapping, QObject* parent)
    : MapTool(parent), editing_(editing), scene_(scene), on_map_(on_map), snapping_(snapping) {
  types_[std::size_t(Shape::Point)] = 25;
  types_[std::size_t(Shape::Line)] = overlays::kVirtualWall;
  types_[std::size_t(Shape::Polygon)] = overlays::kForbiddenRegion;
  for (const auto signal : {&OverlayEditing::previewChanged, &OverlayEditing::selectionChanged})
    connect(editing_, signal, this, &OverlayTool::lookAnew);
  connect(editing_, &OverlayEditing::changed, this, [this] {
    // It may have other points, and other properties, than what the hand holds.
    if (drag_ == Drag::Vertex) {
      drag_ = Drag::None;
      grabbed_.reset();
      editing_->setPreview({});
    }
    lookAnew();
  });
  connect(editing_, &OverlayEditing::opened, this, [this] {
    drag_ = Drag::None;
    corners_.clear();
    lookAnew();
  });
}

void OverlayTool::lookAnew() {
  rings_.reset();
  if (vertex_of_ != editing_->only()) dropVertex();
  if (vertex_) {
    const Rings& now = rings();
    if (vertex_->ring >= now.size() || vertex_->index >= now[vertex_->ring].size()) dropVertex();
  }
  Q_EMIT changed();
  Q_EMIT hintChanged();
}

void OverlayTool::dropVertex() {
  vertex_.reset();
  vertex_of_.reset();
}

void OverlayTool::setMode(OverlayMode mode) {
  if (mode_ == mode) return;
  dragCancelled();
  corners_.clear();
  mode_ = mode;
  Q_EMIT modeChanged();
  lookAnew();
}

void OverlayTool::setNewType(Shape shape, int type) {
  if (std::exchange(types_[std::size_t(shape)], type) != type) Q_EMIT hintChanged();
}

void OverlayTool::setCircleRadius(double metres) {
  if (std::exchange(circle_radius_m_, metres) == metres) return;
  Q_EMIT changed();
  Q_EMIT hintChanged();
}

void OverlayTool::addPlace(const Vector2d& at_m, double yaw_deg) {
  if (!editing_->editable()) return;
  if (drag_ != Drag::None) dragCancelled();
  if (shapeOf(mode_) == Shape::Polygon || shapeOf(mode_) == Shape::Line) return addCorner(at_m);
  Feature point = overlays::newFeature(editing_->document().mine(), Shape::Point, {at_m},
                                       newType(Shape::Point), editing_->newId());
  point = overlays::withYaw(point, yaw_deg);
  editing_->put({point}, {}, tr("add %1").arg(overlayCalled(point)));
}

Vector2d OverlayTool::caught(const MapPoint& at) {
  std::vector<Vector2d> arms;
  const bool bends = mode_ == OverlayMode::Line || mode_ == OverlayMode::Polygon;
  if (bends && !corners_.empty()) arms.push_back(corners_.back());
  landing_ = snapping_->place(at.world_m, at.modifiers, {}, arms);
  return landing_.at_m;
}

Vector2d OverlayTool::shiftTo(const MapPoint& at) {
  landing_ = snapping_->place(anchor_m_ + at.world_m - press_m_, at.modifiers, editing_->selected());
  return landing_.at_m - anchor_m_;
}

Vector2d OverlayTool::anchorNear(const Vector2d& at_m, FeatureKey key) const {
  Vector2d nearest = at_m;
  double least = HUGE_VAL;
  const Feature* const feature = editing_->find(key);
  for (const overlays::Path& path :
       feature ? overlays::shapesOf(*feature).paths : std::vector<overlays::Path>()) {
    for (const Vector2d& point : path.points) {
      const double distance = (point - at_m).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = point;
    }
  }
  return nearest;
}

void OverlayTool::setWhyNot(const QString& sentence) {
  if (std::exchange(why_not_, sentence) != sentence) Q_EMIT hintChanged();
}

QCursor OverlayTool::cursor() const {
  if (drag_ != Drag::None && drag_ != Drag::Frame && !drawing()) return Qt::ClosedHandCursor;
  if (drawing()) return Qt::CrossCursor;
  return hovered_ ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

void OverlayTool::deactivate() {
  dragCancelled();
  corners_.clear();
  hovered_.reset();
  if (std::exchange(mode_, OverlayMode::Select) != OverlayMode::Select) Q_EMIT modeChanged();
}

QPointF OverlayTool::px(const Vector2d& world_m) const {
  return scene::toPoint(scene_->view().pixelFromWorld(world_m));
}

const OverlayTool::Rings& OverlayTool::rings() const {
  if (!rings_) {
    rings_.emplace();
    const auto key = editing_->only();
    const Feature* const feature = key ? editing_->find(*key) : nullptr;
    if (feature && feature->shape() != Shape::Point)
      rings_ = overlays::verticesOf(*feature);  // MultiPoint, too
    std::size_t count = 0;
    for (const auto& ring : *rings_) count += ring.size();
    if (count > kMostVertices) rings_->clear();
  }
  return *rings_;
}

std::optional<Vertex> OverlayTool::vertexAt(const QPointF& at) const {
  if (!editing_->editable()) return std::nullopt;
  std::optional<Vertex> nearest;
  double least = kReachPx;
  for (std::size_t ring = 0; ring < rings().size(); ++ring) {
    for (std::size_t i = 0; i < rings()[ring].size(); ++i) {
      const double distance = away(px(rings()[ring][i]), at);
      if (distance > least) continue;
      least = distance;
      nearest = Vertex{ring, i};
    }
  }
  return nearest;
}

std::optional<Vertex> OverlayTool::middleAt(const QPointF& at) const {
  const auto key = editing_->only();
  if (!editing_->editable() || !key) return std::nullopt;
  const Shape shape = overlays::partShapeOf(*editing_->find(*key));
  if (shape == Shape::Point) return std::nullopt;
  const bool closed = shape == Shape::Polygon;
  for (std::size_t ring = 0; ring < rings().size(); ++ring) {
    const auto& points = rings()[ring];
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
      const QPointF a = px(points[i]), b = px(points[(i + 1) % points.size()]);
      if (away(a, b) >= kLeastSidePx && away((a + b) / 2, at) <= kReachPx) return Vertex{ring, i};
    }
  }
  return std::nullopt;
}

std::optional<QPointF> OverlayTool::handle() const {
  if (!editing_->editable() || drawing() || editing_->selected().empty()) return std::nullopt;
  if (drag_ == Drag::Turn) return now_px_;
  if (const auto key = editing_->only(); key && editing_->find(*key)->shape() == Shape::Point) {
    const auto points = overlays::verticesOf(*editing_->find(*key));
    const auto yaw = overlays::yawOf(*editing_->find(*key));
    if (points.empty() || points[0].empty()) return std::nullopt;
    const double heading = geometry::radiansFromDegrees(yaw.value_or(0)) + scene_->view().rotation_rad;
    return px(points[0][0]) + QPointF(std::cos(heading), -std::sin(heading)) * kHandlePx;
  }
  const geometry::WorldRect bounds = on_map_->boundsOf(editing_->selected());
  if (bounds.empty()) return std::nullopt;
  double top = 1e9;
  for (const double x : {bounds.min_x, bounds.max_x}) {
    for (const double y : {bounds.min_y, bounds.max_y}) top = std::min(top, px({x, y}).y());
  }
  const QPointF pivot = px({(bounds.min_x + bounds.max_x) / 2, (bounds.min_y + bounds.max_y) / 2});
  // Reachable whenever the middle is on screen.
  return QPointF(pivot.x(), std::max(top - kHandlePx, std::min(48.0, pivot.y() - kHandlePx)));
}

bool OverlayTool::onHandle(const QPointF& at) const {
  const auto where = handle();
  return where && away(*where, at) <= kReachPx;
}

bool OverlayTool::pressed(const MapPoint& at) {
  drag_ = Drag::None;
  nudging_ = 0;
  press_m_ = at.world_m;
  landing_ = {};
  press_px_ = now_px_ = at.px;
  pressed_on_one_ = false;
  if (drawing()) {
    const bool circle = mode_ == OverlayMode::Circle;
    if ((mode_ != OverlayMode::Rectangle && !circle) || !editing_->editable() || !corners_.empty())
      return false;
    press_m_ = caught(at);
    drag_ = circle ? Drag::Circle : Drag::Rectangle;
    return true;
  }
  const bool adds = at.modifiers & Qt::ShiftModifier;
  if (!adds && onHandle(at.px)) {
    drag_ = Drag::Turn;
    return true;
  }
  const auto key = editing_->only();
  if (const auto vertex = adds ? std::nullopt : vertexAt(at.px)) {
    vertex_ = vertex;
    vertex_of_ = key;
    grabbed_ = *editing_->find(*key);
    drag_ = Drag::Vertex;
    pressed_on_one_ = true;
    lookAnew();
    return true;
  }
  if (const auto before = adds ? std::nullopt : middleAt(at.px)) {
    grabbed_ = overlays::withVertexAfter(*editing_->find(*key), *before, at.world_m);
    vertex_ = Vertex{before->ring, before->index + 1};
    vertex_of_ = key;
    drag_ = Drag::Vertex;
    pressed_on_one_ = true;
    editing_->setPreview({{*key, *grabbed_}});
    return true;
  }
  const auto under = on_map_->at(at.world_m, kReachPx);
  if (!under) {
    if (!adds || !editing_->isOpen()) return false;
    drag_ = Drag::Frame;
    return true;
  }
  pressed_on_one_ = true;
  dropVertex();
  if (adds) {
    editing_->toggle(*under);
  } else if (!editing_->selected().contains(*under)) {
    editing_->select({*under});
  }
  if (editing_->editable() && editing_->selected().contains(*under)) {
    drag_ = Drag::Move;
    anchor_m_ = anchorNear(at.world_m, *under);
  }
  Q_EMIT changed();
  return drag_ != Drag::None;
}

void OverlayTool::dragged(const MapPoint& at) {
  now_px_ = at.px;
  hand_ = at.world_m;
  if (drag_ == Drag::Turn) return turn(at);
  if (drag_ == Drag::Rectangle || drag_ == Drag::Circle) hand_ = caught(at);
  OverlayEditing::Preview preview;
  if (drag_ == Drag::Move) {
    const Vector2d by = shiftTo(at);
    hand_ = press_m_ + by;
    for (const FeatureKey key : editing_->selected())
      preview.emplace(key, overlays::movedBy(*editing_->document().find(key), by));
  } else if (drag_ == Drag::Vertex && vertex_ && vertex_of_) {
    const Rings grabbed = overlays::verticesOf(*grabbed_);
    const auto& ring = grabbed.at(vertex_->ring);
    const bool closed = overlays::partShapeOf(*grabbed_) == Shape::Polygon;
    std::vector<Vector2d> neighbours;
    const std::size_t size = ring.size(), here = vertex_->index;
    const bool has_sides = overlays::partShapeOf(*grabbed_) != Shape::Point && size > 1;
    if (has_sides && (closed || here > 0)) neighbours.push_back(ring[(here + size - 1) % size]);
    if (has_sides && (closed || here + 1 < size)) neighbours.push_back(ring[(here + 1) % size]);
    landing_ = snapping_->place(at.world_m, at.modifiers, {*vertex_of_}, neighbours, kStraightDeg);
    hand_ = landing_.at_m;
    preview.emplace(*vertex_of_, overlays::withVertexAt(*grabbed_, *vertex_, *hand_));
  }
  if (!preview.empty()) return editing_->setPreview(std::move(preview));
  Q_EMIT changed();
  Q_EMIT hintChanged();
}

void OverlayTool::turn(const MapPoint& at) {
  OverlayEditing::Preview preview;
  const bool in_steps = at.modifiers & Qt::ShiftModifier;
  const auto key = editing_->only();
  const Feature* const one = key ? &*editing_->document().find(*key) : nullptr;
  if (one && one->shape() == Shape::Point) {
    const auto points = overlays::verticesOf(*one);
    if (points.empty() || points[0].empty()) return;
    const Vector2d towards = at.world_m - points[0][0];
    double heading = std::atan2(towards.y(), towards.x());
    if (in_steps) heading = std::round(heading / kTurnStep) * kTurnStep;
    preview.emplace(*key, overlays::withYaw(*one, geometry::degreesFromRadians(heading)));
  } else {
    geometry::WorldRect bounds;
    for (const FeatureKey each : editing_->selected()) {
      for (const overlays::Path& path : overlays::shapesOf(*editing_->document().find(each)).paths) {
        for (const Vector2d& point : path.points) bounds.extend(point);
      }
    }
    const Vector2d pivot((bounds.min_x + bounds.max_x) / 2, (bounds.min_y + bounds.max_y) / 2);
    const Vector2d from = press_m_ - pivot, towards = at.world_m - pivot;
    double by =
        geometry::normalizeAngle(std::atan2(towards.y(), towards.x()) - std::atan2(from.y(), from.x()));
    if (in_steps) by = std::round(by / kTurnStep) * kTurnStep;
    for (const FeatureKey each : editing_->selected())
      preview.emplace(each, overlays::turnedAbout(*editing_->document().find(each), pivot, by));
  }
  editing_->setPreview(std::move(preview));
}

void OverlayTool::released(const MapPoint& at) {
  dragged(at);
  const Drag drag = std::exchange(drag_, Drag::None);
  grabbed_.reset();
  landing_ = {};
  switch (drag) {
    case Drag::Move:
      editing_->applyPreview(editing_->saying(tr("move %1")));
      break;
    case Drag::Turn:
      editing_->applyPreview(editing_->saying(tr("turn %1")));
      break;
    case Drag::Vertex:
      editing_->applyPreview(editing_->saying(tr("reshape %1")));
      break;
    case Drag::Frame: {
      std::set<FeatureKey> keys = on_map_->within(QRectF(press_px_, now_px_).normalized());
      keys.insert(editing_->selected().begin(), editing_->selected().end());
      editing_->select(std::move(keys));
      break;
    }
    case Drag::Rectangle:
    case Drag::Circle:
      corners_ = {press_m_, hand_.value_or(at.world_m)};
      finishShape();
      break;
    case Drag::None:
      break;
  }
  lookAnew();
}

void OverlayTool::dragCancelled() {
  drag_ = Drag::None;
  landing_ = {};
  grabbed_.reset();
  editing_->setPreview({});
  lookAnew();
}

void OverlayTool::clicked(const MapPoint& at) {
  const Drag drag = std::exchange(drag_, Drag::None);
  if (drawing()) return addCorner(caught(at));
  // A side that was only clicked at has its new vertex there.
  if (drag == Drag::Vertex && !editing_->preview().empty())
    return editing_->applyPreview(editing_->saying(tr("reshape %1")));
  grabbed_.reset();
  const bool adds = at.modifiers & Qt::ShiftModifier;
  if (pressed_on_one_) {
    const auto under = on_map_->at(at.world_m, kReachPx);
    if (!adds && drag == Drag::Move && under) editing_->select({*under});
    return lookAnew();
  }
  if (adds) return lookAnew();
  // The handle only reacts to drags: a click means what is below it.
  const auto under = on_map_->at(at.world_m, kReachPx);
  editing_->select(under ? std::set<FeatureKey>{*under} : std::set<FeatureKey>{});
  lookAnew();
}

void OverlayTool::hovered(const MapPoint& at) {
  hand_ = at.world_m;
  now_px_ = at.px;
  if (drawing()) {
    const overlays::SnapTo before = landing_.to;
    if (editing_->editable()) hand_ = caught(at);
    Q_EMIT changed();
    if (!corners_.empty() || landing_.to != before) Q_EMIT hintChanged();
    return;
  }
  const bool grip = onHandle(at.px) || vertexAt(at.px) || middleAt(at.px);
  const auto under = grip ? editing_->only() : on_map_->at(at.world_m, kReachPx);
  if (std::exchange(hovered_, under) != under) Q_EMIT changed();
}

void OverlayTool::left() {
  hand_.reset();
  if (drawing() && std::exchange(landing_, {}).to != overlays::SnapTo::Nothing) Q_EMIT changed();
  if (std::exchange(hovered_, std::nullopt) || !corners_.empty()) Q_EMIT changed();
}

bool OverlayTool::doubleClicked(const MapPoint&) {
  if (drawing()) finishShape();  // its first press added the last corner
  return true;
}

void OverlayTool::addCorner(const Vector2d& at_m) {
  if (!editing_->editable()) return;
  corners_.push_back(at_m);
  const bool two = mode_ == OverlayMode::Rectangle || mode_ == OverlayMode::Circle;
  const bool done = mode_ == OverlayMode::Point || (two && corners_.size() == 2) ||
                    (mode_ == OverlayMode::Circle && circle_radius_m_ > 0);
  if (done) return finishShape();
  lookAnew();
}

std::vector<Vector2d> OverlayTool::rectangle() const {
  // Along the axes of the screen, however the map is turned.
  const geometry::ViewTransform& view = scene_->view();
  const Vector2d a = view.pixelFromWorld(corners_[0]), c = view.pixelFromWorld(corners_[1]);
  return {corners_[0], view.worldFromPixel({a.x(), c.y()}), corners_[1], view.worldFromPixel({c.x(), a.y()})};
}

void OverlayTool::finishShape() {
  if (corners_.empty() || !editing_->editable()) return;
  const bool circle = mode_ == OverlayMode::Circle;
  std::vector<Vector2d> points =
      mode_ == OverlayMode::Rectangle && corners_.size() == 2 ? rectangle() : corners_;
  if (circle) {
    const double radius = circle_radius_m_ > 0   ? circle_radius_m_
                          : corners_.size() == 2 ? (corners_[1] - corners_[0]).norm()
                                                 : 0;
    points = overlays::circleAround(corners_[0], radius);
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const Shape shape = shapeOf(mode_);
  const std::size_t least = shape == Shape::Point ? 1 : shape == Shape::Line ? 2 : 3;
  const double scale = scene_->view().scale_m_per_px;
  const bool flat =
      shape == Shape::Polygon && std::abs(overlays::doubleArea(points)) < 2 * kLeastAreaPx * scale * scale;
  if (points.size() < least || flat) {
    Q_EMIT refused(circle                 ? tr("A circle needs a radius: drag from its centre.")
                   : shape == Shape::Line ? tr("A line needs two points.")
                                          : tr("A region needs three points that enclose an area."));
    if (mode_ == OverlayMode::Rectangle || circle) corners_.clear();
    return lookAnew();
  }
  corners_.clear();
  editing_->add(shape, points, newType(shape));
}

bool OverlayTool::nudge(const MapKeyPress& press) {
  if (!editing_->editable() || editing_->selected().empty() || drawing()) return false;
  if (drag_ != Drag::None) return true;
  const Vector2d screen(press.key == Qt::Key_Left    ? -1
                        : press.key == Qt::Key_Right ? 1
                                                     : 0,
                        press.key == Qt::Key_Up     ? 1
                        : press.key == Qt::Key_Down ? -1
                                                    : 0);
  const double turned = -scene_->view().rotation_rad;
  Vector2d world(std::cos(turned) * screen.x() - std::sin(turned) * screen.y(),
                 std::sin(turned) * screen.x() + std::cos(turned) * screen.y());
  // Along the axis of the map closest to the key's direction.
  world = std::abs(world.x()) >= std::abs(world.y()) ? Vector2d(std::copysign(1.0, world.x()), 0)
                                                     : Vector2d(0, std::copysign(1.0, world.y()));
  world *= kNudgeM * (press.modifiers & Qt::ShiftModifier ? kFar : 1);
  if (nudging_ == 0 || nudged_ != editing_->selected()) {
    nudging_ = editing_->newGesture();
    nudged_ = editing_->selected();
  }
  if (vertex_ && vertex_of_) {
    const Feature& feature = *editing_->document().find(*vertex_of_);
    const Vector2d at = rings()[vertex_->ring][vertex_->index] + world;
    editing_->set(*vertex_of_, overlays::withVertexAt(feature, *vertex_, at),
                  editing_->saying(tr("reshape %1")), nudging_);
  } else {
    editing_->changeSelected(
        editing_->saying(tr("move %1")),
        [&](const Feature& feature) { return overlays::movedBy(feature, world); }, nudging_);
  }
  return true;
}

void OverlayTool::removeVertex() {
  const Feature& feature = *editing_->document().find(*vertex_of_);
  const auto less = overlays::withoutVertex(feature, *vertex_);
  if (!less) {
    const Shape shape = overlays::partShapeOf(feature);
    Q_EMIT refused(shape == Shape::Line    ? tr("A line needs two points.")
                   : shape == Shape::Point ? tr("The last point stays: delete the overlay instead.")
                                           : tr("An outline needs three points."));
    return;
  }
  const FeatureKey key = *vertex_of_;
  dropVertex();
  editing_->set(key, *less, editing_->saying(tr("reshape %1")));
}

bool OverlayTool::claims(const MapKeyPress& press) const {
  if (!editing_->isOpen() || !(press.modifiers & Qt::ControlModifier)) return false;
  if (press.key == Qt::Key_V) return !(press.modifiers & Qt::AltModifier);
  return press.modifiers == Qt::ControlModifier &&
         (press.key == Qt::Key_A || press.key == Qt::Key_C || press.key == Qt::Key_X);
}

bool OverlayTool::keyPressed(const MapKeyPress& press) {
  if (press.modifiers & Qt::ControlModifier) {
    const bool shift = press.modifiers & Qt::ShiftModifier;
    if (press.key == Qt::Key_C && !shift) return Q_EMIT copyWanted(), true;
    if (press.key == Qt::Key_X && !shift) return Q_EMIT cutWanted(), true;
    if (press.key == Qt::Key_A && !shift && editing_->isOpen()) {
      std::set<FeatureKey> all;
      for (FeatureKey key = 0; key < editing_->document().size(); ++key)
        if (editing_->document().find(key)) all.insert(key);
      editing_->select(std::move(all));
      return true;
    }
    if (press.key != Qt::Key_V) return false;
    Q_EMIT pasteWanted(shift ? std::optional(hand_.value_or(scene_->view().center_m)) : std::nullopt);
    return true;
  }
  switch (press.key) {
    case Qt::Key_Escape:
      if (drag_ != Drag::None) {
        dragCancelled();
      } else if (!corners_.empty()) {
        corners_.clear();
        lookAnew();
      } else if (drawing()) {
        setMode(OverlayMode::Select);
      } else if (vertex_) {
        dropVertex();
        lookAnew();
      } else if (!editing_->selected().empty()) {
        editing_->select({});
      } else {
        Q_EMIT finished();
      }
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!drawing()) return false;
      finishShape();
      return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      if (drag_ != Drag::None) return true;
      if (!corners_.empty()) {
        corners_.pop_back();
        lookAnew();
      } else if (vertex_ && vertex_of_ && editing_->editable()) {
        removeVertex();
      } else {
        editing_->removeSelected();
      }
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return nudge(press);
    default:
      return false;
  }
}

std::vector<QRectF> OverlayTool::covered() const {
  const auto grip = handle();
  return grip ? std::vector<QRectF>{scene::squareAround(*grip, kGripPx + 2)} : std::vector<QRectF>();
}

void OverlayTool::paint(QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  paintTheirs(painter);
  paintSelected(painter);
  if (drawing()) {
    paintShape(painter);
    return snapping_->paint(painter, landing_);
  }
  paintVertices(painter);
  const scene::MapTheme& theme = scene_->theme();
  if (const auto grip = handle()) {
    const geometry::WorldRect bounds = on_map_->boundsOf(editing_->selected());
    const QPointF from = px({(bounds.min_x + bounds.max_x) / 2, (bounds.min_y + bounds.max_y) / 2});
    for (const auto& [color, width] : {std::pair(theme.text_halo, 3.5), std::pair(theme.accent, 1.5)}) {
      painter.setPen(QPen(color, width, Qt::DotLine, Qt::RoundCap));
      painter.drawLine(from, *grip);
    }
    painter.setPen(QPen(theme.accent, 2));
    painter.setBrush(theme.text_halo);
    painter.drawEllipse(*grip, kGripPx, kGripPx);
  }
  if (drag_ == Drag::Move || drag_ == Drag::Vertex) snapping_->paint(painter, landing_);
  if (drag_ != Drag::Frame) return;
  painter.setBrush(scene::translucent(theme.accent, 30));
  painter.setPen(QPen(theme.accent, 1.5));
  painter.drawRect(QRectF(press_px_, now_px_).normalized());
}

void OverlayTool::paintSelected(QPainter& painter) const {
  const scene::MapTheme& theme = scene_->theme();
  std::set<FeatureKey> keys = editing_->selected();
  if (hovered_ && !drawing()) keys.insert(*hovered_);
  painter.setBrush(Qt::NoBrush);
  if (keys.size() > kMostDrawnInHand) return paintMany(painter, keys);
  for (const FeatureKey key : keys) {
    const Feature* const feature = editing_->find(key);
    if (!feature) continue;
    const bool selected = editing_->selected().contains(key);
    const auto* const parts = on_map_->partsOf(key);
    for (const map::OverlayFeature& part : parts ? *parts : std::vector<map::OverlayFeature>()) {
      for (const auto& ring : part.parts) {
        if (ring.empty()) continue;
        for (const auto& [color, width] : {std::pair(theme.text_halo, 5.0), std::pair(theme.accent, 2.5)}) {
          painter.setPen(
              QPen(color, width, selected ? Qt::SolidLine : Qt::DotLine, Qt::RoundCap, Qt::RoundJoin));
          if (part.shape == map::OverlayShape::Point) {
            painter.drawEllipse(px(ring[0]), 11, 11);
            continue;
          }
          std::vector<Vector2d> points = ring;
          if (part.shape == map::OverlayShape::Polygon) points.push_back(points.front());
          for (const QPolygonF& line : scene::visibleLines(scene_->view(), points, 8))
            painter.drawPolyline(line);
        }
      }
    }
  }
}

/// Plainer, and fast: each mark of a point is a copy of one picture.
void OverlayTool::paintMany(QPainter& painter, const std::set<FeatureKey>& keys) const {
  constexpr double kMarkPx = 26;
  const QColor accent = scene_->theme().accent;
  const double ratio = painter.device()->devicePixelRatioF();
  QPixmap mark(int(std::ceil(kMarkPx * ratio)), int(std::ceil(kMarkPx * ratio)));
  mark.setDevicePixelRatio(ratio);
  mark.fill(Qt::transparent);
  QPainter on_mark(&mark);
  on_mark.setRenderHint(QPainter::Antialiasing);
  on_mark.setPen(QPen(accent, 2.5));
  on_mark.drawEllipse(QPointF(kMarkPx / 2, kMarkPx / 2), 11, 11);
  on_mark.end();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(accent, 2));
  const QRectF seen = QRectF(painter.viewport()).adjusted(-kMarkPx, -kMarkPx, kMarkPx, kMarkPx);
  for (const FeatureKey key : keys) {
    const auto* const parts = on_map_->partsOf(key);
    for (const map::OverlayFeature& part : parts ? *parts : std::vector<map::OverlayFeature>()) {
      for (const auto& ring : part.parts) {
        if (ring.empty()) continue;
        if (part.shape == map::OverlayShape::Point) {
          const QPointF at = px(ring[0]);
          if (seen.contains(at)) painter.drawPixmap(at - QPointF(kMarkPx / 2, kMarkPx / 2), mark);
          continue;
        }
        std::vector<Vector2d> points = ring;
        if (part.shape == map::OverlayShape::Polygon) points.push_back(points.front());
        for (const QPolygonF& line : scene::visibleLines(scene_->view(), points, 8))
          painter.drawPolyline(line);
      }
    }
  }
  painter.restore();
}

void OverlayTool::paintTheirs(QPainter& painter) const {
  const scene::MapTheme& theme = scene_->theme();
  painter.setBrush(Qt::NoBrush);
  for (const auto& [key, part] : editing_->document().conflicts()) {
    const auto& theirs = editing_->document().findBase(key);
    if (!theirs || part.of == overlays::Part::Of::Property) continue;
    for (const overlays::Path& path : overlays::shapesOf(*theirs).paths) {
      std::vector<Vector2d> points = path.points;
      if (points.empty()) continue;
      if (path.shape == Shape::Polygon) points.push_back(points.front());
      painter.setPen(QPen(theme.warn, 2.5, Qt::DashLine));
      if (path.shape == Shape::Point) painter.drawEllipse(px(points[0]), 9, 9);
      for (const QPolygonF& line : scene::visibleLines(scene_->view(), points, 8)) painter.drawPolyline(line);
    }
  }
}

void OverlayTool::paintVertices(QPainter& painter) const {
  if (!editing_->editable() || rings().empty()) return;
  const scene::MapTheme& theme = scene_->theme();
  const auto key = editing_->only();
  const Shape shape = key ? overlays::partShapeOf(*editing_->find(*key)) : Shape::None;
  const bool closed = shape == Shape::Polygon, has_sides = shape != Shape::Point;
  for (std::size_t ring = 0; ring < rings().size(); ++ring) {
    const auto& points = rings()[ring];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const QPointF at = px(points[i]);
      if (drag_ == Drag::None && has_sides && (closed || i + 1 < points.size())) {
        const QPointF next = px(points[(i + 1) % points.size()]);
        if (away(at, next) >= kLeastSidePx) {
          painter.setPen(QPen(theme.accent, 1));
          painter.setBrush(theme.text_halo);
          painter.drawEllipse((at + next) / 2, kVertexPx - 1, kVertexPx - 1);
        }
      }
      const bool chosen = vertex_ && *vertex_ == Vertex{ring, i};
      painter.setPen(QPen(theme.accent, 1.5));
      painter.setBrush(chosen ? theme.accent : theme.text_halo);
      const double half = chosen ? kVertexPx + 1.5 : kVertexPx;
      painter.drawRect(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half));
    }
  }
}

void OverlayTool::paintShape(QPainter& painter) const {
  std::vector<Vector2d> corners = corners_;
  if (drag_ == Drag::Rectangle || drag_ == Drag::Circle) corners = {press_m_};
  const bool circle = mode_ == OverlayMode::Circle;
  if (circle && circle_radius_m_ > 0 && corners.empty() && hand_) corners = {*hand_};
  if (corners.empty()) return;
  if (hand_) corners.push_back(*hand_);
  const scene::MapTheme& theme = scene_->theme();
  QPolygonF line;
  if (circle) {
    const double radius = circle_radius_m_ > 0  ? circle_radius_m_
                          : corners.size() >= 2 ? (corners[1] - corners[0]).norm()
                                                : 0;
    for (const Vector2d& corner : overlays::circleAround(corners[0], radius)) line << px(corner);
    painter.setPen(QPen(scene_->theme().accent, 1.5, Qt::DashLine));
    if (radius > 0 && corners.size() >= 2 && circle_radius_m_ <= 0)
      painter.drawLine(px(corners[0]), px(corners[1]));
  } else if (mode_ == OverlayMode::Rectangle && corners.size() == 2) {
    line = QPolygonF(QRectF(px(corners[0]), px(corners[1])).normalized());
  } else {
    for (const Vector2d& corner : corners) line << px(corner);
    if (mode_ == OverlayMode::Polygon && line.size() > 2) line << line.front();
  }
  painter.setBrush(mode_ == OverlayMode::Line ? QBrush(Qt::NoBrush)
                                              : QBrush(scene::translucent(theme.accent, 30)));
  for (const auto& [color, width] : {std::pair(theme.text_halo, 4.0), std::pair(theme.accent, 2.0)}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    mode_ == OverlayMode::Line ? painter.drawPolyline(line) : painter.drawPolygon(line);
  }
  painter.setPen(QPen(theme.accent, 1.5));
  painter.setBrush(theme.text_halo);
  for (const Vector2d& corner : corners_) {
    const QPointF at = px(corner);
    painter.drawRect(QRectF(at.x() - kVertexPx, at.y() - kVertexPx, 2 * kVertexPx, 2 * kVertexPx));
  }
}

QString OverlayTool::hint() const {
  if (!editing_->isOpen()) return why_not_.isEmpty() ? tr("Loading the overlays. Esc leaves.") : why_not_;
  if (!editing_->editable()) return tr("The overlays are being saved.");
  const auto metres = [](double value) { return words::fixed(value, 2); };
  if (drag_ == Drag::Frame)
    return tr("%1 in the frame. Esc cancels.")
        .arg(featuresText(qsizetype(on_map_->within(QRectF(press_px_, now_px_).normalized()).size())));
  const QString to = OverlaySnapping::nameOf(landing_.to);
  const QString snap = to.isEmpty() ? QString() : tr("Snapped to %1 (Alt: not). ").arg(to);
  if (drag_ == Drag::Move && hand_) {
    const Vector2d by = *hand_ - press_m_;
    return snap + tr("Moved by %1, %2 m. Esc cancels.").arg(metres(by.x()), metres(by.y()));
  }
  if (drag_ == Drag::Turn) return tr("Shift turns by 15°, Esc cancels.");
  if (drag_ == Drag::Vertex && hand_)
    return snap + tr("%1, %2 m. Esc cancels.").arg(metres(hand_->x()), metres(hand_->y()));
  switch (mode_) {
    case OverlayMode::Select:
      break;
    case OverlayMode::Point:
      return snap + tr("Click to add a point. Esc goes back to selecting.");
    case OverlayMode::Line:
    case OverlayMode::Polygon: {
      const bool line = mode_ == OverlayMode::Line;
      if (corners_.empty())
        return snap + (line ? tr("Click where the line begins. Esc goes back to selecting.")
                            : tr("Click where the outline begins. Esc goes back to selecting."));
      const QString length = hand_ ? metres((*hand_ - corners_.back()).norm()) : QString();
      const QString next = length.isEmpty() ? QString() : tr("%1 m. ").arg(length);
      return snap + next +
             tr("Click to add points; Enter or a double click ends, Backspace removes the last, Esc "
                "cancels.");
    }
    case OverlayMode::Rectangle:
      return corners_.empty() ? tr("Drag a rectangle. Esc goes back to selecting.")
                              : tr("Click the opposite corner. Esc cancels.");
    case OverlayMode::Circle: {
      if (circle_radius_m_ > 0)
        return tr(
            "Click where the centre is, or set another radius in the panel. Esc goes back to selecting.");
      const bool drags = drag_ == Drag::Circle;
      if (!drags && corners_.empty()) return tr("Drag a circle from its centre. Esc goes back to selecting.");
      const Vector2d centre = drags ? press_m_ : corners_[0];
      const QString radius = hand_ ? tr("Radius %1 m. ").arg(metres((*hand_ - centre).norm())) : QString();
      return radius + (drags ? tr("Esc cancels.") : tr("Click where the circle ends. Esc cancels."));
    }
  }
  if (vertex_) return tr("Drag the point or use the arrows to move it, Delete deletes it. Esc deselects it.");
  if (editing_->selected().empty())
    return tr(
        "Click an overlay to select it, drag to move it, Shift and drag to select several. Esc leaves.");
  QString hint = editing_->saying(tr(
      "%1: drag or use the arrows to move, drag the round handle to turn, Delete deletes. Esc deselects."));
  hint[0] = hint[0].toUpper();
  return hint;
}

}  // namespace mapwright::window

#include "moc_overlay_tool.cpp"
