// The map raster alone: gray = intensity, alpha 0 = not observed (cli.md, snapshot --raw).
#pragma once

#include <optional>
#include <span>

#include <QString>

#include "geometry/view_transform.h"
#include "render/compositor.h"

namespace mapwright::app {

/// Composes the view exactly, on every core, and writes an 8-bit gray+alpha PNG. The error is a sentence.
std::optional<QString> writeRawPicture(const geometry::ViewTransform& view,
                                       std::span<const render::PlacedTexture> textures, const QString& path);

}  // namespace mapwright::app
