// The lists of the docks: single letters are left to the window's shortcuts, since every list has its own
// search field, and a selected row is marked by a bar at its edge and not only by colour.
#pragma once

#include <QHeaderView>
#include <QKeyEvent>
#include <QListView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTreeView>

#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

/// The bar of a selected row, or the frame of the current one if it is not selected. `row` spans the view.
inline void paintRowState(QPainter* painter, const QRect& row, bool selected, bool current) {
  const UiColors colors = appColors();
  if (selected) painter->fillRect(QRect(row.left(), row.top(), 3, row.height()), colors.focus);
  if (!current || selected) return;
  painter->save();
  painter->setPen(colors.focus);
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(row.adjusted(0, 0, -1, -1));
  painter->restore();
}

/// A tree view that reports Enter on a row and ignores Esc.
class TreeView : public QTreeView {
  Q_OBJECT
 public:
  using QTreeView::QTreeView;

 Q_SIGNALS:
  void enterPressed();

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
      Q_EMIT enterPressed();
      event->accept();
      return;
    }
    if (event->key() == Qt::Key_Escape) {
      event->ignore();
      return;
    }
    QTreeView::keyPressEvent(event);
  }
  void keyboardSearch(const QString&) override {}
  void drawRow(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
    QTreeView::drawRow(painter, option, index);
    const QModelIndex current = currentIndex();
    paintRowState(painter, QRect(0, option.rect.top(), viewport()->width(), option.rect.height()),
                  selectionModel()->isRowSelected(index.row(), index.parent()),
                  hasFocus() && current.row() == index.row() && current.parent() == index.parent());
  }
};

/// For a list or a table.
template <typename View>
class QuietView : public View {
 public:
  using View::View;

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Escape) {
      event->ignore();
      return;
    }
    View::keyPressEvent(event);
  }
  void keyboardSearch(const QString&) override {}
};
using QuietListView = QuietView<QListView>;
using QuietTableView = QuietView<QTableView>;

/// Paints the bar of a table's row in its first column.
class TableRowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem quiet = option;
    quiet.state.setFlag(QStyle::State_HasFocus, false);  // rows are chosen, not cells
    QStyledItemDelegate::paint(painter, quiet, index);
    const auto* table = qobject_cast<const QTableView*>(option.widget);
    const bool first = table && table->horizontalHeader()->visualIndex(index.column()) == 0;
    if (first) paintRowState(painter, option.rect, option.state.testFlag(QStyle::State_Selected), false);
    // Where the keyboard is: the row has no frame of its own, each cell has a part of it.
    if (!table || !table->hasFocus() || table->currentIndex().row() != index.row()) return;
    painter->setPen(appColors().focus);
    painter->drawLine(option.rect.topLeft(), option.rect.topRight());
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
  }
};

/// The head of a table. The style paints the arrow of the sorted column at the right, over what ends there: a
/// title at the right makes room for it.
class TableHead : public QHeaderView {
 public:
  explicit TableHead(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) { setSectionsClickable(true); }

 protected:
  void initStyleOptionForIndex(QStyleOptionHeader* option, int section) const override {
    QHeaderView::initStyleOptionForIndex(option, section);
    const bool sorted = option->sortIndicator != QStyleOptionHeader::None;
    if (sorted && option->textAlignment.testFlag(Qt::AlignRight))
      option->text += QString(4, QChar(QChar::Nbsp));
  }
};

/// The common look and behaviour of tables whose rows are objects: selects whole rows, has no grid, Tab
/// leaves the table. `name`: for assistive technology.
inline void showRows(QTableView& table, QAbstractItemModel* model, const QString& name, int row_px = 24) {
  table.setHorizontalHeader(new TableHead(&table));
  table.setModel(model);
  table.setItemDelegate(new TableRowDelegate(&table));
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setShowGrid(false);
  table.setWordWrap(false);
  table.setTabKeyNavigation(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table.verticalHeader()->setDefaultSectionSize(row_px);
  table.setAccessibleName(name);
}

}  // namespace mapwright::ui
