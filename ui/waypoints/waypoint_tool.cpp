#include "ui/waypoints/waypoint_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QLocale>

#include "geometry/pose.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/fixed.h"

namespace mapwright::ui {
namespace {

constexpr int kFarCells = 10;  // with Shift

constexpr double kHandleRadiusPx = 6;
constexpr double kInsidePx = 16;            // minimum distance of handles from the edge of the map
constexpr std::size_t kMostTraces = 2'000;  // with more, individual paths are not drawn

QString metresOf(double value) { return words::fixed(value, 2); }

}  // namespace

WaypointTool::WaypointTool(WaypointEditing* editing, const scene::MapScene* scene, const HitList* hits,
                           WaypointSnapping* snapping, QObject* parent)
    : DragTool(scene, parent), editing_(editing), hits_(hits), snapping_(snapping) {
  const auto look_anew = [this] {
    group_.reset();
    notifyChanged();
  };
  connect(editing, &WaypointEditing::selectionChanged, this, look_anew);
  connect(editing, &WaypointEditing::previewChanged, this, look_anew);
  connect(editing, &WaypointEditing::opened, this, [this, look_anew] {
    dragCancelled();
    if (editing_->document())
      connect(editing_->document(), &edit::WaypointDocument::changed, this, [this] {
        group_.reset();
        Q_EMIT changed();
      });
    look_anew();
  });
}

QCursor WaypointTool::cursor() const {
  if (drag() != Drag::None) return Qt::ClosedHandCursor;
  if (hovered_) return Qt::PointingHandCursor;
  return editing_->editable() ? Qt::CrossCursor : Qt::ArrowCursor;
}

void WaypointTool::deactivate() {
  DragTool::deactivate();
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

bool WaypointTool::grab(const MapPoint& at) {
  drag_ = Drag::None;
  nudging_ = 0;
  pressed_on_one_ = true;
  landing_.reset();
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

void WaypointTool::update(const MapPoint& at) {
  if (drag_ == Drag::Move) move(at);
  if (drag_ == Drag::Turn) turn(at);
  if (drag_ == Drag::TurnGroup) turnGroup(at);
}

void WaypointTool::move(const MapPoint& at) {
  const map::Waypoint* const grabbed = editing_->find(grabbed_);
  if (!grabbed) return;
  const Eigen::Vector2d free = grabbed->position_m + (at.world_m - hold()->from.world_m);
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
  if (at.world_m == pivot) return;
  double by = turnAround(pivot, hold()->from.world_m, at.world_m);
  if (at.modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) by = snapping_->heading(by, at.modifiers);
  turned_by_rad_ = by;
  spots = placing::turned(std::move(spots), pivot, by);
  WaypointPreview preview;
  std::size_t i = 0;
  for (const edit::Key& key : keys) preview.emplace_hint(preview.end(), key, spots[i++]);
  editing_->setPreview(std::move(preview));
}

std::set<edit::Key> WaypointTool::inFrame() const {
  const geometry::ViewTransform& view = scene().view();
  const QRectF frame = this->frame();
  geometry::WorldRect around;  // for a rotated view more than the frame
  for (const QPointF& corner : {frame.topLeft(), frame.topRight(), frame.bottomLeft(), frame.bottomRight()})
    around.extend(view.worldFromPixel({corner.x(), corner.y()}));
  std::set<edit::Key> keys;
  hits_->within(around, [&](const Hit& hit) {
    if (hit.layer == scene::Layer::Waypoints && frame.contains(px(hit.world_m))) keys.insert(hit.key);
  });
  return keys;
}

void WaypointTool::finish(const MapPoint&) {
  snapped_ = {};
  if (drag_ == Drag::Frame) {
    std::set<edit::Key> keys = inFrame();
    keys.insert(editing_->selected().begin(), editing_->selected().end());
    return editing_->select(std::move(keys));
  }
  const map::Waypoint* const one = editing_->find(grabbed_);
  const auto count = editing_->preview().size();
  if (one && count > 0) {
    const QString what = count == 1 ? shortWaypointName(*one) : waypointsText(qsizetype(count));
    editing_->applyPreview((drag_ == Drag::Move ? tr("move %1") : tr("turn %1")).arg(what));
  }
}

void WaypointTool::cancel() {
  snapped_ = {};
  editing_->setPreview({});
}

void WaypointTool::click(const MapPoint& at) {
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
  if (!editing_->editable() || editing_->selected().empty()) return false;
  if (nudging_ == 0 || nudged_ != editing_->selected()) {
    nudging_ = editing_->newGesture();
    nudged_ = editing_->selected();
  }
  editing_->moveSelected(arrowStep(scene().view(), press.key) * editing_->cell() *
                             (press.modifiers & Qt::ShiftModifier ? kFarCells : 1),
                         nudging_);
  return true;
}

bool WaypointTool::stepBack() {
  const bool any = !editing_->selected().empty();
  editing_->select({});
  return any;
}

bool WaypointTool::keyPressed(const MapKeyPress& press) {
  switch (press.key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      if (drag() == Drag::None) editing_->removeSelected();
      return true;
    case Qt::Key_F2:
      if (editing_->editable() && editing_->only())
        Q_EMIT editing_->renameWanted(*editing_->selected().begin(), 0);
      if (editing_->selected().size() > 1) Q_EMIT editing_->renameSeveralWanted();
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return hold() || nudge(press);
    default:
      return DragTool::keyPressed(press);
  }
}

const WaypointTool::Group& WaypointTool::group() const {
  if (!group_) {
    group_.emplace();
    std::vector<placing::Spot> spots;
    for (const edit::Key& key : editing_->selected()) {
      const auto spot = editing_->spotOf(key);
      if (!spot) continue;
      group_->bounds.extend(spot->position_m);
      spots.push_back(*spot);
    }
    group_->pivot_m = placing::middleOf(spots);
  }
  return *group_;
}

std::optional<QPointF> WaypointTool::handle() const {
  if (!editing_->editable() || editing_->selected().empty()) return std::nullopt;
  if (editing_->selected().size() > 1) {
    if (drag() == Drag::TurnGroup) return hold()->to.px;
    if (group().bounds.empty()) return std::nullopt;
    return turnHandle(scene().view(), group().bounds, group().pivot_m, kHandlePx);
  }
  const auto point = editing_->spotOf(*editing_->selected().begin());
  if (!point) return std::nullopt;
  const double heading = point->yaw_rad.value_or(0) + scene().view().rotation_rad;
  return px(point->position_m) + QPointF(std::cos(heading), -std::sin(heading)) * kHandlePx;
}

std::vector<QRectF> WaypointTool::covered() const {
  const auto grip = handle();
  if (!grip) return {};
  std::vector<QRectF> areas{scene::squareAround(*grip, kHandleRadiusPx + 2)};
  if (const map::Waypoint* const only = editing_->only()) {
    const QPointF from = px(only->position_m);
    areas.push_back(scene::squareAround((from + *grip) / 2, kHandleRadiusPx));  // of its line
  }
  return areas;
}

void WaypointTool::paint(QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  const Drag drag = this->drag();
  if (drag == Drag::Frame) return paintFrame(painter, theme(), frame());
  if (drag == Drag::Move || drag == Drag::TurnGroup) paintMoved(painter);
  if (drag == Drag::Move) return snapping_->paint(painter, snapped_);
  if (landing_ && drag == Drag::None) snapping_->paint(painter, *landing_);
  const auto grip = handle();
  if (!grip) return;
  editing_->only() ? paintHeading(painter, *grip) : paintGroup(painter, *grip);
}

void WaypointTool::paintMoved(QPainter& painter) const {
  if (editing_->preview().size() > kMostTraces) return;
  for (const auto& [key, to] : editing_->preview()) {
    const map::Waypoint* const from = editing_->find(key);
    if (!from) continue;
    const QPointF a = px(from->position_m);
    lineWithHalo(painter, theme(), a, px(to.position_m), Qt::DashLine);
    painter.setPen(QPen(theme().accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(a, 4, 4);
  }
}

void WaypointTool::paintHeading(QPainter& painter, const QPointF& grip) const {
  const map::Waypoint* const only = editing_->only();
  const bool has_heading = only->yaw_rad || drag() == Drag::Turn;
  lineWithHalo(painter, theme(), px(only->position_m), grip, has_heading ? Qt::SolidLine : Qt::DotLine);
  painter.setPen(QPen(theme().accent, 2));
  painter.setBrush(has_heading ? theme().accent : theme().text_halo);
  painter.drawEllipse(grip, kHandleRadiusPx, kHandleRadiusPx);
}

void WaypointTool::paintGroup(QPainter& painter, const QPointF& grip) const {
  const QPointF pivot = px(group().pivot_m);
  lineWithHalo(painter, theme(), pivot, grip, Qt::DotLine);
  painter.setPen(QPen(theme().accent, 1.5));
  painter.setBrush(theme().text_halo);
  painter.drawEllipse(pivot, 3, 3);
  paintGrip(painter, theme(), grip, kHandleRadiusPx + 1);
  // A circular arrow: for rotation.
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme().accent, 1.5, Qt::SolidLine, Qt::RoundCap));
  const QRectF ring(grip - QPointF(3.5, 3.5), QSizeF(7, 7));
  painter.drawArc(ring, 40 * 16, 280 * 16);
  painter.drawLine(grip + QPointF(2.7, -2.2), grip + QPointF(4.4, -4.2));
}

QString WaypointTool::hint() const {
  if (!editing_->document()) return tr("There is no waypoint list here. Esc leaves.");
  if (drag() == Drag::Frame)
    return tr("%1 in the frame. Esc cancels.").arg(waypointsText(qsizetype(inFrame().size())));
  if (!editing_->editable()) return editing_->unavailableReason();
  if (drag() == Drag::TurnGroup)
    return tr("Turned by %1. Shift turns by 15°, Esc cancels.").arg(yawText(turned_by_rad_));
  if (drag() == Drag::Turn && editing_->preview().contains(grabbed_))
    return tr("Heading %1. Shift turns by 15°, Esc cancels.")
        .arg(yawText(editing_->preview().at(grabbed_).yaw_rad));
  if (drag() == Drag::Move && editing_->preview().contains(grabbed_)) {
    const Eigen::Vector2d at = editing_->preview().at(grabbed_).position_m;
    return tr("%1, %2 m. Ctrl: snap to the grid, Alt: no snapping, Esc cancels.")
        .arg(metresOf(at.x()), metresOf(at.y()));
  }
  if (editing_->selected().empty())
    return tr("Click to add a waypoint, drag to move one, Shift and drag to select several. Esc leaves.");
  const bool deletes = editing_->notRemovedReason().isEmpty();
  if (editing_->selected().size() > 1)
    return (deletes ? tr("%1: drag or use the arrows to move, drag the handle to turn, F2 renames, Delete "
                         "deletes. Esc deselects.")
                    : tr("%1: drag or use the arrows to move, drag the handle to turn, F2 renames. Esc "
                         "deselects."))
        .arg(waypointsText(qsizetype(editing_->selected().size())));
  return deletes ? tr("Drag or use the arrows to move, F2 renames, Delete deletes. Esc deselects.")
                 : tr("Drag or use the arrows to move, F2 renames. Esc deselects.");
}

}  // namespace mapwright::ui

#include "moc_waypoint_tool.cpp"
