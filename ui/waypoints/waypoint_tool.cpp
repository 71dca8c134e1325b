#include "ui/waypoints/waypoint_tool.h"

#include <cmath>
#include <utility>

#include "geometry/pose.h"
#include "scene/drawing.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::window {

namespace {

constexpr int kFarCells = 10;  // with Shift

}  // namespace

WaypointTool::WaypointTool(WaypointEditing* editing, const scene::MapScene* scene, const HitList* hits,
                           WaypointSnapping* snapping, QObject* parent)
    : MapTool(parent), editing_(editing), scene_(scene), hits_(hits), snapping_(snapping) {
  const auto look_anew = [this] {
    group_.reset();
    Q_EMIT changed();
    Q_EMIT hintChanged();
  };
  connect(editing, &WaypointEditing::selectionChanged, this, look_anew);
  connect(editing, &WaypointEditing::previewChanged, this, look_anew);
  connect(editing, &WaypointEditing::opened, this, [this, look_anew] {
    dragCancelled();
    if (editing_->document())
      connect(editing_->document(), &edit::DocumentEvents::changed, this, [this] {
        group_.reset();
        Q_EMIT changed();
      });
    look_anew();
  });
}

QCursor WaypointTool::cursor() const {
  if (drag_ != Drag::None) return Qt::ClosedHandCursor;
  if (hovered_) return Qt::PointingHandCursor;
  return editing_->editable() ? Qt::CrossCursor : Qt::ArrowCursor;
}

void WaypointTool::deactivate() {
  dragCancelled();
  hovered_.reset();
  landing_.reset();
}

std::optional<edit::Key> WaypointTool::under(const MapPoint& at) const {
  for (const Hit& hit : hits_->at(at.world_m, kReachPx)) {
    if (hit.layer == scene::Layer::Waypoints) return hit.key;
  }
  return std::nullopt;
}

bool WaypointTool::onHandle(const MapPoint& at) const {
  const auto where = handle();
  return where && std::hypot(where->x() - at.px.x(), where->y() - at.px.y()) <= kReachPx;
}

bool WaypointTool::pressed(const MapPoint& at) {
  drag_ = Drag::None;
  nudging_ = 0;
  pressed_on_one_ = true;
  landing_.reset();
  press_m_ = at.world_m;
  press_px_ = now_px_ = at.px;
  if (onHandle(at)) {
    pressed_on_one_ = false;
    grabbed_ = *editing_->selected().begin();
    drag_ = editing_->selected().size() == 1 ? Drag::Turn : Drag::TurnGroup;
    turned_by_rad_ = 0;
    return true;
  }
  const auto key = under(at);
  if (!key) {
    pressed_on_one_ = false;
    if (!(at.modifiers & Qt::ShiftModifier) || !editing_->document()) return false;
    drag_ = Drag::Frame;
    return true;
  }
  grabbed_ = *key;
  if (at.modifiers & Qt::ShiftModifier) {
    editing_->toggle(*key);
  } else if (!editing_->selected().contains(*key)) {
    editing_->select({*key});
  }
  if (editing_->editable() && editing_->selected().contains(*key)) drag_ = Drag::Move;
  return drag_ != Drag::None;
}

void WaypointTool::dragged(const MapPoint& at) {
  now_px_ = at.px;
  switch (drag_) {
    case Drag::None:
      return;
    case Drag::Frame:
      Q_EMIT changed();
      Q_EMIT hintChanged();
      return;
    case Drag::Move:
      return move(at);
    case Drag::Turn:
      return turn(at);
    case Drag::TurnGroup:
      return turnGroup(at);
  }
}

