#include "ui/waypoints/waypoint_editing.h"

#include <algorithm>

#include <QUuid>

#include "exchange/waypoint_plan.h"
#include "exchange/waypoint_table.h"
#include "ui/kit/name_order.h"
#include "ui/waypoints/decimal_place.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::ui {
namespace {

/// What a command is about: the name of the only waypoint, as it was, or how many there are.
QString calledOf(const std::vector<edit::Change>& changes) {
  if (changes.size() != 1) return waypointsText(qsizetype(changes.size()));
  const edit::Change& one = changes.front();
  return shortWaypointName(one.before ? *one.before : *one.after);
}

}  // namespace

void WaypointEditing::setDocument(edit::WaypointDocument* document, const QString& unavailable_reason,
                                  const robot::KeptFields& keeps) {
  if (document_) document_->disconnect(this);
  document_ = document;
  unavailable_reason_ = unavailable_reason;
  keeps_ = keeps;
  selected_.clear();
  since_.clear();
  preview_.clear();
  if (document_) {
    connect(document_, &edit::WaypointDocument::changed, this, &WaypointEditing::onChange);
    connect(document_, &edit::WaypointDocument::removalLeftOut, this, [this] {
      Q_EMIT removalRefused(
          tr("It is stored on the robot, so it was not undone. %1").arg(exchange::notRemovedReason(keeps_)));
    });
  }
  Q_EMIT opened();
  Q_EMIT selectionChanged();
}

void WaypointEditing::onChange(const edit::DocumentChange& change) {
  // Removed ones are neither selected nor dragged.
  if (change.removed.empty() && !change.everything) return;
  std::set<edit::Key> left = selected_;
  std::erase_if(left, [this](const edit::Key& key) { return !find(key); });
  std::erase_if(preview_, [&](const auto& one) { return !find(one.first); });
  if (change.everything || left != selected_) select(std::move(left));
}

void WaypointEditing::select(std::set<edit::Key> keys) {
  if (keys == selected_) return;
  selected_ = std::move(keys);
  ++selections_;
  std::map<edit::Key, std::uint64_t> since;
  for (const edit::Key& key : selected_) {
    const auto before = since_.find(key);
    since.emplace_hint(since.end(), key, before == since_.end() ? selections_ : before->second);
  }
  since_ = std::move(since);
  Q_EMIT selectionChanged();
}

std::vector<edit::Key> WaypointEditing::inOrder() const {
  const QCollator by_name = nameOrder();
  struct Row {
    std::uint64_t since;
    QCollatorSortKey name;
    const edit::Key* key;
  };
  std::vector<Row> rows;
  for (const auto& [key, since] : since_) {
    if (const map::Waypoint* const point = find(key))
      rows.push_back({since, by_name.sortKey(QString::fromStdString(point->name)), &key});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.since != b.since ? a.since < b.since : a.name < b.name;
  });
  std::vector<edit::Key> keys;
  for (const Row& row : rows) keys.push_back(*row.key);
  return keys;
}

void WaypointEditing::toggle(const edit::Key& key) {
  std::set<edit::Key> keys = selected_;
  if (keys.erase(key) == 0) keys.insert(key);
  select(std::move(keys));
}

void WaypointEditing::selectAll() { selectAllBut({}); }
void WaypointEditing::invertSelection() { selectAllBut(selected_); }

void WaypointEditing::selectAllBut(const std::set<edit::Key>& others) {
  std::set<edit::Key> keys;
  if (document_) {
    for (const auto& [key, point] : document_->items()) {
      if (!others.contains(key)) keys.insert(keys.end(), key);
    }
  }
  select(std::move(keys));
}

std::set<std::string> WaypointEditing::names() const {
  std::set<std::string> names;
  if (document_) {
    for (const auto& [key, point] : document_->items()) names.insert(point.name);
  }
  return names;
}

edit::Key WaypointEditing::add(const Eigen::Vector2d& world_m, edit::Gesture gesture) {
  map::Waypoint point;
  point.position_m = decimalPlace(world_m);
  const auto keys = addAll({point}, tr("add %1"), gesture);
  return keys.empty() ? edit::Key() : *keys.begin();
}

std::set<edit::Key> WaypointEditing::addAll(std::vector<map::Waypoint> points, const QString& what,
                                            edit::Gesture gesture) {
  const bool all_finite = std::all_of(
      points.begin(), points.end(), [](const map::Waypoint& point) { return point.position_m.allFinite(); });
  if (!editable() || points.empty() || !all_finite) return {};
  std::set<std::string> taken = names();
  std::set<edit::Key> keys;
  std::vector<edit::Change> changes;
  std::size_t number = 0;
  for (map::Waypoint& point : points) {
    point.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    while (point.name.empty()) {
      const std::string name = exchange::madeUpName(++number);
      if (taken.insert(name).second) point.name = name;
    }
    keys.insert(point.id);
    changes.push_back(document_->to(point.id, point));
  }
  const QString called = calledOf(changes);
  document_->change(std::move(changes), what.arg(called), gesture);
  select(keys);
  return keys;
}

void WaypointEditing::rename(const edit::Key& key, const QString& name, edit::Gesture gesture) {
  const map::Waypoint* const now = find(key);
  if (!now || name.trimmed().isEmpty()) return;
  map::Waypoint to = *now;
  to.name = name.trimmed().toStdString();
  set(key, to, tr("rename %1").arg(shortWaypointName(*now)), gesture);
}

