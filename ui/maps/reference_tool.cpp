#include "ui/maps/reference_tool.h"

namespace mapwright::window {

void ReferenceTool::setState(const map::GridReference& grid, const geometry::Pose2& world_from_map,
                             const std::vector<placing::PointPair>& pairs) {
  grid_ = grid;
  pose_ = world_from_map;
  pairs_ = pairs;
  Q_EMIT changed();
}

void ReferenceTool::setPairing(bool pairing) {
  if (pairing == pairing_) return;
  pairing_ = pairing;
  first_m_.reset();
  notifyChanged();
}

void ReferenceTool::deactivate() {
  first_m_.reset();
  cursor_m_.reset();
  DragTool::deactivate();
}

bool ReferenceTool::grab(const MapPoint&) {
  if (pairing_) return false;
  Q_EMIT taken();
  before_ = pose_;
  pivot_m_ = scene().view().center_m;
  return true;
}

void ReferenceTool::update(const MapPoint& at) {
  const MapPoint& from = hold()->from;
  if (!from.modifiers.testFlag(Qt::ShiftModifier)) {
    const Eigen::Vector2d by = at.world_m - from.world_m;
    Q_EMIT moved({before_.x_m + by.x(), before_.y_m + by.y(), before_.yaw_rad});
    return;
  }
  if (from.world_m == pivot_m_ || at.world_m == pivot_m_) return;
  const double by_rad = turnAround(pivot_m_, from.world_m, at.world_m);
  // The middle of the view stays where it is.
  const Eigen::Vector2d at_m =
      pivot_m_ + geometry::Pose2{0, 0, by_rad}.apply(Eigen::Vector2d(before_.x_m, before_.y_m) - pivot_m_);
  Q_EMIT moved({at_m.x(), at_m.y(), geometry::normalizeAngle(before_.yaw_rad + by_rad)});
}

void ReferenceTool::cancel() {
  if (pose_ != before_) Q_EMIT moved(before_);
}

void ReferenceTool::click(const MapPoint& at) {
  if (!pairing_) return;
  if (!first_m_) {
    if (!isOnMap(at.world_m))
      return Q_EMIT refused(tr("This is not on the reference map. Click one of its points first."));
    first_m_ = at.world_m;
  } else {
    const placing::PointPair pair{pose_.inverse().apply(*first_m_), at.world_m};
    first_m_.reset();
    Q_EMIT paired(pair);
  }
}

bool ReferenceTool::stepBack() {
  const bool any = first_m_.has_value();
  first_m_.reset();
  return any;
}

bool ReferenceTool::isOnMap(const Eigen::Vector2d& world_m) const {
  const Eigen::Vector2d cell = grid_.cellFromWorld(pose_.inverse().apply(world_m));
  const double reach = this->reach() / grid_.resolution_m;
  return cell.x() >= -reach && cell.y() >= -reach && cell.x() <= grid_.width + reach &&
         cell.y() <= grid_.height + reach;
}

void ReferenceTool::hovered(const MapPoint& at) {
  cursor_m_ = at.world_m;
  if (first_m_) Q_EMIT changed();
}

void ReferenceTool::paint(QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const auto drawPair = [&](const QPointF& from, const QPointF& to) {
    strokeWithHalo(painter, theme(), 2, [&] {
      painter.drawLine(from, to);
      painter.drawEllipse(from, 5, 5);
      painter.drawLine(to - QPointF(6, 0), to + QPointF(6, 0));
      painter.drawLine(to - QPointF(0, 6), to + QPointF(0, 6));
    });
  };
  for (const placing::PointPair& pair : pairs_) drawPair(px(pose_.apply(pair.on_map_m)), px(pair.in_world_m));
  if (first_m_) drawPair(px(*first_m_), px(cursor_m_.value_or(*first_m_)));
}

QString ReferenceTool::hint() const {
  if (!pairing_)
    return tr(
        "Drag to move the reference map, Shift+drag to turn it around the middle of the view. Esc leaves.");
  if (first_m_) return tr("Click where this point is on the robot's map. Esc takes it back.");
  return tr("Click a point of the reference map, then where it is on the robot's map. Esc leaves.");
}

}  // namespace mapwright::window

#include "moc_reference_tool.cpp"
