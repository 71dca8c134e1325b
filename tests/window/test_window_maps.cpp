// Whole maps in the window: the catalogue, view modes, comparing, limits.
#include <algorithm>

#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include "test_program.h"
#include "ui/layers/layers_controller.h"
#include "ui/layers/layers_dock.h"
#include "ui/maps/compare_controller.h"
#include "ui/maps/export_controller.h"
#include "ui/maps/maps_controller.h"
#include "ui/maps/maps_dock.h"
#include "ui/robot/robot_dock.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/notice_bar.h"
#include "ui/view/on_screen.h"
#include "ui/view/swipe_handle.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_maps {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;
using ui::scene::Layer;

namespace {

map::MapKey stored(const char* id) { return {map::MapKind::Stored, id}; }

QStringList titles(const MapsModel& model) {
  QStringList made;
  for (int row = 0; row < model.rowCount(); ++row) made << model.index(row).data().toString();
  return made;
}

bool ready(const MainWindow& window) {
  return window.session()->wholeMap().phase() == session::MapSlot::Phase::Ready;
}

}  // namespace

class TestWindowMaps : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void listsStoredMapsAndMappings() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    const MapsModel& model = *part<MapsDock>(window)->model();
    QTRY_COMPARE(model.maps(), 3);
    QCOMPARE(titles(model), (QStringList{QStringLiteral("Stored maps"), QStringLiteral("Ground floor"),
                                         QStringLiteral("<b>Attic</b>"), QStringLiteral("Mappings"),
                                         QStringLiteral("Survey")}));
    const QModelIndex current = model.indexOf(stored("1"));
    QVERIFY(current.data(MapsModel::BadgesRole).toStringList().contains(QStringLiteral("current")));
    QVERIFY(model.indexOf(stored("2")).data(MapsModel::BadgesRole).toStringList().isEmpty());
    QVERIFY(!(model.index(0).flags() & Qt::ItemIsSelectable));
    QVERIFY(part<MapsDock>(window)->statusShown().startsWith(QLatin1String("3 maps, as of ")));
    // Markup in a name is text, in the tooltip too.
    QVERIFY(!model.indexOf(stored("2")).data(Qt::ToolTipRole).toString().contains(QLatin1String("<b>")));
  }

  void survivesAnyName() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) {
      robot.has_catalogue = true;
      robot.maps.entries = {test::catalogued("1", ""), test::catalogued("2", std::string(500, 'x')),
                            test::catalogued("3", "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D \xF0\x9F\xA4\x96"),
                            test::catalogued("1700000000123", "two\nlines\t"),
                            test::catalogued("5", "\xff\xfe")};
      robot.maps.entries[1].created_s = 1e300;
      robot.maps.entries[1].map_version = 9;
      robot.maps.entries[1].grid = map::GridReference{2898, 2603, 0.05, {}};
      for (auto& map : robot.maps.entries) map.has_thumbnail = true;
    };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    part<MapsDock>(window)->raise();
    const MapsModel& model = *part<MapsDock>(window)->model();
    QTRY_COMPARE(model.maps(), 5);
    QCOMPARE(model.indexOf(stored("1")).data().toString(), QStringLiteral("(no name)"));
    QVERIFY(model.indexOf(stored("2")).data().toString().size() <= 300);
    QCOMPARE(model.indexOf(stored("2")).data(MapsModel::DetailRole).toString(),
             QStringLiteral("id 2 · v9 · 2,898 x 2,603"));
    QCOMPARE(model.indexOf(stored("1700000000123")).data().toString(), QStringLiteral("two lines"));
    QVERIFY(model.indexOf(stored("1700000000123"))
                .data(MapsModel::DetailRole)
                .toString()
                .contains(QLatin1String("1700000000123")));
    part<MapsDock>(window)->grab();
    QCoreApplication::processEvents();
    QVERIFY(model.indexOf(stored("2")).data(MapsModel::ThumbnailRole).value<QPixmap>().isNull());
  }

  void findsMapsByName() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    QTest::keyClicks(part<MapsDock>(window)->search(), QStringLiteral("atti"));
    QCOMPARE(titles(*part<MapsDock>(window)->model()),
             (QStringList{QStringLiteral("Stored maps"), QStringLiteral("<b>Attic</b>")}));
    part<MapsDock>(window)->search()->setText(QStringLiteral("cellar"));
    QCOMPARE(part<MapsDock>(window)->model()->rowCount(), 0);
    QCOMPARE(part<MapsDock>(window)->emptyShown(), QStringLiteral("No map matches the search."));
    part<MapsDock>(window)->search()->clear();
    QCOMPARE(part<MapsDock>(window)->model()->found(), 3);
  }

  void opensAMapWithoutTouchingTheRobot() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    const MapsModel& model = *part<MapsDock>(window)->model();
    QTRY_COMPARE(model.maps(), 3);
    QVERIFY(model.indexOf(stored("2"))
                .data(Qt::ToolTipRole)
                .toString()
                .contains(QLatin1String("This loads and changes nothing on the robot")));
    bench.robot->maps.opened.clear();
    part<MapsDock>(window)->list()->setCurrentIndex(model.indexOf(stored("2")));
    QTest::keyClick(part<MapsDock>(window)->list(), Qt::Key_Return);
    QCOMPARE(*viewMode(*window.mapScene()), ViewMode::Whole);
    QTRY_VERIFY(ready(window));
    QCOMPARE(bench.robot->maps.opened, std::vector<map::MapKey>{stored("2")});
    QTRY_VERIFY(model.indexOf(stored("2"))
                    .data(MapsModel::BadgesRole)
                    .toStringList()
                    .contains(QStringLiteral("open")));
    QVERIFY(!part<MapOverlay>(window)->card()->kind());
    // The camera went there: 80 x 60 cells of 5 cm.
    QVERIFY(std::abs(window.mapScene()->view().center_m.x() - 2.0) < 0.1);
  }

  void saysWhatIsWrongWithTheList() {
    Bench bench;
    bench.offerMaps();
    const auto offer = bench.prepare;
    bench.prepare = [offer](test::FakeRobot& robot) {
      offer(robot);
      robot.maps.list_error = "The robot answered 500 to /maps/.";
    };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->statusShown(), QStringLiteral("The robot answered 500 to /maps/."));
    QVERIFY(!part<MapsDock>(window)->retryButton()->isHidden());
    bench.robot->maps.list_error.clear();
    QTest::mouseClick(part<MapsDock>(window)->retryButton(), Qt::LeftButton);
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    QVERIFY(part<MapsDock>(window)->retryButton()->isHidden());
    bench.robot->maps.entries.clear();
    QTest::mouseClick(part<MapsDock>(window)->refreshButton(), Qt::LeftButton);
    QTRY_COMPARE(part<MapsDock>(window)->emptyShown(), QStringLiteral("The robot has no stored maps."));
  }

  void saysWhyThereIsNoCatalogue() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(part<MapsDock>(window)->emptyShown().contains(QLatin1String("Connect to a robot")));
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(part<MapsDock>(window)->emptyShown(), QStringLiteral("This robot does not list its maps."));
    QVERIFY(!part<MapsDock>(window)->refreshButton()->isEnabled());
  }

  void offersTheLiveMapOfARobotThatSendsOne() {
    Bench bench;
    bench.offerMaps();
    const auto offer = bench.prepare;
    bench.prepare = [offer](test::FakeRobot& robot) {
      offer(robot);
      robot.has_live = true;
    };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    QCOMPARE(titles(*part<MapsDock>(window)->model()).front(), QStringLiteral("Live map"));
    part<MapsController>(window)->open({map::MapKind::Live, {}});
    QCOMPARE(*part<MapOverlay>(window)->card()->kind(), EmptyState::Kind::LoadingMap);
    map::GridMessage message;
    message.kind = map::GridKind::WholeMap;
    message.grid.resolution_m = 0.05;
    message.png = test::wholeMap({}, "", 50, 40).bytes;
    bench.robot->say(message);
    QTRY_VERIFY(ready(window));
    QVERIFY(!part<MapOverlay>(window)->card()->kind());
  }

  void switchesWhatIsOnScreen() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.key(Qt::Key_2);
    QVERIFY(!window.mapScene()->layerVisible(Layer::Submaps));
    QVERIFY(window.mapScene()->layerVisible(Layer::WholeMap));
    QVERIFY(bench.action("modeWhole")->isChecked());
    bench.key(Qt::Key_3);
    QVERIFY(window.mapScene()->layerVisible(Layer::Submaps));
    QVERIFY(window.mapScene()->layerVisible(Layer::WholeMap));
    QVERIFY(bench.action("modeBoth")->isChecked());
    bench.key(Qt::Key_1);
    QVERIFY(!window.mapScene()->layerVisible(Layer::WholeMap));
    // The switch follows the list of layers.
    part<LayersDock>(window)->eye(Layer::Submaps)->click();
    QVERIFY(!bench.action("modeSubmaps")->isChecked());
  }

  void putsTheWholeMapBelowWhenBothAreShown() {
    Bench bench;
    MainWindow& window = bench.open();
    std::vector<Layer> order = window.mapScene()->layerOrder();
    const auto whole = std::find(order.begin(), order.end(), Layer::WholeMap);
    const auto submaps = std::find(order.begin(), order.end(), Layer::Submaps);
    QVERIFY(whole < submaps && submaps != order.end());
    std::iter_swap(whole, submaps);
    window.mapScene()->setLayerOrder(order);
    part<LayersController>(window)->setMode(ViewMode::Both);
    order = window.mapScene()->layerOrder();
    QVERIFY(std::find(order.begin(), order.end(), Layer::WholeMap) <
            std::find(order.begin(), order.end(), Layer::Submaps));
  }

  void startsWithTheWholeMapWhereThereAreNoSubmaps() {
    Bench bench;
    bench.offerMaps();
    const auto offer = bench.prepare;
    bench.prepare = [offer](test::FakeRobot& robot) {
      offer(robot);
      robot.has_submaps = false;
    };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(*viewMode(*window.mapScene()), ViewMode::Whole);
    QVERIFY(!bench.action("modeSubmaps")->isEnabled());
    QVERIFY(!bench.action("modeBoth")->isEnabled());
    QVERIFY(bench.action("modeSubmaps")->toolTip().contains(QLatin1String("no submaps")));
    // The current map of such a robot opens by itself.
    QTRY_VERIFY(ready(window));
    QCOMPARE(window.session()->wholeMap().key(), stored("1"));
    bench.prepare = {};
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(*viewMode(*window.mapScene()), ViewMode::Submaps);
    QVERIFY(bench.action("modeBoth")->isEnabled());
  }

  void saysWhyAMapCannotBeShown() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    bench.robot->maps.map_error = "The robot answered 404.";
    part<MapsController>(window)->open(stored("2"));
    QTRY_VERIFY(part<MapOverlay>(window)->card()->kind() == EmptyState::Kind::MapFailed);
    QVERIFY(part<WindowStatusBar>(window)->mapShown().contains(QLatin1String("failed")));
    bench.robot->maps.map_error.clear();
    Q_EMIT part<MapOverlay>(window)->card()->wanted(CardOffer::Retry);
    QTRY_VERIFY(ready(window));
    QVERIFY(!part<MapOverlay>(window)->card()->kind());
    QCOMPARE(part<WindowStatusBar>(window)->mapShown(), QStringLiteral("Map 2, 80 x 60 cells"));
    // While the map stays on screen, the next failure is a notice above it.
    bench.robot->maps.map_error = "The robot answered 500.";
    part<MapsController>(window)->open(stored("2"));
    QTRY_VERIFY(part<MapOverlay>(window)->notice()->sentence().contains(QLatin1String("answered 500")));
    QVERIFY(part<MapOverlay>(window)->notice()->isVisible());
  }

  void comparesWithAnotherMap() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(ready(window));
    Q_EMIT part<MapsDock>(window)->compareWanted(stored("2"));
    CompareController& comparison = *part<CompareController>(window);
    QCOMPARE(window.mapScene()->compareMode(), ui::scene::CompareMode::Swipe);
    QVERIFY(comparison.bar()->isVisible());
    QVERIFY(comparison.handle()->isVisible());
    QTRY_COMPARE(window.session()->comparedMap().phase(), session::MapSlot::Phase::Ready);
    QVERIFY(comparison.bar()->second()->currentText().startsWith(QLatin1String("<b>Attic</b>")));
    QTest::mouseClick(comparison.bar()->differenceButton(), Qt::LeftButton);
    QCOMPARE(window.mapScene()->compareMode(), ui::scene::CompareMode::Difference);
    QVERIFY(comparison.bar()->legendShown());
    QVERIFY(!comparison.handle()->isVisible());
    QTest::mouseClick(comparison.bar()->closeButton(), Qt::LeftButton);
    QCOMPARE(window.mapScene()->compareMode(), ui::scene::CompareMode::Off);
    QVERIFY(!comparison.bar()->isVisible());
  }

  void eachHalfOfASwipeIsNamedByWhatItShows_data() {
    QTest::addColumn<Qt::Key>("mode");
    QTest::newRow("submaps") << Qt::Key_1;
    QTest::newRow("whole map") << Qt::Key_2;
    QTest::newRow("both") << Qt::Key_3;
  }
  void eachHalfOfASwipeIsNamedByWhatItShows() {
    QFETCH(Qt::Key, mode);
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(ready(window));
    // Submaps that lie on the free ground of the map, walls everywhere.
    bench.robot->list({test::entry(0, 0, 1, 3, 2), test::entry(0, 1, 1, 3.5, 2.5)});
    QTRY_COMPARE(window.session()->counts().shown, 2);
    bench.key(mode);
    ui::scene::MapScene& scene = *window.mapScene();
    const auto names = [&] { return halfNames(window.session(), scene); };
    QVERIFY(names().left.isEmpty());
    // The submaps against the whole map.
    bench.action("compare")->trigger();
    QVERIFY(scene.halves().left == ui::scene::HalfContent::Submaps);
    QCOMPARE(names().left, QStringLiteral("Submaps of Ground floor"));
    QCOMPARE(names().right, QStringLiteral("Map 1"));
    // Two whole maps: no submaps, also while the second one is on its way.
    part<CompareController>(window)->start(SecondMap(stored("2")));
    QVERIFY(scene.halves().left == ui::scene::HalfContent::WholeMap);
    QVERIFY(scene.halves().right == ui::scene::HalfContent::ComparedMap);
    QCOMPARE(names().left, QStringLiteral("Map 1"));
    QVERIFY(names().right.startsWith(QLatin1String("Fetching ")));
    QTRY_COMPARE(window.session()->comparedMap().phase(), session::MapSlot::Phase::Ready);
    QCOMPARE(names().right, QStringLiteral("Map 2"));
    QTRY_VERIFY(scene.picturesSettled());
    scene.setLayerVisible(Layer::Outlines, false);
    const QImage swiped = part<ExportController>(window)->mapPicture();
    window.session()->setVisible({{0, 0}, {0, 1}}, false);
    QTRY_VERIFY(scene.picturesSettled());
    QCOMPARE(part<ExportController>(window)->mapPicture(), swiped);
    // The names are part of the picture.
    scene.setHalfNames({}, {});
    QVERIFY(part<ExportController>(window)->mapPicture() != swiped);
    // Difference is about the same two, whatever the mode.
    part<CompareController>(window)->start(SecondMap(stored("7")));
    QTest::mouseClick(part<CompareController>(window)->bar()->differenceButton(), Qt::LeftButton);
    QVERIFY(window.windowTitle().startsWith(QLatin1String("Map 1 | Fetching")));
    QTRY_VERIFY(window.windowTitle().startsWith(QLatin1String("Map 1 | Map 7")));
    QVERIFY(names().left.isEmpty());
  }

  void saysWhatIsUnderTheCursorOfThatHalf() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(ready(window));
    ui::scene::MapScene& scene = *window.mapScene();
    const Eigen::Vector2d wall(0.1, 1.5);
    QVERIFY(scene.occupancyAt(wall).has_value());
    // The submaps stand left of the line, and there is none here.
    bench.action("compare")->trigger();
    scene.setSwipeAt(1);
    QVERIFY(!scene.occupancyAt(wall).has_value());
    scene.setSwipeAt(0);
    QVERIFY(scene.occupancyAt(wall).has_value());
    part<CompareController>(window)->start(SecondMap(stored("2")));
    QTRY_COMPARE(window.session()->comparedMap().phase(), session::MapSlot::Phase::Ready);
    QVERIFY(scene.occupancyAt(wall).has_value());
  }

  void twoMapsOfOneNameAreToldApart() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(ready(window));
    const auto names = [&] { return halfNames(window.session(), *window.mapScene()); };
    part<CompareController>(window)->start(SecondMap(KeptState{}));
    QTRY_COMPARE(window.session()->comparedMap().phase(), session::MapSlot::Phase::Ready);
    QCOMPARE(names().left, QStringLiteral("Map 1 (id 1)"));
    QCOMPARE(names().right, QStringLiteral("Map 1 (before)"));
    QCOMPARE(part<CompareController>(window)->bar()->firstShown(), QStringLiteral("Map 1 (id 1)"));
    part<CompareController>(window)->startWith(test::wholeMap({map::MapKind::File, {}}, "Map 1", 30, 30));
    QTRY_COMPARE(window.session()->comparedMap().phase(), session::MapSlot::Phase::Ready);
    QVERIFY(names().left != names().right);
    QVERIFY(
        part<CompareController>(window)->bar()->second()->currentText().startsWith(QLatin1String("Map 1 (")));
    QVERIFY(window.windowTitle().contains(names().left + QStringLiteral(" | ") + names().right));
  }

  void aDamagedMapIsNotShownByThePictureOfAnotherOne() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(ready(window));
    const session::MapSlot& second = window.session()->comparedMap();
    part<CompareController>(window)->startWith(test::wholeMap({map::MapKind::File, {}}, "good", 30, 30));
    QTRY_COMPARE(second.phase(), session::MapSlot::Phase::Ready);
    map::WholeMap damaged = test::wholeMap({map::MapKind::File, {}}, "damaged", 30, 30);
    damaged.bytes = std::make_shared<const std::string>("P5\n30 30\n");
    part<CompareController>(window)->startWith(damaged);
    QTRY_COMPARE(second.phase(), session::MapSlot::Phase::Failed);
    QVERIFY(!second.cells());
    QCOMPARE(halfNames(window.session(), *window.mapScene()).right, QStringLiteral("damaged failed"));
    QVERIFY(!part<CompareController>(window)->bar()->statusShown().isEmpty());
    // The robot is not asked for it: whatever it has would be another map.
    bench.robot->maps.opened.clear();
    window.session()->retryNow();
    QTRY_COMPARE(second.phase(), session::MapSlot::Phase::Failed);
    QCOMPARE(second.name(), QStringLiteral("damaged"));
    for (const map::MapKey& asked : bench.robot->maps.opened) QVERIFY(asked.kind != map::MapKind::File);
  }

  void keepsThePresentStateToCompareWith() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(ready(window));
    part<CompareController>(window)->start(SecondMap(KeptState{}));
    QTRY_COMPARE(window.session()->comparedMap().phase(), session::MapSlot::Phase::Ready);
    QCOMPARE(part<CompareController>(window)->bar()->second()->currentText(),
             QStringLiteral("The state before"));
    bench.key(Qt::Key_Escape);
    QVERIFY(!part<CompareController>(window)->active());
  }

  void setsTheSubmapsAgainstTheWholeMap() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.action("compare")->trigger();
    QVERIFY(part<CompareController>(window)->active());
    QCOMPARE(*part<CompareController>(window)->second(), SecondMap(SubmapsAside{}));
    QVERIFY(!part<CompareController>(window)->bar()->differenceButton()->isEnabled());
  }

  void dragsTheDivider() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.action("compare")->trigger();
    SwipeHandle& handle = *part<CompareController>(window)->handle();
    QCOMPARE(window.mapScene()->swipeAt(), 0.5);
    const QPoint middle = handle.rect().center();
    QTest::mousePress(&handle, Qt::LeftButton, {}, middle);
    const int right = int(0.75 * window.view()->width());
    QMouseEvent move(QEvent::MouseMove, handle.mapFrom(window.view(), QPoint(right, middle.y())), QPoint(),
                     Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&handle, &move);
    QTest::mouseRelease(&handle, Qt::LeftButton, {}, middle);
    QVERIFY(std::abs(window.mapScene()->swipeAt() - 0.75) < 0.01);
    QVERIFY(std::abs(handle.geometry().center().x() - right) <= 2);
    handle.setFocus();
    const double before = window.mapScene()->swipeAt();
    QTest::keyClick(&handle, Qt::Key_Left);
    QVERIFY(std::abs(window.mapScene()->swipeAt() - (before - 0.01)) < 1e-9);
    QTest::keyClick(&handle, Qt::Key_Home);
    QCOMPARE(window.mapScene()->swipeAt(), 0.0);
    QTest::keyClick(&handle, Qt::Key_Escape);
    QVERIFY(!part<CompareController>(window)->active());
  }

  void tellsWhatTheRobotDoesNotAllow() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) { robot.read_only_maker = QStringLiteral("<i>Maker</i>"); };
    const QString limits = QStringLiteral("Read only: <i>Maker</i>'s interface offers no editing.");
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(part<RobotDock>(window)->limitsShown(), limits);
    NoticeBar* notice = part<MapOverlay>(window)->notice();
    QVERIFY(notice->isVisible());
    QCOMPARE(notice->sentence(), limits);
    QTest::mouseClick(notice->closeButton(), Qt::LeftButton);
    QVERIFY(!notice->isVisible());
    QVERIFY(!window.connectTo(kAddress));
    QVERIFY(!notice->isVisible());  // once is enough
    QCOMPARE(part<RobotDock>(window)->limitsShown(), limits);
  }
};

}  // namespace test_window_maps

MAPWRIGHT_TEST(test_window_maps, TestWindowMaps, Widgets)
#include "test_window_maps.moc"
