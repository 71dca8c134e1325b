// Review and send: the calls before they are sent, what becomes of each, the rest once more, and how what is
// kept compares in the end.
#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QTableView>
#include <QtTest>

#include "test_program.h"
#include "ui/maps/maps_controller.h"
#include "ui/waypoints/waypoint_conflicts.h"
#include "ui/waypoints/waypoint_review.h"
#include "ui/waypoints/waypoint_text.h"
#include "waypoints_desk.h"
#include "window_parts.h"

namespace test_window_waypoints_review {

using namespace mapwright;
using namespace mapwright::ui;
using test::FakeWaypointStore;
using test::waypoint;

namespace {

/// A robot that is called for every change; a, b and c are changed.
struct Desk : test::WaypointsDesk {
  Desk() : WaypointsDesk(FakeWaypointStore::Mode::OneByOne) {
    store.is_called = true;
    store.points = {waypoint("a", 1, 1, "Dock"), waypoint("b", 3, 2, "Kitchen"), waypoint("c", 2, 2, "Gate")};
  }
  void change() {
    start();
    bringUp();
    editing().select({"a", "b", "c"});
    editing().moveSelected({0.25, 0});
  }
  WaypointReview& review() { return *control().review(); }
  QString cell(int row, int column) { return review().model()->index(row, column).data().toString(); }
  QString outcome(int row) { return cell(row, ReviewModel::OutcomeColumn); }
  void open() {
    action("save")->trigger();
    QVERIFY(review().isVisible());
  }
  void send() { QTest::mouseClick(review().sendButton(), Qt::LeftButton); }
  static map::Failure failure(map::FailureKind kind, map::Applied applied) {
    map::Failure made{kind};
    made.applied = applied;
    made.asked_for = map::AskedFor::Change;
    return made;
  }
  /// The second request ends so.
  void failSecond(const map::Failure& how) {
    store.before_performing = [this, how] {
      if (store.asked.size() == 2) store.failures.push_back(how);
    };
  }
};

}  // namespace

class TestWindowWaypointsReview : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nothingIsSentBeforeItIsLookedAt() {
    Desk desk;
    desk.change();
    desk.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(desk.review().isVisible());
    QVERIFY(desk.store.asked.empty());
    QCOMPARE(desk.review().model()->rowCount(), 3);
    QCOMPARE(desk.cell(0, ReviewModel::CallColumn), QStringLiteral("change"));
    QCOMPARE(desk.cell(1, ReviewModel::DeedColumn), QStringLiteral("Move Kitchen by 0.25 m"));
    QCOMPARE(desk.cell(1, ReviewModel::ChangeColumn),
             QStringLiteral("position 3.000, 2.000 m → position 3.250, 2.000 m"));
    QVERIFY(desk.review().statusShown().contains(QLatin1String("Nothing has been sent yet")));
    QVERIFY(!desk.review().isModal());
  }

  void aNewOneThatCannotBeDeletedLaterSaysSo() {
    Desk desk;
    desk.store.kept_fields.removal = false;
    desk.start();
    desk.bringUp();
    desk.editing().add({2, 1});
    desk.open();
    QCOMPARE(desk.outcome(0), QStringLiteral("cannot be deleted later"));
  }

  void whatCouldNotBeLookedUpStandsThereStill() {
    Desk desk;
    desk.change();
    desk.key(Qt::Key_S, Qt::ControlModifier);
    desk.store.unreadable = true;
    desk.send();
    QTRY_VERIFY(desk.review().statusShown().endsWith(QLatin1String("Nothing was sent.")));
    QCOMPARE(desk.review().model()->rowCount(), 3);
    QVERIFY(desk.store.asked.empty());
    QVERIFY(!desk.review().statusShown().startsWith(QLatin1String("Nothing")));  // it says why
    desk.store.unreadable = false;
    desk.send();
    QTRY_COMPARE(desk.store.asked.size(), 3u);
  }

