// Paints things that a robot draws on the ground (map::GroundDrawing).
#pragma once

#include <vector>

#include <QPainter>

#include "scene/layer_item.h"

namespace mapwright::scene {

/// 0xRRGGBBAA.
QColor colorFrom(std::uint32_t rgba);

/// `color`: for those without a colour of their own.
void drawGroundDrawings(QPainter& painter, const LayerContext& context,
                        const std::vector<map::GroundDrawing>& drawings, const QColor& color);

}  // namespace mapwright::scene
