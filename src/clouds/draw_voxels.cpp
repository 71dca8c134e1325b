#include <algorithm>
#include <cmath>

#include "clouds/sums.h"
#include "clouds/walk.h"

namespace mapwright::clouds {

bool addVoxels(Sums& sums, const Raster& raster, const ShownCloud& cloud, const CloudLook& look,
               const std::atomic<bool>* cancelled) {
  const CloudTree& tree = *cloud.tree;
  const auto points = tree.points();
  if (points.empty()) return true;
  const Projection pixels(raster, tree.origin());
  const Meant meant(tree, cloud.hidden, look.heights);
  const Channels channels(tree, look);
  // The cells are those of the lattice of the points: neighbours share an edge to the last bit.
  const double edge = cloud.voxel_m, anchor_x = double(points[0].x()), anchor_y = double(points[0].y());
  const auto cellX = [&](double x) { return std::round((x - anchor_x) / edge); };
  const auto cellY = [&](double y) { return std::round((y - anchor_y) / edge); };
  const auto fill = [&](double i, double j, std::int64_t count, const std::array<std::int64_t, 3>& values) {
    const double x0 = anchor_x + (i - 0.5) * edge, x1 = anchor_x + (i + 0.5) * edge;
    const double y0 = anchor_y + (j - 0.5) * edge, y1 = anchor_y + (j + 0.5) * edge;
    const auto reach = pixels.reach(x0, y0, x1, y1);
    if (!sums.touches(reach)) return;
    const double right = std::min(reach.column1, sums.column0 + sums.width - 1);
    const double bottom = std::min(reach.row1, sums.row0 + sums.height - 1);
    for (double row = std::max(reach.row0, sums.row0); row <= bottom; ++row) {
      for (double column = std::max(reach.column0, sums.column0); column <= right; ++column) {
        const Eigen::Vector2d ground = pixels.groundBelow(column, row);
        if (ground.x() >= x0 && ground.x() < x1 && ground.y() >= y0 && ground.y() < y1) {
          sums.add(sums.at(column, row), count, values);
        }
      }
    }
  };
  const double margin =
      edge;  // a cell extends half of it beyond its point, and the lattice may shift it by as much
  walk(
      tree,
      [&](const CloudNode& node) {
        if (cancelled && *cancelled) return Way::Skip;
        const auto reach = pixels.reach(double(node.min[0]) - margin, double(node.min[1]) - margin,
                                        double(node.max[0]) + margin, double(node.max[1]) + margin);
        if (!sums.touches(reach)) return Way::Skip;
        const Way way = meant.of(node);
        const bool one_cell = cellX(double(node.min[0])) == cellX(double(node.max[0])) &&
                              cellY(double(node.min[1])) == cellY(double(node.max[1]));
        return way == Way::Whole && !one_cell ? Way::Into : way;
      },
      [&](const CloudNode& node) {
        fill(cellX(double(node.min[0])), cellY(double(node.min[1])), node.count, channels.of(node));
      },
      [&](std::uint32_t i) {
        if (cancelled && *cancelled) return;
        const Eigen::Vector3f& point = points[i];
        if (meant.has(point)) fill(cellX(double(point.x())), cellY(double(point.y())), 1, channels.of(i));
      });
  return !(cancelled && *cancelled);
}

}  // namespace mapwright::clouds