  void whatIsNotSavedStaysWhenItsStoreGoes() {
    Desk desk;
    desk.change();
    desk.open();
    desk.robot->waypoint_store = nullptr;
    Q_EMIT desk.robot->capabilitiesChanged();
    QVERIFY(desk.control().unsaved());
    QVERIFY(desk.review().isVisible());
    QVERIFY(desk.near("a", 1.25, 1));
    QVERIFY(desk.undo().canUndo());
    desk.robot->waypoint_store = &desk.store;
    Q_EMIT desk.robot->capabilitiesChanged();
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QTRY_VERIFY(desk.review().comparedShown().contains(QLatin1String("as intended")));
    // Of what is saved nothing is lost: it is as the robot says.
    desk.robot->waypoint_store = nullptr;
    Q_EMIT desk.robot->capabilitiesChanged();
    QVERIFY(!desk.review().isVisible());
  }

  void aFileIsSavedWithoutIt() {
    Desk desk;
    desk.store.is_called = false;
    desk.change();
    desk.key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(!desk.control().unsaved());
    QVERIFY(!desk.review().isVisible());
  }

  void eachRowSaysWhatBecameOfItAndTheEndCompares() {
    Desk desk;
    desk.change();
    desk.open();
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QTRY_VERIFY2(desk.review().comparedShown().contains(QLatin1String("all 3 as intended.")),
                 qPrintable(desk.review().comparedShown()));
    for (int row = 0; row < 3; ++row) QCOMPARE(desk.outcome(row), QStringLiteral("done"));
    QVERIFY(!desk.review().sendButton()->isEnabled());
    QCOMPARE(desk.store.find("Gate")->position_m.x(), 2.25);
  }

  void whoeverGoesOnEditingSeesWhatItTakesThen() {
    Desk desk;
    desk.change();
    desk.open();
    desk.undo().undo();
    QTRY_COMPARE(desk.review().model()->rowCount(), 0);
    QVERIFY(!desk.review().sendButton()->isEnabled());
    desk.undo().redo();
    QTRY_COMPARE(desk.review().model()->rowCount(), 3);
  }

  void aFailureStopsItAndTheRestIsSentOnRequest() {
    Desk desk;
    desk.change();
    desk.failSecond(Desk::failure(map::FailureKind::RejectedByRobot, map::Applied::No));
    desk.open();
    desk.send();
    QTRY_COMPARE(desk.outcome(2), QStringLiteral("not sent"));
    QTRY_VERIFY(!desk.control().list()->saving());
    QCOMPARE(desk.outcome(0), QStringLiteral("done"));
    QVERIFY2(desk.review().statusShown().contains(
                 QLatin1String("Of 3 requests: 1 succeeded, 1 failed, 0 with unknown result, 1 not sent.")),
             qPrintable(desk.review().statusShown()));
    QVERIFY(desk.review().comparedShown().contains(QLatin1String("1 as intended, 2 differ: Kitchen, Gate")));
    QVERIFY(desk.control().unsaved());
    QCOMPARE(desk.review().sendButton()->text(), QStringLiteral("&Send the rest"));
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QCOMPARE(desk.store.asked.size(), std::size_t(4));  // none twice that was done
    QTRY_VERIFY(desk.review().comparedShown().contains(QLatin1String("all 3 as intended.")));
  }

