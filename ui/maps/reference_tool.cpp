#include "ui/maps/reference_tool.h"

#include <cmath>

#include <QPainter>

#include "scene/drawing.h"

namespace mapwright::window {

ReferenceTool::ReferenceTool(const scene::MapScene* scene, QObject* parent)
    : MapTool(parent), scene_(scene) {}

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
  tell();
}

void ReferenceTool::deactivate() {
  dragCancelled();
  first_m_.reset();
  cursor_m_.reset();
  Q_EMIT changed();
}

bool ReferenceTool::pressed(const MapPoint& at) {
  if (pairing_) return false;
  Q_EMIT taken();
  hold_ = Hold{pose_, at.world_m, scene_->view().center_m, at.modifiers.testFlag(Qt::ShiftModifier)};
  return true;
}

void ReferenceTool::dragged(const MapPoint& at) {
  if (!hold_) return;
  if (!hold_->turns) {
    const Eigen::Vector2d by = at.world_m - hold_->from_m;
    Q_EMIT moved({hold_->before.x_m + by.x(), hold_->before.y_m + by.y(), hold_->before.yaw_rad});
    return;
  }
  const Eigen::Vector2d a = hold_->from_m - hold_->pivot_m, b = at.world_m - hold_->pivot_m;
  if (a.norm() == 0 || b.norm() == 0) return;
  const double by_rad = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
  // The middle of the view stays where it is.
  const geometry::Pose2 turn{0, 0, by_rad};
  const Eigen::Vector2d at_m =
      hold_->pivot_m + turn.apply(Eigen::Vector2d(hold_->before.x_m, hold_->before.y_m) - hold_->pivot_m);
  Q_EMIT moved({at_m.x(), at_m.y(), geometry::normalizeAngle(hold_->before.yaw_rad + by_rad)});
}

void ReferenceTool::released(const MapPoint& at) {
  dragged(at);
  hold_.reset();
}

void ReferenceTool::dragCancelled() {
  if (!hold_) return;
  const geometry::Pose2 before = hold_->before;
  hold_.reset();
  Q_EMIT moved(before);
}

void ReferenceTool::clicked(const MapPoint& at) {
  hold_.reset();
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
  tell();
}

bool ReferenceTool::isOnMap(const Eigen::Vector2d& world_m) const {
  const Eigen::Vector2d cell = grid_.cellFromWorld(pose_.inverse().apply(world_m));
  const double reach = kReachPx * scene_->view().scale_m_per_px / grid_.resolution_m;
  return cell.x() >= -reach && cell.y() >= -reach && cell.x() <= grid_.width + reach &&
         cell.y() <= grid_.height + reach;
}

void ReferenceTool::hovered(const MapPoint& at) {
  cursor_m_ = at.world_m;
  if (first_m_) Q_EMIT changed();
}

bool ReferenceTool::keyPressed(const MapKeyPress& press) {
  if (press.key != Qt::Key_Escape) return false;
  if (!first_m_) {
    Q_EMIT finished();
    return true;
  }
  first_m_.reset();
  tell();
  return true;
}

void ReferenceTool::paint(QPainter& painter) {
  const auto px = [this](const Eigen::Vector2d& world) {
    return scene::toPoint(scene_->view().pixelFromWorld(world));
  };
  const scene::MapTheme& theme = scene_->theme();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const auto drawPair = [&](const QPointF& from, const QPointF& to) {
    for (const auto& [color, width] : {std::pair(theme.text_halo, 4.5), std::pair(theme.accent, 2.0)}) {
      painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(from, to);
      painter.drawEllipse(from, 5, 5);
      painter.drawLine(to - QPointF(6, 0), to + QPointF(6, 0));
      painter.drawLine(to - QPointF(0, 6), to + QPointF(0, 6));
    }
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
