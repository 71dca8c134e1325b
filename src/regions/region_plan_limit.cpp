// RegionPlan: dispatchers that give less in one answer than a square has. What an answer leaves out is told
// from the end of the map by a small question beyond where it ends; what was not answered at all, by its
// quarters. Then squares are cut smaller.
#include <algorithm>
#include <cmath>
#include <utility>

#include "regions/region_plan.h"
#include "regions/region_sides.h"

namespace mapwright::regions {
namespace {

constexpr double kLeftOutCells = 1.5;  // less is rounding
constexpr double kSameEndCells = 0.75;
constexpr int kLookCells = 4;  // edge of the question beyond an answer

}  // namespace

bool RegionPlan::endsHere(const geometry::WorldRect& known, Side side) const {
  const auto& ends = ends_[at(side)];
  return std::any_of(ends.begin(), ends.end(), [&](double end) {
    return std::abs(end - endOf(known, side)) <= kSameEndCells * *resolution_m_;
  });
}

std::optional<Side> RegionPlan::openSide(const RegionKey& key) const {
  const RegionRow& known = row(key);
  if (!resolution_m_ || known.known.empty() || !known.answered || known.all_is_nothing || known.rim ||
      known.asked_for < round_)
    return std::nullopt;
  const geometry::WorldRect square = squareOf(key);
  for (const Side side : kSides) {
    if (!known.looked_beyond[at(side)] &&
        !reaches(known.known, square, side, kLeftOutCells * *resolution_m_) && !endsHere(known.known, side))
      return side;
  }
  return std::nullopt;
}

bool RegionPlan::searching() const { return searched_ && isInView(*searched_) && row(*searched_).quarters; }

std::optional<RegionAsk> RegionPlan::askAboutLimit() const {
  if (searching()) {
    const RegionRow& known = row(*searched_);
    if (known.ask != 0) return std::nullopt;
    const geometry::WorldRect quarter = known.quarters->asking();
    // With the margin of squares, so that they are answered where these are.
    return RegionAsk{.key = searched_,
                     .part = true,
                     .quarter = true,
                     .rect = quarter,
                     .asking = quarter.grown(resolution_m_.value_or(0) / 2)};
  }
  for (const RegionKey& key : in_view_) {
    if (row(key).ask != 0) continue;
    const auto side = openSide(key);
    if (!side) continue;
    // A few cells beyond the middle of where the answer ends.
    const geometry::WorldRect& known = row(key).known;
    const double cell = *resolution_m_, end = endOf(known, *side), half = kLookCells * cell / 2;
    const bool upwards = *side == Side::Right || *side == Side::Top;
    const double near = upwards ? end + cell / 2 : end - kLookCells * cell,
                 far = upwards ? end + kLookCells * cell : end - cell / 2;
    const Eigen::Vector2d middle = known.center();
    const bool along_x = *side == Side::Left || *side == Side::Right;
    const geometry::WorldRect look =
        common(along_x ? geometry::WorldRect{near, middle.y() - half, far, middle.y() + half}
                       : geometry::WorldRect{middle.x() - half, near, middle.x() + half, far},
               squareOf(key));
    return RegionAsk{.key = key, .part = true, .beyond = side, .rect = look, .asking = look};
  }
  return std::nullopt;
}

void RegionPlan::lookedBeyond(const RegionAsk& ask, RegionRow& row, bool nothing,
                              const geometry::WorldRect& known) {
  row.looked_beyond[at(*ask.beyond)] = true;
  if (ask.round < round_ || row.known.empty()) return;
  const bool goes_on = !nothing && !known.empty() && known.width() > 0 && known.height() > 0;
  if (goes_on) {
    if (limit_.leftOut()) takeLimit();
    return;
  }
  auto& ends = ends_[at(*ask.beyond)];
  if (ends.size() < kMostEnds) ends.push_back(endOf(row.known, *ask.beyond));
}

std::optional<Eigen::Vector2d> RegionPlan::placeIn(const RegionKey& key) const {
  const geometry::WorldRect square = squareOf(key);
  std::vector<geometry::WorldRect> known = row(key).came;
  known.push_back(probe_.known);
  for (const geometry::WorldRect& rect : known) {
    const geometry::WorldRect there = common(rect, square);
    if (!rect.empty() && !there.empty()) return there.center();
  }
  return std::nullopt;
}

bool RegionPlan::beginQuarters(const RegionAsk& ask, RegionRow& row,
                               const std::optional<Eigen::Vector2d>& place) {
  if (!place || !resolution_m_ || searching() || searches_left_ <= 0 || ask.round < round_) return false;
  const geometry::WorldRect square = squareOf(*ask.key);
  const double wide = square.width() / *resolution_m_, high = square.height() / *resolution_m_;
  if (!(wide * high <= 1e12) || limit_.hasGiven(std::int64_t(wide * high))) return false;
  const QuarterSearch search(square, int(std::max(wide, high) + 0.5), *place);
  if (search.over()) return false;
  if (searched_) {
    if (const auto left = rows_.find(*searched_); left != rows_.end()) left->second.quarters.reset();
  }
  --searches_left_;
  row.quarters = search;
  searched_ = ask.key;
  return true;
}

void RegionPlan::quarterAnswered(const RegionAsk& ask, RegionRow& row, bool nothing,
                                 const geometry::WorldRect& known) {
  if (!row.quarters || ask.round < round_) return;
  row.may_hold = row.may_hold || !nothing;
  if (!known.empty()) {
    cuts_ends_ = cuts_ends_ || std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
                   return !reaches(known, ask.rect, side, kLeftOutCells * *resolution_m_);
                 });
  }
  row.quarters->answered(!nothing);
  // Of one that cuts what is partly beyond its map there is no other reason for nothing where there is some.
  const bool too_much = row.quarters->proven() || (cuts_ends_ && !nothing);
  if (!row.quarters->over() && !too_much) return;
  row.quarters.reset();
  searched_.reset();
  if (too_much && limit_.leftOut()) return takeLimit();
  searchAround(*ask.key);
}

void RegionPlan::takeLimit() {
  if (!resolution_m_) return;
  const std::map<RegionKey, RegionRow> before = std::move(rows_);
  const RegionLattice old = lattice_;
  cut(limit_.edge() * *resolution_m_, lattice_.anchor_m);
  const double slack = kLeftOutCells * *resolution_m_;
  // What came stays, whole squares of it as they are.
  for (const auto& [key, row] : before) {
    if (row.may_hold) {
      lattice_.eachIn(old.rectOf(key), [&](const RegionKey& piece) {
        RegionRow& now = rows_[piece];
        now.may_hold = true;
        now.seen = std::max(now.seen, row.seen);
      });
    }
    std::vector<geometry::WorldRect> came;
    if (row.came_in == round_) came = row.came;
    if (row.answered && row.asked_for >= round_ && !row.known.empty()) came.push_back(row.known);
    for (const geometry::WorldRect& rect : came) {
      lattice_.eachIn(rect, [&](const RegionKey& piece) {
        const geometry::WorldRect square = squareOf(piece), there = common(rect, square);
        if (there.width() < slack || there.height() < slack) return;
        const bool all = std::all_of(kSides.begin(), kSides.end(), [&](Side side) {
          return reaches(there, square, side, *resolution_m_ * 0.1);
        });
        this->came(piece, there, all, round_);
      });
    }
  }
  listInView();
}

}  // namespace mapwright::regions
