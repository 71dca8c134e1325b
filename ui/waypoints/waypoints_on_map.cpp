#include "ui/waypoints/waypoints_on_map.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "map/waypoint.h"
#include "sentences/placing_sentence.h"
#include "ui/waypoints/waypoint_warnings.h"

namespace mapwright::ui {
namespace {

constexpr std::size_t kManyMoved = 500;  // with more at once the index is rebuilt

}  // namespace

WaypointsOnMap::WaypointsOnMap(WaypointEditing* editing, scene::MapScene* scene, HitList* hits,
                               QObject* parent)
    : QObject(parent), editing_(editing), scene_(scene) {
  hits->add(scene::Layer::Waypoints, &places_);
  connect(editing_, &WaypointEditing::opened, this, [this] {
    if (edit::WaypointDocument* const document = editing_->document())
      connect(document, &edit::WaypointDocument::changed, this, &WaypointsOnMap::onChanged,
              Qt::UniqueConnection);
    begin();
  });
  connect(editing_, &WaypointEditing::selectionChanged, this, &WaypointsOnMap::onSelection);
  connect(editing_, &WaypointEditing::previewChanged, this, &WaypointsOnMap::onPreview);
}

void WaypointsOnMap::setMap(const std::optional<map::MapKey>& map) {
  if (std::exchange(map_, map) != map) draw();
}

void WaypointsOnMap::setWarnings(const WaypointWarnings* warnings) {
  warnings_ = warnings;
  connect(warnings, &WaypointWarnings::changed, this, [this](const std::vector<std::string>& keys) {
    for (const edit::Key& key : keys) {
      if (const auto known = at_.find(key); known != at_.end())
        points_[known->second].warnings = sentences::sentencesOf(warnings_->of(key));
    }
    if (!keys.empty()) draw();
  });
}

void WaypointsOnMap::begin() {
  points_.clear();
  keys_.clear();
  at_.clear();
  previewed_.clear();
  selected_ = editing_->selected();
  if (const edit::WaypointDocument* const document = editing_->document()) {
    points_.reserve(document->items().size());
    for (const auto& [key, point] : document->items()) put(key);
    for (const edit::Key& key : document->unsaved()) put(key);
  }
  placeAll();
  draw();
}

void WaypointsOnMap::onChanged(const edit::DocumentChange& change) {
  if (sender() != editing_->document()) return;  // from a closed list
  if (change.everything) return begin();
  const bool many = change.added.size() + change.changed.size() + change.removed.size() > kManyMoved;
  for (const auto* keys : {&change.added, &change.changed, &change.removed}) {
    for (const edit::Key& key : *keys) {
      put(key);
      if (!many) place(key);
    }
  }
  if (many) placeAll();
  draw();
}

void WaypointsOnMap::onSelection() {
  const std::set<edit::Key>& now = editing_->selected();
  std::vector<edit::Key> other;
  std::set_symmetric_difference(selected_.begin(), selected_.end(), now.begin(), now.end(),
                                std::back_inserter(other));
  for (const edit::Key& key : other) {
    if (const auto known = at_.find(key); known != at_.end())
      points_[known->second].selected = now.contains(key);
  }
  selected_ = now;
  if (!other.empty()) draw();
}

void WaypointsOnMap::onPreview() {
  const WaypointPreview& preview = editing_->preview();
  // Consecutive steps move the same ones: only their positions change.
  if (areSame(previewed_, preview)) {
    for (const auto& [key, spot] : preview) {
      const auto known = at_.find(key);
      if (known == at_.end()) continue;
      scene::DrawnWaypoint& drawn = points_[known->second];
      // The stored position is known as long as a line leads there.
      if (!drawn.from_m || *drawn.from_m == spot.position_m) {
        put(key);
        continue;
      }
      drawn.position_m = spot.position_m;
      drawn.yaw_rad = spot.yaw_rad;
    }
    return draw();
  }
  const std::vector<edit::Key> before = std::exchange(previewed_, {});
  previewed_.reserve(preview.size());
  for (const auto& [key, spot] : preview) {
    previewed_.push_back(key);
    put(key);
  }
  for (const edit::Key& key : before) {
    if (!preview.contains(key)) put(key);
  }
  draw();
}

std::optional<scene::DrawnWaypoint> WaypointsOnMap::drawnOf(const edit::Key& key) const {
  using scene::WaypointMark;
  const edit::WaypointDocument& document = *editing_->document();
  const map::Waypoint* const point = document.find(key);
  const map::Waypoint* const kept = document.findKept(key);
  const edit::ItemState state = document.state(key);
  const WaypointMark mark = state.changed_elsewhere ? WaypointMark::Conflict
                            : state.sent            ? WaypointMark::Sent
                            : !state.unsaved        ? WaypointMark::Saved
                            : kept                  ? WaypointMark::Unsaved
                                                    : WaypointMark::New;
  if (!point && (!kept || !state.unsaved)) return std::nullopt;
  scene::DrawnWaypoint drawn = scene::drawnFrom(point ? *point : *kept);
  drawn.mark = mark;
  // Still stored: it is removed by saving.
  if (!point && !state.changed_elsewhere && !state.sent) drawn.mark = WaypointMark::Deleted;
  if (const auto moving = editing_->preview().find(key); moving != editing_->preview().end()) {
    drawn.position_m = moving->second.position_m;
    drawn.yaw_rad = moving->second.yaw_rad;
  }
  drawn.selected = selected_.contains(key);
  if (warnings_) drawn.warnings = sentences::sentencesOf(warnings_->of(key));
  if (kept && !map::samePlace(kept->position_m, drawn.position_m)) drawn.from_m = kept->position_m;
  return drawn;
}

void WaypointsOnMap::place(const edit::Key& key) {
  if (const map::Waypoint* const point = editing_->find(key)) {
    places_.put(key, point->position_m);
  } else {
    places_.remove(key);
  }
}

void WaypointsOnMap::placeAll() {
  std::vector<std::pair<std::string, Eigen::Vector2d>> points;
  if (const edit::WaypointDocument* const document = editing_->document()) {
    points.reserve(document->items().size());
    for (const auto& [key, point] : document->items()) points.emplace_back(key, point.position_m);
  }
  places_.reset(points);
}

void WaypointsOnMap::put(const edit::Key& key) {
  std::optional<scene::DrawnWaypoint> drawn = drawnOf(key);
  const auto known = at_.find(key);
  if (known != at_.end() && drawn) {
    points_[known->second] = std::move(*drawn);
  } else if (known != at_.end()) {
    const std::size_t hole = known->second;
    at_.erase(known);
    if (hole + 1 != points_.size()) {
      points_[hole] = std::move(points_.back());
      keys_[hole] = std::move(keys_.back());
      at_[keys_[hole]] = hole;
    }
    points_.pop_back();
    keys_.pop_back();
  } else if (drawn) {
    at_[key] = points_.size();
    keys_.push_back(key);
    points_.push_back(std::move(*drawn));
  }
}

void WaypointsOnMap::draw() {
  const edit::WaypointDocument* const document = editing_->document();
  if (!document || !map_) return scene_->setWaypoints(std::nullopt);
  scene::DrawnWaypoints drawn{*map_, {}};
  drawn.points.reserve(points_.size() + document->conflicts().size());
  drawn.points = points_;
  // The version of others is shown next to mine.
  for (const auto& [key, conflict] : document->conflicts()) {
    if (!conflict.theirs) continue;
    scene::DrawnWaypoint theirs = scene::drawnFrom(*conflict.theirs);
    theirs.mark = scene::WaypointMark::Theirs;
    if (const map::Waypoint* const mine = document->find(key)) theirs.from_m = mine->position_m;
    drawn.points.push_back(std::move(theirs));
  }
  scene_->setWaypoints(std::move(drawn));
}

}  // namespace mapwright::ui

#include "moc_waypoints_on_map.cpp"
