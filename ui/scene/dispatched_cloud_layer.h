// The clouds of a map, from above.
#pragma once

#include "render/raster_tiles.h"
#include "scene/layer_item.h"

namespace mapwright::scene {

class MapClouds;

class DispatchedCloudLayer : public DeviceLayer {
 public:
  DispatchedCloudLayer(const LayerContext& context, const render::RasterTiles::Options& options);

  /// Not owned; must outlive this or be removed first.
  void setClouds(const MapClouds* clouds);
  /// The clouds, their style or the theme have changed.
  void refresh();
  render::PaintedTiles& tiles() { return tiles_; }
  const render::PaintedTiles& tiles() const { return tiles_; }

 protected:
  void takeView(const geometry::ViewTransform& device_view) override;
  void paintPixels(QPainter& painter, const QRectF& exposed) override;

 private:
  const MapClouds* clouds_ = nullptr;
  double ratio_ = 1;
  render::PaintedTiles tiles_;
};

}  // namespace mapwright::scene
