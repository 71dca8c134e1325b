#include "regions/region_plan.h"

#include <algorithm>
#include <cmath>

namespace mapwright::regions {
namespace {

constexpr double kFiner = 0.75, kCoarser = 1.5;  // cells that are so much smaller or larger: cut anew
constexpr int kMostDoublings = 10;

geometry::WorldRect around(const Eigen::Vector2d& centre, double edge_m) {
  return geometry::WorldRect{centre.x(), centre.y(), centre.x(), centre.y()}.grown(edge_m / 2);
}

}  // namespace

map::GridRegion questionOf(const RegionAsk& ask) {
  map::GridRegion region = askedFor(ask.asking);
  region.centre_m += ask.aim.cwiseProduct(region.size_m);
  return region;
}

RegionState RegionRow::state() const {
  if (answered) return nothing ? RegionState::Nothing : RegionState::Held;
  if (ask != 0) return RegionState::Fetching;
  return failures > 0 ? RegionState::Failed : RegionState::NotAsked;
}

RegionPlan::RegionPlan(PlanOptions options) : options_(options), limit_(options.region_cells) {}

const RegionRow& RegionPlan::row(const RegionKey& key) const {
  static const RegionRow kNone;
  const auto found = rows_.find(key);
  return found == rows_.end() ? kNone : found->second;
}

void RegionPlan::setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m) {
  if (rect && (rect->empty() || !isFinite(*rect) || !centre_m.allFinite())) rect.reset();
  view_ = rect;
  centre_m_ = centre_m;
  listInView();
}

double RegionPlan::mostInView() const {
  const double pieces = double(limit_.pieces()) * limit_.pieces();
  return options_.most_in_view * std::min(pieces, double(kMostPieces));
}

void RegionPlan::listInView() {
  in_view_.clear();
  in_view_set_.clear();
  too_far_ = false;
  if (!view_ || !cut_) return;
  if (lattice_.countIn(*view_) > mostInView()) {
    too_far_ = true;
    return;
  }
  ++views_;
  lattice_.eachIn(*view_, [this](const RegionKey& key) { in_view_.push_back(key); });
  const auto distance = [this](const RegionKey& key) {
    return (lattice_.rectOf(key).center() - centre_m_).squaredNorm();
  };
  std::stable_sort(in_view_.begin(), in_view_.end(),
                   [&](const RegionKey& a, const RegionKey& b) { return distance(a) < distance(b); });
  for (const RegionKey& key : in_view_) {
    in_view_set_.insert(key);
    if (const auto found = rows_.find(key); found != rows_.end()) found->second.seen = views_;
  }
}

void RegionPlan::cut(double edge_m, const Eigen::Vector2d& anchor_m) {
  lattice_ = {anchor_m, edge_m};
  cut_ = true;
  ++cuts_;
  rows_.clear();
  searched_.reset();
  for (auto& ends : ends_) ends.clear();
  listInView();
}

bool RegionPlan::setCells(double resolution_m, const Eigen::Vector2d& anchor_m) {
  if (resolution_m_) {
    const double ratio = resolution_m / *resolution_m_;
    if ((ratio > kFiner && ratio < kCoarser) || cuts_left_ <= 0) return false;
    --cuts_left_;
  }
  resolution_m_ = resolution_m;
  cut(limit_.edge() * resolution_m, anchor_m);
  return true;
}

void RegionPlan::refresh() {
  ++round_;
  cuts_left_ = kMostCuts;
  searches_left_ = kMostSearches;
  fine_looks_left_ = kMostFineLooks;
  searched_.reset();
  for (auto& ends : ends_) ends.clear();
  for (auto& [key, row] : rows_) {
    row.rim.reset();
    row.quarters.reset();
  }
  retryNow();
}

void RegionPlan::retryNow() {
  for (auto& [key, row] : rows_) row.retry_at = Millis(0);
  probe_.retry_at = Millis(0);
}

bool RegionPlan::wanted(const RegionRow& row) const {
  return row.ask == 0 && !row.quarters && (!row.answered || row.asked_for < round_);
}

RegionAsk RegionPlan::send(RegionAsk ask, RegionRow& row) {
  ask.id = ++last_id_;
  ask.round = round_;
  ask.aim = aim_;
  row.ask = ask.id;
  under_way_.emplace(ask.id, UnderWay{ask, cuts_});
  return ask;
}

