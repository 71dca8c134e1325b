// The maps of the robot, changed from the window: what is asked first, what is sent, what is said of it.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QtTest>

#include "test_program.h"
#include "ui/maps/administration_controller.h"
#include "ui/maps/mapping_dock.h"
#include "ui/maps/maps_dock.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_administration {

using namespace mapwright;
using namespace mapwright::ui;
using robot::MapChange;
using robot::Obstacle;
using test::Bench;
using test::kAddress;

namespace {

/// Keeps what it is asked for until it is told what comes of it.
class FakeAdministration : public robot::MapAdministration {
 public:
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override {
    if (const auto found = obstacles.find(change); found != obstacles.end()) return found->second;
    if (map && change == MapChange::Archive && map->is_archived) return Obstacle::IsArchived;
    if (map && change == MapChange::Unarchive && !map->is_archived) return Obstacle::IsNotArchived;
    return std::nullopt;
  }
  bool loadAsksForPlace() const override { return asks_place; }
  robot::Call carryOut(const robot::MapOrder& order, robot::OutcomeTo<map::CatalogueEntry> reply) override {
    orders.push_back(order);
    replies.push_back(std::move(reply));
    auto state = std::make_shared<robot::Call::State>();
    state->cancel = [this] { ++cancelled; };
    return robot::Call(state);
  }
  void answer(const robot::Outcome<map::CatalogueEntry>& outcome) {
    const auto reply = std::exchange(replies.back(), nullptr);
    reply(outcome);
  }

  /// It makes new maps only.
  void startMapping() {
    obstacles = {{MapChange::StartMapping, Obstacle::WhileMapping},
                 {MapChange::ContinueMapping, Obstacle::NotOffered}};
  }

  std::map<MapChange, Obstacle> obstacles;
  bool savesListed() const override { return saves_listed; }

  bool asks_place = false, saves_listed = false;
  int cancelled = 0;
  std::vector<robot::MapOrder> orders;
  std::vector<robot::OutcomeTo<map::CatalogueEntry>> replies;
};

struct Desk {
  explicit Desk(bool unconfirmed = false, bool sends_map = false) {
    bench.offerMaps();
    bench.prepare = [this, unconfirmed, sends_map, offer = bench.prepare](test::FakeRobot& robot) {
      offer(robot);
      robot.unconfirmed = unconfirmed;
      robot.has_live = sends_map;
      robot.administration = &maps;
      robot.told_waypoints = &points;
    };
    bench.open();
    (void)bench.window->connectTo(kAddress);
    (void)QTest::qWaitFor([this] { return part<MapsDock>(*bench.window)->model()->maps() == 3; }, 30'000);
  }
  AdministrationController& controller() { return *part<AdministrationController>(*bench.window); }
  /// The menu of this map, as the dock fills it.
  std::unique_ptr<QMenu> menu(const char* id) {
    auto made = std::make_unique<QMenu>();
    controller().fillMenu(made.get(), {map::MapKind::Stored, id});
    return made;
  }
  static QAction* entry(const QMenu& menu, const char* begins) {
    for (QAction* action : menu.actions())
      if (action->text().startsWith(QLatin1String(begins))) return action;
    return nullptr;
  }
  ChangeDialog* ask(const char* id, const char* begins) {
    const auto made = menu(id);
    QAction* const action = entry(*made, begins);
    if (!action || !action->isEnabled()) return nullptr;
    action->trigger();
    return controller().dialog();
  }
  QStringList toasts() { return bench.window->findChild<ToastStack*>()->texts(); }

  FakeAdministration maps;
  map::WaypointList points;
  Bench bench;
};

}  // namespace

class TestWindowAdministration : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aMapIsRenamedOnTheRobot() {
    Desk desk;
    ChangeDialog* const dialog = desk.ask("2", "Rename");
    QVERIFY(dialog);
    // Markup in a name is text, and what stands there is no error yet.
    QVERIFY(dialog->textShown().contains(QLatin1String("<b>Attic</b>")));
    QCOMPARE(dialog->nameEdit()->text(), QStringLiteral("<b>Attic</b>"));
    QVERIFY(!dialog->acceptButton()->isEnabled() && dialog->errorShown().isEmpty());
    QCOMPARE(dialog->focusWidget(), dialog->nameEdit());
    QCOMPARE(dialog->nameEdit()->selectedText(), QStringLiteral("<b>Attic</b>"));
    dialog->nameEdit()->selectAll();
    QTest::keyClicks(dialog->nameEdit(), QStringLiteral("Loft"));
    QVERIFY(dialog->acceptButton()->isEnabled());
    QTest::keyClick(dialog->nameEdit(), Qt::Key_Return);
    QCOMPARE(desk.maps.orders.size(), std::size_t(1));
    QVERIFY(desk.maps.orders[0].change == MapChange::Rename);
    QCOMPARE(desk.maps.orders[0].key.id, std::string("2"));
    QCOMPARE(desk.maps.orders[0].name, std::string("Loft"));
    QVERIFY(dialog->waiting() && !dialog->acceptButton()->isEnabled());
    QVERIFY(desk.toasts().isEmpty());  // nothing is said before the robot has
    desk.maps.answer(test::catalogued("2", "Loft"));
    QTRY_VERIFY(!desk.controller().dialog());
    QCOMPARE(desk.toasts(), QStringList{QStringLiteral("It is now called Loft.")});
  }

