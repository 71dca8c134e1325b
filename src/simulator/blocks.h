// The parts of buildings that scenes are made of. Every block is 60 m x 40 m with its lower-left corner at
// the origin, a main lane at y = 20 and lanes along its west and east ends, so that blocks can be joined in
// any order.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "simulator/floor_plan.h"

namespace mapwright::simulator {

constexpr double kBlockWidthM = 60, kBlockHeightM = 40;

enum class BlockKind { Office, Hall };

/// Where a tour enters or leaves: it begins or ends inside, through the end of the main lane, or through the
/// end of the lane along the block's side (entering from the south, leaving to the north).
enum class Port { Inside, MainLane, SideLane };

struct BlockRequest {
  BlockKind kind = BlockKind::Office;
  std::uint64_t seed = 0;
  bool mirrored = false;  // the tour runs westward
  Port entry = Port::Inside;
  Port exit = Port::Inside;
  bool west_open = false, east_open = false;  // the ends of the main lane
};

struct Block {
  std::vector<Solid> solids;
  std::vector<Eigen::Vector2d> tour;   // past everything, from entry to exit
  std::vector<Eigen::Vector2d> round;  // a closed loop for a working robot
};

Block drawBlock(const BlockRequest& request);
/// A canteen attached to the west of a block's main lane: x -26..0, y 9..31 of that block. The tour starts in
/// the door.
Block drawAnnex(std::uint64_t seed);
/// A small separate building, 40 m x 18 m with its lower-left corner at the origin.
Block drawGatehouse(std::uint64_t seed);

}  // namespace mapwright::simulator
