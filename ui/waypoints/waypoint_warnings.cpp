#include "ui/waypoints/waypoint_warnings.h"

#include <utility>

namespace mapwright::ui {
namespace {

constexpr std::size_t kMostOfGroup = 2'500;

}  // namespace

WaypointWarnings::WaypointWarnings(WaypointEditing* editing, std::shared_ptr<work::Workers> workers,
                                   QObject* parent)
    : QObject(parent), editing_(editing), share_(std::move(workers)) {
  connect(editing_, &WaypointEditing::opened, this, [this] {
    if (editing_->document())
      connect(editing_->document(), &edit::WaypointDocument::changed, this, &WaypointWarnings::onChanged,
              Qt::UniqueConnection);
    begin();
  });
  connect(editing_, &WaypointEditing::previewChanged, this, &WaypointWarnings::onPreview);
}

WaypointWarnings::~WaypointWarnings() {
  if (cancelled_) *cancelled_ = true;
}

const placing::Warnings& WaypointWarnings::of(const edit::Key& key) const {
  static const placing::Warnings kNone;
  const auto found = all_.find(key);
  return found == all_.end() ? kNone : found->second;
}

edit::Key WaypointWarnings::next(const edit::Key& key) const {
  if (all_.empty()) return {};
  const auto after = all_.upper_bound(key);
  return after == all_.end() ? all_.begin()->first : after->first;
}

void WaypointWarnings::setMap(const placing::PlacedMap& map) {
  if (map_ == map) return;
  map_ = map;
  everythingAnew();
}

void WaypointWarnings::setRadius(double radius_m) {
  if (std::exchange(radius_m_, radius_m) != radius_m) everythingAnew();
}

void WaypointWarnings::setZeroTurns(std::set<edit::Key> keys) {
  if (zero_turns_ == keys) return;
  std::set<edit::Key> either = std::exchange(zero_turns_, keys);
  either.merge(keys);
  std::set<std::string> touched;
  for (const edit::Key& key : either) {
    if (settle(key)) touched.insert(key);
  }
  emitChanged(touched);
}

void WaypointWarnings::cellsChanged(const geometry::WorldRect& where) {
  if (!editing_->document()) return;
  const geometry::WorldRect reach = where.grown(radius_m_);
  for (const auto& [key, point] : editing_->document()->items()) {
    if (reach.contains(point.position_m)) waiting_.insert(key);
  }
  lookSoon();
}

void WaypointWarnings::begin() {
  std::set<std::string> gone;
  for (const auto& [key, warnings] : all_) gone.insert(key);
  of_ground_.clear();
  all_.clear();
  waiting_.clear();
  previewed_.clear();
  preview_waits_ = false;
  if (const edit::WaypointDocument* const document = editing_->document()) {
    std::set<std::string> touched;
    lookForNames(touched);
    for (const auto& [key, point] : document->items()) settle(key);
  }
  everythingAnew();
  for (const auto& [key, warnings] : all_) gone.insert(key);
  emitChanged(gone);
}

void WaypointWarnings::everythingAnew() {
  ++state_;
  if (cancelled_) *cancelled_ = true;
  waiting_.clear();
  if (const edit::WaypointDocument* const document = editing_->document()) {
    for (const auto& [key, point] : document->items()) waiting_.insert(waiting_.end(), key);
  }
  lookSoon();
}

void WaypointWarnings::onChanged(const edit::DocumentChange& change) {
  if (sender() != editing_->document()) return;  // from a closed list
  if (change.everything) return begin();
  std::set<std::string> touched;
  // If only positions have changed, nothing is known about them until the map has been checked.
  using namespace edit::waypoint_field;
  const bool places_alone =
      change.added.empty() && change.removed.empty() && !(change.fields & (kName | kYaw));
  if (places_alone) {
    for (const edit::Key& key : change.changed) waiting_.insert(waiting_.end(), key);
    return lookSoon();
  }
  for (const auto* keys : {&change.added, &change.changed}) {
    for (const edit::Key& key : *keys) {
      const map::Waypoint* const point = editing_->find(key);
      if (!point) continue;
      touched.insert(key);
      waiting_.insert(key);
    }
  }
  for (const edit::Key& key : change.removed) {
    touched.insert(key);
    of_ground_.erase(key);
    waiting_.erase(key);
  }
  if (!change.added.empty() || !change.removed.empty() || change.fields & kName) lookForNames(touched);
  std::set<std::string> other;
  for (const edit::Key& key : touched) {
    if (settle(key)) other.insert(key);
  }
  emitChanged(other);
  lookSoon();
}

void WaypointWarnings::lookForNames(std::set<std::string>& touched) {
  const edit::Items& items = editing_->document()->items();
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& [key, point] : items) names.push_back(point.name);
  const std::set<std::string> before = std::exchange(twice_, placing::namesTwice(names));
  if (before == twice_) return;
  for (const auto& [key, point] : items) {
    if (before.contains(point.name) != twice_.contains(point.name)) touched.insert(key);
  }
}

