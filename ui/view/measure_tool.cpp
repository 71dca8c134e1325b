#include "ui/view/measure_tool.h"

#include <cmath>

#include "geometry/polyline.h"
#include "ui/kit/status_text.h"
#include "ui/scene/lengths.h"

namespace mapwright::ui {

using scene::areaText;
using scene::lengthText;

MeasureTool::MeasureTool(scene::MapScene* scene, QObject* parent) : MapTool(parent), scene_(scene) {}

void MeasureTool::activate() { show(); }

void MeasureTool::deactivate() {
  points_.clear();
  live_.reset();
  ended_ = closed_ = false;
  show();
}

bool MeasureTool::onFirst(const Eigen::Vector2d& world_m) const {
  return points_.size() > 2 && (points_.front() - world_m).norm() <= kReachPx * scene_->view().scale_m_per_px;
}

void MeasureTool::clicked(const MapPoint& at) {
  if (ended_) {
    points_.clear();
    ended_ = closed_ = false;
  }
  if (onFirst(at.world_m)) {
    closed_ = true;
    return end();
  }
  points_.push_back(at.world_m);
  live_ = at.world_m;
  show();
}

void MeasureTool::hovered(const MapPoint& at) {
  if (ended_ || points_.empty()) return;
  live_ = at.world_m;
  show();
}

void MeasureTool::left() {
  if (!live_) return;
  live_.reset();
  show();
}

bool MeasureTool::doubleClicked(const MapPoint&) {
  // The first click of the two has already set the point.
  end();
  return true;
}

bool MeasureTool::keyPressed(const MapKeyPress& press) {
  switch (press.key) {
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      if (points_.empty()) return true;
      // A ring is opened first.
      if (!closed_) points_.pop_back();
      ended_ = closed_ = false;
      show();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      end();
      return true;
    case Qt::Key_Escape:
      if (ended_ || points_.size() < 2) {
        Q_EMIT finished();
      } else {
        end();
      }
      return true;
    default:
      return false;
  }
}

void MeasureTool::end() {
  live_.reset();
  ended_ = points_.size() >= 2;
  show();
}

void MeasureTool::show() {
  std::vector<Eigen::Vector2d> points = points_;
  if (!points.empty() && live_ && !ended_) points.push_back(*live_);
  scene_->setMeasurement(std::move(points), closed_);
  Q_EMIT hintChanged();
}

double MeasureTool::total() const {
  const double around = closed_ ? (points_.front() - points_.back()).norm() : 0;
  return geometry::lengthOf(points_) + around;
}

QString MeasureTool::hint() const {
  if (points_.empty()) return tr("Click where to start measuring. Esc leaves.");
  if (closed_) {
    return tr("Area %1, around it %2. Click to start a new measurement, Esc leaves.")
        .arg(areaText(std::abs(geometry::signedAreaOf(points_))), lengthText(total()));
  }
  if (ended_) {
    return tr("Total %1. Click to start a new measurement, Esc leaves.").arg(lengthText(total()));
  }
  if (!live_) return tr("Total %1. Backspace removes the last point, Esc ends.").arg(lengthText(total()));
  if (onFirst(*live_)) return tr("Click to close the ring and see its area.");
  const Eigen::Vector2d leg = *live_ - points_.back();
  const QString heading = rotationText(std::atan2(leg.y(), leg.x()));
  if (points_.size() == 1)
    return tr("%1, heading %2. Click to add a point, Esc leaves.").arg(lengthText(leg.norm()), heading);
  return tr("%1, heading %2, total %3. Backspace removes the last point, Esc ends.")
      .arg(lengthText(leg.norm()), heading, lengthText(total() + leg.norm()));
}

}  // namespace mapwright::ui

#include "moc_measure_tool.cpp"
