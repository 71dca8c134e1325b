// RegionPlan: what was answered with nothing is asked for in parts, where there is reason to think that the
// map reaches into it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "regions/region_plan.h"
#include "regions/region_sides.h"

namespace mapwright::regions {
namespace {

constexpr double kTouchCells = 0.1;  // rounding of places that are the same
constexpr int kPlaceCells = 16;
constexpr int kLookPlaces = 1 + 4 + 16;

/// The middle of a square, those of its quarters, and of theirs.
Eigen::Vector2d lookPlace(const geometry::WorldRect& square, int number) {
  const int across = number == 0 ? 1 : number < 5 ? 2 : 4;
  const int place = number - (number == 0 ? 0 : number < 5 ? 1 : 5);
  return {square.min_x + square.width() * (place % across + 0.5) / across,
          square.min_y + square.height() * (place / across + 0.5) / across};
}

/// `known` reaches the side of `square` that is turned to it.
bool touches(const geometry::WorldRect& known, const geometry::WorldRect& square, Side side, double slack) {
  if (known.empty()) return false;
  switch (side) {
    case Side::Left:
      return known.max_x >= square.min_x - slack;
    case Side::Right:
      return known.min_x <= square.max_x + slack;
    case Side::Bottom:
      return known.max_y >= square.min_y - slack;
    case Side::Top:
      break;
  }
  return known.min_y <= square.max_y + slack;
}

/// As wide as `square` where it lies beside it.
bool spans(const geometry::WorldRect& known, const geometry::WorldRect& square, Side towards, double slack) {
  return towards == Side::Left || towards == Side::Right
             ? known.min_y <= square.min_y + slack && known.max_y >= square.max_y - slack
             : known.min_x <= square.min_x + slack && known.max_x >= square.max_x - slack;
}

}  // namespace

geometry::WorldRect RegionPlan::squareOf(const RegionKey& key) const {
  const geometry::WorldRect square = lattice_.rectOf(key);
  if (!options_.only) return square;
  const geometry::WorldRect wanted = common(square, *options_.only);
  return wanted.empty() ? square : wanted;
}

bool RegionPlan::canBeSearched(const RegionRow& row) const {
  return row.answered && row.all_is_nothing && row.ask == 0 && row.asked_for >= round_;
}

std::optional<RegionKey> RegionPlan::emptyMiddle() const {
  if (!cut_ || !view_ || !view_->contains(centre_m_)) return std::nullopt;
  const bool empty = std::all_of(in_view_.begin(), in_view_.end(), [this](const RegionKey& key) {
    return canBeSearched(row(key)) && row(key).nothing && !row(key).rim;
  });
  if (!empty || in_view_.empty()) return std::nullopt;
  std::optional<RegionKey> middle;
  lattice_.eachIn({centre_m_.x(), centre_m_.y(), centre_m_.x(), centre_m_.y()},
                  [&](const RegionKey& key) { middle = key; });
  return middle && isInView(*middle) ? middle : std::nullopt;
}

std::optional<geometry::WorldRect> RegionPlan::partOf(const RegionKey& key,
                                                      const std::optional<RegionKey>& middle) const {
  const RegionRow& known = row(key);
  if (!canBeSearched(known) || known.quarters) return std::nullopt;
  if (known.rim) return known.rim->asking();
  if (!known.known.empty()) return std::nullopt;
  if (!known.only_tried) return squareOf(key);
  const auto look = lookFor(key, middle);
  if (!look) return std::nullopt;
  const geometry::WorldRect there{look->place.x(), look->place.y(), look->place.x(), look->place.y()};
  // The smaller it is, the nearer to the rim it may lie.
  const double few_cells_m = kPlaceCells * resolution_m_.value_or(options_.assumed_resolution_m);
  const double edge_m = look->middle_of_view ? options_.probe_m : std::min(options_.probe_m, few_cells_m);
  return common(there.grown(edge_m / 2), squareOf(key));
}

std::optional<RegionPlan::Look> RegionPlan::lookFor(const RegionKey& key,
                                                    const std::optional<RegionKey>& middle) const {
  if (!middle) return std::nullopt;
  const RegionRow& tried = row(key);
  if (*middle == key) {
    const auto& before = tried.looked_for;
    const bool new_place = !before || (*before - centre_m_).cwiseAbs().maxCoeff() > options_.probe_m / 2;
    if (new_place) return Look{centre_m_, true};
  }
  const bool nothing_is_known =
      std::all_of(rows_.begin(), rows_.end(), [](const auto& each) { return each.second.known.empty(); });
  if (!nothing_is_known || tried.looks >= kLookPlaces || (tried.looks > 0 && fine_looks_left_ <= 0))
    return std::nullopt;
  // Each square as finely as the others.
  const bool others_first = std::any_of(in_view_.begin(), in_view_.end(), [&](const RegionKey& other) {
    return row(other).looks < tried.looks;
  });
  if (others_first) return std::nullopt;
  return Look{lookPlace(squareOf(key), tried.looks)};
}

void RegionPlan::noteLook(RegionRow& row, const Look& look) {
  if (look.middle_of_view) {
    row.looked_for = look.place;
  } else if (row.looks++ > 0) {
    --fine_looks_left_;
  }
}

int RegionPlan::hintFor(const RegionKey& key, Side towards) const {
  const bool along_x = towards == Side::Left || towards == Side::Right;
  for (const Side side :
       along_x ? std::array{Side::Bottom, Side::Top} : std::array{Side::Left, Side::Right}) {
    if (const int cells = row(besideOf(key, side)).cells_to[at(towards)]; cells > 0) return cells;
  }
  return 0;
}

bool RegionPlan::beginRim(const RegionKey& key, RegionRow& row, const geometry::WorldRect& known,
                          Side towards) {
  const geometry::WorldRect square = squareOf(key);
  const double cell_m = *resolution_m_;
  RimSearch search({square, known, towards, cell_m, hintFor(key, towards),
                    row.known.empty() && spans(known, square, towards, cell_m * kTouchCells)});
  if (search.over()) return false;
  row.rim = search;
  return true;
}

void RegionPlan::searchIn(const RegionKey& key) {
  const auto found = rows_.find(key);
  if (found == rows_.end() || !resolution_m_ || !canBeSearched(found->second) || found->second.rim) return;
  RegionRow& row = found->second;
  if (!row.known.empty()) {
    for (const Side towards : kSides) {
      if (!std::exchange(row.within[at(towards)], true) && beginRim(key, row, row.known, towards)) return;
    }
    return;
  }
  for (const Side side : kSides) {
    const RegionRow& beside = this->row(besideOf(key, side));
    const bool current = beside.asked_for >= round_;
    if (row.beside[at(side)] || !current ||
        !touches(beside.known, squareOf(key), side, *resolution_m_ * kTouchCells))
      continue;
    row.beside[at(side)] = true;
    if (beginRim(key, row, beside.known, opposite(side))) return;
  }
}

void RegionPlan::searchAround(const RegionKey& key) {
  searchIn(key);
  for (const Side side : kSides) searchIn(besideOf(key, side));
}

bool RegionPlan::hasSeam(const RegionKey& key) const {
  constexpr double kLackCells = 1.5;  // less is rounding
  const RegionRow& known = row(key);
  if (!resolution_m_ || known.known.empty() || known.ask != 0 || known.rim || openSide(key)) return false;
  const geometry::WorldRect square = squareOf(key);
  const double slack = kLackCells * *resolution_m_;
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    const RegionRow& beside = row(besideOf(key, side));
    return !beside.known.empty() && beside.asked_for == known.asked_for &&
           !reaches(known.known, square, side, slack);
  });
}

void RegionPlan::partAnswered(const RegionAsk& ask, RegionRow& row, bool nothing,
                              const geometry::WorldRect& known) {
  row.may_hold = row.may_hold || !nothing;
  if (ask.round < round_) return;  // all is asked for anew
  if (row.rim) {
    row.rim->answered(nothing);
    if (!row.rim->over()) return;
    const RimSearch rim = *std::exchange(row.rim, std::nullopt);
    row.cells_to[at(rim.towards())] = rim.cells();
    if (rim.cells() > 0) {
      // What was found from beside has its ends along that axis.
      if (row.known.empty()) row.within[at(rim.towards())] = row.within[at(opposite(rim.towards()))] = true;
      row.known = rim.found();
      row.nothing = false;
    }
  } else {
    row.only_tried = true;
    row.known = nothing ? geometry::WorldRect{} : known;
    row.nothing = nothing;
    row.beside = row.within = {};
    if (!row.known.empty() && beginQuarters(ask, row, row.known.center())) return;
  }
  searchAround(*ask.key);
}

}  // namespace mapwright::regions
