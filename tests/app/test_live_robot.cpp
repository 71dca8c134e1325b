// The client against the simulated robot, judged by the robot's own request log.
#include <map>
#include <set>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "map/live_state.h"
#include "robot/axbot/axbot_robot.h"
#include "sentences/fault_sentence.h"
#include "session/session_options.h"
#include "simulator/simulator.h"
#include "submap/submap_store.h"
#include "test_program.h"

namespace test_live_robot {

using namespace mapwright;
using session::Session;
using session::SubmapStatus;
using simulator::RequestRecord;

namespace {

constexpr int kTimeoutMs = 60'000;

std::vector<RequestRecord> submapRequests(const simulator::Simulator& robot) {
  std::vector<RequestRecord> requests;
  for (const RequestRecord& record : robot.requestLog()) {
    if (record.target.starts_with("/ros/slam/submaps/")) requests.push_back(record);
  }
  return requests;
}

int mostAtOnce(const std::vector<RequestRecord>& requests) {
  int most = 0;
  for (const RequestRecord& record : requests) most = std::max(most, record.concurrent);
  return most;
}

std::map<std::string, int> timesAsked(const std::vector<RequestRecord>& requests) {
  std::map<std::string, int> times;
  for (const RequestRecord& record : requests) ++times[record.target];
  return times;
}

}  // namespace

class LiveRobotTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<simulator::Simulator> robot_;
  std::unique_ptr<QTemporaryDir> cache_;

