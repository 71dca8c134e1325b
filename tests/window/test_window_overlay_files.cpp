// Overlays of a GeoJSON file in the window: edited, saved, and changed by somebody else meanwhile.
#include <QComboBox>
#include <QSaveFile>
#include <QSignalSpy>

#include "disk/read_file.h"
#include "overlays_desk.h"
#include "robot/files/file_address.h"
#include "robot/files/file_robot.h"
#include "test_program.h"
#include "ui/view/empty_state.h"
#include "ui/view/notice_bar.h"

namespace test_window_overlay_files {

using namespace test_overlays_desk;

namespace {

struct FileDesk : Desk {
  FileDesk() { put(kOverlays); }
  QString address() const override { return QStringLiteral("file:") + path(); }
  robot::Addresses schemes() const override { return robot::Addresses({robot::files::addressScheme()}); }
  std::unique_ptr<robot::Robot> shown() override {
    robot::files::FileOptions options;
    options.path = path();
    return std::make_unique<robot::files::FileRobot>(address(), std::move(options));
  }
  QString path() const { return folder.filePath(QStringLiteral("hall.geojson")); }
  /// At once: a file that is written piece by piece may be read in between.
  void put(const std::string& text) const {
    QSaveFile file(path());
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text.data(), qint64(text.size())), qint64(text.size()));
    QVERIFY(file.commit());
  }
  std::string there() const { return disk::readFile(path().toStdString(), 1 << 20).value_or(""); }
  void moveWallHere() { drag(px(2, 0), px(2, 1)); }
};

}  // namespace

class TestWindowOverlayFiles : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsSavedHereIsNoChangeOfSomebodyElse() {
    FileDesk desk;
    desk.open();
    desk.moveWallHere();
    QSignalSpy noticed(&desk.window->session()->robot(), &robot::Robot::mapsChanged);
    desk.save();
    QVERIFY(desk.says("saved"));
    QTRY_COMPARE(desk.there(), Desk::with("[[0.00,0],[4,0]]", desk.coordinates(0)));
    QTRY_COMPARE(noticed.size(), 1);
    desk.put(kOverlays);
    QTRY_COMPARE(desk.coordinates(0), std::string("[[0.00,0],[4,0]]"));
    QTRY_COMPARE(desk.toasts().filter(QStringLiteral("changed on disk")).size(), 1);
  }

  void aFileIsNotCalledARobot() {
    FileDesk desk;
    desk.open();
    desk.moveWallHere();
    desk.put(Desk::with("[[0.00,0],[4,0]]", "[[0.00,3],[4,3]]"));
    QTRY_COMPARE(desk.stateOf(0), QStringLiteral("conflict"));
    desk.action("save")->trigger();
    QTRY_VERIFY(desk.says("both here and in the file"));
    QVERIFY(!desk.says("robot"));
    for (const QLabel* label : desk.dock().findChildren<QLabel*>())
      QVERIFY2(!label->text().contains(QStringLiteral("on the robot")), qPrintable(label->text()));
  }

  void aBrokenFileIsNotCalledReadNorSavedOver() {
    FileDesk desk;
    desk.open();
    desk.moveWallHere();
    QVERIFY(desk.dock().reviewButton()->isEnabled());
    desk.put("{\"features\": [}");
    QTRY_VERIFY(desk.dock().statusShown().contains(QLatin1String("cannot be read")));
    QVERIFY(!desk.dock().reviewButton()->isEnabled() && !desk.action("save")->isEnabled());
    auto* const notice = part<MapOverlay>(*desk.window)->notice();
    QTRY_VERIFY2(notice->sentence().startsWith(QStringLiteral("hall.geojson has not been readable since")),
                 qPrintable(notice->sentence()));
    QVERIFY(!desk.says("changed on disk"));
    // What is changed here is still there, and can be saved when the file is well again.
    desk.put(kOverlays);
    QTRY_VERIFY(desk.dock().reviewButton()->isEnabled() && desk.action("save")->isEnabled());
    QTRY_VERIFY(desk.says("changed on disk and was read again"));
  }

  void aFileThatCannotBeOpenedIsNamedOnce() {
    FileDesk desk;
    desk.put("{");
    desk.start(false);
    const auto* const card = part<MapOverlay>(*desk.window)->card();
    QTRY_VERIFY(card->isVisible());
    QTRY_COMPARE(card->findChild<QLabel*>(QStringLiteral("text"))->text().count(desk.path()), 1);
  }

  void whatSomebodyElseChangedIsChangedInTheFile() {
    FileDesk desk;
    desk.open();
    desk.put(Desk::with("\"Lab\"", "\"Office\""));
    QTRY_COMPARE(desk.stateOf(1), QStringLiteral("changed in the file"));
  }
};

}  // namespace test_window_overlay_files

MAPWRIGHT_TEST(test_window_overlay_files, TestWindowOverlayFiles, Widgets)
#include "test_window_overlay_files.moc"
