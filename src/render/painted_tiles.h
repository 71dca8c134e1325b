// Keeps the tiles of a layer up to date that is painted by a callback: clouds from above, sections.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QImage>

#include "render/raster_tiles.h"

namespace mapwright::render {

/// Paints the window of a raster: ARGB32_Premultiplied or RGB32 of its size, null if it is empty. A pure
/// function, called on any thread; polls the flag, after which its result is ignored.
using TilePainter = std::function<QImage(const PixelGrid&, const std::atomic<bool>& cancelled)>;

/// Without previews there are no stand-ins.
class PaintedTiles : public RasterTiles {
  Q_OBJECT
 public:
  explicit PaintedTiles(Options options, QObject* parent = nullptr);

  /// Paints with this from now on; null = nothing.
  void setPainter(TilePainter painter);

 protected:
  bool hasContent() const override { return painter_ != nullptr; }
  void startMissing() override;

 private:
  std::shared_ptr<const TilePainter> painter_;
};

}  // namespace mapwright::render
