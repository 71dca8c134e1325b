// Rows in the order of numbers or names. What each is sorted by is asked for once, until the row changes: to
// sort thousands takes ten times as many comparisons. GUI thread.
#pragma once

#include <optional>
#include <vector>

#include <QCollator>
#include <QSortFilterProxyModel>
#include <QString>

#include "ui/kit/name_order.h"

namespace mapwright::ui {

class SortedRows : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void setSourceModel(QAbstractItemModel* model) override;

 protected:
  struct SortValue {
    double number = 0;  // comes first; not a number: last
    QString name = {};
  };
  /// Of a cell of the source model.
  virtual SortValue sortValue(const QModelIndex& source) const = 0;

 private:
  struct Key {
    double number;
    QCollatorSortKey name;
  };
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const final;
  const Key& key(const QModelIndex& source) const;

  QCollator order_ = nameOrder();
  mutable int column_ = -1;                       // which keys_ are of
  mutable std::vector<std::optional<Key>> keys_;  // by the rows of the source model
};

}  // namespace mapwright::ui
