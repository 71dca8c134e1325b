#include <cmath>

#include <QSignalSpy>
#include <QTest>
#include <QTimeZone>

#include "fake_robot.h"
#include "map/faults.h"
#include "map/live_state.h"
#include "robot/axbot/faults.h"
#include "session/faults.h"
#include "session/session_options.h"
#include "submap/submap_store.h"
#include "test_program.h"

namespace test_session {

using namespace mapwright;
using Outcome = map::SubmapAnswer::Outcome;
using session::Session;
using session::SubmapStatus;
using test::FakeRobot;

namespace {

map::SubmapEntry entry(int index, int version, double x = 0) {
  map::SubmapEntry e;
  e.id = {0, index};
  e.version = version;
  e.pose = geometry::poseFromYaw(x, 0, 0);
  return e;
}

map::SubmapList listOf(std::vector<map::SubmapEntry> entries, const std::string& uuid = "u") {
  map::SubmapList list;
  list.uuid = uuid;
  list.entries = std::move(entries);
  return list;
}

}  // namespace

class SessionTest : public QObject {
  Q_OBJECT
 private:
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;
  submap::Millis now_{0};

 private Q_SLOTS:
  void init() {
    now_ = submap::Millis(0);
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    Session::Options options;
    options.workers =
        std::make_shared<work::Workers>(1);  // pictures are decoded in the order in which they came
    session_ = std::make_unique<Session>(std::move(robot), options, nullptr, [this] { return now_; });
    robot_->setPhase(robot::ConnectionPhase::Online);
  }
  void cleanup() { session_.reset(); }

