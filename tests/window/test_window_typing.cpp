// What is typed as the name or tag of a waypoint never becomes commands of the window, whatever happens
// between the click and the keys, or between two of them.
#include <functional>

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QtTest>

#include "test_program.h"
#include "ui/layers/layers_dock.h"
#include "ui/maps/maps_dock.h"
#include "ui/waypoints/waypoint_forms.h"
#include "waypoints_desk.h"

namespace test_window_typing {

using namespace mapwright;
using namespace mapwright::ui;
using test::waypoint;

namespace {

struct Desk : test::WaypointsDesk {
  /// What single keys change.
  auto state() {
    return std::tuple(window->mapScene()->view(), window->view()->tool(), window->view()->following(),
                      action("modeWhole")->isChecked(), action("grid")->isChecked());
  }
  /// As a hand does it: to whatever has the focus.
  static void type(const QString& text) {
    for (const QChar c : text) {
      QTest::keyClicks(QApplication::focusWidget(), c);
      QCoreApplication::processEvents();
    }
  }
  static void type(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
  /// A new one at (2, 2), whose name is asked for.
  void place() {
    start();
    bringUp();
    chooseTool();
    click(px(2, 2));
    QVERIFY(control().nameEditor()->hasFocus());
  }
  std::string nameNow() { return editing().only() ? editing().only()->name : std::string(); }
};

/// Everything that comes from elsewhere and was seen to open, raise or focus something.
const std::vector<std::pair<const char*, std::function<void(Desk&)>>>& disturbances() {
  static const std::vector<std::pair<const char*, std::function<void(Desk&)>>> all{
      {"nothing", [](Desk&) {}},
      {"the map takes the focus", [](Desk& desk) { desk.window->view()->setFocus(); }},
      {"a list takes the focus", [](Desk& desk) { desk.dock().table()->setFocus(); }},
      {"a button takes the focus", [](Desk& desk) { desk.dock().addButton()->setFocus(); }},
      {"the focus is taken away", [](Desk& desk) { desk.control().nameEditor()->clearFocus(); }},
      {"a panel comes to the front",
       [](Desk& desk) {
         auto* const dock = part<MapsDock>(*desk.window);
         dock->show();
         dock->raise();
       }},
      {"a panel closes", [](Desk& desk) { desk.dock().close(); }},
      {"a message",
       [](Desk& desk) {
         part<MapOverlay>(*desk.window)
             ->toasts()
             ->add(Mark::Bad, QStringLiteral("Something"), {QStringLiteral("Do it"), [] {}});
       }},
      {"a strip with buttons",
       [](Desk& desk) {
         desk.notice()->setNotice(Mark::Bad, QStringLiteral("Something"), QStringLiteral("Do it"));
       }},
      {"an alert of the robot",
       [](Desk& desk) {
         desk.robot->say(map::AlertsMessage{{{.code = 1, .level = map::AlertLevel::Error, .text = "Stuck"}}});
       }},
      {"the link goes and comes",
       [](Desk& desk) {
         desk.robot->goAway(QStringLiteral("no answer"));
         QCoreApplication::processEvents();
         desk.robot->goOnline();
       }},
      {"the link goes", [](Desk& desk) { desk.robot->goAway(QStringLiteral("no answer")); }},
      {"another operator renames one",
       [](Desk& desk) {
         desk.store.put(waypoint("b", 3, 2, "<b>Küche</b> 😀"));
         Q_EMIT desk.store.changed();
       }},
      {"another operator moves all",
       [](Desk& desk) {
         desk.store.put(waypoint("a", 1.5, 1, "Dock"));
         desk.store.put(waypoint("b", 3.5, 2, "Kitchen"));
         Q_EMIT desk.store.changed();
       }},
      {"another operator deletes all",
       [](Desk& desk) {
         desk.store.remove("a");
         desk.store.remove("b");
         Q_EMIT desk.store.changed();
       }},
      {"the store goes and comes",
       [](Desk& desk) {
         desk.robot->waypoint_store = nullptr;
         Q_EMIT desk.robot->capabilitiesChanged();
         desk.robot->waypoint_store = &desk.store;
         Q_EMIT desk.robot->capabilitiesChanged();
       }},
      {"the map is read again",
       [](Desk& desk) {
         desk.window->session()->openMap({map::MapKind::Stored, "1"});
       }},
      {"the window is laid out anew", [](Desk& desk) { desk.window->resize(1200, 700); }},
      {"another window has the focus for a while",
       [](Desk& desk) {
         QWidget other;
         other.show();
         other.activateWindow();
         (void)QTest::qWaitForWindowActive(&other);
         other.close();
         desk.window->activateWindow();
         (void)QTest::qWaitForWindowActive(desk.window.get());
       }},
  };
  return all;
}

}  // namespace

class TestWindowTyping : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aNameIsTypedToItsEndWhateverHappens_data() {
    QTest::addColumn<int>("what");
    QTest::addColumn<int>("after");
    for (std::size_t i = 0; i < disturbances().size(); ++i) {
      QTest::newRow(disturbances()[i].first) << int(i) << (i % 2 == 0 ? 3 : 0);
    }
  }
  void aNameIsTypedToItsEndWhateverHappens() {
    QFETCH(int, what);
    QFETCH(int, after);
    Desk desk;
    desk.place();
    const QString name = QStringLiteral("Corr 2");
    Desk::type(name.left(after));
    disturbances()[std::size_t(what)].second(desk);
    const auto before = desk.state();
    QTest::keyClicks(QApplication::focusWidget(), name.mid(after, 1));  // at once
    Desk::type(name.mid(after + 1));
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.control().nameEditor()));
    QCOMPARE(desk.nameNow(), std::string("Corr 2"));
    // The window may have been laid out meanwhile; no key turned, zoomed or switched anything.
    const auto now = desk.state();
    QCOMPARE(std::get<0>(now).scale_m_per_px, std::get<0>(before).scale_m_per_px);
    QCOMPARE(std::get<0>(now).rotation_rad, std::get<0>(before).rotation_rad);
    QVERIFY(std::get<1>(now) == std::get<1>(before) && std::get<2>(now) == std::get<2>(before));
    QVERIFY(std::get<3>(now) == std::get<3>(before) && std::get<4>(now) == std::get<4>(before));
    Desk::type(Qt::Key_Return);
    QVERIFY(!desk.control().nameEditor()->isVisible());
    QCOMPARE(desk.nameNow(), std::string("Corr 2"));
  }

  void whenItsListIsGoneTheRestOfTheNameGoesNowhere() {
    Desk desk;
    desk.place();
    Desk::type(QStringLiteral("Co"));
    // Another operator loads another map, and the robot's is what is shown.
    desk.window->session()->openMap({map::MapKind::Stored, "2"});
    QTRY_COMPARE(desk.window->session()->wholeMap().key().id, std::string("2"));
    QTRY_VERIFY(desk.window->session()->wholeMap().settled());
    QCoreApplication::processEvents();
    const auto before = desk.state();
    Desk::type(QStringLiteral("rr 2"));
    QVERIFY(desk.state() == before);
    Desk::type(Qt::Key_Return);
    QVERIFY(!desk.control().nameEditor()->isVisible());
    QTRY_VERIFY(desk.editing().document());
    for (const auto& [key, point] : desk.items()) QVERIFY(point.name == "Dock" || point.name == "Kitchen");
  }

  void aSecondClickGoesOnWithTheName_data() {
    QTest::addColumn<bool>("quick");
    QTest::addColumn<QString>("typed");
    for (const bool quick : {true, false}) {
      QTest::addRow("%s, nothing typed", quick ? "double click" : "click") << quick << QString();
      QTest::addRow("%s, half of it typed", quick ? "double click" : "click")
          << quick << QStringLiteral("Co");
    }
  }
  void aSecondClickGoesOnWithTheName() {
    QFETCH(bool, quick);
    QFETCH(QString, typed);
    Desk desk;
    desk.place();
    Desk::type(typed);
    const auto before = desk.state();
    const QPoint at = desk.px(2, 2);
    QWidget* const map = desk.window->view()->viewport();
    // The second press of a double click is no press of its own.
    quick ? QTest::mouseDClick(map, Qt::LeftButton, {}, at) : QTest::mousePress(map, Qt::LeftButton, {}, at);
    QTest::mouseRelease(map, Qt::LeftButton, {}, at);
    QCoreApplication::processEvents();
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.control().nameEditor()));
    Desk::type(QStringLiteral("Corr 2").mid(typed.size()));
    QCOMPARE(desk.nameNow(), std::string("Corr 2"));
    QVERIFY(desk.state() == before);
    QCOMPARE(desk.items().size(), std::size_t(3));
    QCOMPARE(desk.undo().count(), 1);
  }

  void aClickOfAnUnsteadyHandIsAClick() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    const geometry::ViewTransform view = desk.window->mapScene()->view();
    desk.press(desk.px(2, 2));
    desk.moveTo(desk.px(2, 2) + QPoint(5, 3));
    desk.release(desk.px(2, 2) + QPoint(5, 3));
    Desk::type(QStringLiteral("Corr 2"));
    QCOMPARE(desk.nameNow(), std::string("Corr 2"));
    QVERIFY(desk.window->mapScene()->view() == view);
  }

  void itIsDraggedWithoutLosingItsName() {
    Desk desk;
    desk.place();
    Desk::type(QStringLiteral("Co"));
    const QPoint field = desk.control().nameEditor()->pos();
    desk.drag(desk.px(2, 2), desk.px(2.5, 2.5));
    QCoreApplication::processEvents();
    QCOMPARE(desk.control().nameEditor()->pos(), field + QPoint(50, -50));
    Desk::type(QStringLiteral("rr 2"));
    QCOMPARE(desk.nameNow(), std::string("Corr 2"));
    QVERIFY(desk.near(*desk.editing().selected().begin(), 2.5, 2.5));
  }

  void keysThatMeanNothingInAFieldMeanNothing() {
    Desk desk;
    desk.place();
    for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp}) Desk::type(key);
    QVERIFY(desk.near(*desk.editing().selected().begin(), 2, 2));
    QVERIFY(desk.control().nameEditor()->hasFocus());
  }

  void whoeverGoesElsewhereHasNamedIt_data() {
    QTest::addColumn<int>("departure");
    QTest::newRow("a click beside it") << 0;
    QTest::newRow("a click on another") << 1;
    QTest::newRow("Tab") << 2;
    QTest::newRow("F6") << 3;
    QTest::newRow("a field of a panel") << 4;
    QTest::newRow("saving") << 5;
    QTest::newRow("a button") << 6;
  }
  void whoeverGoesElsewhereHasNamedIt() {
    QFETCH(int, departure);
    Desk desk;
    desk.place();
    const edit::Key key = *desk.editing().selected().begin();
    Desk::type(QStringLiteral("Corr 2"));
    if (departure == 0) desk.click(desk.px(1.5, 2.5));
    if (departure == 1) desk.click(desk.px(1, 1));
    if (departure == 2) Desk::type(Qt::Key_Tab);
    if (departure == 3) Desk::type(Qt::Key_F6);
    if (departure == 4) QTest::mouseClick(desk.dock().filterEdit(), Qt::LeftButton);
    if (departure == 5) desk.key(Qt::Key_S, Qt::ControlModifier);
    if (departure == 6) {
      // What it does takes the focus, as the tools and a menu's "Focus the map" do.
      auto* const button = new QPushButton(desk.window.get());
      button->setFocusPolicy(Qt::NoFocus);
      button->show();
      MapView* const map = desk.window->view();
      QObject::connect(button, &QPushButton::clicked, map, [map] { map->setFocus(); });
      QTest::mouseClick(button, Qt::LeftButton);
    }
    QCoreApplication::processEvents();
    QCOMPARE(desk.editing().find(key)->name, std::string("Corr 2"));
    // Where another has been made its own name is asked for.
    QCOMPARE(desk.control().nameEditor()->isVisible(), departure == 0);
    QVERIFY(departure != 4 || desk.dock().filterEdit()->hasFocus());
    if (departure == 1) QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"a"});
    QVERIFY(desk.near(key, 2, 2));
  }

  void aNameInTheFormIsTypedToItsEndWhateverHappens_data() {
    QTest::addColumn<int>("what");
    for (std::size_t i = 0; i < disturbances().size(); ++i) {
      const QByteArray name = disturbances()[i].first;
      // The user's own doing there, and these are shown by closing the panel itself.
      if (name.contains("takes the focus") || name.contains("taken away") || name.contains("panel")) continue;
      QTest::newRow(name.constData()) << int(i);
    }
  }
  void aNameInTheFormIsTypedToItsEndWhateverHappens() {
    QFETCH(int, what);
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a"});
    desk.dock().table()->setFocus();
    Desk::type(Qt::Key_F2);
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.dock().form()->nameEdit()));
    disturbances()[std::size_t(what)].second(desk);
    QTest::qWait(0);
    QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
    const auto before = desk.state();
    Desk::type(QStringLiteral("Corr 2"));
    QVERIFY(desk.state() == before);
    QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
  }

  void enterEndsTheNameInTheForm() {
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a"});
    desk.dock().table()->setFocus();
    Desk::type(Qt::Key_F2);
    Desk::type(QStringLiteral("CCC"));
    Desk::type(Qt::Key_Return);
    Desk::type(QStringLiteral("2"));
    QCOMPARE(desk.editing().find("a")->name, std::string("CCC"));
  }

  // A field that cuts a name off would cut it off on the robot with the next edit.
  void longNamesStayWholeAsTheyAreEdited_data() {
    QTest::addColumn<bool>("on_map");
    QTest::newRow("in the form") << false;
    QTest::newRow("on the map") << true;
  }
  void longNamesStayWholeAsTheyAreEdited() {
    QFETCH(bool, on_map);
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.store.put(waypoint("a", 1, 1, std::string(600, 'n') + "tail"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.editing().find("a")->name.size(), std::size_t(604));
    desk.editing().select({"a"});
    if (on_map) {
      desk.control().nameEditor()->ask(desk.px(1, 1), QString::fromStdString(desk.nameNow()),
                                       [&](const QString& name) { desk.editing().rename("a", name); });
    } else {
      desk.dock().table()->setFocus();
      Desk::type(Qt::Key_F2);
    }
    auto* const field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    QVERIFY(field);
    field->setCursorPosition(0);
    Desk::type(Qt::Key_Delete);
    Desk::type(QStringLiteral("N"));
    Desk::type(Qt::Key_Return);
    QCOMPARE(desk.editing().find("a")->name, "N" + std::string(599, 'n') + "tail");
  }

  void whatDoesNotFitIntoAFieldIsSaid() {
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a"});
    desk.dock().table()->setFocus();
    Desk::type(Qt::Key_F2);
    auto* const field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    QVERIFY(field);
    QGuiApplication::clipboard()->setText(QString(700, QLatin1Char('p')));
    field->selectAll();
    field->paste();
    QCOMPARE(field->text().size(), 500);
    const auto* const note = desk.window->findChild<QLabel*>(QStringLiteral("outOfRange"));
    QVERIFY(note && note->isVisible());
    QCOMPARE(note->text(), QStringLiteral("Only 500 letters fit. The rest was left out."));
  }

  void whoseWaypointIsDeletedElsewhereTypesIntoNothing() {
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a"});
    QLineEdit* const field = desk.dock().form()->nameEdit();
    field->setFocus();
    desk.store.remove("a");
    Q_EMIT desk.store.changed();
    QTRY_VERIFY(!desk.editing().find("a"));
    const auto before = desk.state();
    Desk::type(QStringLiteral("Corr 2"));
    QVERIFY(desk.state() == before);
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(field));
    QCOMPARE(desk.editing().find("b")->name, std::string("Kitchen"));
    desk.window->view()->setFocus();
    QVERIFY(!desk.dock().form()->isEnabled());
    // The next one has its own name there.
    desk.editing().select({"b"});
    QCOMPARE(field->text(), QStringLiteral("Kitchen"));
  }

  void whatIsTypedIsAboutTheOneThatWasSelected() {
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a"});
    desk.dock().form()->nameEdit()->setFocus();
    desk.dock().form()->nameEdit()->selectAll();
    Desk::type(QStringLiteral("Corr"));
    desk.editing().select({"b"});  // "Next warning" (F8) does it with the focus in the field
    QCOMPARE(desk.dock().form()->nameEdit()->text(), QStringLiteral("Kitchen"));
    QCOMPARE(desk.editing().find("a")->name, std::string("Corr"));
    QLineEdit* const tags = desk.dock().form()->tagsEdit();
    tags->setFocus();
    Desk::type(QStringLiteral("charger"));
    desk.editing().select({"a"});
    QCOMPARE(desk.editing().find("b")->tags, std::vector<std::string>{"charger"});
    QVERIFY(desk.editing().find("a")->tags.empty());
    QVERIFY(tags->text().isEmpty());
  }

  void tagsOfSeveralAreTypedToTheirEnd() {
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a", "b"});
    QLineEdit* const tags = desk.dock().groupForm()->addTagsEdit();
    tags->setFocus();
    Desk::type(QStringLiteral("fr"));
    desk.store.remove("b");
    Q_EMIT desk.store.changed();
    QTRY_VERIFY(!desk.editing().find("b"));
    const auto before = desk.state();
    Desk::type(QStringLiteral("fog"));
    QVERIFY(desk.state() == before);
    QCOMPARE(tags->text(), QStringLiteral("frfog"));
    desk.window->view()->setFocus();
    QVERIFY(!desk.dock().groupForm()->isVisible());
    QVERIFY(desk.dock().form()->isVisible());
  }

  void theMapHasTheFocusWhenWhatHadItIsGone_data() {
    QTest::addColumn<QByteArray>("how");
    for (const char* how : {"disabled", "deleted", "disabled behind a dialog"})
      QTest::newRow(how) << QByteArray(how);
  }
  void theMapHasTheFocusWhenWhatHadItIsGone() {
    QFETCH(QByteArray, how);
    test::Bench bench;
    MainWindow& window = bench.open();
    auto* const panel = new QDockWidget(&window);
    auto* const body = new QWidget(panel);
    auto* const column = new QVBoxLayout(body);
    auto* const send = new QPushButton(QStringLiteral("Send"), body);
    column->addWidget(send);
    column->addWidget(new QLineEdit(body));
    panel->setWidget(body);
    window.addDockWidget(Qt::RightDockWidgetArea, panel);
    send->setFocus();
    QTRY_COMPARE(QApplication::focusWidget(), send);
    if (how == "disabled") send->setEnabled(false);
    if (how == "deleted") delete send;
    if (how == "disabled behind a dialog") {
      QDialog dialog(&window);
      dialog.show();
      QVERIFY(QTest::qWaitForWindowActive(&dialog));
      send->setEnabled(false);
      dialog.close();
      QVERIFY(QTest::qWaitForWindowActive(&window));
    }
    QTRY_COMPARE(QApplication::focusWidget(), static_cast<QWidget*>(window.view()));
  }
};

}  // namespace test_window_typing

MAPWRIGHT_TEST(test_window_typing, TestWindowTyping, Widgets)
#include "test_window_typing.moc"
