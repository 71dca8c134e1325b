// What a robot draws on the ground for people (map::GroundDrawing), as pixels.
#pragma once

#include <vector>

#include <QPainter>

#include "scene/layer_item.h"

namespace mapwright::scene {

/// 0xRRGGBBAA.
QColor colorFrom(std::uint32_t rgba);

/// `color`: of what the robot names none for.
void drawGroundDrawings(QPainter& painter, const LayerContext& context,
                        const std::vector<map::GroundDrawing>& drawings, const QColor& color);

}  // namespace mapwright::scene
