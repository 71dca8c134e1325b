#include "simulator/map_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/scan_grid.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr double kMostCells = 24e6;
constexpr int kMostScans = 1200;  // for one picture
constexpr int kScanStride = 3;    // neighbouring scans see the same
constexpr int kRays = 600;
constexpr double kRangeM = 14;
constexpr std::size_t kPicturesKept = 24;
constexpr std::size_t kCellsKept = 3;
constexpr int kThumbnailPixels = 160;
constexpr std::uint8_t kOccupiedFrom = 136;  // beyond the grain that a cell seen free once may have

/// Where `scans` scans (all of them when negative) were taken, not all of which are worth their time.
std::vector<ScanPlace> placesOf(const Trajectory& trajectory, int scans, double from_m) {
  const int whole = kScansPerSubmapStart * (trajectory.submaps + 1);
  const bool has_end = trajectory.growth != Growth::Live;
  const int count = scans < 0 ? whole : has_end ? std::min(scans, whole) : scans;
  const int stride = std::max(kScanStride, count / kMostScans);
  std::vector<ScanPlace> places;
  for (int scan = 0; scan < count; scan += stride)
    places.push_back({trajectory.drive.at(from_m + kScanStepM * scan), static_cast<std::uint64_t>(scan)});
  return places;
}

std::vector<ScanPlace> placesOf(const Scene& scene, const PictureSpec& spec) {
  std::vector<ScanPlace> places;
  if (const Trajectory* base = scene.find(spec.base)) places = placesOf(*base, -1, 0);
  if (const Trajectory* trajectory = scene.find(spec.trajectory)) {
    const std::vector<ScanPlace> more = placesOf(*trajectory, spec.scans, spec.from_m);
    places.insert(places.end(), more.begin(), more.end());
  }
  return places;
}

/// Twice or more coarser until the area that the scans can reach has few enough cells.
double affordable(double resolution_m, const std::vector<ScanPlace>& places) {
  Vector2d low(places.front().pose.x_m, places.front().pose.y_m), high = low;
  for (const ScanPlace& place : places) {
    low = low.cwiseMin(Vector2d(place.pose.x_m, place.pose.y_m));
    high = high.cwiseMax(Vector2d(place.pose.x_m, place.pose.y_m));
  }
  const Vector2d size = high - low + Vector2d(2 * kRangeM, 2 * kRangeM);
  while (size.x() * size.y() / (resolution_m * resolution_m) > kMostCells) resolution_m *= 2;
  return resolution_m;
}

std::vector<Solid> cratesAlong(const Trajectory& trajectory, int crates) {
  std::vector<Solid> solids;
  for (int i = 0; i < std::min(crates, 64); ++i) {
    const geometry::Pose2 by = trajectory.drive.at(6.0 + 5.3 * i);
    solids.push_back({by.apply({0.0, i % 2 == 0 ? 0.7 : -0.7}), {0.3, 0.3}, by.yaw_rad, false, true});
  }
  return solids;
}

/// Rays leave specks between them: a cell that nobody saw among cells that were seen free is free.
void fillSpecks(FloorCells& floor) {
  const std::vector<FloorCell> before = floor.cells;
  const auto width = static_cast<std::size_t>(floor.width);
  for (std::size_t v = 1; v + 1 < static_cast<std::size_t>(floor.height); ++v) {
    for (std::size_t u = 1; u + 1 < width; ++u) {
      const std::size_t here = v * width + u;
      if (before[here] != FloorCell::Unknown) continue;
      int free = 0;
      for (const std::size_t row : {here - width, here, here + width}) {
        for (const std::size_t at : {row - 1, row, row + 1}) free += before[at] == FloorCell::Free ? 1 : 0;
      }
      if (free >= 4) floor.cells[here] = FloorCell::Free;
    }
  }
}

std::uint8_t levelOf(FloorCell cell, int bits) {
  if (cell == FloorCell::Occupied) return 0;
  if (cell == FloorCell::Free) return 255;
  return bits == 4 ? 0x77 : 128;
}

}  // namespace