void WaypointTool::move(const MapPoint& at) {
  const map::Waypoint* const grabbed = editing_->find(grabbed_);
  if (!grabbed) return;
  const Eigen::Vector2d free = grabbed->position_m + (at.world_m - press_m_);
  snapped_ = snapping_->place(free, at.modifiers, [this](const Hit& hit) {
    return hit.layer == scene::Layer::Waypoints && editing_->selected().contains(hit.key);
  });
  const Eigen::Vector2d by = snapped_.at_m - grabbed->position_m;
  WaypointPreview preview;
  for (const edit::Key& key : editing_->selected()) {
    const map::Waypoint& from = *editing_->find(key);
    preview.emplace_hint(preview.end(), key, placing::Spot{from.position_m + by, from.yaw_rad});
  }
  // Exactly the snapped position, without rounding errors.
  preview.at(grabbed_).position_m = snapped_.at_m;
  editing_->setPreview(std::move(preview));
}

void WaypointTool::turn(const MapPoint& at) {
  const map::Waypoint* const grabbed = editing_->find(grabbed_);
  if (!grabbed) return;
  placing::Spot to{grabbed->position_m, grabbed->yaw_rad};
  const Eigen::Vector2d towards = at.world_m - to.position_m;
  if (towards.norm() <= 0) return;
  const double yaw = std::atan2(towards.y(), towards.x());
  to.yaw_rad = geometry::normalizeAngle(snapping_->heading(yaw, at.modifiers));
  WaypointPreview preview;
  preview.emplace(grabbed_, to);
  editing_->setPreview(std::move(preview));
}

void WaypointTool::turnGroup(const MapPoint& at) {
  const auto& keys = editing_->selected();
  std::vector<placing::Spot> spots;
  spots.reserve(keys.size());
  for (const edit::Key& key : keys) {
    const map::Waypoint& point = *editing_->find(key);
    spots.push_back({point.position_m, point.yaw_rad});
  }
  const Eigen::Vector2d pivot = placing::middleOf(spots);
  const Eigen::Vector2d from = press_m_ - pivot, towards = at.world_m - pivot;
  if (towards.norm() <= 0) return;
  double by = geometry::normalizeAngle(std::atan2(towards.y(), towards.x()) - std::atan2(from.y(), from.x()));
  if (at.modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) by = snapping_->heading(by, at.modifiers);
  turned_by_rad_ = by;
  spots = placing::turned(std::move(spots), pivot, by);
  WaypointPreview preview;
  std::size_t i = 0;
  for (const edit::Key& key : keys) preview.emplace_hint(preview.end(), key, spots[i++]);
  editing_->setPreview(std::move(preview));
}

std::set<edit::Key> WaypointTool::inFrame() const {
  const geometry::ViewTransform& view = scene_->view();
  const QRectF frame = QRectF(press_px_, now_px_).normalized();
  geometry::WorldRect around;  // for a rotated view more than the frame
  for (const QPointF& corner : {frame.topLeft(), frame.topRight(), frame.bottomLeft(), frame.bottomRight()})
    around.extend(view.worldFromPixel({corner.x(), corner.y()}));
  std::set<edit::Key> keys;
  hits_->within(around, [&](const Hit& hit) {
    if (hit.layer == scene::Layer::Waypoints &&
        frame.contains(scene::toPoint(view.pixelFromWorld(hit.world_m))))
      keys.insert(hit.key);
  });
  return keys;
}

void WaypointTool::released(const MapPoint& at) {
  dragged(at);
  const Drag drag = std::exchange(drag_, Drag::None);
  if (drag == Drag::Frame) {
    std::set<edit::Key> keys = inFrame();
    keys.insert(editing_->selected().begin(), editing_->selected().end());
    editing_->select(std::move(keys));
    return endDrag();
  }
  const map::Waypoint* const one = editing_->find(grabbed_);
  const auto count = editing_->preview().size();
  if (one && count > 0) {
    const QString what = count == 1 ? shortWaypointName(*one) : waypointsText(qsizetype(count));
    editing_->applyPreview((drag == Drag::Move ? tr("move %1") : tr("turn %1")).arg(what));
  }
  endDrag();
}

void WaypointTool::dragCancelled() {
  drag_ = Drag::None;
  editing_->setPreview({});
  endDrag();
}

void WaypointTool::endDrag() {
  drag_ = Drag::None;
  snapped_ = {};
  Q_EMIT changed();
  Q_EMIT hintChanged();
}

