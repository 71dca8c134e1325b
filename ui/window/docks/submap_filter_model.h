// The tree of submaps, reduced to what the filter lets through (with the groups above it).
#pragma once

#include <QSortFilterProxyModel>

#include "window/docks/submap_tree_model.h"

namespace mapwright::window {

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

}  // namespace mapwright::window
