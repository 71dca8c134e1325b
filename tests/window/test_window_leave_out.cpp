// "Leave out…": what is offered where, what is asked, and what is said of the new file.
#include <QAbstractButton>
#include <QButtonGroup>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTreeView>
#include <QtTest>

#include "../pbstream/state_bytes.h"
#include "robot/pbstream/state_robot.h"
#include "test_program.h"
#include "ui/layers/fold_header.h"
#include "ui/layers/layer_row.h"
#include "ui/layers/layers_dock.h"
#include "ui/robot/robot_dock.h"
#include "ui/slam/closures_dock.h"
#include "ui/slam/leave_out_controller.h"
#include "ui/view/map_view.h"
#include "window_bench.h"

namespace test_window_leave_out {

using namespace mapwright;
using namespace mapwright::ui;
using pbstream::tests::Folder;

namespace {

std::vector<LeaveOutChoice> choices() {
  return {{QStringLiteral("A closure"), {}, QStringLiteral("closure"), {{}, {}, {{{0, 0}, {0, 3}}}}},
          {QStringLiteral("A submap"), {}, QStringLiteral("submap"), {{}, {{0, 0}}, {}}},
          {QStringLiteral("A trajectory"), {}, QStringLiteral("trajectory"), {{0}, {}, {}}}};
}

/// The dialog alone, on a file.
struct Asking {
  explicit Asking(const std::string& bytes = pbstream::tests::wholeFile())
      : from(QString::fromStdString(folder.write(bytes))),
        dialog(from, choices(), QFileInfo(from).absolutePath(), std::make_shared<work::Workers>()) {
    dialog.show();
  }
  void write() { QTest::mouseClick(dialog.writeButton(), Qt::LeftButton); }
  bool ended() {
    return QTest::qWaitFor([this] { return dialog.pathEdit()->isEnabled(); }, 30'000);
  }
  tl::expected<pbstream::StateFile, Fault> made() const {
    return pbstream::readStateFile(dialog.pathEdit()->text().toStdString());
  }
  Folder folder;
  QString from;
  LeaveOutDialog dialog;
};

/// The menu that `opens` pops up: its entry, as it is then.
struct Seen {
  bool there = false, enabled = false;
  QString text, tip;
};
Seen entryOf(const std::function<void()>& opens, bool triggers = false) {
  Seen seen;
  QTimer looks;
  QObject::connect(&looks, &QTimer::timeout, &looks, [&] {
    auto* const menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) return;
    if (auto* const entry = menu->findChild<QAction*>(QStringLiteral("leaveOut"))) {
      seen = {true, entry->isEnabled(), entry->text(), entry->toolTip()};
      if (triggers && seen.enabled) {
        looks.stop();  // it may show a dialog
        menu->setActiveAction(entry);
        return QTest::keyClick(menu, Qt::Key_Return);
      }
    }
    menu->close();
  });
  looks.start(0);
  opens();
  return seen;
}

/// What a right click does, after its press.
void openMenu(QAbstractItemView& view, const QModelIndex& row) {
  const QPoint at = view.visualRect(row).center();
  QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, at);
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, view.viewport()->mapToGlobal(at));
  QApplication::sendEvent(view.viewport(), &event);
}

/// A window on a state file.
struct FileDesk {
  FileDesk()
      : path(QString::fromStdString(folder.write(pbstream::tests::wholeFile()))),
        settings(QString::fromStdString(folder.path("s.ini")), QSettings::IniFormat) {
    MainWindow::Dependencies wanted{
        [](const QString& address,
           const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          robot::pbstream::StateOptions options;
          options.path = address.mid(int(qstrlen("file:")));
          return std::unique_ptr<robot::Robot>(
              std::make_unique<robot::pbstream::StateRobot>(address, options));
        },
        settings};
    wanted.addresses = test::knownAddresses();
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(1366, 768);
    window->show();
    (void)QTest::qWaitForWindowActive(window.get());
    if (window->connectTo(QStringLiteral("file:") + path)) qFatal("not opened");
    (void)QTest::qWaitFor([this] { return window->session()->counts().shown == 3; }, 30'000);
  }
  InspectorDock& inspector() {
    auto* const dock = part<InspectorDock>(*window);
    dock->show();
    dock->raise();
    dock->tree()->expandAll();
    return *dock;
  }
  LeaveOutDialog* dialog() { return part<LeaveOutController>(*window)->dialog(); }
  QStringList offered() {
    QStringList texts;
    for (const QAbstractButton* button : dialog()->choices()->buttons()) texts << button->text();
    return texts;
  }

  Folder folder;
  QString path;
  QSettings settings;
  std::unique_ptr<MainWindow> window;
};

}  // namespace