std::vector<RegionAsk> RegionPlan::take(Millis now) {
  std::vector<RegionAsk> asks;
  if (!view_) return asks;
  const auto room = [&] { return int(under_way_.size()) < options_.most_under_way; };
  if (!cut_) {
    if (probe_.ask == 0 && probe_.retry_at <= now && room()) {
      geometry::WorldRect first = around(centre_m_, options_.probe_m);
      if (options_.only) {
        const geometry::WorldRect& only = *options_.only;
        first = {std::max(first.min_x, only.min_x), std::max(first.min_y, only.min_y),
                 std::min(first.max_x, only.max_x), std::min(first.max_y, only.max_y)};
      }
      asks.push_back(send({.rect = first, .asking = first}, probe_));
    }
    return asks;
  }
  while (room()) {
    auto ask = askAboutLimit();
    if (!ask || row(*ask->key).retry_at > now) break;
    asks.push_back(send(std::move(*ask), rows_[*ask->key]));
  }
  // While it is being found out how much is given at once, more than that is not asked for.
  if (searching()) return asks;
  // What is missing before what gets newer.
  for (const bool missing : {true, false}) {
    for (const RegionKey& key : in_view_) {
      if (!room()) return asks;
      const RegionRow& known = this->row(key);
      if (known.answered == missing || !wanted(known) || known.retry_at > now) continue;
      RegionRow& row = rows_[key];
      row.seen = views_;
      // What has been found of one that was answered with nothing is asked for as it was found.
      if (row.all_is_nothing && !row.known.empty()) {
        asks.push_back(send({.key = key, .part = true, .rect = row.known, .asking = row.known}, row));
      } else {
        const geometry::WorldRect square = squareOf(key);
        asks.push_back(
            send({.key = key, .rect = square, .asking = square.grown(resolution_m_.value_or(0) / 2)}, row));
      }
    }
  }
  auto middle = emptyMiddle();
  for (const RegionKey& key : in_view_) {
    if (!room()) return asks;
    const auto part = partOf(key, middle);
    if (!part || this->row(key).retry_at > now) continue;
    RegionRow& row = rows_[key];
    if (!row.rim && row.only_tried) noteLook(row, *lookFor(key, middle));
    asks.push_back(send({.key = key, .part = true, .rect = *part, .asking = *part}, row));
    middle = emptyMiddle();
  }
  return asks;
}

std::vector<std::uint64_t> RegionPlan::unwanted() {
  std::vector<std::uint64_t> ids;
  for (auto& [id, under_way] : under_way_) {
    const bool wanted = under_way.cut == cuts_ && view_ &&
                        (under_way.ask.key ? in_view_set_.contains(*under_way.ask.key) : !cut_);
    if (wanted || under_way.told) continue;
    under_way.told = true;
    ids.push_back(id);
  }
  return ids;
}

std::optional<Millis> RegionPlan::nextDue(Millis now) const {
  if (!view_ || int(under_way_.size()) >= options_.most_under_way) return std::nullopt;
  if (!cut_) return probe_.ask == 0 ? std::optional(std::max(now, probe_.retry_at)) : std::nullopt;
  std::optional<Millis> due;
  if (const auto ask = askAboutLimit()) due = std::max(now, row(*ask->key).retry_at);
  if (searching()) return due;
  const auto middle = emptyMiddle();
  for (const RegionKey& key : in_view_) {
    const RegionRow& known = row(key);
    if (wanted(known) || partOf(key, middle))
      due = std::min(due.value_or(Millis::max()), std::max(now, known.retry_at));
  }
  return due;
}

const RegionAsk* RegionPlan::find(std::uint64_t id) const {
  const auto found = under_way_.find(id);
  return found == under_way_.end() ? nullptr : &found->second.ask;
}

bool RegionPlan::isOfThisCut(std::uint64_t id) const {
  const auto found = under_way_.find(id);
  return found != under_way_.end() && found->second.cut == cuts_;
}

/// nullptr: the lattice that it was asked for is gone.
RegionRow* RegionPlan::rowOf(const RegionAsk& ask) {
  if (!ask.key) return &probe_;
  const auto found = rows_.find(*ask.key);
  return found == rows_.end() || found->second.ask != ask.id ? nullptr : &found->second;
}