void WaypointWarnings::onPreview() {
  const WaypointPreview& preview = editing_->preview();
  if (!areSame(previewed_, preview)) {
    // Released or restored ones are checked again.
    for (edit::Key& key : std::exchange(previewed_, {})) waiting_.insert(std::move(key));
    previewed_.reserve(preview.size());
    for (const auto& [key, spot] : preview) previewed_.push_back(key);
  }
  preview_waits_ = !previewed_.empty();
  lookSoon();
}

void WaypointWarnings::lookSoon() {
  if (groups_left_ > 0 || !looking() || std::exchange(soon_, true)) return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        soon_ = false;
        look();
      },
      Qt::QueuedConnection);
}

void WaypointWarnings::look() {
  if (groups_left_ > 0 || !looking()) return;
  std::set<edit::Key> keys = std::exchange(waiting_, {});
  if (std::exchange(preview_waits_, false)) keys.insert(previewed_.begin(), previewed_.end());
  Batch batch;
  for (const edit::Key& key : keys) {
    const auto spot = editing_->spotOf(key);
    if (!spot) continue;
    batch.keys.push_back(key);
    batch.places_m.push_back(spot->position_m);
  }
  if (batch.keys.empty()) return;
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  // In groups: the threads of the pool share them, and the window is not blocked for long.
  for (const std::vector<std::size_t>& group :
       placing::groupsOf(batch.places_m, map_.reference, kMostOfGroup)) {
    auto part = std::make_shared<Batch>();
    for (const std::size_t i : group) {
      part->keys.push_back(std::move(batch.keys[i]));
      part->places_m.push_back(batch.places_m[i]);
    }
    ++groups_left_;
    share_.start(work::Urgency::Wanted,
                 [this, part, map = map_, radius = radius_m_, state = state_, cancelled = cancelled_] {
                   auto found = std::make_shared<placing::GroundWarnings>(
                       placing::groundWarnings(part->places_m, map, radius, cancelled.get()));
                   QMetaObject::invokeMethod(
                       this,
                       [this, part, found, state] {
                         if (state == state_) onGround(*part, *found);
                         if (--groups_left_ == 0) endLook();
                       },
                       Qt::QueuedConnection);
                 });
  }
}

void WaypointWarnings::onGround(const Batch& batch, const placing::GroundWarnings& found) {
  if (std::exchange(ground_, found.state) != found.state) other_ground_ = true;
  for (std::size_t i = 0; i < batch.keys.size(); ++i) {
    const edit::Key& key = batch.keys[i];
    const auto spot = editing_->spotOf(key);
    if (!spot || spot->position_m != batch.places_m[i]) continue;  // it has moved since, and is queued again
    if (!found.of[i].empty()) {
      of_ground_[key] = found.of[i];
    } else if (of_ground_.erase(key) == 0) {
      continue;  // as before
    }
    if (settle(key)) touched_.insert(key);
  }
}

void WaypointWarnings::endLook() {
  const std::set<std::string> touched = std::exchange(touched_, {});
  if (std::exchange(other_ground_, false) || !touched.empty())
    Q_EMIT changed({touched.begin(), touched.end()});
  lookSoon();
}

bool WaypointWarnings::settle(const edit::Key& key) {
  const map::Waypoint* const point = editing_->find(key);
  placing::Warnings now;
  if (point) {
    const auto ground = of_ground_.find(key);
    const bool zero_turn = point->yaw_rad == 0.0 && zero_turns_.contains(key);
    now = placing::together(ground == of_ground_.end() ? placing::Warnings{} : ground->second, point->name,
                            twice_.contains(point->name), zero_turn);
  }
  const auto before = all_.find(key);
  if (now.empty()) {
    if (before == all_.end()) return false;
    all_.erase(before);
    return true;
  }
  if (before != all_.end() && before->second == now) return false;
  all_[key] = std::move(now);
  return true;
}

void WaypointWarnings::emitChanged(const std::set<std::string>& keys) {
  if (!keys.empty()) Q_EMIT changed({keys.begin(), keys.end()});
}

}  // namespace mapwright::ui

#include "moc_waypoint_warnings.cpp"
