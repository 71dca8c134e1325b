// What the parts of the window share: places in menus and bars, docks, the notice above the map, the session.
#include <functional>
#include <utility>

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolBar>
#include <QtTest>

#include "test_program.h"
#include "ui/kit/actions.h"
#include "ui/kit/controller.h"
#include "ui/kit/panels.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"
#include "ui/shell/unsaved_changes.h"
#include "ui/view/notice_bar.h"
#include "window_bench.h"

namespace test_window_parts {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

/// The ids of what stands there, a line as "-", a widget or a submenu as "*".
QStringList idsOf(const QList<QAction*>& actions) {
  QStringList ids;
  for (const QAction* action : actions) {
    const bool is_line = action->isSeparator();
    ids << (is_line                          ? QStringLiteral("-")
            : action->objectName().isEmpty() ? QStringLiteral("*")
                                             : action->objectName());
  }
  return ids;
}

QStringList words(const char* text) { return QString::fromLatin1(text).split(QLatin1Char(' ')); }

QMenu* menuCalled(const QWidget& bar, const char* title) {
  for (const QAction* action : bar.actions()) {
    if (action->text() == QLatin1String(title)) return action->menu();
  }
  return nullptr;
}

/// A window with one dock a side, and what arranges them.
struct Docks {
  explicit Docks(const QStringList& names) {
    for (const QString& name : names) {
      auto* const dock = new QDockWidget(name, &window);
      dock->setObjectName(name);
      panels.add(dock, {.side = PanelPosition::Side::Left,
                        .tab = int(docks.size()),
                        .menu_rank = int(docks.size()) + 1,
                        .open = true});
      docks.push_back(dock);
    }
    panels.arrange();
    window.resize(800, 600);
    window.show();
  }
  QMainWindow window;
  Actions actions;
  Panels& panels = *new Panels(window, actions);
  std::vector<QDockWidget*> docks;
};

/// A controller that asks before it is left.
class Part : public Controller {
 public:
  bool unsaved() const override { return unsaved_; }
  void save() override { change(false); }
  void beforeLeaving(std::function<void()> then) override { agreed = std::move(then); }
  void change(bool unsaved) {
    if (std::exchange(unsaved_, unsaved) != unsaved) Q_EMIT unsavedChanged();
  }
  std::function<void()> agreed;

 private:
  bool unsaved_ = false;
};

bool inFront(const QDockWidget* dock) { return !dock->visibleRegion().isEmpty(); }

}  // namespace

