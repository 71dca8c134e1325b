// The tree of submaps: incremental, tri-state, filtered.
#include <algorithm>
#include <random>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "fake_robot.h"
#include "session/session_options.h"
#include "submap/submap_store.h"
#include "test_program.h"
#include "ui/slam/submap_tree_model.h"

namespace test_window_tree {

using namespace mapwright;
using namespace mapwright::ui;

namespace {

/// A session on a fake robot with a model that follows it.
struct Bench {
  explicit Bench(bool hold = true) {
    auto made = std::make_unique<test::FakeRobot>();
    robot = made.get();
    robot->hold = hold;
    session = std::make_unique<session::Session>(std::move(made), session::Session::Options{});
    session->open();
    model.setSession(session.get());
  }
  ~Bench() { model.setSession(nullptr); }
  void list(std::vector<map::SubmapEntry> entries) {
    say(std::move(entries));
    model.sync();
  }
  /// Long lists are looked at aside.
  void say(const std::vector<map::SubmapEntry>& entries) {
    robot->list(entries);
    const submap::SubmapStore& store = session->submaps();
    QTRY_VERIFY(store.rows().size() == entries.size() &&
                std::all_of(entries.begin(), entries.end(), [&](const map::SubmapEntry& entry) {
                  const submap::SubmapRow* row = store.find(entry.id);
                  return row && row->entry == entry;
                }));
  }
  QModelIndex all() const { return model.index(0, 0); }

  test::FakeRobot* robot;
  std::unique_ptr<session::Session> session;
  SubmapTreeModel model;
};

std::vector<map::SubmapEntry> entries(int trajectories, int each) {
  std::vector<map::SubmapEntry> made;
  for (int t = 0; t < trajectories; ++t) {
    for (int i = 0; i < each; ++i) made.push_back(test::entry(t, i, 1, i * 5.0, t * 5.0));
  }
  return made;
}

bool sameRows(const SubmapTreeModel& one, const SubmapTreeModel& other) {
  const QModelIndex all = one.index(0, 0), other_all = other.index(0, 0);
  const auto sameTotal = [](const QModelIndex& a, const QModelIndex& b) {
    return a.data(SubmapTreeModel::TotalRole) == b.data(SubmapTreeModel::TotalRole);
  };
  if (one.rowCount(all) != other.rowCount(other_all) || !sameTotal(all, other_all)) return false;
  for (int branch = 0; branch < one.rowCount(all); ++branch) {
    const QModelIndex here = one.index(branch, 0, all), there = other.index(branch, 0, other_all);
    if (one.rowCount(here) != other.rowCount(there) || !sameTotal(here, there)) return false;
    for (int row = 0; row < one.rowCount(here); ++row) {
      if (!(one.facts(one.index(row, 0, here)) == other.facts(other.index(row, 0, there)))) return false;
    }
  }
  for (const auto flag : {&SubmapFacts::nearby, &SubmapFacts::incremental}) {
    int here = 0, there = 0;
    if (one.visibilityWhere(flag, &here) != other.visibilityWhere(flag, &there) || here != there)
      return false;
  }
  return true;
}

QVariant check(const QModelIndex& index) { return index.data(Qt::CheckStateRole); }

}  // namespace

class TestWindowTree : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void standsAsGroupsAndRows() {
    Bench bench;
    bench.list({test::entry(1, 592, 70, 0, 0), test::entry(0, 3, 1, 0, 0), test::entry(1, 593, 2, 0, 0)});
    QCOMPARE(bench.model.rowCount(), 1);
    QCOMPARE(bench.all().data().toString(), QStringLiteral("All"));
    QCOMPARE(bench.model.rowCount(bench.all()), 2);
    const QModelIndex second = bench.model.index(1, 0, bench.all());
    QCOMPARE(second.data().toString(), QStringLiteral("Trajectory 1"));
    const QModelIndex leaf = bench.model.index(0, 0, second);
    QCOMPARE(leaf.data().toString(), QStringLiteral("#592 v70"));
    QCOMPARE(leaf.parent(), second);
    QCOMPARE(second.parent(), bench.all());
    QCOMPARE(bench.model.indexOf({1, 592}), leaf);
    QVERIFY(!bench.model.indexOf({5, 592}).isValid());
  }

