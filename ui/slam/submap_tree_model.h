// The submaps as a tree: All -> Trajectory N -> "#592 v70". Follows a session
// by differences: never resets while the session stays, so selection and
// expansion are stable and ten thousand rows only cost what changed.
#pragma once

#include <optional>
#include <vector>

#include <QAbstractItemModel>
#include <QPointer>
#include <QSortFilterProxyModel>

#include "session/session.h"
#include "ui/slam/submap_filter.h"

namespace mapwright::ui {

class SubmapTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { NameColumn, BadgeColumn, StatusColumn, LocateColumn, kColumns };
  enum Role {
    BadgesRole = Qt::UserRole,  // QStringList, leaves only
    StatusRole,                 // int(session::SubmapStatus), leaves only
    HiddenRole,                 // bool: hidden by the user
    TotalRole,                  // "3 of 12": how many are shown, groups only
  };

  explicit SubmapTreeModel(QObject* parent = nullptr);

  /// Not owned; null = none.
  void setSession(session::Session* session);
  /// Updates everything, as differences to the present rows.
  void sync();
  /// Updates these submaps (ascending), including new and removed ones. The
  /// cost depends on their number.
  void syncRows(const std::vector<map::SubmapId>& ids);
  /// Updates only the visibility: the check boxes follow at once, while the
  /// counts stay in step with the status bar.
  void syncVisibility();

  std::optional<SubmapFacts> facts(const QModelIndex& index) const;
  std::optional<std::int32_t> trajectory(const QModelIndex& index) const;  // only of a trajectory row
  QModelIndex indexOf(map::SubmapId id) const;
  /// Every submap at or below the index.
  std::vector<map::SubmapId> submapsBelow(const QModelIndex& index) const;
  std::vector<map::SubmapId> submapsWhere(bool SubmapFacts::*flag) const;
  /// The longest name of a leaf and of a group, with digits as zeros: width for
  /// these fits every row.
  QString widestLeaf() const { return widest_leaf_; }
  QString widestGroup() const;
  /// The longest count of a group: "10,000 of 10,000".
  QString widestTotal() const;
  /// Of the nearby or the incremental ones: checked, unchecked or partial; of
  /// no submaps: unchecked.
  Qt::CheckState visibilityWhere(bool SubmapFacts::*flag, int* count = nullptr) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  struct Branch {
    std::int32_t trajectory = 0;
    std::vector<SubmapFacts> leaves;  // by index
    int visible = 0, shown = 0;
  };
  struct Group {
    int total = 0, visible = 0;
  };
  int branchRow(std::int32_t trajectory) const;        // -1 = none
  using Rows = std::vector<std::vector<SubmapFacts>>;  // one list per trajectory, none of
                                                       // them empty
  void replaceRows(const Rows& fresh);
  void syncBranches(const Rows& fresh);
  void syncLeaves(int branch_row, const std::vector<SubmapFacts>& fresh);
  void recount();
  void count(Branch& branch, const SubmapFacts& facts, int by);
  void updateWidth(const SubmapFacts& facts);
  QVariant groupData(const QString& name, int visible, int shown, int total, int column, int role) const;
  static QString leafName(map::SubmapId id, std::int32_t version);
  static QString groupName(std::int32_t trajectory);
  static QString totalText(int shown, int total);
  QVariant leafData(const SubmapFacts& facts, int column, int role) const;
  QModelIndex allIndex() const { return createIndex(0, 0, quintptr(0)); }

  QPointer<session::Session> session_;
  std::vector<Branch> branches_;  // by trajectory
  int total_ = 0, visible_ = 0, shown_ = 0;
  Group nearby_, incremental_;
  std::int32_t longest_index_ = 0, longest_version_ = 0;
  QString widest_leaf_;
};

/// The tree, reduced to what matches the filter (with the groups above).
class SubmapFilterModel : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit SubmapFilterModel(SubmapTreeModel* tree, QObject* parent = nullptr);
  void setFilter(const SubmapFilter& filter);
  const SubmapFilter& filter() const { return filter_; }

 protected:
  bool filterAcceptsRow(int source_row, const QModelIndex& source_parent) const override;

 private:
  SubmapTreeModel* tree_;
  SubmapFilter filter_;
};

}  // namespace mapwright::ui
