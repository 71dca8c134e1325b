// A recorded way on the map on screen: what it crosses is drawn and listed.
#include <QDoubleSpinBox>
#include <QFile>
#include <QStandardItemModel>
#include <QTableView>
#include <QtTest>

#include "grids/grid_pyramid.h"
#include "reference_bench.h"
#include "test_program.h"
#include "text_bag.h"
#include "ui/kit/theme.h"
#include "ui/replay/recordings_dock.h"
#include "ui/replay/rehearsal_controller.h"
#include "ui/replay/rehearsal_dock.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_view.h"

namespace test_window_rehearsal {

using namespace mapwright;
using namespace mapwright::ui;
using carry::Crossing;
using test::FakeRobot;
using test::Site;

namespace {

/// A recording as a robot with one bag.
struct OneBag : test::TextBag {
  robot::Call list(robot::OutcomeTo<std::vector<robot::BagEntry>> reply) override {
    robot::BagEntry row;
    row.key = {robot::BagKind::File, "run.mcap"};
    QMetaObject::invokeMethod(
        this, [row, reply] { reply(std::vector<robot::BagEntry>{row}); }, Qt::QueuedConnection);
    return {};
  }
  robot::Call messages(const robot::BagKey& key, const robot::BagRange& range,
                       robot::OutcomeTo<robot::BagChunkPtr> reply) override {
    if (!silent) return TextBag::messages(key, range, std::move(reply));
    ++asked;
    return {};
  }
  bool silent = false;
};

struct RehearsalBench : test::ReferenceBench {
  RehearsalBench() {
    also = [this](FakeRobot& made) {
      if (made.address().endsWith(QLatin1String("run.mcap"))) made.bags = bag;
      if (of_robot && made.address() == test::kAddress) made.bags = &one;
    };
  }
  ~RehearsalBench() { window.reset(); }  // before the bag that it reads
  /// The hall has a new rack.
  void openHall() {
    Site now = Site::rooms();
    now.wall(200, 110, 220, 130);
    openOn(now, Site::rooms().turned());
  }
  RehearsalController& rehearsal() { return *part<RehearsalController>(*window); }
  RehearsalDock& way_dock() { return *part<RehearsalDock>(*window); }
  /// Through the hall, where the rack is now; as the old map has it, or the one on screen.
  QString wayFile(bool on_old) {
    QByteArray text = "stamp_s,x_m,y_m\n";
    for (int i = 0; i <= 60; ++i) {
      const double x = 7 + i * 0.1, y = 6;
      text += QByteArray::number(1'717'405'200 + i * 0.2, 'f', 3) + ',' +
              QByteArray::number(on_old ? 12 - y : x) + ',' + QByteArray::number(on_old ? x : y) + '\n';
    }
    return put("way.csv", text);
  }
  QString put(const char* name, const QByteArray& bytes) {
    QFile file(folder.filePath(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("not written");
    return file.fileName();
  }
  /// What is on screen, with the rack painted over.
  std::shared_ptr<const grids::GridPyramid> withoutRack() {
    const auto now = window->session()->wholeMap().cells();
    const auto builder = grids::buildGrid(now->width(), now->height(), now->code(), now->reduction());
    for (int row = 0; row < now->height(); ++row) {
      std::vector<std::uint8_t> cells;
      for (int column = 0; column < now->width(); ++column) {
        const bool rack = column >= 200 && column < 220 && row >= 110 && row < 130;
        cells.push_back(rack ? now->at(195, row) : now->at(column, row));
      }
      builder->pushRow(cells);
    }
    builder->finish();
    return builder->pyramid();
  }
  QString meets(int row) { return way_dock().table()->model()->index(row, 0).data().toString(); }
  const robot::BagKey key{robot::BagKind::File, "run.mcap"};
  bool of_robot = false;  // it has `one`
  OneBag one;
  OneBag* bag = nullptr;  // null: the file is no recording
  void waitForWay() { QTRY_VERIFY_WITH_TIMEOUT(!rehearsal().shown().empty(), 60'000); }
};

}  // namespace

class TestWindowRehearsal : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aWayOfTheOldMapIsDrawnWhereItLiesNow() {
    RehearsalBench bench;
    bench.openHall();
    bench.align();
    bench.rehearsal().rehearse(bench.wayFile(true));
    bench.waitForWay();
    QVERIFY(bench.way_dock().isVisible());
    const auto& shown = bench.rehearsal().shown();
    QCOMPARE(shown.size(), 3U);
    QCOMPARE(shown[0].what, Crossing::Free);
    QCOMPARE(shown[1].what, Crossing::Obstacle);
    QCOMPARE(shown[2].what, Crossing::Free);
    QCOMPARE(bench.way_dock().table()->model()->rowCount(), 1);
    QCOMPARE(bench.meets(0), QStringLiteral("in an obstacle"));
    for (const char* part : {"way.csv: 6.0 m. Not free: ", "as the reference map lies"})
      QVERIFY2(bench.way_dock().said().contains(QLatin1String(part)), qPrintable(bench.way_dock().said()));

    QTableView* const table = bench.way_dock().table();
    const auto sample = [&] {
      return table->model()->index(0, 0).data(Qt::DecorationRole).value<QIcon>().pixmap(16, 16).toImage();
    };
    applyTheme(*qApp, ThemeChoice::Light);
    const QImage light = sample();
    applyTheme(*qApp, ThemeChoice::Dark);
    QVERIFY(sample() != light);
    applyTheme(*qApp, ThemeChoice::System);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                      table->visualRect(table->model()->index(0, 0)).center());
    const auto& marker = bench.window->mapScene()->marker();
    QVERIFY(marker && (*marker - Eigen::Vector2d(10.5, 6)).norm() < 0.1);
  }

  void withoutAReferenceMapItLiesAsRecorded() {
    RehearsalBench bench;
    bench.openHall();
    bench.reference()->removeMap();
    bench.rehearsal().rehearse(bench.wayFile(false));
    bench.waitForWay();
    QCOMPARE(bench.meets(0), QStringLiteral("in an obstacle"));
    QVERIFY(bench.way_dock().said().contains(QLatin1String("as it was recorded")));
  }

  void theSameMapReadAgainLeavesItAndAnotherOneTakesItOff() {
    RehearsalBench bench;
    bench.openHall();
    bench.reference()->removeMap();
    const session::MapSlot& whole = bench.window->session()->wholeMap();
    const auto read_again = [&] {
      const auto before = whole.cells();
      bench.window->session()->openMap({map::MapKind::Stored, "1"});
      QTRY_VERIFY(whole.cells() && whole.cells() != before && whole.settled());
    };
    bench.robot->maps.pictures["1"].fingerprint = "as it is";
    read_again();
    bench.rehearsal().rehearse(bench.wayFile(false));
    bench.waitForWay();
    read_again();
    QVERIFY(!bench.rehearsal().shown().empty());
    bench.robot->maps.pictures["1"].fingerprint = "otherwise";
    read_again();
    QVERIFY(bench.rehearsal().shown().empty());
    QVERIFY(bench.way_dock().said().contains(QLatin1String("Press Again")));
  }

  void aReferenceMapThatMovesTakesItOffAndAgainBringsItBack() {
    RehearsalBench bench;
    bench.openHall();
    bench.rehearsal().rehearse(bench.wayFile(true));
    bench.waitForWay();
    bench.align();
    QTRY_VERIFY(bench.rehearsal().shown().empty());
    QVERIFY2(bench.way_dock().said().contains(QLatin1String("Press Again")),
             qPrintable(bench.way_dock().said()));
    QTest::mouseClick(bench.way_dock().againButton(), Qt::LeftButton);
    bench.waitForWay();
    QCOMPARE(bench.meets(0), QStringLiteral("in an obstacle"));
    QTest::mouseClick(bench.way_dock().removeButton(), Qt::LeftButton);
    QVERIFY(bench.rehearsal().shown().empty());
    QVERIFY(!bench.way_dock().againButton()->isEnabled());
  }

  void aRecordingIsReadToItsEnd() {
    RehearsalBench bench;
    bench.bag = &bench.one;
    for (int i = 0; i <= 60; ++i)
      bench.one.add(1'717'405'200 + i * 0.2, map::TrackedPose{{7 + i * 0.1, 6, 0}});
    bench.openHall();
    bench.reference()->removeMap();
    bench.rehearsal().rehearse(bench.folder.filePath(QStringLiteral("run.mcap")));
    bench.waitForWay();
    QCOMPARE(bench.meets(0), QStringLiteral("in an obstacle"));
    QVERIFY2(bench.way_dock().said().startsWith(QLatin1String("run.mcap: 6.0 m. Not free: ")),
             qPrintable(bench.way_dock().said()));
    // Another way while one is being read: only the last one counts.
    bench.rehearsal().rehearse(bench.folder.filePath(QStringLiteral("run.mcap")));
    QVERIFY(bench.rehearsal().shown().empty());
    bench.rehearsal().rehearse(bench.wayFile(false));
    bench.waitForWay();
    QVERIFY(bench.way_dock().said().startsWith(QLatin1String("way.csv: ")));
  }

  /// Both maps have the same coordinates, and both parts lie on free ground.
  void ofARecordingOnTwoMapsThePartOfThisMapIsRehearsed() {
    RehearsalBench bench;
    bench.bag = &bench.one;
    for (const auto& [map, y_m] : {std::pair(0, 4.0), {1, 8.0}}) {
      map::MapInfo info;
      info.name = "Hall", info.uid = map == 0 ? "u-other" : "u-site";
      bench.one.add(1'717'405'200 + map * 50, info);
      for (int i = 1; i <= 40 - 10 * map; ++i)
        bench.one.add(1'717'405'200 + map * 50 + i * 0.2, map::TrackedPose{{7 + i * 0.1, y_m, 0}});
    }
    bench.openHall();
    bench.reference()->removeMap();
    bench.robot->maps.entries[0].uid = "u-site";
    bench.window->session()->catalogue().refresh();
    QTRY_VERIFY(bench.window->session()->catalogue().find({map::MapKind::Stored, "1"})->uid == "u-site");
    bench.rehearsal().rehearse(bench.folder.filePath(QStringLiteral("run.mcap")));
    bench.waitForWay();
    const QString said = bench.way_dock().said();
    QVERIFY2(said.startsWith(QLatin1String("run.mcap: 2.9 m")), qPrintable(said));
    QVERIFY2(said.contains(QLatin1String("Driven on another map, not rehearsed: 3.9 m.")), qPrintable(said));
    QVERIFY2(!said.contains(QLatin1String("not known: the part")), qPrintable(said));
  }

  void aRecordingWithoutAnEndIsSaid() {
    RehearsalBench bench;
    bench.bag = &bench.one;
    bench.one.interrupted = true;
    for (int i = 0; i <= 5; ++i)
      bench.one.add(1'717'405'200 + i * 0.2, map::TrackedPose{{7 + i * 0.1, 6, 0}});
    bench.openHall();
    bench.rehearsal().rehearse(bench.folder.filePath(QStringLiteral("run.mcap")));
    bench.waitForWay();
    QVERIFY2(bench.way_dock().said().contains(QLatin1String("Its end is missing")),
             qPrintable(bench.way_dock().said()));
  }

  void aRecordingOfTheRobotIsRead() {
    RehearsalBench bench;
    for (int i = 0; i <= 60; ++i)
      bench.one.add(1'717'405'200 + i * 0.2, map::TrackedPose{{7 + i * 0.1, 6, 0}});
    bench.of_robot = true;
    bench.openHall();
    bench.reference()->removeMap();
    QTest::mouseClick(bench.way_dock().recordingsButton(), Qt::LeftButton);
    auto& list = *part<RecordingsDock>(*bench.window);
    QVERIFY(list.isVisible());
    QTRY_COMPARE(list.model()->rowCount(), 1);
    list.select(bench.key);
    QTest::mouseClick(list.rehearseButton(), Qt::LeftButton);
    QVERIFY(bench.way_dock().cancelButton()->isVisibleTo(&bench.way_dock()));
    bench.waitForWay();
    QCOMPARE(bench.meets(0), QStringLiteral("in an obstacle"));
    QVERIFY2(bench.way_dock().said().startsWith(QLatin1String("run.mcap: 6.0 m. Not free: ")),
             qPrintable(bench.way_dock().said()));
    QVERIFY(!bench.way_dock().cancelButton()->isVisibleTo(&bench.way_dock()));
  }

  void whatIsBeingReadCanBeCancelled() {
    RehearsalBench bench;
    for (int i = 0; i <= 60; ++i)
      bench.one.add(1'717'405'200 + i * 0.2, map::TrackedPose{{7 + i * 0.1, 6, 0}});
    bench.of_robot = true;
    bench.openHall();
    bench.reference()->removeMap();
    bench.one.silent = true;
    bench.rehearsal().rehearseBag(bench.key);
    QTRY_VERIFY(bench.one.asked > 0);
    QTest::mouseClick(bench.way_dock().cancelButton(), Qt::LeftButton);
    QCOMPARE(bench.way_dock().said(), QStringLiteral("Cancelled. Press Again."));
    QVERIFY(!bench.way_dock().cancelButton()->isVisibleTo(&bench.way_dock()));
    bench.one.silent = false;
    QTest::mouseClick(bench.way_dock().againButton(), Qt::LeftButton);
    bench.waitForWay();
  }

  void withoutRecordingsOfTheRobotItIsSaidWhy() {
    RehearsalBench bench;
    bench.openHall();
    QVERIFY(!bench.way_dock().recordingsButton()->isEnabled());
    QVERIFY(!bench.way_dock().recordingsButton()->toolTip().isEmpty());
  }

  void anotherRadiusCountsAtOnce() {
    RehearsalBench bench;
    bench.openHall();
    bench.reference()->removeMap();
    // 0.5 m beside the rack: free for the usual radius.
    QByteArray text = "stamp_s,x_m,y_m\n";
    for (int i = 0; i <= 60; ++i)
      text += QByteArray::number(i * 0.2, 'f', 3) + ',' + QByteArray::number(7 + i * 0.1) + ",7.0\n";
    bench.rehearsal().rehearse(bench.put("beside.csv", text));
    bench.waitForWay();
    QCOMPARE(bench.way_dock().table()->model()->rowCount(), 0);
    bench.way_dock().radiusBox()->setValue(0.8);
    QTRY_VERIFY(bench.way_dock().table()->model()->rowCount() > 0);
    QCOMPARE(bench.meets(0), QStringLiteral("too close to a wall"));
    bench.way_dock().radiusBox()->setValue(0);  // the robot's own
    QTRY_COMPARE(bench.way_dock().table()->model()->rowCount(), 0);
    map::RobotModel wide;
    for (const auto& [x, y] : {std::pair(0.8, 0.8), {-0.8, 0.8}, {-0.8, -0.8}, {0.8, -0.8}})
      wide.footprint.emplace_back(x, y);
    bench.robot->say(wide);
    QTRY_VERIFY(bench.way_dock().table()->model()->rowCount() > 0);
  }

  void brushStrokesLeaveItAndSayThatItIsOfTheMapBefore() {
    RehearsalBench bench;
    bench.openHall();
    bench.reference()->removeMap();
    bench.rehearsal().rehearse(bench.wayFile(false));
    bench.waitForWay();
    const QString before = bench.way_dock().said();
    // What the picture editor does: the rack is gone.
    bench.window->mapScene()->setEditedCells({map::MapKind::Stored, "1"}, bench.withoutRack());
    for (int stroke = 0; stroke < 2; ++stroke) bench.window->mapScene()->editedCellsChanged({9, 5, 12, 7});
    QCOMPARE(bench.way_dock().said(),
             QStringLiteral("The map on screen has changed since then. As it was: ") + before);
    QVERIFY(!bench.rehearsal().shown().empty());
    QTest::mouseClick(bench.way_dock().againButton(), Qt::LeftButton);
    bench.waitForWay();
    QCOMPARE(bench.way_dock().table()->model()->rowCount(), 0);
    QVERIFY2(bench.way_dock().said().contains(QLatin1String("all free")),
             qPrintable(bench.way_dock().said()));
  }

  void whatIsNoWayIsSaid() {
    RehearsalBench bench;
    bench.openHall();
    const auto said = [&](const QString& path, const char* part) {
      bench.rehearsal().rehearse(path);
      QTRY_VERIFY2(bench.way_dock().said().contains(QLatin1String(part)),
                   qPrintable(bench.way_dock().said()));
      QVERIFY(bench.rehearsal().shown().empty());
    };
    said(bench.put("other.csv", "Hello\n"), "This is no track.");
    said(bench.put("none.csv", "stamp_s,x_m,y_m\n1,nan,2\n"), "It has no position of the robot.");
    said(bench.folder.filePath(QStringLiteral("missing.csv")), "No such file");
    said(bench.put("run.mcap", "nothing"), "This is no recording.");
  }

  void whatWasShownStaysWhereTheNextOneFails() {
    RehearsalBench bench;
    bench.openHall();
    bench.reference()->removeMap();
    const auto fails = [&](const QString& path) {
      bench.rehearsal().rehearse(path);
      QTRY_VERIFY2(bench.way_dock().said().contains(QLatin1String("Still shown: way.csv: 6.0 m.")),
                   qPrintable(bench.way_dock().said()));
      QCOMPARE(bench.rehearsal().shown().size(), 3U);
      QCOMPARE(bench.way_dock().table()->model()->rowCount(), 1);
    };
    bench.rehearsal().rehearse(bench.wayFile(false));
    bench.waitForWay();
    fails(bench.put("other.csv", "Hello\n"));
    QVERIFY2(bench.way_dock().said().startsWith(QLatin1String("other.csv: This is no track.")),
             qPrintable(bench.way_dock().said()));
    fails(bench.put("run.mcap", "nothing"));
    fails(bench.put("none.csv", "stamp_s,x_m,y_m\n1,nan,2\n"));
    // It is that one which is read again, and which another radius is for.
    QTest::mouseClick(bench.way_dock().againButton(), Qt::LeftButton);
    QTRY_VERIFY2(bench.way_dock().said().startsWith(QLatin1String("way.csv: 6.0 m.")),
                 qPrintable(bench.way_dock().said()));
    QFile::remove(bench.folder.filePath(QStringLiteral("way.csv")));
    fails(bench.folder.filePath(QStringLiteral("way.csv")));
    // Elsewhere it does not hold.
    bench.lay();
    bench.dock()->xBox()->setValue(1);
    QTRY_VERIFY(bench.rehearsal().shown().empty());
    bench.rehearsal().rehearse(bench.put("other.csv", "Hello\n"));
    QTRY_VERIFY(bench.way_dock().said().startsWith(QLatin1String("This is no track.")));
    QVERIFY(bench.rehearsal().shown().empty());
  }

  /// Dashes of one would fill the gaps of the other.
  void dashesOfAWayThatComesByAgainStayDashes() {
    RehearsalBench bench;
    bench.openHall();
    bench.reference()->removeMap();
    bench.way_dock().radiusBox()->setValue(0.8);
    QByteArray text = "stamp_s,x_m,y_m\n";
    for (int lap = 0; lap < 4; ++lap) {
      for (int i = 0; i <= 20; ++i)
        text += QByteArray::number(lap * 20 + i * 0.5, 'f', 3) + ',' +
                QByteArray::number(lap % 2 == 0 ? 10 + i * 0.05 : 11.013 - i * 0.05) + ",7.0\n";
    }
    bench.rehearsal().rehearse(bench.put("laps.csv", text));
    bench.waitForWay();
    QCOMPARE(bench.meets(0), QStringLiteral("too close to a wall"));
    geometry::ViewTransform view = bench.window->mapScene()->view();
    view.center_m = {10.5, 7};
    view.scale_m_per_px = 0.005;
    bench.window->view()->moveTo(view, false);
    const QColor dash = bench.window->mapScene()->theme().warn;
    const auto share = [&] {
      const QImage seen = bench.window->view()->viewport()->grab().toImage();
      int drawn = 0, all = 0;
      for (int x = bench.at(10.1, 7).x(); x < bench.at(10.9, 7).x(); ++x, ++all)
        drawn += seen.pixelColor(x, bench.at(10.1, 7).y()) == dash;
      return double(drawn) / all;
    };
    QTRY_VERIFY2(share() > 0.6 && share() < 0.92, qPrintable(QString::number(share())));
  }

  void withoutAWholeMapNothingIsRehearsed() {
    RehearsalBench bench;
    bench.openOnRobot();
    bench.rehearsal().rehearse(bench.wayFile(false));
    QCOMPARE(bench.way_dock().said(), QStringLiteral("There is no whole map on screen."));
  }
};

}  // namespace test_window_rehearsal

MAPWRIGHT_TEST(test_window_rehearsal, TestWindowRehearsal, Widgets)
#include "test_window_rehearsal.moc"
