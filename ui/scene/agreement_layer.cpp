// Where submaps contradict each other, and how many saw a place. Both are sampled pixel by pixel from the
// tiles in view: there are no seams, and how many tiles there are hardly matters.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "agreement/heat.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

using agreement::kTileCells;
using agreement::Tile;
using agreement::TileKey;

constexpr int kCoarsest = 8;  // a tile is one value
// A square of this edge contains the centre of a pixel, however it is turned: none is ever lost.
constexpr double kLeastPx = 1.4143;
constexpr std::size_t kMostBytes = std::size_t(32) << 20;
constexpr int kRampAlpha = 185, kOnceAlpha = 120;

/// One value for each square of 2^level cells, row by row from the lowest x, y; 0 = nothing is drawn.
using Values = std::vector<std::uint8_t>;

int levelFor(double cell_px) {
  int level = 0;
  for (; level < kCoarsest && cell_px < kLeastPx; ++level) cell_px *= 2;
  return level;
}

class AgreementLayer : public DeviceLayer {
 public:
  struct Palette {
    std::array<QRgb, 256> colors{};  // of a value; premultiplied
    QRgb hatch = 0;                  // of the lines over value 1; 0 = none
  };
  using DeviceLayer::DeviceLayer;
  void setActive(bool active) override {
    if (!active) forget();
  }
  std::size_t cacheBytes() const override { return bytes_; }

 protected:
  virtual bool shows(const Tile& tile) const = 0;
  virtual Values valuesOf(const Tile& tile, int level) const = 0;
  virtual Palette palette() const = 0;

  void onViewChanged(const geometry::ViewTransform& device_view) override { view_ = device_view; }
  void paintPixels(QPainter& painter, const QRectF& exposed) override;

 private:
  struct Kept {
    std::shared_ptr<const Tile> tile;
    Values values;
  };
  void forget() {
    kept_.clear();
    bytes_ = 0;
  }
  void keepOnlyThose();
  const Values& values(TileKey key, const std::shared_ptr<const Tile>& tile, int level);
  void paintDots(QPainter& painter, const Palette& palette, const geometry::WorldRect& seen);
  void paintCells(QImage& image, const QPoint& at, const Palette& palette, const geometry::WorldRect& seen,
                  int level);

  std::optional<geometry::ViewTransform> view_;  // in device pixels
  std::shared_ptr<const agreement::Tiles> of_;   // what is kept
  std::map<std::pair<int, TileKey>, Kept> kept_;
  std::size_t bytes_ = 0;
};

void AgreementLayer::keepOnlyThose() {
  if (bytes_ > kMostBytes || !context_.agreement) forget();
  if (std::exchange(of_, context_.agreement) == context_.agreement) return;
  std::erase_if(kept_, [this](const auto& entry) {
    const auto now = of_->find(entry.first.second);
    const bool gone = now == of_->end() || now->second != entry.second.tile;
    if (gone) bytes_ -= entry.second.values.size();
    return gone;
  });
}

const Values& AgreementLayer::values(TileKey key, const std::shared_ptr<const Tile>& tile, int level) {
  const auto [at, is_new] = kept_.try_emplace({level, key});
  if (is_new) {
    at->second = {tile, valuesOf(*tile, level)};
    bytes_ += at->second.values.size();
  }
  return at->second.values;
}

void AgreementLayer::paintPixels(QPainter& painter, const QRectF& exposed) {
  if (!view_) viewMoved();
  keepOnlyThose();
  if (!of_ || of_->empty()) return;
  const QRect area = exposed.toAlignedRect() & QRect(0, 0, view_->width_px, view_->height_px);
  if (area.isEmpty()) return;
  geometry::WorldRect seen;
  for (const double x : {area.left(), area.right() + 1}) {
    for (const double y : {area.top(), area.bottom() + 1}) seen.extend(view_->worldFromPixel({x, y}));
  }
  const double cell_px = context_.agreement_cell_m / view_->scale_m_per_px;
  if (cell_px * kTileCells < kLeastPx) return paintDots(painter, palette(), seen);
  QImage image(area.size(), QImage::Format_ARGB32_Premultiplied);
  if (image.isNull()) return;  // no memory
  image.fill(Qt::transparent);
  paintCells(image, area.topLeft(), palette(), seen, levelFor(cell_px));
  painter.drawImage(area.topLeft(), image);
}

/// Tiles are smaller than pixels.
void AgreementLayer::paintDots(QPainter& painter, const Palette& palette, const geometry::WorldRect& seen) {
  for (const auto& [key, tile] : *of_) {
    const geometry::WorldRect bounds = agreement::boundsOf(key, context_.agreement_cell_m);
    if (!shows(*tile) || !bounds.intersects(seen)) continue;
    const QColor color =
        QColor::fromRgba(qUnpremultiply(palette.colors[values(key, tile, kCoarsest).front()]));
    painter.fillRect(squareAround(toPoint(view_->pixelFromWorld(bounds.center())), kLeastPx / 2), color);
  }
}

