#include "window/waypoints/waypoint_editing.h"

#include <algorithm>
#include <utility>

#include <QUuid>

#include "window/waypoints/waypoint_text.h"

namespace mapwright::window {

void WaypointEditing::setDocument(edit::WaypointDocument* document, const QString& why_not) {
  if (document_) document_->disconnect(this);
  document_ = document;
  why_not_ = why_not;
  selected_.clear();
  preview_.clear();
  if (document_) connect(document_, &edit::DocumentEvents::changed, this, &WaypointEditing::takeChange);
  Q_EMIT opened();
  Q_EMIT selectionChanged();
}

void WaypointEditing::takeChange(const edit::DocumentChange& change) {
  // What is gone is neither selected nor in the hand.
  std::set<edit::Key> left;
  for (const edit::Key& key : selected_) {
    if (find(key)) left.insert(key);
  }
  std::erase_if(preview_, [&](const auto& one) { return !find(one.first); });
  if (change.everything || left != selected_) select(std::move(left));
}

void WaypointEditing::select(std::set<edit::Key> keys) {
  if (keys == selected_) return;
  selected_ = std::move(keys);
  Q_EMIT selectionChanged();
}

void WaypointEditing::toggle(const edit::Key& key) {
  std::set<edit::Key> keys = selected_;
  if (keys.erase(key) == 0) keys.insert(key);
  select(std::move(keys));
}

edit::Key WaypointEditing::add(const Eigen::Vector2d& world_m, edit::Gesture gesture) {
  if (!editable() || !world_m.allFinite()) return {};
  std::set<std::string> names;
  for (const auto& [key, point] : document_->items()) names.insert(point.name);
  QString name;
  for (std::size_t number = 1; name.isEmpty() || names.contains(name.toStdString()); ++number)
    name = tr("Waypoint %1").arg(number);
  map::Waypoint point;
  point.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  point.name = name.toStdString();
  point.position_m = world_m;
  const edit::Key key = point.id;
  document_->change({document_->to(key, point)}, tr("add %1").arg(shortWaypointName(point)), gesture);
  select({key});
  return key;
}

void WaypointEditing::rename(const edit::Key& key, const QString& name, edit::Gesture gesture) {
  const map::Waypoint* const now = find(key);
  if (!now || name.trimmed().isEmpty()) return;
  map::Waypoint to = *now;
  to.name = name.trimmed().toStdString();
  set(key, to, tr("rename %1").arg(shortWaypointName(*now)), gesture);
}

void WaypointEditing::set(const edit::Key& key, const map::Waypoint& to, const QString& what,
                          edit::Gesture gesture) {
  if (editable() && find(key)) document_->change({document_->to(key, to)}, what, gesture);
}

void WaypointEditing::removeSelected() {
  if (!editable() || selected_.empty()) return;
  std::vector<edit::Change<map::Waypoint>> changes;
  for (const edit::Key& key : selected_) changes.push_back(document_->to(key, std::nullopt));
  const QString what = tr("delete %1").arg(called(selected_));
  document_->change(std::move(changes), what);
}

void WaypointEditing::moveSelected(const Eigen::Vector2d& by_m, edit::Gesture gesture) {
  if (!editable() || selected_.empty()) return;
  std::vector<edit::Change<map::Waypoint>> changes;
  for (const edit::Key& key : selected_) {
    map::Waypoint to = *find(key);
    to.position_m += by_m;
    changes.push_back(document_->to(key, to));
  }
  document_->change(std::move(changes), tr("move %1").arg(called(selected_)), gesture);
}

void WaypointEditing::setPreview(WaypointPreview preview) {
  if (preview.empty() && preview_.empty()) return;
  preview_ = std::move(preview);
  Q_EMIT previewChanged();
}

void WaypointEditing::applyPreview(const QString& what) {
  const WaypointPreview preview = std::exchange(preview_, {});
  std::vector<edit::Change<map::Waypoint>> changes;
  if (editable()) {
    for (const auto& [key, to] : preview) {
      if (find(key)) changes.push_back(document_->to(key, to));
    }
    document_->change(std::move(changes), what);
  }
  Q_EMIT previewChanged();
}

QString WaypointEditing::called(const std::set<edit::Key>& keys) const {
  if (keys.size() == 1 && find(*keys.begin())) return shortWaypointName(*find(*keys.begin()));
  return waypointsText(qsizetype(keys.size()));
}

}  // namespace mapwright::window
