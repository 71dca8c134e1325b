#include "ui/clouds/projection_tool.h"

#include <algorithm>
#include <array>

#include "ui/scene/lengths.h"

namespace mapwright::ui {
namespace {

constexpr double kTagPadPx = 3;

geometry::WorldRect rectOf(const map::Projection& one) {
  geometry::WorldRect rect;
  rect.extend(one.corner_m);
  rect.extend(Eigen::Vector2d(one.corner_m + one.size_m));
  return rect;
}

}  // namespace

ProjectionTool::ProjectionTool(const scene::MapScene* scene, const ProjectionDraft* draft, QObject* parent)
    : DragTool(scene, parent), draft_(draft) {}

QCursor ProjectionTool::cursor() const {
  if (!editable_) return Qt::ArrowCursor;
  if (under_ == RectGrip::None) return Qt::CrossCursor;
  // The view may be rotated: an arrow would point in a wrong direction.
  return under_ == RectGrip::Inside ? Qt::SizeAllCursor : Qt::PointingHandCursor;
}

void ProjectionTool::setEditable(bool editable, bool takes) {
  if (editable == editable_ && takes == takes_) return;
  editable_ = editable;
  takes_ = takes;
  grabbed_.reset();
  dragCancelled();
}

void ProjectionTool::refresh() {
  if (grabbed_ && grabbed_->index >= int(draft_->wanted().size())) grabbed_->index = -1;
  notifyChanged();
}

RectGrip ProjectionTool::gripOnChosen(const MapPoint& at) const {
  const map::Projection* const one = draft_->selectedOne();
  return one ? gripAt(*one, at.world_m, reach()) : RectGrip::None;
}

/// Where they overlap, the one below the selected one: repeated clicks cycle through them.
std::optional<int> ProjectionTool::indexAt(const MapPoint& at) const {
  const auto& all = draft_->wanted();
  const int count = int(all.size());
  for (int i = 1; i <= count; ++i) {
    const int index = (draft_->selected().value_or(0) - i + 2 * count) % count;
    if (gripAt(all[std::size_t(index)], at.world_m, reach()) != RectGrip::None) return index;
  }
  return std::nullopt;
}

bool ProjectionTool::grab(const MapPoint& at) {
  grabbed_.reset();
  if (!editable_) return false;
  if (const RectGrip grip = gripOnChosen(at); grip != RectGrip::None)
    grabbed_ = Grabbed{*draft_->selected(), grip, *draft_->selectedOne()};
  return true;
}

void ProjectionTool::update(const MapPoint& at) {
  if (!grabbed_ || grabbed_->index < 0) return;
  Q_EMIT changedTo(grabbed_->index,
                   moved(grabbed_->before, grabbed_->grip, at.world_m - hold()->from.world_m));
}

void ProjectionTool::finish(const MapPoint&) {
  const geometry::WorldRect rect = newOne();
  if (rect.width() > 0 && rect.height() > 0) Q_EMIT drawn(rect);
}

void ProjectionTool::cancel() {
  if (grabbed_ && grabbed_->index >= 0) Q_EMIT changedTo(grabbed_->index, grabbed_->before);
}

geometry::WorldRect ProjectionTool::newOne() const {
  geometry::WorldRect rect;
  if (!dragging() || grabbed_) return rect;
  rect.extend(hold()->from.world_m);
  rect.extend(hold()->to.world_m);
  return rect;
}

void ProjectionTool::hovered(const MapPoint& at) {
  const RectGrip under = gripOnChosen(at);
  if (under == under_) return;
  under_ = under;
  Q_EMIT changed();
}

bool ProjectionTool::keyPressed(const MapKeyPress& press) {
  if (editable_ && !press.repeats && press.key == Qt::Key_Delete && draft_->selected()) {
    Q_EMIT removeWanted();
    return true;
  }
  return DragTool::keyPressed(press);
}

QString ProjectionTool::hint() const {
  if (!editable_ && draft_->wanted().empty()) {
    return takes_ ? tr("Waiting for the robot. Esc leaves.")
                  : tr("Projections cannot be set on this robot, and there are none to select. Esc leaves.");
  }
  if (!takes_) return tr("Projections cannot be set on this robot: click one to select it. Esc leaves.");
  if (!editable_) return tr("Click a projection to select it. Esc leaves.");
  if (const geometry::WorldRect rect = newOne(); rect.width() > 0 || rect.height() > 0)
    return tr("%1 x %2").arg(scene::lengthText(rect.width()), scene::lengthText(rect.height()));
  if (const map::Projection* const one = draft_->selectedOne()) {
    return tr("%1 x %2. Drag it or its edges; Delete removes it. Esc leaves.")
        .arg(scene::lengthText(one->size_m.x()), scene::lengthText(one->size_m.y()));
  }
  return tr("Drag a rectangle for a new projection, or click one to select it. Esc leaves.");
}

void ProjectionTool::paint(QPainter& painter) {
  const QColor accent = theme().accent;
  painter.setRenderHint(QPainter::Antialiasing);
  std::vector<QRectF> plates;
  const auto draw = [&](const geometry::WorldRect& rect, bool strong, const QString& tag) {
    const std::array corners{px({rect.min_x, rect.min_y}), px({rect.max_x, rect.min_y}),
                             px({rect.max_x, rect.max_y}), px({rect.min_x, rect.max_y})};
    painter.setBrush(scene::translucent(accent, strong ? 50 : 16));
    painter.setPen(QPen(accent, strong ? 2.5 : 1.5, strong ? Qt::SolidLine : Qt::DashLine));
    painter.drawPolygon(corners.data(), int(corners.size()));
    if (strong && editable_) {
      painter.setBrush(accent);
      painter.setPen(Qt::NoPen);
      for (const QPointF& corner : corners) painter.drawEllipse(corner, 4, 4);
    }
    if (tag.isEmpty()) return;
    const QFontMetricsF metrics(painter.font());
    QRectF plate(corners[3].x() + 6, corners[3].y() + 6, metrics.horizontalAdvance(tag) + 2 * kTagPadPx,
                 metrics.height() + 2 * kTagPadPx);
    // Overlapping labels are placed side by side.
    while (std::any_of(plates.begin(), plates.end(),
                       [&plate](const QRectF& other) { return other.intersects(plate); }))
      plate.translate(plate.width() + 2, 0);
    plates.push_back(plate);
    painter.setPen(Qt::NoPen);
    painter.setBrush(accent);
    painter.drawRoundedRect(plate, 3, 3);
    painter.setPen(accent.lightnessF() > 0.6F ? Qt::black : Qt::white);
    painter.drawText(plate, Qt::AlignCenter, tag);
  };
  const auto& all = draft_->wanted();
  for (int i = 0; i < int(all.size()); ++i) {
    if (draft_->selected() != i) draw(rectOf(all[std::size_t(i)]), false, QString::number(i));
  }
  if (const map::Projection* const one = draft_->selectedOne()) {
    draw(rectOf(*one), true, QString::number(*draft_->selected()));
  }
  if (const geometry::WorldRect rect = newOne(); rect.width() > 0 || rect.height() > 0) draw(rect, true, {});
}

}  // namespace mapwright::ui

#include "moc_projection_tool.cpp"