void RegionPlan::answered(std::uint64_t id, bool nothing, const geometry::WorldRect& known) {
  const auto found = under_way_.find(id);
  if (found == under_way_.end()) return;
  const RegionAsk ask = found->second.ask;
  under_way_.erase(found);
  RegionRow* const row = rowOf(ask);
  if (!row) return;
  row->ask = 0;
  if (ask.quarter) return quarterAnswered(ask, *row, nothing, known);
  if (ask.beyond) return lookedBeyond(ask, *row, nothing, known);
  row->failures = 0;
  row->trouble = {};
  row->asked_for = ask.round;
  if (ask.part) return partAnswered(ask, *row, nothing, known);
  row->answered = true;
  row->nothing = row->all_is_nothing = nothing;
  row->may_hold = !nothing;
  row->known = known;
  row->rim.reset();
  row->only_tried = !options_.only;
  row->looked_for.reset();
  row->looks = 0;
  row->beside = row->within = row->looked_beyond = {};
  row->lost_looks = 0;
  if (ask.key) {
    if (nothing && beginQuarters(ask, *row, placeIn(*ask.key))) return;
    return searchAround(*ask.key);
  }
  // It does not tell how large its cells are, so regions are as large as they usually would be.
  if (!cut_) cut(options_.region_cells * options_.assumed_resolution_m, Eigen::Vector2d::Zero());
}

void RegionPlan::failed(std::uint64_t id, RegionTrouble trouble, Millis now) {
  const auto found = under_way_.find(id);
  if (found == under_way_.end()) return;
  const RegionAsk ask = found->second.ask;
  under_way_.erase(found);
  RegionRow* const row = rowOf(ask);
  if (!row) return;
  row->ask = 0;
  if (ask.quarter) return quarterAnswered(ask, *row, true, {});
  if (ask.beyond) {
    row->retry_at = now + options_.cooldown;
    if (++row->lost_looks >= kMostLostLooks) row->looked_beyond.fill(true);
    return;
  }
  const bool refused = trouble.kind == RegionTrouble::Kind::Failed &&
                       trouble.failure.kind == map::FailureKind::RejectedByRobot;
  row->trouble = std::move(trouble);
  ++row->failures;
  wait(*row, now);
  // Once is chance.
  if (refused && row->failures > 1 && ask.key && !ask.part)
    beginQuarters(ask, *row, placeIn(*ask.key).value_or(squareOf(*ask.key).center()));
}

void RegionPlan::wait(RegionRow& row, Millis now) const {
  const int doublings = std::clamp(row.failures - 1, 0, kMostDoublings);
  row.retry_at = now + std::min(options_.cooldown * (1 << doublings), options_.cooldown_limit);
}

void RegionPlan::cancelled(std::uint64_t id) {
  const auto found = under_way_.find(id);
  if (found == under_way_.end()) return;
  const RegionAsk ask = found->second.ask;
  under_way_.erase(found);
  if (RegionRow* const row = rowOf(ask)) row->ask = 0;
}

void RegionPlan::came(const RegionKey& key, const geometry::WorldRect& where, bool all, std::uint64_t round) {
  constexpr std::size_t kMostPieces = 16;
  RegionRow& row = rows_[key];
  row.seen = std::max(row.seen, isInView(key) ? views_ : std::uint64_t(0));
  row.may_hold = true;
  if (row.came_in != round) row.came.clear();
  row.came_in = round;
  if (!where.empty() && row.came.size() < kMostPieces) row.came.push_back(where);
  if (!all || row.ask != 0) return;
  row.answered = true;
  row.nothing = row.all_is_nothing = false;
  row.known = where;
  row.rim.reset();
  row.quarters.reset();
  if (searched_ == key) searched_.reset();
  row.asked_for = std::max(row.asked_for, round);
  row.failures = 0;
  row.trouble = {};
}

void RegionPlan::forget(const RegionKey& key) {
  const auto found = rows_.find(key);
  if (found != rows_.end() && found->second.ask == 0) rows_.erase(found);
}

bool RegionPlan::settled(int tries) const {
  if (!view_) return true;
  if (!cut_) return probe_.failures >= tries;
  if (askAboutLimit()) return false;
  const auto middle = emptyMiddle();
  return std::all_of(in_view_.begin(), in_view_.end(), [&](const RegionKey& key) {
    const RegionRow& known = row(key);
    if (known.ask != 0) return false;
    if (known.quarters || (partOf(key, middle) && known.failures < tries)) return false;
    return (known.answered && known.asked_for >= round_) || known.failures >= tries;
  });
}

}  // namespace mapwright::regions
