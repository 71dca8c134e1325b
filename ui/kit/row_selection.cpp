#include "ui/kit/row_selection.h"

#include <algorithm>
#include <cstddef>

#include <QItemSelection>
#include <QTableView>

namespace mapwright::ui {

void selectRows(QTableView& table, std::vector<int> rows, int column) {
  std::sort(rows.begin(), rows.end());
  const QAbstractItemModel& model = *table.model();
  const int last_column = model.columnCount() - 1;
  // Adjacent rows become one range: a view compares ranges one by one, and thousands take seconds.
  QItemSelection selection;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t end = i + 1;
    while (end < rows.size() && rows[end] == rows[end - 1] + 1) ++end;
    selection.append(QItemSelectionRange(model.index(rows[i], 0), model.index(rows[end - 1], last_column)));
    i = end;
  }
  // Not in one step, which compares each old range with each new one: thousands of both take seconds.
  table.selectionModel()->clearSelection();
  table.selectionModel()->select(selection, QItemSelectionModel::Select);
  if (rows.empty()) return;
  const QModelIndex last = model.index(rows.back(), column);
  table.selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
  table.scrollTo(last);
}

}  // namespace mapwright::ui
