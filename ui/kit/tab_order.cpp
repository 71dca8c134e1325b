#include "ui/kit/tab_order.h"

#include <vector>

#include <QGridLayout>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>

namespace mapwright::ui {

namespace {

void collect(QWidget* widget, std::vector<QWidget*>& stops);

void collect(QLayout* layout, std::vector<QWidget*>& stops) {
  const auto collectItem = [&](QLayoutItem* item) {
    if (!item) return;
    if (item->widget()) collect(item->widget(), stops);
    if (item->layout()) collect(item->layout(), stops);
  };
  if (auto* const grid = qobject_cast<QGridLayout*>(layout)) {
    for (int row = 0; row < grid->rowCount(); ++row) {
      for (int column = 0; column < grid->columnCount(); ++column) {
        QLayoutItem* const item = grid->itemAtPosition(row, column);
        // Which may span several cells.
        int its_row = 0, its_column = 0, rows = 0, columns = 0;
        if (item) grid->getItemPosition(grid->indexOf(item), &its_row, &its_column, &rows, &columns);
        if (its_row == row && its_column == column) collectItem(item);
      }
    }
    return;
  }
  for (int i = 0; i < layout->count(); ++i) collectItem(layout->itemAt(i));
}

void collect(QWidget* widget, std::vector<QWidget*>& stops) {
  if (widget->focusPolicy() & Qt::TabFocus) stops.push_back(widget);
  if (auto* const area = qobject_cast<QScrollArea*>(widget)) {
    if (area->widget()) collect(area->widget(), stops);
  } else if (auto* const splitter = qobject_cast<QSplitter*>(widget)) {
    for (int i = 0; i < splitter->count(); ++i) collect(splitter->widget(i), stops);
  } else if (auto* const tabs = qobject_cast<QTabWidget*>(widget)) {
    for (int i = 0; i < tabs->count(); ++i) collect(tabs->widget(i), stops);
  } else if (widget->layout()) {
    collect(widget->layout(), stops);
  }
}

}  // namespace

void orderTabsAsLaidOut(QWidget& panel) {
  std::vector<QWidget*> stops;
  collect(&panel, stops);
  for (std::size_t i = 1; i < stops.size(); ++i) QWidget::setTabOrder(stops[i - 1], stops[i]);
}

}  // namespace mapwright::ui
