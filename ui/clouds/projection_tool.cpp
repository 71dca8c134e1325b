#include "ui/clouds/projection_tool.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>

#include "scene/drawing.h"
#include "scene/lengths.h"

namespace mapwright::window {
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
    : MapTool(parent), scene_(scene), draft_(draft) {}

QCursor ProjectionTool::cursor() const {
  if (!editable_) return Qt::ArrowCursor;
  switch (under_) {
    case RectGrip::None:
      return Qt::CrossCursor;
    case RectGrip::Inside:
      return Qt::SizeAllCursor;
    case RectGrip::Left:
    case RectGrip::Right:
    case RectGrip::Bottom:
    case RectGrip::Top:
    case RectGrip::BottomLeft:
    case RectGrip::BottomRight:
    case RectGrip::TopLeft:
    case RectGrip::TopRight:
      break;
  }
  return Qt::PointingHandCursor;  // the view may be rotated: an arrow would point in a wrong direction
}

void ProjectionTool::setEditable(bool editable, bool takes) {
  if (editable == editable_ && takes == takes_) return;
  editable_ = editable;
  takes_ = takes;
  letGo();
}

void ProjectionTool::refresh() {
  if (hold_ && hold_->index >= int(draft_->wanted().size())) hold_.reset();
  tell();
}

void ProjectionTool::letGo() {
  hold_.reset();
  tell();
}

void ProjectionTool::deactivate() { letGo(); }

RectGrip ProjectionTool::gripOnChosen(const MapPoint& at) const {
  const map::Projection* const one = draft_->selectedOne();
  return one ? gripAt(*one, at.world_m, kReachPx * scene_->view().scale_m_per_px) : RectGrip::None;
}

/// Where they overlap, the one below the selected one: repeated clicks cycle through them.
std::optional<int> ProjectionTool::indexAt(const MapPoint& at) const {
  const auto& all = draft_->wanted();
  const int count = int(all.size());
  const double reach_m = kReachPx * scene_->view().scale_m_per_px;
  for (int i = 1; i <= count; ++i) {
    const int index = (draft_->selected().value_or(0) - i + 2 * count) % count;
    if (gripAt(all[std::size_t(index)], at.world_m, reach_m) != RectGrip::None) return index;
  }
  return std::nullopt;
}

bool ProjectionTool::pressed(const MapPoint& at) {
  if (!editable_) return false;
  hold_ = Hold{-1, gripOnChosen(at), {}, at.world_m, at.world_m};
  if (hold_->grip != RectGrip::None) {
    hold_->index = *draft_->selected();
    hold_->before = *draft_->selectedOne();
  }
  return true;
}

void ProjectionTool::dragged(const MapPoint& at) {
  if (!hold_) return;
  hold_->to_m = at.world_m;
  if (hold_->index >= 0) {
    Q_EMIT changedTo(hold_->index, moved(hold_->before, hold_->grip, at.world_m - hold_->from_m));
    return;
  }
  tell();
}

void ProjectionTool::released(const MapPoint& at) {
  const auto hold = hold_;
  letGo();
  if (!hold) return;
  if (hold->index >= 0) {
    Q_EMIT changedTo(hold->index, moved(hold->before, hold->grip, at.world_m - hold->from_m));
    return;
  }
  geometry::WorldRect rect;
  rect.extend(hold->from_m);
  rect.extend(at.world_m);
  if (rect.width() > 0 && rect.height() > 0) Q_EMIT drawn(rect);
}

void ProjectionTool::dragCancelled() {
  const auto hold = hold_;
  letGo();
  if (hold && hold->index >= 0) Q_EMIT changedTo(hold->index, hold->before);
}

void ProjectionTool::clicked(const MapPoint& at) {
  letGo();
  Q_EMIT chosen(indexAt(at));
}

void ProjectionTool::hovered(const MapPoint& at) {
  const RectGrip under = gripOnChosen(at);
  if (under == under_) return;
  under_ = under;
  Q_EMIT changed();
}

bool ProjectionTool::keyPressed(const MapKeyPress& press) {
  if (press.key == Qt::Key_Escape) {
    if (hold_) {
      dragCancelled();
    } else {
      Q_EMIT finished();
    }
    return true;
  }
  if (editable_ && !press.repeats && press.key == Qt::Key_Delete && draft_->selected()) {
    Q_EMIT removeWanted();
    return true;
  }
  return false;
}

QString ProjectionTool::hint() const {
  if (!editable_ && draft_->wanted().empty()) {
    return takes_ ? tr("Waiting for the robot. Esc leaves.")
                  : tr("Projections cannot be set on this robot, and there are none to select. Esc leaves.");
  }
  if (!takes_) return tr("Projections cannot be set on this robot: click one to select it. Esc leaves.");
  if (!editable_) return tr("Click a projection to select it. Esc leaves.");
  if (hold_ && hold_->index < 0 && hold_->from_m != hold_->to_m) {
    return tr("%1 x %2").arg(scene::lengthText(std::abs(hold_->to_m.x() - hold_->from_m.x())),
                             scene::lengthText(std::abs(hold_->to_m.y() - hold_->from_m.y())));
  }
  if (const map::Projection* const one = draft_->selectedOne()) {
    return tr("%1 x %2. Drag it or its edges; Delete removes it. Esc leaves.")
        .arg(scene::lengthText(one->size_m.x()), scene::lengthText(one->size_m.y()));
  }
  return tr("Drag a rectangle for a new projection, or click one to select it. Esc leaves.");
}

void ProjectionTool::paint(QPainter& painter) {
  const geometry::ViewTransform& view = scene_->view();
  const QColor accent = scene_->theme().accent;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  std::vector<QRectF> plates;
  const auto draw = [&](const geometry::WorldRect& rect, bool strong, const QString& tag) {
    const auto px = [&view](double x, double y) { return scene::toPoint(view.pixelFromWorld({x, y})); };
    const std::array corners{px(rect.min_x, rect.min_y), px(rect.max_x, rect.min_y),
                             px(rect.max_x, rect.max_y), px(rect.min_x, rect.max_y)};
    QColor pale = accent;
    pale.setAlpha(strong ? 50 : 16);
    painter.setBrush(pale);
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
  if (hold_ && hold_->index < 0 && hold_->from_m != hold_->to_m) {
    geometry::WorldRect rect;
    rect.extend(hold_->from_m);
    rect.extend(hold_->to_m);
    draw(rect, true, {});
  }
  painter.restore();
}

}  // namespace mapwright::window

#include "moc_projection_tool.cpp"
