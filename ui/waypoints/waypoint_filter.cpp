#include "ui/waypoints/waypoint_filter.h"

#include "ui/waypoints/waypoints_model.h"

namespace mapwright::window {

namespace {
constexpr std::size_t kMostSortKeys = 200'000;
}

WaypointFilter::WaypointFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  // The C locale always compares bytes.
  if (order_.locale().language() == QLocale::C)
    order_.setLocale(QLocale(QLocale::English, QLocale::UnitedStates));
  order_.setNumericMode(true);
  order_.setCaseSensitivity(Qt::CaseInsensitive);
}

void WaypointFilter::look(const QString& text) {
  if (sort_keys_.size() > kMostSortKeys) sort_keys_.clear();
  wanted_ = text.trimmed();
  invalidateFilter();
}

void WaypointFilter::lookForPending(int flags) {
  pending_ = flags;
  invalidateFilter();
}

bool WaypointFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto at = [&](int column) { return sourceModel()->index(row, column, parent); };
  if (pending_ != 0 &&
      !(at(WaypointsModel::StateColumn).data(WaypointsModel::kPendingRole).toInt() & pending_))
    return false;
  if (wanted_.isEmpty()) return true;
  for (const int column : {WaypointsModel::NameColumn, WaypointsModel::TagsColumn}) {
    if (at(column).data().toString().contains(wanted_, Qt::CaseInsensitive)) return true;
  }
  return false;
}

bool WaypointFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const QVariant one = left.data(sortRole()), other = right.data(sortRole());
  if (one.typeId() != QMetaType::QString) return QSortFilterProxyModel::lessThan(left, right);
  return sortKey(one.toString()).compare(sortKey(other.toString())) < 0;
}

const QCollatorSortKey& WaypointFilter::sortKey(const QString& text) const {
  const auto known = sort_keys_.find(text);
  return known != sort_keys_.end() ? known->second
                                   : sort_keys_.emplace(text, order_.sortKey(text)).first->second;
}

}  // namespace mapwright::window

#include "moc_waypoint_filter.cpp"
