// How fast tiles are composed, and how exactly, next to what other libraries make of the same tiles in the
// same run. Each kernel benchmark reports: Mpixel_per_s (samples of one layer), max_error and
// off_by_more_than_1 (percent) against a double-precision reference over three layers.
#include <algorithm>
#include <cairo.h>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QImage>
#include <QPainter>
#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "cells/cell_texture.h"
#include "render/compositor.h"
#include "render/dense_cache.h"
#include "render/tile_renderer.h"

namespace {

using namespace mapwright;

constexpr int kTile = 256;
constexpr int kCells = 400;
constexpr double kResolution = 0.05;
constexpr int kTiles = 16;
constexpr int kLayers = 3;

struct Layer {
  std::vector<cells::CellPair> cells;
  render::PlacedTexture placed;
};

struct Tile {
  render::PixelGrid grid;
  std::vector<Layer> layers;
};

// Rooms with walls on unknown ground until 41 % of the cells are known, as in Cartographer's submaps.
std::vector<cells::CellPair> submapCells(std::mt19937& random) {
  std::vector<cells::CellPair> cells(std::size_t(kCells) * kCells);
  const std::size_t wanted = cells.size() * 41 / 100;
  const auto below = [&](int end) { return int(random() % unsigned(end)); };
  for (std::size_t known = 0; known < wanted;) {
    const int w = 40 + below(110), h = 40 + below(110);
    const int x0 = 60 + below(kCells - 120 - w), y0 = 60 + below(kCells - 120 - h);
    for (int y = y0; y < y0 + h && known < wanted; ++y) {
      for (int x = x0; x < x0 + w; ++x) {
        cells::CellPair& cell = cells[std::size_t(y) * kCells + std::size_t(x)];
        if (cell == cells::CellPair{}) ++known;
        const bool wall = x == x0 || y == y0 || x == x0 + w - 1 || y == y0 + h - 1;
        const auto strength = std::uint8_t(40 + below(80));
        cell = wall ? cells::CellPair{0, strength} : cells::CellPair{std::uint8_t(strength / 2), 0};
      }
    }
  }
  return cells;
}

Layer placedLayer(std::mt19937& random, int index) {
  std::uniform_real_distribution<double> angle(-3.14, 3.14), offset(-0.5, 0.5);
  Layer layer{submapCells(random), {}};
  layer.placed.id = {0, index};
  layer.placed.texture = cells::CellTexture::fromPairs(kCells, kCells, kResolution, layer.cells);
  const double yaw = angle(random), half = kCells * kResolution / 2;
  const Eigen::Vector2d middle = geometry::Pose2{0, 0, yaw}.apply({-half, -half});
  layer.placed.world_from_texture = {offset(random) - middle.x(), offset(random) - middle.y(), yaw};
  return layer;
}

std::vector<Tile> kernelTiles() {
  std::mt19937 random(42);
  std::vector<Tile> tiles;
  for (int t = 0; t < kTiles; ++t) {
    Tile tile;
    tile.grid.scale_m_per_px = kResolution * 0.97;
    tile.grid.width_px = tile.grid.height_px = kTile;
    tile.grid.first_column = tile.grid.first_row = -kTile / 2;
    for (int l = 0; l < kLayers; ++l) tile.layers.push_back(placedLayer(random, l));
    tiles.push_back(std::move(tile));
  }
  return tiles;
}

std::vector<render::PlacedTexture> placedOf(const Tile& tile) {
  std::vector<render::PlacedTexture> placed;
  for (const Layer& layer : tile.layers) placed.push_back(layer.placed);
  return placed;
}

double referenceAt(const Tile& tile, int column, int row) {
  const Eigen::Vector2d world = tile.grid.worldFromPixel(column + 0.5, row + 0.5);
  double intensity = 128;
  for (const Layer& layer : tile.layers) {
    const Eigen::Vector2d p = layer.placed.world_from_texture.inverse().apply(world);
    const double u = -p.y() / kResolution - 0.5, v = -p.x() / kResolution - 0.5;
    double value = 0, alpha = 0;
    for (const double y : {std::floor(v), std::floor(v) + 1}) {
      for (const double x : {std::floor(u), std::floor(u) + 1}) {
        if (x < 0 || y < 0 || x >= kCells || y >= kCells) continue;
        const cells::CellPair cell = layer.cells[std::size_t(y) * kCells + std::size_t(x)];
        const double weight = (1 - std::abs(u - x)) * (1 - std::abs(v - y));
        value += weight * cell.value;
        alpha += weight * cell.alpha;
      }
    }
    intensity = std::min(255.0, value + intensity * (255 - alpha) / 255);
  }
  return intensity;
}

// Composes one tile into kTile x kTile intensities.
template <typename Compose>
void runKernel(benchmark::State& state, const std::vector<Tile>& tiles, Compose compose) {
  for (auto _ : state) {
    for (std::size_t t = 0; t < tiles.size(); ++t) benchmark::DoNotOptimize(compose(t));
  }
  double worst = 0, off = 0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const std::vector<std::uint8_t> intensity = compose(t);
    for (int row = 0; row < kTile; ++row) {
      for (int column = 0; column < kTile; ++column) {
        const double difference =
            std::abs(referenceAt(tiles[t], column, row) - intensity[std::size_t(row * kTile + column)]);
        worst = std::max(worst, difference);
        if (difference > 1) ++off;
      }
    }
  }
  const double pixels = double(tiles.size()) * kTile * kTile;
  state.counters["Mpixel_per_s"] =
      benchmark::Counter(pixels * kLayers / 1e6 * double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["max_error"] = worst;
  state.counters["off_by_more_than_1"] = 100 * off / pixels;
}

void composeKernel(benchmark::State& state, render::Kernel kernel) {
  if (!render::kernelAvailable(kernel)) {
    state.SkipWithError("this processor has not got it");
    return;
  }
  const std::vector<Tile> tiles = kernelTiles();
  std::vector<std::vector<render::PlacedTexture>> placed;
  for (const Tile& tile : tiles) placed.push_back(placedOf(tile));
  render::DenseCache cache;
  runKernel(state, tiles, [&](std::size_t t) {
    return render::compose(tiles[t].grid, placed[t], render::Quality::Exact, cache, kernel).intensity;
  });
}

void composePortable(benchmark::State& state) { composeKernel(state, render::Kernel::Portable); }
void composeAvx2(benchmark::State& state) { composeKernel(state, render::Kernel::Avx2); }
BENCHMARK(composePortable)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(composeAvx2)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

// Tile pixel from texture cell: x = a*u + b*v + c, y = d*u + e*v + f.
struct Affine {
  double a, b, c, d, e, f;
};

Affine tileFromTexture(const Tile& tile, const Layer& layer) {
  const auto pixelOf = [&](double u, double v) {
    const Eigen::Vector2d world = layer.placed.world_from_texture.apply({-v * kResolution, -u * kResolution});
    const Eigen::Vector2d corner = tile.grid.worldFromPixel(0, 0);
    return Eigen::Vector2d((world.x() - corner.x()) / tile.grid.scale_m_per_px,
                           (corner.y() - world.y()) / tile.grid.scale_m_per_px);
  };
  const Eigen::Vector2d o = pixelOf(0, 0), u = pixelOf(1, 0) - o, v = pixelOf(0, 1) - o;
  return {u.x(), v.x(), o.x(), u.y(), v.y(), o.y()};
}

QImage premultiplied(const Layer& layer) {
  QImage image(kCells, kCells, QImage::Format_ARGB32_Premultiplied);
  for (int y = 0; y < kCells; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < kCells; ++x) {
      const cells::CellPair cell = layer.cells[std::size_t(y) * kCells + std::size_t(x)];
      line[x] = qRgba(cell.value, cell.value, cell.value, cell.alpha);
    }
  }
  return image;
}

