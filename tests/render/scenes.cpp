#include "scenes.h"

#include <cmath>
#include <random>

#include "reference.h"

namespace mapwright::testing {

std::vector<render::PlacedTexture> field(int count, double across_m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-across_m / 2, across_m / 2), angle(-3.1, 3.1);
  std::vector<render::PlacedTexture> placed;
  for (int i = 0; i < count; ++i) {
    const auto cells = randomCells(100, 80, Content::Folding, random);
    const double yaw = angle(random);
    const Eigen::Vector2d middle = geometry::Pose2{0, 0, yaw}.apply({-2, -2.5});
    const geometry::Pose2 pose{place(random) - middle.x(), place(random) - middle.y(), yaw};
    placed.push_back(
        plainTexture(100, 80, 0.05, cells, pose, i, std::uint16_t(((i * 37) % 1000) << 4 | (i % 8) << 1))
            .placed);
  }
  return placed;
}

render::PlacedTexture square(int index, double x, double y, double edge_m, cells::CellPair cell,
                             std::uint16_t flags) {
  const int cells = int(std::lround(edge_m / 0.05));
  return plainTexture(cells, cells, 0.05,
                      std::vector<cells::CellPair>(std::size_t(cells) * std::size_t(cells), cell),
                      {x + edge_m / 2, y + edge_m / 2, 0}, index, flags)
      .placed;
}

geometry::ViewTransform viewAt(double x, double y, double scale, int width, int height, double rotation) {
  geometry::ViewTransform view;
  view.center_m = {x, y};
  view.scale_m_per_px = scale;
  view.rotation_rad = rotation;
  view.width_px = width;
  view.height_px = height;
  return view;
}

render::PixelGrid gridOf(const geometry::ViewTransform& view) {
  render::PixelGrid grid;
  grid.origin_m = view.worldFromPixel({0, 0});
  grid.scale_m_per_px = view.scale_m_per_px;
  grid.rotation_rad = view.rotation_rad;
  grid.width_px = view.width_px;
  grid.height_px = view.height_px;
  return grid;
}

}  // namespace mapwright::testing
