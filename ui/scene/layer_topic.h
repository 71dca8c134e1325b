// Which layers show what people may take from a topic of their choice.
#pragma once

#include <optional>

#include "map/stream.h"
#include "scene/layer.h"

namespace mapwright::scene {

/// The kind of data that is chosen for the layer; nullopt: it comes from where it comes.
std::optional<map::Stream> chosenStream(Layer layer);

}  // namespace mapwright::scene