std::vector<std::uint8_t> grayOf(const std::uint8_t* pixels, std::size_t bytes_per_line) {
  std::vector<std::uint8_t> gray(std::size_t(kTile) * kTile);
  for (std::size_t y = 0; y < kTile; ++y) {
    for (std::size_t x = 0; x < kTile; ++x) gray[y * kTile + x] = pixels[y * bytes_per_line + 4 * x];
  }
  return gray;
}

void composeQPainter(benchmark::State& state) {
  const std::vector<Tile> tiles = kernelTiles();
  std::vector<std::vector<QImage>> images(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const Layer& layer : tiles[t].layers) images[t].push_back(premultiplied(layer));
  }
  runKernel(state, tiles, [&](std::size_t t) {
    QImage target(kTile, kTile, QImage::Format_ARGB32_Premultiplied);
    target.fill(qRgba(128, 128, 128, 255));
    QPainter painter(&target);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (std::size_t l = 0; l < images[t].size(); ++l) {
      const Affine m = tileFromTexture(tiles[t], tiles[t].layers[l]);
      painter.setTransform(QTransform(m.a, m.d, m.b, m.e, m.c, m.f));
      painter.drawImage(0, 0, images[t][l]);
    }
    painter.end();
    return grayOf(target.constBits(), std::size_t(target.bytesPerLine()));
  });
}
BENCHMARK(composeQPainter)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void composeCairo(benchmark::State& state) {
  const std::vector<Tile> tiles = kernelTiles();
  using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
  std::vector<std::vector<Surface>> surfaces(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const Layer& layer : tiles[t].layers) {
      const QImage image = premultiplied(layer);
      Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, kCells, kCells), cairo_surface_destroy);
      for (int y = 0; y < kCells; ++y) {
        std::memcpy(
            cairo_image_surface_get_data(surface.get()) + y * cairo_image_surface_get_stride(surface.get()),
            image.constScanLine(y), std::size_t(kCells) * 4);
      }
      cairo_surface_mark_dirty(surface.get());
      surfaces[t].push_back(std::move(surface));
    }
  }
  runKernel(state, tiles, [&](std::size_t t) {
    const Surface target(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, kTile, kTile),
                         cairo_surface_destroy);
    cairo_t* const context = cairo_create(target.get());
    cairo_set_source_rgb(context, 128 / 255.0, 128 / 255.0, 128 / 255.0);
    cairo_paint(context);
    for (std::size_t l = 0; l < surfaces[t].size(); ++l) {
      const Affine m = tileFromTexture(tiles[t], tiles[t].layers[l]);
      cairo_matrix_t matrix;
      cairo_matrix_init(&matrix, m.a, m.d, m.b, m.e, m.c, m.f);
      cairo_set_matrix(context, &matrix);
      cairo_set_source_surface(context, surfaces[t][l].get(), 0, 0);
      cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_BILINEAR);
      cairo_paint(context);
    }
    cairo_destroy(context);
    cairo_surface_flush(target.get());
    return grayOf(cairo_image_surface_get_data(target.get()),
                  std::size_t(cairo_image_surface_get_stride(target.get())));
  });
}
BENCHMARK(composeCairo)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void blend(const cv::Mat& layer, std::vector<std::uint8_t>& intensity) {
  for (int y = 0; y < kTile; ++y) {
    const std::uint8_t* const in = layer.ptr<std::uint8_t>(y);
    std::uint8_t* const out = intensity.data() + std::ptrdiff_t(y) * kTile;
    for (int x = 0; x < kTile; ++x) {
      const int kept = (out[x] * (255 - in[2 * x + 1]) + 127) / 255;
      out[x] = std::uint8_t(std::min(255, in[2 * x] + kept));
    }
  }
}

