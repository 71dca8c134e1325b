#include "simulator/scene.h"

#include <algorithm>
#include <cmath>

#include "simulator/blocks.h"
#include "simulator/noise.h"
#include "simulator/simulator.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr int kLiveSubmapsKept = 12;
constexpr int kLiveScansAtStart = 8;
constexpr int kSubmapsPerBlock = 60;   // no kind of block gives fewer
const Vector2d kOrigin{-22.4, -17.3};  // where block 0 lies: the map's origin is inside the building

/// How blocks are laid out.
struct Layout {
  int columns = 1, rows = 1;
  Vector2d pitch{kBlockWidthM, kBlockHeightM};
  std::vector<BlockKind> kinds;  // taken in turn
};

Layout layoutFor(const std::string& name, int submaps) {
  Layout layout;
  if (name == "warehouse") {
    layout.columns = 2;
    layout.kinds = {BlockKind::Hall};
  } else if (name == "campus") {
    layout.columns = layout.rows = 2;
    layout.pitch = {86, 64};
    layout.kinds = {BlockKind::Office, BlockKind::Hall};
  } else {
    layout.kinds = {BlockKind::Office};
  }
  if (submaps > 0) {
    const int blocks = (submaps + kSubmapsPerBlock - 1) / kSubmapsPerBlock;
    layout.columns =
        std::max(1, static_cast<int>(std::lround(std::sqrt(blocks * layout.pitch.y() / layout.pitch.x()))));
    layout.rows = (blocks + layout.columns - 1) / layout.columns;
  }
  return layout;
}

void append(std::vector<Solid>& solids, std::vector<Solid> more, const Vector2d& offset) {
  for (Solid& solid : more) {
    solid.centre += offset;
    solids.push_back(solid);
  }
}

void append(std::vector<Vector2d>& way, const std::vector<Vector2d>& more, const Vector2d& offset) {
  for (const Vector2d& point : more) way.emplace_back(point + offset);
}

/// Trees, lamp posts and parked cars in the gaps between blocks, away from the paths.
void drawOutdoors(std::vector<Solid>& solids, const Layout& layout, std::uint64_t seed) {
  const double gap_x = layout.pitch.x() - kBlockWidthM, gap_y = layout.pitch.y() - kBlockHeightM;
  if (gap_x < 6 || gap_y < 6) return;
  Dice dice(seed);
  for (int row = 0; row < layout.rows; ++row) {
    for (int column = 0; column < layout.columns; ++column) {
      const Vector2d corner = kOrigin + Vector2d(column * layout.pitch.x(), row * layout.pitch.y());
      for (double x = kBlockWidthM + 3; x < layout.pitch.x() - 2; x += dice.uniform(3, 5)) {
        for (const double side : {-1.0, 1.0}) {
          const double r = dice.uniform(0.1, 0.3);
          solids.push_back({corner + Vector2d(x, 20 + side * dice.uniform(2.2, 4)), {r, r}, 0, true, true});
          if (dice.chance(0.5)) {
            solids.push_back({corner + Vector2d(x, 20 + side * dice.uniform(7, 9)),
                              {2.1, 0.85},
                              dice.uniform(1.45, 1.65),
                              false,
                              true});
          }
        }
      }
      for (double y = kBlockHeightM + 3; y < layout.pitch.y() - 2; y += dice.uniform(3, 5)) {
        for (double x = 5; x < kBlockWidthM - 5; x += dice.uniform(4, 12)) {
          const double r = dice.uniform(0.1, 0.35);
          solids.push_back({corner + Vector2d(x, y), {r, r}, 0, true, true});
        }
      }
    }
  }
}

}  // namespace

int Trajectory::scansAt(double session_s) const {
  if (session_s < appears_at_s) return 0;
  const int whole = kScansPerSubmapStart * (submaps + 1);
  if (growth == Growth::Complete) return whole;
  // Versions are published once a second, as robots do: two scans each.
  const double seconds = std::min(std::floor(session_s - appears_at_s), 5e8);
  const int scans = kLiveScansAtStart + 2 * static_cast<int>(seconds);
  return growth == Growth::Live ? scans : std::min(scans, whole);
}