class TestWindowLeaveOut : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aStateFileIsNotTakenForARobot() {
    FileDesk desk;
    using ui::scene::Layer;
    auto& layers = *part<LayersDock>(*desk.window);
    for (const Layer of_robots : {Layer::Robot, Layer::Footprint, Layer::Trail, Layer::Track, Layer::Cloud,
                                  Layer::Path, Layer::NearbyRobots, Layer::WholeMap, Layer::Overlays})
      QVERIFY2(!layers.row(of_robots)->unavailable().isEmpty(), qPrintable(ui::scene::layerName(of_robots)));
    for (const Layer of_file :
         {Layer::Submaps, Layer::Trajectory, Layer::Closures, Layer::Landmarks, Layer::Outlines, Layer::Grid})
      QVERIFY2(layers.row(of_file)->unavailable().isEmpty(), qPrintable(ui::scene::layerName(of_file)));
    QVERIFY(layers.unavailableHeader()->text().contains(QStringLiteral("this file has no data for")));
    for (const ui::scene::LegendSection& section : desk.window->mapScene()->legend(1))
      QVERIFY2(section.title != ui::scene::layerTitle(Layer::Robot), qPrintable(section.title));
    QAction* const follow = desk.window->actionList().find(QLatin1String("follow"));
    follow->trigger();
    QVERIFY(!follow->isChecked() && !part<MapView>(*desk.window)->following());
    part<RobotDock>(*desk.window)->show();
    part<RobotDock>(*desk.window)->raise();
    QTRY_VERIFY(part<RobotDock>(*desk.window)->limitsShown().contains(QStringLiteral("there is no robot")));
  }

  void aClosureGoesIntoANewFileThatIsOfferedToBeOpened() {
    Asking asking;
    QVERIFY(asking.dialog.noteText().contains(QStringLiteral("No pose changes: Cartographer optimises")));
    QVERIFY(asking.dialog.pathEdit()->text().endsWith(QStringLiteral("map-without-closure.pbstream")));
    const auto before = *pbstream::readStateFile(asking.from.toStdString());
    asking.write();
    QTRY_VERIFY(asking.dialog.openButton()->isVisible());
    const QString said = asking.dialog.saidText();
    QVERIFY2(said.contains(QStringLiteral("INTER constraints 1")), qPrintable(said));
    QVERIFY(said.contains(QStringLiteral("read again and compared")));
    QVERIFY(said.contains(QStringLiteral("No pose has changed")));
    const auto made = asking.made();
    QVERIFY(made);
    QCOMPARE(made->graph->constraints.size(), before.graph->constraints.size() - 1);
    QVERIFY(made->graph->submaps == before.graph->submaps);
    QSignalSpy opened(&asking.dialog, &LeaveOutDialog::openWanted);
    QTest::keyClick(&asking.dialog, Qt::Key_Return);
    QCOMPARE(opened.size(), 1);
    QCOMPARE(opened.front().front().toString(), asking.dialog.pathEdit()->text());
  }

  void theProposedNameFollowsTheChoiceUntilOneIsTyped() {
    Asking asking;
    const auto choose = [&](int id) { asking.dialog.choices()->button(id)->click(); };
    choose(1);
    QVERIFY(asking.dialog.pathEdit()->text().endsWith(QStringLiteral("map-without-submap.pbstream")));
    asking.dialog.pathEdit()->selectAll();
    QTest::keyClicks(asking.dialog.pathEdit(), QString::fromStdString(asking.folder.path("mine")));
    choose(2);
    asking.write();
    QTRY_VERIFY(asking.dialog.openButton()->isVisible());
    QVERIFY(asking.dialog.pathEdit()->text().endsWith(QStringLiteral("mine.pbstream")));
    QCOMPARE(asking.made()->graph->trajectories.size(), std::size_t(1));
  }

  void nothingIsWrittenOver() {
    Asking asking;
    asking.dialog.pathEdit()->selectAll();
    QTest::keyClicks(asking.dialog.pathEdit(), asking.from);
    asking.write();
    QVERIFY(asking.ended());
    QVERIFY2(asking.dialog.saidText().contains(QStringLiteral("never written over")),
             qPrintable(asking.dialog.saidText()));
    QVERIFY(!asking.dialog.openButton()->isVisible());
    // Another name, and it goes on.
    QVERIFY(asking.dialog.pathEdit() == asking.dialog.focusWidget());
    asking.dialog.pathEdit()->selectAll();
    QTest::keyClicks(asking.dialog.pathEdit(), QString::fromStdString(asking.folder.path("other.pbstream")));
    QVERIFY(asking.dialog.saidText().isEmpty());
    asking.write();
    QTRY_VERIFY(asking.dialog.openButton()->isVisible());
  }

  void refusalsAreSaidWithTheirReason() {
    const auto said = [](const std::string& bytes, int choice) {
      Asking asking(bytes);
      asking.dialog.choices()->button(choice)->click();
      asking.write();
      return asking.ended() && !asking.made() ? asking.dialog.saidText() : QString();
    };
    const std::string whole = pbstream::tests::wholeFile();
    QVERIFY(said(whole.substr(0, whole.size() - 5), 0).contains(QStringLiteral("damaged")));
    auto graph = pbstream::tests::graphRecord();
    graph.mutable_pose_graph()->mutable_trajectory()->RemoveLast();
    graph.mutable_pose_graph()->clear_constraint();
    const std::string one = pbstream::tests::header() + pbstream::tests::record(graph) +
                            pbstream::tests::record(pbstream::tests::optionsRecord(1)) +
                            pbstream::tests::record(pbstream::tests::submapRecord(0, 0)) +
                            pbstream::tests::record(pbstream::tests::submapRecord(0, 1));
    QVERIFY(said(one, 2).contains(QStringLiteral("only trajectory")));
    QVERIFY(said(one, 0).contains(QStringLiteral("no constraint")));
  }

  void whatIsSaidOfACancelledOneIsTrue() {
    Asking asking;
    asking.write();
    QTest::mouseClick(asking.dialog.cancelButton(), Qt::LeftButton);
    QTRY_VERIFY(asking.dialog.openButton()->isVisible() || asking.dialog.pathEdit()->isEnabled());
    // It may have come too late.
    QCOMPARE(QFileInfo::exists(asking.dialog.pathEdit()->text()), asking.dialog.openButton()->isVisible());
    QVERIFY(asking.dialog.openButton()->isVisible() ||
            asking.dialog.saidText().contains(QStringLiteral("Nothing was written")));
  }

  void anOpenFileOffersItForSubmapsAndTrajectories() {
    FileDesk desk;
    InspectorDock& dock = desk.inspector();
    const auto row = [&](map::SubmapId id) {
      return dock.filterModel()->mapFromSource(dock.model()->indexOf(id));
    };
    QVERIFY(entryOf([&] { openMenu(*dock.tree(), row({0, 1})); }, true).enabled);
    QTRY_VERIFY(desk.dialog());
    QCOMPARE(desk.offered(), (QStringList{QStringLiteral("Submap 0-1"), QStringLiteral("Trajectory 0")}));
    QTest::keyClick(desk.dialog(), Qt::Key_Escape);
    QTRY_VERIFY(!desk.dialog());
    QVERIFY(entryOf([&] { openMenu(*dock.tree(), row({0, 1}).parent()); }, true).enabled);
    QTRY_VERIFY(desk.dialog());
    QCOMPARE(desk.offered(), QStringList(QStringLiteral("Trajectory 0")));
    // Written and opened.
    QTest::keyClick(desk.dialog(), Qt::Key_Return);
    QTRY_VERIFY(desk.dialog()->openButton()->isVisible());
    QTest::keyClick(desk.dialog(), Qt::Key_Return);
    QTRY_VERIFY(desk.window->session()->robot().address().endsWith(
        QStringLiteral("map-without-trajectory-0.pbstream")));
    QTRY_COMPARE(desk.window->session()->counts().shown, 1);
  }

  void anOpenFileOffersItForLoopClosures() {
    FileDesk desk;
    auto* const dock = part<ClosuresDock>(*desk.window);
    dock->toggleViewAction()->trigger();
    // Before the pose graph is there the rows have no ids.
    QTRY_VERIFY(dock->model()->rowCount() == 2 && dock->model()->row(0).submap);
    QVERIFY(entryOf([&] { openMenu(*dock->table(), dock->model()->index(0, 0)); }, true).enabled);
    QTRY_VERIFY(desk.dialog());
    QCOMPARE(desk.offered().size(), 3);
    QVERIFY(desk.offered().front().contains(QStringLiteral("loop closure of submap 0-")));
  }

  void whatIsNoFileSaysWhyNot() {
    test::Bench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(test::kAddress));
    bench.load();
    auto* const dock = part<InspectorDock>(*bench.window);
    const Seen seen = entryOf([&] { openMenu(*dock->tree(), bench.row({1, 0})); });
    QVERIFY(seen.there && !seen.enabled);
    QVERIFY2(seen.tip.contains(QStringLiteral("Only a Cartographer state file")), qPrintable(seen.tip));
  }
};

}  // namespace test_window_leave_out

MAPWRIGHT_TEST(test_window_leave_out, TestWindowLeaveOut, Widgets)
#include "test_window_leave_out.moc"
