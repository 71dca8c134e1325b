#include "ui/waypoints/mirror_tool.h"

#include "ui/waypoints/waypoint_text.h"

namespace mapwright::ui {

MirrorTool::MirrorTool(WaypointEditing* editing, const scene::MapScene* scene, WaypointSnapping* snapping,
                       QObject* parent)
    : TwoPointTool(scene, snapping, parent), editing_(editing) {}

void MirrorTool::activate() {
  forget();
  Q_EMIT activated();
}

void MirrorTool::forget() {
  if (line()) editing_->setPreview({});
  TwoPointTool::forget();
}

void MirrorTool::lineMoved() {
  WaypointPreview preview;
  if (line()->length() > 0 && editing_->editable()) {
    const std::vector<edit::Key> keys(editing_->selected().begin(), editing_->selected().end());
    const auto spots = placing::mirrored(editing_->spots(keys), line()->from_m, line()->heading());
    for (std::size_t i = 0; i < keys.size(); ++i) preview.emplace_hint(preview.end(), keys[i], spots[i]);
  }
  editing_->setPreview(std::move(preview));
}

void MirrorTool::lineDrawn() {
  const auto count = qsizetype(editing_->preview().size());
  if (count > 0) editing_->applyPreview(tr("mirror %1").arg(waypointsText(count)));
  forget();
  if (count > 0) Q_EMIT ended();
}

void MirrorTool::paint(QPainter& painter) {
  TwoPointTool::paint(painter);
  if (!line()) return;
  const QPointF a = px(line()->from_m), b = px(line()->to_m);
  const QLineF drawn(a, b);
  // A mirror has no ends.
  QLineF whole = drawn;
  if (drawn.length() > 0) {
    const QPointF far = drawn.unitVector().p2() - drawn.p1();
    const double reach = scene().view().width_px + scene().view().height_px;
    whole = QLineF(a - far * reach, a + far * reach);
  }
  lineWithHalo(painter, theme(), whole.p1(), whole.p2(), Qt::DashLine);
  painter.setPen(QPen(theme().accent, 1.5));
  painter.setBrush(theme().text_halo);
  for (const QPointF& end : {a, b}) painter.drawEllipse(end, 4, 4);
}

QString MirrorTool::hint() const {
  if (editing_->selected().empty()) return tr("Select waypoints first. Esc leaves.");
  return line() ? tr("Click a second point of the mirror line. Shift: steps of 15°, Esc starts over.")
                : tr("Mirror %1: click a point of the mirror line, or drag along it. Esc leaves.")
                      .arg(waypointsText(qsizetype(editing_->selected().size())));
}

}  // namespace mapwright::ui

#include "moc_mirror_tool.cpp"