void composeOpenCv(benchmark::State& state) {
  cv::setNumThreads(1);
  const std::vector<Tile> tiles = kernelTiles();
  runKernel(state, tiles, [&](std::size_t t) {
    std::vector<std::uint8_t> intensity(std::size_t(kTile) * kTile, 128);
    for (const Layer& layer : tiles[t].layers) {
      const cv::Mat cells(kCells, kCells, CV_8UC2, const_cast<cells::CellPair*>(layer.cells.data()));
      const Affine m = tileFromTexture(tiles[t], layer);
      // OpenCV counts from the centres of cells and pixels.
      const cv::Matx23d matrix(m.a, m.b, m.c + (m.a + m.b) / 2 - 0.5, m.d, m.e, m.f + (m.d + m.e) / 2 - 0.5);
      cv::Mat warped;
      cv::warpAffine(cells, warped, matrix, {kTile, kTile}, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
      blend(warped, intensity);
    }
    return intensity;
  });
}
BENCHMARK(composeOpenCv)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

// `count` submaps side by side so that three layers of known cells lie on every spot.
std::vector<render::PlacedTexture> mapOf(int count) {
  constexpr double kSpacing = 7.3;
  constexpr std::size_t kDistinct = 64;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-2, 2), angle(-3.14, 3.14);
  std::vector<std::shared_ptr<const cells::CellTexture>> textures;
  while (textures.size() < std::min(kDistinct, std::size_t(count))) {
    textures.push_back(cells::CellTexture::fromPairs(kCells, kCells, kResolution, submapCells(random)));
  }
  const int across = int(std::ceil(std::sqrt(count)));
  std::vector<render::PlacedTexture> placed;
  for (int i = 0; i < count; ++i) {
    const double yaw = angle(random), half = kCells * kResolution / 2;
    const Eigen::Vector2d middle = geometry::Pose2{0, 0, yaw}.apply({-half, -half});
    render::PlacedTexture submap;
    submap.id = {0, i};
    submap.texture = textures[std::size_t(i) % textures.size()];
    submap.world_from_texture = {(i % across - across / 2) * kSpacing + jitter(random) - middle.x(),
                                 (i / across - across / 2) * kSpacing + jitter(random) - middle.y(), yaw};
    placed.push_back(std::move(submap));
  }
  return placed;
}

