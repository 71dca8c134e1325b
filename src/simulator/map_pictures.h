// The floor plan as occupancy grids, as mapped by a robot that has driven a whole trajectory.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "simulator/png_writing.h"
#include "simulator/scene.h"

namespace mapwright::simulator {

enum class FloorCell : std::uint8_t { Unknown, Free, Occupied };

/// Cells in picture order: columns along +x, rows along -y, the top row first.
struct FloorCells {
  int width = 0, height = 0;
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m{0, 0};  // world of the lower-left cell's outer corner
  std::vector<FloorCell> cells;
};

/// An encoded picture and its position.
struct MapPicture {
  std::shared_ptr<const std::string> png;
  int width = 0, height = 0;
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m{0, 0};
  std::string hash;  // 64 hexadecimal digits, of the PNG
};
using MapPicturePtr = std::shared_ptr<const MapPicture>;

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

/// What the scans of `spec.trajectory` saw. No cells if there is no such trajectory or no scan. Takes about a
/// tenth of a second for an office at 5 cm.
FloorCells drawFloor(const Scene& scene, const PictureSpec& spec);

/// At most 160 pixels wide and high; thin walls stay visible. `unknown` is the level of unobserved cells.
GrayPicture thumbnailOf(const GrayPicture& picture, std::uint8_t unknown);

GrayPicture grayOf(const FloorCells& cells, int bits);
MapPicturePtr encode(const FloorCells& cells, const GrayPicture& picture, int bits);

/// Makes each picture once and caches the last ones. Safe from any thread.
class MapPictures {
 public:
  explicit MapPictures(const Scene& scene) : scene_(scene) {}

  /// Null if it is empty.
  MapPicturePtr picture(const PictureSpec& spec);
  /// At most 160 pixels wide and high, 8 bits; thin walls stay.
  MapPicturePtr thumbnail(const PictureSpec& spec);
  /// Also caches the last cells. Null if it is empty.
  std::shared_ptr<const FloorCells> cells(const PictureSpec& spec);

 private:
  const Scene& scene_;
  std::mutex mutex_;
  std::map<PictureSpec, MapPicturePtr> pictures_, thumbnails_;
  std::list<std::pair<PictureSpec, std::shared_ptr<const FloorCells>>> cells_;  // newest first
};

}  // namespace mapwright::simulator