  void whatIsNotConfirmedByTheMakerIsCalledSoWhereverItIsOffered() {
    for (const bool unconfirmed : {false, true}) {
      Desk desk(unconfirmed);
      const auto says = [](const QString& text) { return text.contains(QLatin1String("not confirmed")); };
      const auto menu = desk.menu("2");
      QCOMPARE(says(Desk::entry(*menu, "Rename")->toolTip()), unconfirmed);
      QCOMPARE(says(desk.bench.action("startMapping")->toolTip()), unconfirmed);
      QVERIFY(desk.bench.action("startMapping")->toolTip().contains(QLatin1String("start a new map")));
      ChangeDialog* const dialog = desk.ask("2", "Rename");
      QVERIFY(dialog);
      QCOMPARE(says(dialog->textShown()), unconfirmed);
      MappingDock* const dock = desk.controller().mappingDock();
      dock->show();
      bool shown = false;
      for (const QLabel* label : dock->findChildren<QLabel*>())
        shown = shown || (label->isVisibleTo(dock) && says(label->text()));
      QCOMPARE(shown, unconfirmed);
    }
  }

  void aMappingThatEndsBySavingSaysSo() {
    Desk desk;
    desk.maps.obstacles = {{MapChange::StartMapping, Obstacle::WhileMapping},
                           {MapChange::StopMapping, Obstacle::EndsBySaving}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    QAction* const stop = desk.bench.action("stopMapping");
    QVERIFY(stop->isVisible() && !stop->isEnabled());
    QVERIFY2(stop->toolTip().contains(QLatin1String("by saving the map")), qPrintable(stop->toolTip()));
    desk.bench.action("saveNewMap")->trigger();
    ChangeDialog* const save = desk.controller().dialog();
    QVERIFY(save->textShown().contains(QLatin1String("ends the mapping")));
    QVERIFY(save->acceptButton()->text().contains(QLatin1String("end the mapping")));
    // Enter behind the name neither ends it nor throws the name away.
    QTest::keyClicks(save->nameEdit(), QStringLiteral("Yard"));
    QTest::keyClick(save->nameEdit(), Qt::Key_Return);
    QVERIFY(save->isVisible() && desk.maps.orders.empty());
    QCOMPARE(save->nameEdit()->text(), QStringLiteral("Yard"));
    save->acceptButton()->click();
    QCOMPARE(desk.maps.orders.size(), std::size_t(1));
    delete save;
    desk.maps.obstacles = {{MapChange::StopMapping, Obstacle::EndsBySaving},
                           {MapChange::CancelMapping, Obstacle::NotMapping}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    QVERIFY(desk.controller().mappingDock()->said().startsWith(QLatin1String("The robot is not mapping.")));
  }

  void aNameThatAnotherMapHasIsToldWhileItIsTyped() {
    Desk desk;
    ChangeDialog* const dialog = desk.ask("2", "Rename");
    QVERIFY(dialog);
    QTest::keyClicks(dialog->nameEdit(), QStringLiteral("Ground floor"));
    QCOMPARE(dialog->errorShown(), QStringLiteral("Another map has this name: id 1."));
    QVERIFY(dialog->acceptButton()->isEnabled());  // names need not be unique
    QTest::keyClicks(dialog->nameEdit(), QStringLiteral(" 2"));
    QVERIFY(dialog->errorShown().isEmpty());
    dialog->reject();
    desk.bench.action("saveNewMap")->trigger();
    ChangeDialog* const save = desk.controller().dialog();
    QVERIFY(save);
    QTest::keyClicks(save->nameEdit(), QStringLiteral("Ground floor"));
    QCOMPARE(save->errorShown(), QStringLiteral("Another map has this name: id 1."));
    QTest::keyClick(save->nameEdit(), Qt::Key_Return);
    QCOMPARE(desk.maps.orders.size(), std::size_t(1));
  }

  void aMappingThatWasAskedForIsNoAlarm() {
    Desk desk;
    const auto ask = [&](const char* action = "startMapping") {
      desk.bench.action(action)->trigger();
      desk.controller().dialog()->acceptButton()->click();
    };
    desk.bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-a");
    ask();
    desk.bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-b");
    const QString begun = QStringLiteral("Mapping has started: the robot is making a new map.");
    QCOMPARE(desk.toasts(), QStringList{begun});
    desk.maps.answer(test::catalogued("1", "Ground floor"));
    // Its end begins another session, too.
    ask("stopMapping");
    desk.bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-of-the-map");
    QVERIFY(!desk.toasts().join(QLatin1Char(' ')).contains(QLatin1String("The previous map is gone")));
    desk.maps.answer(test::catalogued("1", "Ground floor"));
    // What was refused, and what nobody asked for.
    ask();
    desk.maps.answer(tl::make_unexpected(test::failed("no")));
    desk.bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-c");
    QVERIFY(desk.toasts().join(QLatin1Char(' ')).contains(QLatin1String("The previous map is gone")));
  }

  void whatFailsIsSaidWhereItWasTypedAndNothingIsLost() {
    Desk desk;
    ChangeDialog* const dialog = desk.ask("2", "Rename");
    QVERIFY(dialog);
    dialog->nameEdit()->setText(QStringLiteral("Ground floor"));
    dialog->acceptButton()->click();
    desk.maps.answer(tl::make_unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot,
                                                      .subject = map::subjectOf(desk.maps.orders[0].key),
                                                      .robot_code = "2",
                                                      .detail = "name exists",
                                                      .asked_for = map::AskedFor::Change}));
    QCOMPARE(desk.controller().dialog(), dialog);
    QVERIFY2(dialog->errorShown().contains(QLatin1String("It was not changed")),
             qPrintable(dialog->errorShown()));
    QVERIFY(dialog->errorShown().contains(QLatin1String("name exists")));
    QCOMPARE(dialog->nameEdit()->text(), QStringLiteral("Ground floor"));
    QVERIFY(dialog->acceptButton()->isEnabled());
    dialog->acceptButton()->click();
    QCOMPARE(desk.maps.orders.size(), std::size_t(2));
  }

