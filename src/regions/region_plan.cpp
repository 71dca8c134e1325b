#include "regions/region_plan.h"

#include <algorithm>
#include <cmath>

namespace mapwright::regions {
namespace {

using Kind = RegionRequest::Kind;

constexpr double kFiner = 0.75, kCoarser = 1.5;  // relative cell size that causes a new layout
constexpr int kMostDoublings = 10;
constexpr int kLookCells = 16;  // edge of a test region; the smaller, the closer to an edge of the map
constexpr int kLooksAcross = 4;

geometry::WorldRect around(const Eigen::Vector2d& centre, double edge_m) {
  return geometry::WorldRect{centre.x(), centre.y(), centre.x(), centre.y()}.grown(edge_m / 2);
}

}  // namespace

map::GridRegion questionOf(const RegionRequest& request) {
  map::GridRegion region = askedFor(request.rect);
  region.centre_m += request.aim.cwiseProduct(region.size_m);
  return region;
}

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
  ends_.stop();
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

void RegionPlan::gave(int width, int height) {
  most_given_ = std::max(most_given_, std::int64_t(width) * height);
}

bool RegionPlan::halve(const geometry::WorldRect& asked) {
  const double cells = asked.width() * asked.height() / (*resolution_m_ * *resolution_m_);
  // A size that it has delivered before is not too much.
  if (cells <= double(most_given_) || edge_cells_ / 2 < kLeastCells) return false;
  edge_cells_ /= 2;
  const RegionLattice old = lattice();
  const std::map<RegionKey, RegionRow> before = std::move(rows_);
  cut(edge_cells_ * *resolution_m_, old.anchor_m);
  // The received cells stay, and are known to be on the map.
  for (const auto& [key, of_old] : before) {
    const RegionRow& whole = of_old;
    if (!whole.may_hold) continue;
    lattice().eachIn(old.rectOf(key), [&](const RegionKey& piece) {
      RegionRow& row = rows_[piece];
      row.may_hold = true;
      row.seen = std::max(row.seen, whole.seen);
      row.came_in = round_;
      if (whole.came_in != round_) return;
      for (const geometry::WorldRect& rect : whole.came) {
        if (const auto there = common(rect, lattice().rectOf(piece)); !there.empty())
          row.came.push_back(there);
      }
    });
  }
  return true;
}

void RegionPlan::refresh() {
  ++round_;
  cuts_left_ = kMostCuts;
  looks_left_ = kMostLooks;
  looked_from_.reset();
  ends_.forget();
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
  return lattice().rectOf(key).grown(resolution_m_.value_or(0) / 2);
}

geometry::WorldRect RegionPlan::partOf(const RegionKey& key) const {
  geometry::WorldRect part = questionFor(key);
  if (options_.only) {
    if (const auto wanted = common(part, *options_.only); !wanted.empty()) part = wanted;
  }
  return ends_.within(part, resolution_m_.value_or(0));
}

bool RegionPlan::isCurrent(const RegionRow& row) const {
  return row.answered && row.asked_for >= round_ && row.request == 0;
}

bool RegionPlan::asksInPart(const RegionKey& key) const {
  const RegionRow& known = row(key);
  if (!isCurrent(known) || !known.whole_is_nothing) return false;
  const geometry::WorldRect part = partOf(key);
  const auto isAsBefore = [&, about = resolution_m_.value_or(0) / 2](Side side) {
    return std::abs(endOf(part, side) - endOf(known.part, side)) <= about;
  };
  return !common(part, squareOf(key)).empty() && part != questionFor(key) &&
         !std::all_of(kSides.begin(), kSides.end(), isAsBefore);
}

std::optional<geometry::WorldRect> RegionPlan::groundAt(const RegionKey& key) const {
  const RegionRow& known = row(key);
  if (!known.known.empty()) return known.known;
  if (known.came_in == round_ && !known.came.empty()) {
    const auto area = [](const geometry::WorldRect& rect) { return rect.width() * rect.height(); };
    return *std::max_element(known.came.begin(), known.came.end(),
                             [&](const auto& a, const auto& b) { return area(a) < area(b); });
  }
  const geometry::WorldRect square = lattice().rectOf(key);
  for (const Side side : kSides) {
    const RegionRow& beside = row(besideOf(key, side));
    if (isCurrent(beside) && beside.known.intersects(square.grown(*resolution_m_ / 2))) return beside.known;
  }
  return std::nullopt;
}

void RegionPlan::learn() {
  if (!resolution_m_) return;
  if (ends_.searching() && !squares_.contains(end_of_)) ends_.stop();
  for (const RegionKey& key : squares_.keys()) {
    const RegionRow& known = row(key);
    if (!isCurrent(known) || asksInPart(key)) continue;
    const auto ground = groundAt(key);
    if (!ground) continue;
    const geometry::WorldRect square = squareOf(key);
    if (const auto side = ends_.openSide(square, *ground, *resolution_m_)) {
      if (ends_.searching()) continue;
      end_of_ = key;
      ends_.search(*side, *ground, square, *resolution_m_);
    } else if (known.known.empty() ? ground->intersects(square) && halve(partOf(key))
                                   : leftOut(key) && halve(questionFor(key))) {
      return;
    }
  }
}

bool RegionPlan::hasMoved() const {
  return !looked_from_ || (*looked_from_ - squares_.centre()).cwiseAbs().maxCoeff() > options_.probe_m / 2;
}

std::optional<RegionRequest> RegionPlan::lookForAnything() const {
  const bool empty =
      std::all_of(squares_.keys().begin(), squares_.keys().end(),
                  [this](const RegionKey& key) { return isCurrent(row(key)) && row(key).nothing(); });
  if (!empty || !squares_.rect() || squares_.keys().empty()) return std::nullopt;
  const geometry::WorldRect& view = *squares_.rect();
  const int number = hasMoved() ? 0 : looks_;
  // First the centre; if nothing at all is known of the map, more places.
  const bool anything_known = std::any_of(rows_.begin(), rows_.end(), [this](const auto& each) {
    return each.second.may_hold && each.second.came_in == round_;
  });
  if (number > kLooksAcross * kLooksAcross || (number > 0 && (anything_known || looks_left_ <= 0)))
    return std::nullopt;
  const int place = number - 1;
  const Eigen::Vector2d at =
      number == 0 ? squares_.centre()
                  : Eigen::Vector2d(view.min_x + view.width() * (place % kLooksAcross + 0.5) / kLooksAcross,
                                    view.min_y + view.height() * (place / kLooksAcross + 0.5) / kLooksAcross);
  const auto key = squares_.at(at);
  if (!key) return std::nullopt;
  const double few_cells_m = kLookCells * resolution_m_.value_or(options_.assumed_resolution_m);
  const double edge_m = number == 0 ? options_.probe_m : std::min(options_.probe_m, few_cells_m);
  return RegionRequest{.kind = Kind::Look, .key = *key, .rect = common(around(at, edge_m), squareOf(*key))};
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
      wanted.push_back({.kind = Kind::Square, .key = key, .rect = questionFor(key)});
    }
  }
  if (ends_.searching() && row(end_of_).request == 0)
    wanted.push_back({.kind = Kind::End, .key = end_of_, .rect = ends_.asking()});
  for (const RegionKey& key : squares_.keys()) {
    if (asksInPart(key)) wanted.push_back({.kind = Kind::Part, .key = key, .rect = partOf(key)});
  }
  if (wanted.empty()) {
    if (const auto look = lookForAnything()) wanted.push_back(*look);
  }
  return wanted;
}

