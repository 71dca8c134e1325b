// The picture of a KABAM robot's map, edited in the window on its simulator.
#include <QAction>
#include <QDesktopServices>
#include <QDirIterator>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QUrl>
#include <QtTest>

#include "edit/picture/picture_copies.h"
#include "robot/ros/ros_address.h"
#include "robot/ros/ros_robot.h"
#include "simulator/simulator.h"
#include "test_program.h"
#include "ui/kit/status_text.h"
#include "ui/maps/administration_controller.h"
#include "ui/picture/copies_dialog.h"
#include "ui/picture/picture_controller.h"
#include "ui/picture/picture_dock.h"
#include "ui/picture/picture_tool.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_window_kabam_picture {

using namespace mapwright;
using namespace mapwright::ui;
using picture::CellRect;

namespace {

struct Hall {
  explicit Hall(simulator::Faults faults = {}) : Hall(robotWith(std::move(faults))) {}
  explicit Hall(std::shared_ptr<simulator::Simulator> of)
      : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat), robot(std::move(of)) {}
  static std::shared_ptr<simulator::Simulator> robotWith(simulator::Faults faults) {
    simulator::Options options;
    options.paused = true;
    options.faults = std::move(faults);
    auto made = std::make_shared<simulator::Simulator>(options);
    (void)made->start();
    return made;
  }
  ~Hall() { window.reset(); }

  void start() {
    MainWindow::Dependencies wanted{
        [this](const QString& address,
               const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          robot::ros::LinkOptions options;
          options.url = QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(robot->rosPort()));
          options.kabam_only = true;
          options.picture_settles = std::chrono::milliseconds(20);
          options.kabam.confirm = confirm;
          options.client.most_whole_bytes = 10'000;
          options.client.fragment_bytes = 10'000;
          return std::make_unique<robot::ros::RosRobot>(address, options);
        },
        settings};
    wanted.addresses = robot::Addresses({robot::ros::kabamAddressScheme()});
    if (keeps_copies) wanted.edit.drafts_folder = folder.filePath(QStringLiteral("mapwright/drafts"));
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(1366, 768);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
    QVERIFY(!window->connectTo(QStringLiteral("kabam+ws://127.0.0.1:%1").arg(robot->rosPort())));
  }
  /// The map that is sent is on screen; the tool takes the one that is kept.
  void open() {
    start();
    QTRY_VERIFY(action("pictureTool")->isEnabled());
    QVERIFY(!editing().isOpen());
    QCOMPARE(window->session()->wholeMap().shown().key.kind, map::MapKind::Live);
    action("pictureTool")->trigger();
    QTRY_VERIFY(editing().isOpen());
    QCOMPARE(window->session()->wholeMap().shown().key.kind, map::MapKind::Stored);
    QCOMPARE(window->view()->tool(), static_cast<MapTool*>(control().tool()));
  }
  void paint(const CellRect& rect) {
    editing().setKind(picture::Kind::Occupied);
    editing().drawRectangle(rect);
  }
  /// Saves, and says that it may be sent.
  void save() {
    action("save")->trigger();
    QVERIFY(control().sendingQuestion());
    control().sendingQuestion()->findChild<QPushButton*>(QStringLiteral("sendPicture"))->click();
  }
  PictureController& control() { return *part<PictureController>(*window); }
  edit::PictureEditing& editing() { return *control().editing(); }
  int cell(int column, int row) { return int(editing().grid()->at(column, row)); }
  QAction* action(const char* id) { return window->actionList().find(QLatin1String(id)); }
  QString status() { return control().dock()->status(); }
  QStringList toasts() { return part<MapOverlay>(*window)->toasts()->texts(); }

  /// The copies that are kept, oldest first.
  QStringList copies() {
    QStringList found;
    QDirIterator files(folder.filePath(QStringLiteral("mapwright/overwritten")), {QStringLiteral("*.yaml")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) found << files.next();
    found.sort();
    return found;
  }

  bool keeps_copies = false;
  std::chrono::milliseconds confirm{5'000};
  QTemporaryDir folder;
  QSettings settings;
  std::shared_ptr<simulator::Simulator> robot;
  std::unique_ptr<MainWindow> window;
};

constexpr CellRect kSpot{30, 40, 34, 44};

/// The first picture that is sent goes wrong.
simulator::Faults firstSave(simulator::FaultKind kind, simulator::Requests of) {
  simulator::Faults faults;
  faults.requests.push_back({kind, of, 1, 0, "/map_manager/update_map_image"});
  return faults;
}

/// What the desktop is asked to show.
class ShownFolders : public QObject {
  Q_OBJECT
 public:
  ShownFolders() { QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "addFolder"); }
  ~ShownFolders() override { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
  QStringList folders;

 public Q_SLOTS:
  void addFolder(const QUrl& url) { folders << url.toLocalFile(); }
};

}  // namespace