void AgreementLayer::paintCells(QImage& image, const QPoint& at, const Palette& palette,
                                const geometry::WorldRect& seen, int level) {
  struct InView {
    TileKey key;
    const Values* values;
  };
  const double tile_m = kTileCells * context_.agreement_cell_m;
  std::vector<InView> in_view;
  TileKey first{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
  TileKey last{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};
  for (const auto& [key, tile] : *of_) {
    if (!shows(*tile) || !agreement::boundsOf(key, context_.agreement_cell_m).intersects(seen)) continue;
    in_view.push_back({key, &values(key, tile, level)});
    first = {std::min(first.column, key.column), std::min(first.row, key.row)};
    last = {std::max(last.column, key.column), std::max(last.row, key.row)};
  }
  if (in_view.empty()) return;
  // A tile is larger than a pixel: these are not many.
  const int columns = last.column - first.column + 1, rows = last.row - first.row + 1;
  std::vector<const std::uint8_t*> tiles(std::size_t(columns) * std::size_t(rows));
  for (const InView& one : in_view) {
    tiles[std::size_t(one.key.row - first.row) * std::size_t(columns) +
          std::size_t(one.key.column - first.column)] = one.values->data();
  }
  const int edge = kTileCells >> level, edge_bits = std::countr_zero(unsigned(edge));
  const double value_m = tile_m / edge;
  const Eigen::Vector2d origin = view_->worldFromPixel({0.5, 0.5}) / value_m;
  const Eigen::Vector2d right = view_->worldFromPixelVector({1, 0}) / value_m;
  const Eigen::Vector2d down = view_->worldFromPixelVector({0, 1}) / value_m;
  const double first_x = double(first.column) * edge, first_y = double(first.row) * edge;
  const double width = double(columns) * edge, height = double(rows) * edge;
  const QPointF hatch_at = hatchOrigin(*view_);
  const int hatch_phase = int(hatch_at.x() + hatch_at.y());
  for (int y = 0; y < image.height(); ++y) {
    auto* const line = reinterpret_cast<QRgb*>(image.scanLine(y));
    const Eigen::Vector2d row = origin + down * (at.y() + y);
    for (int x = 0; x < image.width(); ++x) {
      // Whole numbers first: what a pixel shows does not depend on the part that is painted.
      const double from_left = std::floor(row.x() + right.x() * (at.x() + x)) - first_x;
      const double from_lowest = std::floor(row.y() + right.y() * (at.x() + x)) - first_y;
      if (!(from_left >= 0 && from_left < width && from_lowest >= 0 && from_lowest < height)) continue;
      const int column = int(from_left), value_row = int(from_lowest);
      const std::uint8_t* const tile = tiles[std::size_t(value_row >> edge_bits) * std::size_t(columns) +
                                             std::size_t(column >> edge_bits)];
      if (!tile) continue;
      const std::uint8_t value = tile[(value_row & (edge - 1)) * edge + (column & (edge - 1))];
      const bool hatched =
          value == 1 && palette.hatch != 0 && ((at.x() + x + at.y() + y - hatch_phase) & 7) < 2;
      line[x] = hatched ? palette.hatch : palette.colors[value];
    }
  }
}

/// Zoomed out, a square is marked if one of its cells contradicts.
class DisagreementLayer : public AgreementLayer {
 public:
  using AgreementLayer::AgreementLayer;
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (!context_.agreement) return bounds;
    for (const auto& [key, tile] : *context_.agreement) {
      for (const auto& [square, findings] : tile->squares)
        bounds.extend(
            geometry::WorldRect{double(square.x), double(square.y), square.x + 1.0, square.y + 1.0});
    }
    return bounds;
  }

 protected:
  bool shows(const Tile& tile) const override { return tile.contradicted_cells > 0; }
  Values valuesOf(const Tile& tile, int level) const override {
    const int edge = kTileCells >> level;
    Values values(std::size_t(edge) * std::size_t(edge));
    for (int row = 0; row < kTileCells; ++row) {
      for (int word = 0; word < Tile::kWords; ++word) {
        for (std::uint64_t bits = tile.contradicted[std::size_t(row * Tile::kWords + word)]; bits != 0;
             bits &= bits - 1) {
          const int column = word * 64 + std::countr_zero(bits);
          values[std::size_t((row >> level) * edge + (column >> level))] = 1;
        }
      }
    }
    return values;
  }
  Palette palette() const override {
    Palette palette;
    palette.colors[1] = colorOr(context_.theme.bad).rgba();
    return palette;
  }
};

/// Those of pictures, so that the map below is seen.
AgreementLayer::Palette coveragePalette() {
  Tile counts;
  constexpr std::size_t kRow = kTileCells;  // its first cells have no line of the hatching
  for (std::size_t seen_by = 0; seen_by < kTileCells; ++seen_by)
    counts.seen_by[kRow + seen_by] = std::uint8_t(seen_by);
  counts.seen_by[0] = 1;
  const agreement::Shades shades = agreement::CoverageHeat::shades(counts);
  const std::span<const agreement::Argb> colors = agreement::CoverageHeat::colors();
  AgreementLayer::Palette palette;
  for (std::size_t seen_by = 1; seen_by < palette.colors.size(); ++seen_by) {
    const QRgb color = colors[shades[kRow + seen_by]];
    const int alpha = seen_by == 1 ? kOnceAlpha : kRampAlpha;
    palette.colors[seen_by] = qPremultiply(qRgba(qRed(color), qGreen(color), qBlue(color), alpha));
  }
  palette.hatch = colors[shades[0]];
  return palette;
}

