#include "scene/dispatched_cloud_layer.h"

#include <QPainter>

#include "scene/map_clouds.h"

namespace mapwright::scene {

DispatchedCloudLayer::DispatchedCloudLayer(const LayerContext& context,
                                           const render::RasterTiles::Options& options)
    : DeviceLayer(context), tiles_(options) {
  QObject::connect(&tiles_, &render::PaintedTiles::tilesChanged, &tiles_, [this] { update(); });
}

void DispatchedCloudLayer::setClouds(const MapClouds* clouds) {
  clouds_ = clouds;
  refresh();
}

void DispatchedCloudLayer::refresh() {
  tiles_.setPainter(clouds_ ? clouds_->painter(ratio_) : render::TilePainter());
}

void DispatchedCloudLayer::takeView(const geometry::ViewTransform& device_view) {
  // Points have a size in window pixels.
  const double ratio = context_.view.scale_m_per_px / device_view.scale_m_per_px;
  if (std::exchange(ratio_, ratio) != ratio) refresh();
  tiles_.setView(device_view);
}

void DispatchedCloudLayer::paintPixels(QPainter& painter, const QRectF& exposed) {
  drawRaster(painter, exposed, tiles_.drawing());
}

}  // namespace mapwright::scene
