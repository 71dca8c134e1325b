// Paints a row of the catalogue: thumbnail, name, badges and details.
#pragma once

#include <QStyledItemDelegate>

namespace mapwright::window {

class MapRowDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintSection(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintThumbnail(QPainter* painter, const QRect& box, const QModelIndex& index) const;
};

}  // namespace mapwright::window