class TestWindowParts : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void putsActionsWhereTheySayWheneverTheyCome() {
    Actions actions;
    actions.add({.id = "late", .text = QStringLiteral("Late"), .menu = {MenuGroup::Look, 20}});
    actions.add({.id = "helps", .text = QStringLiteral("Helps"), .menu = {MenuGroup::Finding, 10}});
    actions.add({.id = "first",
                 .text = QStringLiteral("First"),
                 .menu = {MenuGroup::Zoom, 10},
                 .bar = {BarGroup::Look, 20}});
    actions.add({.id = "early",
                 .text = QStringLiteral("Early"),
                 .menu = {MenuGroup::Look, 10},
                 .bar = {BarGroup::Robot, 10}});
    actions.add({.id = "nowhere", .text = QStringLiteral("Nowhere"), .bar = {BarGroup::Look, 10}});
    actions.add({.id = "also", .text = QStringLiteral("Also"), .menu = {MenuGroup::Look, 20}});
    QMainWindow window;
    fillMenuBar(*window.menuBar(), actions);
    QCOMPARE(window.menuBar()->actions().size(), 2);
    QCOMPARE(idsOf(menuCalled(*window.menuBar(), "&Map")->actions()), words("first - early late also"));
    QCOMPARE(idsOf(menuCalled(*window.menuBar(), "&Help")->actions()), words("helps"));
    QToolBar bar;
    fillToolBar(bar, actions);
    QCOMPARE(idsOf(bar.actions()), words("early - nowhere first"));
    QStringList listed;
    for (const Actions::Entry& entry : actions.entries()) listed << entry.action->objectName();
    QCOMPARE(listed, words("first early late also helps nowhere"));
  }

  void leavesNoLinesAroundWhatHasNothingToSay() {
    Actions actions;
    bool speaks = false;
    actions.addToMapMenu({MapMenuGroup::Submap, 10}, [&](QMenu& menu, const Eigen::Vector2d&) {
      if (speaks) menu.addAction(QStringLiteral("x"))->setObjectName(QStringLiteral("submap"));
    });
    actions.add({.id = "fit", .text = QStringLiteral("Fit"), .map_menu = {MapMenuGroup::Look, 10}});
    actions.add({.id = "copy", .text = QStringLiteral("Copy"), .map_menu = {MapMenuGroup::Copies, 10}});
    QMenu silent, full;
    fillMapMenu(silent, actions, {0, 0});
    QCOMPARE(idsOf(silent.actions()), words("copy - fit"));
    speaks = true;
    fillMapMenu(full, actions, {0, 0});
    QCOMPARE(idsOf(full.actions()), words("submap - copy - fit"));
  }

  void theMenusOfTheWindow() {
    Bench bench;
    const QMenuBar& bar = *bench.open().menuBar();
    QCOMPARE(idsOf(menuCalled(bar, "&Robot")->actions()).join(QLatin1Char(' ')),
             QStringLiteral(
                 "connect demo - retry disconnect robotLook record showRecordings rehearseWay * - "
                 "robotPose setPose startMapping extendMap stopMapping cancelMapping saveNewMap uploadMap "
                 "createMap"));
    QCOMPARE(idsOf(menuCalled(bar, "&File")->actions()).join(QLatin1Char(' ')),
             QStringLiteral("openFile * closeFile readAgain - export compareExpected - quit"));
    QCOMPARE(idsOf(menuCalled(bar, "&Edit")->actions()).join(QLatin1Char(' ')),
             QStringLiteral("undo redo - save - waypointTool * snap * * renameWaypoints duplicateWaypoints "
                            "selectAllWaypoints "
                            "invertWaypoints nextWarning revertWaypoints pictureTool pictureCopies "
                            "overlayTool * copyWaypoints pasteWaypoints "
                            "importWaypoints exportWaypoints referenceTool"));
    QCOMPARE(idsOf(menuCalled(bar, "&Map")->actions()).join(QLatin1Char(' ')),
             QStringLiteral("zoomIn zoomOut native fit - follow goTo identify - * - pan "
                            "measure cloudRegion cloudSection projections - "
                            "compare referenceMap alignMap mapProperties - * - "
                            "copyCoordinates "
                            "screenshotCopy screenshotSave"));
    QCOMPARE(idsOf(menuCalled(*menuCalled(bar, "&Map"), "Turn")->actions()),
             words("northUp robotTurn rotateLeft rotateRight"));
    QCOMPARE(idsOf(menuCalled(*menuCalled(bar, "&Map"), "Regions")->actions()),
             words("fetchRegion refreshRegions refreshRegionsEvery fetchWholeMap saveMapOnRobot"));
    QCOMPARE(idsOf(menuCalled(bar, "&View")->actions()).join(QLatin1Char(' ')),
             QStringLiteral("modeSubmaps modeWhole modeBoth - grid showIds showOutlines furniture "
                            "layerPresetsMenu - * * * * * - filter findObject focusMap nextPane previousPane "
                            "fullScreen resetLayout"));
    QCOMPARE(menuCalled(*menuCalled(bar, "&View"), "Panels")->actions().size(),
             bench.window->findChildren<QDockWidget*>().size());
    QCOMPARE(idsOf(menuCalled(*menuCalled(bar, "&View"), "Colours of submaps")->actions()),
             words("colorsNormal colorsIncremental colorsActive colorsTrajectory colorsAge colorsVersion"));
    QCOMPARE(idsOf(menuCalled(*menuCalled(bar, "&View"), "Theme")->actions()),
             words("themeLight themeDark themeSystem"));
    QCOMPARE(idsOf(menuCalled(*menuCalled(bar, "&View"), "Layout")->actions()),
             words("layoutOperate layoutInspect layoutReplay"));
    QCOMPARE(idsOf(menuCalled(bar, "&Help")->actions()).join(QLatin1Char(' ')),
             QStringLiteral("manual palette shortcuts - diagnostics copyDiagnostics about"));
  }

  void everyMenuFitsOnASmallScreen() {
    Bench bench;
    for (QMenu* menu : bench.open({1366, 768}).findChildren<QMenu*>())
      QVERIFY2(menu->sizeHint().height() <= 680,
               qPrintable(menu->title() + QString::number(menu->sizeHint().height())));
  }

  void theToolBarOfTheWindow() {
    Bench bench;
    const auto* const bar = bench.open().findChild<QToolBar*>(QStringLiteral("tools"));
    const auto shown = [&](const char* role) {
      bench.action(role)->trigger();
      return idsOf(bar->actions()).join(QLatin1Char(' '));
    };
    QCOMPARE(
        shown("layoutInspect"),
        QStringLiteral("* record - modeSubmaps modeWhole modeBoth compare - pan measure - fit native follow "
                       "northUp - grid showIds showOutlines - goTo screenshotSave * layoutOperate "
                       "layoutInspect layoutReplay - palette"));
    QCOMPARE(
        shown("layoutOperate"),
        QStringLiteral(
            "* record - pan measure waypointTool pictureTool overlayTool - undo redo save - fit follow - "
            "goTo * layoutOperate layoutInspect layoutReplay - palette"));
    QCOMPARE(
        shown("layoutReplay"),
        QStringLiteral("* - modeSubmaps modeWhole modeBoth - pan measure - fit follow - screenshotSave * "
                       "layoutOperate layoutInspect layoutReplay - palette"));
  }

  void showsTheLastTabOfASideFirst() {
    Docks docks(words("a b"));
    QTRY_VERIFY(inFront(docks.docks[1]));
    QVERIFY(!inFront(docks.docks[0]));
    docks.panels.suggest(docks.docks[0]);
    QTRY_VERIFY(inFront(docks.docks[0]));
  }

  void leavesTheTabsThatTheUserChose() {
    Docks docks(words("a b"));
    QTRY_VERIFY(inFront(docks.docks[1]));
    QVERIFY(docks.panels.restore(docks.panels.state()));
    docks.panels.suggest(docks.docks[0]);
    QVERIFY(inFront(docks.docks[1]));
    docks.panels.open(docks.docks[0]);  // asked for
    QTRY_VERIFY(inFront(docks.docks[0]));
  }

  void forcesNoLayoutUponOtherDocks() {
    const QByteArray of_two = Docks(words("a b")).panels.state();
    QVERIFY(Docks(words("a b")).panels.restore(of_two));
    Docks three(words("a b c"));
    QVERIFY(!three.panels.restore(of_two));
    QVERIFY(!three.panels.restored());
  }

  void theMapIsLeftWhenAllHaveAgreedOneAfterTheOther() {
    Part first, second;
    UnsavedChanges unsaved;
    unsaved.watch(&first);
    unsaved.watch(&second);
    int left = 0;
    unsaved.whenMayLeave([&] { ++left; });
    QVERIFY(first.agreed && !second.agreed);  // one question at a time
    first.agreed();
    QVERIFY(second.agreed);
    QCOMPARE(left, 0);
    second.agreed();
    QCOMPARE(left, 1);
  }

  void whatOneHasNotSavedIsUnsavedAndSaved() {
    Part first, second;
    UnsavedChanges unsaved;
    unsaved.watch(&first);
    unsaved.watch(&second);
    QSignalSpy changed(&unsaved, &UnsavedChanges::changed);
    QVERIFY(!unsaved.any());
    second.change(true);
    QVERIFY(unsaved.any());
    QCOMPARE(changed.size(), 1);
    unsaved.save();
    QVERIFY(!unsaved.any());
    QCOMPARE(changed.size(), 2);
  }

  void theFirstWhoHasSomethingToSayGetsTheNotice() {
    NoticeBar bar;
    Notices notices(&bar);
    int retried = 0, connected = 0;
    notices.set(NoticeRank::Map,
                {Mark::Bad, QStringLiteral("The map failed."), QStringLiteral("Retry"), [&] { ++retried; }});
    notices.set(NoticeRank::Link,
                {Mark::Warning, QStringLiteral("Lost."), QStringLiteral("Connect"), [&] { ++connected; }});
    QCOMPARE(bar.sentence(), QStringLiteral("Lost."));
    bar.offerButton()->click();
    notices.clear(NoticeRank::Link);
    QCOMPARE(bar.sentence(), QStringLiteral("The map failed."));
    QCOMPARE(bar.mark(), Mark::Bad);
    bar.offerButton()->click();
    QCOMPARE(connected, 1);
    QCOMPARE(retried, 1);
    notices.clear(NoticeRank::Map);
    QVERIFY(bar.isHidden());
  }

  void aNoticeThatWasClosedDoesNotComeAgain() {
    NoticeBar bar;
    Notices notices(&bar);
    const auto say = [&](const char* sentence) {
      notices.set(NoticeRank::Limits, {.sentence = QLatin1String(sentence), .closable = true});
    };
    say("Read only.");
    Q_EMIT bar.closed();
    QVERIFY(bar.isHidden());
    say("Read only.");
    QVERIFY(bar.isHidden());
    say("No pose.");
    QCOMPARE(bar.sentence(), QStringLiteral("No pose."));
  }

  void takesASessionAwayBeforeItEnds() {
    ui::scene::MapScene scene({});
    CurrentSession current(scene, {});
    QStringList told;
    QPointer<session::Session> last;
    connect(&current, &CurrentSession::changed, this, [&](session::Session* session) {
      told << (session ? QStringLiteral("came") : QStringLiteral("goes"));
      QCOMPARE(current.session(), session);
      if (session) {
        last = session;
      } else {
        QVERIFY(last);                    // can still be disconnected from
        QCOMPARE(scene.session(), last);  // and is on screen until everybody knows
      }
    });
    current.begin(std::make_unique<test::FakeRobot>(kAddress));
    QCOMPARE(scene.session(), current.session());
    QCOMPARE(current.address(), kAddress);
    current.begin(std::make_unique<test::FakeRobot>(QStringLiteral("demo:")));
    QCOMPARE(told, words("came goes came"));
    QCOMPARE(current.address(), QStringLiteral("demo:"));
    current.leave();
    QVERIFY(!last);
    QVERIFY(!scene.session());
    QCOMPARE(told, words("came goes came goes"));
  }

  void tellsOfTheStateOnlyOfThePresentSession() {
    ui::scene::MapScene scene({});
    CurrentSession current(scene, {});
    auto made = std::make_unique<test::FakeRobot>(kAddress);
    test::FakeRobot* const robot = made.get();
    current.begin(std::move(made));
    QSignalSpy spy(&current, &CurrentSession::stateChanged);
    robot->identify({QStringLiteral("x"), {}, QStringLiteral("name"), {}});
    QCOMPARE(spy.size(), 1);
    scene.setLayerVisible(ui::scene::Layer::Grid, !scene.layerVisible(ui::scene::Layer::Grid));
    QCOMPARE(spy.size(), 2);
    current.leave();
    QCOMPARE(spy.size(), 3);  // that it has gone, and nothing of its end
  }
};

}  // namespace test_window_parts

MAPWRIGHT_TEST(test_window_parts, TestWindowParts, Widgets)
#include "test_window_parts.moc"
