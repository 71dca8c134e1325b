// A KABAM robot whose rosbridge stalls while its waypoints are edited, in the window on its simulator.
#include <QAction>
#include <QTableView>
#include <QtTest>

#include "robot/robot.h"
#include "robot/ros/ros_address.h"
#include "robot/ros/ros_robot.h"
#include "simulator/simulator.h"
#include "test_program.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_view.h"
#include "ui/waypoints/waypoint_review.h"
#include "ui/waypoints/waypoints_controller.h"
#include "ui/waypoints/waypoints_dock.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_window_stalls {

using namespace mapwright;
using namespace mapwright::ui;
using std::chrono::milliseconds;

namespace {

struct Desk {
  explicit Desk(milliseconds given_up_after)
      : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {
    simulator::Options options;
    options.paused = true;
    robot = std::make_unique<simulator::Simulator>(options);
    if (robot->start()) qFatal("no robot");
    MainWindow::Dependencies wanted{
        [=, this](const QString& address,
                  const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          robot::ros::LinkOptions made;
          made.url = QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(robot->rosPort()));
          made.kabam_only = true;
          made.client.link.ask_after = milliseconds(100);
          made.client.link.look_every = milliseconds(50);
          made.client.link.quiet_after = milliseconds(500);
          made.client.link.silent_after = given_up_after;
          made.client.link.connect_timeout = milliseconds(500);
          made.client.link.backoff_first = milliseconds(20);
          made.client.link.backoff_limit = milliseconds(50);
          return std::make_unique<robot::ros::RosRobot>(address, made);
        },
        settings};
    wanted.addresses = robot::Addresses({robot::ros::kabamAddressScheme()});
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(1366, 768);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
  }
  ~Desk() { window.reset(); }

  /// Two changes, one of them taken back, and the review is open.
  void edit() {
    QVERIFY(!window->connectTo(QStringLiteral("kabam+ws://127.0.0.1:%1").arg(robot->rosPort())));
    QTRY_VERIFY(editing().document() && editing().document()->items().size() == 12);
    control().dock()->show();
    control().dock()->raise();
    QTRY_VERIFY(control().dock()->table()->isVisible());
    moved = editing().document()->items().begin()->first;
    editing().select({moved});
    editing().moveSelected({0.25, 0});
    editing().moveSelected({0, 0.5});
    editing().document()->undoStack().undo();
    at = editing().find(moved)->position_m;
    window->actionList().find(QLatin1String("save"))->trigger();
    QTRY_VERIFY(control().review() && control().review()->isVisible());
    QTRY_COMPARE(control().review()->model()->rowCount(), 1);
  }
  /// All of what was edited is there.
  bool keepsAll() {
    const auto* const document = editing().document();
    if (!document || document->items().size() != 12 || !editing().find(moved)) return false;
    return (editing().find(moved)->position_m - at).norm() < 1e-9 && control().unsaved() &&
           control().dock()->table()->model()->rowCount() == 12 &&
           editing().document()->undoStack().canUndo() && editing().document()->undoStack().canRedo() &&
           control().review()->isVisible() && control().review()->model()->rowCount() == 1;
  }
  /// Somewhere it is told in amber that nothing comes.
  bool tellsSilence() {
    const auto labels = window->findChildren<StateLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const StateLabel* label) {
      return label->isVisible() && label->state().mark == Mark::Warning &&
             label->state().text.startsWith(QLatin1String("nothing for "));
    });
  }
  robot::ConnectionPhase phase() { return window->session()->connection().phase; }
  WaypointsController& control() { return *part<WaypointsController>(*window); }
  WaypointEditing& editing() { return *control().editing(); }

  QTemporaryDir folder;
  QSettings settings;
  std::unique_ptr<simulator::Simulator> robot;
  std::unique_ptr<MainWindow> window;
  edit::Key moved;
  Eigen::Vector2d at{0, 0};
};

}  // namespace

class TestWindowStalls : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aStalledRobotIsToldInAmberAndNothingIsTakenAway() {
    Desk desk(milliseconds(60'000));
    desk.edit();
    QVERIFY(desk.keepsAll() && !desk.tellsSilence());
    desk.robot->stallRos();
    QTRY_VERIFY(desk.tellsSilence());
    QCOMPARE(desk.phase(), robot::ConnectionPhase::Online);
    QVERIFY(desk.keepsAll());
    desk.robot->unstallRos();
    QTRY_VERIFY(!desk.tellsSilence());
    QVERIFY(desk.keepsAll());
  }

  void oneThatIsGivenUpTakesNothingAwayEither() {
    Desk desk(milliseconds(1'500));
    desk.edit();
    desk.robot->stallRos();
    QTRY_VERIFY(desk.phase() != robot::ConnectionPhase::Online);
    QVERIFY(desk.keepsAll());
    // Every new connection is accepted by nobody.
    QTest::qWait(1'500);
    QVERIFY(desk.phase() != robot::ConnectionPhase::Online);
    QVERIFY(desk.keepsAll());
    desk.robot->unstallRos();
    QTRY_COMPARE(desk.phase(), robot::ConnectionPhase::Online);
    QTRY_VERIFY(!desk.tellsSilence());
    QVERIFY(desk.keepsAll());
    // And it can be sent.
    QTRY_VERIFY(desk.control().review()->sendButton()->isEnabled());
    QTest::mouseClick(desk.control().review()->sendButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.control().unsaved());
    QVERIFY((desk.editing().find(desk.moved)->position_m - desk.at).norm() < 1e-6);
  }
};

}  // namespace test_window_stalls

MAPWRIGHT_TEST(test_window_stalls, TestWindowStalls, Widgets)
#include "test_window_stalls.moc"
