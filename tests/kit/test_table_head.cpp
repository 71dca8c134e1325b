// The head of a table whose columns can be sorted.
#include <QStandardItemModel>
#include <QStyleOptionHeader>
#include <QTableView>
#include <QTest>

#include "test_program.h"
#include "ui/kit/tree_view.h"

namespace test_table_head {

using namespace mapwright;

namespace {

class Head : public ui::TableHead {
 public:
  using TableHead::TableHead;
  /// From the edge at the right to what is written.
  int roomAtTheRight(int section) const {
    QStyleOptionHeader option;
    initStyleOption(&option);
    initStyleOptionForIndex(&option, section);
    const QString title = option.text.trimmed();
    return fontMetrics().horizontalAdvance(option.text) - fontMetrics().horizontalAdvance(title);
  }
};

}  // namespace

class TestTableHead : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theArrowDoesNotLieOnTheTitle() {
    QStandardItemModel model(3, 2);
    model.setHorizontalHeaderLabels({QStringLiteral("Name"), QStringLiteral("Off (m)")});
    model.horizontalHeaderItem(1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    QTableView table;
    auto* const head = new Head(&table);
    table.setHorizontalHeader(head);
    table.setModel(&model);
    head->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table.setSortingEnabled(true);
    table.sortByColumn(0, Qt::AscendingOrder);
    QCOMPARE(head->roomAtTheRight(0), 0);
    QCOMPARE(head->roomAtTheRight(1), 0);  // above the numbers
    table.sortByColumn(1, Qt::AscendingOrder);
    QVERIFY(head->roomAtTheRight(1) >= 10);
    QVERIFY(head->sectionsClickable());
  }
};

}  // namespace test_table_head

MAPWRIGHT_TEST(test_table_head, TestTableHead, Widgets)
#include "test_table_head.moc"
