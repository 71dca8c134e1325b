// Versions of overlays in the window: listed, compared in words and on the map, brought back, without a
// robot.
#include <QComboBox>
#include <QListWidget>
#include <QTableWidget>
#include <QToolButton>

#include "overlays_desk.h"
#include "test_program.h"
#include "ui/overlays/overlay_history_dock.h"

namespace test_window_overlay_history {

using namespace test_overlays_desk;

namespace {

/// The desk with its history on screen.
struct HistoryDesk : Desk {
  HistoryDesk() { keeps_versions = true; }
  OverlayHistoryDock& past() { return *control().historyDock(); }
  QString cell(int row, int column) {
    const QTableWidgetItem* const item = past().table()->item(row, column);
    return item ? item->text() : QString();
  }
  void show() { QTest::mouseClick(dock().historyButton(), Qt::LeftButton); }
  void pick(int row, Qt::KeyboardModifiers keys = {}) {
    QTableWidget* const table = past().table();
    const QRect at = table->visualItemRect(table->item(row, 0));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, keys, at.center());
  }
  QStringList changes() {
    QStringList all;
    for (int row = 0; row < past().changeList()->count(); ++row)
      all << past().changeList()->item(row)->text();
    return all;
  }
  /// Somebody else moves the wall, then the window reads it.
  void moveWall() {
    QVERIFY(hand(with("[[0.00,0],[4,0]]", "[[0.00,0.4],[4,0.4]]")));
    control().tool()->activate();
    QTRY_COMPARE(coordinates(0), std::string("[[0.00,0.4],[4,0.4]]"));
  }
};

}  // namespace

