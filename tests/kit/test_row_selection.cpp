// What a table shows as selected: few ranges, however many rows there are.
#include <algorithm>
#include <vector>

#include <QItemSelectionModel>
#include <QStandardItemModel>
#include <QTableView>
#include <QTest>

#include "test_program.h"
#include "ui/kit/row_selection.h"

namespace test_row_selection {

using namespace mapwright;

class TestRowSelection : public QObject {
  Q_OBJECT
 private:
  QStandardItemModel model_{1'000, 3};

 private Q_SLOTS:
  void adjacentRowsAreOneRange() {
    QTableView table;
    table.setModel(&model_);
    std::vector<int> rows;
    for (int row = 900; row >= 100; --row) {
      if (row != 500) rows.push_back(row);
    }
    ui::selectRows(table, rows, 1);
    const QItemSelectionModel& selected = *table.selectionModel();
    QCOMPARE(selected.selection().size(), 2);
    QCOMPARE(selected.selectedRows().size(), 800);
    QVERIFY(!selected.isRowSelected(500));
    QCOMPARE(selected.currentIndex(), model_.index(900, 1));
  }

  void whatWasSelectedBeforeIsNoLonger() {
    QTableView table;
    table.setModel(&model_);
    ui::selectRows(table, {1, 2}, 0);
    ui::selectRows(table, {7}, 0);
    QCOMPARE(table.selectionModel()->selectedRows(), QModelIndexList{model_.index(7, 0)});
    ui::selectRows(table, {}, 0);
    QVERIFY(!table.selectionModel()->hasSelection());
  }

  // Qt compares each range that was selected with each that is.
  void scatteredRowsAreNotComparedWithThoseBefore() {
    QTableView table;
    table.setModel(&model_);
    std::vector<int> even, odd;
    for (int row = 0; row < 1'000; row += 2) {
      even.push_back(row);
      odd.push_back(row + 1);
    }
    ui::selectRows(table, even, 0);
    qsizetype most = 0;
    connect(table.selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [&](const QItemSelection& now, const QItemSelection& before) {
              most = std::max(most, now.size() * before.size());
            });
    ui::selectRows(table, odd, 0);
    QCOMPARE(table.selectionModel()->selectedRows().size(), 500);
    QVERIFY(table.selectionModel()->isRowSelected(1));
    QCOMPARE(most, 0);
  }
};

}  // namespace test_row_selection

MAPWRIGHT_TEST(test_row_selection, TestRowSelection, Widgets)
#include "test_row_selection.moc"
