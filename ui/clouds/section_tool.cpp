#include "ui/clouds/section_tool.h"

#include <array>

#include "ui/scene/lengths.h"

namespace mapwright::ui {

void SectionTool::deactivate() {
  DragTool::deactivate();
  mark_.reset();
}

std::optional<SectionTool::Line> SectionTool::line() const {
  if (!dragging() || hold()->from.world_m == hold()->to.world_m) return line_;
  return Line{hold()->from.world_m, hold()->to.world_m};
}

void SectionTool::finish(const MapPoint&) {
  line_ = line();
  if (line_) Q_EMIT lineDrawn(line_->from_m, line_->to_m);
}

bool SectionTool::stepBack() {
  const bool any = line_.has_value();
  forget();
  return any;
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
  mark_.reset();
  notifyChanged();
  Q_EMIT lineGone();
}

QString SectionTool::hint() const {
  const auto drawn = line();
  if (!drawn) return tr("Drag a line to see a cross-section of the cloud. Esc leaves.");
  return tr("%1 long. Drag another line, or press Esc to remove it.")
      .arg(scene::lengthText((drawn->to_m - drawn->from_m).norm()));
}

void SectionTool::paint(QPainter& painter) {
  const auto drawn = line();
  if (!drawn) return;
  const Eigen::Vector2d along = (drawn->to_m - drawn->from_m).normalized();
  const Eigen::Vector2d aside = Eigen::Vector2d(-along.y(), along.x()) * width_m_ / 2;
  const QColor color = theme().measure;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 1, Qt::DashLine));
  painter.setBrush(scene::translucent(color, 50));
  const std::array corners{px(drawn->from_m + aside), px(drawn->to_m + aside), px(drawn->to_m - aside),
                           px(drawn->from_m - aside)};
  painter.drawPolygon(corners.data(), int(corners.size()));
  painter.setPen(QPen(color, 2));
  const QPointF from = px(drawn->from_m), to = px(drawn->to_m);
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
  if (mark_) painter.drawEllipse(px(drawn->from_m + along * *mark_), 5, 5);
}

}  // namespace mapwright::ui

#include "moc_section_tool.cpp"
