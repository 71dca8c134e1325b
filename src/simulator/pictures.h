// The floor plan as grids: occupancy as mapped by a robot that has driven a trajectory, and driving costs,
// which are the solids inflated by the robot's size.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "simulator/cache.h"
#include "simulator/encoding.h"
#include "simulator/scene.h"

namespace mapwright::simulator {

/// The position of a grid.
struct GridPlace {
  int width = 0, height = 0;  // cells
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m{0, 0};  // world of the lower-left cell's outer corner
};

enum class FloorCell : std::uint8_t { Unknown, Free, Occupied };

/// Cells in picture order: columns along +x, rows along -y, the top row first.
struct FloorCells : GridPlace {
  std::vector<FloorCell> cells;
};

/// An encoded picture and its position.
struct MapPicture : GridPlace {
  std::shared_ptr<const std::string> png;
  std::string hash;  // 64 hexadecimal digits, of the PNG
};
using MapPicturePtr = std::shared_ptr<const MapPicture>;

MapPicturePtr placedPicture(const GridPlace& place, std::string png);

/// Which picture.
struct PictureSpec {
  int trajectory = 0;
  double resolution_m = 0.05;  // coarser if the picture would be too large
  int bits = 8;                // 4: 0 occupied, 7 unknown, 15 free; 8: 0, 128, 255
  int crates = 0;              // number of crates added along the route
  int scans = -1;              // >= 0: only what the first scans saw
  double from_m = 0;           // position of the first scan along the route
  int base = -1;               // >= 0: on top of everything seen on this trajectory
  auto operator<=>(const PictureSpec&) const = default;
};

/// At most 160 pixels wide and high; thin walls stay visible. `place` is that of the picture.
MapPicturePtr thumbnailOf(const GridPlace& place, const GrayPicture& picture);

/// Makes each picture once and caches the last ones. Safe from any thread.
class MapPictures {
 public:
  explicit MapPictures(const Scene& scene) : scene_(scene) {}

  /// Null if it is empty.
  MapPicturePtr picture(const PictureSpec& spec) {
    return pictures_.get(spec, [&] { return made(spec, false); });
  }
  MapPicturePtr thumbnail(const PictureSpec& spec) {
    return thumbnails_.get(spec, [&] { return made(spec, true); });
  }
  /// Also caches the last cells. Null if it is empty.
  std::shared_ptr<const FloorCells> cells(const PictureSpec& spec);

 private:
  MapPicturePtr made(const PictureSpec& spec, bool small);

  const Scene& scene_;
  Cache<PictureSpec, MapPicturePtr> pictures_{24}, thumbnails_{24};
  Cache<PictureSpec, std::shared_ptr<const FloorCells>> cells_{6};
};

/// A square of `cells` around a position, on the lattice through the world's origin.
GridPlace squareAround(const Eigen::Vector2d& centre_m, int cells, double resolution_m);

/// 0 free, 254 in a solid, 253 where the robot's centre must not go, decreasing beyond. Top row first.
GrayPicture costsOf(const FloorPlan& plan, const std::vector<Solid>& extra, const GridPlace& place);

}  // namespace mapwright::simulator
