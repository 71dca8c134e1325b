// The pictures of docs/window.md, made by the program itself: each task is done in a real window, and what is
// seen then is the picture. docs/draw-pictures writes them; without it the test shows that the tasks work.
#include <functional>

#include <QDockWidget>
#include <QFile>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "app/robot_factory.h"
#include "replay/replay_robot.h"
#include "robot/address.h"
#include "robot/bag_library.h"
#include "simulator/simulator.h"
#include "test_program.h"
#include "ui/replay/replay_controller.h"
#include "ui/shell/replay_clock.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "window/main_window.h"
#include "window/window_parts.h"

namespace test_guide_pictures {

using namespace mapwright;

namespace {

/// A robot that stands still in time, so that its pictures hardly change from one run to the next.
simulator::Options frozen() {
  simulator::Options options;
  options.paused = true;
  options.start_at_s = 90;
  return options;
}

class Desk {
 public:
  explicit Desk(const simulator::Options& options = frozen())
      : robot_(options), settings_(folder_.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {
    if (const auto error = robot_.start()) qFatal("%s", error->c_str());
    window::MainWindow::Dependencies wanted{
        [](const QString& to, const QByteArray&) { return app::makeRobot(to, {}, app::DemoTime::Frozen); },
        settings_};
    wanted.addresses = app::knownAddresses();
    wanted.edit.drafts_folder = folder_.filePath(QStringLiteral("drafts"));
    window_ = std::make_unique<window::MainWindow>(std::move(wanted));
    window_->resize(1366, 768);
    window_->show();
    window_->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window_.get());
  }
  ~Desk() { window_.reset(); }

  window::MainWindow& window() { return *window_; }
  session::Session* session() { return window_->session(); }
  const simulator::Simulator& robot() const { return robot_; }
  bool connectTo(const std::string& address) {
    return !window_->connectTo(QString::fromStdString(address)) && settles();
  }
  /// Opens the first map that the robot stores.
  bool openMap() {
    const auto stored = [this]() -> const map::CatalogueEntry* {
      for (const map::CatalogueEntry& entry : session()->catalogue().entries())
        if (entry.key.kind == map::MapKind::Stored) return &entry;
      return nullptr;
    };
    if (!QTest::qWaitFor([&] { return stored() != nullptr; }, 20'000)) return false;
    session()->openMap(stored()->key);
    return QTest::qWaitFor([this] { return session()->wholeMap().cells() && window_->mapScene()->settled(); },
                           20'000);
  }
  void act(const char* id) {
    QAction* const action = window_->actionList().find(QLatin1String(id));
    if (!action) qFatal("no action %s", id);
    action->trigger();
  }
  void front(const char* dock) {
    auto* const panel = window_->findChild<QDockWidget*>(QLatin1String(dock));
    if (!panel) qFatal("no dock %s", dock);
    panel->show();
    panel->raise();
  }
  bool settles() {
    return QTest::qWaitFor(
        [this] {
          return session() && session()->counts().pending == 0 && session()->wholeMap().settled() &&
                 window_->mapScene()->settled();
        },
        60'000);
  }
  /// Waits until nothing moves; written if asked to.
  bool picture(const char* name) {
    const bool quiet =
        settles() &&
        QTest::qWaitFor(
            [this] { return window::part<window::MapOverlay>(*window_)->toasts()->texts().isEmpty(); },
            20'000);
    const QImage seen = window_->grab().toImage();
    const QString folder = qEnvironmentVariable("MAPWRIGHT_GUIDE_PICTURES");
    if (!folder.isEmpty() &&
        !seen.save(folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"), nullptr, 0))
      return false;
    return quiet && seen.size() == QSize(1366, 768);
  }

 private:
  simulator::Simulator robot_;
  QTemporaryDir folder_;
  QSettings settings_;
  std::unique_ptr<window::MainWindow> window_;
};

}  // namespace

class GuidePicturesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void inspectWhatARobotKnows() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    desk.act("modeBoth");
    desk.front("layers");
    desk.front("robot");
    desk.act("fit");
    QVERIFY(desk.picture("inspect"));
  }

  void editWaypoints() {
    Desk desk(simulator::Options{});  // its rosbridge needs time that passes
    QVERIFY(desk.connectTo(desk.robot().kabamAddress()) && desk.openMap());
    desk.front("waypoints");
    desk.act("waypointTool");
    desk.act("fit");
    QVERIFY(desk.picture("waypoints"));
  }

  void cleanAMap() {
    Desk desk(simulator::Options{});  // its rosbridge needs time that passes
    QVERIFY(desk.connectTo(desk.robot().kabamAddress()) && desk.openMap());
    desk.act("pictureTool");
    desk.front("picture");
    desk.act("fit");
    QVERIFY(desk.picture("clean"));
  }

  void replayWhatHappened() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    robot::BagKey key;
    bool listed = false;
    const auto call = desk.session()->robot().bagLibrary()->list([&](auto bags) {
      listed = true;
      if (bags && bags->size() > 2) key = (*bags)[1].key;
    });
    QTRY_VERIFY(listed);
    auto* const replay = window::part<window::ReplayController>(desk.window());
    QVERIFY(replay);
    replay->openBag(key);
    QTRY_VERIFY_WITH_TIMEOUT(replay->clock().isOpen(), 30'000);
    desk.act("modeWhole");
    QTRY_VERIFY_WITH_TIMEOUT(replay->clock().readShare() == 1, 30'000);
    replay->clock().seek(replay->clock().start() + 300);
    QTRY_VERIFY(replay->clock().knowledge() == replay::Knowledge::Exact);
    desk.front("events");
    desk.front("timeline");
    desk.front("robot");
    desk.act("fit");
    QVERIFY(desk.picture("replay"));
  }

  void compareTwoMaps() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    desk.act("modeWhole");
    desk.act("compare");
    desk.act("fit");
    QVERIFY(desk.picture("compare"));
  }

  /// A picture that nothing makes would show an old program for ever.
  void theGuideShowsJustThese() {
    QFile guide(QFINDTESTDATA("../../docs/window.md"));
    QVERIFY(guide.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(guide.readAll());
    QStringList shown;
    for (auto all = QRegularExpression(QStringLiteral("\\]\\(pictures/(\\w+)\\.png\\)")).globalMatch(text);
         all.hasNext();) {
      shown << all.next().captured(1);
      QVERIFY2(QFile::exists(QFINDTESTDATA("../../docs/pictures/") + shown.back() + QStringLiteral(".png")),
               qPrintable(shown.back()));
    }
    shown.sort();
    QCOMPARE(shown,
             (QStringList{QStringLiteral("clean"), QStringLiteral("compare"), QStringLiteral("inspect"),
                          QStringLiteral("replay"), QStringLiteral("waypoints")}));
  }
};

}  // namespace test_guide_pictures

MAPWRIGHT_TEST(test_guide_pictures, GuidePicturesTest, Widgets)
#include "test_guide_pictures.moc"