class TestWindowKabamPicture : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theMapThatTheRobotWorksWithIsEditedAndSaved() {
    Hall hall;
    hall.open();
    hall.paint(kSpot);
    QVERIFY(hall.editing().unsaved());
    hall.save();
    QVERIFY(hall.control().saving());
    QTRY_VERIFY(!hall.control().saving());
    QVERIFY2(!hall.editing().unsaved(), qPrintable(hall.status()));
    QVERIFY2(hall.toasts().join(QLatin1Char('|')).contains(QLatin1String("saved")),
             qPrintable(hall.toasts().join(QLatin1Char('|'))));
    // Another window sees it.
    Hall other(hall.robot);
    other.open();
    QCOMPARE(other.cell(31, 41), 100);
  }

  void nothingIsSentBeforeSomebodySaysSo() {
    Hall hall;
    hall.open();
    hall.paint(kSpot);
    hall.action("save")->trigger();
    QMessageBox* const question = hall.control().sendingQuestion();
    QVERIFY(question);
    const QString told = question->text() + question->informativeText();
    QVERIFY2(told.contains(hall.window->session()->wholeMap().name()), qPrintable(told));
    QVERIFY2(told.contains(QStringLiteral("%1 cells").arg(kSpot.area())), qPrintable(told));
    QVERIFY2(told.contains(QStringLiteral("127.0.0.1")), qPrintable(told));
    QTest::keyClick(question, Qt::Key_Return);  // the default is not to send
    QTRY_VERIFY(!hall.control().sendingQuestion());
    QVERIFY(!hall.control().saving() && hall.editing().unsaved());
    hall.action("save")->trigger();
    hall.action("save")->trigger();                                     // asked once
    QTRY_COMPARE(hall.window->findChildren<QMessageBox*>().size(), 1);  // the first one goes with its event
    hall.control().sendingQuestion()->findChild<QPushButton*>(QStringLiteral("sendPicture"))->click();
    QVERIFY(hall.control().saving());
    QTRY_VERIFY(!hall.control().saving() && !hall.editing().unsaved());
  }

  void whatTheRobotHasIsKeptBeforeItIsOverwritten() {
    Hall hall;
    hall.keeps_copies = true;
    hall.open();
    const auto before = hall.editing().saved();
    hall.paint(kSpot);
    hall.action("save")->trigger();
    const QString told = hall.control().sendingQuestion()->informativeText();
    QVERIFY2(told.contains(hall.folder.filePath(QStringLiteral("mapwright/overwritten"))), qPrintable(told));
    QVERIFY(hall.copies().isEmpty());  // nothing is overwritten yet
    hall.control().sendingQuestion()->findChild<QPushButton*>(QStringLiteral("sendPicture"))->click();
    QTRY_VERIFY(!hall.control().saving() && !hall.editing().unsaved());
    QCOMPARE(hall.copies().size(), 1);
    QVERIFY2(hall.toasts().join(QLatin1Char('|')).contains(hall.copies().first()),
             qPrintable(hall.toasts().join(QLatin1Char('|'))));
    // It can be opened like any local map, and has the cells of before.
    QString pgm = hall.copies().first();
    pgm.replace(QLatin1String(".yaml"), QLatin1String(".pgm"));
    QFile file(pgm);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    const qsizetype cells = qsizetype(before->width()) * before->height();
    QVERIFY(bytes.size() > cells);
    const auto shade = [&](int x, int y) {
      return int(std::uint8_t(bytes[bytes.size() - cells + qsizetype(y) * before->width() + x]));
    };
    for (int y = 0; y < before->height(); ++y) {
      for (int x = 0; x < before->width(); ++x) {
        const int cell = before->at(x, y);
        QCOMPARE(shade(x, y), cell == 0 || cell == 100 ? cell : 255);  // mode raw: as they were
      }
    }
  }

  void asManyCopiesAreKeptAsIsSaid() {
    Hall hall;
    const QString folder = edit::copiesFolder(hall.folder.filePath(QStringLiteral("mapwright/drafts")),
                                              QStringLiteral("ws://a/../b"), QStringLiteral("../../<Hall>"));
    QVERIFY2(folder.startsWith(hall.folder.filePath(QStringLiteral("mapwright/overwritten/"))) &&
                 !folder.contains(QLatin1String("/../")),
             qPrintable(folder));
    const auto builder = grids::buildGrid(3, 2, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
    builder->finish();
    map::GridReference place;
    place.width = 3;
    place.height = 2;
    place.resolution_m = 1;
    const QDateTime first(QDate(2026, 1, 2), QTime(3, 4, 5));
    for (int i = 0; i < edit::kMostCopies + 3; ++i)
      QVERIFY(!edit::keepCopy(*builder->pyramid(), place, edit::copyPath(folder, first.addSecs(i))));
    QCOMPARE(hall.copies().size(), edit::kMostCopies);
    QCOMPARE(hall.copies().first(), edit::copyPath(folder, first.addSecs(3)));
    QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 2 * edit::kMostCopies);
  }

  void theOldestGoWhereTheyTakeTooMuchRoom() {
    const auto copy = [](const char* map, int second, qint64 bytes) {
      edit::PictureCopy made;
      made.map = QString::fromLatin1(map);
      made.path = QStringLiteral("/robot/%1/%2.yaml").arg(made.map).arg(second);
      made.made = QDateTime(QDate(2026, 1, 2), QTime(3, 4, second));
      made.bytes = bytes;
      return made;
    };
    const auto gone = [](const std::vector<edit::PictureCopy>& copies, qint64 most) {
      QStringList paths;
      for (const edit::PictureCopy& one : edit::copiesTooMany(copies, most)) paths << one.path;
      return paths;
    };
    const std::vector<edit::PictureCopy> copies{copy("hall", 9, 40), copy("attic", 8, 40),
                                                copy("hall", 7, 40), copy("hall", 6, 10),
                                                copy("cellar", 5, 90)};
    QVERIFY(gone(copies, 1'000).isEmpty());
    // The newest of each map stays, whatever it takes.
    QCOMPARE(gone(copies, 100), QStringList{QStringLiteral("/robot/hall/7.yaml")});
    QCOMPARE(gone(copies, 1),
             (QStringList{QStringLiteral("/robot/hall/7.yaml"), QStringLiteral("/robot/hall/6.yaml")}));
  }

  void aCopyIsPutBackAndLookedAtBeforeItIsSent() {
    Hall hall;
    hall.keeps_copies = true;
    hall.open();
    const auto original = hall.editing().saved();
    hall.paint(kSpot);
    hall.save();
    QTRY_VERIFY(!hall.control().saving() && !hall.editing().unsaved());
    QCOMPARE(hall.copies().size(), 1);
    hall.action("pictureCopies")->trigger();
    CopiesDialog* const dialog = hall.control().copiesDialog();
    QVERIFY(dialog);
    QTRY_COMPARE(dialog->table()->rowCount(), 1);
    QVERIFY2(dialog->putBackButton()->isEnabled(), qPrintable(dialog->statusShown()));
    QVERIFY(dialog->table()->item(0, 3)->text().contains(
        QStringLiteral("%1 x %2 cells").arg(original->width()).arg(original->height())));
    ShownFolders shown;
    QTest::mouseClick(dialog->folderButton(), Qt::LeftButton);
    QCOMPARE(shown.folders, QStringList{QFileInfo(hall.copies().front()).path()});
    QTest::mouseClick(dialog->putBackButton(), Qt::LeftButton);
    QTRY_VERIFY(hall.editing().unsaved());
    // As it was, cell by cell; and nothing has been sent.
    QCOMPARE(picture::DifferenceCount::between(*hall.editing().grid(), *original).cells, std::int64_t(0));
    QCOMPARE(hall.editing().changedCells(), kSpot.area());
    QVERIFY(!hall.control().saving() && !hall.control().sendingQuestion());
    QVERIFY(hall.action("undo")->text().contains(QLatin1String("put back the copy of")));
    hall.action("undo")->trigger();
    QCOMPARE(hall.cell(31, 41), 100);
    hall.action("redo")->trigger();
    hall.save();
    QTRY_VERIFY(!hall.control().saving() && !hall.editing().unsaved());
    QCOMPARE(hall.copies().size(), 2);  // that one, too, was kept before
    Hall other(hall.robot);
    other.open();
    QVERIFY(other.cell(31, 41) != 100);
  }

  void theRobotOfACopyIsCalledByItsName() {
    Hall hall;
    hall.keeps_copies = true;
    hall.open();
    hall.paint(kSpot);
    hall.save();
    QTRY_VERIFY(!hall.control().saving() && !hall.editing().unsaved());
    hall.action("pictureCopies")->trigger();
    QTRY_COMPARE(hall.control().copiesDialog()->table()->rowCount(), 1);
    QCOMPARE(hall.control().copiesDialog()->table()->item(0, 2)->text(),
             QStringLiteral("127.0.0.1:%1").arg(hall.robot->rosPort()));
  }

  void theMapThatTheRobotMakesIsShownInsteadOfTheOneThatItLeft() {
    Hall hall;
    hall.open();
    const session::MapSlot& slot = hall.window->session()->wholeMap();
    const QString left = slot.name();
    QVERIFY(!left.isEmpty() && hall.window->windowTitle().contains(left));
    // It works with a map, and there has been no mapping.
    QVERIFY(!hall.action("saveNewMap")->isEnabled());
    QVERIFY2(hall.action("saveNewMap")->toolTip().contains(QLatin1String("no new map")),
             qPrintable(hall.action("saveNewMap")->toolTip()));
    hall.action("startMapping")->trigger();
    QTRY_VERIFY(part<AdministrationController>(*hall.window)->dialog());
    part<AdministrationController>(*hall.window)->dialog()->acceptButton()->click();
    QTRY_COMPARE(slot.key().kind, map::MapKind::Live);
    QTRY_VERIFY2(!hall.window->windowTitle().contains(left), qPrintable(hall.window->windowTitle()));
    QTRY_COMPARE(slot.phase(), session::MapSlot::Phase::Ready);
    QVERIFY2(!mapShownText(slot).contains(left), qPrintable(mapShownText(slot)));
    QVERIFY(!hall.window->session()->placesOf(slot));
    QVERIFY(hall.action("saveNewMap")->isEnabled());
  }

  void aCopyOfAnotherMapIsNotPutBack() {
    Hall hall;
    hall.keeps_copies = true;
    hall.open();
    const QString folder =
        edit::copiesFolder(hall.folder.filePath(QStringLiteral("mapwright/drafts")),
                           QStringLiteral("ws://elsewhere"), QStringLiteral("<b>Attic</b>"));
    const auto builder = grids::buildGrid(3, 2, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
    builder->finish();
    map::GridReference place;
    place.width = 3;
    place.height = 2;
    place.resolution_m = 1;
    QVERIFY(!edit::keepCopy(*builder->pyramid(), place,
                            edit::copyPath(folder, QDateTime(QDate(2026, 1, 2), QTime(3, 4)))));
    hall.action("pictureCopies")->trigger();
    CopiesDialog* const dialog = hall.control().copiesDialog();
    QTRY_COMPARE(dialog->table()->rowCount(), 1);
    QVERIFY(!dialog->putBackButton()->isEnabled());
    QVERIFY2(dialog->statusShown().contains(QLatin1String("a copy of another map")),
             qPrintable(dialog->statusShown()));
    QVERIFY(dialog->openButton()->isEnabled());
    // One that has rotted says so.
    QString pgm = hall.copies().first();
    QFile file(pgm.replace(QLatin1String(".yaml"), QLatin1String(".pgm")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    dialog->list(
        edit::copiesKept(edit::allCopiesFolder(hall.folder.filePath(QStringLiteral("mapwright/drafts")))));
    QCOMPARE(dialog->statusShown(), QStringLiteral("This copy cannot be read."));
    QVERIFY(!dialog->openButton()->isEnabled());
  }

  void withoutACopyNothingIsOverwritten() {
    Hall hall;
    hall.keeps_copies = true;
    hall.open();
    QFile obstacle(hall.folder.filePath(QStringLiteral("mapwright/overwritten")));
    QVERIFY(QDir().mkpath(hall.folder.filePath(QStringLiteral("mapwright"))));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    hall.paint(kSpot);
    hall.save();
    QTRY_VERIFY(!hall.control().saving());
    QVERIFY(hall.editing().unsaved());
    QVERIFY2(hall.status().contains(QLatin1String("Nothing was sent")), qPrintable(hall.status()));
    Hall other(hall.robot);
    other.open();
    QVERIFY(other.cell(31, 41) != 100);
    // Once it can be kept, it is sent.
    QVERIFY(obstacle.remove());
    hall.save();
    QTRY_VERIFY(!hall.control().saving() && !hall.editing().unsaved());
  }

  void whatOthersPaintMeanwhileIsPutTogether() {
    Hall hall;
    hall.open();
    hall.paint(kSpot);
    const auto before = hall.editing().saved();
    hall.robot->otherPainter();
    hall.save();
    QTRY_VERIFY(!hall.control().saving() && !hall.editing().unsaved());
    QCOMPARE(hall.cell(31, 41), 100);
    QTRY_VERIFY(hall.editing().saved() != before);
    // Theirs, too.
    const auto differs = picture::DifferenceCount::between(*hall.editing().grid(), *before);
    QVERIFY(differs.cells > kSpot.area());
  }

  void whatOthersPaintComesByItself() {
    Hall hall;
    hall.open();
    hall.paint(kSpot);
    const auto before = hall.editing().saved();
    hall.robot->otherPainter();
    QTRY_VERIFY(hall.editing().saved() != before);
    QVERIFY(hall.editing().unsaved());
    QCOMPARE(hall.cell(31, 41), 100);
  }

  void whatTheRobotDoesNotShowIsToldAndStaysUnsaved() {
    Hall hall(firstSave(simulator::FaultKind::Ignore, simulator::kWrites));
    hall.confirm = std::chrono::milliseconds(100);
    hall.open();
    hall.paint(kSpot);
    hall.save();
    QTRY_VERIFY(!hall.control().saving());
    QVERIFY(hall.editing().unsaved());
    // The robot may send the picture that it has within that time, or not.
    QVERIFY2(hall.status().contains(QLatin1String("Not confirmed")) ||
                 hall.status().contains(QLatin1String("the same picture as before")),
             qPrintable(hall.status()));
  }

  void aLinkLostAfterwardsIsNoDoubtWhereTheMapShowsIt() {
    Hall hall(firstSave(simulator::FaultKind::Cut, simulator::kServices));
    hall.open();
    hall.paint(kSpot);
    hall.save();
    QTRY_VERIFY(!hall.control().saving());
    const QString told = hall.toasts().join(QLatin1Char('|'));
    QVERIFY2(told.contains(QLatin1String("Ground floor saved")), qPrintable(told));
    QVERIFY(!hall.editing().unsaved());
    QCOMPARE(hall.cell(31, 41), 100);
    QCOMPARE(hall.status(), QStringLiteral("No unsaved changes."));
  }

  /// What was on its way before says nothing about what became of it.
  void whatTheRobotSentBeforeIsNoAnswer() {
    Hall hall(firstSave(simulator::FaultKind::Cut, simulator::kServices));
    hall.confirm = std::chrono::milliseconds(1);
    hall.open();
    hall.paint(kSpot);
    hall.save();
    QTRY_VERIFY(!hall.control().saving());
    QStringList told;
    const auto hear = [&] { return (told << hall.toasts()).last(); };
    QTRY_VERIFY2(!hall.editing().unsaved(), qPrintable(hear()));
    QTRY_VERIFY(hear().contains(QLatin1String("saved")));
    const QString all = told.join(QLatin1Char('|'));
    QVERIFY2(!all.contains(QLatin1String("was not saved")), qPrintable(all));
    QCOMPARE(hall.status(), QStringLiteral("No unsaved changes."));
  }

  void aLinkLostBeforeItWasStoredIsToldOnceItIsBack() {
    Hall hall(firstSave(simulator::FaultKind::Drop, simulator::kWrites));
    hall.confirm = std::chrono::milliseconds(200);
    hall.open();
    hall.paint(kSpot);
    hall.save();
    QTRY_VERIFY(!hall.control().saving());
    const auto told = [&] { return hall.toasts().join(QLatin1Char('|')); };
    QTRY_VERIFY2(told().contains(QLatin1String("was not saved: the robot has the same picture as before")),
                 qPrintable(told()));
    QVERIFY(hall.editing().unsaved());
    QVERIFY2(hall.status().contains(QLatin1String("was not saved")), qPrintable(hall.status()));
  }
};

}  // namespace test_window_kabam_picture

MAPWRIGHT_TEST(test_window_kabam_picture, TestWindowKabamPicture, Widgets)
#include "test_window_kabam_picture.moc"