void WaypointTool::clicked(const MapPoint& at) {
  drag_ = Drag::None;
  landing_.reset();
  if (pressed_on_one_) {
    if (!(at.modifiers & Qt::ShiftModifier) && under(at) == std::optional(grabbed_))
      editing_->select({grabbed_});
    return;
  }
  if (at.modifiers & Qt::ShiftModifier) return;  // an empty frame
  // A handle only reacts to drags: a click means what is below it.
  if (const auto key = under(at)) return editing_->select({*key});
  if (!editing_->editable()) {
    editing_->select({});
    return;
  }
  const auto where = snapping_->place(at.world_m, at.modifiers, [](const Hit&) { return false; });
  const edit::Gesture gesture = editing_->newGesture();
  const edit::Key key = editing_->add(where.at_m, gesture);
  if (!key.empty()) Q_EMIT editing_->renameWanted(key, gesture);
}

void WaypointTool::hovered(const MapPoint& at) {
  const auto key = onHandle(at) ? std::optional(*editing_->selected().begin()) : under(at);
  const bool had_landing = landing_.has_value();
  landing_.reset();
  if (!key && editing_->editable() && !(at.modifiers & Qt::ShiftModifier)) {
    auto place = snapping_->place(at.world_m, at.modifiers, [](const Hit&) { return false; });
    if (!place.guides.empty()) landing_ = std::move(place);
  }
  if (std::exchange(hovered_, key) != key || had_landing || landing_) Q_EMIT changed();
}

void WaypointTool::left() {
  const bool had_landing = landing_.has_value();
  landing_.reset();
  if (std::exchange(hovered_, std::nullopt) || had_landing) Q_EMIT changed();
}

bool WaypointTool::doubleClicked(const MapPoint& at) {
  const auto key = under(at);
  if (key && editing_->editable()) {
    editing_->select({*key});
    Q_EMIT editing_->renameWanted(*key, 0);
  }
  return true;
}

bool WaypointTool::nudge(const MapKeyPress& press) {
  Eigen::Vector2d screen(0, 0);
  switch (press.key) {
    case Qt::Key_Left:
      screen = {-1, 0};
      break;
    case Qt::Key_Right:
      screen = {1, 0};
      break;
    case Qt::Key_Up:
      screen = {0, 1};
      break;
    default:
      screen = {0, -1};
  }
  if (!editing_->editable() || editing_->selected().empty()) return false;
  // Along the axis of the map closest to the key's direction.
  const double turned = -scene_->view().rotation_rad;
  Eigen::Vector2d world(std::cos(turned) * screen.x() - std::sin(turned) * screen.y(),
                        std::sin(turned) * screen.x() + std::cos(turned) * screen.y());
  world = std::abs(world.x()) >= std::abs(world.y()) ? Eigen::Vector2d(std::copysign(1.0, world.x()), 0)
                                                     : Eigen::Vector2d(0, std::copysign(1.0, world.y()));
  if (nudging_ == 0 || nudged_ != editing_->selected()) {
    nudging_ = editing_->newGesture();
    nudged_ = editing_->selected();
  }
  editing_->moveSelected(world * editing_->cell() * (press.modifiers & Qt::ShiftModifier ? kFarCells : 1),
                         nudging_);
  return true;
}

bool WaypointTool::keyPressed(const MapKeyPress& press) {
  switch (press.key) {
    case Qt::Key_Escape:
      if (drag_ != Drag::None) {
        dragCancelled();
      } else if (!editing_->selected().empty()) {
        editing_->select({});
      } else {
        Q_EMIT finished();
      }
      return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      if (drag_ == Drag::None) editing_->removeSelected();
      return true;
    case Qt::Key_F2:
      if (editing_->editable() && editing_->only())
        Q_EMIT editing_->renameWanted(*editing_->selected().begin(), 0);
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return drag_ != Drag::None || nudge(press);
    default:
      return false;
  }
}

}  // namespace mapwright::window

#include "moc_waypoint_tool.cpp"
