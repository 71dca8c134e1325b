#include "scene/layer_topic.h"

namespace mapwright::scene {

std::optional<map::Stream> chosenStream(Layer layer) {
  switch (layer) {
    case Layer::WholeMap:
    case Layer::CostmapLow:
    case Layer::CostmapHigh:
    case Layer::Path:
    case Layer::LocalPath:
    case Layer::Target:
      return *layerStreams(layer).begin();
    default:
      return std::nullopt;
  }
}

}  // namespace mapwright::scene