/// Zoomed out, a square shows the mean of its cells that were seen.
class CoverageLayer : public AgreementLayer {
 public:
  using AgreementLayer::AgreementLayer;
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (!context_.agreement) return bounds;
    for (const auto& [key, tile] : *context_.agreement)
      bounds.extend(agreement::boundsOf(key, context_.agreement_cell_m));
    return bounds;
  }

 protected:
  bool shows(const Tile& tile) const override { return tile.seen_cells > 0; }
  Values valuesOf(const Tile& tile, int level) const override {
    if (level == 0) return {tile.seen_by.begin(), tile.seen_by.end()};
    const int step = 1 << level, edge = kTileCells >> level;
    Values values;
    values.reserve(std::size_t(edge) * std::size_t(edge));
    for (int top = 0; top < kTileCells; top += step) {
      std::array<std::uint16_t, kTileCells> sums{}, seen{};  // of columns; at most 256 * 255
      for (int row = top; row < top + step; ++row) {
        const std::uint8_t* const cells = tile.seen_by.data() + row * kTileCells;
        for (std::size_t column = 0; column < kTileCells; ++column) {
          sums[column] = std::uint16_t(sums[column] + cells[column]);
          seen[column] = std::uint16_t(seen[column] + (cells[column] != 0));
        }
      }
      for (int left = 0; left < kTileCells; left += step) {
        std::uint32_t sum = 0, count = 0;
        for (int column = left; column < left + step; ++column) {
          sum += sums[std::size_t(column)];
          count += seen[std::size_t(column)];
        }
        values.push_back(std::uint8_t(count == 0 ? 0 : (sum + count / 2) / count));
      }
    }
    return values;
  }
  Palette palette() const override {
    static const Palette palette = coveragePalette();
    return palette;
  }
};

/// Everything in view, contradicted; `seen_by` gets columns of 2 pixels, counted from the middle.
void fillSample(LegendSample& sample, const std::function<int(int column)>& seen_by) {
  auto tiles = std::make_shared<agreement::Tiles>();
  for (const int tile_column : {-1, 0}) {
    auto tile = std::make_shared<Tile>();
    for (std::size_t cell = 0; cell < tile->seen_by.size(); ++cell)
      tile->seen_by[cell] = std::uint8_t(seen_by(int(cell % kTileCells) + tile_column * kTileCells));
    tile->contradicted.fill(~std::uint64_t(0));
    tile->seen_cells = tile->contradicted_cells = tile->seen_by.size();
    for (const int tile_row : {-1, 0}) tiles->emplace(TileKey{tile_column, tile_row}, tile);
  }
  sample.context.agreement = std::move(tiles);
  sample.context.agreement_cell_m = 2 * LegendSample::kMPerPx;
}

void coverageLegend(Legend& legend) {
  legend.addSample(LegendText::tr("Seen by one submap only: unverified"),
                   [](LegendSample& sample) { fillSample(sample, [](int) { return 1; }); });
  const auto step = [&](const QString& text, int most) {
    legend.addSample(text,
                     [most](LegendSample& sample) { fillSample(sample, [most](int) { return most; }); });
  };
  step(LegendText::tr("Seen by 2 submaps"), 2);
  step(LegendText::tr("3 to 4"), 4);
  step(LegendText::tr("5 to 8"), 8);
  step(LegendText::tr("9 to 16"), 16);
  step(LegendText::tr("17 or more"), 17);
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Coverage>() {
  return {.name = "coverage",
          .title = QT_TRANSLATE_NOOP("scene", "Coverage"),
          .shown = false,
          .follows_robot = false,
          .in_all = false,
          .not_in_all_reason = QT_TRANSLATE_NOOP("scene", "covers the map"),
          .why_empty = noSubmapsReason,
          .items = oneItem<CoverageLayer>,
          .legend = coverageLegend};
}

template <>
LayerSpec layerSpec<Layer::Disagreement>() {
  return {.name = "disagreement",
          .title = QT_TRANSLATE_NOOP("scene", "Disagreement"),
          .shown = false,
          .follows_robot = false,
          .in_all = false,
          .not_in_all_reason = QT_TRANSLATE_NOOP("scene", "takes a while"),
          .traits = [] { return LayerTraits{.color = true}; },
          .why_empty = noSubmapsReason,
          .items = oneItem<DisagreementLayer>,
          .legend =
              [](Legend& legend) {
                legend.addSample(LegendText::tr("Occupied in one submap, free in another"),
                                 [](LegendSample& sample) { fillSample(sample, [](int) { return 2; }); });
              }};
}

}  // namespace mapwright::ui::scene
