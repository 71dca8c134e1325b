#include "app/raw_picture.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include <QSaveFile>
#include <QThreadPool>
#include <spng.h>

namespace mapwright::app {
namespace {

constexpr int kBandRows = 128;

/// Gray and alpha of every pixel, made in bands on every core. `draw` writes the pairs of a band.
std::vector<std::uint8_t> inBands(
    const geometry::ViewTransform& view,
    const std::function<void(const render::PixelGrid& band, std::uint8_t* pairs)>& draw) {
  std::vector<std::uint8_t> pixels(std::size_t(view.width_px) * std::size_t(view.height_px) * 2);
  QThreadPool pool;
  for (int top = 0; top < view.height_px; top += kBandRows) {
    pool.start([&, top] {
      render::PixelGrid band;
      band.origin_m = view.worldFromPixel({0, 0});
      band.first_row = top;
      band.scale_m_per_px = view.scale_m_per_px;
      band.rotation_rad = view.rotation_rad;
      band.width_px = view.width_px;
      band.height_px = std::min(kBandRows, view.height_px - top);
      draw(band, pixels.data() + std::size_t(top) * std::size_t(view.width_px) * 2);
    });
  }
  pool.waitForDone();
  return pixels;
}

std::optional<QString> writeGrayAlpha(const geometry::ViewTransform& view,
                                      const std::vector<std::uint8_t>& pixels, const QString& path) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> encoder(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                    &spng_ctx_free);
  spng_ihdr header{};
  header.width = std::uint32_t(view.width_px);
  header.height = std::uint32_t(view.height_px);
  header.bit_depth = 8;
  header.color_type = SPNG_COLOR_TYPE_GRAYSCALE_ALPHA;
  spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_ihdr(encoder.get(), &header);
  int failure =
      spng_encode_image(encoder.get(), pixels.data(), pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t bytes = 0;
  const std::unique_ptr<void, decltype(&std::free)> png(
      failure ? nullptr : spng_get_png_buffer(encoder.get(), &bytes, &failure), &std::free);
  if (!png)
    return QStringLiteral("The picture cannot be encoded: %1.").arg(QLatin1String(spng_strerror(failure)));
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly) ||
      file.write(static_cast<const char*>(png.get()), qint64(bytes)) < 0 || !file.commit()) {
    return QStringLiteral("%1 cannot be written: %2.").arg(path, file.errorString());
  }
  return std::nullopt;
}

}  // namespace

std::optional<QString> writeRawPicture(const geometry::ViewTransform& view,
                                       std::span<const render::PlacedTexture> textures, const QString& path) {
  render::DenseCache cache(std::size_t(256) << 20);
  const auto pixels = inBands(view, [&](const render::PixelGrid& band, std::uint8_t* pairs) {
    const render::Composition made = render::compose(band, textures, render::Quality::Exact, cache);
    for (std::size_t i = 0; i < made.intensity.size(); ++i) {
      pairs[2 * i] = made.intensity[i];
      pairs[2 * i + 1] = (made.flags[i] & render::kObserved) ? 255 : 0;
    }
  });
  return writeGrayAlpha(view, pixels, path);
}

std::optional<QString> writeRawPicture(const geometry::ViewTransform& view, const render::PlacedGrid& grid,
                                       const QString& path) {
  if (!grid.cells) return QStringLiteral("There is no map to draw.");
  const raster::CellCode code = grid.cells->code();
  const raster::CellMeaning& meaning = raster::meaningOf(code);
  const auto pixels = inBands(view, [&](const render::PixelGrid& band, std::uint8_t* pairs) {
    const render::Composition made = render::sampleGrid(band, grid, nullptr);
    for (std::size_t i = 0; i < made.intensity.size(); ++i) {
      const std::uint8_t cell = made.intensity[i];
      const bool inside = made.flags[i] != 0;
      pairs[2 * i] = !inside ? 128 : code == raster::CellCode::Gray ? cell : meaning.intensity[cell];
      pairs[2 * i + 1] = inside && meaning.known[cell] ? 255 : 0;
    }
  });
  return writeGrayAlpha(view, pixels, path);
}

}  // namespace mapwright::app
