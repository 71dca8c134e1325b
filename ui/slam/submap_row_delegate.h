// Paints the rows of the inspector: badges, status and the locate button.
#pragma once

#include <QStyledItemDelegate>

#include "ui/slam/submap_columns.h"

class QTreeView;

namespace mapwright::window {

class SubmapTreeModel;

inline constexpr int kRowPx = 24;

/// The widths that the columns need so that nothing important is truncated, in the font of the tree.
ColumnNeeds columnNeeds(const QTreeView& tree, const SubmapTreeModel& model);

class SubmapRowDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintBadges(QPainter* painter, const QStyleOptionViewItem& option, const QStringList& names) const;
  void paintStatus(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintTotal(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
};

}  // namespace mapwright::window
