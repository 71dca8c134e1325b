#include "ui/overlays/overlay_snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QPainter>

#include "grids/grid_pyramid.h"
#include "render/sample_grid.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/drawing.h"
#include "ui/view/map_tool.h"

namespace mapwright::ui {
namespace {

using overlays::SnapKinds;
using overlays::Snapped;
using overlays::SnapTo;

constexpr double kFinestGridM = 0.01, kCoarsestGridM = 100;

// By their names in the settings.
constexpr std::array<std::pair<const char*, bool SnapKinds::*>, 5> kSnapKinds{
    {{"vertices", &SnapKinds::vertices},
     {"edges", &SnapKinds::edges},
     {"grid", &SnapKinds::grid},
     {"angles", &SnapKinds::angles},
     {"walls", &SnapKinds::walls}}};

QString snapKey(const char* name) { return QStringLiteral("overlaySnap/") + QLatin1String(name); }

placing::PlacedMap mapBelow(const scene::MapScene& scene) {
  const auto whole = scene.wholeMap();
  if (!whole || !whole->cells || !whole->cells->complete()) return {};
  return {whole->cells, whole->reference};
}

}  // namespace

OverlaySnapping::OverlaySnapping(edit::OverlayEditing* editing, const scene::MapScene* scene,
                                 const OverlaysOnMap* on_map, QObject* parent)
    : QObject(parent), editing_(editing), scene_(scene), on_map_(on_map) {
  connect(editing_, &edit::OverlayEditing::changed, this, [this] { index_.reset(); });
  connect(editing_, &edit::OverlayEditing::previewChanged, this, [this] {
    // What was being dragged is where it was again.
    if (editing_->preview().empty()) index_.reset();
  });
}

void OverlaySnapping::setOn(bool on) {
  if (std::exchange(on_, on) != on) Q_EMIT changed();
}

void OverlaySnapping::setKinds(const SnapKinds& kinds) {
  SnapKinds fit = kinds;
  fit.grid_m = std::isfinite(fit.grid_m) ? std::clamp(fit.grid_m, kFinestGridM, kCoarsestGridM) : 0.5;
  if (kinds_ == fit) return;
  kinds_ = fit;
  Q_EMIT changed();
}

void OverlaySnapping::recall(const QSettings& settings) {
  SnapKinds kinds;
  for (const auto& [name, kind] : kSnapKinds)
    kinds.*kind = settings.value(snapKey(name), kinds.*kind).toBool();
  kinds.grid_m = settings.value(snapKey("grid_m"), kinds.grid_m).toDouble();
  setKinds(kinds);
  setOn(settings.value(snapKey("on"), true).toBool());
}

void OverlaySnapping::remember(QSettings& settings) const {
  settings.setValue(snapKey("on"), on_);
  for (const auto& [name, kind] : kSnapKinds) settings.setValue(snapKey(name), kinds_.*kind);
  settings.setValue(snapKey("grid_m"), kinds_.grid_m);
}

const overlays::SnapIndex& OverlaySnapping::index() {
  if (!index_) {
    index_.emplace();
    on_map_->eachShape(
        [this](FeatureKey key, const std::vector<overlays::Path>& paths) { index_->add(key, paths); });
    index_->finish();
  }
  return *index_;
}

Snapped OverlaySnapping::place(const Eigen::Vector2d& free_m, Qt::KeyboardModifiers modifiers,
                               const std::set<FeatureKey>& ignored, std::vector<Eigen::Vector2d> arms_m,
                               double angle_step_deg) {
  if (!on_ || modifiers & Qt::AltModifier) return {free_m};
  overlays::SnapScene around;
  if (kinds_.vertices || kinds_.edges) around.index = &index();
  around.ignored = [&ignored](FeatureKey key) { return ignored.contains(key); };
  around.arms_m = std::move(arms_m);
  around.angle_step_deg = angle_step_deg;
  if (kinds_.walls) {
    const placing::PlacedMap under = mapBelow(*scene_);
    if (!ground_ || !(ground_->map() == under)) ground_.emplace(under, placing::Ground::Access::AtHand);
    around.ground = &*ground_;
  }
  return overlays::snapped(free_m, MapTool::kReachPx * scene_->view().scale_m_per_px, kinds_, around);
}

QString OverlaySnapping::hintOf(SnapTo to) {
  const auto hint = [](const QString& what) { return tr("Snapped to %1 (Alt: not). ").arg(what); };
  switch (to) {
    case SnapTo::Vertex:
      return hint(tr("a point"));
    case SnapTo::Edge:
      return hint(tr("an edge"));
    case SnapTo::Wall:
      return hint(tr("a wall of the map"));
    case SnapTo::Angle:
      return hint(tr("an angle"));
    case SnapTo::Grid:
      return hint(tr("the grid"));
    case SnapTo::Nothing:
      break;
  }
  return {};
}

void OverlaySnapping::paint(QPainter& painter, const Snapped& place) const {
  if (place.to == SnapTo::Nothing) return;
  const scene::MapTheme& theme = scene_->theme();
  const auto px = [&](const Eigen::Vector2d& at) {
    return scene::toPoint(scene_->view().pixelFromWorld(at));
  };
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QPointF at = px(place.at_m);
  for (const auto& [color, width] : {std::pair(theme.text_halo, 4.0), std::pair(theme.measure, 2.0)}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
    switch (place.to) {
      case SnapTo::Vertex:
        painter.drawRect(QRectF(at.x() - 8, at.y() - 8, 16, 16));
        break;
      case SnapTo::Edge:
      case SnapTo::Angle:
        for (const QPolygonF& line :
             scene::visibleLines(scene_->view(), std::vector<Eigen::Vector2d>{place.from_m, place.to_m}, 8))
          painter.drawPolyline(line);
        painter.drawEllipse(at, 7, 7);
        break;
      case SnapTo::Wall:
        painter.drawPolygon(
            QPolygonF{at + QPointF(0, -9), at + QPointF(9, 0), at + QPointF(0, 9), at + QPointF(-9, 0)});
        break;
      case SnapTo::Grid:
        painter.drawLine(at - QPointF(12, 0), at + QPointF(12, 0));
        painter.drawLine(at - QPointF(0, 12), at + QPointF(0, 12));
        break;
      case SnapTo::Nothing:
        break;
    }
  }
  painter.restore();
}

}  // namespace mapwright::ui

#include "moc_overlay_snapping.cpp"
