// Bags in the window: the list, the replay in the place of the live robot, and the timeline, with real mouse
// and keys, on the simulator.
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include "excerpt/excerpt.h"
#include "incident/report.h"
#include "recorder/layout.h"
#include "recording/source.h"
#include "replay/event_sentence.h"
#include "robot/axbot/axbot_address.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/files/file_address.h"
#include "robot/recorded/recorded_robot.h"
#include "simulator/simulator.h"
#include "submap/submap_store.h"
#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/plots/messages_dock.h"
#include "ui/plots/plots_controller.h"
#include "ui/plots/plots_dock.h"
#include "ui/replay/events_dock.h"
#include "ui/replay/range_export_dialog.h"
#include "ui/replay/record_dialog.h"
#include "ui/replay/recording_controller.h"
#include "ui/replay/recordings_controller.h"
#include "ui/replay/recordings_dock.h"
#include "ui/replay/replay_controller.h"
#include "ui/replay/timeline_dock.h"
#include "ui/robot/robot_look.h"
#include "ui/shell/replay_clock.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/replay_state.h"
#include "ui/view/toast_stack.h"
#include "ui/window/layout_controller.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_window_replay {

using namespace mapwright;
using namespace mapwright::ui;
using robot::BagKey;
using robot::BagKind;

namespace {

const BagKey kGap{BagKind::Bag, "gap.bag"};
const BagKey kWhole{BagKind::Bag, "same_stamps.bag"};

struct Desk {
  Desk() : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat), sim(options()) {
    if (sim.start()) qFatal("no simulator");
    address = QString::fromStdString(sim.address());
    MainWindow::Dependencies wanted{
        [this](const QString& to,
               const QByteArray& secret) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          secrets << secret;
          return makeRobot(to);
        },
        settings};
    wanted.addresses = robot::Addresses({robot::axbot::addressScheme(), robot::files::addressScheme()});
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(1366, 768);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
  }
  std::unique_ptr<robot::Robot> makeRobot(const QString& to = {}) {
    if (to.endsWith(QLatin1String(".mcap"))) {
      robot::recorded::RecordedOptions file;
      file.path = QString(to).remove(QStringLiteral("file:"));
      const std::string bag = robot::recorded::bagNameOf(file.path);
      return std::make_unique<replay::ReplayRobot>(
          std::make_unique<robot::recorded::RecordedRobot>(to, std::move(file)), bag, followedReading());
    }
    robot::axbot::LinkOptions link;
    link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(sim.port()));
    link.cache_folder = folder.filePath(QStringLiteral("cache"));
    return std::make_unique<robot::axbot::AxbotRobot>(to.isEmpty() ? address : to, link);
  }
  static simulator::Options options() {
    simulator::Options options;
    options.paused = true;
    options.start_at_s = 700;
    options.bags.odd = true;
    return options;
  }
  ~Desk() { window.reset(); }

  RecordingsDock& list() { return *part<RecordingsController>(*window)->dock(); }
  TimelineDock& timeline() { return *part<ReplayController>(*window)->dock(); }
  TimelineView& axis() { return *timeline().view(); }
  ReplayClock& clock() { return part<ReplayController>(*window)->clock(); }
  QAction* action(const char* id) { return window->actionList().find(QLatin1String(id)); }
  bool isReplay() {
    return window->session() && qobject_cast<replay::ReplayRobot*>(&window->session()->robot());
  }
  void connect(const QByteArray& secret = {}) {
    QVERIFY(!window->connectTo(address, secret));
    list().show();
    list().raise();
    QTRY_VERIFY(list().model()->rowCount() > 0);
  }
  void doubleClick(const BagKey& key) {
    list().select(key);
    const QModelIndex row = list().table()->currentIndex();
    QVERIFY(row.isValid());
    list().table()->scrollTo(row);
    const QPoint at = list().table()->visualRect(row).center();
    QTest::mouseClick(list().table()->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(list().table()->viewport(), Qt::LeftButton, {}, at);
  }
  /// The world on screen is that of the clock.
  bool isThere() {
    auto* const robot =
        isReplay() ? qobject_cast<replay::ReplayRobot*>(&window->session()->robot()) : nullptr;
    return robot && robot->at() == clock().at() && robot->knowledge() == replay::Knowledge::Exact;
  }
  /// What the robot sends now, until it stands in the file.
  QString record(const char* name) {
    RecordingController* const recorder = part<RecordingController>(*window);
    const QString path = folder.filePath(QLatin1String(name));
    const auto error = recorder->startInto(path);
    if (error) qFatal("%s", qPrintable(*error));
    for (int i = 0; i < 5; ++i) sim.advance(0.2);
    recorder->stop();
    const bool done = QTest::qWaitFor([&] { return recorder->shown().isEmpty(); }, 10'000);
    if (!done) qFatal("the recording did not end");
    return path;
  }
  /// The button of the toast that was shown last.
  void acceptOffer() {
    const auto buttons = part<MapOverlay>(*window)->toasts()->findChildren<QPushButton*>();
    QVERIFY(!buttons.isEmpty());
    buttons.last()->click();
  }
  /// Opened, and all of the moment is known.
  void replay(const BagKey& key) {
    connect();
    doubleClick(key);
    QTRY_VERIFY(clock().isOpen());
    QTRY_VERIFY(isThere());
  }
  QPoint pixelOf(double at_s) { return {int(std::lround(axis().axis().pixelOf(at_s))), axis().height() / 2}; }
  void click(double at_s, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(&axis(), Qt::LeftButton, modifiers, pixelOf(at_s));
  }
  void drag(double from_s, double until_s, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&axis(), Qt::LeftButton, modifiers, pixelOf(from_s));
    for (int part = 1; part <= 5; ++part) {
      const QPointF at = pixelOf(from_s + (until_s - from_s) * part / 5);
      QMouseEvent move(QEvent::MouseMove, at, axis().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       modifiers);
      QCoreApplication::sendEvent(&axis(), &move);
    }
    QTest::mouseRelease(&axis(), Qt::LeftButton, modifiers, pixelOf(until_s));
  }
  void key(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&axis(), Qt::Key(key), modifiers);
  }

  QTemporaryDir folder;
  QSettings settings;
  simulator::Simulator sim;
  QString address;
  QList<QByteArray> secrets;
  std::unique_ptr<MainWindow> window;
};

#define NEAR(a, b, within) \
  QVERIFY2(std::abs((a) - (b)) <= (within), qPrintable(QString::number((a) - (b), 'g', 9)))

}  // namespace

