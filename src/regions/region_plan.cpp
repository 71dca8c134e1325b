#include "regions/region_plan.h"

#include <algorithm>
#include <cmath>

#include "regions/region_sheet.h"

namespace mapwright::regions {
namespace {

static_assert(PlanOptions{}.region_cells == RegionSheet::kStep);  // whole tiles of a sheet

constexpr double kFiner = 0.75, kCoarser = 1.5;  // relative cell size that causes a new layout
constexpr int kMostDoublings = 10;
constexpr double kInside = 0.02;    // of a cell: a request ends this much before the map, whatever is rounded
constexpr double kLackCells = 1.5;  // less is rounding

geometry::WorldRect around(const Eigen::Vector2d& centre, double edge_m) {
  return geometry::WorldRect{centre.x(), centre.y(), centre.x(), centre.y()}.grown(edge_m / 2);
}

}  // namespace

RegionState RegionRow::state() const {
  if (answered) return nothing() ? RegionState::Nothing : RegionState::Held;
  if (request != 0) return RegionState::Fetching;
  return failures > 0 ? RegionState::Failed : RegionState::NotAsked;
}

RegionPlan::RegionPlan(PlanOptions options)
    : options_(options), edge_cells_(std::max(1, options.region_cells)) {}

const RegionRow& RegionPlan::row(const RegionKey& key) const {
  static const RegionRow kNone;
  const auto found = rows_.find(key);
  return found == rows_.end() ? kNone : found->second;
}

double RegionPlan::mostInView() const {
  const double pieces = double(options_.region_cells) / edge_cells_;
  return options_.most_in_view * std::min(pieces * pieces, double(kMostPieces));
}

void RegionPlan::setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m) {
  squares_.look(rect, centre_m, mostInView());
  ++views_;
  for (const RegionKey& key : squares_.keys()) {
    if (const auto found = rows_.find(key); found != rows_.end()) found->second.seen = views_;
  }
}

void RegionPlan::cut(double edge_m, const Eigen::Vector2d& anchor_m) {
  ++cuts_;
  rows_.clear();
  squares_.cut({anchor_m, edge_m}, mostInView());
}

bool RegionPlan::setCells(double resolution_m, const Eigen::Vector2d& anchor_m) {
  if (resolution_m_) {
    const double ratio = resolution_m / *resolution_m_;
    if ((ratio > kFiner && ratio < kCoarser) || cuts_left_ <= 0) return false;
    --cuts_left_;
  }
  resolution_m_ = resolution_m;
  cut(edge_cells_ * resolution_m, anchor_m);
  return true;
}

void RegionPlan::gave(const map::GridReference& grid) {
  most_given_ = std::max(most_given_, std::int64_t(grid.width) * grid.height);
  if (grid.origin.yaw_rad == 0) reach_.extend(grid.bounds());
}

bool RegionPlan::halve(const geometry::WorldRect& asked) {
  const double cells = asked.width() * asked.height() / (*resolution_m_ * *resolution_m_);
  if (cells <= double(most_given_) || edge_cells_ / 2 < kLeastCells) return false;
  edge_cells_ /= 2;
  const RegionLattice old = lattice();
  const std::map<RegionKey, RegionRow> before = std::move(rows_);
  cut(edge_cells_ * *resolution_m_, old.anchor_m);
  // The received cells stay.
  for (const auto& [key, whole] : before) {
    if (!whole.may_hold) continue;
    lattice().eachIn(old.rectOf(key), [&, seen = whole.seen](const RegionKey& piece) {
      rows_[piece].may_hold = true;
      rows_[piece].seen = std::max(rows_[piece].seen, seen);
    });
  }
  return true;
}

void RegionPlan::refresh() {
  ++round_;
  cuts_left_ = kMostCuts;
  reach_ = {};
  retryNow();
}

void RegionPlan::retryNow() {
  for (auto& [key, row] : rows_) row.retry_at = Millis(0);
  probe_.retry_at = Millis(0);
}

