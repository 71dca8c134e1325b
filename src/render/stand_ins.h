// What is drawn of a layer of tiles; pictures of earlier views, warped, shown until the present one is ready.
// GUI thread.
#pragma once

#include <memory>
#include <vector>

#include <QImage>
#include <QTransform>

#include "geometry/view_transform.h"
#include "render/tile_colors.h"

namespace mapwright::render {

/// One image to draw: `image` (RGB32, opaque; ARGB32_Premultiplied if unknown is transparent, and then null
/// means that the area is empty and no stand-in may show) is mapped to viewport pixels by `to_viewport`: an
/// integer translation if the tile belongs to the present scale and rotation, otherwise (stand_in) a warped
/// picture of an earlier view.
struct DrawnTile {
  QImage image;
  QTransform to_viewport;
  bool stand_in = false;
};

/// The pixels of a tile and the image painted from them.
struct Picture {
  PixelGrid grid;
  std::shared_ptr<const Composition> pixels;  // null: cannot be recoloured
  QImage image;
};

/// Layers of pictures, the newest on top. Bounded: if views change faster than tiles are made, the layers are
/// merged into one picture of the viewport.
class StandIns {
 public:
  static constexpr std::size_t kMostLayers = 4;

  bool empty() const { return layers_.empty(); }
  void clear() { layers_.clear(); }
  /// `view` is the one in which the pictures were shown.
  void push(std::vector<Picture> pictures, const geometry::ViewTransform& view, std::uint32_t background);
  void repaint(const ColorTable& colors);
  /// The visible parts, bottom to top.
  void draw(const geometry::ViewTransform& view, std::vector<DrawnTile>& out) const;
  std::size_t bytes() const;

 private:
  void flatten(const geometry::ViewTransform& view, std::uint32_t background);
  std::vector<std::vector<Picture>> layers_;  // bottom first
};

/// From the pixels of a grid's window to those of a viewport.
QTransform viewportFromGrid(const PixelGrid& grid, const geometry::ViewTransform& view);

std::size_t bytesOf(const Composition& pixels);

}  // namespace mapwright::render
