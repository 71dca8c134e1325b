// The submap tree, reduced to what matches the filter (with the groups above).
#pragma once

#include <QSortFilterProxyModel>

#include "ui/slam/submap_tree_model.h"

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
