// Paints the rows of the inspector: badges, status and the locate button.
#pragma once

#include <QStyledItemDelegate>

namespace mapwright::window {

inline constexpr int kRowPx = 24;

class SubmapRowDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintBadges(QPainter* painter, const QStyleOptionViewItem& option, const QStringList& names) const;
  void paintStatus(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
};

}  // namespace mapwright::window
