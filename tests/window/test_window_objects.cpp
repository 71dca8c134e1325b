// What is this? Cards, properties and the list of what is on the map, by mouse and by keyboard.
#include <QLineEdit>
#include <QListWidget>
#include <QTableView>
#include <QtTest>

#include "test_program.h"
#include "ui/kit/forms.h"
#include "ui/objects/object_card.h"
#include "ui/objects/object_facts.h"
#include "ui/objects/objects_dock.h"
#include "ui/objects/properties_dock.h"
#include "ui/plots/messages_dock.h"
#include "ui/view/map_view.h"
#include "ui/window/command_palette.h"
#include "waypoints_desk.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_objects {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

map::AutoDoor door(const std::string& name, double x_m, const std::string& state) {
  return {name, "", state, {{x_m, 0}, {x_m + 2, 0}, {x_m + 2, 1}, {x_m, 1}}};
}

map::OverlayFeature region(const std::string& name, double from_m, double to_m) {
  return {map::OverlayShape::Polygon,
          1,
          name,
          name,
          std::nullopt,
          {{{from_m, from_m}, {to_m, from_m}, {to_m, to_m}, {from_m, to_m}}}};
}

/// A window on a robot at the origin that looks at 20 m around it.
struct ObjectBench : Bench {
  MainWindow& openOnRobot() {
    MainWindow& opened = open();
    (void)opened.connectTo(kAddress);
    robot->goOnline();
    robot->say(map::TrackedPose{{0, 0, 0}});
    geometry::ViewTransform view = opened.mapScene()->view();
    view.center_m = {0, 0};
    view.scale_m_per_px = 0.05;
    view.rotation_rad = 0;
    opened.view()->moveTo(view, false);
    return opened;
  }
  QPoint at(double x_m, double y_m) const {
    const Eigen::Vector2d px = window->mapScene()->view().pixelFromWorld({x_m, y_m});
    return QPoint(int(std::lround(px.x())), int(std::lround(px.y())));
  }
  void click(double x_m, double y_m, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(window->view()->viewport(), Qt::LeftButton, modifiers, at(x_m, y_m));
  }
  void rest(double x_m, double y_m) {
    QTest::mouseMove(window->view()->viewport(), at(x_m, y_m));
    // Offscreen, a move of the mouse reaches the widget as an event of its own.
    QMouseEvent move(QEvent::MouseMove, at(x_m, y_m), window->view()->viewport()->mapToGlobal(at(x_m, y_m)),
                     Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(window->view()->viewport(), &move);
  }
  ObjectCard* card() const { return window->findChild<ObjectCard*>(); }
};

}  // namespace