std::vector<RegionRequest> RegionPlan::take(Millis now) {
  learn();
  std::vector<RegionRequest> sent;
  for (RegionRequest& request : wanted()) {
    if (int(under_way_.size()) >= options_.most_under_way) break;
    RegionRow& row = request.isOfSquare() ? rows_[request.key] : probe_;
    if (row.retry_at > now || row.request != 0) continue;
    if (request.isOfSquare()) row.seen = views_;
    request.id = ++last_id_;
    request.round = round_;
    request.aim = aim_;
    row.request = request.id;
    under_way_.emplace(request.id, UnderWay{request, cuts_});
    sent.push_back(request);
  }
  return sent;
}

std::vector<std::uint64_t> RegionPlan::unwanted() {
  std::vector<std::uint64_t> ids;
  for (auto& [id, under_way] : under_way_) {
    const RegionRequest& request = under_way.request;
    const bool wanted = under_way.cut == cuts_ && squares_.rect() &&
                        (request.isOfSquare() ? squares_.contains(request.key) : !squares_.isCut());
    if (wanted || under_way.told) continue;
    under_way.told = true;
    ids.push_back(id);
  }
  return ids;
}

std::optional<Millis> RegionPlan::nextDue(Millis now) const {
  if (int(under_way_.size()) >= options_.most_under_way) return std::nullopt;
  std::optional<Millis> due;
  for (const RegionRequest& request : wanted()) {
    const RegionRow& of = request.isOfSquare() ? row(request.key) : probe_;
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
  const auto found = under_way_.find(id);
  return found == under_way_.end() ? nullptr : &found->second.request;
}

bool RegionPlan::isOfThisCut(std::uint64_t id) const {
  const auto found = under_way_.find(id);
  return found != under_way_.end() && found->second.cut == cuts_;
}

/// nullptr: the lattice of the request no longer exists.
RegionRow* RegionPlan::rowOf(const RegionRequest& request) {
  if (!request.isOfSquare()) return &probe_;
  const auto found = rows_.find(request.key);
  return found == rows_.end() || found->second.request != request.id ? nullptr : &found->second;
}

void RegionPlan::answered(std::uint64_t id, bool nothing, const geometry::WorldRect& known) {
  const auto found = under_way_.find(id);
  if (found == under_way_.end()) return;
  const RegionRequest request = found->second.request;
  under_way_.erase(found);
  RegionRow* const row = rowOf(request);
  if (!row) return;
  row->request = 0;
  row->failures = 0;
  row->trouble = {};
  switch (request.kind) {
    case Kind::First:
      // It does not report its cell size, so regions have the usual size.
      if (!squares_.isCut())
        cut(options_.region_cells * options_.assumed_resolution_m, Eigen::Vector2d::Zero());
      return;
    case Kind::Square:
      row->answered = true;
      row->asked_for = request.round;
      row->whole_is_nothing = nothing;
      row->known = known;
      row->part = {};
      // Cells from other answers of this round stay.
      row->may_hold = !nothing || (row->came_in == request.round && row->may_hold);
      return;
    case Kind::Part:
      row->part = request.rect;
      row->known = nothing ? geometry::WorldRect{} : known;
      return;
    case Kind::End:
      if (request.round == round_ && ends_.searching() && request.key == end_of_) ends_.answered(known);
      return;
    case Kind::Look:
      if (hasMoved()) {
        looked_from_ = squares_.centre();
        looks_ = 0;
      }
      if (looks_++ > 0) --looks_left_;
      return;
  }
}

void RegionPlan::failed(std::uint64_t id, RegionTrouble trouble, Millis now) {
  const auto found = under_way_.find(id);
  if (found == under_way_.end()) return;
  const RegionRequest request = found->second.request;
  under_way_.erase(found);
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
  if (refused && row->failures > 1 && resolution_m_ && request.kind == Kind::Square) halve(request.rect);
}

void RegionPlan::cancelled(std::uint64_t id) {
  const auto found = under_way_.find(id);
  if (found == under_way_.end()) return;
  const RegionRequest request = found->second.request;
  under_way_.erase(found);
  if (RegionRow* const row = rowOf(request)) row->request = 0;
}

void RegionPlan::came(const RegionKey& key, const geometry::WorldRect& where, bool all, std::uint64_t round) {
  constexpr std::size_t kMostRects = 16;
  RegionRow& row = rows_[key];
  row.seen = std::max(row.seen, squares_.contains(key) ? views_ : std::uint64_t(0));
  row.may_hold = true;
  if (row.came_in != round) row.came.clear();
  row.came_in = round;
  if (!where.empty() && row.came.size() < kMostRects) row.came.push_back(where);
  if (!all || row.request != 0) return;
  row.answered = true;
  row.whole_is_nothing = false;
  row.known = where;
  row.asked_for = std::max(row.asked_for, round);
  row.failures = 0;
  row.trouble = {};
}

void RegionPlan::forget(const RegionKey& key) {
  const auto found = rows_.find(key);
  if (found != rows_.end() && found->second.request == 0) rows_.erase(found);
}

bool RegionPlan::leftOut(const RegionKey& key) const {
  const RegionRow& known = row(key);
  if (!resolution_m_ || known.known.empty() || known.request != 0) return false;
  const geometry::WorldRect square = squareOf(key);
  return !ends_.openSide(square, known.known, *resolution_m_) &&
         ends_.goesOnBeyond(known.known, square, *resolution_m_);
}

}  // namespace mapwright::regions
