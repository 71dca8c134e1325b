// Editing the picture of a map in the window: painting by hand, undoing, saving, what others write meanwhile,
// leaving.
#include <random>

#include <QAction>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include "edit/picture/picture_drafts.h"
#include "render/sample_grid.h"
#include "robot/files/file_address.h"
#include "robot/files/file_robot.h"
#include "test_program.h"
#include "ui/kit/ui_colors.h"
#include "ui/maps/compare_controller.h"
#include "ui/maps/export_controller.h"
#include "ui/picture/picture_controller.h"
#include "ui/picture/picture_dock.h"
#include "ui/picture/picture_tool.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_picture {

using namespace mapwright;
using namespace mapwright::ui;
using picture::CellRect;
using picture::Kind;

namespace {

constexpr int kWidth = 400, kHeight = 300;
const QByteArray kYaml =
    "# kept\nimage: office.pgm\nresolution: 0.01\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\nowner: me\n";

/// A window on a local map of 4 m x 3 m, 1 cm a cell, all free; two pixels a cell, its middle in the middle.
struct Desk {
  Desk() : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {
    writeFile(yaml(), kYaml);
    writeCells([](int, int) { return char(254); });
  }
  ~Desk() { window.reset(); }

  QString yaml() const { return folder.filePath(QStringLiteral("office.yaml")); }
  QString pgm() const { return folder.filePath(QStringLiteral("office.pgm")); }
  static void writeFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);  // it is watched: never seen half written
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    QVERIFY(file.commit());
  }
  void writeCells(const std::function<char(int, int)>& shade, int width = kWidth,
                  int height = kHeight) const {
    QByteArray bytes = "P5\n" + QByteArray::number(width) + " " + QByteArray::number(height) + "\n255\n";
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) bytes += shade(x, y);
    }
    writeFile(pgm(), bytes);
  }
  QByteArray cellsOnDisk() const {
    QFile file(pgm());
    return file.open(QIODevice::ReadOnly) ? file.readAll().right(kWidth * kHeight) : QByteArray();
  }
  int shadeOnDisk(int x, int y) const {
    const QByteArray cells = cellsOnDisk();
    return cells.size() == kWidth * kHeight ? int(std::uint8_t(cells[y * kWidth + x])) : -1;
  }

  void start(const QString& path = {}) {
    MainWindow::Dependencies wanted{
        [](const QString& address,
           const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          robot::files::FileOptions options;
          options.path = address.mid(int(qstrlen("file:")));
          options.settle = std::chrono::milliseconds(1);
          return std::make_unique<robot::files::FileRobot>(address, options);
        },
        settings};
    wanted.addresses = robot::Addresses({robot::files::addressScheme()});
    if (keeps_drafts) wanted.edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(1900, 1050);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
    QVERIFY(!window->connectTo(QStringLiteral("file:") + (path.isEmpty() ? yaml() : path)));
  }
  void open() {
    start();
    QTRY_VERIFY(editing().isOpen());
    QTest::keyClick(window->view(), Qt::Key_B);
    QCOMPARE(window->view()->tool(), static_cast<MapTool*>(control().tool()));
    QCoreApplication::processEvents();  // the dock has opened
    geometry::ViewTransform camera = window->mapScene()->view();
    camera.center_m = {2, 1.5};
    camera.scale_m_per_px = 0.005;
    window->view()->moveTo(camera, false);
  }
  PictureController& control() { return *part<PictureController>(*window); }
  edit::PictureEditing& editing() { return *control().editing(); }
  PictureDock& dock() { return *control().dock(); }
  const grids::GridPyramid& cells() { return *window->mapScene()->wholeMap()->cells; }

  /// The middle of a cell.
  QPoint px(int column, int row) {
    const Eigen::Vector2d at = window->mapScene()->view().pixelFromWorld(
        editing().reference().worldFromCell({column + 0.5, row + 0.5}));
    return {qRound(at.x()), qRound(at.y())};
  }
  QWidget* map() { return window->view()->viewport(); }
  void press(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(map(), Qt::LeftButton, keys, at);
  }
  void moveTo(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent move(QEvent::MouseMove, at, map()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, keys);
    QApplication::sendEvent(map(), &move);
  }
  void release(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseRelease(map(), Qt::LeftButton, keys, at);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
    press(from, keys);
    moveTo((from + to) / 2, keys);
    moveTo(to, keys);
    release(to, keys);
  }
  void click(const QPoint& at) { QTest::mouseClick(map(), Qt::LeftButton, {}, at); }
  QAction* action(const char* id) { return window->actionList().find(QLatin1String(id)); }
  void save() {
    action("save")->trigger();
    QTRY_VERIFY(!control().saving());
  }
  QStringList toasts() { return part<MapOverlay>(*window)->toasts()->texts(); }

  bool keeps_drafts = false;
  QTemporaryDir folder;
  QSettings settings;
  std::unique_ptr<MainWindow> window;
};

}  // namespace

