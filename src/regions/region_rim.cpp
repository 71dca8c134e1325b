#include "regions/region_rim.h"

#include <algorithm>
#include <cmath>

namespace mapwright::regions {
namespace {

bool isAlongX(Side side) { return side == Side::Left || side == Side::Right; }
bool isUpwards(Side side) { return side == Side::Right || side == Side::Top; }

// Of a cell. What is asked for ends so much before the cells do: rounding must not make it reach beyond a map
// that ends there.
constexpr double kInside = 0.02;
// And begins so much before where it grows from, where there are cells: rounding must not lose a row.
constexpr double kOverlap = 0.5;
constexpr int kMostCells = 1 << 24;

}  // namespace

Side opposite(Side side) {
  switch (side) {
    case Side::Left:
      return Side::Right;
    case Side::Right:
      return Side::Left;
    case Side::Bottom:
      return Side::Top;
    case Side::Top:
      break;
  }
  return Side::Bottom;
}

RimSearch::RimSearch(const Ground& ground) : ground_(ground) {
  const geometry::WorldRect& square = ground.square;
  const bool along_x = isAlongX(ground.towards);
  const double low = along_x ? square.min_x : square.min_y, high = along_x ? square.max_x : square.max_y;
  const double known_low = along_x ? ground.known.min_x : ground.known.min_y,
               known_high = along_x ? ground.known.max_x : ground.known.max_y;
  const double edge = isUpwards(ground.towards) ? low : high, far = isUpwards(ground.towards) ? high : low;
  // Cells are counted from the edge of the square, where one begins.
  const double reached =
      isUpwards(ground.towards) ? std::max(known_high, low) - edge : edge - std::min(known_low, high);
  const double cells = std::floor(reached / ground.cell_m + 0.1);
  start_m_ = edge + (isUpwards(ground.towards) ? 1 : -1) * cells * ground.cell_m;
  all_ = int(std::clamp(std::ceil(std::abs(far - start_m_) / ground.cell_m - 0.1), 0.0, double(kMostCells)));
  if ((isUpwards(ground.towards) && start_m_ >= far) || (!isUpwards(ground.towards) && start_m_ <= far))
    all_ = 0;
  most_ = ground.all_fails ? std::max(all_, 1) : all_ + 1;
}

int RimSearch::wanted() const {
  const auto open = [this](int cells) { return cells > least_ && cells < most_; };
  // What the square beside this one came to, and not one more; else: anything at all, everything, by halves.
  const int hint = std::min(ground_.hint, all_);
  if (least_ == 0) return hint > 0 && open(hint) ? hint : 1;
  if (least_ == hint && open(hint + 1)) return hint + 1;
  if (most_ == all_ + 1) return all_;
  return least_ + (most_ - least_) / 2;
}

void RimSearch::answered(bool nothing) {
  if (over()) return;
  (nothing ? most_ : least_) = wanted();
}

geometry::WorldRect RimSearch::upTo(int cells) const {
  geometry::WorldRect rect = ground_.known;
  const double begin = kOverlap * ground_.cell_m, end = (double(cells) - kInside) * ground_.cell_m;
  const bool up = isUpwards(ground_.towards);
  const double from = up ? start_m_ - begin : start_m_ - end, to = up ? start_m_ + end : start_m_ + begin;
  (isAlongX(ground_.towards) ? rect.min_x : rect.min_y) = from;
  (isAlongX(ground_.towards) ? rect.max_x : rect.max_y) = to;
  return rect;
}

geometry::WorldRect RimSearch::found() const {
  geometry::WorldRect all = ground_.known;
  if (least_ > 0) all.extend(upTo(least_));
  const geometry::WorldRect& square = ground_.square;
  const double margin = kOverlap * ground_.cell_m;
  // A margin beside the square is there as well, and is what is asked for in the next one.
  all.min_x = std::max(all.min_x, square.min_x - margin);
  all.min_y = std::max(all.min_y, square.min_y - margin);
  all.max_x = std::min(all.max_x, square.max_x + margin);
  all.max_y = std::min(all.max_y, square.max_y + margin);
  return least_ > 0 || square.contains(ground_.known.center()) ? all : geometry::WorldRect{};
}

}  // namespace mapwright::regions
