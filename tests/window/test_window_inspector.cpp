// The inspector in the window: what is never cut, counts that agree, the frame on the map.
#include <limits>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTreeView>
#include <QtTest>

#include "render/tile_colors.h"
#include "submap/submap_store.h"
#include "test_program.h"
#include "ui/kit/status_text.h"
#include "ui/shell/window_status_bar.h"
#include "ui/slam/inspector_dock.h"
#include "ui/slam/submap_row_delegate.h"
#include "ui/view/map_view.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_inspector {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

using Ids = std::set<map::SubmapId>;

/// How many pixels of its text a cell of the tree cannot show.
int cutOff(const QTreeView& tree, const QModelIndex& index) {
  QStyleOptionViewItem option;
  option.initFrom(&tree);
  option.rect = tree.visualRect(index);
  option.features = QStyleOptionViewItem::HasDisplay | QStyleOptionViewItem::HasCheckIndicator;
  option.widget = &tree;
  option.text = index.data().toString();
  const QRect text = tree.style()->subElementRect(QStyle::SE_ItemViewItemText, &option, &tree);
  const int margin = tree.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &tree) + 1;
  return tree.fontMetrics().horizontalAdvance(option.text) - (text.width() - 2 * margin);
}

/// "3 of 5" out of the status bar's sentence.
QString countIn(const QString& sentence) { return sentence.section(QStringLiteral(" submaps"), 0, 0); }

std::vector<map::SubmapEntry> five() {
  std::vector<map::SubmapEntry> entries;
  for (int i = 0; i < 5; ++i) entries.push_back(test::entry(i / 3, i, 1, i * 6.0, 0));
  return entries;
}

}  // namespace

