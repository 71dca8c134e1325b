// The map raster alone: gray = intensity, alpha 0 = not observed (cli.md, snapshot --raw).
#pragma once

#include <optional>
#include <span>

#include <QString>

#include "geometry/view_transform.h"
#include "render/compositor.h"
#include "render/sample_grid.h"

namespace mapwright::app {

/// Composes the view exactly, on every core, and writes an 8-bit gray+alpha PNG. The error is a sentence.
std::optional<QString> writeRawPicture(const geometry::ViewTransform& view,
                                       std::span<const render::PlacedTexture> textures, const QString& path);

/// The same of a whole map: gray pictures keep their gray levels, also where they mean "unknown".
std::optional<QString> writeRawPicture(const geometry::ViewTransform& view, const render::PlacedGrid& grid,
                                       const QString& path);

}  // namespace mapwright::app