  void keepsToTheRulesOfModels() {
    Bench bench;
    QAbstractItemModelTester tester(&bench.model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    SubmapFilterModel filtered(&bench.model);
    QAbstractItemModelTester filtered_tester(&filtered,
                                             QAbstractItemModelTester::FailureReportingMode::QtTest);
    bench.list(entries(3, 20));
    auto fewer = entries(2, 30);
    fewer.erase(fewer.begin() + 4, fewer.begin() + 9);
    bench.list(fewer);
    filtered.setFilter(SubmapFilter(QStringLiteral("1-2")));
    bench.list(entries(4, 10));
    bench.list({test::entry(7, 1, 1, 0, 0)});
    bench.list({});
    QCOMPARE(bench.model.rowCount(bench.all()), 0);
  }

  void staysIncrementalWithTenThousandRows() {
    Bench bench;
    auto list = entries(4, 2500);
    bench.list(list);
    QPersistentModelIndex held(bench.model.indexOf({2, 1234}));
    QSignalSpy reset(&bench.model, &QAbstractItemModel::modelReset);
    QSignalSpy inserted(&bench.model, &QAbstractItemModel::rowsInserted);
    QSignalSpy removed(&bench.model, &QAbstractItemModel::rowsRemoved);
    QSignalSpy changed(&bench.model, &QAbstractItemModel::dataChanged);
    bench.model.sync();
    QCOMPARE(changed.size(), 0);  // nothing happened, nothing is said

    list[5000 + 1234].version = 9;
    list.push_back(test::entry(3, 2500, 1, 0, 0));
    list.erase(list.begin());
    bench.list(list);
    QCOMPARE(reset.size(), 0);
    QCOMPARE(inserted.size(), 1);
    QCOMPARE(removed.size(), 1);
    QVERIFY2(changed.size() >= 1 && changed.size() <= 8, qPrintable(QString::number(changed.size())));
    QVERIFY(held.isValid());
    QCOMPARE(held.data().toString(), QStringLiteral("#1234 v9"));
    QCOMPARE(bench.model.rowCount(bench.model.index(0, 0, bench.all())), 2499);
  }

  /// What is told row by row comes to what a walk over all of them gives.
  void followsTouchedRows() {
    Bench bench;
    SubmapTreeModel follower;
    const QAbstractItemModelTester tester(&follower);
    follower.setSession(bench.session.get());
    QObject::connect(
        bench.session.get(), &session::Session::rowsTouched, &follower,
        [&](const session::TouchedRows& rows) { rows.all ? follower.sync() : follower.syncRows(rows.ids); });
    bench.list(entries(3, 40));
    std::mt19937 random(3);
    for (int round = 0; round < 60; ++round) {
      std::vector<map::SubmapEntry> list;
      for (map::SubmapEntry& entry : entries(3, 44)) {
        if (random() % 12 == 0 || (round % 10 == 9 && entry.id.trajectory == 1)) continue;
        if (random() % 8 == 0) entry.version = int(random() % 5) + 1;
        entry.is_frozen = random() % 9 == 0;
        entry.is_nearby = random() % 7 == 0;
        list.push_back(entry);
      }
      bench.list(list);
      bench.session->setVisible({{0, int(random() % 40)}, {2, int(random() % 40)}}, random() % 2 == 0);
      bench.model.sync();
      QTRY_VERIFY(sameRows(follower, bench.model));
    }
    follower.setSession(nullptr);
  }

  void saysNeighbouringChangesAtOnce() {
    Bench bench;
    auto list = entries(1, 1000);
    bench.list(list);
    for (int i = 100; i < 200; ++i) list[std::size_t(i)].is_frozen = true;
    QSignalSpy changed(&bench.model, &QAbstractItemModel::dataChanged);
    bench.list(list);
    int of_leaves = 0;
    for (const auto& arguments : changed) {
      const auto top = arguments[0].toModelIndex();
      if (!bench.model.facts(top)) continue;
      ++of_leaves;
      QCOMPARE(top.row(), 100);
      QCOMPARE(arguments[1].toModelIndex().row(), 199);
    }
    QCOMPARE(of_leaves, 1);
  }

  void checksThreeWays() {
    Bench bench;
    bench.list(entries(2, 3));
    const QModelIndex first = bench.model.index(0, 0, bench.all());
    const QModelIndex leaf = bench.model.index(1, 0, first);
    QCOMPARE(check(bench.all()).toInt(), int(Qt::Checked));
    QVERIFY(bench.model.setData(leaf, Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(!bench.session->submaps().find({0, 1})->visible);
    QCOMPARE(check(leaf).toInt(), int(Qt::Unchecked));
    QCOMPARE(check(first).toInt(), int(Qt::PartiallyChecked));
    QCOMPARE(check(bench.all()).toInt(), int(Qt::PartiallyChecked));
    QVERIFY(bench.model.setData(first, Qt::Unchecked, Qt::CheckStateRole));
    QCOMPARE(check(first).toInt(), int(Qt::Unchecked));
    QCOMPARE(check(bench.all()).toInt(), int(Qt::PartiallyChecked));
    QVERIFY(bench.model.setData(bench.all(), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(check(leaf).toInt(), int(Qt::Checked));
    QVERIFY(bench.session->submaps().find({1, 2})->visible);
    QVERIFY(!bench.model.setData(leaf.siblingAtColumn(1), Qt::Unchecked, Qt::CheckStateRole));
  }

  void countsGroupsByFlag() {
    Bench bench;
    auto list = entries(1, 4);
    list[1].is_nearby = list[2].is_nearby = true;
    bench.list(list);
    bench.session->setVisible({{0, 1}}, false);
    bench.model.sync();
    int count = 0;
    QCOMPARE(bench.model.visibilityWhere(&SubmapFacts::nearby, &count), Qt::PartiallyChecked);
    QCOMPARE(count, 2);
    QCOMPARE(bench.model.submapsWhere(&SubmapFacts::nearby).size(), std::size_t(2));
  }

  void filtersLeavesAndKeepsTheirGroups() {
    Bench bench;
    SubmapFilterModel filtered(&bench.model);
    bench.list(entries(3, 10));
    filtered.setFilter(SubmapFilter(QStringLiteral("1-3")));
    const QModelIndex all = filtered.index(0, 0);
    QCOMPARE(filtered.rowCount(all), 1);
    const QModelIndex group = filtered.index(0, 0, all);
    QCOMPARE(group.data().toString(), QStringLiteral("Trajectory 1"));
    QCOMPARE(filtered.rowCount(group), 1);
    QCOMPARE(filtered.index(0, 0, group).data().toString(), QStringLiteral("#3 v1"));
    filtered.setFilter(SubmapFilter(QStringLiteral("frozen")));
    QCOMPARE(filtered.rowCount(all), 0);
    // A row that comes to fit appears by itself.
    auto list = entries(3, 10);
    list[4].is_frozen = true;
    bench.list(list);
    QCOMPARE(filtered.rowCount(all), 1);
    filtered.setFilter({});
    QCOMPARE(filtered.rowCount(all), 3);
  }

  void showsHowEachOneStands() {
    Bench bench(false);
    bench.robot->missing = {{0, 1}};
    bench.robot->failing = {{0, 2}};
    bench.robot->corrupt = {{0, 3}};
    bench.list(entries(1, 4));
    const auto word = [&](int row) {
      bench.model.sync();
      return bench.model.indexOf({0, row}).siblingAtColumn(SubmapTreeModel::StatusColumn).data().toString();
    };
    QTRY_COMPARE(word(0), QStringLiteral("shown"));
    QTRY_COMPARE(word(1), QStringLiteral("missing"));
    QTRY_COMPARE(word(2), QStringLiteral("failed"));
    QTRY_COMPARE(word(3), QStringLiteral("corrupt"));
    const QString tip = bench.model.indexOf({0, 2}).data(Qt::ToolTipRole).toString();
    QVERIFY(tip.contains(QLatin1String("&lt;b&gt;500")));  // what a robot says is never markup
    QVERIFY(!tip.contains(QLatin1String("<b>")));
  }

  void forgetsTheSessionThatGoes() {
    Bench bench;
    bench.list(entries(1, 4));
    bench.model.setSession(nullptr);
    QCOMPARE(bench.model.rowCount(bench.all()), 0);
    QVERIFY(!bench.model.setData(bench.all(), Qt::Checked, Qt::CheckStateRole));
  }
};

}  // namespace test_window_tree

MAPWRIGHT_TEST(test_window_tree, TestWindowTree, Widgets)
#include "test_window_tree.moc"