geometry::WorldRect RegionPlan::firstRect() const {
  const geometry::WorldRect first = around(squares_.centre(), options_.probe_m);
  return options_.only ? common(first, *options_.only) : first;
}

geometry::WorldRect RegionPlan::squareOf(const RegionKey& key) const {
  const geometry::WorldRect square = lattice().rectOf(key);
  if (!options_.only) return square;
  const geometry::WorldRect wanted = common(square, *options_.only);
  return wanted.empty() ? square : wanted;
}

geometry::WorldRect RegionPlan::questionFor(const RegionKey& key) const {
  const double cell_m = resolution_m_.value_or(0);
  const geometry::WorldRect question = squareOf(key).grown(cell_m / 2);
  if (!extent_) return question;
  const geometry::WorldRect on_map = common(question, extent_->grown(-kInside * cell_m));
  return on_map.empty() ? question : on_map;
}

bool RegionPlan::leftOut(const RegionKey& key) const {
  const RegionRow& of = row(key);
  if (!resolution_m_ || !of.answered || of.request != 0 || (of.known.empty() && !of.came_empty)) return false;
  const geometry::WorldRect there = common(squareOf(key), reach_), &known = of.known;
  const double slack = kLackCells * *resolution_m_;
  if (of.came_empty) return there.width() > slack && there.height() > slack;
  return !there.empty() && std::max({known.min_x - there.min_x, there.max_x - known.max_x,
                                     known.min_y - there.min_y, there.max_y - known.max_y}) > slack;
}

std::vector<RegionRequest> RegionPlan::wanted() const {
  std::vector<RegionRequest> wanted;
  if (!squares_.rect()) return wanted;
  if (!squares_.isCut()) {
    if (probe_.request == 0) wanted.push_back({.rect = firstRect()});
    return wanted;
  }
  // Missing regions come before updates.
  for (const bool missing : {true, false}) {
    for (const RegionKey& key : squares_.keys()) {
      const RegionRow& known = row(key);
      if (known.answered == missing || known.request != 0 || (known.answered && known.asked_for >= round_))
        continue;
      wanted.push_back({.is_first = false, .key = key, .rect = questionFor(key)});
    }
  }
  return wanted;
}

std::vector<RegionRequest> RegionPlan::take(Millis now) {
  for (const RegionKey& key : squares_.keys()) {
    if (leftOut(key) && halve(questionFor(key))) break;
  }
  std::vector<RegionRequest> sent;
  for (RegionRequest& request : wanted()) {
    if (int(in_progress_.size()) >= options_.most_in_progress) break;
    RegionRow& row = request.is_first ? probe_ : rows_[request.key];
    if (row.retry_at > now || row.request != 0) continue;
    if (!request.is_first) row.seen = views_;
    request.id = ++last_id_;
    request.round = round_;
    row.request = request.id;
    in_progress_.emplace(request.id, RequestInProgress{request, cuts_});
    sent.push_back(request);
  }
  return sent;
}

std::vector<std::uint64_t> RegionPlan::unwanted() {
  std::vector<std::uint64_t> ids;
  for (auto& [id, in_progress] : in_progress_) {
    const RegionRequest& request = in_progress.request;
    const bool wanted = in_progress.cut == cuts_ && squares_.rect() &&
                        (request.is_first ? !squares_.isCut() : squares_.contains(request.key));
    if (wanted || in_progress.told) continue;
    in_progress.told = true;
    ids.push_back(id);
  }
  return ids;
}

std::optional<Millis> RegionPlan::nextDue(Millis now) const {
  if (int(in_progress_.size()) >= options_.most_in_progress) return std::nullopt;
  std::optional<Millis> due;
  for (const RegionRequest& request : wanted()) {
    const RegionRow& of = request.is_first ? probe_ : row(request.key);
    due = std::min(due.value_or(Millis::max()), std::max(now, of.retry_at));
  }
  return due;
}

