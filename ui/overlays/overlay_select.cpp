#include "ui/overlays/overlay_select.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/pose.h"
#include "overlays/overlay_shapes.h"
#include "ui/overlays/overlay_text.h"
#include "words/figures.h"
#include "words/fixed.h"
#include "words/listed.h"

namespace mapwright::ui {

using Eigen::Vector2d;
using overlays::Shape;
using overlays::Vertex;

namespace {

constexpr double kHandlePx = 34;  // from what it turns
constexpr double kVertexPx = 4, kGripPx = 6;
constexpr double kLeastSidePx = 36;  // of shorter ones no middle is offered
constexpr double kNudgeM = 0.05;
constexpr int kFar = 10;                      // with Shift
constexpr double kStraightDeg = 90;           // sides of what is reshaped
constexpr std::size_t kMostVertices = 2'000;  // of a feature with more, none are shown
constexpr double kTurnStep = std::numbers::pi / 12;

double away(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

Vector2d middleOf(const geometry::WorldRect& bounds) {
  return {(bounds.min_x + bounds.max_x) / 2, (bounds.min_y + bounds.max_y) / 2};
}

/// Where a point is that has a heading.
std::optional<Vector2d> placeOf(const Feature& feature) {
  if (feature.shape() != Shape::Point) return std::nullopt;
  const auto points = overlays::verticesOf(feature);
  if (points.empty() || points[0].empty()) return std::nullopt;
  return points[0][0];
}

}  // namespace

OverlaySelect::OverlaySelect(edit::OverlayEditing* editing, const scene::MapScene* scene,
                             const OverlaysOnMap* on_map, OverlaySnapping* snapping, QObject* parent)
    : DragTool(scene, parent), editing_(editing), on_map_(on_map), snapping_(snapping) {
  for (const auto signal : {&edit::OverlayEditing::previewChanged, &edit::OverlayEditing::selectionChanged})
    connect(editing_, signal, this, &OverlaySelect::lookAnew);
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::editableChanged}) {
    connect(editing_, signal, this, [this] {
      // It may have other points, and other properties, than what the hand holds.
      if (drag() == Drag::Vertex) dragCancelled();
      lookAnew();
    });
  }
  connect(editing_, &edit::OverlayEditing::opened, this, [this] {
    dragCancelled();
    lookAnew();
  });
}

void OverlaySelect::lookAnew() {
  rings_.reset();
  bounds_.reset();
  if (vertex_of_ != editing_->only()) dropVertex();
  if (vertex_) {
    const Rings& now = rings();
    if (vertex_->ring >= now.size() || vertex_->index >= now[vertex_->ring].size()) dropVertex();
  }
  notifyChanged();
}

void OverlaySelect::dropVertex() {
  vertex_.reset();
  vertex_of_.reset();
}

