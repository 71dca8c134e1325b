#include "render/stand_ins.h"

#include <QPainter>

namespace mapwright::render {

QTransform viewportFromGrid(const PixelGrid& grid, const geometry::ViewTransform& view) {
  const Eigen::Vector2d origin = view.pixelFromWorld(grid.worldFromPixel(0, 0));
  const double turned = view.rotation_rad - grid.rotation_rad;
  const double zoomed = grid.scale_m_per_px / view.scale_m_per_px;
  const double c = std::cos(turned) * zoomed, s = std::sin(turned) * zoomed;
  // Counter-clockwise on screen, where y runs down.
  return {c, -s, s, c, origin.x(), origin.y()};
}

std::size_t bytesOf(const Composition& pixels) {
  return pixels.intensity.size() + pixels.flags.size() * sizeof(pixels.flags[0]);
}

void StandIns::push(std::vector<Picture> pictures, const geometry::ViewTransform& view,
                    std::uint32_t background) {
  if (pictures.empty()) return;
  layers_.push_back(std::move(pictures));
  if (layers_.size() > kMostLayers) flatten(view, background);
}

void StandIns::flatten(const geometry::ViewTransform& view, std::uint32_t background) {
  QImage image(view.width_px, view.height_px,
               qAlpha(background) == 255 ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
  image.fill(background);
  {
    std::vector<DrawnTile> tiles;
    draw(view, tiles);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (const DrawnTile& tile : tiles) {
      painter.setTransform(tile.to_viewport);
      painter.drawImage(0, 0, tile.image);
    }
  }
  PixelGrid grid;
  grid.origin_m = view.worldFromPixel({0, 0});
  grid.scale_m_per_px = view.scale_m_per_px;
  grid.rotation_rad = view.rotation_rad;
  grid.width_px = view.width_px;
  grid.height_px = view.height_px;
  layers_.clear();
  layers_.push_back({{grid, nullptr, std::move(image)}});
}

void StandIns::repaint(const ColorTable& colors) {
  for (auto& layer : layers_) {
    for (Picture& picture : layer) {
      if (picture.pixels) picture.image = colors.paint(*picture.pixels);
    }
  }
}

void StandIns::draw(const geometry::ViewTransform& view, std::vector<DrawnTile>& out) const {
  const QRectF viewport(0, 0, view.width_px, view.height_px);
  for (const auto& layer : layers_) {
    for (const Picture& picture : layer) {
      const QTransform to_viewport = viewportFromGrid(picture.grid, view);
      if (!to_viewport.mapRect(QRectF(picture.image.rect())).intersects(viewport)) continue;
      out.push_back({picture.image, to_viewport, true});
    }
  }
}

std::size_t StandIns::bytes() const {
  std::size_t bytes = 0;
  for (const auto& layer : layers_) {
    for (const Picture& picture : layer) {
      bytes += std::size_t(picture.image.sizeInBytes()) + (picture.pixels ? bytesOf(*picture.pixels) : 0);
    }
  }
  return bytes;
}

}  // namespace mapwright::render
