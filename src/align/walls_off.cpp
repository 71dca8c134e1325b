#include "align/walls_off.h"

#include <optional>
#include <utility>

#include "align/fit.h"
#include "align/plan_of.h"

namespace mapwright::align {

struct WallsOff::Parts {
  Sheets sheets;
};

WallsOff::WallsOff(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
WallsOff::~WallsOff() = default;

std::shared_ptr<const WallsOff> WallsOff::between(const render::PlacedGrid& old_map,
                                                  const render::PlacedGrid& new_map,
                                                  const std::atomic<bool>& cancelled) {
  const double cell_m = cellsFor(old_map, new_map);
  const auto sheet_of = [&](const render::PlacedGrid& map) -> std::optional<Sheet> {
    auto plan = planOf(map, cell_m, &cancelled);
    if (!plan || cancelled) return std::nullopt;
    return Sheet(seenOnly(std::move(*plan), Sheet::kReach_m));
  };
  auto of_old = sheet_of(old_map);
  auto of_new = of_old ? sheet_of(new_map) : std::nullopt;
  if (!of_new) return nullptr;
  return std::shared_ptr<const WallsOff>(
      new WallsOff(std::make_unique<const Parts>(Parts{{std::move(*of_old), std::move(*of_new)}})));
}

double WallsOff::cell_m() const { return parts_->sheets.of_new.resolution(); }

std::vector<OffWall> WallsOff::at(const geometry::Pose2& transform, double least_m) const {
  const Mover forward(transform), backward(transform.inverse());
  const auto& [of_old, of_new] = parts_->sheets;
  std::vector<OffWall> off;
  for (const Eigen::Vector2d& wall : of_old.walls()) {
    const Eigen::Vector2d there = forward(wall);
    const auto distance = of_new.distanceAt(there);
    if (distance && distance->metres > least_m) off.push_back({there, distance->metres});
  }
  for (const Eigen::Vector2d& wall : of_new.walls()) {
    const auto distance = of_old.distanceAt(backward(wall));
    if (distance && distance->metres > least_m) off.push_back({wall, distance->metres});
  }
  return off;
}

}  // namespace mapwright::align
