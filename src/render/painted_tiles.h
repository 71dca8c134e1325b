// Keeps the tiles of a layer up to date that is painted by a callback: clouds from above, sections.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QImage>
#include <QObject>

#include "render/grid_renderer.h"

namespace mapwright::render {

/// Paints the window of a raster: ARGB32_Premultiplied or RGB32 of its size, null if it is empty. A pure
/// function, called on any thread; polls the flag, after which its result is ignored.
using TilePainter = std::function<QImage(const PixelGrid&, const std::atomic<bool>& cancelled)>;

/// GUI-thread object; paints on the thread pool, like GridRenderer: tiles are aligned with the view's pixels
/// and drawn at integer offsets; a picture of another view or of older content is shown until the new one is
/// ready.
class PaintedTiles : public QObject {
  Q_OBJECT
 public:
  /// `previews` false: no stand-ins.
  explicit PaintedTiles(GridRenderer::Options options, QObject* parent = nullptr);
  ~PaintedTiles() override;

  /// Paints with this from now on; null = nothing.
  void setPainter(TilePainter painter);
  /// A view without pixels shows nothing. Device pixels.
  void setView(const geometry::ViewTransform& view);
  /// While switched off nothing is painted.
  void setActive(bool active);

  GridRenderer::Drawing drawing();
  /// Every visible tile shows the present content.
  bool settled() const;
  std::size_t cacheBytes() const;

 Q_SIGNALS:
  void tilesChanged();  // repaint; coalesced
  void settledChanged();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::render
