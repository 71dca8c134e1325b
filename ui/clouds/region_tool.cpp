#include "ui/clouds/region_tool.h"

#include <array>
#include <cmath>

#include <QPainter>

#include "scene/drawing.h"
#include "scene/lengths.h"

namespace mapwright::window {

RegionTool::RegionTool(const scene::MapScene* scene, QObject* parent) : MapTool(parent), scene_(scene) {}

void RegionTool::deactivate() { forget(); }

void RegionTool::forget() {
  from_.reset();
  to_.reset();
  tell();
}

void RegionTool::setShape(RegionShape shape) {
  shape_ = shape;
  forget();
}

bool RegionTool::pressed(const MapPoint& at) {
  from_ = at.world_m;
  to_.reset();
  return true;
}

void RegionTool::dragged(const MapPoint& at) {
  to_ = at.world_m;
  tell();
}

void RegionTool::released(const MapPoint& at) {
  const auto from = from_;
  forget();
  if (!from) return;
  geometry::WorldRect box;
  box.extend(*from);
  box.extend(at.world_m);
  const double radius = (at.world_m - *from).norm();
  if (shape_ == RegionShape::Sphere && radius > 0) {
    Q_EMIT sphereDrawn(*from, radius);
  } else if (shape_ == RegionShape::Box && box.width() > 0 && box.height() > 0) {
    Q_EMIT boxDrawn(box);
  }
}

void RegionTool::dragCancelled() { forget(); }

bool RegionTool::keyPressed(const MapKeyPress& press) {
  if (press.key != Qt::Key_Escape) return false;
  Q_EMIT finished();
  return true;
}

QString RegionTool::hint() const {
  if (!from_ || !to_) {
    return shape_ == RegionShape::Box
               ? tr("Drag a box to fetch its cloud. Esc leaves.")
               : tr("Drag from the centre of a sphere to its edge to fetch its cloud. Esc leaves.");
  }
  if (shape_ == RegionShape::Sphere) return tr("Radius %1").arg(scene::lengthText((*to_ - *from_).norm()));
  return tr("%1 x %2").arg(scene::lengthText(std::abs(to_->x() - from_->x())),
                           scene::lengthText(std::abs(to_->y() - from_->y())));
}

void RegionTool::paint(QPainter& painter) {
  if (!from_ || !to_) return;
  const geometry::ViewTransform& view = scene_->view();
  const auto px = [&view](double x, double y) { return scene::toPoint(view.pixelFromWorld({x, y})); };
  QColor pale = scene_->theme().accent;
  pale.setAlpha(40);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(scene_->theme().accent, 2));
  painter.setBrush(pale);
  if (shape_ == RegionShape::Sphere) {
    const double radius = (*to_ - *from_).norm() / view.scale_m_per_px;
    painter.drawEllipse(px(from_->x(), from_->y()), radius, radius);
  } else {
    const std::array corners{px(from_->x(), from_->y()), px(to_->x(), from_->y()), px(to_->x(), to_->y()),
                             px(from_->x(), to_->y())};
    painter.drawPolygon(corners.data(), int(corners.size()));
  }
  painter.restore();
}

}  // namespace mapwright::window

#include "moc_region_tool.cpp"