  void theRestIsShownAnewWhereItTakesOtherCallsNow() {
    Desk desk;
    desk.change();
    desk.failSecond(Desk::failure(map::FailureKind::RejectedByRobot, map::Applied::No));
    desk.open();
    desk.send();
    QTRY_COMPARE(desk.outcome(2), QStringLiteral("not sent"));
    QTRY_VERIFY(!desk.control().list()->saving());
    // Another operator renames one that is left.
    desk.store.put(waypoint("c", 2, 2, "Gate north"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.editing().find("c")->name, std::string("Gate north"));
    desk.send();
    QTRY_COMPARE(desk.review().model()->rowCount(), 2);
    QVERIFY2(desk.review().statusShown().contains(QLatin1String("the list has changed in the meantime")),
             qPrintable(desk.review().statusShown()));
    QCOMPARE(desk.store.asked.size(), std::size_t(2));
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QCOMPARE(desk.store.find("Gate north")->position_m.x(), 2.25);
  }

  void whatTheRobotStalledBeforeWasNotSent() {
    Desk desk;
    desk.change();
    desk.failSecond(Desk::failure(map::FailureKind::TimedOut, map::Applied::No));
    desk.open();
    desk.send();
    QTRY_VERIFY2(desk.outcome(1).startsWith(QLatin1String("not sent. ")), qPrintable(desk.outcome(1)));
    QTRY_VERIFY2(desk.review().statusShown().contains(QLatin1String(
                     "Of 3 requests: 1 succeeded, 0 failed, 0 with unknown result, 2 not sent.")),
                 qPrintable(desk.review().statusShown()));
  }

  void itGoesOnWhereThatWasChosen() {
    Desk desk;
    desk.change();
    desk.failSecond(Desk::failure(map::FailureKind::RejectedByRobot, map::Applied::No));
    desk.open();
    desk.review().goOnBox()->setChecked(true);
    desk.send();
    QTRY_COMPARE(desk.store.asked.size(), std::size_t(3));
    QTRY_VERIFY(desk.review().comparedShown().contains(QLatin1String("2 as intended, 1 differ: Kitchen")));
    QCOMPARE(desk.outcome(2), QStringLiteral("done"));
    QCOMPARE(desk.editing().document()->unsaved(), (std::set<edit::Key>{"b"}));
  }

  void aLostLinkLeavesNoDoubt_data() {
    QTest::addColumn<bool>("arrives");
    QTest::newRow("the robot has made the change") << true;
    QTest::newRow("it has not") << false;
  }
  void aLostLinkLeavesNoDoubt() {
    QFETCH(bool, arrives);
    Desk desk;
    desk.change();
    desk.store.before_performing = [&] {
      if (desk.store.asked.size() != 2) return;
      desk.store.unreadable = true;  // the link is gone, and with it the look at the end
      desk.store.failures.push_back(Desk::failure(map::FailureKind::Unreachable, map::Applied::Maybe));
    };
    desk.open();
    desk.review().goOnBox()->setChecked(true);  // a lost link stops it all the same
    desk.send();
    QTRY_COMPARE(desk.outcome(1), QStringLiteral("unknown. The connection was lost."));
    QVERIFY(desk.review()
                .model()
                ->index(1, ReviewModel::OutcomeColumn)
                .data(Qt::ToolTipRole)
                .toString()
                .contains(QLatin1String("Whether it was changed is unknown")));
    QTRY_VERIFY(desk.review().comparedShown().startsWith(QLatin1String("Not compared")));
    QVERIFY(desk.review().comparedShown().contains(QLatin1String("as soon as the connection is back")));
    QCOMPARE(desk.outcome(2), QStringLiteral("not sent"));
    // Nowhere is what was carried out, or may have been, said to be as it was.
    const QString unchanged = QStringLiteral("not changed");
    for (const QString& text :
         {desk.outcome(0), desk.outcome(1), desk.review().statusShown(), desk.dock().statusShown()})
      QVERIFY2(!text.contains(unchanged), qPrintable(text));
    QVERIFY2(desk.review().statusShown().startsWith(QLatin1String("The connection was lost.")),
             qPrintable(desk.review().statusShown()));
    QVERIFY2(desk.dock().statusShown().contains(
                 QLatin1String("Not everything was saved: 1 of 3 requests succeeded, the result of 1 is "
                               "unknown. The connection was lost.")),
             qPrintable(desk.dock().statusShown()));
    QVERIFY(desk.dock().statusIsBad());
    // Who tries again before the link is back has lost sight of none of them.
    desk.send();
    QTRY_COMPARE(desk.control().list()->submission().phase(), edit::SubmissionPhase::Stopped);
    QCOMPARE(desk.review().model()->rowCount(), 3);
    QVERIFY2(desk.review().statusShown().contains(
                 QLatin1String("Of 3 requests: 1 succeeded, 0 failed, 1 with unknown result, 1 not sent.")),
             qPrintable(desk.review().statusShown()));
    if (!arrives) desk.store.put(waypoint("b", 3, 2, "Kitchen"));
    desk.store.unreadable = false;
    Q_EMIT desk.store.changed();
    // What is not to be seen there yet may come still.
    QTRY_VERIFY2(desk.review().comparedShown().contains(arrives ? QLatin1String("2 as intended, 1 differ")
                                                                : QLatin1String("1 as intended, 2 differ")),
                 qPrintable(desk.review().comparedShown()));
    QCOMPARE(desk.outcome(1), arrives ? QStringLiteral("done, answer lost")
                                      : QStringLiteral("unknown. The connection was lost."));
    // The link is back: what it did to the others is over.
    QVERIFY2(desk.review().statusShown().startsWith(QLatin1String("Of 3 requests")),
             qPrintable(desk.review().statusShown()));
    QVERIFY2(!desk.dock().statusShown().contains(QLatin1String("saved:")),
             qPrintable(desk.dock().statusShown()));
    QVERIFY(!desk.dock().statusIsBad());
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QCOMPARE(desk.store.asked.size(), std::size_t(arrives ? 3 : 4));
    QCOMPARE(desk.store.find("Kitchen")->position_m.x(), 3.25);
    QTRY_VERIFY(desk.review().comparedShown().contains(QLatin1String("all 3 as intended.")));
  }

  void whatOthersChangedMeanwhileIsMergedAndOnlyWhatWasReviewedIsSent() {
    Desk desk;
    desk.change();
    desk.open();
    // Another operator renames one: what is to be sent of it is another call now.
    desk.store.put(waypoint("c", 2, 2, "Gate north"));
    desk.send();
    QTRY_VERIFY2(desk.review().statusShown().contains(QLatin1String("the list has changed in the meantime")),
                 qPrintable(desk.review().statusShown()));
    QVERIFY(desk.store.asked.empty());
    QCOMPARE(desk.cell(2, ReviewModel::DeedColumn), QStringLiteral("Move Gate north by 0.25 m"));
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QCOMPARE(desk.store.find("Gate north")->position_m.x(), 2.25);
  }

  void aConflictIsDecidedFirst() {
    Desk desk;
    desk.change();
    desk.open();
    desk.store.put(waypoint("c", 9, 9, "Gate"));
    desk.send();
    QTRY_VERIFY2(desk.review().statusShown().contains(QLatin1String("changed here and elsewhere")),
                 qPrintable(desk.review().statusShown()));
    QVERIFY(desk.store.asked.empty());
    QVERIFY(!desk.review().sendButton()->isEnabled());
    QTest::mouseClick(desk.dock().conflicts()->mineButton(), Qt::LeftButton);
    QTRY_VERIFY(desk.review().sendButton()->isEnabled());
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QCOMPARE(desk.store.find("Gate")->position_m.x(), 2.25);
  }

  void cancellingSaysWhatWasSent() {
    Desk desk;
    desk.change();
    desk.store.before_performing = [&] { desk.store.hold = desk.store.asked.size() == 2; };
    desk.open();
    desk.send();
    QTRY_COMPARE(desk.outcome(1), QStringLiteral("in progress…"));
    QTest::mouseClick(desk.review().cancelButton(), Qt::LeftButton);
    QTRY_COMPARE(desk.outcome(2), QStringLiteral("not sent"));
    QTRY_VERIFY(desk.review().comparedShown().contains(QLatin1String("1 as intended, 2 differ")));
  }

  void leavingSavesThroughIt() {
    Desk desk;
    desk.change();
    part<MapsController>(*desk.window)->open({map::MapKind::Stored, "2"});
    desk.answer(QMessageBox::Save);
    QTRY_VERIFY(desk.review().isVisible());
    QVERIFY(desk.window->session()->wholeMap().key().id != "2");
    desk.send();
    QTRY_COMPARE(desk.window->session()->wholeMap().key().id, std::string("2"));
    QTRY_VERIFY(!desk.review().isVisible());
  }

  void whoClosesItStays() {
    Desk desk;
    desk.change();
    part<MapsController>(*desk.window)->open({map::MapKind::Stored, "2"});
    desk.answer(QMessageBox::Save);
    QTRY_VERIFY(desk.review().isVisible());
    desk.review().close();
    desk.open();
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
    QCoreApplication::processEvents();
    QVERIFY(desk.window->session()->wholeMap().key().id != "2");
  }

  void enterSendsWhereverTheFocusIs_data() {
    QTest::addColumn<QString>("focus");
    for (const char* focus : {"send", "close", "go on", "table"})
      QTest::newRow(focus) << QString::fromLatin1(focus);
  }
  void enterSendsWhereverTheFocusIs() {
    QFETCH(QString, focus);
    Desk desk;
    desk.change();
    desk.store.before_performing = [&] { desk.store.hold = true; };
    desk.open();
    desk.review().activateWindow();
    QTRY_VERIFY(desk.review().isActiveWindow());
    const std::map<QString, QWidget*> widgets{
        {QStringLiteral("send"), desk.review().sendButton()},
        {QStringLiteral("close"), desk.review().closeButton()},
        {QStringLiteral("go on"), desk.review().goOnBox()},
        {QStringLiteral("table"), desk.review().findChild<QTableView*>()}};
    QWidget* const widget = widgets.at(focus);
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_Return);
    QTRY_COMPARE(desk.store.asked.size(), std::size_t(1));
    QVERIFY(desk.review().isVisible());
    // Once more, and Space: what is in progress is not cancelled by a button that the focus has hopped to.
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space})
      QTest::keyClick(desk.review().focusWidget() ? desk.review().focusWidget() : &desk.review(), key);
    QCOMPARE(desk.outcome(0), QStringLiteral("in progress…"));
    QTest::mouseClick(desk.review().cancelButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.control().list()->saving());
    // Nor is it closed.
    desk.store.before_performing = [&] { desk.store.hold = false; };
    desk.store.hold = false;
    QTest::keyClick(desk.review().focusWidget() ? desk.review().focusWidget() : &desk.review(),
                    Qt::Key_Return);
    QTRY_VERIFY(!desk.control().unsaved());
    QTest::keyClick(desk.review().focusWidget() ? desk.review().focusWidget() : &desk.review(),
                    Qt::Key_Return);
    QVERIFY(desk.review().isVisible());
  }

  void aNameTwiceIsSaidBeforeAndNotSent() {
    Desk desk;
    desk.store.kept_fields.name_twice = false;
    desk.change();
    desk.editing().rename("b", QStringLiteral("Gate"));
    desk.open();
    QCOMPARE(desk.review().model()->requests(), 2);
    QVERIFY2(desk.review().statusShown().contains(
                 QLatin1String("1 waypoint is not sent: the robot does not allow duplicate names (Gate).")),
             qPrintable(desk.review().statusShown()));
    // It has its row, below those that are sent.
    QCOMPARE(desk.review().model()->rowCount(), 3);
    QCOMPARE(desk.cell(2, ReviewModel::DeedColumn),
             QStringLiteral("Rename Kitchen to Gate, move it by 0.25 m"));
    QCOMPARE(desk.outcome(2), QStringLiteral("not sent: another waypoint is called Gate"));
    QVERIFY(desk.cell(2, ReviewModel::NumberColumn).isEmpty());
    desk.send();
    QTRY_COMPARE(desk.store.asked.size(), std::size_t(2));
    QTRY_VERIFY2(desk.review().statusShown().contains(QLatin1String("1 waypoint is not sent")),
                 qPrintable(desk.review().statusShown()));
    QVERIFY(desk.control().unsaved());
    // Another name, and it goes.
    desk.editing().rename("b", QStringLiteral("Gate 2"));
    desk.open();
    QTRY_COMPARE(desk.review().model()->rowCount(), 1);
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
  }

  void whatIsRefusedAfterALostLinkHasOneRow() {
    Desk desk;
    desk.store.kept_fields.name_twice = false;
    desk.change();
    desk.editing().rename("c", QStringLiteral("Gate 2"));
    desk.failSecond(Desk::failure(map::FailureKind::Unreachable, map::Applied::No));
    desk.open();
    desk.send();
    QTRY_COMPARE(desk.outcome(2), QStringLiteral("not sent"));
    QCOMPARE(desk.review().model()->rowCount(), 3);
    // Somebody else takes the name meanwhile.
    desk.store.put(waypoint("d", 1, 2, "Gate 2"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.outcome(2), QStringLiteral("not sent: another waypoint is called Gate 2"));
    QCOMPARE(desk.review().model()->rowCount(), 3);
  }

  void whoLeavesIsNotLetGoWhileANameTwiceIsLeft() {
    Desk desk;
    desk.store.kept_fields.name_twice = false;
    desk.change();
    desk.editing().rename("b", QStringLiteral("Gate"));
    part<MapsController>(*desk.window)->open({map::MapKind::Stored, "2"});
    desk.answer(QMessageBox::Save);
    QTRY_VERIFY(desk.review().isVisible());
    desk.send();
    QTRY_COMPARE(desk.store.asked.size(), std::size_t(2));
    QTRY_VERIFY(desk.review().statusShown().contains(QLatin1String("1 waypoint is not sent")));
    QCoreApplication::processEvents();
    QVERIFY(desk.window->session()->wholeMap().key().id != "2");
  }

  void nothingChangesUnderTheFocus() {
    Desk desk;
    desk.change();
    desk.store.before_performing = [&] { desk.store.hold = desk.store.asked.size() == 2; };
    desk.open();
    desk.review().activateWindow();
    QTRY_VERIFY(desk.review().isActiveWindow());
    auto* const table = desk.review().findChild<QTableView*>();
    table->selectRow(2);
    QPushButton* const send = desk.review().sendButton();
    send->setFocus();
    QTest::keyClick(send, Qt::Key_Return);
    QTRY_COMPARE(desk.outcome(1), QStringLiteral("in progress…"));
    // The button has become no other one, and a second press of it does nothing.
    QVERIFY(send->isVisible() && send->hasFocus() && send->isDefault());
    QTest::keyClick(send, Qt::Key_Space);
    QCOMPARE(table->currentIndex().row(), 2);
    QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
    QTest::mouseClick(desk.review().cancelButton(), Qt::LeftButton);
    QTRY_COMPARE(desk.outcome(2), QStringLiteral("not sent"));
    QTRY_VERIFY(!desk.control().list()->saving());
    QCOMPARE(table->currentIndex().row(), 2);
    QVERIFY(send->isDefault());
    desk.store.before_performing = [&] { desk.store.hold = false; };
    desk.store.hold = false;
    QTest::keyClick(desk.review().focusWidget(), Qt::Key_Return);
    QTRY_VERIFY(!desk.control().unsaved());
    QCOMPARE(table->currentIndex().row(), 2);
  }

  void whatChangesMeanwhileLeavesTheCurrentRow() {
    Desk desk;
    desk.change();
    desk.open();
    auto* const table = desk.review().findChild<QTableView*>();
    table->selectRow(1);
    desk.editing().add({1, 2});
    QTRY_COMPARE(desk.review().model()->rowCount(), 4);
    QCOMPARE(table->currentIndex().row(), 1);
    QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
  }

  void withoutALinkNothingIsSent() {
    Desk desk;
    desk.change();
    desk.open();
    desk.review().activateWindow();
    QTRY_VERIFY(desk.review().isActiveWindow());
    QPushButton* const send = desk.review().sendButton();
    send->setFocus();
    desk.robot->goAway(QStringLiteral("The cable is out."));
    QVERIFY(!send->isEnabled());
    QVERIFY2(desk.review().statusShown().contains(QLatin1String("There is no connection to the robot")),
             qPrintable(desk.review().statusShown()));
    QVERIFY(desk.review().statusShown().contains(QLatin1String("The cable is out.")));
    QVERIFY(send->toolTip().contains(QLatin1String("no connection")));
    QTest::keyClick(desk.review().focusWidget(), Qt::Key_Return);
    QTest::keyClick(desk.review().focusWidget(), Qt::Key_Space);
    QVERIFY(desk.store.asked.empty());
    QVERIFY(desk.review().isVisible());
    desk.robot->goOnline();
    QVERIFY(send->isEnabled());
    QVERIFY(!desk.review().statusShown().contains(QLatin1String("no connection")));
    QTest::keyClick(desk.review().focusWidget(), Qt::Key_Return);
    QTRY_COMPARE(desk.store.asked.size(), std::size_t(3));
  }

  void theLinkGoesWhileItIsSent() {
    Desk desk;
    desk.change();
    desk.store.before_performing = [&] {
      if (desk.store.asked.size() != 2) return;
      desk.store.unreadable = true;
      desk.store.failures.push_back(Desk::failure(map::FailureKind::Unreachable, map::Applied::Maybe));
      desk.robot->goAway(QStringLiteral("no answer"));
    };
    desk.open();
    desk.send();
    QTRY_COMPARE(desk.outcome(2), QStringLiteral("not sent"));
    QTRY_VERIFY(!desk.control().list()->saving());
    QVERIFY(!desk.review().sendButton()->isEnabled());
    desk.store.unreadable = false;
    desk.robot->goOnline();
    Q_EMIT desk.store.changed();
    QTRY_VERIFY(desk.review().comparedShown().contains(QLatin1String("as intended")));
    QVERIFY(desk.review().sendButton()->isEnabled());
    desk.send();
    QTRY_VERIFY(!desk.control().unsaved());
  }

  void eachRequestIsSaidInWords() {
    map::Waypoint dock = waypoint("a", 1, 1, "Dock");
    const auto deed = [&](auto change) {
      map::Waypoint to = dock;
      change(to);
      return deedText(dock, to);
    };
    QCOMPARE(deedText(std::nullopt, dock), QStringLiteral("Create Dock"));
    QCOMPARE(deedText(dock, std::nullopt), QStringLiteral("Delete Dock"));
    QCOMPARE(deed([](map::Waypoint& to) { to.name = "Kitchen"; }), QStringLiteral("Rename Dock to Kitchen"));
    QCOMPARE(deed([](map::Waypoint& to) { to.position_m += Eigen::Vector2d(0.3, 0.4); }),
             QStringLiteral("Move Dock by 0.50 m"));
    QCOMPARE(deed([](map::Waypoint& to) { to.position_m.x() += 0.004; }),
             QStringLiteral("Move Dock by 0.004 m"));
    QCOMPARE(deed([](map::Waypoint& to) { to.yaw_rad = 1.5707963; }), QStringLiteral("Turn Dock to 90.0°"));
    dock.yaw_rad = 0;
    QCOMPARE(deed([](map::Waypoint& to) { to.yaw_rad = -1.5707963; }), QStringLiteral("Turn Dock by -90.0°"));
    QCOMPARE(deed([](map::Waypoint& to) { to.yaw_rad.reset(); }),
             QStringLiteral("Remove the heading of Dock"));
    QCOMPARE(deed([](map::Waypoint& to) { to.tags = {"charger"}; }),
             QStringLiteral("Change the tags of Dock"));
    QCOMPARE(deed([](map::Waypoint& to) {
               to.name = "%2 <b>";
               to.position_m.x() += 1;
               to.type = "charger";
             }),
             QStringLiteral("Rename Dock to %2 <b>, move it by 1.00 m, change its kind"));
  }

  void newOnesAreSentInTheOrderInWhichTheyWereMade() {
    Desk desk;
    desk.start();
    QStringList names;
    for (int i = 1; i <= 8; ++i) {
      names << QStringLiteral("Corr %1").arg(i);
      const edit::Key key = desk.editing().add({0.3 * i, 1});
      desk.editing().rename(key, names.back());
    }
    desk.open();
    QStringList listed;
    for (int row = 0; row < 8; ++row) listed << desk.cell(row, ReviewModel::DeedColumn);
    QCOMPARE(listed, names.replaceInStrings(QStringLiteral("Corr"), QStringLiteral("Create Corr")));
  }

  void aHeadingThatThereMustBeIsSaidBefore() {
    Desk desk;
    desk.store.kept_fields = {.type = false, .no_heading = false};
    for (map::Waypoint& point : desk.store.points) point.yaw_rad = 1.5;
    desk.start();
    const edit::Key key = desk.editing().add({1, 1});
    desk.open();
    QVERIFY2(desk.cell(0, ReviewModel::ChangeColumn).contains(QStringLiteral("heading 0.0°")),
             qPrintable(desk.cell(0, ReviewModel::ChangeColumn)));
    QVERIFY2(desk.review().statusShown().contains(QLatin1String("has a heading on this robot")),
             qPrintable(desk.review().statusShown()));
    // One that is turned has the heading that was chosen.
    map::Waypoint turned = *desk.editing().find(key);
    turned.yaw_rad = 1;
    desk.editing().set(key, turned, QStringLiteral("turn"));
    QTRY_VERIFY(!desk.review().statusShown().contains(QLatin1String("has a heading on this robot")));
  }

  void namesOfOthersAreText() {
    Desk desk;
    desk.store.points[0].name = "<b>Bold</b>\nline";
    desk.change();
    desk.open();
    QCOMPARE(desk.cell(0, ReviewModel::DeedColumn), QStringLiteral("Move <b>Bold</b> line by 0.25 m"));
    for (const QLabel* label : desk.review().findChildren<QLabel*>())
      QCOMPARE(label->textFormat(), Qt::PlainText);
  }
};

}  // namespace test_window_waypoints_review

MAPWRIGHT_TEST(test_window_waypoints_review, TestWindowWaypointsReview, Widgets)
#include "test_window_waypoints_review.moc"
