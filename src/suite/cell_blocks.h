// Checksums of blocks of the cells of a map, so that what changed has its place. Values.
#pragma once

#include <cstdint>
#include <vector>

#include <QJsonValue>

#include "geometry/rect.h"
#include "map/grid_reference.h"

namespace mapwright::suite {

struct CellBlocks {
  int width = 0, height = 0;  // of the map in cells; 0: nothing is known
  int edge = 0;               // of a block in cells; those at the right and at the bottom may be smaller
  std::vector<std::uint32_t> sums;  // of the blocks, row by row from the top
  bool operator==(const CellBlocks&) const = default;

  CellBlocks() = default;
  /// Blocks as small as a bounded number of them allows.
  CellBlocks(int width, int height);
  /// From the top; each row once.
  void addRow(int y, const std::uint8_t* cells);
  int columns() const { return (width + edge - 1) / edge; }
  int rows() const { return (height + edge - 1) / edge; }
  bool known() const { return width > 0; }
  bool comparableWith(const CellBlocks& other) const {
    return known() && width == other.width && height == other.height && edge == other.edge;
  }
};

/// Blocks that changed and touch each other.
struct ChangedPatch {
  double width_m = 0, height_m = 0;  // along the sides of the map
  Eigen::Vector2d center_m;
  std::vector<geometry::WorldRect> blocks;
};
/// The largest first. Precondition: they are comparable.
std::vector<ChangedPatch> changedPatches(const CellBlocks& before, const CellBlocks& after,
                                         const geometry::Pose2& origin, double resolution_m);

/// {"size", "edge", "rows"}: the checksums of each row of blocks as base64.
QJsonValue jsonOf(const CellBlocks& blocks);
/// Nothing is known of what does not fit together.
CellBlocks blocksFrom(const QJsonValue& json);

}  // namespace mapwright::suite
