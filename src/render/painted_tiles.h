// Keeps the tiles of a layer up to date whose pictures somebody else paints: clouds from above, sections.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QImage>

#include "render/raster_tiles.h"

namespace mapwright::render {

/// Paints the window of a raster: ARGB32_Premultiplied or RGB32 of its size, null where there is nothing. A
/// pure function that any thread may call; polls the flag, after which its result does not matter.
using TilePainter = std::function<QImage(const PixelGrid&, const std::atomic<bool>& cancelled)>;

/// Without previews there are no stand-ins.
class PaintedTiles : public RasterTiles {
  Q_OBJECT
 public:
  explicit PaintedTiles(Options options, QObject* parent = nullptr);

  /// From now on this is painted; null = nothing is.
  void setPainter(TilePainter painter);

 protected:
  bool hasContent() const override { return painter_ != nullptr; }
  void startMissing() override;

 private:
  std::shared_ptr<const TilePainter> painter_;
};

}  // namespace mapwright::render