std::pair<int, int> Trajectory::submapsAfter(int scans) const {
  const int begun = (scans + kScansPerSubmapStart - 1) / kScansPerSubmapStart;
  if (growth == Growth::Live) return {std::max(0, begun - submaps), begun};
  return {0, std::min(begun, submaps)};
}

std::optional<Scene> makeScene(const std::string& name, int submaps, std::uint32_t seed) {
  Scene scene;
  if (name == "empty") return scene;
  if (name != "office" && name != "warehouse" && name != "campus") return std::nullopt;

  const Layout layout = layoutFor(name, submaps);
  std::vector<Solid> solids;
  std::vector<Vector2d> tour, round;
  for (int row = 0; row < layout.rows; ++row) {
    const bool westward = row % 2 == 1;
    for (int step = 0; step < layout.columns; ++step) {
      const int column = westward ? layout.columns - 1 - step : step;
      const bool first_ever = row == 0 && step == 0;
      const bool last_ever = row + 1 == layout.rows && step + 1 == layout.columns;
      BlockRequest request;
      request.kind = layout.kinds[static_cast<std::size_t>(row + column) % layout.kinds.size()];
      request.seed = hashOf(seed, row, column);
      request.mirrored = westward;
      request.entry = first_ever ? Port::Inside : step == 0 ? Port::SideLane : Port::MainLane;
      request.exit = last_ever ? Port::Inside : step + 1 == layout.columns ? Port::SideLane : Port::MainLane;
      request.west_open = column > 0 || row == 0;  // the annex joins block 0 on the west
      request.east_open = column + 1 < layout.columns;
      Block block = drawBlock(request);
      const Vector2d corner = kOrigin + Vector2d(column * layout.pitch.x(), row * layout.pitch.y());
      append(solids, std::move(block.solids), corner);
      append(tour, block.tour, corner);
      if (first_ever) append(round, block.round, corner);
    }
  }
  drawOutdoors(solids, layout, hashOf(seed, 77));
  Block annex = drawAnnex(hashOf(seed, 78));
  Block gatehouse = drawGatehouse(hashOf(seed, 79));
  const Vector2d gatehouse_corner = kOrigin + Vector2d(9, -29);
  append(solids, std::move(annex.solids), kOrigin);
  append(solids, std::move(gatehouse.solids), gatehouse_corner);
  std::vector<Vector2d> annex_way, gatehouse_way;
  append(annex_way, annex.tour, kOrigin);
  append(gatehouse_way, gatehouse.tour, gatehouse_corner);

  const auto submapsOn = [](const Drive& drive) {
    return std::max(1, static_cast<int>(drive.length_m() / (kScanStepM * kScansPerSubmapStart)) - 1);
  };
  Trajectory map{0, Drive(tour, false), Growth::Complete, 0, 0, false, false};
  map.submaps = submapsOn(map.drive);
  if (submaps > 0) map.submaps = std::min(submaps, map.submaps);
  if (map.submaps > kMostOwnLooks) map.looks = kLooks;
  Trajectory live{1, Drive(round, true), Growth::Live, 0, kLiveSubmapsKept, false, false};
  Trajectory incremental{2, Drive(annex_way, false), Growth::Once, 20, 0, true, false};
  incremental.submaps = submapsOn(incremental.drive);
  Trajectory nearby{3, Drive(gatehouse_way, false), Growth::Complete, 30, 0, false, true};
  nearby.submaps = submapsOn(nearby.drive);
  scene.plan = FloorPlan(std::move(solids));
  scene.trajectories = {std::move(map), std::move(live), std::move(incremental), std::move(nearby)};
  return scene;
}

std::vector<std::pair<std::string, std::string>> sceneNames() {
  return {{"office", "A floor of offices, 60 m x 40 m, with a canteen and a small building next to it."},
          {"warehouse", "A hall of racks, 120 m x 40 m."},
          {"campus", "Two office buildings and two halls with paths between them."},
          {"empty", "A robot without any submaps."}};
}

}  // namespace mapwright::simulator
