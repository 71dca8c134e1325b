#include "ui/waypoints/line_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mapwright::ui {
namespace {

constexpr double kTickPx = 11;
constexpr std::size_t kMostLineTicks = 500;  // more could not be distinguished

}  // namespace

void LineTool::activate() {
  forget();
  Q_EMIT activated(true);
}

void LineTool::deactivate() {
  TwoPointTool::deactivate();
  Q_EMIT activated(false);
}

void LineTool::forget() {
  TwoPointTool::forget();
  Q_EMIT lineChanged();
}

void LineTool::setSpacing(double spacing_m) {
  const double fit = std::clamp(spacing_m, kLeastSpacingM, kMostSpacingM);
  if (std::exchange(spacing_m_, fit) == fit) return;
  notifyChanged();
  Q_EMIT lineChanged();
}

bool LineTool::keyPressed(const MapKeyPress& press) {
  switch (press.key) {
    case Qt::Key_Backspace:
      forget();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (ready()) Q_EMIT madeWanted();
      return true;
    default:
      return TwoPointTool::keyPressed(press);
  }
}

std::vector<placing::Spot> LineTool::spots() const {
  if (length() <= 0) return {};
  return placing::alongLine(line()->from_m, line()->to_m, spacing_m_);
}

void LineTool::paint(QPainter& painter) {
  TwoPointTool::paint(painter);
  if (!line()) return;
  strokeWithHalo(
      painter, theme(), 2, [&] { painter.drawLine(px(line()->from_m), px(line()->to_m)); },
      ended() ? Qt::SolidLine : Qt::DashLine);
  const std::vector<placing::Spot> spots = this->spots();
  // Each at its future position, with its heading.
  if (spots.size() > kMostLineTicks) return;
  for (const placing::Spot& spot : spots) {
    const QPointF at = px(spot.position_m);
    const double heading = *spot.yaw_rad + scene().view().rotation_rad;
    const QPointF ahead(std::cos(heading), -std::sin(heading));
    painter.setPen(QPen(theme().accent, 2));
    painter.drawLine(at, at + ahead * kTickPx);
    painter.setBrush(theme().text_halo);
    painter.drawEllipse(at, 4.5, 4.5);
  }
}

QString LineTool::hint() const {
  if (!line()) return tr("Waypoints along a line: click its start, or drag. Esc leaves.");
  if (!ended()) return tr("Click the end. Shift: steps of 15°, Alt: free, Esc starts over.");
  return tr("Enter creates them, Esc starts over.");
}

}  // namespace mapwright::ui

#include "moc_line_tool.cpp"
