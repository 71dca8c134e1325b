// What a window would show of a tile renderer, and how to look at it.
#pragma once

#include <vector>

#include <QImage>

#include "render/tile_renderer.h"

namespace mapwright::testing {

inline constexpr QRgb kNothing = 0xff00ff00;

/// The drawn tiles painted into an image of the viewport; kNothing where nothing is painted.
QImage paintedPicture(render::TileRenderer& renderer, const geometry::ViewTransform& view);
int countNothing(const QImage& image);
bool hasStandIns(render::TileRenderer& renderer);

/// The composition of the view's own pixels.
render::Composition exactOf(const geometry::ViewTransform& view,
                            const std::vector<render::PlacedTexture>& placed);
/// Mean absolute difference of the intensities of two pictures of one size.
double meanDifference(const render::Composition& a, const render::Composition& b);

}  // namespace mapwright::testing