  void startRobot(simulator::Options options = {}) {
    options.paused = true;
    robot_ = std::make_unique<simulator::Simulator>(options);
    const auto error = robot_->start();
    QVERIFY2(!error, error ? error->c_str() : "");
  }
  std::unique_ptr<Session> connectTo(submap::SchedulerOptions scheduler = {}, const QByteArray& secret = {}) {
    robot::axbot::LinkOptions link;
    link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(robot_->port()));
    link.secret = secret;
    link.cache_folder = cache_->path();
    link.socket.backoff_first = std::chrono::milliseconds(50);
    Session::Options options;
    options.scheduler = scheduler;
    auto session = std::make_unique<Session>(
        std::make_unique<robot::axbot::AxbotRobot>(QStringLiteral("test"), link), options);
    session->open();
    return session;
  }
  static bool complete(const Session& session) {
    const auto counts = session.counts();
    return counts.list_received && counts.listed > 0 &&
           counts.shown + counts.without_slice == counts.listed && session.settled(1);
  }

 private Q_SLOTS:
  void init() { cache_ = std::make_unique<QTemporaryDir>(); }
  void cleanup() { robot_.reset(); }

  void everySubmapArrivesOverEveryKindOfLink_data() {
    QTest::addColumn<bool>("binary");
    QTest::addColumn<bool>("topic_lists");
    QTest::newRow("binary, topic lists") << true << true;
    QTest::newRow("json, topic lists") << false << true;
    QTest::newRow("json, one by one") << false << false;
  }
  void everySubmapArrivesOverEveryKindOfLink() {
    QFETCH(bool, binary);
    QFETCH(bool, topic_lists);
    simulator::Options options;
    options.binary_topics = binary;
    options.enable_topic_list = topic_lists;
    startRobot(options);
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    const auto requests = submapRequests(*robot_);
    QCOMPARE(int(requests.size()), session->counts().listed);
    QVERIFY(mostAtOnce(requests) <= 4);
    for (const auto& [target, times] : timesAsked(requests)) QVERIFY2(times == 1, target.c_str());
    QTRY_VERIFY(session->live().robot_pose.has_value());
    QTRY_VERIFY(session->live().model.footprint.size() >= 3);
    QCOMPARE(session->problems().unresolved(), 0);
    QVERIFY(!session->robot().identity().model.isEmpty());
  }

  void aRestartDownloadsNothingAgain() {
    startRobot();
    {
      const auto session = connectTo();
      QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    }
    robot_->clearRequestLog();
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    QCOMPARE(submapRequests(*robot_).size(), std::size_t(0));
    QCOMPARE(int(session->counts().cache_hits), session->counts().listed);
  }

  void onlyWhatChangedIsFetched() {
    startRobot();
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    robot_->clearRequestLog();
    const map::SubmapId id = session->submaps().rows().begin()->first;
    const int before = session->submaps().find(id)->shown_version;
    robot_->bumpVersion(id.trajectory, id.index);
    QTRY_VERIFY_WITH_TIMEOUT(session->submaps().find(id)->shown_version > before, kTimeoutMs);
    QCOMPARE(submapRequests(*robot_).size(), std::size_t(1));
  }

  void aLoopClosureMovesPicturesWithoutAnyFetch() {
    startRobot();
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    robot_->clearRequestLog();
    QSignalSpy placed(session.get(), &Session::submapsPlaced);
    robot_->closeLoop();
    QTRY_VERIFY_WITH_TIMEOUT(placed.count() > 0, kTimeoutMs);
    QVERIFY(complete(*session));
    QCOMPARE(submapRequests(*robot_).size(), std::size_t(0));
  }

  void aSubmapThatLeavesTheListLeavesTheMap() {
    startRobot();
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    const map::SubmapId id = session->submaps().rows().begin()->first;
    robot_->removeSubmap(id.trajectory, id.index);
    QTRY_VERIFY_WITH_TIMEOUT(!session->submaps().find(id), kTimeoutMs);
  }

  void a404IsNotRepeated() {
    simulator::Options options;
    options.faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kSubmaps, 0.3, 404});
    startRobot(options);
    submap::SchedulerOptions quick;
    quick.cooldown = submap::Millis(20);
    const auto session = connectTo(quick);
    QTRY_VERIFY_WITH_TIMEOUT(session->settled(1) && session->counts().missing > 0, kTimeoutMs);
    bool was_away = false;
    connect(session.get(), &Session::connectionChanged, this,
            [&] { was_away |= session->staleSince().has_value(); });
    robot_->dropWebSockets();  // a new list, a new chance to ask wrongly
    QTRY_VERIFY_WITH_TIMEOUT(was_away && session->connection().phase == robot::ConnectionPhase::Online,
                             kTimeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(session->settled(1), kTimeoutMs);
    for (const auto& [target, times] : timesAsked(submapRequests(*robot_)))
      QVERIFY2(times == 1, target.c_str());
    QCOMPARE(session->counts().shown + session->counts().missing, session->counts().listed);
  }

  void failuresHealAndTheOthersAreNotHeldUp_data() {
    QTest::addColumn<QString>("fault");
    for (const char* fault : {"drop", "truncate", "corrupt", "error", "status"})
      QTest::newRow(fault) << QString::fromLatin1(fault);
  }
  void failuresHealAndTheOthersAreNotHeldUp() {
    QFETCH(QString, fault);
    simulator::Options options;
    if (fault == QLatin1String("drop"))
      options.faults.requests.push_back({simulator::FaultKind::Drop, simulator::kSubmaps, 0.5});
    if (fault == QLatin1String("truncate"))
      options.faults.requests.push_back({simulator::FaultKind::Truncate, simulator::kSubmaps, 0.5});
    if (fault == QLatin1String("corrupt"))
      options.faults.requests.push_back({simulator::FaultKind::Corrupt, simulator::kSubmaps, 0.5});
    if (fault == QLatin1String("error"))
      options.faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kSubmaps, 0.5});
    if (fault == QLatin1String("status"))
      options.faults.requests.push_back({simulator::FaultKind::StatusError, simulator::kSubmaps, 0.5});
    startRobot(options);
    submap::SchedulerOptions quick;
    quick.cooldown = submap::Millis(30);
    quick.cooldown_limit = submap::Millis(100);
    const auto session = connectTo(quick);
    QTRY_VERIFY_WITH_TIMEOUT(session->problems().rows().size() > 0, kTimeoutMs);
    robot_->setFaults({});
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    QVERIFY(mostAtOnce(submapRequests(*robot_)) <= 4);
  }

  void theCooldownIsKept() {
    simulator::Options options;
    options.faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kSubmaps});
    startRobot(options);
    submap::SchedulerOptions scheduler;
    scheduler.cooldown = submap::Millis(400);
    const auto session = connectTo(scheduler);
    QTRY_VERIFY_WITH_TIMEOUT(session->settled(2), kTimeoutMs);
    std::map<std::string, double> ended;
    int again = 0;
    for (const RequestRecord& record : submapRequests(*robot_)) {
      if (const auto it = ended.find(record.target); it != ended.end()) {
        ++again;
        QVERIFY(record.at_s - it->second >= 0.399);
      }
      ended[record.target] = record.until_s;
    }
    QVERIFY(again >= session->counts().listed);
  }

  void wrongSizesAreReportedAndNotAskedForAgain() {
    simulator::Options options;
    options.faults.requests.push_back({simulator::FaultKind::WrongSize, simulator::kSubmaps, 0.4});
    startRobot(options);
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(session->settled(1) && session->counts().corrupt > 0, kTimeoutMs);
    for (const auto& [target, times] : timesAsked(submapRequests(*robot_)))
      QVERIFY2(times == 1, target.c_str());
    QVERIFY(session->problems().unresolved() >= session->counts().corrupt);
  }

  void badListEntriesCostOnlyThemselves() {
    startRobot();
    int good = 0;
    {
      const auto session = connectTo();
      QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
      good = session->counts().shown;
    }
    simulator::Options options;
    options.faults.bad_entries = true;
    startRobot(options);
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(session->settled(1), kTimeoutMs);
    QVERIFY(session->counts().shown >= good - 1);
    QVERIFY(session->counts().corrupt > 0);
    QVERIFY(session->problems().unresolved() > 0);
  }

  void aNewSlamSessionReplacesEverything() {
    startRobot();
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    const std::string before = session->submaps().uuid();
    robot_->restartSlam();
    QTRY_VERIFY_WITH_TIMEOUT(session->submaps().uuid() != before && complete(*session), kTimeoutMs);
    QVERIFY(mostAtOnce(submapRequests(*robot_)) <= 4);
  }

  void theSecretOpensTheDoorAndAWrongOneIsRefused() {
    simulator::Options options;
    options.secret = "open sesame";
    startRobot(options);
    {
      const auto session = connectTo({}, "open sesame");
      QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    }
    const auto session = connectTo({}, "xyzzy-42");
    QTRY_COMPARE_WITH_TIMEOUT(session->connection().phase, robot::ConnectionPhase::Refused, kTimeoutMs);
    QVERIFY(!sentences::wordsOf(session->connection().reason).contains(QStringLiteral("xyzzy-42")));
  }

  void aRobotThatGoesAwayAndComesBackIsFoundAgain() {
    startRobot();
    const auto session = connectTo();
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    const int shown = session->counts().shown;
    simulator::Options again;
    again.port = robot_->port();
    robot_.reset();
    QTRY_COMPARE_WITH_TIMEOUT(session->connection().phase, robot::ConnectionPhase::Interrupted, kTimeoutMs);
    QVERIFY(session->connection().reason.any());
    QCOMPARE(session->counts().shown, shown);
    startRobot(again);
    QTRY_COMPARE_WITH_TIMEOUT(session->connection().phase, robot::ConnectionPhase::Online, kTimeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(complete(*session), kTimeoutMs);
    QCOMPARE(submapRequests(*robot_).size(), std::size_t(0));
  }
};

}  // namespace test_live_robot

MAPWRIGHT_TEST(test_live_robot, LiveRobotTest, Core)
#include "test_live_robot.moc"
