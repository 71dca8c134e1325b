#include <algorithm>

#include "render/tile_renderer.h"
#include "scene/layer_item.h"

namespace mapwright::scene {
namespace {

constexpr int kMapTileEdge = 256;  // of the renderer's tiles

/// The composited submaps.
class SubmapsLayer : public DeviceLayer {
 public:
  using DeviceLayer::DeviceLayer;
  bool settled() const override { return context_.submaps->settled(); }

 protected:
  void takeView(const geometry::ViewTransform& device_view) override {
    context_.submaps->setView(device_view);
  }
  void paintPixels(QPainter& painter, const QRectF& exposed) override {
    const std::vector<render::DrawnTile> tiles = context_.submaps->drawnTiles();
    const auto first =
        std::find_if(tiles.begin(), tiles.end(), [](const auto& tile) { return !tile.stand_in; });
    const std::span stand_ins(tiles.begin(), first), finished(first, tiles.end());
    if (!stand_ins.empty() && context_.submaps->colors().clear_unknown) {
      // A transparent part of a finished tile shows the layer below, not the stand-in.
      QRegion open(exposed.toAlignedRect());
      for (const render::DrawnTile& tile : finished) {
        open -= QRect(int(tile.to_viewport.dx()), int(tile.to_viewport.dy()), kMapTileEdge, kMapTileEdge);
      }
      painter.save();
      painter.setClipRegion(open, Qt::IntersectClip);
      drawTiles(painter, exposed, stand_ins);
      painter.restore();
    } else {
      drawTiles(painter, exposed, stand_ins);
    }
    drawTiles(painter, exposed, finished);
  }
};

}  // namespace

template <>
LayerSpec layerSpec<Layer::Submaps>() {
  return {.name = "submaps",
          .title = QT_TRANSLATE_NOOP("scene", "Submaps"),
          .in_all = false,  // --mode decides about them
          .why_empty = whyNoSubmaps,
          .items = oneItem<SubmapsLayer>};
}

}  // namespace mapwright::scene
