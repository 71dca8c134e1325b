// Paints the rows of the inspector: badges, status and the locate button; and
// how wide the columns are.
#pragma once

#include <QStyledItemDelegate>

class QTreeView;

namespace mapwright::ui {

class SubmapTreeModel;

/// Widths in pixels. `name` and `total` are never truncated: `total` ("244 of
/// 300") is shown on a group's row across the two columns after the name.
struct ColumnNeeds {
  int name = 0, total = 0, locate = 0;
  int badges_wanted = 0, badges_least = 0;
  int status_wanted = 0, status_least = 0;
};

struct ColumnWidths {
  int name = 0, badges = 0, status = 0, locate = 0;
  int sum() const { return name + badges + status + locate; }
  bool operator==(const ColumnWidths&) const = default;
};

/// If there is not enough room, the badges are reduced first, then the status;
/// if that is not enough the tree scrolls beyond `available`. Extra room goes
/// to the name.
ColumnWidths shareColumns(int available, const ColumnNeeds& needs);

/// The widths that the columns need so that nothing important is truncated, in
/// the font of the tree.
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

}  // namespace mapwright::ui