class TestWindowObjects : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aClickSaysWhatItIsAndEscLetsGo() {
    ObjectBench bench;
    bench.openOnRobot();
    bench.robot->say(map::AutoDoorsMessage{{door("Gate <b>3</b>", 4, "closed")}});
    bench.click(5, 0.5);
    QVERIFY(bench.card()->isVisible());
    QCOMPARE(bench.card()->title(), QStringLiteral("Automatic door Gate <b>3</b>"));
    QVERIFY2(bench.card()->lines().contains(QStringLiteral("State: closed")),
             qPrintable(bench.card()->lines().join(QLatin1Char('\n'))));
    QVERIFY(bench.card()->lines().contains(QStringLiteral("Area: 2.00 m²")));
    bench.key(Qt::Key_Escape);
    QVERIFY(!bench.card()->isVisible());
  }

  void aCardSaysWhatItHasNoRoomFor() {
    ObjectBench bench;
    bench.openOnRobot();
    bench.robot->say(map::AutoDoorsMessage{{door("Gate", 4, "closed")}});
    bench.click(5, 0.5);
    const scene::MapObject object = bench.window->mapScene()->objects(10).front();
    const std::vector<scene::ObjectProperty> facts(14, {QStringLiteral("Name"), QStringLiteral("value")});
    bench.card()->show(object, facts, 0);
    QCOMPARE(bench.card()->lines().size(), 11);
    QCOMPARE(bench.card()->moreShown(), QStringLiteral("3 more in the properties"));
    bench.card()->showRows(2);  // there is no room for more
    QCOMPARE(bench.card()->moreShown(), QStringLiteral("12 more in the properties"));
    bench.card()->show(object, {facts.begin(), facts.begin() + 11}, 0);
    QCOMPARE(bench.card()->moreShown(), QString());
  }

  void aToolInTheHandClosesTheCard() {
    ObjectBench bench;
    bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L7", {4, 4}, false}}});
    bench.click(4, 4);
    QVERIFY(bench.card()->isVisible());
    bench.action("measure")->trigger();
    QVERIFY(!bench.card()->isVisible());  // it would swallow the clicks of the tool
  }

  void aClickOnNothingLetsGo() {
    ObjectBench bench;
    bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L7", {4, 4}, false}}});
    bench.click(4, 4);
    QCOMPARE(bench.card()->title(), QStringLiteral("Landmark L7"));
    QVERIFY(bench.card()->lines().contains(QStringLiteral("In use: no")));
    bench.click(-6, -6);
    QVERIFY(!bench.card()->isVisible());
  }

  void altClickStepsThroughWhatLiesBeneath() {
    ObjectBench bench;
    bench.openOnRobot();
    map::MapInfo info;
    info.name = "Hall";
    info.overlays_version = 12;
    info.overlays = {region("Large", 2, 8), region("Small", 3, 5)};
    bench.robot->say(info);
    bench.robot->say(map::LandmarksMessage{{{"L1", {4, 4}, true}}});
    bench.click(4, 4);
    QCOMPARE(bench.card()->title(), QStringLiteral("Landmark L1"));
    bench.click(4, 4, Qt::AltModifier);
    QCOMPARE(bench.card()->title(), QStringLiteral("Forbidden region Small"));
    QVERIFY(bench.card()->lines().contains(QStringLiteral("Overlays version: 12")));
    bench.click(4, 4, Qt::AltModifier);
    QCOMPARE(bench.card()->title(), QStringLiteral("Forbidden region Large"));
    bench.click(4, 4, Qt::AltModifier);
    QCOMPARE(bench.card()->title(), QStringLiteral("Landmark L1"));
  }

  void theCardOfARestingCursorIsInNobodysWay() {
    ObjectBench bench;
    bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L1", {4, 4}, true}}});
    bench.rest(4, 4);
    QTRY_VERIFY(bench.card()->isVisible());
    QVERIFY(bench.card()->testAttribute(Qt::WA_TransparentForMouseEvents));
    QCOMPARE(bench.card()->title(), QStringLiteral("Landmark L1"));
    bench.rest(-6, -6);
    QVERIFY(!bench.card()->isVisible());
  }

  void theCardOfARestingCursorKeepsUpAndHasRoomForItsRows() {
    ObjectBench bench;
    bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L1", {-4, 4}, true}}});
    bench.robot->say(map::AutoDoorsMessage{{door("Gate", 4, "closed")}});
    bench.click(-4, 4);  // a card with fewer rows before
    bench.key(Qt::Key_Escape);
    bench.rest(5, 0.5);
    QTRY_VERIFY(bench.card()->isVisible());
    QVERIFY(bench.card()->lines().contains(QStringLiteral("State: closed")));
    QVERIFY(bench.card()->height() >= bench.card()->minimumSizeHint().height());
    bench.robot->say(map::AutoDoorsMessage{{door("Gate", 4, "open")}});
    QTRY_VERIFY(bench.card()->lines().contains(QStringLiteral("State: open")));
  }

  void theCardKeepsClearOfItsThing_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("large") << QSize(1600, 1000);
    QTest::newRow("small") << QSize(700, 440);
    QTest::newRow("flat") << QSize(1200, 340);
  }
  void theCardKeepsClearOfItsThing() {
    QFETCH(QSize, size);
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    for (QDockWidget* const dock : window.findChildren<QDockWidget*>()) dock->hide();
    window.resize(size);
    QCoreApplication::processEvents();
    const geometry::ViewTransform view = window.mapScene()->view();
    map::LandmarksMessage all;
    std::vector<Eigen::Vector2d> places;
    for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      for (const double y : {0.2, 0.5, 0.8})
        places.push_back(view.worldFromPixel({x * view.width_px, y * view.height_px}));
    }
    for (const Eigen::Vector2d& place : places) all.landmarks.push_back({"L", place, true});
    bench.robot->say(all);
    for (const Eigen::Vector2d& place : places) {
      bench.click(place.x(), place.y());
      QVERIFY(bench.card()->isVisible());
      const QRect card = bench.card()->geometry();
      QVERIFY2(!card.contains(bench.at(place.x(), place.y())),
               qPrintable(QStringLiteral("%1").arg(card.x())));
      QVERIFY(window.view()->viewport()->rect().contains(card));
    }
  }

  void whatHasLeftTheMapTakesItsCardAlong() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L1", {4, 4}, true}}});
    bench.click(4, 4);
    const QRect map = window.view()->viewport()->rect();
    geometry::ViewTransform view = window.mapScene()->view();
    view.center_m = {400, 4};
    window.view()->moveTo(view, false);
    QVERIFY(!bench.card()->geometry().intersects(map));
    view.center_m = {4, 4};
    window.view()->moveTo(view, false);
    QVERIFY(map.contains(bench.card()->geometry()));
  }

  void aWaypointTellsItsTagsAndWarnings() {
    test::WaypointsDesk desk;
    desk.store.points[0].type = "charger";
    desk.store.points[0].tags = {"night", "wide <b>"};
    desk.store.points.push_back(test::waypoint("c", 3, 1, "Dock"));
    desk.start();
    desk.click(desk.px(1, 1));
    auto* const card = desk.window->findChild<ObjectCard*>();
    QVERIFY(card->lines().contains(QStringLiteral("Type: charger")));
    QVERIFY(card->lines().contains(QStringLiteral("Tags: night, wide <b>")));
    QVERIFY2(card->lines().first().startsWith(QStringLiteral("Warning: ")),
             qPrintable(card->lines().join(QLatin1Char('\n'))));
  }

  void theKeyboardAlonePointsAtTheMiddleOfTheMap() {
    ObjectBench bench;
    bench.openOnRobot();
    bench.key(Qt::Key_I, Qt::ControlModifier);
    QCOMPARE(bench.card()->title(), QStringLiteral("Robot"));
    QVERIFY(bench.card()->lines().contains(QStringLiteral("Heading: 0°")));
  }

  void propertiesFollowTheThingUntilItIsGone() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    auto* const dock = part<PropertiesDock>(window);
    dock->show();
    bench.robot->say(map::AutoDoorsMessage{{door("Gate", 4, "closed")}});
    bench.click(5, 0.5);
    const auto value = [&](const QString& name) {
      const QAbstractItemModel* rows = dock->table()->model();
      for (int row = 0; row < rows->rowCount(); ++row) {
        if (rows->index(row, 0).data().toString() == name) return rows->index(row, 1).data().toString();
      }
      return QString();
    };
    QCOMPARE(value(QStringLiteral("State")), QStringLiteral("closed"));
    bench.robot->say(map::AutoDoorsMessage{{door("Gate", 4, "open")}});
    QTRY_COMPARE(value(QStringLiteral("State")), QStringLiteral("open"));
    bench.robot->say(map::AutoDoorsMessage{});
    QTRY_VERIFY(!bench.card()->isVisible());
    QCOMPARE(value(QStringLiteral("State")), QStringLiteral("open"));
  }

  void listsAllThatIsShownAndGoesThere() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L1", {4, 4}, true}, {"L2", {300, 40}, true}}});
    bench.robot->say(map::AutoDoorsMessage{{door("Gate", 4, "closed")}});
    auto* const dock = part<ObjectsDock>(window);
    bench.action("findObject")->trigger();
    QVERIFY(dock->isVisible());
    QVERIFY(dock->filterEdit()->hasFocus());
    QTest::keyClicks(dock->filterEdit(), QStringLiteral("landm"));
    QCOMPARE(dock->table()->model()->rowCount(), 2);
    QTest::keyClicks(dock->filterEdit(), QStringLiteral("arks"));
    dock->table()->setFocus();
    QTest::keyClick(dock->table(), Qt::Key_Down);
    QTest::keyClick(dock->table(), Qt::Key_Down);
    QTest::keyClick(dock->table(), Qt::Key_Return);
    const Eigen::Vector2d middle = window.view()->destination().center_m;
    QVERIFY2((middle - Eigen::Vector2d(300, 40)).norm() < 1, "it is in the middle of the map");
    QCOMPARE(bench.card()->title(), QStringLiteral("Landmark L2"));
  }

  void aLayerThatIsHiddenHasNothingToPointAt() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L1", {4, 4}, true}}});
    bench.click(4, 4);
    QVERIFY(bench.card()->isVisible());
    window.mapScene()->setLayerVisible(ui::scene::Layer::Landmarks, false);
    QTRY_VERIFY(!bench.card()->isVisible());
    bench.click(4, 4);
    QVERIFY(!bench.card()->isVisible());
  }

  void saysWhenAndFromWhereItKnows() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L1", {4, 4}, true}}});
    const auto ids = window.mapScene()->objectsAt({4, 4}, 5);
    QCOMPARE(ids.size(), 1U);
    const auto object = window.mapScene()->object(ids[0]);
    const auto heard = window.session()->heard(object->topic);
    QVERIFY(heard);
    const QDateTime later = QDateTime::fromMSecsSinceEpoch(std::llround((heard->last_s + 130) * 1000));
    bool told = false;
    for (const auto& fact : factsOf(*object, *window.session(), later))
      told = told || (fact.name == QLatin1String("Last message") &&
                      fact.value.endsWith(QLatin1String("(2 min 10 s ago)")));
    QVERIFY(told);
  }

  void thePaletteFindsThingsSubmapsAndCommands() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.load();
    bench.robot->say(map::LandmarksMessage{{{"Pillar 9", {4, 4}, true}}});
    bench.action("palette")->trigger();
    auto* const palette = window.findChild<CommandPalette*>();
    QVERIFY(palette);
    QTest::keyClicks(palette->field(), QStringLiteral("pillar"));
    QCOMPARE(palette->list()->item(0)->text(), QStringLiteral("Landmark Pillar 9"));
    palette->field()->clear();
    QTest::keyClicks(palette->field(), QStringLiteral("1-0"));
    QCOMPARE(palette->list()->item(0)->text(), QStringLiteral("Submap 1-0"));
    QTest::keyClick(palette->field(), Qt::Key_Return);
    QVERIFY(window.mapScene()->highlighted().contains({1, 0}));
  }

  void goingToASubmapLeavesNoOtherCard() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.load();
    bench.robot->say(map::LandmarksMessage{{{"Pillar 9", {4, 4}, true}}});
    bench.click(4, 4);
    QCOMPARE(bench.card()->title(), QStringLiteral("Landmark Pillar 9"));
    bench.action("palette")->trigger();
    auto* const palette = window.findChild<CommandPalette*>();
    QTest::keyClicks(palette->field(), QStringLiteral("1-0"));
    QTest::keyClick(palette->field(), Qt::Key_Return);
    QVERIFY(!bench.card()->isVisible());
    QVERIFY(window.mapScene()->highlighted().contains({1, 0}));
  }

  void aTopicIsSelectedTheFirstTime() {
    ObjectBench bench;
    bench.prepare = [](test::FakeRobot& made) { made.has_live = true; };
    MainWindow& window = bench.openOnRobot();
    auto* const messages = part<MessagesDock>(window);
    messages->hide();
    messages->filterEdit()->setText(QStringLiteral("something else"));
    bench.action("palette")->trigger();
    auto* const palette = window.findChild<CommandPalette*>();
    QTest::keyClicks(palette->field(), QStringLiteral("/battery_state"));
    QTest::keyClick(palette->field(), Qt::Key_Return);
    QVERIFY(messages->isVisible());
    QCOMPARE(messages->chosenTopic(), QStringLiteral("/battery_state"));
    QVERIFY(messages->table()->currentIndex().isValid());
  }

  void topicsBeyondThoseThatAreListedAreTold() {
    ObjectBench bench;
    bench.prepare = [](test::FakeRobot& made) { made.has_live = true; };
    MainWindow& window = bench.openOnRobot();
    auto* const messages = part<MessagesDock>(window);
    messages->show();
    messages->raise();
    QTRY_VERIFY(messages->watching());
    const auto say = [&](int from, int until) {
      for (int i = from; i < until; ++i) {
        robot::RawMessage message;
        message.topic = QStringLiteral("/many%1").arg(i);
        message.text = "1";
        Q_EMIT bench.robot->rawReceived(message);
      }
      messages->refresh();
    };
    say(0, 400);
    QCOMPARE(messages->moreShown(), QString());
    say(400, 501);
    QCOMPARE(messages->moreShown(),
             QStringLiteral("Only 500 topics are listed. Messages of others have come, too."));
    messages->clearButton()->click();
    QCOMPARE(messages->moreShown(), QString());
  }

  void thingsHaveTheSymbolsOfTheLegend() {
    ObjectBench bench;
    bench.prepare = [](test::FakeRobot& made) { made.has_live = true; };
    MainWindow& window = bench.openOnRobot();
    bench.robot->say(map::LandmarksMessage{{{"L1", {4, 4}, true}, {"L2", {6, 4}, false}}});
    std::vector<QImage> legend;
    for (const ui::scene::LegendSection& section : window.mapScene()->legend(1)) {
      if (section.title != ui::scene::layerTitle(ui::scene::Layer::Landmarks)) continue;
      for (const ui::scene::LegendRow& row : section.rows) legend.push_back(row.symbol);
    }
    QCOMPARE(legend.size(), 2U);
    for (const auto& [x_m, row] : {std::pair(4, 0), std::pair(6, 1)}) {
      const auto object = window.mapScene()->object(window.mapScene()->objectsAt({x_m, 4}, 5).at(0));
      const QImage symbol = window.mapScene()->symbolOf(*object, 22, 1);
      QCOMPARE(symbol.size(), QSize(22, 22));
      QCOMPARE(symbol.copy(3, 3, 16, 16), legend[std::size_t(row)].copy(14, 3, 16, 16));
    }
  }

  void theWholeNameIsFoundBeforeThoseThatBeginLikeIt() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    map::LandmarksMessage many;
    for (int i = 290; i > 0; --i) many.landmarks.push_back({"Rack " + std::to_string(i), {i * 0.1, 0}, true});
    bench.robot->say(many);
    bench.action("palette")->trigger();
    auto* const palette = window.findChild<CommandPalette*>();
    QTest::keyClicks(palette->field(), QStringLiteral("rack 29"));
    QCOMPARE(palette->list()->item(0)->text(), QStringLiteral("Landmark Rack 29"));
  }

  void aCommaIsADecimalPoint() {
    QWidget parent;
    QDoubleSpinBox* const box = numberField(&parent, {-100, 100, 3, 0.05, QStringLiteral(" m")});
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("-1,25"));
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(box->value(), -1.25);
  }

  void tenThousandThingsAreFoundAtOnce() {
    ObjectBench bench;
    MainWindow& window = bench.openOnRobot();
    map::LandmarksMessage many;
    for (int i = 0; i < 10'000; ++i) many.landmarks.push_back({"same", {i * 0.001, 0}, true});
    bench.robot->say(many);
    QVERIFY(!window.mapScene()->objectsAt({5, 0}, 5).empty());
    QVERIFY(window.mapScene()->objectsAt({5, 0}, 5).size() <= 50);
    QVERIFY(window.mapScene()->objects(100).size() == 100);
  }
};

}  // namespace test_window_objects

MAPWRIGHT_TEST(test_window_objects, TestWindowObjects, Widgets)
#include "test_window_objects.moc"
