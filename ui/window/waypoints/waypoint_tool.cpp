#include "window/waypoints/waypoint_tool.h"

#include <cmath>
#include <utility>

#include <QLocale>
#include <QPainter>

#include "geometry/pose.h"
#include "scene/layer_item.h"
#include "window/waypoints/waypoint_text.h"

namespace mapwright::window {

namespace {

constexpr double kHandleRadiusPx = 6;
constexpr double kTurnStep = geometry::radiansFromDegrees(15);  // with Ctrl
constexpr int kFarCells = 10;                                   // with Shift

/// To the millimetre: a hand is no more exact, and files stay readable.
Eigen::Vector2d exactEnough(const Eigen::Vector2d& at_m) {
  return {std::round(at_m.x() * 1000) / 1000, std::round(at_m.y() * 1000) / 1000};
}

QString metres(double value) { return QLocale::c().toString(value, 'f', 2); }

}  // namespace

WaypointTool::WaypointTool(WaypointEditing* editing, const scene::MapScene* scene, const HitList* hits,
                           QObject* parent)
    : MapTool(parent), editing_(editing), scene_(scene), hits_(hits) {
  const auto look_anew = [this] {
    Q_EMIT changed();
    Q_EMIT hintChanged();
  };
  connect(editing, &WaypointEditing::selectionChanged, this, look_anew);
  connect(editing, &WaypointEditing::previewChanged, this, look_anew);
  connect(editing, &WaypointEditing::opened, this, [this, look_anew] {
    dragCancelled();
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
}

std::optional<edit::Key> WaypointTool::under(const MapPoint& at) const {
  for (const Hit& hit : hits_->at(at.world_m, kReachPx)) {
    if (hit.layer == scene::Layer::Waypoints) return hit.key;
  }
  return std::nullopt;
}

std::optional<QPointF> WaypointTool::handle() const {
  if (!editing_->editable() || editing_->selected().size() != 1) return std::nullopt;
  const edit::Key& key = *editing_->selected().begin();
  const auto preview = editing_->preview().find(key);
  const map::Waypoint* const point =
      preview == editing_->preview().end() ? editing_->only() : &preview->second;
  if (!point) return std::nullopt;
  const double heading = point->yaw_rad.value_or(0) + scene_->view().rotation_rad;
  return scene::toPoint(scene_->view().pixelFromWorld(point->position_m)) +
         QPointF(std::cos(heading), -std::sin(heading)) * kHandlePx;
}

bool WaypointTool::onHandle(const MapPoint& at) const {
  const auto where = handle();
  return where && std::hypot(where->x() - at.px.x(), where->y() - at.px.y()) <= kReachPx;
}

bool WaypointTool::pressed(const MapPoint& at) {
  drag_ = Drag::None;
  nudging_ = 0;
  pressed_on_one_ = true;
  press_m_ = at.world_m;
  if (onHandle(at)) {
    grabbed_ = *editing_->selected().begin();
    drag_ = Drag::Turn;
    return true;
  }
  const auto key = under(at);
  if (!key) {
    pressed_on_one_ = false;
    return false;
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
  const map::Waypoint* const grabbed = editing_->find(grabbed_);
  if (drag_ == Drag::None || !grabbed) return;
  WaypointPreview preview;
  if (drag_ == Drag::Turn) {
    map::Waypoint to = *grabbed;
    const Eigen::Vector2d towards = at.world_m - to.position_m;
    if (towards.norm() <= 0) return;
    double yaw = std::atan2(towards.y(), towards.x());
    if (at.modifiers & Qt::ControlModifier) yaw = std::round(yaw / kTurnStep) * kTurnStep;
    to.yaw_rad = geometry::normalizeAngle(yaw);
    preview.emplace(grabbed_, std::move(to));
  } else {
    const Eigen::Vector2d free = grabbed->position_m + (at.world_m - press_m_);
    snapped_ = snap(*scene_, *hits_, free, at.modifiers, kReachPx, [this](const Hit& hit) {
      return hit.layer == scene::Layer::Waypoints && editing_->selected().contains(hit.key);
    });
    const Eigen::Vector2d there =
        snapped_.to == Snapped::To::Thing ? snapped_.world_m : exactEnough(snapped_.world_m);
    const Eigen::Vector2d by = there - grabbed->position_m;
    for (const edit::Key& key : editing_->selected()) {
      map::Waypoint to = *editing_->find(key);
      to.position_m += by;
      preview.emplace(key, std::move(to));
    }
  }
  editing_->setPreview(std::move(preview));
}

void WaypointTool::released(const MapPoint& at) {
  dragged(at);
  const Drag drag = std::exchange(drag_, Drag::None);
  const map::Waypoint* const one = editing_->find(grabbed_);
  const auto count = editing_->preview().size();
  if (one && count > 0) {
    const QString what = count == 1 ? shortWaypointName(*one) : waypointsText(qsizetype(count));
    editing_->applyPreview((drag == Drag::Turn ? tr("turn %1") : tr("move %1")).arg(what));
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
  if (pressed_on_one_) {
    if (!(at.modifiers & Qt::ShiftModifier) && under(at) == std::optional(grabbed_))
      editing_->select({grabbed_});
    return;
  }
  if (!editing_->editable()) {
    editing_->select({});
    return;
  }
  const Snapped where = snap(*scene_, *hits_, at.world_m, at.modifiers, 0, [](const Hit&) { return true; });
  const edit::Gesture gesture = editing_->newGesture();
  const edit::Key key = editing_->add(exactEnough(where.world_m), gesture);
  if (!key.empty()) Q_EMIT editing_->renameWanted(key, gesture);
}

void WaypointTool::hovered(const MapPoint& at) {
  const auto key = onHandle(at) ? std::optional(*editing_->selected().begin()) : under(at);
  if (std::exchange(hovered_, key) != key) Q_EMIT changed();
}

void WaypointTool::left() {
  if (std::exchange(hovered_, std::nullopt)) Q_EMIT changed();
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
  // Along the axis of the map that lies nearest to the key's direction.
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

void WaypointTool::paint(QPainter& painter) {
  const scene::MapTheme& theme = scene_->theme();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [key, to] : editing_->preview()) {
    const map::Waypoint* const from = editing_->find(key);
    if (!from || drag_ != Drag::Move) continue;
    const QPointF a = scene::toPoint(scene_->view().pixelFromWorld(from->position_m)),
                  b = scene::toPoint(scene_->view().pixelFromWorld(to.position_m));
    for (const auto& [color, width] : {std::pair(theme.text_halo, 3.5), std::pair(theme.accent, 1.5)}) {
      painter.setPen(QPen(color, width, Qt::DashLine, Qt::RoundCap));
      painter.drawLine(a, b);
    }
    painter.setPen(QPen(theme.accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(a, 4, 4);
    // Where it has caught something there is a cross.
    if (key == grabbed_ && snapped_.to != Snapped::To::Nothing) {
      painter.setPen(QPen(theme.measure, 1.5));
      painter.drawLine(b - QPointF(14, 0), b + QPointF(14, 0));
      painter.drawLine(b - QPointF(0, 14), b + QPointF(0, 14));
    }
  }
  const auto grip = handle();
  if (!grip || drag_ == Drag::Move) return;
  const map::Waypoint* const only = editing_->only();
  const bool has_heading = only->yaw_rad || drag_ == Drag::Turn;
  const QPointF from = scene::toPoint(scene_->view().pixelFromWorld(only->position_m));
  for (const auto& [color, width] : {std::pair(theme.text_halo, 3.5), std::pair(theme.accent, 1.5)}) {
    painter.setPen(QPen(color, width, has_heading ? Qt::SolidLine : Qt::DotLine, Qt::RoundCap));
    painter.drawLine(from, *grip);
  }
  painter.setPen(QPen(theme.accent, 2));
  painter.setBrush(has_heading ? QBrush(theme.accent) : QBrush(theme.text_halo));
  painter.drawEllipse(*grip, kHandleRadiusPx, kHandleRadiusPx);
}

QString WaypointTool::hint() const {
  if (!editing_->document()) return tr("There is no waypoint list here. Esc leaves.");
  if (!editing_->editable()) return editing_->whyNot();
  if (drag_ == Drag::Turn && editing_->preview().contains(grabbed_))
    return tr("Heading %1. Ctrl turns by 15°, Esc cancels.")
        .arg(yawText(editing_->preview().at(grabbed_).yaw_rad));
  if (drag_ == Drag::Move && editing_->preview().contains(grabbed_)) {
    const Eigen::Vector2d at = editing_->preview().at(grabbed_).position_m;
    return tr("%1, %2 m. Ctrl: to the grid, Alt: free, Esc cancels.").arg(metres(at.x()), metres(at.y()));
  }
  if (editing_->selected().empty()) return tr("Click adds a waypoint, drag moves one. Esc leaves.");
  return tr("Drag or arrows move, F2 renames, Delete deletes. Esc lets go.");
}

}  // namespace mapwright::window