FloorCells drawFloor(const Scene& scene, const PictureSpec& spec) {
  FloorCells floor;
  const Trajectory* trajectory = scene.find(spec.trajectory);
  if (trajectory == nullptr) return floor;
  const std::vector<ScanPlace> places = placesOf(scene, spec);
  if (places.empty()) return floor;

  ScanSettings settings;
  settings.resolution_m = affordable(spec.resolution_m, places);
  settings.range_m = kRangeM;
  settings.rays = kRays;
  settings.seed = 5;
  // A slice frame turned by a quarter has its columns along +x and its rows along -y of the world.
  const ScanGrid grid = scanGrid(scene.plan, cratesAlong(*trajectory, spec.crates), places, {0, 0},
                                 std::numbers::pi / 2, settings);
  floor.width = grid.width;
  floor.height = grid.height;
  floor.resolution_m = grid.resolution_m;
  const auto snapped = [&](double metres) {
    return std::round(metres / grid.resolution_m) * grid.resolution_m;
  };
  floor.origin_m = {snapped(grid.world_from_slice.x_m),
                    snapped(grid.world_from_slice.y_m - grid.height * grid.resolution_m)};
  floor.cells.resize(grid.cells.size());
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    floor.cells[i] = grid.cells[i] == 0              ? FloorCell::Unknown
                     : grid.cells[i] > kOccupiedFrom ? FloorCell::Occupied
                                                     : FloorCell::Free;
  }
  fillSpecks(floor);
  fillSpecks(floor);
  return floor;
}

GrayPicture grayOf(const FloorCells& cells, int bits) {
  GrayPicture picture{cells.width, cells.height, std::vector<std::uint8_t>(cells.cells.size())};
  std::transform(cells.cells.begin(), cells.cells.end(), picture.levels.begin(),
                 [bits](FloorCell cell) { return levelOf(cell, bits); });
  return picture;
}

GrayPicture thumbnailOf(const GrayPicture& picture, std::uint8_t unknown) {
  const int step =
      std::max(1, (std::max(picture.width, picture.height) + kThumbnailPixels - 1) / kThumbnailPixels);
  GrayPicture small{(picture.width + step - 1) / step, (picture.height + step - 1) / step, {}};
  small.levels.assign(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height), 255);
  std::vector<bool> seen(small.levels.size());
  std::size_t from = 0;
  for (int v = 0; v < picture.height; ++v) {
    for (int u = 0; u < picture.width; ++u, ++from) {
      if (picture.levels[from] == unknown) continue;
      const std::size_t at = static_cast<std::size_t>(v / step) * static_cast<std::size_t>(small.width) +
                             static_cast<std::size_t>(u / step);
      seen[at] = true;
      small.levels[at] = std::min(small.levels[at], picture.levels[from]);
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) small.levels[i] = unknown;
  }
  return small;
}

MapPicturePtr encode(const FloorCells& cells, const GrayPicture& picture, int bits) {
  MapPicture encoded;
  encoded.png = std::make_shared<const std::string>(writePng(picture, bits));
  encoded.width = picture.width;
  encoded.height = picture.height;
  encoded.resolution_m = cells.resolution_m * cells.width / std::max(1, picture.width);
  encoded.origin_m = cells.origin_m;
  encoded.hash = contentHash(*encoded.png);
  return std::make_shared<const MapPicture>(std::move(encoded));
}

std::shared_ptr<const FloorCells> MapPictures::cells(const PictureSpec& spec) {
  PictureSpec key = spec;
  key.bits = 8;  // cells have none
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [known, cells] : cells_) {
      if (known == key) return cells;
    }
  }
  FloorCells drawn = drawFloor(scene_, key);
  if (drawn.cells.empty()) return nullptr;
  auto made = std::make_shared<const FloorCells>(std::move(drawn));
  const std::lock_guard lock(mutex_);
  cells_.emplace_front(key, made);
  if (cells_.size() > kCellsKept) cells_.pop_back();
  return made;
}

MapPicturePtr MapPictures::picture(const PictureSpec& spec) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = pictures_.find(spec); found != pictures_.end()) return found->second;
  }
  const std::shared_ptr<const FloorCells> floor = cells(spec);
  MapPicturePtr made = floor ? encode(*floor, grayOf(*floor, spec.bits), spec.bits) : nullptr;
  const std::lock_guard lock(mutex_);
  if (pictures_.size() >= kPicturesKept) pictures_.clear();
  pictures_[spec] = made;
  return made;
}

MapPicturePtr MapPictures::thumbnail(const PictureSpec& spec) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = thumbnails_.find(spec); found != thumbnails_.end()) return found->second;
  }
  const std::shared_ptr<const FloorCells> floor = cells(spec);
  if (!floor) return nullptr;
  const GrayPicture small = thumbnailOf(grayOf(*floor, 8), levelOf(FloorCell::Unknown, 8));
  MapPicturePtr made = encode(*floor, small, 8);
  const std::lock_guard lock(mutex_);
  if (thumbnails_.size() >= kPicturesKept) thumbnails_.clear();
  thumbnails_[spec] = made;
  return made;
}

}  // namespace mapwright::simulator
