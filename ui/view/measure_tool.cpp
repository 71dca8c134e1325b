#include "ui/view/measure_tool.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>

namespace mapwright::window {

double polylineLength(const std::vector<Eigen::Vector2d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

QString lengthText(double metres) {
  if (!std::isfinite(metres)) return QStringLiteral("?");
  const QLocale c = QLocale::c();
  if (metres >= 10'000)
    return QCoreApplication::translate("window", "%1 km").arg(c.toString(metres / 1000, 'f', 3));
  const int decimals = metres < 100 ? 3 : metres < 1000 ? 2 : 1;
  return QStringLiteral("%1 m").arg(c.toString(metres, 'f', decimals));
}

MeasureTool::MeasureTool(scene::MapScene* scene, QObject* parent) : MapTool(parent), scene_(scene) {}

void MeasureTool::activate() { show(); }

void MeasureTool::deactivate() {
  points_.clear();
  live_.reset();
  ended_ = false;
  show();
}

void MeasureTool::clicked(const MapPoint& at) {
  if (ended_) {
    points_.clear();
    ended_ = false;
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
      points_.pop_back();
      ended_ = false;
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
  scene_->setMeasurement(std::move(points));
  Q_EMIT hintChanged();
}

QString MeasureTool::hint() const {
  if (points_.empty()) return tr("Click where to start measuring. Esc leaves.");
  if (ended_) {
    return tr("Total %1. Click to start a new measurement, Esc leaves.").arg(lengthText(total()));
  }
  if (!live_) return tr("Total %1. Backspace removes the last point, Esc ends.").arg(lengthText(total()));
  const double leg = (*live_ - points_.back()).norm();
  if (points_.size() == 1) {
    return tr("%1. Click to add a point, Esc leaves.").arg(lengthText(leg));
  }
  return tr("%1, total %2. Backspace removes the last point, Esc ends.")
      .arg(lengthText(leg), lengthText(total() + leg));
}

}  // namespace mapwright::window

#include "moc_measure_tool.cpp"
