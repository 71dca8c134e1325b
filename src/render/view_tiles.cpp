#include "render/view_tiles.h"

#include <algorithm>
#include <cmath>

namespace mapwright::render {
namespace {

constexpr double kFarthestPixel = double(std::int64_t(1) << 50);
constexpr double kFarthestTile = kFarthestPixel / kTileEdge;
constexpr std::size_t kTileBytes = 256;

bool usable(const geometry::ViewTransform& view) {
  // Orders of magnitude beyond the limits of geometry::ViewTransform, and still safe for arithmetic.
  constexpr double kFinest = 1e-9, kCoarsest = 1e9, kFarthestM = 1e15;
  return view.width_px > 0 && view.height_px > 0 && view.scale_m_per_px >= kFinest &&
         view.scale_m_per_px <= kCoarsest && std::isfinite(view.rotation_rad) &&
         std::abs(view.center_m.x()) <= kFarthestM && std::abs(view.center_m.y()) <= kFarthestM;
}

std::size_t bytesOf(const Picture& picture) {
  return std::size_t(picture.image.sizeInBytes()) + (picture.pixels ? render::bytesOf(*picture.pixels) : 0);
}

}  // namespace

bool ViewTiles::rasterChanges(const geometry::ViewTransform& view) const {
  if (snapshot_) return !(view == view_);
  return view.scale_m_per_px != view_.scale_m_per_px || view.rotation_rad != view_.rotation_rad;
}

void ViewTiles::setView(const geometry::ViewTransform& view) {
  if (rasterChanges(view)) clear();
  view_ = view;
  visible_.clear();
  if (!usable(view)) return;
  raster_ = {};
  raster_.scale_m_per_px = view.scale_m_per_px;
  raster_.rotation_rad = view.rotation_rad;
  offset_x_ = offset_y_ = 0;
  if (snapshot_) {
    raster_.origin_m = view.worldFromPixel({0, 0});
  } else {
    const Eigen::Vector2d origin = view.pixelFromWorld({0, 0});
    offset_x_ = std::round(origin.x());
    offset_y_ = std::round(origin.y());
  }
  if (std::abs(offset_x_) < kFarthestPixel && std::abs(offset_y_) < kFarthestPixel) listVisible();
}

void ViewTiles::listVisible() {
  ++views_;
  const auto tileOf = [](double pixel) { return std::int64_t(std::floor(pixel / kTileEdge)); };
  const std::int64_t x0 = tileOf(-offset_x_), x1 = tileOf(view_.width_px - 1 - offset_x_);
  const std::int64_t y0 = tileOf(-offset_y_), y1 = tileOf(view_.height_px - 1 - offset_y_);
  for (std::int64_t y = y0; y <= y1; ++y) {
    for (std::int64_t x = x0; x <= x1; ++x) {
      visible_.push_back({x, y});
      if (ViewTile* const tile = find({x, y})) tile->last_visible = views_;
    }
  }
  const double middle_x = view_.width_px / 2.0 - kTileEdge / 2.0,
               middle_y = view_.height_px / 2.0 - kTileEdge / 2.0;
  const auto distance = [&](const TileKey& key) {
    const QPointF offset = offsetOf(key);
    return std::hypot(offset.x() - middle_x, offset.y() - middle_y);
  };
  std::stable_sort(visible_.begin(), visible_.end(),
                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

ViewTile& ViewTiles::at(const TileKey& key) {
  const auto [found, added] = tiles_.try_emplace(key);
  if (added) {
    found->second.last_visible = views_;
    found->second.picture.grid = gridOf(key);
    bytes_ += kTileBytes;
  }
  return found->second;
}

ViewTile* ViewTiles::find(const TileKey& key) {
  const auto found = tiles_.find(key);
  return found == tiles_.end() ? nullptr : &found->second;
}

const ViewTile* ViewTiles::find(const TileKey& key) const {
  const auto found = tiles_.find(key);
  return found == tiles_.end() ? nullptr : &found->second;
}

PixelGrid ViewTiles::gridOf(const TileKey& key) const {
  PixelGrid grid = raster_;
  grid.first_column = key.x * kTileEdge;
  grid.first_row = key.y * kTileEdge;
  grid.width_px = grid.height_px = kTileEdge;
  if (snapshot_) {
    grid.width_px = int(std::min<std::int64_t>(kTileEdge, view_.width_px - grid.first_column));
    grid.height_px = int(std::min<std::int64_t>(kTileEdge, view_.height_px - grid.first_row));
  }
  return grid;
}

QPointF ViewTiles::offsetOf(const TileKey& key) const {
  return {offset_x_ + double(key.x * kTileEdge), offset_y_ + double(key.y * kTileEdge)};
}

std::optional<ViewTiles::Pixel> ViewTiles::pixelAt(const Eigen::Vector2d& world_m) const {
  if (visible_.empty()) return std::nullopt;
  const double c = std::cos(raster_.rotation_rad), s = std::sin(raster_.rotation_rad);
  const Eigen::Vector2d d = (world_m - raster_.origin_m) / raster_.scale_m_per_px;
  const double column = std::floor(c * d.x() - s * d.y()), row = std::floor(-(s * d.x() + c * d.y()));
  if (!(std::abs(column) < kFarthestPixel && std::abs(row) < kFarthestPixel)) return std::nullopt;
  const TileKey key{std::int64_t(std::floor(column / kTileEdge)), std::int64_t(std::floor(row / kTileEdge))};
  return Pixel{key, int(std::int64_t(column) - key.x * kTileEdge),
               int(std::int64_t(row) - key.y * kTileEdge)};
}

ViewTiles::KeyRange ViewTiles::keysUnder(const geometry::WorldRect& rect) const {
  const double c = std::cos(raster_.rotation_rad), s = std::sin(raster_.rotation_rad);
  geometry::WorldRect pixels;
  for (const double x : {rect.min_x, rect.max_x}) {
    for (const double y : {rect.min_y, rect.max_y}) {
      const Eigen::Vector2d d = (Eigen::Vector2d(x, y) - raster_.origin_m) / raster_.scale_m_per_px;
      pixels.extend(Eigen::Vector2d(c * d.x() - s * d.y(), -(s * d.x() + c * d.y())));
    }
  }
  if (!std::isfinite(pixels.width() + pixels.height())) {
    return {-kFarthestTile, -kFarthestTile, kFarthestTile, kFarthestTile};
  }
  // A pixel more for the rounding of the corners.
  const auto tileOf = [](double pixel) {
    return std::clamp(std::floor(pixel / kTileEdge), -kFarthestTile, kFarthestTile);
  };
  return {tileOf(pixels.min_x - 1), tileOf(pixels.min_y - 1), tileOf(pixels.max_x + 1),
          tileOf(pixels.max_y + 1)};
}

void ViewTiles::setPicture(ViewTile& tile, std::shared_ptr<const Composition> pixels, QImage image,
                           std::uint64_t colors) {
  bytes_ -= bytesOf(tile.picture);
  tile.picture.pixels = std::move(pixels);
  tile.picture.image = std::move(image);
  tile.colors = colors;
  bytes_ += bytesOf(tile.picture);
}

std::vector<Picture> ViewTiles::pictures(std::size_t others) const {
  std::vector<Picture> pictures;
  for (const auto& [key, tile] : tiles_) {
    if (tile.picture.image.isNull()) continue;
    const bool in_view = !visible_.empty() && tile.last_visible == views_;
    if (!in_view && others == 0) continue;
    if (!in_view) --others;
    pictures.push_back(tile.picture);
  }
  return pictures;
}

void ViewTiles::clear() {
  tiles_.clear();
  bytes_ = 0;
}

void ViewTiles::trim(std::size_t budget_bytes) {
  if (bytes_ <= budget_bytes) return;
  std::vector<std::pair<std::uint64_t, TileKey>> hidden;
  for (const auto& [key, tile] : tiles_) {
    if (tile.last_visible != views_ && tile.exact_work == 0 && tile.preview_work == 0) {
      hidden.emplace_back(tile.last_visible, key);
    }
  }
  std::sort(hidden.begin(), hidden.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [last_visible, key] : hidden) {
    if (bytes_ <= budget_bytes) return;
    bytes_ -= bytesOf(tiles_.at(key).picture) + kTileBytes;
    tiles_.erase(key);
  }
}

}  // namespace mapwright::render
