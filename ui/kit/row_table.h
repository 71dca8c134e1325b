// The common look and behaviour of tables whose rows are objects.
#pragma once

#include <QString>

class QAbstractItemModel;
class QTableView;

namespace mapwright::window {

/// Selects whole rows, has no grid, Tab leaves the table. `name`: for assistive technology.
void showRows(QTableView& table, QAbstractItemModel* model, const QString& name, int row_px = 24);

}  // namespace mapwright::window
