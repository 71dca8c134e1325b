#include "painted.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "render/dense_cache.h"
#include "scenes.h"

namespace mapwright::testing {

QImage paintedPicture(render::TileRenderer& renderer, const geometry::ViewTransform& view) {
  QImage image(view.width_px, view.height_px, QImage::Format_RGB32);
  image.fill(kNothing);
  QPainter painter(&image);
  for (const render::DrawnTile& tile : renderer.drawnTiles()) {
    painter.setTransform(tile.to_viewport);
    painter.drawImage(0, 0, tile.image);
  }
  return image;
}

int countNothing(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    const auto* const line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    count += int(std::count(line, line + image.width(), kNothing));
  }
  return count;
}

render::Composition exactOf(const geometry::ViewTransform& view,
                            const std::vector<render::PlacedTexture>& placed) {
  render::DenseCache cache;
  return render::compose(gridOf(view), placed, render::Quality::Exact, cache);
}

bool hasStandIns(render::TileRenderer& renderer) {
  const auto tiles = renderer.drawnTiles();
  return std::any_of(tiles.begin(), tiles.end(), [](const render::DrawnTile& tile) { return tile.stand_in; });
}

double meanDifference(const render::Composition& a, const render::Composition& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.intensity.size(); ++i)
    sum += std::abs(int(a.intensity[i]) - int(b.intensity[i]));
  return sum / double(a.intensity.size());
}

}  // namespace mapwright::testing
