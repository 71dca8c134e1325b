#include "ui/shell/viewpoint.h"

#include <algorithm>

#include "ui/view/map_view.h"

namespace mapwright::ui {

namespace {
constexpr double kClosestFitMPerPx = 0.01;
constexpr double kLookScaleMPerPx = 0.05;
}  // namespace

Viewpoint::Viewpoint(MapView& view, QObject* parent) : QObject(parent), view_(view) {
  connect(&view_, &MapView::movedByHand, this, &Viewpoint::choose);
}

void Viewpoint::fit(const geometry::WorldRect& world) { view_.keepFitted(world, kClosestFitMPerPx); }

void Viewpoint::fitOnce(const geometry::WorldRect& world) { view_.fit(world, false, kClosestFitMPerPx); }

void Viewpoint::lookAt(const geometry::WorldRect& world) {
  geometry::ViewTransform to = view_.destination();
  to.center_m = world.center();
  const double smaller_px = std::min(to.width_px, to.height_px);
  const double extent = std::max(world.width(), world.height());
  if (extent / to.scale_m_per_px > smaller_px) {
    to = to.fitted(world, 48);
  } else if (extent / to.scale_m_per_px < smaller_px / 8) {
    to.scale_m_per_px = std::max(std::min(kLookScaleMPerPx, to.scale_m_per_px), extent / smaller_px);
  }
  view_.setFollowing(false);
  choose();
  view_.moveTo(to, true);
}

}  // namespace mapwright::ui

#include "moc_viewpoint.cpp"