geometry::ViewTransform screen(double scale) {
  geometry::ViewTransform view;
  view.width_px = 1920;
  view.height_px = 1080;
  view.scale_m_per_px = scale;
  return view;
}

void waitUntilSettled(render::TileRenderer& renderer) {
  while (!renderer.settled()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

double milliseconds(const QElapsedTimer& timer) { return double(timer.nsecsElapsed()) / 1e6; }

// All poses of a map move a little, as after a loop closure, while the screen shows a part of it at 1:1.
void crispAfterAllPosesMoved(benchmark::State& state) {
  if (QCoreApplication::instance() == nullptr) {
    state.SkipWithError("needs a QCoreApplication");
    return;
  }
  auto placed = mapOf(int(state.range(0)));
  render::TileRenderer renderer({});
  renderer.setView(screen(kResolution));
  renderer.upsert(placed);
  waitUntilSettled(renderer);
  double upsert_ms = 0;
  for (auto _ : state) {
    for (auto& submap : placed) submap.world_from_texture.x_m += 0.011;
    QElapsedTimer timer;
    timer.start();
    renderer.upsert(placed);
    upsert_ms += milliseconds(timer);
    waitUntilSettled(renderer);
  }
  state.counters["upsert_ms"] = upsert_ms / double(state.iterations());
}
BENCHMARK(crispAfterAllPosesMoved)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// A whole map appears on an empty screen: when all of it can be seen, and when it is exact.
void wholeMap(benchmark::State& state) {
  if (QCoreApplication::instance() == nullptr) {
    state.SkipWithError("needs a QCoreApplication");
    return;
  }
  const auto placed = mapOf(int(state.range(0)));
  double preview_ms = 0;
  for (auto _ : state) {
    QElapsedTimer timer;
    timer.start();
    render::TileRenderer renderer({});
    renderer.upsert(placed);
    renderer.setView(screen(0.05).fitted(renderer.contentBounds(), 20));
    while (true) {
      const render::TileCounts counts = renderer.counts();
      if (counts.exact + counts.preview == counts.visible) break;
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    preview_ms += milliseconds(timer);
    waitUntilSettled(renderer);
    state.counters["tiles_MB"] = double(renderer.counts().cache_bytes) / 1e6;
  }
  state.counters["preview_ms"] = preview_ms / double(state.iterations());
}
BENCHMARK(wholeMap)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
