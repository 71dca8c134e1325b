#include "simulator/pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/lidar.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr double kMostCells = 24e6;
constexpr int kMostScans = 1200;  // for one picture
constexpr int kScanStride = 3;    // neighbouring scans see the same
constexpr int kRays = 600;
constexpr double kRangeM = 14;
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
  const Vector2d size = boundsOf(places).sizes() + Vector2d(2 * kRangeM, 2 * kRangeM);
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
  return bits == 4 ? 0x77 : kUnknownShade;
}

constexpr double kInscribedM = 0.25;
constexpr double kInflationM = 0.55;
constexpr double kSteepness = 9;  // per metre
constexpr int kStepsPerMetre = 400;

/// Cost by distance in steps, so that no exponential is taken per cell.
std::vector<std::uint8_t> costTable() {
  std::vector<std::uint8_t> costs;
  for (int i = 0; i <= static_cast<int>(kInflationM * kStepsPerMetre); ++i) {
    const double distance = static_cast<double>(i) / kStepsPerMetre;
    const double cost =
        distance <= kInscribedM ? 253 : 252 * std::exp(-kSteepness * (distance - kInscribedM));
    costs.push_back(static_cast<std::uint8_t>(cost));
  }
  return costs;
}

void addSolid(GrayPicture& picture, const GridPlace& place, const Solid& solid,
              const std::vector<std::uint8_t>& costs) {
  const double c = std::cos(solid.yaw_rad), s = std::sin(solid.yaw_rad);
  const Vector2d shape = solid.round ? Vector2d(solid.half.x(), solid.half.x()) : solid.half;
  const Vector2d grown = solid.extent() + Vector2d(kInflationM, kInflationM);
  const Vector2d low = (solid.centre - grown - place.origin_m) / place.resolution_m;
  const Vector2d high = (solid.centre + grown - place.origin_m) / place.resolution_m;
  const auto cell = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, static_cast<double>(count)));
  };
  const int u0 = cell(low.x(), place.width), u1 = cell(high.x() + 1, place.width);
  const int y0 = cell(low.y(), place.height), y1 = cell(high.y() + 1, place.height);
  for (int y = y0; y < y1; ++y) {
    std::uint8_t* row = picture.levels.data() + static_cast<std::size_t>(place.height - 1 - y) *
                                                    static_cast<std::size_t>(place.width);
    const double dy = place.origin_m.y() + place.resolution_m * (y + 0.5) - solid.centre.y();
    for (int u = u0; u < u1; ++u) {
      if (row[u] == 254) continue;
      const double dx = place.origin_m.x() + place.resolution_m * (u + 0.5) - solid.centre.x();
      double beyond = 0;  // the square of how far outside the shape
      if (solid.round) {
        const double distance = std::max(0.0, std::sqrt(dx * dx + dy * dy) - shape.x());
        beyond = distance * distance;
      } else {
        const double along = std::max(0.0, std::abs(c * dx + s * dy) - shape.x());
        const double across = std::max(0.0, std::abs(-s * dx + c * dy) - shape.y());
        beyond = along * along + across * across;
      }
      if (beyond > kInflationM * kInflationM) continue;
      const std::uint8_t cost =
          beyond <= 0 ? 254 : costs[static_cast<std::size_t>(std::sqrt(beyond) * kStepsPerMetre)];
      row[u] = std::max(row[u], cost);
    }
  }
}

/// What the scans of `spec.trajectory` saw. No cells if there is no such trajectory or no scan. Takes about a
/// tenth of a second for an office at 5 cm.
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

}  // namespace

MapPicturePtr placedPicture(const GridPlace& place, std::string png) {
  MapPicture picture{place, nullptr, contentHash(png)};
  picture.png = std::make_shared<const std::string>(std::move(png));
  return std::make_shared<const MapPicture>(std::move(picture));
}

MapPicturePtr thumbnailOf(const GridPlace& place, const GrayPicture& picture) {
  const int step =
      std::max(1, (std::max(picture.width, picture.height) + kThumbnailPixels - 1) / kThumbnailPixels);
  GrayPicture small{(picture.width + step - 1) / step, (picture.height + step - 1) / step, {}};
  small.levels.assign(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height), 255);
  std::vector<bool> seen(small.levels.size());
  std::size_t from = 0;
  for (int v = 0; v < picture.height; ++v) {
    for (int u = 0; u < picture.width; ++u, ++from) {
      if (picture.levels[from] == kUnknownShade) continue;
      const std::size_t at = static_cast<std::size_t>(v / step) * static_cast<std::size_t>(small.width) +
                             static_cast<std::size_t>(u / step);
      seen[at] = true;
      small.levels[at] = std::min(small.levels[at], picture.levels[from]);
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) small.levels[i] = kUnknownShade;
  }
  const double resolution_m = place.resolution_m * place.width / std::max(1, small.width);
  return placedPicture({small.width, small.height, resolution_m, place.origin_m}, writePng(small, 8));
}

std::shared_ptr<const FloorCells> MapPictures::cells(const PictureSpec& spec) {
  PictureSpec key = spec;
  key.bits = 8;  // cells have none
  return cells_.get(key, [&]() -> std::shared_ptr<const FloorCells> {
    FloorCells drawn = drawFloor(scene_, key);
    return drawn.cells.empty() ? nullptr : std::make_shared<const FloorCells>(std::move(drawn));
  });
}

MapPicturePtr MapPictures::made(const PictureSpec& spec, bool small) {
  const std::shared_ptr<const FloorCells> floor = cells(spec);
  if (!floor) return nullptr;
  const int bits = small ? 8 : spec.bits;
  GrayPicture picture{floor->width, floor->height, std::vector<std::uint8_t>(floor->cells.size())};
  std::transform(floor->cells.begin(), floor->cells.end(), picture.levels.begin(),
                 [bits](FloorCell cell) { return levelOf(cell, bits); });
  return small ? thumbnailOf(*floor, picture) : placedPicture(*floor, writePng(picture, bits));
}

GridPlace squareAround(const Vector2d& centre_m, int cells, double resolution_m) {
  const Vector2d corner = centre_m / resolution_m - Vector2d(cells / 2, cells / 2);
  return {cells, cells, resolution_m,
          Vector2d(std::round(corner.x()) * resolution_m, std::round(corner.y()) * resolution_m)};
}

GrayPicture costsOf(const FloorPlan& plan, const std::vector<Solid>& extra, const GridPlace& place) {
  static const std::vector<std::uint8_t> costs = costTable();
  GrayPicture picture{place.width, place.height, {}};
  picture.levels.assign(static_cast<std::size_t>(place.width) * static_cast<std::size_t>(place.height), 0);
  const Vector2d margin(kInflationM, kInflationM);
  const Vector2d size = place.resolution_m * Vector2d(place.width, place.height);
  for (const std::uint32_t index : plan.near(place.origin_m - margin, place.origin_m + size + margin))
    addSolid(picture, place, plan.solids()[index], costs);
  for (const Solid& solid : extra) addSolid(picture, place, solid, costs);
  return picture;
}

}  // namespace mapwright::simulator
