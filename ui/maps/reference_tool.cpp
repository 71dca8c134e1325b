#include "ui/maps/reference_tool.h"

#include <utility>

namespace mapwright::ui {
namespace {

constexpr int kFarTimes = 10;  // with Shift
constexpr double kTurn_deg = 0.1;

/// Turned around a point that stays where it is.
geometry::Pose2 turnedAround(const Eigen::Vector2d& pivot_m, const geometry::Pose2& pose, double by_rad) {
  const Eigen::Vector2d at_m =
      pivot_m + geometry::Pose2{0, 0, by_rad}.apply(Eigen::Vector2d(pose.x_m, pose.y_m) - pivot_m);
  return {at_m.x(), at_m.y(), geometry::normalizeAngle(pose.yaw_rad + by_rad)};
}

}  // namespace

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
  nudging_ = false;
  DragTool::deactivate();
}

std::optional<geometry::Pose2> ReferenceTool::nudged(const MapKeyPress& press) const {
  if (pairing_ || press.modifiers & (Qt::ControlModifier | Qt::AltModifier)) return std::nullopt;
  const int times = press.modifiers & Qt::ShiftModifier ? kFarTimes : 1;
  switch (press.key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down: {
      const Eigen::Vector2d by = arrowStep(scene().view(), press.key) * grid_.resolution_m * times;
      return geometry::Pose2{pose_.x_m + by.x(), pose_.y_m + by.y(), pose_.yaw_rad};
    }
    case Qt::Key_BracketLeft:
    case Qt::Key_BracketRight:
    case Qt::Key_BraceLeft:
    case Qt::Key_BraceRight: {
      // Counter-clockwise on the left, as the keys that turn the view.
      const bool left = press.key == Qt::Key_BracketLeft || press.key == Qt::Key_BraceLeft;
      const double by_rad = geometry::radiansFromDegrees(kTurn_deg * times);
      return turnedAround(scene().view().center_m, pose_, left ? by_rad : -by_rad);
    }
    default:
      return std::nullopt;
  }
}

bool ReferenceTool::claims(const MapKeyPress& press) const { return nudged(press).has_value(); }

bool ReferenceTool::keyPressed(const MapKeyPress& press) {
  const auto to = nudged(press);
  if (!to) return DragTool::keyPressed(press);
  if (hold()) return true;
  if (!std::exchange(nudging_, true)) Q_EMIT taken();
  Q_EMIT moved(*to);
  return true;
}

bool ReferenceTool::grab(const MapPoint&) {
  nudging_ = false;
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
  Q_EMIT moved(turnedAround(pivot_m_, before_, by_rad));
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
        "Drag or use the arrows to move the reference map, Shift+drag or [ and ] to turn it around the "
        "middle "
        "of the view. Esc leaves.");
  if (first_m_) return tr("Click where this point is on the robot's map. Esc takes it back.");
  return tr("Click a point of the reference map, then where it is on the robot's map. Esc leaves.");
}

}  // namespace mapwright::ui

#include "moc_reference_tool.cpp"
