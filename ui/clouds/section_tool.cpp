#include "ui/clouds/section_tool.h"

#include <array>

#include <QPainter>
#include <QPainterPath>

#include "scene/drawing.h"
#include "scene/lengths.h"

namespace mapwright::window {

SectionTool::SectionTool(const scene::MapScene* scene, QObject* parent) : MapTool(parent), scene_(scene) {}

void SectionTool::deactivate() { mark_.reset(); }

bool SectionTool::pressed(const MapPoint& at) {
  before_ = line_;
  line_ = Line{at.world_m, at.world_m};
  return true;
}

void SectionTool::dragged(const MapPoint& at) {
  if (!line_) return;
  line_->to_m = at.world_m;
  tell();
}

void SectionTool::released(const MapPoint& at) {
  if (!line_) return;
  line_->to_m = at.world_m;
  if ((line_->to_m - line_->from_m).norm() > 0) {
    Q_EMIT lineDrawn(line_->from_m, line_->to_m);
  } else {
    line_ = before_;
  }
  tell();
}

void SectionTool::dragCancelled() {
  line_ = before_;
  tell();
}

bool SectionTool::keyPressed(const MapKeyPress& press) {
  if (press.key != Qt::Key_Escape) return false;
  if (line_) {
    forget();
  } else {
    Q_EMIT finished();
  }
  return true;
}

void SectionTool::setWidth(double metres) {
  width_m_ = metres;
  Q_EMIT changed();
}

void SectionTool::setMark(std::optional<double> along_m) {
  if (along_m == mark_) return;
  mark_ = along_m;
  Q_EMIT changed();
}

void SectionTool::forget() {
  if (!line_) return;
  line_.reset();
  before_.reset();
  mark_.reset();
  tell();
  Q_EMIT lineGone();
}

QString SectionTool::hint() const {
  if (!line_ || line_->from_m == line_->to_m)
    return tr("Drag a line to see a cross-section of the cloud. Esc leaves.");
  return tr("%1 long. Drag another line, or press Esc to remove it.")
      .arg(scene::lengthText((line_->to_m - line_->from_m).norm()));
}

void SectionTool::paint(QPainter& painter) {
  if (!line_ || line_->from_m == line_->to_m) return;
  const geometry::ViewTransform& view = scene_->view();
  const Eigen::Vector2d along = (line_->to_m - line_->from_m).normalized();
  const Eigen::Vector2d aside = Eigen::Vector2d(-along.y(), along.x()) * width_m_ / 2;
  const auto px = [&view](const Eigen::Vector2d& at) { return scene::toPoint(view.pixelFromWorld(at)); };
  const QColor color = scene_->theme().measure;
  QColor pale = color;
  pale.setAlpha(50);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 1, Qt::DashLine));
  painter.setBrush(pale);
  const std::array corners{px(line_->from_m + aside), px(line_->to_m + aside), px(line_->to_m - aside),
                           px(line_->from_m - aside)};
  painter.drawPolygon(corners.data(), int(corners.size()));
  painter.setPen(QPen(color, 2));
  const QPointF from = px(line_->from_m), to = px(line_->to_m);
  painter.drawLine(from, to);
  painter.setBrush(color);
  painter.drawEllipse(from, 4, 4);
  // The end has an arrow, which gives the direction of the section.
  const QLineF shaft(to, from);
  if (shaft.length() > 1) {
    QLineF wing(to, to + (from - to) * (10 / shaft.length()));
    for (const double turn : {25.0, -25.0}) {
      QLineF turned = wing;
      turned.setAngle(wing.angle() + turn);
      painter.drawLine(turned);
    }
  }
  if (mark_) painter.drawEllipse(px(line_->from_m + along * *mark_), 5, 5);
  painter.restore();
}

}  // namespace mapwright::window

#include "moc_section_tool.cpp"