  void whatIsSaidAgainIsNoChange() {
    QSignalSpy changed(session_.get(), &Session::liveChanged), heard(session_.get(), &Session::liveHeard);
    map::LandmarksMessage landmarks{{{"a", {1, 2}, true}}};
    map::WheelState wheels{"auto", false, false};
    const auto points = [] {
      return std::make_shared<const std::vector<map::CloudPoint>>(std::vector<map::CloudPoint>{{1, 2, 0, 9}});
    };
    const std::vector<map::TopicMessage> all{map::TrackedPose{{1, 2, 0.5}},
                                             map::PointCloudMessage{"/a", points()},
                                             map::PointCloudMessage{"/b", points()},
                                             map::PathMessage{{{1, 1}, {2, 2}}},
                                             map::AlertsMessage{},
                                             landmarks,
                                             wheels,
                                             map::RackMessage{},
                                             map::MapInfo{"Hall", "u", 1, {}, {}},
                                             map::AlertsMessage{{{1, map::AlertLevel::Error, "one", 0}}}};
    // The first of its kind is told, also when it says nothing.
    for (const map::TopicMessage& message : all) robot_->say(message);
    QCOMPARE(changed.size(), int(all.size()));
    changed.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == 1) continue;
      if (const auto* const alerts = std::get_if<map::AlertsMessage>(&all[i]);
          alerts && alerts->alerts.empty())
        continue;  // others have come since
      robot_->say(all[i]);
    }
    robot_->say(map::PointCloudMessage{"/a", points()});  // another one with the same points
    QVERIFY2(changed.empty(), qPrintable(QString::number(changed.size())));
    QCOMPARE(heard.size(), int(2 * all.size() - 1));
    landmarks.landmarks[0].in_use = false;
    robot_->say(landmarks);
    robot_->say(map::AlertsMessage{});
    robot_->say(map::PathMessage{});
    QCOMPARE(changed.size(), 3);
  }

  void aListIsFetchedDecodedAndPlaced() {
    std::vector<map::SubmapId> placed;  // one by one, or several at a time
    connect(session_.get(), &Session::submapsPlaced, this, [&](const std::vector<map::SubmapId>& ids) {
      placed.insert(placed.end(), ids.begin(), ids.end());
    });
    robot_->say(listOf({entry(0, 1), entry(1, 1)}));
    QCOMPARE(robot_->asked.size(), std::size_t(2));
    QCOMPARE(session_->counts().pending, 2);
    robot_->answer(Outcome::Ok);
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 2);
    QCOMPARE(placed, std::vector<map::SubmapId>({{0, 0}, {0, 1}}));
    QVERIFY(session_->settled(1));
    QCOMPARE(session_->status({0, 0}), SubmapStatus::OnScreen);
    QCOMPARE(session_->counts().fetches, 2u);
  }

  void cellsBeyondTheBudgetLeaveTheMemory() {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    Session::Options options;
    options.budgets.textures = 1;
    session_ = std::make_unique<Session>(std::move(robot), options);
    robot_->setPhase(robot::ConnectionPhase::Online);
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    QTRY_COMPARE(session_->memory().textures, std::size_t(0));
  }

  void whatCannotBeDecodedIsKeptNowhere() {
    for (int version = 1; version <= 2; ++version) {
      now_ += submap::Millis(3'600'000);
      robot_->say(listOf({entry(0, version)}));
      robot_->answer(Outcome::Ok, 0, 5, 7);  // sizes do not fit
      QTRY_COMPARE(robot_->discarded.size(), std::size_t(version));
      QCOMPARE(robot_->discarded.back(), (map::SubmapKey{"u", {0, 0}, version}));
      QCOMPARE(session_->status({0, 0}), SubmapStatus::Corrupt);
      QVERIFY(session_->settled(1));
    }
    QCOMPARE(robot_->asked.size(), std::size_t(2));  // the robot's own answer is not asked for twice
  }

  void whatLiesBrokenOnTheDiskIsAskedOfTheRobotOnce() {
    robot_->from_disk = true;
    for (int version = 1; version <= 2; ++version) {
      now_ += submap::Millis(3'600'000);
      robot_->say(listOf({entry(0, version)}));
      for (int times = 1; times <= 2; ++times) {
        QCOMPARE(robot_->open.size(), std::size_t(1));
        QVERIFY(!session_->settled(1));
        robot_->answer(Outcome::Ok, 0, 5, 7);
        now_ += submap::Millis(3'600'000);
        QTRY_COMPARE(robot_->discarded.size(), std::size_t(2 * version - 2 + times));
      }
      // Even if it lies again about where its answer came from.
      QVERIFY(robot_->open.empty());
      QVERIFY(session_->settled(1));
      QCOMPARE(session_->status({0, 0}), SubmapStatus::Corrupt);
    }
    now_ += submap::Millis(3'600'000);
    robot_->say(listOf({entry(0, 3)}));
    robot_->answer(Outcome::Ok, 0, 5, 7);
    now_ += submap::Millis(3'600'000);
    QTRY_COMPARE(robot_->open.size(), std::size_t(1));
    robot_->from_disk = false;
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->status({0, 0}), SubmapStatus::OnScreen);
  }

  void theCountsAlwaysAddUp() {
    auto lost = entry(4, 1);
    lost.pose.x = std::nan("");
    robot_->say(listOf({entry(0, 1), entry(1, 1), entry(2, 1), entry(3, 1), lost, entry(5, 1)}));
    robot_->answer(Outcome::Ok);
    robot_->answer(Outcome::NotFound);
    robot_->answer(Outcome::Failed);
    robot_->answer(Outcome::Ok, 0, 5, 7);  // sizes do not fit: corrupt
    QTRY_COMPARE(session_->counts().corrupt, 2);
    const auto counts = session_->counts();
    QCOMPARE(counts.listed, 6);
    QCOMPARE(counts.shown, 1);
    QCOMPARE(counts.missing, 1);
    QCOMPARE(counts.failed, 1);
    QCOMPARE(counts.pending, 1);
    QCOMPARE(session_->status({0, 1}), SubmapStatus::Missing);
    QVERIFY(session_->reason({0, 1}) == fault::said("The robot said no."));
    QCOMPARE(session_->status({0, 2}), SubmapStatus::Waiting);
    QCOMPARE(session_->status({0, 3}), SubmapStatus::Corrupt);
    QCOMPARE(session_->status({0, 4}), SubmapStatus::Unplaced);
    QCOMPARE(session_->problems().unresolved(), 4);
  }

  void theOldPictureStaysWhileTheNewOneIsOnItsWay() {
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    now_ += submap::Millis(1000);
    robot_->say(listOf({entry(0, 2)}));
    QCOMPARE(session_->status({0, 0}), SubmapStatus::Updating);
    QCOMPARE(session_->counts().shown, 1);
    QVERIFY(!session_->settled(1));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->status({0, 0}), SubmapStatus::OnScreen);
  }

  void aMovedPoseIsNotFetched() {
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    QSignalSpy placed(session_.get(), &Session::submapsPlaced);
    now_ += submap::Millis(10'000);
    robot_->say(listOf({entry(0, 1, 3)}));
    QCOMPARE(placed.count(), 1);
    QCOMPARE(robot_->asked.size(), std::size_t(1));
  }

  void aNewSessionAbortsTheFetchesOfTheOldOne() {
    robot_->say(listOf({entry(0, 1), entry(1, 1)}));
    QSignalSpy restarted(session_.get(), &Session::sessionRestarted);
    robot_->say(listOf({entry(0, 1)}, "v"));
    QCOMPARE(restarted.count(), 1);
    QCOMPARE(robot_->open.size(), std::size_t(1));
    QCOMPARE(robot_->open[0].first.uuid, std::string("v"));
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void aPictureDecodedForTheOldSessionIsDropped() {
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::Ok);  // is being decoded now
    robot_->say(listOf({entry(0, 1), entry(1, 1)}, "v"));
    robot_->answer(Outcome::NotFound);
    robot_->answer(Outcome::Ok);  // is decoded after the one of before
    QTRY_COMPARE(session_->counts().shown, 1);
    QCOMPARE(session_->status({0, 0}), SubmapStatus::Missing);
    QCOMPARE(session_->status({0, 1}), SubmapStatus::OnScreen);
    QVERIFY(session_->submaps().find({0, 0})->slices.empty());
  }

  void whatIsLookedAtComesFirst() {
    std::vector<map::SubmapEntry> entries;
    for (int i = 0; i < 20; ++i) entries.push_back(entry(i, 1, i * 10));
    geometry::WorldRect view;
    view.extend(Eigen::Vector2d(145, -5));
    view.extend(Eigen::Vector2d(165, 5));
    session_->setView(view, view.center());
    robot_->say(listOf(entries));
    QCOMPARE(robot_->asked.size(), std::size_t(4));
    QCOMPARE(robot_->asked[0].id.index, 15);
    session_->setVisible({{0, 0}}, false);
    session_->setView({-5, -5, 5, 5}, {0, 0});
    robot_->answer(Outcome::Ok);
    QCOMPARE(robot_->asked.back().id.index, 1);  // 0 is nearest, but hidden
  }

  void anInterruptedLinkAsksForNothingAndKeepsThePicture() {
    robot_->say(listOf({entry(0, 1), entry(1, 1)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    QVERIFY(session_->staleSince().has_value());
    robot_->answer(Outcome::Failed);
    now_ += submap::Millis(100'000);
    QCOMPARE(session_->counts().shown, 1);
    session_->setVisible({{0, 0}}, false);
    QCOMPARE(robot_->asked.size(), std::size_t(2));
    QCOMPARE(session_->counts().shown, 0);
    session_->setVisible({{0, 0}}, true);
    QCOMPARE(session_->counts().shown, 1);
    robot_->setPhase(robot::ConnectionPhase::Online);
    QVERIFY(!session_->staleSince());
    QCOMPARE(robot_->asked.size(), std::size_t(3));
  }

  void whatIsShownOfALostRobotIsAsOfWhatWasHeardLast() {
    const QDateTime heard(QDate(2026, 5, 1), QTime(12, 3, 34));
    robot_->silent_since = heard;
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    QCOMPARE(session_->staleSince(), std::optional(heard));
    robot_->silent_since = {};
    robot_->setPhase(robot::ConnectionPhase::Online);
    QVERIFY(!session_->staleSince());
  }

  void aReconnectWithTheSameSessionFetchesNothingAgain() {
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    robot_->setPhase(robot::ConnectionPhase::Online);
    robot_->say(listOf({entry(0, 1)}));
    QCOMPARE(robot_->asked.size(), std::size_t(1));
  }

  void retryNowAsksAgainForWhatIsMissing() {
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::NotFound);
    QVERIFY(session_->settled(1));
    session_->retryNow();
    QCOMPARE(robot_->asked.size(), std::size_t(2));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void aSliceThatASubmapLacksDrawsNothing() {
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    session_->setSlice(1);
    QCOMPARE(session_->status({0, 0}), SubmapStatus::NoSlice);
    QCOMPARE(session_->counts().without_slice, 1);
    QVERIFY(session_->settled(1));
  }

  void aSubmapThatFailedRecoversWithItsNextVersion_data() {
    QTest::addColumn<int>("outcome");
    QTest::newRow("not there") << int(Outcome::NotFound);
    QTest::newRow("failed") << int(Outcome::Failed);
    QTest::newRow("of another session") << int(Outcome::WrongUuid);
  }
  void aSubmapThatFailedRecoversWithItsNextVersion() {
    QFETCH(int, outcome);
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome(outcome));
    QCOMPARE(session_->problems().unresolved(), 1);
    now_ += submap::Millis(100'000);
    robot_->say(listOf({entry(0, 2)}));
    QCOMPARE(session_->problems().unresolved(), 1);
    robot_->answer(Outcome::Ok);
    QCOMPARE(session_->problems().unresolved(), 0);
    QTRY_COMPARE(session_->counts().shown, 1);
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void everyOutcomeHasAStatusThatItsWorkStandsBehind_data() {
    QTest::addColumn<int>("outcome");
    QTest::addColumn<int>("status");
    QTest::newRow("ok") << int(Outcome::Ok) << int(SubmapStatus::OnScreen);
    QTest::newRow("not found") << int(Outcome::NotFound) << int(SubmapStatus::Missing);
    QTest::newRow("wrong uuid") << int(Outcome::WrongUuid) << int(SubmapStatus::Waiting);
    QTest::newRow("failed") << int(Outcome::Failed) << int(SubmapStatus::Waiting);
    QTest::newRow("cancelled") << int(Outcome::Cancelled) << int(SubmapStatus::Queued);
  }
  void everyOutcomeHasAStatusThatItsWorkStandsBehind() {
    QFETCH(int, outcome);
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome(outcome));
    QFETCH(int, status);
    QTRY_COMPARE(int(session_->status({0, 0})), status);
    // What is said to be queued or waiting is asked for once its time has come.
    const bool asks = status == int(SubmapStatus::Queued) || status == int(SubmapStatus::Waiting);
    now_ += submap::Millis(100'000);
    robot_->say(listOf({entry(0, 1)}));
    QCOMPARE(robot_->asked.size(), std::size_t(asks ? 2 : 1));
  }

  void aSubmapThatFailsAtEveryVersionIsOneRow() {
    for (int version = 1; version <= 5; ++version) {
      robot_->say(listOf({entry(0, version)}));
      robot_->answer(Outcome::NotFound);
      now_ += submap::Millis(1'000);
      robot_->say(listOf({entry(0, version)}));
    }
    QCOMPARE(session_->problems().rows().size(), std::size_t(1));
    QCOMPARE(session_->problems().rows()[0].count, 5);
    const map::Problem& problem = session_->problems().rows()[0].problem;
    QCOMPARE(problem.subject.id, std::string("0-0"));
    QVERIFY(problem.reason == Fault(session::fault::VersionNotHad, {5}, {fault::said("The robot said no.")},
                                    Consequence::AskedAgainAtTheNext));
  }

  void aCorruptPictureRecoversWithTheNextVersion() {
    robot_->say(listOf({entry(0, 1)}));
    robot_->answer(Outcome::Ok, 0, 5, 7);
    QTRY_COMPARE(session_->counts().corrupt, 1);
    QCOMPARE(session_->problems().unresolved(), 1);
    now_ += submap::Millis(1'000);
    robot_->say(listOf({entry(0, 2)}));
    robot_->answer(Outcome::Failed);  // the broken one is on screen yet
    QCOMPARE(session_->problems().unresolved(), 2);
    now_ += submap::Millis(100'000);
    robot_->say(listOf({entry(0, 3)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void aSubmapRecoversFromWhatItsListSaidWhenTheListIsFine_data() {
    QTest::addColumn<int>("trouble");
    QTest::newRow("no usable pose") << 0;
    QTest::newRow("listed twice") << 1;
    QTest::newRow("version went back") << 2;
    QTest::newRow("rows left out") << 3;
  }
  void aSubmapRecoversFromWhatItsListSaidWhenTheListIsFine() {
    QFETCH(int, trouble);
    robot_->say(listOf({entry(0, 2)}));
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    auto broken = listOf({entry(0, 2)});
    if (trouble == 0) broken.entries[0].pose.x = std::nan("");
    if (trouble == 1) broken.entries.push_back(entry(0, 2, 4));
    if (trouble == 2) broken.entries[0].version = 1;
    if (trouble == 3) broken.rejected = {{robot::axbot::fault::RowWithoutNumbers, {7}}};
    robot_->say(broken);
    QCOMPARE(session_->problems().unresolved(), 1);
    robot_->say(broken);
    QCOMPARE(session_->problems().rows().size(), std::size_t(1));
    robot_->say(listOf({entry(0, 2)}));
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void aSubmapThatLeavesTheListIsNoProblemAnyMore() {
    auto lost = entry(2, 1);
    lost.pose.x = std::nan("");
    robot_->say(listOf({entry(0, 1), entry(1, 1), lost, entry(3, 1), entry(3, 1, 1)}));
    robot_->answer(Outcome::Failed);
    robot_->answer(Outcome::NotFound);
    QCOMPARE(session_->problems().unresolved(), 4);
    robot_->say(listOf({entry(1, 1), entry(7, 1)}));
    QCOMPARE(session_->problems().unresolved(), 1);  // 0-1 is still missing
  }

  void aNewSessionSettlesTheProblemsOfTheOldOne() {
    auto lost = entry(2, 1);
    lost.pose.x = std::nan("");
    robot_->say(listOf({entry(0, 1), entry(1, 1), lost}));
    robot_->answer(Outcome::Failed);
    robot_->answer(Outcome::NotFound);
    QCOMPARE(session_->problems().unresolved(), 3);
    robot_->say(listOf({entry(0, 1)}, "v"));
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void aListThatComesAtLastIsNoProblemAnyMore() {
    const map::Problem none{map::Severity::Warning, map::Subject(map::SubjectKind::SubmapList, {}),
                            fault::said("None yet."), map::ProblemCode::Unavailable};
    for (int connection = 0; connection < 2; ++connection) {
      Q_EMIT robot_->problemFound(none);
      QCOMPARE(session_->problems().unresolved(), 1);
      robot_->say(listOf({}));
      QCOMPARE(session_->problems().unresolved(), 0);
    }
  }

  void whatTheRobotTellsToBeWellIsResolved() {
    QSignalSpy changed(session_.get(), &Session::problemsChanged);
    const map::Subject topic(map::SubjectKind::Topic, "/x");
    robot_->say(map::UnreadableMessage{"/x", fault::said("It is garbage.")});
    Q_EMIT robot_->problemFound({map::Severity::Warning, topic, fault::said("Odd."), map::ProblemCode::Odd});
    QCOMPARE(session_->problems().unresolved(), 2);
    Q_EMIT robot_->recovered({topic, map::ProblemCode::Unreadable});
    QCOMPARE(session_->problems().unresolved(), 1);
    Q_EMIT robot_->recovered({topic});
    QCOMPARE(session_->problems().unresolved(), 0);
    QTRY_VERIFY(!changed.isEmpty());
  }

  void aTopicThatNobodyWantsAnyMoreIsNoProblem() {
    robot_->has_topics = true;
    session_->want(QStringLiteral("layers"), {}, {QStringLiteral("/x"), QStringLiteral("/y")});
    robot_->say(map::UnreadableMessage{"/x", fault::said("It is garbage.")});
    robot_->say(map::UnreadableMessage{"/y", fault::said("It is garbage.")});
    session_->want(QStringLiteral("layers"), {}, {QStringLiteral("/y")});
    QCOMPARE(session_->problems().unresolved(), 1);
  }

  void aRobotThatIsConnectedAgainHasItsProblemsBehindIt() {
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    Q_EMIT robot_->problemFound({map::Severity::Error, map::Subject(map::SubjectKind::Robot, "1.2.3.4:8090"),
                                 fault::said("It is gone.")});
    Q_EMIT robot_->problemFound({map::Severity::Error, "something else", fault::said("No.")});
    QCOMPARE(session_->problems().unresolved(), 2);
    robot_->setPhase(robot::ConnectionPhase::Online);
    QCOMPARE(session_->problems().unresolved(), 1);
  }

  void problemsMayBeToldWithTheirTimes() {
    const QDateTime noon = QDateTime(QDate(2026, 1, 2), QTime(12, 0), QTimeZone::utc()).toUTC();
    const map::Subject stop(map::SubjectKind::Condition, "emergency-stop");
    session_->report({map::Severity::Error, stop, map::fault::EmergencyStop}, noon);
    session_->recover({stop}, noon.addSecs(90));
    QCOMPARE(session_->problems().rows()[0].lastedMs(noon.addSecs(500)), 90'000);
  }

  void unreadableMessagesBecomeProblems() {
    robot_->say(map::UnreadableMessage{"/submap_list", fault::said("It is garbage.")});
    QCOMPARE(session_->problems().rows().size(), std::size_t(1));
  }

  void replyingAfterTheSessionIsGoneIsHarmless() {
    robot_->say(listOf({entry(0, 1)}));
    auto reply = std::move(robot_->open[0].second);
    session_.reset();
    reply({});
  }
};

}  // namespace test_session

MAPWRIGHT_TEST(test_session, SessionTest, Core)
#include "test_session.moc"