class TestWindowReplay : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void saysWhyThereIsNoList() {
    Desk desk;
    QVERIFY(!desk.list().emptyShown().isEmpty());
    QVERIFY(!desk.list().recordButton()->isEnabled());
    QVERIFY(!desk.timeline().view()->notice().isEmpty());
    QVERIFY(!desk.action("replayPlay")->isEnabled());
  }

  void theControlsFitASmallScreen() {
    Desk desk;
    desk.window->resize(800, 570);
    desk.action("layoutReplay")->trigger();
    QCoreApplication::processEvents();
    const int before = desk.window->minimumSizeHint().width();
    desk.replay(kGap);
    for (auto* label : desk.window->findChildren<StateLabel*>())
      label->setState({Mark::Warning, QStringLiteral("the range is missing ").repeated(20)});
    for (auto* button : desk.timeline().findChildren<QPushButton*>()) button->show();
    QCoreApplication::processEvents();
    QVERIFY2(desk.window->minimumSizeHint().width() <= 800,
             qPrintable(QString::number(desk.window->minimumSizeHint().width())));
    QCOMPARE(desk.window->minimumSizeHint().width(), before);
    QCOMPARE(desk.window->width(), 800);
  }

  void spacePlaysWhereverNothingIsTyped() {
    Desk desk;
    desk.replay(kGap);
    desk.action("layoutReplay")->trigger();
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    desk.clock().seek(desk.clock().start());
    auto* const events = desk.window->findChild<EventsDock*>();
    const auto plays = [&](QWidget* at) {
      at->setFocus();
      const bool before = desk.clock().playing();
      QTest::keyClick(at, Qt::Key_Space);
      return desk.clock().playing() != before;
    };
    QVERIFY(plays(desk.window->view()));
    for (QAbstractItemView* const list : {events->findChild<QAbstractItemView*>(),
                                          part<MessagesDock>(*desk.window)->findChild<QAbstractItemView*>()})
      QVERIFY(plays(list));
    QVERIFY(plays(&desk.axis()));
    for (QTabBar* const tabs : desk.window->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
      if (tabs->isVisible()) QVERIFY(plays(tabs));
    auto* const filter = part<MessagesDock>(*desk.window)->findChild<QLineEdit*>();
    QVERIFY(!plays(filter));
    QCOMPARE(filter->text(), QStringLiteral(" "));
  }

  void listsSortsAndSearches() {
    Desk desk;
    desk.connect();
    QVERIFY(desk.list().emptyShown().isEmpty());
    const QAbstractItemModel* const shown = desk.list().table()->model();
    const int all = shown->rowCount();
    QVERIFY(all > 8);
    desk.list().table()->sortByColumn(BagsModel::NameColumn, Qt::AscendingOrder);
    for (int row = 1; row < all; ++row)
      QVERIFY(shown->index(row - 1, 0).data().toString() <= shown->index(row, 0).data().toString());
    desk.list().search()->setFocus();
    QTest::keyClicks(desk.list().search(), QStringLiteral("EIGHT"));
    QCOMPARE(shown->rowCount(), 1);
    QCOMPARE(desk.list().summaryShown(), QStringLiteral("1 of %1 recordings").arg(all));
    QTest::keyClicks(desk.list().search(), QStringLiteral("x"));
    QVERIFY(!desk.list().emptyShown().isEmpty());
  }

  void severalRowsAreInViewOnASmallScreen() {
    Desk desk;
    desk.connect();
    QTableView& table = *desk.list().table();
    QTRY_VERIFY(table.viewport()->visibleRegion().boundingRect().height() >= 4 * table.rowHeight(0));
  }

  void aDamagedBagSaysSoOnItsRowAndTheRobotStays() {
    Desk desk;
    desk.connect();
    const auto corrupt = [&] {
      for (int row = 0;; ++row) {
        const robot::BagEntry* const entry = desk.list().model()->entry(row);
        if (!entry) qFatal("no such row");
        if (entry->key.name.find("_1008") != std::string::npos) return entry->key;
      }
    }();
    desk.doubleClick(corrupt);
    QTRY_COMPARE(desk.list().model()->note(corrupt).kind, BagNote::Kind::Failed);
    QVERIFY(!desk.list().model()->note(corrupt).text.isEmpty());
    QVERIFY(!desk.isReplay());
    QCOMPARE(desk.window->session()->connection().phase, robot::ConnectionPhase::Online);
  }

  void howLongABagIsStandsThereOnceItWasOpened() {
    Desk desk;
    desk.connect();
    const auto shown = [&] {
      return desk.list()
          .model()
          ->indexOf(kWhole)
          .siblingAtColumn(BagsModel::DurationColumn)
          .data()
          .toString();
    };
    QCOMPARE(shown(), QStringLiteral("—"));
    desk.doubleClick(kWhole);
    QTRY_VERIFY(desk.clock().isOpen());
    QTRY_VERIFY(desk.list().model()->rowCount() > 0);
    QCOMPARE(shown(),
             elapsedText(desk.clock().reading()->info()->end_s - desk.clock().reading()->info()->start_s)
                 .chopped(2));
  }

  void aDoubleClickReplaysInThePlaceOfTheRobot() {
    Desk desk;
    desk.replay(kWhole);
    QVERIFY(desk.isReplay());
    QVERIFY(desk.window->windowTitle().contains(QStringLiteral("same_stamps.bag")));
    QVERIFY(desk.timeline().isVisible());
    // Nothing can be changed on the robot.
    QCOMPARE(desk.window->session()->robot().waypointStore(), nullptr);
    QCOMPARE(desk.window->session()->robot().mapAdministration(), nullptr);
    QTRY_VERIFY(desk.list().model()->rowCount() > 0);
    desk.list().select(kWhole);
    QVERIFY(!desk.list().deleteButton()->isEnabled());
    QVERIFY(!desk.list().recordButton()->isEnabled());
  }

  void theTimeStandsInItsFieldInEveryReplay() {
    Desk desk;
    desk.replay(kWhole);
    const auto shown = [&] { return desk.timeline().timeField()->text(); };
    QCOMPARE(shown(), clockText(desk.clock().at()));
    QTRY_VERIFY(desk.list().model()->rowCount() > 0);
    desk.list().raise();
    desk.doubleClick(kGap);
    QTRY_VERIFY(desk.window->windowTitle().contains(QStringLiteral("gap.bag")));
    QTRY_VERIFY(desk.clock().isOpen() && desk.isThere());
    QCOMPARE(shown(), clockText(desk.clock().at()));
    desk.clock().seek(desk.clock().start() + 100);
    QCOMPARE(shown(), clockText(desk.clock().start() + 100));
  }

  void aBagOpensWithTheWholePathOfItsRobotInView() {
    Desk desk;
    desk.replay(kWhole);
    QTRY_COMPARE(desk.clock().readShare(), 1.0);
    const auto all_in_view = [&] {
      const geometry::WorldRect seen = desk.window->mapScene()->view().visibleWorld();
      for (const auto& [from, digest] : desk.clock().reading()->index().digests()) {
        for (const replay::Digest::Pose& pose : digest.poses) {
          if (!seen.contains(replay::placeOf(pose).position_m)) return false;
        }
      }
      return desk.window->mapScene()->robotPose().has_value();
    };
    QTRY_VERIFY(all_in_view());
  }

  void aRecordingOpensAtItsFirstMap() {
    Desk desk;
    desk.replay(kWhole);
    QTRY_VERIFY(desk.isThere() && desk.window->session()->world().submaps);
    QVERIFY(desk.clock().at() > desk.clock().start());
    const double opened_s = desk.clock().at();
    desk.clock().seek(opened_s - 0.01);
    QTRY_VERIFY(desk.isThere() && !desk.window->session()->world().submaps);
  }

  void aTimeBeforeTheFirstMapSaysSoHoweverOneCameThere() {
    Desk desk;
    desk.replay(kWhole);
    session::Session* const session = desk.window->session();
    QTRY_VERIFY(desk.isThere() && session->counts().shown > 0 && session->counts().pending == 0);
    // Until then the view is not chosen, and the next map would be fitted.
    QTRY_VERIFY(!desk.window->mapScene()->layerBounds(scene::Layer::Track).empty());
    desk.clock().seek(desk.clock().start());
    QTRY_VERIFY(desk.isThere());
    const auto says = [&] {
      return part<MapOverlay>(*desk.window)
          ->notice()
          ->sentence()
          .contains(QStringLiteral("contains no map up to this time"));
    };
    QVERIFY(!session->world().submaps);
    QTRY_VERIFY(says());
    // What comes later does not move what is looked at.
    const geometry::ViewTransform view = desk.window->mapScene()->view();
    for (const auto& [from, digest] : desk.clock().reading()->index().digests()) {
      if (!digest.poses.empty())
        QVERIFY(view.visibleWorld().contains(replay::placeOf(digest.poses.front()).position_m));
      if (!digest.poses.empty()) break;
    }
    desk.clock().seek(desk.clock().start() + 60);
    QTRY_VERIFY(desk.isThere() && session->counts().shown > 0 && session->counts().pending == 0);
    QTRY_VERIFY(!says());
    QCOMPARE(desk.window->mapScene()->view().scale_m_per_px, view.scale_m_per_px);
    QVERIFY(desk.window->mapScene()->view().center_m == view.center_m);
    desk.clock().seek(desk.clock().start());
    QTRY_VERIFY(desk.isThere() && !session->world().submaps);
    QVERIFY(session->submaps().rows().empty() && !session->submaps().listReceived());
    QTRY_VERIFY(says());
  }

  void howFarItIsStandsThereWhole() {
    Desk desk;
    desk.replay({BagKind::Bag, "eight_hours.bag"});
    desk.clock().seek(desk.clock().start() + 4 * 3600);
    const auto* const length = desk.timeline().findChild<PlainLabel*>();
    QCOMPARE(length->text(), desk.timeline().lengthShown());
    QVERIFY(length->text().contains(QStringLiteral("4:00:00")));
    QTRY_VERIFY(length->width() >= length->fontMetrics().horizontalAdvance(length->text()));
  }

  void withoutTheRobotNothingNewIsRecorded() {
    Desk desk;
    desk.connect();
    QAction* const record = desk.action("record");
    QTRY_VERIFY(desk.list().recordButton()->isEnabled() && record->isEnabled());
    desk.sim.stop();
    QTRY_VERIFY(!desk.list().recordButton()->isEnabled() && !record->isEnabled());
    QVERIFY(desk.list().recordButton()->toolTip().contains(QStringLiteral("cannot be reached")));
    QVERIFY(record->toolTip().contains(QStringLiteral("cannot be reached")));
  }

  void leadsBackToTheRobotWithItsSecret() {
    Desk desk;
    desk.connect("quiet");
    desk.doubleClick(kWhole);
    QTRY_VERIFY(desk.clock().isOpen());
    QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.isReplay());
    QVERIFY(!desk.clock().isOpen());
    QTRY_COMPARE(desk.window->session()->connection().phase, robot::ConnectionPhase::Online);
    QVERIFY(!desk.window->windowTitle().contains(QStringLiteral("same_stamps.bag")));
    QVERIFY(!desk.timeline().isVisible());
    QCOMPARE(desk.secrets, (QList<QByteArray>{"quiet", "quiet", "quiet"}));
  }

  void aRecordingThatIsPlayedLeadsBackToWhatWasOpenBefore_data() {
    QTest::addColumn<bool>("robot_left");
    QTest::newRow("the robot that was recorded") << false;
    QTest::newRow("nothing: the robot was left first") << true;
  }
  void aRecordingThatIsPlayedLeadsBackToWhatWasOpenBefore() {
    QFETCH(bool, robot_left);
    Desk desk;
    desk.connect("quiet");
    QTRY_COMPARE(desk.window->session()->connection().phase, robot::ConnectionPhase::Online);
    const QString path = desk.record("run.mcap");
    if (robot_left) desk.action("disconnect")->trigger();
    desk.acceptOffer();
    QTRY_VERIFY(desk.isReplay() && desk.clock().isOpen());
    // The file is not a robot.
    const QString said = part<MapOverlay>(*desk.window)->notice()->sentence();
    QVERIFY2(said.contains(QStringLiteral("not live")) && !said.contains(QStringLiteral("robot")),
             qPrintable(said));
    QCOMPARE(desk.timeline().backButton()->text(),
             robot_left ? QStringLiteral("Close the replay") : QStringLiteral("Back to the robot"));
    QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.isReplay());
    QCOMPARE(desk.window->session() == nullptr, robot_left);
    if (robot_left) return;
    QTRY_COMPARE(desk.window->session()->connection().phase, robot::ConnectionPhase::Online);
    QCOMPARE(desk.window->session()->robot().address(), desk.address);
    QCOMPARE(desk.secrets.last(), QByteArray("quiet"));
  }

  void theUsersNameOfARobotIsThereAfterAReplay() {
    Desk desk;
    desk.connect();
    QTRY_COMPARE(desk.window->session()->connection().phase, robot::ConnectionPhase::Online);
    desk.action("robotLook")->trigger();
    auto* const look = desk.window->findChild<RobotLookDialog*>();
    QVERIFY(look);
    look->findChild<QLineEdit*>()->setText(QStringLiteral("Forklift"));
    look->accept();
    QTRY_VERIFY(desk.window->windowTitle().contains(QStringLiteral("Forklift")));
    desk.doubleClick(kWhole);
    QTRY_VERIFY(desk.clock().isOpen());
    QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.isReplay());
    QTRY_VERIFY(desk.window->windowTitle().contains(QStringLiteral("Forklift")));
  }

  void aFieldIsPlottedOnWhereItsTopicWasRecorded() {
    Desk desk;
    desk.connect();
    PlotsDock* const plots = part<PlotsController>(*desk.window)->dock();
    plots->show();
    for (const char* field : {"/tracked_pose.pos[0]", "/nowhere.a"}) {
      plots->pathEdit()->setText(QLatin1String(field));
      QTest::keyClick(plots->pathEdit(), Qt::Key_Return);
      QVERIFY(plots->layout().contains(QLatin1String(field)));
    }
    // A recording has the topics that were received.
    QTRY_VERIFY((desk.sim.advance(0.2), desk.window->session()->live().robot_pose.has_value()));
    desk.record("run.mcap");
    desk.acceptOffer();
    QTRY_VERIFY(desk.isReplay() && desk.clock().isOpen());
    QVERIFY(plots->layout().contains(QStringLiteral("/tracked_pose.pos[0]")));
    QVERIFY(!plots->layout().contains(QStringLiteral("/nowhere.a")));
    QVERIFY2(plots->saidText().contains(QStringLiteral("/nowhere.a")), qPrintable(plots->saidText()));
    QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.isReplay());
    QVERIFY(plots->layout().contains(QStringLiteral("/tracked_pose.pos[0]")));
  }

  void aClickGoesToItsTime() {
    Desk desk;
    desk.replay(kWhole);
    const double middle_s = (desk.clock().start() + desk.clock().end()) / 2;
    desk.click(middle_s);
    NEAR(desk.clock().at(), middle_s, desk.axis().axis().secondsPerPixel());
    QTRY_VERIFY(desk.isThere());
    QTRY_VERIFY(desk.window->session()->live().robot_pose.has_value());
    const auto& trail = desk.window->session()->live().trail;
    QVERIFY(!trail.empty());
    QVERIFY(trail.back().at_s <= desk.clock().at());
    QVERIFY(trail.back().at_s > desk.clock().start() + 60);
  }

  void ofADragTheLastWantedTimeWins() {
    Desk desk;
    desk.replay(kWhole);
    const double start_s = desk.clock().start();
    desk.drag(start_s + 20, start_s + 420);
    NEAR(desk.clock().at(), start_s + 420, desk.axis().axis().secondsPerPixel());
    const double wanted_s = desk.clock().at();
    QTRY_VERIFY(desk.isThere());
    QCOMPARE(desk.clock().at(), wanted_s);
  }

  void keysStepAsInOtherPlayers() {
    Desk desk;
    desk.replay(kWhole);
    desk.axis().setFocus();
    const double start_s = desk.clock().start();
    QTRY_VERIFY(desk.clock().at() > start_s);  // at its first map
    desk.key(Qt::Key_Home);
    NEAR(desk.clock().at(), start_s, 1e-6);
    desk.key(Qt::Key_Right);
    NEAR(desk.clock().at(), start_s + 0.1, 1e-6);
    desk.key(Qt::Key_Right, Qt::ShiftModifier);
    NEAR(desk.clock().at(), start_s + 0.11, 1e-6);
    desk.key(Qt::Key_Right, Qt::AltModifier);
    NEAR(desk.clock().at(), start_s + 0.61, 1e-6);
    desk.key(Qt::Key_Left);
    NEAR(desk.clock().at(), start_s + 0.51, 1e-6);
    desk.key(Qt::Key_Home);
    QCOMPARE(desk.clock().at(), start_s);
    desk.key(Qt::Key_End);
    QCOMPARE(desk.clock().at(), desk.clock().end());
    desk.key(Qt::Key_Up);
    QCOMPARE(desk.clock().speed(), 2.0);
    desk.key(Qt::Key_Down);
    desk.key(Qt::Key_Down);
    QCOMPARE(desk.clock().speed(), 0.5);
  }

  void spacePlaysAndStandsStill() {
    Desk desk;
    desk.replay(kWhole);
    desk.axis().setFocus();
    desk.key(Qt::Key_Space);
    QVERIFY(desk.clock().playing());
    QTRY_VERIFY(desk.clock().at() > desk.clock().start() + 0.2);
    desk.key(Qt::Key_Space);
    QVERIFY(!desk.clock().playing());
    const double stands_s = desk.clock().at();
    // On the map Space alone plays, too; with a drag it moves the map.
    desk.window->view()->setFocus();
    QTest::keyClick(desk.window->view(), Qt::Key_Space);
    QVERIFY(desk.clock().playing());
    QTRY_VERIFY(desk.clock().at() > stands_s + 0.1);
    QTest::keyPress(desk.window->view(), Qt::Key_Space);
    QTest::mouseClick(desk.window->view()->viewport(), Qt::LeftButton, {}, QPoint(300, 200));
    QTest::keyRelease(desk.window->view(), Qt::Key_Space);
    QVERIFY(desk.clock().playing());
  }

  // However often the same time is looked at again.
  void standingStillNoMessageCountsTwice() {
    Desk desk;
    desk.replay(kWhole);
    desk.clock().seek(desk.clock().start() + 30);
    QTRY_VERIFY(desk.isThere());
    MessagesDock& messages = *part<MessagesDock>(*desk.window);
    messages.show();
    messages.raise();
    QTRY_VERIFY(messages.watching() && messages.log().topics().size() > 3);
    const auto told = [&] {
      quint64 count = 0;
      for (const auto& [topic, tally] : messages.log().topics()) count += tally.count;
      return count;
    };
    const quint64 before = told();
    auto* const robot = qobject_cast<replay::ReplayRobot*>(&desk.window->session()->robot());
    for (const char* const topic : {"/one", "/other"}) {
      QSignalSpy jumped(robot, &replay::ReplayRobot::jumped);
      desk.window->session()->want(QStringLiteral("test"), {}, {QLatin1String(topic)});
      QTRY_VERIFY(!jumped.isEmpty());
      QCoreApplication::processEvents();
    }
    QCOMPARE(told(), before);
    QCOMPARE(messages.log().topics().size(), std::size_t(before));
    // What is played counts.
    desk.axis().setFocus();
    desk.key(Qt::Key_Space);
    QTRY_VERIFY(told() > before);
  }

  void playsBackwardsByTheSpeedBox() {
    Desk desk;
    desk.replay(kWhole);
    desk.key(Qt::Key_End);
    QLineEdit* const typed = desk.timeline().speedBox()->lineEdit();
    typed->setFocus();
    typed->selectAll();
    QTest::keyClicks(typed, QStringLiteral("-5"));
    QTest::keyClick(typed, Qt::Key_Return);
    QCOMPARE(desk.clock().speed(), -5.0);
    QTest::mouseClick(desk.timeline().playButton(), Qt::LeftButton);
    QTRY_VERIFY(desk.clock().at() < desk.clock().end() - 1);
    typed->selectAll();
    QTest::keyClicks(typed, QStringLiteral("99"));
    QTest::keyClick(typed, Qt::Key_Return);
    QCOMPARE(desk.clock().speed(), -5.0);
  }

  void shiftDragLoopsAndEscEndsIt() {
    Desk desk;
    desk.replay(kWhole);
    const double start_s = desk.clock().start();
    desk.drag(start_s + 100, start_s + 200, Qt::ShiftModifier);
    QVERIFY(desk.clock().loop().has_value());
    NEAR(desk.clock().loop()->from_s, start_s + 100, desk.axis().axis().secondsPerPixel());
    NEAR(desk.clock().loop()->until_s, start_s + 200, desk.axis().axis().secondsPerPixel());
    desk.axis().setFocus();
    desk.key(Qt::Key_Escape);
    QVERIFY(!desk.clock().loop().has_value());
  }

  void aTypedTimeIsGoneTo() {
    Desk desk;
    desk.replay(kWhole);
    desk.action("replayTime")->trigger();
    QLineEdit* const field = desk.timeline().timeField();
    QTRY_VERIFY(field->hasFocus());
    QTest::keyClicks(field, QStringLiteral("+1:40"));
    QTest::keyClick(field, Qt::Key_Return);
    NEAR(desk.clock().at(), desk.clock().start() + 100, 1e-6);
    desk.action("replayTime")->trigger();
    QTest::keyClicks(field, QStringLiteral("nonsense"));
    QTest::keyClick(field, Qt::Key_Return);
    NEAR(desk.clock().at(), desk.clock().start() + 100, 1e-6);
    QTest::keyClick(field, Qt::Key_Escape);
    desk.action("replayTime")->trigger();
    desk.clock().setSpeed(20);
    QTest::keyClicks(field, QStringLiteral("+1:42"));
    QTest::keyClick(field, Qt::Key_Return, Qt::ControlModifier);
    QTRY_VERIFY(!desk.clock().playing());
    NEAR(desk.clock().at(), desk.clock().start() + 102, 1e-6);
  }

  void stepsFromMessageToMessage() {
    Desk desk;
    desk.replay(kWhole);
    desk.axis().setFocus();
    desk.click(desk.clock().start() + 100);
    QTRY_VERIFY(desk.isThere());
    const double before_s = desk.clock().at();
    desk.key(Qt::Key_Period);
    const double next_s = desk.clock().at();
    QVERIFY(next_s > before_s && next_s < before_s + 5);
    desk.key(Qt::Key_Period);
    QVERIFY(desk.clock().at() > next_s);
    desk.key(Qt::Key_Comma);
    NEAR(desk.clock().at(), next_s, 1e-6);
  }

  void marksWhatHappenedAndGoesThere() {
    Desk desk;
    desk.replay(kWhole);
    QTRY_VERIFY(!desk.axis().content().events.empty());
    QTRY_VERIFY(desk.clock().reading()->chunks().wholeRead());
    QTRY_COMPARE(desk.axis().content().events.size(),
                 replay::eventsOf(desk.clock().reading()->index().digests()).size());
    desk.axis().setFocus();
    desk.key(Qt::Key_PageDown);
    const auto& events = desk.axis().content().events;
    const auto* const first = nextEvent(events, desk.clock().start(), 1);
    QVERIFY(first);
    NEAR(desk.clock().at(), first->at_s, 1e-6);
    QVERIFY(desk.axis().wordsAt(desk.pixelOf(first->at_s)).contains(replay::eventText(*first)));
    desk.key(Qt::Key_End);
    desk.key(Qt::Key_PageUp);
    NEAR(desk.clock().at(), nextEvent(events, desk.clock().end(), -1)->at_s, 1e-6);
  }

  void kindsOfEventsAreHiddenTogetherAndThatIsRemembered() {
    Desk desk;
    desk.replay(kWhole);
    QTRY_VERIFY(desk.clock().reading()->chunks().wholeRead());
    QTRY_COMPARE(desk.axis().content().events.size(),
                 replay::eventsOf(desk.clock().reading()->index().digests()).size());
    QCOMPARE(desk.axis().shownEvents().size(), desk.axis().content().events.size());
    QAction* planner = nullptr;
    for (QAction* const shown : desk.timeline().eventsButton()->menu()->actions()) {
      if (shown->data().toInt() == int(replay::EventGroup::Planner)) planner = shown;
    }
    QVERIFY(planner && planner->isChecked());
    planner->trigger();
    for (const replay::Event& event : desk.axis().shownEvents())
      QVERIFY(replay::groupOf(event.kind) != replay::EventGroup::Planner);
    QVERIFY(desk.axis().shownEvents().size() < desk.axis().content().events.size());
    QVERIFY(desk.timeline().eventsButton()->toolTip().contains(groupName(replay::EventGroup::Planner)));
    // Steps pass over what is hidden.
    desk.axis().setFocus();
    desk.key(Qt::Key_End);
    desk.key(Qt::Key_PageUp);
    const auto* const last = nextEvent(desk.axis().shownEvents(), desk.clock().end(), -1);
    if (last) NEAR(desk.clock().at(), last->at_s, 1e-6);
    part<ReplayController>(*desk.window)->remember(desk.settings);
    desk.timeline().setHiddenGroups({});
    QVERIFY(planner->isChecked());
    part<ReplayController>(*desk.window)->recall(desk.settings);
    QVERIFY(!planner->isChecked());
  }

  void theKindsOfEventsKeepTheirRoom() {
    Desk desk;
    desk.replay(kWhole);
    EventsDock& list = *part<ReplayController>(*desk.window)->eventsDock();
    QTest::mouseClick(desk.timeline().listButton(), Qt::LeftButton);
    QTRY_VERIFY(list.isVisible() && list.table()->isVisible());
    const auto* const kinds = list.findChild<QComboBox*>();
    list.setFloating(true);
    list.resize(1, 300);
    QCoreApplication::processEvents();
    QVERIFY(kinds->width() >= 14 * kinds->fontMetrics().horizontalAdvance(QLatin1Char('x')));
  }

  void aListOfTheEventsGoesThereAndFollows() {
    Desk desk;
    desk.replay(kWhole);
    EventsDock& list = *part<ReplayController>(*desk.window)->eventsDock();
    QVERIFY(!list.isVisible());
    QTest::mouseClick(desk.timeline().listButton(), Qt::LeftButton);
    QTRY_VERIFY(list.isVisible() && list.table()->isVisible());
    QTRY_VERIFY(desk.clock().reading()->chunks().wholeRead());
    QTRY_VERIFY(list.summaryShown().contains(QStringLiteral("the whole bag")));
    const auto events = replay::eventsOf(desk.clock().reading()->index().digests());
    QTRY_COMPARE(list.model()->rowCount(), int(events.size()));
    QVERIFY(events.size() > 3);
    for (int row = 0; row < int(events.size()); ++row)
      QCOMPARE(list.model()->event(row)->at_s, events[std::size_t(row)].at_s);

    const int last = int(events.size()) - 1;
    const auto center = [&](int row) {
      list.table()->scrollTo(list.model()->index(row, EventsModel::TextColumn));
      return list.table()->visualRect(list.model()->index(row, EventsModel::TextColumn)).center();
    };
    QTest::mouseClick(list.table()->viewport(), Qt::LeftButton, {}, center(last));
    QTest::mouseDClick(list.table()->viewport(), Qt::LeftButton, {}, center(last));
    QCOMPARE(desk.clock().at(), events.back().at_s);
    QCOMPARE(list.model()->presentRow(), last);
    list.table()->setCurrentIndex(list.model()->index(0, 0));
    QTest::keyClick(list.table(), Qt::Key_Return);
    QCOMPARE(desk.clock().at(), events.front().at_s);
    // What goes elsewhere takes the present row along, and into view.
    desk.clock().seek(desk.clock().end());
    QCOMPARE(list.model()->presentRow(), last);
    QVERIFY(
        list.table()->viewport()->rect().intersects(list.table()->visualRect(list.model()->index(last, 0))));
    desk.clock().seek(desk.clock().start() - 1);
    QCOMPARE(list.model()->presentRow(), -1);

    list.table()->selectAll();
    list.table()->setFocus();
    QTest::keyClick(list.table(), Qt::Key_C, Qt::ControlModifier);
    const QStringList lines =
        QGuiApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), int(events.size()));
    QVERIFY(lines.front().contains(replay::eventText(events.front())));
    QVERIFY(lines.front().contains(clockText(events.front().at_s)));

    // Without the replay it is empty, and stays where the user has it.
    QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.isReplay());
    QVERIFY(list.isVisible());
    QCOMPARE(list.model()->rowCount(), 0);
  }

  void offersItsLayoutAndForcesNone() {
    Desk desk;
    desk.replay(kWhole);
    QCOMPARE(part<LayoutController>(*desk.window)->role(), Role::Inspect);
    const auto* const toasts = part<MapOverlay>(*desk.window)->toasts();
    QPushButton* use = nullptr;
    for (QPushButton* button : toasts->findChildren<QPushButton*>())
      if (button->text() == QLatin1String("Use it")) use = button;
    QVERIFY(use);
    QTest::mouseClick(use, Qt::LeftButton);
    QCOMPARE(part<LayoutController>(*desk.window)->role(), Role::Replay);
    QTRY_VERIFY(!part<ReplayController>(*desk.window)->eventsDock()->visibleRegion().isEmpty());
    QVERIFY(!desk.timeline().visibleRegion().isEmpty());
    QVERIFY(desk.timeline().width() == desk.window->width());
  }

  void theOfferOfItsLayoutGoesOnceThatIsOnOrTheReplayIsOver() {
    for (const bool by_key : {true, false}) {
      Desk desk;
      desk.replay(kWhole);
      const auto* const toasts = part<MapOverlay>(*desk.window)->toasts();
      const auto offered = [&] {
        return !toasts->texts().filter(QStringLiteral("The layout Replay")).isEmpty();
      };
      QVERIFY(offered());
      if (by_key) {
        desk.action("layoutReplay")->trigger();
      } else {
        QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
        QTRY_VERIFY(!desk.isReplay());
      }
      QVERIFY(!offered());
    }
  }

  void theTimelineOfAReplayIsNoPartOfAnotherLayout() {
    Desk desk;
    desk.replay(kWhole);
    QVERIFY(desk.timeline().isVisible());
    desk.action("layoutReplay")->trigger();
    QVERIFY(desk.timeline().isVisible());
    // While it is played it goes along.
    desk.action("layoutInspect")->trigger();
    QVERIFY(desk.timeline().isVisible());
    desk.action("layoutReplay")->trigger();
    desk.window->leaveRobot();
    QVERIFY(desk.timeline().isVisible());  // a part of this layout
    desk.action("layoutInspect")->trigger();
    QVERIFY(!desk.timeline().isVisible());
    // Closed without a robot behind it.
    desk.replay(kWhole);
    QVERIFY(desk.timeline().isVisible());
    desk.window->leaveRobot();
    QVERIFY(!desk.timeline().isVisible());
  }

  void isWhatTheFirstStartIsLaidOutFor() {
    Desk desk;
    part<ReplayController>(*desk.window)->open(desk.makeRobot(), kWhole);
    QTRY_VERIFY(desk.isReplay());
    QCOMPARE(part<LayoutController>(*desk.window)->role(), Role::Replay);
  }

  void theListOfEventsIsFilteredByKindAndWords() {
    Desk desk;
    desk.replay(kWhole);
    EventsDock& list = *part<ReplayController>(*desk.window)->eventsDock();
    QTest::mouseClick(desk.timeline().listButton(), Qt::LeftButton);
    QTRY_VERIFY(desk.clock().reading()->chunks().wholeRead());
    QTRY_VERIFY(list.summaryShown().contains(QStringLiteral("the whole bag")));
    const int all = list.model()->rowCount();
    list.groupBox()->setCurrentIndex(list.groupBox()->findData(int(replay::EventGroup::Planner)));
    const int planner = list.model()->rowCount();
    QVERIFY(planner > 0 && planner < all);
    for (int row = 0; row < planner; ++row)
      QCOMPARE(replay::groupOf(list.model()->event(row)->kind), replay::EventGroup::Planner);
    QVERIFY(list.summaryShown().startsWith(QStringLiteral("%1 of %2 events").arg(planner).arg(all)));
    list.search()->setFocus();
    QTest::keyClicks(list.search(), QStringLiteral("no such words"));
    QCOMPARE(list.model()->rowCount(), 0);
    QVERIFY(!list.emptyShown().isEmpty() && !list.saveButton()->isEnabled());
    list.search()->clear();
    list.groupBox()->setCurrentIndex(0);
    QCOMPARE(list.model()->rowCount(), all);
  }

  void theListSaysWhatHasNotBeenReadAndHasItRead() {
    Desk desk;
    desk.action("replayReadAll")->setChecked(false);
    desk.replay({BagKind::Bag, "eight_hours.bag"});
    EventsDock& list = *part<ReplayController>(*desk.window)->eventsDock();
    QTest::mouseClick(desk.timeline().listButton(), Qt::LeftButton);
    QTRY_VERIFY(list.readButton()->isVisible());
    QVERIFY(list.summaryShown().contains(QStringLiteral("found so far")));
    QVERIFY(desk.clock().readShare() < 0.5);
    QTest::mouseClick(list.readButton(), Qt::LeftButton);
    QVERIFY(desk.action("replayReadAll")->isChecked());
    QVERIFY(!list.readButton()->isVisible());
  }

  void aHundredThousandEventsAreNoBurden() {
    std::vector<replay::Event> events;
    for (int i = 0; i < 100'000; ++i)
      events.push_back(
          {1'700'000'000 + i * 0.25, replay::EventKind::AlertBegan, i, "wheel " + std::to_string(i), 0});
    EventsModel model;
    QTableView view;
    view.setModel(&model);
    view.show();
    QElapsedTimer took;
    took.start();
    model.setEvents(events, 1'700'000'000);
    qInfo("set: %lld ms", static_cast<long long>(took.restart()));
    model.setFilter({std::nullopt, QStringLiteral("WHEEL 9999")});
    qInfo("filtered: %lld ms", static_cast<long long>(took.restart()));
    QCOMPARE(model.rowCount(), 11);
    model.setFilter({});
    view.selectRow(50'000);
    // What comes in the middle moves the rows after it, and the selection with them.
    std::vector<replay::Event> more = events;
    more.insert(more.begin() + 10, {1'700'000'002.6, replay::EventKind::EmergencyStopOn, 0, {}, 0});
    took.restart();
    model.setEvents(more, 1'700'000'000);
    qInfo("one more: %lld ms", static_cast<long long>(took.restart()));
    QCOMPARE(view.selectionModel()->selectedRows().front().row(), 50'001);
    model.setAt(events[70'000].at_s);
    QCOMPARE(model.presentRow(), 70'001);
    model.setFilter({std::nullopt, QStringLiteral("WHEEL 9999")});
    int seen = 0;
    QCOMPARE(picturesMadeTwice(model, seen), QStringList());
    QCOMPARE(seen, 11);
  }

  void theReportOfTheMomentIsWrittenFromTheMenu() {
    Desk desk;
    QVERIFY(!desk.action("replayReport")->isEnabled());
    desk.replay(kWhole);
    desk.clock().seek(desk.clock().start() + 100);
    QTRY_VERIFY(desk.isThere());
    const double at_s = desk.clock().at();
    const QString path = desk.folder.filePath(QStringLiteral("moment.html"));
    QTimer chooses;
    chooses.setInterval(10);
    connect(&chooses, &QTimer::timeout, this, [&] {
      auto* const dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      auto* const name = dialog ? dialog->findChild<QLineEdit*>() : nullptr;
      if (!name) return;
      chooses.stop();
      QVERIFY(name->text().contains(QLatin1String("same_stamps.bag")));
      name->setText(path);
      QTest::keyClick(name, Qt::Key_Return);
    });
    chooses.start();
    desk.action("replayReport")->trigger();
    const ToastStack* const toasts = part<MapOverlay>(*desk.window)->toasts();
    QTRY_VERIFY(toasts->texts().join(QLatin1Char(' ')).contains(QLatin1String("moment.html")));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString html = QString::fromUtf8(file.readAll());
    QVERIFY(html.contains(incident::utcText(at_s)) && html.contains(QLatin1String("same_stamps.bag")));
    QVERIFY(html.contains(QLatin1String("data:image/png")) && html.endsWith(QLatin1String("</html>\n")));
    // The replay on screen is where it was.
    QVERIFY(desk.clock().at() == at_s && desk.isThere());
    const auto canBeOpened = [&desk] {
      const auto buttons = desk.window->findChildren<QAbstractButton*>();
      return std::any_of(buttons.begin(), buttons.end(), [](const QAbstractButton* each) {
        return each->isVisible() && each->text() == QLatin1String("Open");
      });
    };
    QTRY_VERIFY(canBeOpened());
  }

  void aRangeBeginsAndEndsWhereTheReplayIs() {
    Desk desk;
    desk.replay(kWhole);
    desk.action("replayExport")->trigger();
    const QPointer<RangeExportDialog> dialog = part<ReplayController>(*desk.window)->rangeDialog();
    QVERIFY(dialog && dialog->fromHereButton()->isVisible());
    desk.clock().seek(desk.clock().start() + 100);
    QTest::mouseClick(dialog->fromHereButton(), Qt::LeftButton);
    desk.clock().seek(desk.clock().start() + 130);
    QTest::mouseClick(dialog->toHereButton(), Qt::LeftButton);
    QVERIFY(dialog->fromEdit()->text().endsWith(clockText(desk.clock().start() + 100)));
    QVERIFY(dialog->toEdit()->text().endsWith(clockText(desk.clock().start() + 130)));
    dialog->close();
  }

  void aRangeIsExportedAsMessagesAndAsWay_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("suffix");
    QTest::newRow("mcap") << int(excerpt::Kind::Mcap) << ".mcap";
    QTest::newRow("lines") << int(excerpt::Kind::Lines) << ".jsonl";
    QTest::newRow("geojson") << int(excerpt::Kind::TrackGeoJson) << ".geojson";
    QTest::newRow("csv") << int(excerpt::Kind::TrackCsv) << ".csv";
    QTest::newRow("tum") << int(excerpt::Kind::TrackTum) << ".tum";
  }
  void aRangeIsExportedAsMessagesAndAsWay() {
    QFETCH(int, kind);
    QFETCH(QString, suffix);
    Desk desk;
    desk.replay(kWhole);
    const double from_s = desk.clock().start() + 100, to_s = desk.clock().start() + 130;
    desk.clock().setLoop(replay::Player::Loop{from_s, to_s});
    desk.action("replayExport")->trigger();
    QPointer<RangeExportDialog> dialog = part<ReplayController>(*desk.window)->rangeDialog();
    QVERIFY(dialog && dialog->isVisible());
    QVERIFY(dialog->fromEdit()->text().endsWith(clockText(from_s)));
    QVERIFY(dialog->toEdit()->text().endsWith(clockText(to_s)));
    dialog->kindBox()->setCurrentIndex(dialog->kindBox()->findData(kind));
    QVERIFY(dialog->pathEdit()->text().endsWith(suffix));
    const QString path = desk.folder.filePath(QStringLiteral("part") + suffix);
    dialog->pathEdit()->setText(path);
    QSignalSpy exported(dialog, &RangeExportDialog::exported);
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QTRY_VERIFY(exported.count() == 1);
    QTRY_VERIFY(!dialog);
    QVERIFY(QFileInfo(path).size() > 0);
    if (kind == int(excerpt::Kind::Mcap)) {
      const auto source = recording::openRecording(path.toStdString());
      QVERIFY(source);
      QVERIFY((*source)->summary().finished);
      QVERIFY(*(*source)->summary().end_ns <= excerpt::nanosecondsOf(to_s));
      QVERIFY(*(*source)->summary().start_ns >= excerpt::nanosecondsOf(from_s));
    } else if (kind == int(excerpt::Kind::Lines)) {
      QFile file(path);
      QVERIFY(file.open(QIODevice::ReadOnly));
      int lines = 0;
      while (!file.atEnd()) {
        const double at_s =
            QJsonDocument::fromJson(file.readLine()).object()[QStringLiteral("__stamp")].toDouble();
        QVERIFY(at_s >= from_s && at_s <= to_s);
        ++lines;
      }
      QVERIFY(lines > 10);
    }
    // What is there is not replaced without a question.
    desk.action("replayExport")->trigger();
    dialog = part<ReplayController>(*desk.window)->rangeDialog();
    dialog->kindBox()->setCurrentIndex(dialog->kindBox()->findData(kind));
    dialog->pathEdit()->setText(path);
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(!dialog->running());
    QVERIFY(dialog->said().contains(QStringLiteral("exists")));
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(dialog->running());
    QTRY_VERIFY(!dialog);
  }

  void anExportThatIsCancelledOrLeftLeavesNothing() {
    Desk desk;
    desk.replay({BagKind::Bag, "eight_hours.bag"});
    desk.action("replayExport")->trigger();
    const QPointer<RangeExportDialog> dialog = part<ReplayController>(*desk.window)->rangeDialog();
    QDir().mkpath(desk.folder.filePath(QStringLiteral("out")));
    const QDir out(desk.folder.filePath(QStringLiteral("out")));
    dialog->pathEdit()->setText(out.filePath(QStringLiteral("all.mcap")));
    // Times that are none, or the wrong way round, are told at once.
    dialog->fromEdit()->setText(QStringLiteral("never"));
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(!dialog->running() && dialog->said().contains(QStringLiteral("times between")));
    QVERIFY(dialog->filmEdit()->text().isEmpty());
    dialog->fromEdit()->setText(QStringLiteral("+30:00"));
    dialog->toEdit()->setText(QStringLiteral("+20:00"));
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(!dialog->running() && dialog->said().contains(QStringLiteral("before the start")));
    QVERIFY(dialog->filmEdit()->text().startsWith(
        QStringLiteral("mapwright bags film 'eight_hours.bag' --robot ")));
    dialog->fromEdit()->setText(QStringLiteral("+0"));
    dialog->toEdit()->setText(QStringLiteral("-0"));
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(dialog->running());
    QTest::mouseClick(dialog->closeButton(), Qt::LeftButton);
    QTRY_VERIFY(!dialog->running());
    QVERIFY(dialog->said().contains(QStringLiteral("Cancelled")));
    QVERIFY(out.entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty());

    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(dialog->running());
    QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
    QVERIFY(!dialog->running());
    QVERIFY(dialog->said().contains(QStringLiteral("was closed")));
    QVERIFY(!dialog->exportButton()->isEnabled());
    QVERIFY(out.entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty());
    dialog->close();
  }

  void whatCannotBeWrittenIsASentenceInTheDialog() {
    Desk desk;
    desk.replay(kWhole);
    desk.action("replayExport")->trigger();
    const QPointer<RangeExportDialog> dialog = part<ReplayController>(*desk.window)->rangeDialog();
    dialog->pathEdit()->setText(desk.folder.filePath(QStringLiteral("no/such/folder/a.mcap")));
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(!dialog->running() && dialog->said().contains(QStringLiteral("does not exist")));
    dialog->pathEdit()->setText(desk.folder.path());
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QVERIFY(!dialog->running() && dialog->said().contains(QStringLiteral("is a folder")));
    dialog->close();
  }

  void whereNothingWasRecordedTheBandHasAHole() {
    Desk desk;
    desk.replay(kGap);
    QTRY_VERIFY(desk.clock().reading()->chunks().wholeRead());
    QTRY_VERIFY(!desk.axis().content().silences.empty());
    const replay::Silence gap = desk.axis().content().silences.front();
    QVERIFY(gap.until_s - gap.from_s >= replay::kSilenceS);
    // No message lies within.
    for (const auto& [from, digest] : desk.clock().reading()->index().digests()) {
      for (const replay::Digest::Pose& pose : digest.poses)
        QVERIFY(pose.stamp_s <= gap.from_s || pose.stamp_s >= gap.until_s);
    }
    const QString words = desk.axis().wordsAt(desk.pixelOf((gap.from_s + gap.until_s) / 2));
    QVERIFY2(words.contains(QStringLiteral("Nothing was recorded from ")), qPrintable(words));
    QVERIFY(!words.contains(QStringLiteral("could not be read")));
    QVERIFY(!desk.axis().wordsAt(desk.pixelOf(gap.from_s - 30)).contains(QStringLiteral("Nothing was")));
    desk.axis().grab();
  }

  void theRobotIsDrawnBetweenTwoSamples() {
    Desk desk;
    desk.replay(BagKey{BagKind::Bag, "gap.bag"});
    QTRY_VERIFY(desk.clock().reading()->chunks().wholeRead());
    // A pair of samples between which it moves.
    const replay::Digest::Pose *before = nullptr, *after = nullptr;
    for (const auto& [from, digest] : desk.clock().reading()->index().digests()) {
      for (std::size_t i = 1; i < digest.poses.size() && !after; ++i) {
        const auto &a = digest.poses[i - 1], &b = digest.poses[i];
        const double way_m = std::hypot(b.pose.x_m - a.pose.x_m, b.pose.y_m - a.pose.y_m);
        if (b.stamp_s - a.stamp_s > 0.9 || b.stamp_s - a.stamp_s < 0.02 || way_m < 0.01 || way_m > 0.4)
          continue;
        before = &a;
        after = &b;
      }
    }
    QVERIFY(after);
    const geometry::Pose2 from = before->pose, to = after->pose;
    desk.clock().seek((before->stamp_s + after->stamp_s) / 2);
    QTRY_VERIFY(desk.isThere());
    std::optional<geometry::Pose2> drawn;
    QTRY_VERIFY((drawn = desk.window->mapScene()->robotPose()) &&
                std::abs(drawn->x_m - (from.x_m + to.x_m) / 2) < 1e-6);
    NEAR(drawn->y_m, (from.y_m + to.y_m) / 2, 1e-6);
    // The world says what was recorded.
    QTRY_VERIFY(std::abs(desk.window->session()->live().robot_pose->x_m - from.x_m) < 1e-9);
  }

  void oddBagsOpen_data() {
    QTest::addColumn<QString>("name");
    for (const char* name :
         {"eight_hours.bag", "clock_set_back.bag", "gap.bag", "ends_late.bag", "one_message.bag"})
      QTest::newRow(name) << QString::fromLatin1(name);
  }
  void oddBagsOpen() {
    QFETCH(QString, name);
    Desk desk;
    desk.replay({BagKind::Bag, name.toStdString()});
    desk.axis().setFocus();
    desk.key(Qt::Key_Right);
    desk.key(Qt::Key_End);
    QVERIFY(desk.clock().at() >= desk.clock().start());
    desk.key(Qt::Key_Home);
    QTRY_VERIFY(desk.isThere());
    desk.axis().grab();
  }

  void anEmptyBagSaysThatItIsEmpty() {
    Desk desk;
    desk.connect();
    desk.doubleClick({BagKind::Bag, "empty.bag"});
    QTRY_VERIFY(desk.clock().isOpen());
    QTRY_VERIFY(!desk.axis().notice().isEmpty());
    desk.key(Qt::Key_Right);
    desk.key(Qt::Key_Space);
    desk.click(0);
    QTest::mouseClick(desk.timeline().backButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.isReplay());
  }

  void theWheelZoomsAndTheKeysToo() {
    Desk desk;
    desk.replay(kWhole);
    const double middle_s = (desk.clock().start() + desk.clock().end()) / 2;
    const QPointF at = desk.pixelOf(middle_s);
    QWheelEvent wheel(at, desk.axis().mapToGlobal(at), {}, {0, 480}, {}, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&desk.axis(), &wheel);
    const TimelineAxis near = desk.axis().axis();
    QVERIFY(near.until_s - near.from_s < 0.5 * (desk.clock().end() - desk.clock().start()));
    NEAR(near.pixelOf(middle_s), at.x(), 1.5);
    desk.axis().setFocus();
    desk.key(Qt::Key_0);
    QCOMPARE(desk.axis().axis().from_s, desk.clock().start());
    QCOMPARE(desk.axis().axis().until_s, desk.clock().end());
  }

  void aClickOnTheWayGoesToItsTime() {
    Desk desk;
    desk.replay(kWhole);
    QTRY_VERIFY(desk.clock().reading()->chunks().wholeRead());
    desk.window->mapScene()->setLayerVisible(ui::scene::Layer::Trail, true);
    desk.clock().seek(desk.clock().end());
    QTRY_VERIFY(desk.isThere());
    const auto& trail = desk.window->session()->live().trail;
    QVERIFY(trail.size() > 10);
    const Eigen::Vector2d place = trail[trail.size() / 2].position_m;
    part<ReplayController>(*desk.window)->clickedOnMap(place);
    const auto pose = desk.clock().poseBetween();
    QVERIFY(pose);
    NEAR(std::hypot(pose->x_m - place.x(), pose->y_m - place.y()), 0.0, 0.3);
    QVERIFY(desk.clock().at() < desk.clock().end());
  }

  void recordsOnTheRobot() {
    Desk desk;
    desk.connect();
    const int before = desk.list().model()->rowCount();
    QTest::mouseClick(desk.list().recordButton(), Qt::LeftButton);
    RecordDialog* const dialog = part<RecordingsController>(*desk.window)->recordDialog();
    QVERIFY(dialog);
    QTest::keyClicks(dialog->suffix(), QStringLiteral("te st/1"));
    // What cannot be a name is told, not swallowed.
    QCOMPARE(dialog->suffix()->text(), QStringLiteral("te st/1"));
    QVERIFY(dialog->errorShown().contains(QStringLiteral("letters")));
    QVERIFY(!dialog->recordButton()->isEnabled());
    dialog->suffix()->selectAll();
    QTest::keyClicks(dialog->suffix(), QStringLiteral("test-1"));
    QVERIFY(dialog->errorShown().isEmpty());
    // The simulated robot records five minutes at most: the dialog stays with what it says.
    dialog->duration()->setValue(600);
    const QPointer<QDialog> open = dialog;
    QTest::keyClick(dialog->suffix(), Qt::Key_Return);
    QTRY_VERIFY(open && dialog->errorShown().contains(QStringLiteral("duration")));
    QVERIFY(dialog->isVisible() && dialog->recordButton()->isEnabled());
    dialog->duration()->setValue(30);
    QTest::keyClick(dialog->suffix(), Qt::Key_Return);
    QTRY_VERIFY(!open);
    QTRY_COMPARE(desk.list().model()->rowCount(), before + 1);
  }

  void deletesWhatWasConfirmed() {
    Desk desk;
    desk.connect();
    const int before = desk.list().model()->rowCount();
    desk.list().select(kGap);
    QTest::mouseClick(desk.list().deleteButton(), Qt::LeftButton);
    QVERIFY(part<RecordingsController>(*desk.window)->question());
    QVERIFY(part<RecordingsController>(*desk.window)->question()->text().contains(QStringLiteral("gap.bag")));
    QTest::keyClick(part<RecordingsController>(*desk.window)->question(), Qt::Key_Escape);
    QTRY_VERIFY(!part<RecordingsController>(*desk.window)->question());
    QCOMPARE(desk.list().model()->note(kGap).kind, BagNote::Kind::None);
    desk.list().select(kGap);
    QTest::mouseClick(desk.list().deleteButton(), Qt::LeftButton);
    auto* const yes = part<RecordingsController>(*desk.window)
                          ->question()
                          ->findChild<QPushButton*>(QStringLiteral("deleteRecording"));
    QVERIFY(yes);
    QTest::mouseClick(yes, Qt::LeftButton);
    QTRY_COMPARE(desk.list().model()->rowCount(), before - 1);
  }

  void aRecordingTellsThatTheLinkWasLostAndHoldsTheMapsThatWereOpened() {
    Desk desk;
    desk.connect();
    RecordingController* const recorder = part<RecordingController>(*desk.window);
    QTRY_COMPARE(desk.window->session()->connection().phase, robot::ConnectionPhase::Online);
    QTRY_VERIFY(desk.window->session()->catalogue().entries().size() > 1);
    const auto& maps = desk.window->session()->catalogue().entries();
    const auto other =
        std::find_if(maps.begin(), maps.end(), [](const auto& map) { return !map.is_current; });
    QVERIFY(other != maps.end());
    const map::MapKey key = other->key;
    const QString path = desk.folder.filePath(QStringLiteral("session.mcap"));
    QVERIFY(!recorder->startInto(path));
    desk.window->session()->openMap(key);
    QTRY_COMPARE(desk.window->session()->wholeMap().phase(), session::MapSlot::Phase::Ready);
    QStringList told;
    const auto said = [&](const char* words) {
      for (const QString& text : part<MapOverlay>(*desk.window)->toasts()->texts()) {
        if (!told.contains(text)) told << text;
      }
      return std::any_of(told.begin(), told.end(),
                         [&](const QString& text) { return text.contains(QLatin1String(words)); });
    };
    desk.sim.dropWebSockets();
    QTRY_VERIFY(said("the connection was lost"));
    QTRY_VERIFY(said("recording continues"));
    QTRY_VERIFY(!recorder->shown().contains(QStringLiteral("no connection")));
    const auto hasMap = [&] {
      const auto source = recording::openRecording(path.toStdString());
      if (!source) return false;
      const auto& files = (*source)->attachments();
      return std::any_of(files.begin(), files.end(),
                         [&](const auto& file) { return file.name == recorder::mapName(key); });
    };
    QTRY_VERIFY(hasMap());
    recorder->stop();
    QTRY_VERIFY(said("but it is incomplete: the connection was lost, times: 1."));
    // And is played from there.
    QSignalSpy play(recorder, &RecordingController::playWanted);
    const auto buttons = part<MapOverlay>(*desk.window)->toasts()->findChildren<QPushButton*>();
    QVERIFY(!buttons.isEmpty());
    buttons.last()->click();
    QCOMPARE(play.size(), 1);
    QCOMPARE(play.front().front().toString(), path);
    QVERIFY(hasMap());
  }

  void downloadsIntoAFile() {
    Desk desk;
    desk.connect();
    const QString path = desk.folder.filePath(QStringLiteral("got.bag"));
    part<RecordingsController>(*desk.window)->download(kGap, path);
    QCOMPARE(desk.list().model()->note(kGap).kind, BagNote::Kind::Downloading);
    QTRY_COMPARE(desk.list().model()->note(kGap).kind, BagNote::Kind::Downloaded);
    QVERIFY(QFileInfo(path).size() > 1000);
    // One that is stopped says that it goes on.
    part<RecordingsController>(*desk.window)
        ->download(kWhole, desk.folder.filePath(QStringLiteral("other.bag")));
    desk.list().select(kWhole);
    QVERIFY(desk.list().stopButton()->isEnabled());
    QTest::mouseClick(desk.list().stopButton(), Qt::LeftButton);
    QTRY_VERIFY(desk.list().model()->note(kWhole).kind == BagNote::Kind::Stopped ||
                desk.list().model()->note(kWhole).kind == BagNote::Kind::Downloaded);
    // A folder that is not there is no place.
    part<RecordingsController>(*desk.window)
        ->download(kGap, desk.folder.filePath(QStringLiteral("no/where/got.bag")));
    QTRY_COMPARE(desk.list().model()->note(kGap).kind, BagNote::Kind::Failed);
  }
};

}  // namespace test_window_replay

MAPWRIGHT_TEST(test_window_replay, TestWindowReplay, Widgets)
#include "test_window_replay.moc"
