// The rows of the waypoint list, which follow a document change by change, and which of them are shown in
// which order. Those that I deleted stay as rows until that is saved.
#pragma once

#include <unordered_map>
#include <vector>

#include <QAbstractTableModel>
#include <QPointer>

#include "edit/document.h"
#include "placing/warnings.h"
#include "ui/kit/sorted_rows.h"

namespace mapwright::ui {

class WaypointWarnings;

class WaypointsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { StateColumn, NameColumn, XColumn, YColumn, YawColumn, TagsColumn, kColumns };
  /// What rows are sorted by.
  static constexpr int kSortRole = Qt::UserRole + 1;
  /// Flags of Pending.
  static constexpr int kPendingRole = Qt::UserRole + 2;

  using QAbstractTableModel::QAbstractTableModel;
  /// null = none.
  void setDocument(edit::WaypointDocument* document);
  /// Must outlive this.
  void setWarnings(const WaypointWarnings* warnings);

  edit::Key key(const QModelIndex& index) const;  // empty = none
  QModelIndex indexOf(const edit::Key& key, int column = NameColumn) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void onChanged(const edit::DocumentChange& change);
  void begin();
  bool belongs(const edit::Key& key) const;
  /// As it is, or as it is kept when I deleted it; null = neither.
  const map::Waypoint* point(const edit::Key& key) const;
  int pending(const edit::Key& key) const;
  void number(std::size_t from);
  const placing::Warnings& warningsOf(const edit::Key& key) const;
  QVariant text(const map::Waypoint& point, int column) const;
  QVariant sortValue(const edit::Key& key, const map::Waypoint& point, int column) const;

  QPointer<edit::WaypointDocument> document_;
  const WaypointWarnings* warnings_ = nullptr;
  std::vector<edit::Key> rows_;
  std::unordered_map<edit::Key, int> row_of_;
};

/// By name or tag, and by what is pending; "Rack 2" stands before "Rack 10".
class WaypointFilter : public SortedRows {
  Q_OBJECT
 public:
  explicit WaypointFilter(QObject* parent = nullptr);
  /// Those with this in their name or tags; empty = all.
  void look(const QString& text);
  /// Those of which any of these (Pending) is so; 0 = all.
  void lookForPending(int flags);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  SortValue sortValue(const QModelIndex& source) const override;

 private:
  QString wanted_;
  int pending_ = 0;
};

}  // namespace mapwright::ui
