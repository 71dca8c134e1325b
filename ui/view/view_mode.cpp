#include "ui/view/view_mode.h"

#include <algorithm>

namespace mapwright::window {

using scene::Layer;

std::optional<ViewMode> viewMode(const scene::MapScene& scene) {
  const bool submaps = scene.layerVisible(Layer::Submaps), whole = scene.layerVisible(Layer::WholeMap);
  if (submaps && whole) return ViewMode::Both;
  if (submaps) return ViewMode::Submaps;
  return whole ? std::optional(ViewMode::Whole) : std::nullopt;
}

void setViewMode(scene::MapScene& scene, ViewMode mode) {
  if (mode == ViewMode::Both) {
    std::vector<Layer> order = scene.layerOrder();
    const auto whole = std::find(order.begin(), order.end(), Layer::WholeMap);
    const auto submaps = std::find(order.begin(), order.end(), Layer::Submaps);
    if (whole > submaps) {
      std::rotate(submaps, whole, whole + 1);
      scene.setLayerOrder(order);
    }
  }
  scene.setLayerVisible(Layer::WholeMap, mode != ViewMode::Submaps);
  scene.setLayerVisible(Layer::Submaps, mode != ViewMode::Whole);
}

}  // namespace mapwright::window