class TestWindowInspector : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void sharesTheWidth_data() {
    QTest::addColumn<int>("available");
    QTest::addColumn<int>("badges");
    QTest::addColumn<int>("status");
    QTest::addColumn<bool>("fits");
    QTest::newRow("room to spare") << 500 << 130 << 90 << true;
    QTest::newRow("just room") << 362 << 130 << 90 << true;
    QTest::newRow("badges give way") << 320 << 88 << 90 << true;
    QTest::newRow("then the words") << 252 << 40 << 70 << true;
    QTest::newRow("then it scrolls") << 200 << 40 << 60 << false;
  }
  void sharesTheWidth() {
    QFETCH(int, available);
    QFETCH(int, badges);
    QFETCH(int, status);
    QFETCH(bool, fits);
    const ColumnNeeds needs{120, 100, 22, 130, 40, 90, 50};
    const ColumnWidths widths = shareColumns(available, needs);
    QCOMPARE(widths.badges, badges);
    QVERIFY(widths.name >= needs.name);
    QVERIFY(widths.badges + widths.status >= needs.total);
    QCOMPARE(widths.status, status);
    QCOMPARE(widths.locate, 22);
    QCOMPARE(widths.sum() <= available, fits);
    if (fits) QCOMPARE(widths.sum(), available);
  }

  void neverCutsAnId_data() {
    QTest::addColumn<int>("trajectory");
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("version");
    QTest::addColumn<int>("width");
    QTest::newRow("usual, as wide as at first") << 0 << 592 << 70 << 0;
    QTest::newRow("long run") << 12 << 10'482 << 1'204 << 0;
    QTest::newRow("longest") << 2'147'483'647 << 2'147'483'647 << 2'147'483'647 << 0;
    QTest::newRow("narrow") << 0 << 592 << 70 << 300;
    QTest::newRow("wide") << 3 << 592 << 70 << 700;
  }
  void neverCutsAnId() {
    QFETCH(int, trajectory);
    QFETCH(int, index);
    QFETCH(int, version);
    QFETCH(int, width);
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    std::vector<map::SubmapEntry> entries;
    for (int i = 0; i < 60; ++i)  // enough for a scroll bar
      entries.push_back(test::entry(trajectory, index - i, version, i * 6.0, 0));
    bench.robot->list(entries);
    if (width > 0) window.resizeDocks({part<InspectorDock>(window)}, {width}, Qt::Horizontal);
    QTreeView* tree = part<InspectorDock>(window)->tree();
    QTRY_VERIFY(bench.row({trajectory, index}).isValid());
    QTRY_COMPARE(window.session()->counts().shown, 60);
    tree->expandAll();
    QCoreApplication::processEvents();
    for (const QModelIndex& row :
         {tree->model()->index(0, 0), tree->model()->index(0, 0, tree->model()->index(0, 0)),
          bench.row({trajectory, index}), bench.row({trajectory, index - 1})}) {
      QVERIFY2(cutOff(*tree, row) <= 0, qPrintable(row.data().toString()));
    }
    // The totals of the groups stand across the columns of badges and status.
    const int room =
        tree->columnWidth(SubmapTreeModel::BadgeColumn) + tree->columnWidth(SubmapTreeModel::StatusColumn);
    QVERIFY(room >= tree->fontMetrics().horizontalAdvance(QStringLiteral("60 of 60")));
  }

  /// The theme knows widgets by their name: one that is named too late looks like any other.
  void whatTheThemeKnowsByNameLooksSo() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->list(five());
    QTRY_COMPARE(window.session()->counts().shown, 5);
    int looked_at = 0;
    for (QWidget* const widget : window.findChildren<QWidget*>()) {
      if (widget->objectName().isEmpty() || !widget->isVisible()) continue;
      const QImage before = widget->grab().toImage();
      widget->style()->unpolish(widget);
      widget->style()->polish(widget);
      QVERIFY2(widget->grab().toImage() == before, qPrintable(widget->objectName()));
      ++looked_at;
    }
    QVERIFY(looked_at > 5);
  }

  void choosesTheColoursOfSubmaps() {
    Bench bench;
    MainWindow& window = bench.open();
    auto* const colors = window.findChild<QComboBox*>(QStringLiteral("colors"));
    QVERIFY(colors);
    QCOMPARE(colors->count(), 6);
    colors->setCurrentText(QStringLiteral("Age"));
    QCOMPARE(window.mapScene()->colorMode(), render::ColorMode::Age);
    QVERIFY(bench.action("colorsAge")->isChecked());
    bench.action("colorsTrajectory")->trigger();
    QCOMPARE(colors->currentText(), QStringLiteral("Trajectory"));
    bench.action("colorsNormal")->trigger();
    QCOMPARE(colors->currentIndex(), 0);
  }

  void makesRoomForLongTotals() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->hold = true;
    std::vector<map::SubmapEntry> entries;
    for (int i = 0; i < 10'000; ++i) entries.push_back(test::entry(0, i, 1, i, 0));
    bench.robot->list(entries);
    QTreeView* tree = part<InspectorDock>(window)->tree();
    QTRY_VERIFY(bench.row({0, 9'999}).isValid());
    const int room =
        tree->columnWidth(SubmapTreeModel::BadgeColumn) + tree->columnWidth(SubmapTreeModel::StatusColumn);
    QVERIFY(room >= tree->fontMetrics().horizontalAdvance(QStringLiteral("10,000 of 10,000")));
  }

  void countsAgreeWhereverTheyStand() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->missing = {{0, 1}};
    bench.robot->corrupt = {{0, 2}};
    bench.robot->failing = {{1, 3}};
    session::Session* session = window.session();
    const QModelIndex all = part<InspectorDock>(window)->model()->index(0, SubmapTreeModel::StatusColumn);
    int compared = 0;
    QStringList different;
    const auto compare = [&] {
      const QString tree = all.data().toString(),
                    bar = countIn(part<WindowStatusBar>(window)->loadingShown());
      ++compared;
      if (tree != bar) different << tree + QStringLiteral(" beside ") + bar;
    };
    // Connected last, so called when everyone else has taken the news.
    connect(session, &session::Session::listChanged, &window, compare);
    connect(session, &session::Session::rowsChanged, &window, compare);
    auto entries = five();
    entries.push_back(test::entry(1, 5, 1, 0, 0));
    entries.back().pose.x = std::numeric_limits<double>::quiet_NaN();
    bench.robot->list(entries);
    QTRY_COMPARE(all.data().toString(), QStringLiteral("2 of 6"));
    QTRY_COMPARE(session->counts().corrupt, 2);
    // What is done by hand changes no count before the others count too.
    part<InspectorDock>(window)->filterModel()->setData(bench.row({0, 0}), Qt::Unchecked, Qt::CheckStateRole);
    compare();
    // What is hidden is not shown, wherever it is said.
    QTRY_COMPARE(all.data().toString(), QStringLiteral("1 of 6"));
    QCOMPARE(bench.row({0, 0}, SubmapTreeModel::StatusColumn).data().toString(), QStringLiteral("hidden"));
    QVERIFY(part<WindowStatusBar>(window)->loadingShown().contains(QLatin1String("1 hidden")));
    QVERIFY(submapDetails(*session, {0, 0}).endsWith(QLatin1String("hidden")));
    bench.robot->corrupt.clear();
    for (map::SubmapEntry& entry : entries) entry.version = 2;
    bench.robot->list(entries);
    QTRY_COMPARE(all.data().toString(), QStringLiteral("2 of 6"));
    // Another slice, which none of them has.
    session->setSlice(1);
    QTRY_COMPARE(all.data().toString(), QStringLiteral("0 of 6"));
    part<InspectorDock>(window)->hide();
    session->setSlice(0);
    part<InspectorDock>(window)->show();
    compare();
    QTRY_COMPARE(all.data().toString(), QStringLiteral("2 of 6"));
    part<InspectorDock>(window)->filterModel()->setData(bench.row({0, 0}), Qt::Checked, Qt::CheckStateRole);
    QTRY_COMPARE(all.data().toString(), QStringLiteral("3 of 6"));
    QVERIFY(compared > 5);
    QVERIFY2(different.isEmpty(), qPrintable(different.join(QStringLiteral(", "))));
  }

  void framesWhatIsSelected_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<bool>("stays");
    for (const char* what : {"filtered out", "Esc in the tree", "Esc on the map", "Esc in the empty filter",
                             "click on a group", "click below the rows", "click beside it on the map",
                             "new session with the same ids", "gone from the list", "robot left"})
      QTest::newRow(what) << QString::fromLatin1(what) << false;
    for (const char* what :
         {"filter that fits", "click within it on the map", "another one goes", "new version"})
      QTest::newRow(what) << QString::fromLatin1(what) << true;
  }
  void framesWhatIsSelected() {
    QFETCH(QString, what);
    QFETCH(bool, stays);
    Bench bench;
    MainWindow& window = bench.open({1366, 1000});
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    QTreeView* tree = part<InspectorDock>(window)->tree();
    QLineEdit* filter = part<InspectorDock>(window)->filterEdit();
    tree->expandAll();
    const auto click_row = [&](const QModelIndex& row) {
      tree->scrollTo(row);
      QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(row).center());
    };
    const auto click_map = [&](const Eigen::Vector2d& world) {
      const Eigen::Vector2d at = window.mapScene()->view().pixelFromWorld(world);
      QTest::mouseClick(window.view()->viewport(), Qt::LeftButton, {}, QPoint(int(at.x()), int(at.y())));
    };
    click_row(bench.row({0, 1}));
    QCOMPARE(window.mapScene()->highlighted(), (Ids{{0, 1}}));
    window.view()->fit(window.session()->contentBounds(), false);

    if (what == QLatin1String("filtered out")) filter->setText(QStringLiteral("1-0"));
    if (what == QLatin1String("filter that fits")) filter->setText(QStringLiteral("0-1"));
    if (what == QLatin1String("Esc in the tree")) QTest::keyClick(tree, Qt::Key_Escape);
    if (what == QLatin1String("Esc on the map")) QTest::keyClick(window.view(), Qt::Key_Escape);
    if (what == QLatin1String("Esc in the empty filter")) {
      filter->setFocus();
      QTest::keyClick(filter, Qt::Key_Escape);
    }
    if (what == QLatin1String("click on a group")) click_row(bench.row({0, 1}).parent());
    if (what == QLatin1String("click below the rows"))
      QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                        tree->viewport()->rect().bottomLeft() - QPoint(-40, 4));
    // 100 cells of 5 cm run to -x and -y from its pose at 5, 0.
    if (what == QLatin1String("click beside it on the map")) click_map({20, -2});
    if (what == QLatin1String("click within it on the map")) click_map({2.5, -2.5});
    auto list =
        std::vector{test::entry(0, 0, 1, 0, 0), test::entry(0, 1, 1, 5, 0), test::entry(1, 0, 3, 40, 0)};
    if (what == QLatin1String("new session with the same ids")) bench.robot->list(list, "session-b");
    if (what == QLatin1String("gone from the list")) bench.robot->list({list[0], list[2]});
    if (what == QLatin1String("another one goes")) bench.robot->list({list[1], list[2]});
    if (what == QLatin1String("new version")) {
      list[1].version = 2;
      bench.robot->list(list);
      QTRY_COMPARE(window.session()->submaps().find({0, 1})->shown_version, 2);
    }
    if (what == QLatin1String("robot left")) window.leaveRobot();

    const Ids wanted = stays ? Ids{{0, 1}} : Ids{};
    QTRY_COMPARE(window.mapScene()->highlighted(), wanted);
    QCOMPARE(part<InspectorDock>(window)->selected().has_value(), stays);
    QCOMPARE(part<InspectorDock>(window)
                 ->findChild<QLabel*>(QStringLiteral("details"))
                 ->text()
                 .startsWith(QLatin1String("0-1 ")),
             stays);
  }

  void framesAllThatAreSelected() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    QTreeView* tree = part<InspectorDock>(window)->tree();
    tree->expandAll();
    tree->setCurrentIndex(bench.row({0, 0}));
    tree->selectionModel()->select(bench.row({1, 0}),
                                   QItemSelectionModel::Select | QItemSelectionModel::Rows);
    QCOMPARE(window.mapScene()->highlighted(), (Ids{{0, 0}, {1, 0}}));
    QCOMPARE(part<InspectorDock>(window)->findChild<QLabel*>(QStringLiteral("details"))->text(),
             QStringLiteral("2 submaps are selected."));
  }

  void escEmptiesASearchFieldFirst() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    part<InspectorDock>(window)->select({0, 1});
    QLineEdit* filter = part<InspectorDock>(window)->filterEdit();
    filter->setFocus();
    QTest::keyClicks(filter, QStringLiteral("1"));
    QTest::keyClick(filter, Qt::Key_Escape);
    QVERIFY(filter->text().isEmpty());
    QVERIFY(part<InspectorDock>(window)->selected());
    QTest::keyClick(filter, Qt::Key_Escape);
    QVERIFY(!part<InspectorDock>(window)->selected());
  }
};

}  // namespace test_window_inspector

MAPWRIGHT_TEST(test_window_inspector, TestWindowInspector, Widgets)
#include "test_window_inspector.moc"
