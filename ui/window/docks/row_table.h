// How the tables of panels and dialogs look and are used, where a row is one thing.
#pragma once

#include <QString>

class QAbstractItemModel;
class QTableView;

namespace mapwright::window {

/// Whole rows are selected, there is no grid, Tab leaves the table. `name`: for assistive technology.
void showRows(QTableView& table, QAbstractItemModel* model, const QString& name, int row_px = 24);

}  // namespace mapwright::window
