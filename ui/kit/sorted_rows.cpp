#include "ui/kit/sorted_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mapwright::ui {

void SortedRows::setSourceModel(QAbstractItemModel* model) {
  if (sourceModel()) sourceModel()->disconnect(this);
  keys_.clear();
  if (model) {
    // Before the base class hears of it, and sorts.
    const auto forget = [this] { keys_.clear(); };
    connect(model, &QAbstractItemModel::modelReset, this, forget);
    connect(model, &QAbstractItemModel::rowsInserted, this, forget);
    connect(model, &QAbstractItemModel::rowsRemoved, this, forget);
    connect(model, &QAbstractItemModel::rowsMoved, this, forget);
    connect(model, &QAbstractItemModel::layoutChanged, this, forget);
    connect(model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex& first, const QModelIndex& last) {
              const std::size_t end = std::min(keys_.size(), std::size_t(last.row() + 1));
              for (std::size_t row = std::size_t(first.row()); row < end; ++row) keys_[row].reset();
            });
  }
  QSortFilterProxyModel::setSourceModel(model);
}

const SortedRows::Key& SortedRows::key(const QModelIndex& source) const {
  if (std::exchange(column_, source.column()) != source.column()) keys_.clear();
  const auto row = std::size_t(source.row());
  if (keys_.size() <= row) keys_.resize(std::size_t(sourceModel()->rowCount()));
  std::optional<Key>& known = keys_[row];
  if (!known) {
    const SortValue value = sortValue(source);
    known.emplace(Key{std::isnan(value.number) ? std::numeric_limits<double>::infinity() : value.number,
                      order_.sortKey(value.name)});
  }
  return *known;
}

bool SortedRows::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const Key& one = key(left);
  const Key& other = key(right);
  return one.number != other.number ? one.number < other.number : one.name.compare(other.name) < 0;
}

}  // namespace mapwright::ui
