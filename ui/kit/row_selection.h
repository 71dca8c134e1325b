// The rows that a table shows as selected.
#pragma once

#include <vector>

class QTableView;

namespace mapwright::ui {

/// Selects these rows (in any order) and no others. The cell of the last one in `column` becomes the current
/// one and is scrolled to.
void selectRows(QTableView& table, std::vector<int> rows, int column);

}  // namespace mapwright::ui