QCursor OverlaySelect::cursor() const {
  if (drag() != Drag::None && drag() != Drag::Frame) return Qt::ClosedHandCursor;
  return under_ ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

void OverlaySelect::deactivate() {
  DragTool::deactivate();
  under_.reset();
}

Vector2d OverlaySelect::anchorNear(const Vector2d& at_m, FeatureKey key) const {
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

const OverlaySelect::Rings& OverlaySelect::rings() const {
  if (!rings_) {
    rings_.emplace();
    const auto key = editing_->only();
    const Feature* const feature = key ? editing_->find(*key) : nullptr;
    if (feature && feature->shape() != Shape::Point)
      rings_ = overlays::verticesOf(*feature);  // MultiPoint, too
    std::size_t count = 0;
    for (const auto& ring : *rings_) count += ring.size();
    left_out_ = count > kMostVertices ? count : 0;
    if (left_out_ > 0) rings_->clear();
  }
  return *rings_;
}

std::optional<Vertex> OverlaySelect::vertexAt(const QPointF& at) const {
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

std::optional<Vertex> OverlaySelect::middleAt(const QPointF& at) const {
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

std::optional<QPointF> OverlaySelect::handle() const {
  if (!editing_->editable() || editing_->selected().empty()) return std::nullopt;
  if (drag() == Drag::Turn) return hold()->to.px;
  if (const auto key = editing_->only(); key && editing_->find(*key)->shape() == Shape::Point) {
    const auto place = placeOf(*editing_->find(*key));
    if (!place) return std::nullopt;
    const double yaw = geometry::radiansFromDegrees(overlays::yawOf(*editing_->find(*key)).value_or(0)) +
                       scene().view().rotation_rad;
    return px(*place) + QPointF(std::cos(yaw), -std::sin(yaw)) * kHandlePx;
  }
  const geometry::WorldRect bounds = selectedBounds();
  if (bounds.empty()) return std::nullopt;
  return turnHandle(scene().view(), bounds, middleOf(bounds), kHandlePx);
}

geometry::WorldRect OverlaySelect::selectedBounds() const {
  if (!bounds_) bounds_ = on_map_->boundsOf(editing_->selected());
  return *bounds_;
}

bool OverlaySelect::onHandle(const QPointF& at) const {
  const auto where = handle();
  return where && away(*where, at) <= kReachPx;
}

/// A vertex, or a side whose middle becomes one.
bool OverlaySelect::holdVertex(const MapPoint& at) {
  const auto key = editing_->only();
  const auto vertex = vertexAt(at.px), before = vertex ? std::nullopt : middleAt(at.px);
  if (!vertex && !before) return false;
  drag_ = Drag::Vertex;
  pressed_on_one_ = true;
  vertex_of_ = key;
  if (vertex) {
    vertex_ = vertex;
    grabbed_ = *editing_->find(*key);
    lookAnew();
  } else {
    vertex_ = Vertex{before->ring, before->index + 1};
    grabbed_ = overlays::withVertexAfter(*editing_->find(*key), *before, at.world_m);
    editing_->setPreview({{*key, *grabbed_}});
  }
  return true;
}

bool OverlaySelect::grab(const MapPoint& at) {
  drag_ = Drag::None;
  nudging_ = 0;
  landing_ = {};
  pressed_on_one_ = false;
  const bool adds = at.modifiers & Qt::ShiftModifier;
  if (!adds && onHandle(at.px)) {
    drag_ = Drag::Turn;
    return true;
  }
  if (!adds && holdVertex(at)) return true;
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

void OverlaySelect::update(const MapPoint& at) {
  if (drag_ == Drag::Move) move(at);
  if (drag_ == Drag::Turn) turn(at);
  if (drag_ == Drag::Vertex && vertex_ && vertex_of_) moveVertex(at);
}

void OverlaySelect::move(const MapPoint& at) {
  landing_ =
      snapping_->place(anchor_m_ + at.world_m - hold()->from.world_m, at.modifiers, editing_->selected());
  by_m_ = landing_.at_m - anchor_m_;
  edit::OverlayEditing::Preview preview;
  for (const FeatureKey key : editing_->selected())
    preview.emplace(key, overlays::movedBy(*editing_->document().find(key), by_m_));
  editing_->setPreview(std::move(preview));
}

void OverlaySelect::moveVertex(const MapPoint& at) {
  const Rings grabbed = overlays::verticesOf(*grabbed_);
  const auto& ring = grabbed.at(vertex_->ring);
  const bool closed = overlays::partShapeOf(*grabbed_) == Shape::Polygon;
  std::vector<Vector2d> neighbours;
  const std::size_t size = ring.size(), here = vertex_->index;
  const bool has_sides = overlays::partShapeOf(*grabbed_) != Shape::Point && size > 1;
  if (has_sides && (closed || here > 0)) neighbours.push_back(ring[(here + size - 1) % size]);
  if (has_sides && (closed || here + 1 < size)) neighbours.push_back(ring[(here + 1) % size]);
  landing_ = snapping_->place(at.world_m, at.modifiers, {*vertex_of_}, neighbours, kStraightDeg);
  editing_->setPreview({{*vertex_of_, overlays::withVertexAt(*grabbed_, *vertex_, landing_.at_m)}});
}

void OverlaySelect::turn(const MapPoint& at) {
  const auto step = [steps = bool(at.modifiers & Qt::ShiftModifier)](double angle) {
    return steps ? std::round(angle / kTurnStep) * kTurnStep : angle;
  };
  edit::OverlayEditing::Preview preview;
  const auto key = editing_->only();
  const Feature* const one = key ? &*editing_->document().find(*key) : nullptr;
  if (one && one->shape() == Shape::Point) {
    const auto place = placeOf(*one);
    if (!place) return;
    const Vector2d towards = at.world_m - *place;
    const double heading = step(std::atan2(towards.y(), towards.x()));
    preview.emplace(*key, overlays::withYaw(*one, geometry::degreesFromRadians(heading)));
  } else {
    geometry::WorldRect bounds;
    for (const FeatureKey each : editing_->selected()) {
      for (const overlays::Path& path : overlays::shapesOf(*editing_->document().find(each)).paths) {
        for (const Vector2d& point : path.points) bounds.extend(point);
      }
    }
    const Vector2d pivot = middleOf(bounds);
    const double by = step(turnAround(pivot, hold()->from.world_m, at.world_m));
    for (const FeatureKey each : editing_->selected())
      preview.emplace(each, overlays::turnedAbout(*editing_->document().find(each), pivot, by));
  }
  editing_->setPreview(std::move(preview));
}

void OverlaySelect::finish(const MapPoint&) {
  const Drag drag = std::exchange(drag_, Drag::None);
  grabbed_.reset();
  landing_ = {};
  if (drag == Drag::Frame) {
    std::set<FeatureKey> keys = on_map_->within(frame());
    keys.insert(editing_->selected().begin(), editing_->selected().end());
    editing_->select(std::move(keys));
  } else {
    editing_->applyPreview(editing_->saying(drag == Drag::Move   ? tr("move %1")
                                            : drag == Drag::Turn ? tr("turn %1")
                                                                 : tr("reshape %1")));
  }
  lookAnew();
}

void OverlaySelect::cancel() {
  drag_ = Drag::None;
  landing_ = {};
  grabbed_.reset();
  editing_->setPreview({});
  lookAnew();
}

void OverlaySelect::click(const MapPoint& at) {
  const Drag drag = std::exchange(drag_, Drag::None);
  // A side that was only clicked at has its new vertex there.
  if (drag == Drag::Vertex && !editing_->preview().empty())
    return editing_->applyPreview(editing_->saying(tr("reshape %1")));
  grabbed_.reset();
  const bool adds = at.modifiers & Qt::ShiftModifier;
  const auto under = on_map_->at(at.world_m, kReachPx);
  if (pressed_on_one_) {
    if (!adds && drag == Drag::Move && under) editing_->select({*under});
  } else if (!adds) {
    // The handle only reacts to drags: a click means what is below it.
    editing_->select(under ? std::set<FeatureKey>{*under} : std::set<FeatureKey>{});
  }
  lookAnew();
}

void OverlaySelect::hovered(const MapPoint& at) {
  const bool grip = onHandle(at.px) || vertexAt(at.px) || middleAt(at.px);
  const auto under = grip ? editing_->only() : on_map_->at(at.world_m, kReachPx);
  if (std::exchange(under_, under) != under) Q_EMIT changed();
}

void OverlaySelect::left() {
  if (std::exchange(under_, std::nullopt)) Q_EMIT changed();
}

bool OverlaySelect::nudge(const MapKeyPress& press) {
  if (!editing_->editable() || editing_->selected().empty()) return false;
  if (hold()) return true;
  const Vector2d world =
      arrowStep(scene().view(), press.key) * kNudgeM * (press.modifiers & Qt::ShiftModifier ? kFar : 1);
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

void OverlaySelect::removeVertex() {
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

bool OverlaySelect::stepBack() {
  if (vertex_) {
    dropVertex();
  } else if (!editing_->selected().empty()) {
    editing_->select({});
  } else {
    return false;
  }
  return true;
}

bool OverlaySelect::keyPressed(const MapKeyPress& press) {
  switch (press.key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      if (hold()) return true;
      vertex_&& vertex_of_ && editing_->editable() ? removeVertex() : editing_->removeSelected();
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return nudge(press);
    default:
      return DragTool::keyPressed(press);
  }
}

std::vector<QRectF> OverlaySelect::covered() const {
  const auto grip = handle();
  return grip ? std::vector<QRectF>{scene::squareAround(*grip, kGripPx + 2)} : std::vector<QRectF>();
}

void OverlaySelect::paint(QPainter& painter) {
  paintVertices(painter);
  if (const auto grip = handle()) {
    const QPointF from = px(middleOf(selectedBounds()));
    lineWithHalo(painter, theme(), from, *grip, Qt::DotLine);
    paintGrip(painter, theme(), *grip, kGripPx);
  }
  if (drag() == Drag::Move || drag() == Drag::Vertex) snapping_->paint(painter, landing_);
  if (drag() == Drag::Frame) paintFrame(painter, theme(), frame());
}

void OverlaySelect::paintVertices(QPainter& painter) const {
  if (!editing_->editable() || rings().empty()) return;
  const auto key = editing_->only();
  const Shape shape = key ? overlays::partShapeOf(*editing_->find(*key)) : Shape::None;
  const bool closed = shape == Shape::Polygon, has_sides = shape != Shape::Point;
  for (std::size_t ring = 0; ring < rings().size(); ++ring) {
    const auto& points = rings()[ring];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const QPointF at = px(points[i]);
      if (drag() == Drag::None && has_sides && (closed || i + 1 < points.size())) {
        const QPointF next = px(points[(i + 1) % points.size()]);
        if (away(at, next) >= kLeastSidePx) {
          painter.setPen(QPen(theme().accent, 1));
          painter.setBrush(theme().text_halo);
          painter.drawEllipse((at + next) / 2, kVertexPx - 1, kVertexPx - 1);
        }
      }
      const bool chosen = vertex_ && *vertex_ == Vertex{ring, i};
      painter.setPen(QPen(theme().accent, 1.5));
      painter.setBrush(chosen ? theme().accent : theme().text_halo);
      painter.drawRect(scene::squareAround(at, chosen ? kVertexPx + 1.5 : kVertexPx));
    }
  }
}

QString OverlaySelect::hint() const {
  const auto metres = [](double value) { return words::fixed(value, 2); };
  if (drag() == Drag::Frame)
    return tr("%1 in the frame. Esc cancels.").arg(featuresText(qsizetype(on_map_->within(frame()).size())));
  const QString snap = OverlaySnapping::hintOf(landing_.to);
  if (drag() == Drag::Move && dragging())
    return snap + tr("Moved by %1, %2 m. Esc cancels.").arg(metres(by_m_.x()), metres(by_m_.y()));
  if (drag() == Drag::Turn) return tr("Shift turns by 15°, Esc cancels.");
  if (drag() == Drag::Vertex && dragging())
    return snap + tr("%1, %2 m. Esc cancels.").arg(metres(landing_.at_m.x()), metres(landing_.at_m.y()));
  if (vertex_) return tr("Drag the point or use the arrows to move it, Delete deletes it. Esc deselects it.");
  if (editing_->selected().empty())
    return tr(
        "Click an overlay to select it, drag to move it, Shift and drag to select several. Esc leaves.");
  QString hint = editing_->saying(tr(
      "%1: drag or use the arrows to move, drag the round handle to turn, Delete deletes. Esc deselects."));
  hint[0] = hint[0].toUpper();
  (void)rings();
  if (left_out_ == 0) return hint;
  return words::paragraph({hint, tr("It has %1 points: too many to drag one by one.")
                                     .arg(QString::fromStdString(words::grouped(qint64(left_out_))))});
}

}  // namespace mapwright::ui

#include "moc_overlay_select.cpp"
