// MapScene: which layers are shown, in which order and style, and comparisons.
#include <algorithm>

#include "scene/map_scene_impl.h"

namespace mapwright::scene {

void MapScene::setWaypoints(std::optional<DrawnWaypoints> waypoints) {
  if (!waypoints && !impl_->edited) return;
  impl_->edited = std::move(waypoints);
  impl_->takeWaypoints(session_);
  for (LayerItem* item : impl_->itemsOf(Layer::Waypoints)) item->update();
}

void MapScene::setEditedCells(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells) {
  impl_->raster.setEdited(map, std::move(cells));
}

void MapScene::editedCellsChanged(const geometry::WorldRect& where) {
  impl_->raster.editedChanged(where);
  Q_EMIT cellsEdited(where);
}

bool MapScene::layerVisible(Layer layer) const { return impl_->shown.at(layer); }

void MapScene::setLayerVisible(Layer layer, bool visible) {
  impl_->shown[layer] = visible;
  syncPlace();
  sendWants();
  Q_EMIT layersChanged();
}

double MapScene::layerOpacity(Layer layer) const { return impl_->items.at(layer)->opacity(); }

void MapScene::setLayerOpacity(Layer layer, double opacity) {
  for (LayerItem* item : impl_->itemsOf(layer)) item->setOpacity(std::clamp(opacity, 0.0, 1.0));
  impl_->applyVisibility();
  Q_EMIT layersChanged();
}

const LayerStyle& MapScene::layerStyle(Layer layer) const { return impl_->items.at(layer)->style(); }

void MapScene::setLayerStyle(Layer layer, const LayerStyle& style) {
  for (LayerItem* item : impl_->itemsOf(layer)) item->setStyle(style);
  if (layer == Layer::WholeMap) applyReduction();
  if (layer == Layer::DispatchedCloud) impl_->dispatched->refresh();
  Q_EMIT layersChanged();
}

void MapScene::applyReduction() {
  if (!session_) return;
  const bool average = WholeMapChoice(layerStyle(Layer::WholeMap).choice) == WholeMapChoice::Average;
  for (session::MapSlot* slot : {&session_->wholeMap(), &session_->comparedMap()}) {
    slot->setReduction(average ? grids::Reduction::Average : grids::Reduction::OccupiedWins);
  }
}

const std::vector<Layer>& MapScene::layerOrder() const { return impl_->order; }

void MapScene::setLayerOrder(const std::vector<Layer>& order) {
  std::vector<Layer> next, fixed;
  const auto missing = [&](Layer layer) { return std::find(next.begin(), next.end(), layer) == next.end(); };
  for (const Layer layer : order) {
    if (!orderFixed(layer) && missing(layer)) next.push_back(layer);
  }
  for (const Layer layer : allLayers()) {
    if (orderFixed(layer)) {
      fixed.push_back(layer);
    } else if (missing(layer)) {
      next.push_back(layer);  // one that the caller does not know goes on top
    }
  }
  next.insert(next.end(), fixed.begin(), fixed.end());
  impl_->order = std::move(next);
  impl_->stack();
  update();
  Q_EMIT layersChanged();
}

CompareMode MapScene::compareMode() const { return impl_->compare; }

void MapScene::setCompareMode(CompareMode mode) {
  if (mode == impl_->compare) return;
  impl_->compare = mode;
  syncPlace();
  sendWants();
  update();
  Q_EMIT layersChanged();
}

const RobotPlace& MapScene::robotPlace() const { return impl_->place; }

void MapScene::setRobotWanted(std::optional<bool> wanted) {
  impl_->robot_wanted = wanted;
  syncPlace();
}

void MapScene::syncPlace() {
  if (impl_->placeRobot(session_)) {
    showPlaced();
    return;
  }
  impl_->applyVisibility();
  syncColors();
  syncFeatures();
}

void MapScene::showPlaced() {
  impl_->applyVisibility();
  syncColors();
  syncFeatures();
  update();
  Q_EMIT robotPlaceChanged();
}

double MapScene::swipeAt() const { return impl_->swipe_at; }

void MapScene::setSwipeAt(double fraction) {
  impl_->swipe_at = std::clamp(fraction, 0.0, 1.0);
  impl_->applyVisibility();
}

Halves MapScene::halves() const {
  Halves halves = impl_->halves();
  if (halves.left == HalfContent::Submaps && !impl_->items.at(Layer::Submaps)->isVisible())
    halves.left = HalfContent::Nothing;
  return halves;
}

void MapScene::setHalfNames(const QString& left, const QString& right) {
  impl_->swipe->setNames(left, right);
}

void MapScene::setCoveredTop(double px) {
  if (px == impl_->context.covered_top_px) return;
  impl_->context.covered_top_px = px;
  impl_->swipe->update();
}

double MapScene::coveredTop() const { return impl_->context.covered_top_px; }

}  // namespace mapwright::scene