bool RegionPlan::settled(int tries) const {
  if (!squares_.rect()) return true;
  if (!squares_.isCut()) return probe_.failures >= tries;
  const auto wanted = this->wanted();
  return std::none_of(squares_.keys().begin(), squares_.keys().end(),
                      [&](const RegionKey& key) { return row(key).request != 0; }) &&
         std::all_of(wanted.begin(), wanted.end(),
                     [&](const RegionRequest& request) { return row(request.key).failures >= tries; });
}

const RegionRequest* RegionPlan::find(std::uint64_t id) const {
  const auto found = in_progress_.find(id);
  return found == in_progress_.end() ? nullptr : &found->second.request;
}

bool RegionPlan::isOfThisCut(std::uint64_t id) const {
  const auto found = in_progress_.find(id);
  return found != in_progress_.end() && found->second.cut == cuts_;
}

/// nullptr: the lattice of the request no longer exists.
RegionRow* RegionPlan::rowOf(const RegionRequest& request) {
  if (request.is_first) return &probe_;
  const auto found = rows_.find(request.key);
  return found == rows_.end() || found->second.request != request.id ? nullptr : &found->second;
}

void RegionPlan::answered(std::uint64_t id, bool nothing, const geometry::WorldRect& known) {
  const auto found = in_progress_.find(id);
  if (found == in_progress_.end()) return;
  const RegionRequest request = found->second.request;
  in_progress_.erase(found);
  RegionRow* const row = rowOf(request);
  if (!row) return;
  row->request = 0;
  row->failures = 0;
  row->trouble = {};
  if (request.is_first) {
    // It does not report its cell size, so regions have the usual size.
    if (!squares_.isCut())
      cut(options_.region_cells * options_.assumed_resolution_m, Eigen::Vector2d::Zero());
    return;
  }
  row->answered = true;
  row->asked_for = request.round;
  row->came_empty = nothing;
  row->known = known;
  row->may_hold = !nothing;
}

void RegionPlan::failed(std::uint64_t id, RegionTrouble trouble, Millis now) {
  const auto found = in_progress_.find(id);
  if (found == in_progress_.end()) return;
  const RegionRequest request = found->second.request;
  in_progress_.erase(found);
  RegionRow* const row = rowOf(request);
  if (!row) return;
  row->request = 0;
  const bool refused = trouble.kind == RegionTrouble::Kind::Failed &&
                       trouble.failure.kind == map::FailureKind::RejectedByRobot;
  row->trouble = std::move(trouble);
  ++row->failures;
  const int doublings = std::clamp(row->failures - 1, 0, kMostDoublings);
  row->retry_at = now + std::min(options_.cooldown * (1 << doublings), options_.cooldown_limit);
  // A single failure may be chance.
  if (refused && row->failures > 1 && resolution_m_ && !request.is_first) halve(request.rect);
}

void RegionPlan::cancelled(std::uint64_t id) {
  const auto found = in_progress_.find(id);
  if (found == in_progress_.end()) return;
  const RegionRequest request = found->second.request;
  in_progress_.erase(found);
  if (RegionRow* const row = rowOf(request)) row->request = 0;
}

void RegionPlan::came(const RegionKey& key, const geometry::WorldRect& where, bool all, std::uint64_t round) {
  RegionRow& row = rows_[key];
  row.seen = std::max(row.seen, squares_.contains(key) ? views_ : std::uint64_t(0));
  row.may_hold = true;
  if (!all || row.request != 0) return;
  row.answered = true;
  row.came_empty = false;
  row.known = where;
  row.asked_for = std::max(row.asked_for, round);
  row.failures = 0;
  row.trouble = {};
}

void RegionPlan::forget(const RegionKey& key) {
  const auto found = rows_.find(key);
  if (found != rows_.end() && found->second.request == 0) rows_.erase(found);
}

}  // namespace mapwright::regions
