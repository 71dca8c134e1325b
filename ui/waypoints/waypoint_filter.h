// Which rows of the waypoint list are shown, and in which order: by name or tag, by what is pending; "Rack 2"
// stands before "Rack 10".
#pragma once

#include <unordered_map>

#include <QCollator>
#include <QSortFilterProxyModel>

namespace mapwright::window {

class WaypointFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit WaypointFilter(QObject* parent = nullptr);
  /// Those with this in their name or tags; empty = all.
  void look(const QString& text);
  /// Those of which any of these (Pending) is so; 0 = all.
  void lookForPending(int flags);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  /// What a text is ordered by; made once of each, since thousands of rows are compared often.
  const QCollatorSortKey& sortKey(const QString& text) const;

  QString wanted_;
  int pending_ = 0;
  QCollator order_;
  mutable std::unordered_map<QString, QCollatorSortKey> sort_keys_;
};

}  // namespace mapwright::window
