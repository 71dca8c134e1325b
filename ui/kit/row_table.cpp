#include "ui/kit/row_table.h"

#include <QHeaderView>
#include <QTableView>

#include "ui/kit/tree_view.h"

namespace mapwright::window {

void showRows(QTableView& table, QAbstractItemModel* model, const QString& name, int row_px) {
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

}  // namespace mapwright::window
