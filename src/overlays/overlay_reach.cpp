#include "overlays/overlay_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include <opencv2/imgproc.hpp>
#include <queue>

#include "grids/grid_cells.h"
#include "grids/grid_pyramid.h"
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
    // Of every thread that OpenCV's own threads have helped it keeps something for ever.
    cv::setNumThreads(1);
    const grids::GridPyramid& cells = *map.cells;
    while (std::int64_t(cells.levelWidth(level_)) * cells.levelHeight(level_) > kMostCells &&
           level_ + 1 < cells.levels())
      ++level_;
    image_ = cv::Mat(cells.levelHeight(level_), cells.levelWidth(level_), CV_8U, cv::Scalar(0));
    read();
  }

  cv::Mat& image() { return image_; }
  const cv::Mat& image() const { return image_; }
  double cellM() const { return map_.reference.resolution_m * (1 << level_); }
  /// Continuous.
  Vector2d cellOf(const Vector2d& world_m) const {
    return map_.reference.cellFromWorld(world_m) / double(1 << level_);
  }
  Vector2d worldOf(const Vector2d& cell) const {
    return map_.reference.worldFromCell(cell * double(1 << level_));
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

/// Labels of connected ways around a place.
class WayLabels {
 public:
  /// `map_free`: without overlays.
  WayLabels(const WayMap& ways, const cv::Mat& map_free, const cv::Mat& labels, double reach_m)
      : ways_(ways), map_free_(map_free), labels_(labels), reach_cells_(reach_m / ways.cellM()) {}

  /// All labels in reach, not through walls or forbidden regions. Empty: there is no way near it.
  std::set<int> near(const Vector2d& world_m) const {
    std::set<int> found;
    const Vector2d cell = ways_.cellOf(world_m);
    const int reach = int(std::ceil(reach_cells_));
    const int column = int(std::floor(std::clamp(cell.x(), -1e6, 1e6)));
    const int row = int(std::floor(std::clamp(cell.y(), -1e6, 1e6)));
    for (int y = std::max(0, row - reach); y <= std::min(labels_.rows - 1, row + reach); ++y) {
      for (int x = std::max(0, column - reach); x <= std::min(labels_.cols - 1, column + reach); ++x) {
        const int label = labels_.at<int>(y, x);
        if (label > 0 && !found.contains(label) &&
            (Vector2d(x + 0.5, y + 0.5) - cell).norm() <= reach_cells_ + 0.5 && isOpen({column, row}, {x, y}))
          found.insert(label);
      }
    }
    return found;
  }

 private:
  /// What stands in a wall of the map comes out of it, and into no other.
  bool isOpen(const cv::Point& from, const cv::Point& to) const {
    bool inside = true;
    // Only sideways: a wall drawn askew has no gaps then.
    cv::LineIterator line(cv::Rect(0, 0, labels_.cols, labels_.rows), from, to, 4);
    for (int i = 0; i < line.count; ++i, ++line) {
      const bool free = ways_.image().at<std::uint8_t>(line.pos()) != 0;
      if (!free && (!inside || map_free_.at<std::uint8_t>(line.pos()) != 0)) return false;
      inside = inside && !free;
    }
    return true;
  }

  const WayMap& ways_;
  const cv::Mat &map_free_, &labels_;
  double reach_cells_;
};

/// Where a robot of a radius gets from the chargers.
class Reach {
 public:
  Reach(const OverlayDocument& document, const placing::PlacedMap& map, double radius_m)
      : ways_(map), reach_m_(std::max(0.0, radius_m) + kAsideM) {
    const auto drawEdge = [](cv::Mat& image) {  // the map ends like a wall
      cv::rectangle(image, cv::Rect(0, 0, image.cols, image.rows), cv::Scalar(0));
    };
    drawEdge(ways_.image());
    ways_.image().copyTo(map_free_);
    drawAll(ways_, document, Shape::Polygon, kFreeRegion, kWay);
    drawAll(ways_, document, Shape::Polygon, kForbiddenRegion, 0);
    drawAll(ways_, document, Shape::Line, kVirtualWall, 0);
    drawEdge(ways_.image());
    // A robot of this radius has room where the next obstacle is that far.
    cv::Mat distance;
    cv::distanceTransform(ways_.image(), distance, cv::DIST_L2, cv::DIST_MASK_5);
    const double radius_cells = std::max(0.0, radius_m / ways_.cellM());
    const cv::Mat room = distance > std::max(0.5, radius_cells);
    distance.release();
    cv::connectedComponents(room, labels_, 4, CV_32S);
    const WayLabels way_labels(ways_, map_free_, labels_, reach_m_);
    for (const Feature& feature : document.features()) {
      if (feature.shape() != Shape::Point || feature.type() != kCharger) continue;
      const auto at = shapesOf(feature).somewhere();
      if (!at) continue;
      const std::set<int> near = way_labels.near(*at);
      from_chargers_.insert(near.begin(), near.end());
      if (!near.empty()) chargers_.push_back(*at);
    }
  }

  bool anyCharger() const { return !chargers_.empty(); }
  bool reaches(const Vector2d& at_m) const {
    const std::set<int> near = WayLabels(ways_, map_free_, labels_, reach_m_).near(at_m);
    return std::any_of(near.begin(), near.end(), [&](int label) { return from_chargers_.contains(label); });
  }

  std::optional<Way> wayTo(const Vector2d& at_m) const {
    if (chargers_.empty()) return std::nullopt;
    const cv::Mat cost = costs();
    const auto cellAt = [&](const Vector2d& world_m) {
      const cv::Point pixel = ways_.pixelOf(world_m);
      return cv::Point(std::clamp(pixel.x / step_, 0, cost.cols - 1),
                       std::clamp(pixel.y / step_, 0, cost.rows - 1));
    };
    // Dijkstra from all chargers at once.
    constexpr int kFar = std::numeric_limits<int>::max();
    cv::Mat length(cost.size(), CV_32S, cv::Scalar(kFar));
    cv::Mat from(cost.size(), CV_8U, cv::Scalar(8));
    using Entry = std::pair<int, int>;  // length, index
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const Vector2d& charger : chargers_) {
      const cv::Point start = cellAt(charger);
      length.at<int>(start) = 0;
      open.emplace(0, start.y * cost.cols + start.x);
    }
    const std::array<cv::Point, 8> steps{cv::Point{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                         {1, 1},          {-1, 1}, {1, -1}, {-1, -1}};
    const cv::Point goal = cellAt(at_m);
    while (!open.empty()) {
      const auto [so_far, index] = open.top();
      open.pop();
      const cv::Point at(index % cost.cols, index / cost.cols);
      if (so_far > length.at<int>(at)) continue;
      if (at == goal) break;
      for (std::size_t i = 0; i < steps.size(); ++i) {
        const cv::Point next = at + steps[i];
        if (next.x < 0 || next.y < 0 || next.x >= cost.cols || next.y >= cost.rows) continue;
        const int longer = so_far + cost.at<std::int16_t>(next) * (i < 4 ? 10 : 14);
        if (longer >= length.at<int>(next)) continue;
        length.at<int>(next) = longer;
        from.at<std::uint8_t>(next) = std::uint8_t(i);
        open.emplace(longer, next.y * cost.cols + next.x);
      }
    }
    std::vector<cv::Point> cells{goal};
    while (from.at<std::uint8_t>(cells.back()) < steps.size())
      cells.push_back(cells.back() - steps[from.at<std::uint8_t>(cells.back())]);
    std::reverse(cells.begin(), cells.end());
    return split(cells, at_m);
  }

 private:
  static constexpr std::int64_t kMostSearched = 4'000'000;
  static constexpr int kRoom = 1, kNarrow = 20, kWall = 300;

  /// Of cells that are `step_` times as large: what it costs to be there. Cells with room that no charger
  /// leads to have the cost of room, too.
  cv::Mat costs() const {
    while (std::int64_t(labels_.cols / step_) * (labels_.rows / step_) > kMostSearched) ++step_;
    cv::Mat cost((labels_.rows + step_ - 1) / step_, (labels_.cols + step_ - 1) / step_, CV_16S,
                 cv::Scalar(kWall));
    for (int y = 0; y < labels_.rows; ++y) {
      const int* const label = labels_.ptr<int>(y);
      const std::uint8_t* const free = map_free_.ptr(y);
      const std::uint8_t* const way = ways_.image().ptr(y);
      std::int16_t* const out = cost.ptr<std::int16_t>(y / step_);
      for (int x = 0; x < labels_.cols; ++x) {
        const int here = label[x] > 0 ? kRoom : free[x] || way[x] ? kNarrow : kWall;
        std::int16_t& coarse = out[x / step_];
        coarse = std::int16_t(std::min<int>(coarse, here));
      }
    }
    return cost;
  }

  bool leadsHere(const cv::Point& coarse) const {
    for (int y = coarse.y * step_; y < std::min((coarse.y + 1) * step_, labels_.rows); ++y) {
      for (int x = coarse.x * step_; x < std::min((coarse.x + 1) * step_, labels_.cols); ++x) {
        if (from_chargers_.contains(labels_.at<int>(y, x))) return true;
      }
    }
    return false;
  }

  Way split(const std::vector<cv::Point>& cells, const Vector2d& at_m) const {
    // Chargers may stand in a wall: only what comes after room counts.
    std::size_t last = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (leadsHere(cells[i])) {
        last = i;
      } else if (last > 0) {
        break;
      }
    }
    const bool arrives = reaches(at_m);
    Way way;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Vector2d cell = (Vector2d(cells[i].x, cells[i].y) + Vector2d(0.5, 0.5)) * double(step_);
      const Vector2d world = ways_.worldOf(cell);
      if (arrives || i <= last) way.open.push_back(world);
      if (!arrives && i >= last) way.blocked.push_back(world);
    }
    if (!way.blocked.empty()) way.blocked.push_back(at_m);
    return way;
  }

  WayMap ways_;
  cv::Mat map_free_, labels_;
  double reach_m_;
  std::set<int> from_chargers_;
  std::vector<Vector2d> chargers_;
  mutable int step_ = 1;
};

}  // namespace

std::vector<std::size_t> unreachable(const OverlayDocument& document, const placing::PlacedMap& map,
                                     double radius_m) {
  std::vector<std::size_t> found;
  if (!map.cells || map::unusableReason(map.reference)) return found;
  const Reach reach(document, map, radius_m);
  if (!reach.anyCharger()) return found;
  const std::vector<Feature>& features = document.features();
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!isDestination(features[i])) continue;
    const auto at = shapesOf(features[i]).somewhere();
    if (at && !reach.reaches(*at)) found.push_back(i);
  }
  return found;
}

std::optional<Way> wayTo(std::size_t feature, const OverlayDocument& document, const placing::PlacedMap& map,
                         double radius_m) {
  if (!map.cells || map::unusableReason(map.reference) || feature >= document.features().size())
    return std::nullopt;
  const auto at = shapesOf(document.features()[feature]).somewhere();
  if (!at) return std::nullopt;
  return Reach(document, map, radius_m).wayTo(*at);
}

}  // namespace mapwright::overlays
