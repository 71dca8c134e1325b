#include "ui/slam/submap_filter_model.h"

namespace mapwright::window {

SubmapFilterModel::SubmapFilterModel(SubmapTreeModel* tree, QObject* parent)
    : QSortFilterProxyModel(parent), tree_(tree) {
  setRecursiveFilteringEnabled(true);
  setSourceModel(tree);
}

void SubmapFilterModel::setFilter(const SubmapFilter& filter) {
  if (filter == filter_) return;
  filter_ = filter;
  invalidateFilter();
}

bool SubmapFilterModel::filterAcceptsRow(int source_row, const QModelIndex& source_parent) const {
  if (filter_.empty() || !source_parent.isValid()) return true;  // "All" is always there
  const auto facts = tree_->facts(tree_->index(source_row, 0, source_parent));
  return facts && filter_.matches(*facts);  // groups are only kept for their content
}

}  // namespace mapwright::window

#include "moc_submap_filter_model.cpp"