class TestWindowOverlayHistory : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void versionsAreListedWithWhatEachChanged() {
    HistoryDesk desk;
    desk.open();
    desk.moveWall();
    desk.show();
    QTRY_COMPARE(desk.past().table()->rowCount(), 2);
    QTRY_COMPARE(desk.cell(0, 3), QStringLiteral("Move virtual wall W17 by 0.40 m"));
    QTRY_COMPARE(desk.cell(1, 3), QStringLiteral("First version stored here: 3 features"));
    QCOMPARE(desk.cell(0, 1), QStringLiteral("read"));
    desk.look();
    desk.drag(desk.px(2, 0.4), desk.px(2, 1.4));
    desk.save();
    QTRY_COMPARE(desk.past().table()->rowCount(), 3);
    QCOMPARE(desk.cell(0, 1), QStringLiteral("saved here"));
    QTRY_COMPARE(desk.cell(0, 3), QStringLiteral("Move virtual wall W17 by 1.00 m"));
  }

  void twoVersionsAreComparedInWordsAndOnTheMap() {
    HistoryDesk desk;
    desk.open();
    desk.moveWall();
    QVERIFY(desk.hand(R"({"type":"FeatureCollection","features":[]})"));
    desk.control().tool()->activate();
    QTRY_VERIFY(!desk.editing().find(0));
    desk.show();
    QTRY_COMPARE(desk.past().table()->rowCount(), 3);
    desk.pick(1);
    QTRY_COMPARE(desk.changes(), QStringList{QStringLiteral("Move virtual wall W17 by 0.40 m")});
    QCOMPARE(desk.control().marks().shown().size(), std::size_t(2));
    QVERIFY(desk.control().marks().shown()[0].kind == OverlayMark::Kind::Before);
    QVERIFY(desk.control().marks().shown()[1].kind == OverlayMark::Kind::After);
    // The newest against the oldest.
    desk.pick(0);
    desk.pick(2, Qt::ControlModifier);
    QTRY_COMPARE(desk.changes().size(), 4);
    QVERIFY(desk.changes().contains(QStringLiteral("Delete virtual wall W17")));
    QVERIFY(desk.control().marks().shown()[0].kind == OverlayMark::Kind::Removed);
    QVERIFY(!desk.past().restoreButton()->isEnabled());
    // Hidden, it draws nothing.
    desk.past().close();
    QVERIFY(desk.control().marks().shown().empty());
  }

  void changesThatAreLeftOutAreCounted() {
    HistoryDesk desk;
    desk.open();
    std::string more;
    for (int i = 0; i < 5100; ++i) {
      more += ",{\"id\":\"n" + std::to_string(i) +
              "\",\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[1,1]},"
              "\"properties\":{}}";
    }
    std::string text = kOverlays;
    text.insert(text.rfind("]}"), more);
    QVERIFY(desk.hand(text));
    desk.control().tool()->activate();
    QTRY_COMPARE(desk.document().size(), std::size_t(5103));
    desk.show();
    QTRY_COMPARE(desk.past().table()->rowCount(), 2);
    desk.pick(0);
    QTRY_COMPARE(desk.past().changeList()->count(), 5000);
    QCOMPARE(desk.past().moreShown(),
             QStringLiteral("100 more are not listed. 1,100 are not marked on the map."));
    desk.pick(1);
    QTRY_COMPARE(desk.past().changeList()->count(), 0);
    QCOMPARE(desk.past().moreShown(), QString());
  }

  void aVersionIsBroughtBackAsOneStep() {
    HistoryDesk desk;
    desk.open();
    desk.moveWall();
    const std::string there = desk.held();
    desk.show();
    QTRY_COMPARE(desk.past().table()->rowCount(), 2);
    desk.pick(1);
    desk.past().againstChoice()->setFocus();
    QTest::keyClick(desk.past().againstChoice(), Qt::Key_Down);
    QTRY_COMPARE(desk.changes(), QStringList{QStringLiteral("Move virtual wall W17 by 0.40 m")});
    QTRY_VERIFY(desk.past().restoreButton()->isEnabled());
    QTest::mouseClick(desk.past().restoreButton(), Qt::LeftButton);
    QTRY_COMPARE(desk.coordinates(0), std::string("[[0.00,0],[4,0]]"));
    QVERIFY(desk.control().unsaved());
    QCOMPARE(desk.document().steps(), std::size_t(1));
    QCOMPARE(desk.document().mine().text(), std::string(kOverlays));
    QCOMPARE(desk.held(), there);
    desk.action("undo")->trigger();
    QVERIFY(!desk.control().unsaved());
    desk.action("redo")->trigger();
    desk.save();
    QCOMPARE(desk.held(), std::string(kOverlays));
  }

  void whatBelongsToAllOverlaysIsBroughtBackToo() {
    HistoryDesk desk;
    desk.open();
    QVERIFY(desk.hand(desk.with("1.50", "2.5")));
    desk.control().tool()->activate();
    desk.show();
    QTRY_COMPARE(desk.past().table()->rowCount(), 2);
    desk.pick(1);
    QTRY_VERIFY(desk.past().restoreButton()->isEnabled());
    QTest::mouseClick(desk.past().restoreButton(), Qt::LeftButton);
    QTRY_VERIFY(desk.control().unsaved());
    QCOMPARE(desk.document().mine().text(), std::string(kOverlays));
  }

  void whatIsDeletedHereIsTheSameFeatureAgain() {
    HistoryDesk desk;
    desk.open();
    desk.show();
    QTRY_COMPARE(desk.past().table()->rowCount(), 1);
    desk.click(desk.px(2, 0));
    desk.editing().removeSelected();
    QVERIFY(!desk.editing().find(0));
    desk.pick(0);
    QTRY_VERIFY(desk.past().restoreButton()->isEnabled());
    QTest::mouseClick(desk.past().restoreButton(), Qt::LeftButton);
    QTRY_VERIFY(desk.editing().find(0));
    QVERIFY(!desk.control().unsaved());
    QCOMPARE(desk.document().size(), std::size_t(3));
  }

  void withoutARobotTheVersionsAreStillThere() {
    HistoryDesk desk;
    desk.open();
    desk.moveWall();
    desk.window->leaveRobot();
    QTRY_VERIFY(!desk.editing().isOpen());
    desk.window.reset();
    MainWindow::Dependencies alone{
        [](const QString&, const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          return tl::make_unexpected(QStringLiteral("none"));
        },
        desk.settings};
    alone.overlays_history = desk.history();
    desk.window = std::make_unique<MainWindow>(std::move(alone));
    desk.window->resize(1500, 900);
    desk.window->show();
    desk.past().show();
    QTRY_COMPARE(desk.past().table()->rowCount(), 2);
    QVERIFY(desk.past().mapChoice()->currentText().contains(QStringLiteral("127.0.0.1")));
    desk.pick(0);
    QTRY_COMPARE(desk.changes(), QStringList{QStringLiteral("Move virtual wall W17 by 0.40 m")});
    QVERIFY(!desk.past().restoreButton()->isEnabled() && desk.past().saveAsButton()->isEnabled());
  }

  void aVersionThatCannotBeKeptIsSaid() {
    HistoryDesk desk;
    QFile damaged(QString::fromStdString(desk.history()));
    QVERIFY(damaged.open(QIODevice::WriteOnly));
    damaged.write(QByteArray(4096, 'x'));
    damaged.close();
    desk.open();
    QTRY_VERIFY(desk.says("not in the history") && desk.says("overlays.sqlite"));
    desk.show();
    QTRY_VERIFY(desk.past().troubleShown().contains(QStringLiteral("overlays.sqlite")));
    QVERIFY(desk.editing().isOpen());
  }
};

}  // namespace test_window_overlay_history

MAPWRIGHT_TEST(test_window_overlay_history, TestWindowOverlayHistory, Widgets)
#include "test_window_overlay_history.moc"
