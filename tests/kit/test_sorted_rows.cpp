// Sorted rows ask for what they are sorted by once, and are in order after any change.
#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <QStandardItemModel>
#include <QTest>

#include "test_program.h"
#include "ui/kit/sorted_rows.h"

namespace test_sorted_rows {

using namespace mapwright;

namespace {

class Names : public ui::SortedRows {
 public:
  mutable int asked = 0;

 private:
  SortValue sortValue(const QModelIndex& source) const override {
    ++asked;
    if (source.column() == 1) return {.number = source.data().toDouble()};
    return {.name = source.data().toString()};
  }
};

std::vector<QString> shown(const Names& names) {
  std::vector<QString> texts;
  for (int row = 0; row < names.rowCount(); ++row) texts.push_back(names.index(row, 0).data().toString());
  return texts;
}

}  // namespace

class TestSortedRows : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachRowIsAskedOnce() {
    QStandardItemModel model(5'000, 1);
    for (int row = 0; row < 5'000; ++row)
      model.setData(model.index(row, 0), QStringLiteral("Rack %1").arg(row * 7'919 % 5'000));
    Names names;
    names.setSourceModel(&model);
    names.sort(0);
    QCOMPARE(names.asked, 5'000);
    QCOMPARE(names.index(4'999, 0).data().toString(), QStringLiteral("Rack 4999"));
    names.sort(0, Qt::DescendingOrder);
    QCOMPARE(names.asked, 5'000);
    QCOMPARE(names.index(0, 0).data().toString(), QStringLiteral("Rack 4999"));
  }

  void theyAreInOrderAfterAnyChange() {
    std::mt19937 random(7);
    const auto upTo = [&](int most) { return int(random() % unsigned(most + 1)); };
    const auto name = [&] { return QStringLiteral("Rack %1").arg(upTo(1'000)); };
    QStandardItemModel model(0, 2);
    Names names;
    names.setSourceModel(&model);
    names.sort(0);
    const QCollator order = ui::nameOrder();
    for (int i = 0; i < 2'000; ++i) {
      const int rows = model.rowCount();
      const int what = upTo(9);
      if (rows == 0 || what < 4) {
        model.insertRow(upTo(rows), {new QStandardItem(name()), new QStandardItem});
      } else if (what < 6) {
        model.setData(model.index(upTo(rows - 1), 0), name());
      } else if (what < 8) {
        const int row = upTo(rows - 1);
        model.removeRows(row, std::min(rows - row, 1 + upTo(2)));
      } else {
        model.item(upTo(rows - 1))->setText(name());
      }
      const std::vector<QString> texts = shown(names);
      QCOMPARE(int(texts.size()), model.rowCount());
      QVERIFY(std::is_sorted(texts.begin(), texts.end(), order));
    }
  }

  void whatIsNoNumberComesLast() {
    QStandardItemModel model(3, 2);
    const double values[] = {std::numeric_limits<double>::quiet_NaN(), 10, 9};
    for (int row = 0; row < 3; ++row) {
      model.setData(model.index(row, 0), QString::number(row));
      model.setData(model.index(row, 1), values[row]);
    }
    Names names;
    names.setSourceModel(&model);
    names.sort(0);
    names.sort(1);
    QCOMPARE(shown(names),
             (std::vector<QString>{QStringLiteral("2"), QStringLiteral("1"), QStringLiteral("0")}));
  }
};

}  // namespace test_sorted_rows

MAPWRIGHT_TEST(test_sorted_rows, TestSortedRows, Widgets)
#include "test_sorted_rows.moc"
