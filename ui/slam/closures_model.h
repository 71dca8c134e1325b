// Constraints of the pose graph as a table, the largest residual first; or one row for each submap, that with
// most constraints that contradict the map first.
#pragma once

#include <optional>
#include <vector>

#include <QAbstractTableModel>

#include "map/closures.h"

namespace mapwright::ui {

/// From here on a constraint contradicts the map, as the layer colours it.
inline constexpr double kContradictsMapM = 0.5;

/// A constraint as far as the robot says: of the residuals of a mapping robot only the lines are known.
struct ClosureRow {
  double residual_m = 0;
  std::optional<double> residual_rad = {};
  std::optional<map::SubmapId> submap = {};
  std::optional<map::NodeId> node = {};
  map::ConstraintKind kind = map::ConstraintKind::Inter;
  std::optional<double> stamp_s = {};
  Eigen::Vector2d at{0, 0}, expected{0, 0};  // world, see map::Closure
};

/// Which rows are listed.
struct ClosureFilter {
  bool inter = true, intra = false;
  double least_m = 0;
  QString text = {};  // a whole name, as 0-12, of the submap or the node; otherwise the beginning of one
  std::optional<map::SubmapId> submap = {};  // only this one's
  bool by_submap = false;
  bool operator==(const ClosureFilter&) const = default;
  bool lists(const ClosureRow& row) const;
  /// All loop closures, and nothing else, are listed, maybe by submap.
  bool listsLoopClosures() const;
};

class ClosuresModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { ResidualColumn, TurnColumn, SubmapColumn, NodeColumn, TimeColumn, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  /// Behind the name of the column that the list is ordered by: the arrow is drawn over what stands there.
  static QString roomForArrow() { return QString(5, QChar(0xa0)); }

  /// Largest residual first.
  void setRows(std::vector<ClosureRow> rows);
  void setFilter(ClosureFilter filter);
  const ClosureFilter& filter() const { return filter_; }
  const std::vector<ClosureRow>& all() const { return rows_; }
  /// Whether the robot says which submaps and nodes it ties together.
  bool namesSubmaps() const;
  /// Of the table; of a submap its worst.
  const ClosureRow& row(int row) const { return rows_[listed_[std::size_t(row)].row]; }
  /// Where it is listed, or its submap is; -1 = nowhere.
  int rowOf(const ClosureRow& closure) const;

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(listed_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// -1: the worst first.
  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

 private:
  struct Listed {
    std::size_t row = 0;
    int of_submap = 0, contradict = 0;  // how many constraints the row stands for, and those over the limit
  };
  void list();
  void arrange();

  std::vector<ClosureRow> rows_;
  std::vector<Listed> listed_;
  ClosureFilter filter_;
  int sort_column_ = -1;
  Qt::SortOrder sort_order_ = Qt::AscendingOrder;
};

}  // namespace mapwright::ui