void WaypointEditing::renameAll(const std::vector<std::pair<edit::Key, QString>>& names) {
  std::vector<edit::Change> changes;
  for (const auto& [key, name] : names) {
    const map::Waypoint* const now = find(key);
    if (!now || name.trimmed().isEmpty()) continue;
    map::Waypoint to = *now;
    to.name = name.trimmed().toStdString();
    changes.push_back(document_->to(key, std::move(to)));
  }
  if (!editable() || changes.empty()) return;
  const QString called = calledOf(changes);
  document_->change(std::move(changes), tr("rename %1").arg(called));
}

void WaypointEditing::set(const edit::Key& key, const map::Waypoint& to, const QString& what,
                          edit::Gesture gesture) {
  if (editable() && find(key)) document_->change({document_->to(key, to)}, what, gesture);
}

QString WaypointEditing::notRemovedReason() const {
  if (!editable()) return unavailable_reason_;
  // A new one is only taken back.
  const bool stored = std::any_of(selected_.begin(), selected_.end(),
                                  [this](const edit::Key& key) { return document_->findKept(key); });
  return stored ? exchange::notRemovedReason(keeps_) : QString();
}

void WaypointEditing::removeSelected() {
  if (!editable() || selected_.empty()) return;
  if (const QString why = notRemovedReason(); !why.isEmpty()) return Q_EMIT removalRefused(why);
  std::vector<edit::Change> changes;
  for (const edit::Key& key : selected_) changes.push_back(document_->to(key, std::nullopt));
  const QString called = calledOf(changes);
  document_->change(std::move(changes), tr("delete %1").arg(called));
}

void WaypointEditing::changeSelected(const QString& what, const std::function<void(map::Waypoint&)>& change,
                                     edit::Gesture gesture) {
  if (!editable() || selected_.empty()) return;
  std::vector<edit::Change> changes;
  for (const edit::Key& key : selected_) {
    map::Waypoint to = *find(key);
    change(to);
    changes.push_back(document_->to(key, std::move(to)));
  }
  const QString called = calledOf(changes);
  document_->change(std::move(changes), what.arg(called), gesture);
}

void WaypointEditing::restore(const std::vector<edit::Key>& keys) {
  std::vector<edit::Change> changes;
  for (const edit::Key& key : keys) {
    const map::Waypoint* const kept = editable() && !find(key) ? document_->findKept(key) : nullptr;
    if (kept) changes.push_back(document_->to(key, *kept));
  }
  if (!changes.empty()) make(std::move(changes), tr("restore %1"));
}

void WaypointEditing::make(std::vector<edit::Change> changes, const QString& what) {
  if (!editable() || changes.empty()) return;
  std::set<edit::Key> there;
  for (const auto& change : changes) {
    if (change.after) there.insert(change.key);
  }
  const bool one_is_there = changes.size() == 1 && changes.front().after;
  const QString called = one_is_there ? shortWaypointName(*changes.front().after) : calledOf(changes);
  document_->change(std::move(changes), what.arg(called));
  select(std::move(there));
}

void WaypointEditing::moveSelected(const Eigen::Vector2d& by_m, edit::Gesture gesture) {
  changeSelected(
      tr("move %1"),
      [&](map::Waypoint& to) { to.position_m = decimalPlace(to.position_m + by_m, to.position_m); }, gesture);
}

std::optional<placing::Spot> WaypointEditing::spotOf(const edit::Key& key) const {
  const map::Waypoint* const point = find(key);
  if (!point) return std::nullopt;
  const auto moving = preview_.find(key);
  return moving == preview_.end() ? placing::Spot{point->position_m, point->yaw_rad} : moving->second;
}

std::vector<placing::Spot> WaypointEditing::spots(const std::vector<edit::Key>& keys) const {
  std::vector<placing::Spot> spots;
  spots.reserve(keys.size());
  for (const edit::Key& key : keys) {
    const map::Waypoint& point = *find(key);
    spots.push_back({point.position_m, point.yaw_rad});
  }
  return spots;
}

void WaypointEditing::setPreview(WaypointPreview preview) {
  if (preview.empty() && preview_.empty()) return;
  preview_ = std::move(preview);
  Q_EMIT previewChanged();
}

void WaypointEditing::applyPreview(const QString& what) {
  const WaypointPreview preview = std::exchange(preview_, {});
  apply(preview, what);
  Q_EMIT previewChanged();
}

void WaypointEditing::apply(const WaypointPreview& to, const QString& what, edit::Gesture gesture) {
  if (!editable()) return;
  std::vector<edit::Change> changes;
  changes.reserve(to.size());
  for (const auto& [key, spot] : to) {
    const map::Waypoint* const now = find(key);
    if (!now) continue;
    changes.push_back({key, *now, *now});
    changes.back().after->position_m = decimalPlace(spot.position_m, now->position_m);
    changes.back().after->yaw_rad = spot.yaw_rad;
  }
  document_->change(std::move(changes), what, gesture);
}

bool areSame(const std::vector<edit::Key>& keys, const WaypointPreview& preview) {
  return std::equal(keys.begin(), keys.end(), preview.begin(), preview.end(),
                    [](const edit::Key& key, const auto& moved) { return key == moved.first; });
}

}  // namespace mapwright::ui

#include "moc_waypoint_editing.cpp"
