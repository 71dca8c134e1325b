// Overlays of a GeoJSON file in the window: edited, saved, and changed by somebody else meanwhile.
#include <QComboBox>

#include "disk/read_file.h"
#include "overlays_desk.h"
#include "robot/files/file_address.h"
#include "robot/files/file_robot.h"
#include "test_program.h"

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
  void put(const std::string& text) const {
    QFile file(path());
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text.data(), qint64(text.size())), qint64(text.size()));
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
    desk.save();
    QVERIFY(desk.says("saved"));
    QTRY_COMPARE(desk.there(), Desk::with("[[0.00,0],[4,0]]", "[[0,1],[4,1]]"));
    // A later change of the file has been noticed: so has that one.
    desk.put(kOverlays);
    QTRY_COMPARE(desk.coordinates(0), std::string("[[0.00,0],[4,0]]"));
    QCOMPARE(desk.toasts().filter(QStringLiteral("changed on disk")).size(), 1);
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