class TestWindowPicture : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aStrokeIsOnTheMapAtOnceAndOneThingToUndo() {
    Desk desk;
    desk.open();
    const QImage before = part<ExportController>(*desk.window)->mapPicture();
    desk.press(desk.px(100, 100));
    desk.moveTo(desk.px(150, 100));
    QCOMPARE(int(desk.cells().at(140, 100)), 100);  // while the hand is still down
    desk.moveTo(desk.px(200, 100));
    desk.release(desk.px(200, 100));
    QCOMPARE(int(desk.cells().at(100, 100)), 100);
    QCOMPARE(int(desk.cells().at(199, 100)), 100);
    QCOMPARE(int(desk.cells().at(199, 110)), 0);
    QTRY_VERIFY(desk.window->mapScene()->settled());
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != before);
    QTRY_VERIFY(desk.window->windowTitle().startsWith(QStringLiteral("• ")));
    QVERIFY2(desk.dock().status().contains(QLatin1String("Changed: 3")), qPrintable(desk.dock().status()));
    desk.action("undo")->trigger();
    QCOMPARE(int(desk.cells().at(150, 100)), 0);
    QTRY_VERIFY(!desk.window->windowTitle().startsWith(QStringLiteral("• ")));
    QCOMPARE(desk.dock().status(), QStringLiteral("No unsaved changes."));
    desk.action("redo")->trigger();
    QCOMPARE(int(desk.cells().at(150, 100)), 100);
  }

  void quickDabsAreAllPainted() {
    Desk desk;
    desk.open();
    desk.click(desk.px(50, 50));
    QTest::mouseDClick(desk.map(), Qt::LeftButton, {}, desk.px(60, 50));
    desk.drag(desk.px(70, 50), desk.px(90, 50));
    for (const int x : {50, 60, 80}) QCOMPARE(int(desk.cells().at(x, 50)), 100);
  }

  void everyToolPaints() {
    Desk desk;
    desk.open();
    const auto cell = [&](int x, int y) { return int(desk.cells().at(x, y)); };
    const auto choose = [&](PaintMode mode) { desk.dock().modeButton(mode)->click(); };
    desk.dock().kindButton(Kind::Occupied)->click();
    choose(PaintMode::Line);
    desk.drag(desk.px(10, 20), desk.px(110, 20));
    QCOMPARE(cell(60, 20), 100);
    choose(PaintMode::Rectangle);
    desk.drag(desk.px(10, 40), desk.px(30, 60));
    QCOMPARE(cell(20, 50), 100);
    choose(PaintMode::Polygon);
    for (const auto& [x, y] : {std::pair{200, 200}, {300, 200}, {250, 280}, {200, 200}}) {
      desk.moveTo(desk.px(x, y));
      desk.click(desk.px(x, y));
    }
    QCOMPARE(cell(250, 230), 100);
    QCOMPARE(cell(210, 270), 0);
    choose(PaintMode::Fill);
    desk.dock().kindButton(Kind::Unknown)->click();
    desk.click(desk.px(350, 100));
    QCOMPARE(cell(5, 5), 255);
    QCOMPARE(cell(250, 230), 100);
    choose(PaintMode::Eraser);
    desk.dock().sizeBox()->setValue(20);
    desk.drag(desk.px(240, 230), desk.px(260, 230));
    QCOMPARE(cell(250, 230), 0);
    QCOMPARE(cell(250, 260), 100);
    QCOMPARE(desk.editing().undoStack().count(), 5);
  }

  void aSelectionIsMovedCopiedAndPasted() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({50, 50, 60, 60});
    desk.dock().modeButton(PaintMode::Select)->click();
    desk.drag(desk.px(45, 45), desk.px(65, 65));
    QCOMPARE(desk.editing().selection(), (CellRect{45, 45, 66, 66}));
    desk.drag(desk.px(55, 55), desk.px(155, 55));
    QCOMPARE(int(desk.cells().at(55, 55)), 255);
    QCOMPARE(int(desk.cells().at(155, 55)), 100);
    QCOMPARE(desk.editing().selection().left, 145);
    QTest::keyClick(desk.window->view(), Qt::Key_C, Qt::ControlModifier);
    desk.editing().select({});
    desk.moveTo(desk.px(200, 200));
    QTest::keyClick(desk.window->view(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(int(desk.cells().at(207, 207)), 100);
    desk.drag(desk.px(207, 207), desk.px(257, 207), Qt::ControlModifier);
    QCOMPARE(int(desk.cells().at(207, 207)), 100);
    QCOMPARE(int(desk.cells().at(257, 207)), 100);
  }

  void tidyingIsShownBeforeItIsDone() {
    Desk desk;
    desk.writeCells([](int x, int y) { return char((x % 50 == 20 && y % 50 == 20) || y == 0 ? 0 : 254); });
    desk.open();
    desk.dock().tidySize(edit::Tidying::Specks)->setValue(3);
    desk.dock().tidyButton(edit::Tidying::Specks)->click();
    QTRY_VERIFY(desk.editing().preview());
    QCOMPARE(int(desk.editing().preview()->found.pieces), 48);
    QCOMPARE(int(desk.cells().at(20, 20)), 0);  // as it would be
    QVERIFY(!desk.editing().unsaved());
    QTest::keyClick(desk.window->view(), Qt::Key_Escape);
    QCOMPARE(int(desk.cells().at(20, 20)), 100);
    desk.dock().tidyButton(edit::Tidying::Specks)->click();
    QTRY_VERIFY(desk.dock().applyButton()->isEnabled());
    desk.dock().applyButton()->click();
    QCOMPARE(int(desk.editing().changedCells()), 48);
    QCOMPARE(int(desk.cells().at(20, 0)), 100);
    desk.action("undo")->trigger();
    QCOMPARE(int(desk.cells().at(20, 20)), 100);
  }

  void theKeysOfAPreviewWorkInItsPanelToo() {
    Desk desk;
    desk.writeCells([](int x, int y) { return x == 20 && y == 20 ? char(0) : char(254); });
    desk.open();
    desk.dock().tidyButton(edit::Tidying::Specks)->click();
    QTRY_VERIFY(desk.editing().preview());
    // Who goes back to the panel has neither lost Esc nor Enter.
    QTest::mouseClick(desk.dock().tidyButton(edit::Tidying::Gaps), Qt::LeftButton);
    QTRY_VERIFY(desk.editing().preview() && desk.editing().preview()->what == edit::Tidying::Gaps);
    desk.dock().modeButton(PaintMode::Brush)->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!desk.editing().preview() && !desk.editing().looking());
    QCOMPARE(desk.window->view()->tool(), static_cast<MapTool*>(desk.control().tool()));
    // Enter in a number looks with it, the next one applies that.
    QSpinBox* const size = desk.dock().tidySize(edit::Tidying::Specks);
    size->setFocus();
    size->selectAll();
    QTest::keyClicks(size, QStringLiteral("5"));
    QTest::keyClick(size, Qt::Key_Return);
    QTRY_VERIFY(desk.editing().preview());
    QVERIFY(!desk.editing().unsaved());
    desk.dock().applyButton()->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_VERIFY(desk.editing().unsaved());
    QVERIFY(!desk.editing().preview());
    const int across = desk.editing().across();
    desk.dock().modeButton(PaintMode::Brush)->setFocus();
    for (int i = 0; i < 2; ++i) QTest::keyClick(QApplication::focusWidget(), Qt::Key_B);  // away, and back
    QVERIFY(desk.window->view()->hasFocus());
    desk.dock().modeButton(PaintMode::Brush)->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Period);
    QVERIFY(desk.editing().across() > across);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Comma);
    QCOMPARE(desk.editing().across(), across);
  }

  void whatIsShownBeforeItIsTidiedUpHasKeysAndALegend() {
    Desk desk;
    // A speck in free ground, one in unknown ground, and a gap in a wall.
    desk.writeCells([](int x, int y) {
      if ((x == 20 && y == 20) || (x == 320 && y == 20) || (x == 321 && y == 20)) return char(0);
      if (y == 200 && x > 50 && x < 350 && x != 200) return char(0);
      return x > 300 && y < 100 ? char(205) : char(254);
    });
    desk.open();
    desk.action("pictureTool")->trigger();  // nothing in the hand
    QVERIFY(desk.window->view()->tool() != &*desk.control().tool());
    desk.dock().tidySize(edit::Tidying::Specks)->setValue(3);
    QTest::mouseClick(desk.dock().tidyButton(edit::Tidying::Specks), Qt::LeftButton);
    QTRY_VERIFY(desk.editing().preview());
    QCOMPARE(desk.dock().legend(), (QStringList{QStringLiteral("becomes free: 1 cell"),
                                                QStringLiteral("becomes unknown: 2 cells")}));
    // The keyboard is where the hint says.
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!desk.editing().preview() && !desk.editing().unsaved());
    QVERIFY(desk.dock().legend().isEmpty());
    desk.dock().tidyButton(edit::Tidying::Gaps)->setFocus();
    QTest::keyClick(desk.dock().tidyButton(edit::Tidying::Gaps), Qt::Key_Space);
    QTRY_VERIFY(desk.editing().preview());
    QCOMPARE(desk.dock().legend(), QStringList{QStringLiteral("becomes occupied: 1 cell")});
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(int(desk.cells().at(200, 200)), 100);
    QCOMPARE(int(desk.editing().changedCells()), 1);
  }

  void theMarksAreToldApartWithoutColours() {
    for (int one = 0; one < picture::kKinds; ++one) {
      for (int other = 0; other < one; ++other) {
        const BecomesLook a = becomesLook(Kind(one)), b = becomesLook(Kind(other));
        QVERIFY2(contrastRatio(a.color, b.color) > 1.3 && a.lines != b.lines,
                 qPrintable(QString::number(contrastRatio(a.color, b.color))));
      }
    }
  }

  void savingWritesThePictureAndLeavesItsYaml() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    desk.save();
    QCOMPARE(desk.shadeOnDisk(15, 15), 0);
    QCOMPARE(desk.shadeOnDisk(25, 15), 254);
    QFile yaml(desk.yaml());
    QVERIFY(yaml.open(QIODevice::ReadOnly));
    QCOMPARE(yaml.readAll(), kYaml);
    QTRY_VERIFY(!desk.window->windowTitle().startsWith(QStringLiteral("• ")));
    // It goes on from there, and what was done before can still be undone.
    desk.editing().drawRectangle({30, 10, 40, 20});
    QCOMPARE(int(desk.editing().changedCells()), 100);
    desk.save();
    QCOMPARE(desk.shadeOnDisk(35, 15), 0);
    desk.action("undo")->trigger();
    desk.action("undo")->trigger();
    QCOMPARE(int(desk.editing().changedCells()), 200);
    desk.save();
    QCOMPARE(desk.shadeOnDisk(15, 15), 254);
  }

  void whatOthersWriteIsPutTogether() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    desk.writeCells([](int x, int) { return char(x > 390 ? 0 : 254); });
    QTRY_COMPARE(int(desk.cells().at(395, 100)), 100);
    QCOMPARE(int(desk.cells().at(15, 15)), 100);
    QCOMPARE(int(desk.editing().changedCells()), 100);
    QCOMPARE(int(desk.editing().conflicts()), 0);
    desk.save();
    QTRY_COMPARE(desk.shadeOnDisk(15, 15), 0);
    QCOMPARE(desk.shadeOnDisk(395, 100), 0);
  }

  /// Somebody else writes the file ten times a second: on rows of his own, so that both must be there.
  void everyStrokeIsWholeWhileSomebodyElsePaints() {
    Desk desk;
    desk.open();
    desk.editing().setAcross(1);
    std::mt19937 random(7);
    const auto upTo = [&random](int most) { return int(random() % unsigned(most)); };
    std::vector<int> mine(std::size_t(kWidth) * kHeight), theirs(mine);
    int painted = 0;
    QTimer painter;
    QObject::connect(&painter, &QTimer::timeout, &painter, [&] {
      if (desk.control().saving()) return;  // who writes without looking would undo it
      const int left = upTo(kWidth - 40), row = 2 * upTo(kHeight / 2) + 1;
      const QByteArray kept = desk.cellsOnDisk();
      if (kept.size() != kWidth * kHeight) return;
      for (int x = left; x < left + 40; ++x) theirs[std::size_t(row * kWidth + x)] = 1;
      desk.writeCells([&](int x, int y) {
        const auto at = std::size_t(y * kWidth + x);
        return theirs[at] ? char(205) : kept[qsizetype(at)];
      });
      ++painted;
    });
    painter.start(100);
    for (int stroke = 0; stroke < 12; ++stroke) {
      const int left = 20 + upTo(200), right = left + 100 + upTo(60), row = 20 + 2 * upTo(120);
      const int begun = painted;
      desk.press(desk.px(left, row));
      for (int x = left + 1; x <= right; ++x) {
        desk.moveTo(desk.px(x, row));
        if (x == left + 50) QTRY_VERIFY(painted > begun);  // and it comes in the middle of it
        if (x % 20 == 0) QTest::qWait(1);
      }
      desk.release(desk.px(right, row));
      for (int x = left; x <= right; ++x) mine[std::size_t(row * kWidth + x)] = 1;
      if (stroke == 5) desk.action("save")->trigger();
    }
    painter.stop();
    const auto asWanted = [&](bool of_mine) {
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const auto at = std::size_t(y * kWidth + x);
          const int wanted = of_mine && mine[at] ? 100 : theirs[at] ? 255 : 0;
          if (int(desk.cells().at(x, y)) != wanted) return false;
        }
      }
      return true;
    };
    QTRY_VERIFY(asWanted(true));
    QCOMPARE(desk.editing().undoStack().count(), 12);
    QTRY_VERIFY(!desk.control().saving() && !desk.editing().merging());
    while (desk.editing().undoStack().canUndo()) desk.editing().undoStack().undo();
    QVERIFY(asWanted(false));
    while (desk.editing().undoStack().canRedo()) desk.editing().undoStack().redo();
    QVERIFY(asWanted(true));
    desk.save();
    QTRY_VERIFY(!desk.editing().unsaved());
    const QByteArray kept = desk.cellsOnDisk();
    for (std::size_t at = 0; at < mine.size(); ++at)
      QCOMPARE(int(std::uint8_t(kept[qsizetype(at)])), mine[at] ? 0 : theirs[at] ? 205 : 254);
  }

  void whatMeetsIsDecidedBeforeItIsSaved() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    desk.writeCells([](int x, int y) { return char(x < 15 && y < 15 ? 205 : 254); });
    QTRY_COMPARE(int(desk.editing().conflicts()), 25);
    QCOMPARE(int(desk.cells().at(5, 5)), 255);
    QCOMPARE(int(desk.cells().at(12, 12)), 100);  // mine, until it is decided
    // It is said once, and again to whoever saves.
    const auto told = [&desk] {
      return desk.toasts().filter(QLatin1String("Choose which ones to keep")).size();
    };
    QTRY_COMPARE(told(), 1);
    desk.writeCells([](int x, int y) { return char((x < 15 && y < 15) || x > 390 ? 205 : 254); });
    QTRY_COMPARE(int(desk.cells().at(395, 5)), 255);
    QCOMPARE(int(desk.editing().conflicts()), 25);  // nobody has decided about them
    QCOMPARE(told(), 1);
    desk.action("save")->trigger();
    QVERIFY(!desk.control().saving());
    QVERIFY(desk.toasts().last().contains(QLatin1String("Choose which ones to keep")));
    QVERIFY(desk.dock().useTheirsButton()->isVisible());
    desk.dock().useTheirsButton()->setFocus();
    desk.dock().useTheirsButton()->click();
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.window->view()));
    QCOMPARE(int(desk.cells().at(12, 12)), 255);
    QCOMPARE(int(desk.cells().at(17, 17)), 100);
    desk.save();
    QTRY_COMPARE(desk.shadeOnDisk(17, 17), 0);
    QCOMPARE(desk.shadeOnDisk(12, 12), 205);
  }

  void aMapOfAnotherSizeTakesNothingAlongSilently() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    desk.writeCells([](int, int) { return char(254); }, 50, 40);
    QTRY_COMPARE(desk.editing().grid()->width(), 50);
    QCOMPARE(desk.toasts().filter(QLatin1String("100 cells")).size(), 1);
    QVERIFY(!desk.editing().unsaved());
  }

  void leavingAsks() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    desk.window->close();
    QTRY_VERIFY(desk.control().question());
    QVERIFY(desk.control().question()->text().contains(QLatin1String("100 cells")));
    desk.control().question()->button(QMessageBox::Cancel)->click();
    QVERIFY(desk.window->isVisible());
    desk.window->close();
    QTRY_VERIFY(desk.control().question());
    desk.control().question()->button(QMessageBox::Save)->click();
    QTRY_VERIFY(!desk.window->isVisible());
    QCOMPARE(desk.shadeOnDisk(15, 15), 0);
  }

  void whatIsNotSavedIsOfferedAgain() {
    Desk desk;
    desk.keeps_drafts = true;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    desk.window->close();
    QTRY_VERIFY(desk.control().question());
    desk.control().question()->findChild<QPushButton*>(QStringLiteral("keepDraft"))->click();
    QTRY_VERIFY(!desk.window->isVisible());
    QCOMPARE(desk.shadeOnDisk(15, 15), 254);
    desk.window.reset();
    // Somebody writes there meanwhile.
    desk.writeCells([](int x, int y) { return char(x < 15 && y < 15 ? 205 : 254); });
    desk.open();
    QTRY_VERIFY(!desk.control().offerText().isEmpty());
    QVERIFY(desk.control().offerText().contains(QLatin1String("100 cells")));
    for (QPushButton* button : desk.dock().findChildren<QPushButton*>()) {
      if (button->text() != QLatin1String("Restore")) continue;
      button->setFocus();
      button->click();
    }
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.window->view()));
    QCOMPARE(int(desk.cells().at(15, 15)), 100);
    QCOMPARE(int(desk.cells().at(5, 5)), 255);
    QVERIFY(desk.toasts().last().contains(QLatin1String("25 cells")));
    desk.save();
    QCOMPARE(desk.shadeOnDisk(15, 15), 0);
    const QDir drafts(desk.folder.filePath(QStringLiteral("drafts")));
    QTRY_VERIFY(drafts.entryList({QStringLiteral("*.json")}, QDir::Files).isEmpty());
  }

  void aDraftThatCouldNotBeWrittenIsNoTroubleOnceItIsSaved() {
    Desk desk;
    desk.keeps_drafts = true;
    Desk::writeFile(desk.folder.filePath(QStringLiteral("drafts")), "no folder");
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    QVERIFY(desk.control().edited()->drafts()->keep());
    const auto said = [&] { return desk.dock().status(); };
    QTRY_VERIFY2(said().contains(QLatin1String("not backed up")), qPrintable(said()));
    desk.save();
    QTRY_VERIFY(!desk.editing().unsaved());
    QVERIFY2(!said().contains(QLatin1String("not backed up")), qPrintable(said()));
  }

  void whatCouldNotBeSavedIsNoLongerSaidOnceItIs() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    // Nobody can write where there is no folder, whoever runs the test.
    const QString away = desk.folder.path() + QStringLiteral("-away");
    QVERIFY(QDir().rename(desk.folder.path(), away));
    const auto back = qScopeGuard([&] { QDir().rename(away, desk.folder.path()); });
    desk.save();
    QVERIFY2(desk.toasts().value(0).startsWith(QLatin1String("The map was not saved.")),
             qPrintable(desk.toasts().join(QLatin1Char('|'))));
    QVERIFY(QDir().rename(away, desk.folder.path()));
    desk.save();
    QCOMPARE(desk.toasts(), QStringList{QStringLiteral("office.yaml saved")});
  }

  void brokenDraftsAreSetAside() {
    QVERIFY(!edit::pictureDraftFrom("{}"));
    const picture::EditedGrid grid(
        grids::buildGrid(3, 3, grids::CellCode::Gray, grids::Reduction::OccupiedWins)->pyramid());
    const QByteArray whole = edit::pictureDraftBytes({}, QDateTime::currentDateTime(), grid, grid);
    QVERIFY(edit::pictureDraftFrom(whole));
    QVERIFY(!edit::pictureDraftFrom(QByteArray(whole).replace("\"width\":3", "\"width\":-3")));
    QVERIFY(!edit::pictureDraftFrom(QByteArray(whole).replace("\"changes\":[", "\"changes\":[{\"x\":1},")));
    // It says that it unpacks to four gigabytes.
    QVERIFY(!edit::pictureDraftFrom(
        QByteArray(whole).replace("]", ",{\"x\":0,\"y\":0,\"was\":\"/////wA=\",\"is\":\"/////wA=\"}]")));
  }

  void discardingCanBeUndone() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    desk.editing().revert();
    QVERIFY(!desk.editing().unsaved());
    QCOMPARE(int(desk.cells().at(15, 15)), 0);
    desk.action("undo")->trigger();
    QCOMPARE(int(desk.cells().at(15, 15)), 100);
  }

  void whatIsSavedIsComparedWithWhatItIsNow() {
    Desk desk;
    desk.open();
    desk.editing().drawRectangle({10, 10, 20, 20});
    Q_EMIT desk.control().compareWanted();
    QTRY_VERIFY(desk.window->session()->comparedMap().cells());
    QCOMPARE(desk.window->mapScene()->compareMode(), ui::scene::CompareMode::Swipe);
    QTRY_COMPARE(int(desk.window->session()->comparedMap().cells()->at(15, 15)), 0);
    QCOMPARE(int(desk.cells().at(15, 15)), 100);
  }

  void whatCouldNotBeSentBackIsNotPaintedOn() {
    /// Keeps black and white, and grays only where they are asked for.
    class FewShades : public robot::PictureStore {
     public:
      std::optional<robot::PictureObstacle> obstacle(const map::WholeMap&) const override { return {}; }
      bool holdsUnknown(const map::WholeMap&) const override { return true; }
      bool holdsCell(const map::WholeMap&, std::uint8_t cell) const override { return cell != not_held; }
      robot::Call write(const robot::PictureChange&, robot::OutcomeTo<robot::PictureReceipt>) override {
        return {};
      }
      std::uint8_t not_held = 254;
    };
    FewShades shades;
    test::Bench bench;
    bench.offerMaps();
    bench.prepare = [&shades, offer = bench.prepare](test::FakeRobot& robot) {
      offer(robot);
      robot.picture_store = &shades;
    };
    bench.open();
    QVERIFY(!bench.window->connectTo(test::kAddress));
    bench.window->session()->openMap({map::MapKind::Stored, "2"});
    QAction* const tool = bench.action("pictureTool");
    QTRY_VERIFY2(tool->toolTip().contains(QLatin1String("in between (254 of 100)")),
                 qPrintable(tool->toolTip()));
    QVERIFY(!tool->isEnabled() && !part<PictureController>(*bench.window)->editing()->isOpen());
    // One without such cells.
    shades.not_held = 100;
    bench.window->session()->openMap({map::MapKind::Stored, "1"});
    QTRY_VERIFY(part<PictureController>(*bench.window)->editing()->isOpen());
    QVERIFY(tool->isEnabled());
  }

  /// Reading takes a while: what is read may be older than what was saved in the meantime.
  void whatWasReadBeforeItWasSavedTakesNothingBack() {
    class SlowStore : public robot::PictureStore {
     public:
      std::optional<robot::PictureObstacle> obstacle(const map::WholeMap&) const override { return {}; }
      bool holdsUnknown(const map::WholeMap&) const override { return true; }
      robot::Call write(const robot::PictureChange&,
                        robot::OutcomeTo<robot::PictureReceipt> outcome) override {
        reply = std::move(outcome);
        return {};
      }
      robot::OutcomeTo<robot::PictureReceipt> reply;
    };
    SlowStore store;
    test::Bench bench;
    bench.offerMaps();
    bench.prepare = [&store, offer = bench.prepare](test::FakeRobot& robot) {
      offer(robot);
      robot.picture_store = &store;
    };
    bench.open();
    QVERIFY(!bench.window->connectTo(test::kAddress));
    session::Session& session = *bench.window->session();
    const map::MapKey key{map::MapKind::Stored, "1"};
    session.openMap(key);
    PictureController& control = *part<PictureController>(*bench.window);
    QTRY_VERIFY(control.editing()->isOpen());
    control.editing()->drawRectangle({10, 10, 20, 20});
    bench.action("save")->trigger();
    bench.window->findChild<QPushButton*>(QStringLiteral("sendPicture"))->click();
    QTRY_VERIFY(store.reply);
    const auto before = session.wholeMap().cells();
    Q_EMIT store.changed(key);  // read again while it is being written, as it was before
    QTRY_VERIFY(session.wholeMap().cells() != before && session.wholeMap().settled());
    store.reply(robot::PictureReceipt{"saved"});
    QTRY_VERIFY(!control.saving() && !control.editing()->merging());
    QCOMPARE(int(control.editing()->grid()->at(15, 15)), 0);  // black
    QVERIFY(!control.editing()->unsaved());
  }

  void theToolSaysWhyNot() {
    Desk desk;
    desk.start(QStringLiteral("/nowhere/gone.yaml"));
    QVERIFY(!desk.action("pictureTool")->isEnabled());
    QVERIFY(desk.action("pictureTool")->toolTip().contains(QLatin1String("whole map")));
  }
};

}  // namespace test_window_picture

MAPWRIGHT_TEST(test_window_picture, TestWindowPicture, Widgets)
#include "test_window_picture.moc"
