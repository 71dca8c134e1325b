// The exact composition of overlapping, rotated submap textures: pure functions, any thread. Source:
// docs/protocols/cartographer-submaps.md, "Geometry", "Composition".
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/pose.h"
#include "geometry/rect.h"
#include "map/submap.h"
#include "render/pixel_flags.h"

namespace mapwright::cells {
class CellTexture;
}

namespace mapwright::render {

class DenseCache;

/// A texture with its pose. `flags`: its classes and the PixelFlag bits (without kObserved) for its pixels.
struct PlacedTexture {
  map::SubmapId id;
  std::shared_ptr<const cells::CellTexture> texture;
  geometry::Pose2 world_from_texture;  // columns run along -y, rows along -x of this frame
  std::uint16_t flags = 0;
};

/// The world rectangle that a placed texture can affect, including one cell of bilinear fade.
geometry::WorldRect boundsOf(const PlacedTexture& placed);

/// A raster of square pixels anywhere on the plane, and a window of it. Column direction is (cos, -sin) of
/// rotation and row direction is "down": as geometry::ViewTransform with the same rotation_rad.
/// origin_m is the world point of the corner where column 0 meets row 0 of the whole, infinite raster; the
/// window's first pixel is (first_column, first_row). Windows of one raster (same origin, scale, rotation)
/// give the same bytes for the same pixels wherever they are cut, provided each gets all textures that touch
/// its bounds() grown by 32 pixels; if all textures have one resolution, those that touch its bounds()
/// suffice.
struct PixelGrid {
  Eigen::Vector2d origin_m{0, 0};
  double scale_m_per_px = 0.05;
  double rotation_rad = 0;
  int width_px = 0, height_px = 0;
  std::int64_t first_column = 0, first_row = 0;
  /// Continuous, counted from the window's first pixel, whose centre is (0.5, 0.5).
  Eigen::Vector2d worldFromPixel(double column, double row) const;
  geometry::WorldRect bounds() const;  // of the window
};

/// A finished composition, row-major from the top row.
struct Composition {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> intensity;  // 128 where nothing was observed
  std::vector<std::uint16_t> flags;     // render/pixel_flags.h, 0 = not observed
};

enum class Quality {
  Exact,    // the composition at native resolution, reduced by area average
  Preview,  // composed from reduced levels, one sample per pixel: fast, but walls are pale
};

/// Which inner loop to use. All give the same bytes. With MAPWRIGHT_PORTABLE in the environment there is no
/// Avx2.
enum class Kernel { Best, Portable, Avx2 };
bool kernelAvailable(Kernel kernel);

/// Composes `textures`, which must be in ascending (trajectory, index) order (they are painted in this
/// order). Sampling is bilinear per texture, or nearest if a cell covers more than 4x4 pixels. A pixel larger
/// than the finest cell under it is the area average of k*k samples no coarser than that cell; its flags are
/// those of its samples, united(). `cancelled` (may be null) is polled; when it becomes true the result is
/// empty (width 0). Runs on any thread, one core. A grid without pixels, or with a scale, origin or rotation
/// that is not finite and positive, gives an empty result; a texture without cells, or with an invalid pose,
/// draws nothing.
Composition compose(const PixelGrid& grid, std::span<const PlacedTexture> textures, Quality quality,
                    DenseCache& cache, Kernel kernel = Kernel::Best,
                    const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::render