  void namesThatNoMapHasAreNotSent_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("empty") << QString();
    QTest::newRow("blank") << QStringLiteral("   ");
    QTest::newRow("bell") << QStringLiteral("a\u0007b");
    QTest::newRow("the same") << QStringLiteral("<b>Attic</b>");
  }
  void namesThatNoMapHasAreNotSent() {
    QFETCH(QString, name);
    Desk desk;
    ChangeDialog* const dialog = desk.ask("2", "Rename");
    QVERIFY(dialog);
    dialog->nameEdit()->setText(name);
    QVERIFY(!dialog->acceptButton()->isEnabled());
    QTest::keyClick(dialog->nameEdit(), Qt::Key_Return);
    QVERIFY(desk.maps.orders.empty());
  }

  void theMapThatTheRobotWorksWithIsDeletedByTypingItsName() {
    Desk desk;
    ChangeDialog* const dialog = desk.ask("1", "Delete");
    QVERIFY(dialog && dialog->typedEdit());
    QVERIFY(!dialog->acceptButton()->isEnabled());
    dialog->typedEdit()->setText(QStringLiteral("Ground"));
    QVERIFY(!dialog->acceptButton()->isEnabled());
    dialog->typedEdit()->setText(QStringLiteral("Ground floor"));
    QVERIFY(dialog->acceptButton()->isEnabled());
    dialog->reject();
    QVERIFY(desk.maps.orders.empty());
    ChangeDialog* const other = desk.ask("2", "Delete");
    QVERIFY(other && !other->typedEdit() && other->acceptButton()->isEnabled());
    other->acceptButton()->click();
    QVERIFY(desk.maps.orders[0].change == MapChange::Delete);
  }

  void loadingAsksWhereTheRobotStandsThoseForLocalisationFirst() {
    Desk desk;
    desk.maps.asks_place = true;
    for (const char* name : {"Gate", "Dock", "Aisle"}) {
      map::Waypoint point;
      point.id = point.name = name;
      if (point.name == "Dock") point.tags = {"localisation"};
      if (point.name == "Gate") point.tags = {"map_entry"};
      desk.points.points.push_back(point);
    }
    ChangeDialog* const dialog = desk.ask("2", "Load");
    QVERIFY(dialog && dialog->places());
    QVERIFY(dialog->textShown().contains(QLatin1String("from Ground floor to")));
    QTRY_COMPARE(dialog->places()->count(), 4);
    // Nobody has said where it stands.
    QCOMPARE(dialog->places()->currentText(), QStringLiteral("not stated"));
    QCOMPARE(dialog->places()->itemText(1), QStringLiteral("Dock"));
    QCOMPARE(dialog->places()->itemText(2), QStringLiteral("Gate"));
    dialog->places()->setCurrentIndex(1);
    dialog->acceptButton()->click();
    QCOMPARE(desk.maps.orders[0].place, std::string("Dock"));
  }

  void aPlaceThatNobodyHasStatedIsNotSent() {
    Desk desk;
    desk.maps.asks_place = true;
    map::Waypoint point;
    point.id = point.name = "not stated";  // a place may be called so
    desk.points.points.push_back(point);
    ChangeDialog* dialog = desk.ask("2", "Load");
    QVERIFY(dialog);
    QCOMPARE(dialog->places()->currentText(), QStringLiteral("not stated"));  // before they have come
    QTRY_COMPARE(dialog->places()->count(), 2);
    dialog->acceptButton()->click();
    QCOMPARE(desk.maps.orders[0].place, std::string());
    desk.maps.answer(test::catalogued("2", "Attic"));
    QTRY_VERIFY(!desk.controller().dialog());
    dialog = desk.ask("2", "Load");
    QVERIFY(dialog);
    QTRY_COMPARE(dialog->places()->count(), 2);
    dialog->places()->setCurrentIndex(1);
    dialog->acceptButton()->click();
    QCOMPARE(desk.maps.orders[1].place, std::string("not stated"));
  }

  void whatIsTypedIsKeptWhenThePlacesCome() {
    Desk desk;
    desk.maps.asks_place = true;
    map::Waypoint point;
    point.id = point.name = "Dock";
    desk.points.points.push_back(point);
    ChangeDialog* const dialog = desk.ask("2", "Load");
    QVERIFY(dialog);
    dialog->places()->setEditText(QStringLiteral("Ramp"));
    QTRY_COMPARE(dialog->places()->count(), 2);
    QCOMPARE(dialog->places()->currentText(), QStringLiteral("Ramp"));
    dialog->acceptButton()->click();
    QCOMPARE(desk.maps.orders[0].place, std::string("Ramp"));
  }

  void enterDoesNothingThatCannotBeHadBack_data() {
    QTest::addColumn<QString>("entry");
    QTest::newRow("delete") << QStringLiteral("Delete");
    QTest::newRow("load") << QStringLiteral("Load");
    QTest::newRow("start mapping") << QStringLiteral("startMapping");
    QTest::newRow("stop mapping") << QStringLiteral("stopMapping");
  }
  void enterDoesNothingThatCannotBeHadBack() {
    QFETCH(QString, entry);
    Desk desk;
    desk.maps.asks_place = true;
    QAction* const action = desk.bench.window->actionList().find(entry);
    ChangeDialog* dialog = nullptr;
    if (action) {
      action->trigger();
      dialog = desk.controller().dialog();
    } else {
      dialog = desk.ask("2", qPrintable(entry));  // which the robot does not work with
    }
    QVERIFY(dialog);
    QVERIFY(!dialog->acceptButton()->isDefault());
    QTest::keyClick(dialog->focusWidget() ? dialog->focusWidget() : dialog, Qt::Key_Return);
    QVERIFY(desk.maps.orders.empty());
    QTRY_VERIFY(!desk.controller().dialog());
    // Nor when the button has the focus.
    if (action) {
      action->trigger();
      dialog = desk.controller().dialog();
    } else {
      dialog = desk.ask("2", qPrintable(entry));
    }
    QVERIFY(dialog);
    dialog->acceptButton()->setFocus();
    QTest::keyClick(dialog->acceptButton(), Qt::Key_Return);
    QVERIFY(desk.maps.orders.empty());
  }

  void whatCannotBeDoneNowIsGreyedAndSaysWhy() {
    Desk desk;
    desk.maps.obstacles = {{MapChange::Load, Obstacle::WhileMapping},
                           {MapChange::Delete, Obstacle::NotOffered}};
    const auto menu = desk.menu("2");
    QAction* const load = Desk::entry(*menu, "Load");
    QVERIFY(load && !load->isEnabled());
    QVERIFY2(load->toolTip().contains(QLatin1String("stop mapping first")), qPrintable(load->toolTip()));
    QVERIFY(!Desk::entry(*menu, "Delete"));
    QVERIFY(Desk::entry(*menu, "Archive") && !Desk::entry(*menu, "Restore"));
  }

  void mappingIsStartedStoppedAndSaved() {
    Desk desk;
    desk.maps.obstacles = {{MapChange::StopMapping, Obstacle::NotMapping},
                           {MapChange::Save, Obstacle::NotMapping}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    QAction* const start = desk.bench.action("startMapping");
    QAction* const stop = desk.bench.action("stopMapping");
    QVERIFY(start->isVisible() && start->isEnabled() && stop->isVisible() && !stop->isEnabled());
    start->trigger();
    desk.controller().dialog()->acceptButton()->click();
    desk.maps.answer(map::CatalogueEntry{});
    QTRY_VERIFY(!desk.controller().dialog());
    desk.maps.obstacles = {{MapChange::StartMapping, Obstacle::WhileMapping}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    QVERIFY(!start->isEnabled() && stop->isEnabled());
    stop->trigger();
    desk.controller().dialog()->acceptButton()->click();
    desk.maps.answer(map::CatalogueEntry{});
    desk.maps.obstacles = {{MapChange::StopMapping, Obstacle::NotMapping}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    // Who stops mapping is asked what the map is called.
    QTRY_VERIFY(desk.controller().dialog() && desk.controller().dialog()->nameEdit());
    desk.controller().dialog()->nameEdit()->setText(QStringLiteral("Hall 3"));
    desk.controller().dialog()->acceptButton()->click();
    QVERIFY(desk.maps.orders.back().change == MapChange::Save);
    QCOMPARE(desk.maps.orders.back().name, std::string("Hall 3"));
    QAction* const save = desk.bench.action("saveNewMap");
    QVERIFY(save->isEnabled());
    map::CatalogueEntry saved;
    saved.key = {map::MapKind::Stored, "9"};
    saved.name = "Hall 3";
    desk.maps.answer(saved);
    QTRY_VERIFY(!desk.controller().dialog());
    QVERIFY(!save->isEnabled() && save->toolTip().contains(QLatin1String("is saved")));
    // Until the robot maps again.
    desk.maps.obstacles = {{MapChange::StartMapping, Obstacle::WhileMapping}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    desk.maps.obstacles = {{MapChange::StopMapping, Obstacle::NotMapping}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    QVERIFY(save->isEnabled());
    // What was discarded cannot be saved.
    desk.maps.obstacles = {{MapChange::StartMapping, Obstacle::WhileMapping}};
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    desk.bench.action("cancelMapping")->trigger();
    desk.controller().dialog()->acceptButton()->click();
    desk.maps.obstacles = {{MapChange::StopMapping, Obstacle::NotMapping}};
    desk.maps.answer(map::CatalogueEntry{});
    QTRY_VERIFY(!desk.controller().dialog());
    QVERIFY(!save->isEnabled() && save->toolTip().contains(QLatin1String("discarded")));
  }

  void whileTheRobotMakesANewMapNothingIsSaidToBeTheOneThatItLeft() {
    Desk desk(false, true);
    const session::MapSlot& slot = desk.bench.window->session()->wholeMap();
    desk.bench.action("modeWhole")->trigger();
    desk.bench.window->session()->openMap({map::MapKind::Stored, "1"});
    QTRY_COMPARE(slot.phase(), session::MapSlot::Phase::Ready);
    const auto title = [&] { return desk.bench.window->windowTitle(); };
    QVERIFY2(title().contains(QLatin1String("Map 1")), qPrintable(title()));
    map::MapInfo left;
    left.name = "Ground floor";
    desk.bench.robot->say(left);
    desk.maps.startMapping();
    Q_EMIT desk.bench.robot->mapsChanged();
    // The map that grows is on screen, and the robot in it.
    QTRY_COMPARE(slot.key().kind, map::MapKind::Live);
    map::GridMessage grown;
    grown.kind = map::GridKind::WholeMap;
    const map::WholeMap picture = test::wholeMap({map::MapKind::Live, {}}, {}, 40, 30);
    grown.grid = picture.grid;
    grown.png = picture.bytes;
    grown.fingerprint = "1";
    desk.bench.robot->say(grown);
    QTRY_COMPARE(slot.phase(), session::MapSlot::Phase::Ready);
    QVERIFY2(!title().contains(QLatin1String("Ground floor")), qPrintable(title()));
    QVERIFY(title().contains(QLatin1String("live map")));
    QVERIFY(!desk.bench.window->session()->placesOf(slot));  // its waypoints are those of another map
    QCOMPARE(desk.bench.window->mapScene()->robotPlace().drawn, ui::scene::ScreenPart::All);
    desk.bench.window->session()->openMap({map::MapKind::Stored, "1"});
    QTRY_COMPARE(slot.phase(), session::MapSlot::Phase::Ready);
    QCOMPARE(desk.bench.window->mapScene()->robotPlace().drawn, ui::scene::ScreenPart::None);
    // It names the map again once the robot uses one.
    desk.maps.obstacles = {{MapChange::StopMapping, Obstacle::NotMapping}};
    Q_EMIT desk.bench.robot->mapsChanged();
    desk.bench.window->session()->openMap({map::MapKind::Live, {}});
    QTRY_VERIFY2(title().contains(QLatin1String("Ground floor")), qPrintable(title()));
  }

  void aMapThatIsLookedAtStaysOnScreenWhileTheRobotMaps() {
    Desk desk(false, true);
    const session::MapSlot& slot = desk.bench.window->session()->wholeMap();
    desk.bench.window->session()->openMap({map::MapKind::Stored, "2"});  // the robot is in 1
    QTRY_COMPARE(slot.phase(), session::MapSlot::Phase::Ready);
    desk.maps.startMapping();
    Q_EMIT desk.bench.robot->mapsChanged();
    QTRY_VERIFY(desk.controller().mappingDock()->said().startsWith(QLatin1String("The robot is mapping.")));
    QCOMPARE(slot.key(), (map::MapKey{map::MapKind::Stored, "2"}));
  }

  void withoutAFinishedMappingNothingCanBeSaved() {
    Desk desk;
    desk.maps.saves_listed = true;
    desk.bench.robot->maps.entries[2].state = "running";
    Q_EMIT desk.bench.robot->mapsChanged();
    QAction* const save = desk.bench.action("saveNewMap");
    QTRY_VERIFY(!save->isEnabled());
    QVERIFY2(save->toolTip().contains(QLatin1String("no new map")), qPrintable(save->toolTip()));
    desk.bench.robot->maps.entries[2].state = "finished";
    Q_EMIT desk.bench.robot->mapsChanged();
    QTRY_VERIFY(save->isEnabled());
  }

  void theMapThatWasSavedIsOfferedForLoading() {
    Desk desk;
    desk.bench.action("saveNewMap")->trigger();
    desk.controller().dialog()->nameEdit()->setText(QStringLiteral("Hall 3"));
    desk.controller().dialog()->acceptButton()->click();
    desk.bench.robot->maps.entries.push_back(test::catalogued("9", "Hall 3"));
    desk.maps.answer(test::catalogued("9", "Hall 3"));
    QTRY_VERIFY(!desk.controller().dialog());
    QTRY_COMPARE(part<MapsDock>(*desk.bench.window)->model()->maps(), 4);
    const auto buttons = desk.bench.window->findChild<ToastStack*>()->findChildren<QPushButton*>();
    const auto load = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
      return button->text().startsWith(QLatin1String("Load it now"));
    });
    QVERIFY(load != buttons.end());
    (*load)->click();
    QVERIFY(desk.controller().dialog());
    desk.controller().dialog()->acceptButton()->click();
    QVERIFY(desk.maps.orders.back().change == MapChange::Load);
    QCOMPARE(desk.maps.orders.back().key.id, std::string("9"));
  }

  void theMappingOfOneRobotIsNotInFrontForTheNext() {
    Desk desk;
    MappingDock* const dock = desk.controller().mappingDock();
    const auto in_front = [&] { return dock->isVisible() && !dock->visibleRegion().isEmpty(); };
    desk.maps.startMapping();
    Q_EMIT desk.bench.robot->mapsChanged();
    dock->raise();
    QTRY_VERIFY(in_front());
    desk.maps.obstacles = {{MapChange::StopMapping, Obstacle::NotMapping}};
    QVERIFY(!desk.bench.window->connectTo(QStringLiteral("axbot+http://192.0.2.8:8090")));
    QTRY_VERIFY(!in_front());
  }

  void aRobotThatCannotDoAnyOfItShowsNothingOfIt() {
    Bench bench;
    bench.offerMaps();
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(*bench.window)->model()->maps(), 3);
    QMenu menu;
    part<AdministrationController>(*bench.window)->fillMenu(&menu, {map::MapKind::Stored, "2"});
    QVERIFY(menu.isEmpty());
    QVERIFY(!bench.action("startMapping")->isVisible());
  }

  void givingUpWaitsForWhatBecameOfIt() {
    Desk desk;
    ChangeDialog* const dialog = desk.ask("2", "Load");
    QVERIFY(dialog);
    dialog->acceptButton()->click();
    dialog->reject();
    QCOMPARE(desk.maps.cancelled, 1);
    QCOMPARE(desk.controller().dialog(), dialog);
    desk.maps.answer(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Cancelled,
                                                      .applied = map::Applied::Maybe,
                                                      .asked_for = map::AskedFor::Change}));
    QVERIFY(dialog->errorShown().contains(QLatin1String("unknown")));
    dialog->reject();
    QTRY_VERIFY(!desk.controller().dialog());
  }

  void leavingTheRobotTakesTheQuestionAlong() {
    Desk desk;
    QVERIFY(desk.ask("2", "Load"));
    desk.bench.window->leaveRobot();
    QVERIFY(!desk.controller().dialog());
  }
};

}  // namespace test_window_administration

MAPWRIGHT_TEST(test_window_administration, TestWindowAdministration, Widgets)
#include "test_window_administration.moc"
