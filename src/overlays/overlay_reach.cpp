#include "overlays/overlay_reach.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "grids/grid_cells.h"
#include "overlays/overlay_check.h"
#include "overlays/overlay_shapes.h"
#include "overlays/overlay_types.h"

namespace mapwright::overlays {
namespace {

using Eigen::Vector2d;

constexpr std::uint8_t kWay = 255;
constexpr double kAsideM = 0.5;

/// The map as an image: kWay where a robot may be, else 0.
class WayMap {
 public:
  explicit WayMap(const placing::PlacedMap& map) : map_(map) {
    const grids::GridPyramid& cells = *map.cells;
    while (std::int64_t(cells.levelWidth(level_)) * cells.levelHeight(level_) > kMostCells &&
           level_ + 1 < cells.levels())
      ++level_;
    image_ = cv::Mat(cells.levelHeight(level_), cells.levelWidth(level_), CV_8U, cv::Scalar(0));
    read();
  }

  cv::Mat& image() { return image_; }
  double cellM() const { return map_.reference.resolution_m * (1 << level_); }
  /// Continuous.
  Vector2d cellOf(const Vector2d& world_m) const {
    return map_.reference.cellFromWorld(world_m) / double(1 << level_);
  }
  cv::Point pixelOf(const Vector2d& world_m) const {
    // Far outside OpenCV's numbers would wrap.
    const Vector2d cell = cellOf(world_m).cwiseMax(-1e6).cwiseMin(1e6);
    return {int(std::floor(cell.x())), int(std::floor(cell.y()))};
  }

 private:
  void read() {
    constexpr int kEdge = grids::GridPyramid::kTileEdge;
    const grids::CellMeaning& meaning = grids::meaningOf(map_.cells->code());
    std::array<std::uint8_t, 256> way{};
    for (std::size_t byte = 0; byte < 256; ++byte)
      way[byte] = meaning.known[byte] && meaning.occupancy[byte] < placing::kOccupiedPercent ? kWay : 0;
    for (int tile_y = 0; tile_y * kEdge < image_.rows; ++tile_y) {
      for (int tile_x = 0; tile_x * kEdge < image_.cols; ++tile_x) {
        const auto tile = map_.cells->tile(level_, tile_x, tile_y);
        if (!tile) continue;
        const int width = std::min(kEdge, image_.cols - tile_x * kEdge);
        const int height = std::min(kEdge, image_.rows - tile_y * kEdge);
        for (int y = 0; y < height; ++y) {
          const std::uint8_t* from = tile->cells.get() + y * kEdge;
          std::uint8_t* to = image_.ptr(tile_y * kEdge + y) + tile_x * kEdge;
          std::transform(from, from + width, to, [&](std::uint8_t byte) { return way[byte]; });
        }
      }
    }
  }

  const placing::PlacedMap& map_;
  int level_ = 0;
  cv::Mat image_;
};

void draw(WayMap& ways, const Path& path, bool filled, std::uint8_t value) {
  std::vector<cv::Point> pixels;
  for (const Vector2d& point : path.points) pixels.push_back(ways.pixelOf(point));
  if (pixels.empty()) return;
  if (filled) {
    cv::fillPoly(ways.image(), std::vector<std::vector<cv::Point>>{pixels}, cv::Scalar(value));
  } else {
    cv::polylines(ways.image(), std::vector<std::vector<cv::Point>>{pixels}, false, cv::Scalar(value));
  }
}

void drawAll(WayMap& ways, const OverlayDocument& document, Shape shape, int type, std::uint8_t value) {
  for (const Feature& feature : document.features()) {
    if (feature.shape() != shape || feature.type() != type) continue;
    for (const Path& path : shapesOf(feature).paths) draw(ways, path, shape == Shape::Polygon, value);
  }
}

/// Labels of connected ways around a place, nearest first.
class Places {
 public:
  Places(const WayMap& ways, const cv::Mat& labels, double reach_m)
      : ways_(ways), labels_(labels), reach_cells_(reach_m / ways.cellM()) {}

  /// All labels in reach. Empty: there is no way near it.
  std::set<int> near(const Vector2d& world_m) const {
    std::set<int> found;
    const Vector2d cell = ways_.cellOf(world_m);
    const int reach = int(std::ceil(reach_cells_));
    const int column = int(std::floor(std::clamp(cell.x(), -1e6, 1e6)));
    const int row = int(std::floor(std::clamp(cell.y(), -1e6, 1e6)));
    for (int y = std::max(0, row - reach); y <= std::min(labels_.rows - 1, row + reach); ++y) {
      for (int x = std::max(0, column - reach); x <= std::min(labels_.cols - 1, column + reach); ++x) {
        const int label = labels_.at<int>(y, x);
        if (label > 0 && (Vector2d(x + 0.5, y + 0.5) - cell).norm() <= reach_cells_ + 0.5)
          found.insert(label);
      }
    }
    return found;
  }

 private:
  const WayMap& ways_;
  const cv::Mat& labels_;
  double reach_cells_;
};

}  // namespace

std::vector<std::size_t> unreachable(const OverlayDocument& document, const placing::PlacedMap& map,
                                     double radius_m) {
  std::vector<std::size_t> found;
  if (!map.cells || map::whyUnusable(map.reference)) return found;
  WayMap ways(map);
  drawAll(ways, document, Shape::Polygon, kFreeRegion, kWay);
  drawAll(ways, document, Shape::Polygon, kForbiddenRegion, 0);
  drawAll(ways, document, Shape::Line, kVirtualWall, 0);
  // The map ends like a wall.
  cv::rectangle(ways.image(), cv::Rect(0, 0, ways.image().cols, ways.image().rows), cv::Scalar(0));
  // A robot of this radius has room where the next obstacle is that far.
  cv::Mat distance, labels;
  cv::distanceTransform(ways.image(), distance, cv::DIST_L2, cv::DIST_MASK_5);
  const double radius_cells = std::max(0.0, radius_m / ways.cellM());
  const cv::Mat room = distance > std::max(0.5, radius_cells);
  distance.release();
  cv::connectedComponents(room, labels, 4, CV_32S);
  const Places places(ways, labels, std::max(0.0, radius_m) + kAsideM);
  std::set<int> from_chargers;
  bool any = false;
  const std::vector<Feature>& features = document.features();
  for (const Feature& feature : features) {
    if (feature.shape() != Shape::Point || feature.type() != kCharger) continue;
    if (const auto at = shapesOf(feature).somewhere()) {
      const std::set<int> near = places.near(*at);
      from_chargers.insert(near.begin(), near.end());
      any |= !near.empty();
    }
  }
  if (!any) return found;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!isDestination(features[i])) continue;
    const auto at = shapesOf(features[i]).somewhere();
    if (!at) continue;
    const std::set<int> near = places.near(*at);
    const bool reached =
        std::any_of(near.begin(), near.end(), [&](int label) { return from_chargers.contains(label); });
    if (!reached) found.push_back(i);
  }
  return found;
}

}  // namespace mapwright::overlays
