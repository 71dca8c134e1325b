// Which layers offer a choice of topic.
#pragma once

#include <optional>

#include "map/stream.h"
#include "scene/layer.h"

namespace mapwright::scene {

/// The kind of data to choose for the layer; nullopt: no choice.
std::optional<map::Stream> chosenStream(Layer layer);

}  // namespace mapwright::scene
