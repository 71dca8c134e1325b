// Changes on their way to a robot with a request for each: what became of every one of them is known, or it
// is said that it is not.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "../edit/fake_waypoint_store.h"
#include "app/exit_code.h"
#include "app/waypoint_sending.h"
#include "exchange/waypoint_plan.h"
#include "robot/ros/faults.h"
#include "sentences/failure_sentence.h"
#include "test_program.h"

namespace test_waypoint_sending {

using namespace mapwright;
using test::FakeWaypointStore;
using test::waypoint;

namespace {

map::Failure failed(map::FailureKind kind, map::Applied applied) {
  map::Failure failure;
  failure.kind = kind;
  failure.applied = applied;
  return failure;
}

}  // namespace

class WaypointSendingTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>();

  /// A map of which only the time and the event loop matter here.
  std::unique_ptr<app::RobotReading> reading(double timeout_s = 60) {
    QFile picture(folder_.filePath(QStringLiteral("map.pgm")));
    if (!picture.open(QIODevice::WriteOnly) || picture.write("P5\n1 1\n255\n\xfe") != 12) return {};
    picture.close();
    auto opened =
        app::RobotReading::open(picture.fileName(), {}, {app::commandStart(timeout_s, 0), timeout_s},
                                app::RobotReading::Purpose::Maps, workers_);
    return opened ? std::move(*opened) : nullptr;
  }
  static std::vector<exchange::WaypointEdit> threeMoves(const FakeWaypointStore& store) {
    std::vector<exchange::WaypointEdit> edits;
    for (const map::Waypoint& point : store.points) {
      map::Waypoint after = point;
      after.position_m += Eigen::Vector2d(10, 0);
      edits.push_back({point.id, point, after});
    }
    return edits;
  }
  static void fill(FakeWaypointStore& store) {
    store.points = {waypoint("a", 1, 1, "Ada"), waypoint("b", 2, 2, "Bo"), waypoint("c", 3, 3, "Cy")};
  }
  static QString states(const app::SentWaypoints& sent) {
    QString line;
    for (const app::SentStep& one : sent.steps) line += QStringLiteral("AFUN").at(int(one.outcome.state));
    return line;
  }

 private Q_SLOTS:
  void everythingIsSentOneByOneAndLookedAtAfterwards() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    auto edits = threeMoves(store);
    edits.push_back({exchange::freshKey(), std::nullopt, waypoint("", 5, 5, "New")});
    const auto sent = app::sendWaypoints(list, edits, app::AtFailure::Stop);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("AAAA"));
    QVERIFY(sent->complete());
    QCOMPARE(sent->exitCode(), 0);
    QCOMPARE(store.asked.size(), std::size_t(4));
    // The robot gave it an id of its own.
    QCOMPARE(sent->kept.at(edits.back().key).id, std::string("robot-1"));
  }

  void afterAFailureNothingMoreIsSent() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    store.before_performing = [&] {
      if (store.asked.size() == 2)
        store.failures = {failed(map::FailureKind::RejectedByRobot, map::Applied::No)};
    };
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::Stop);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("AFN"));
    QCOMPARE(sent->exitCode(), int(app::kIncomplete));
    QCOMPARE(store.asked.size(), std::size_t(2));
  }

  void theOthersGoOnWhenAskedTo() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    store.failures = {failed(map::FailureKind::RejectedByRobot, map::Applied::No)};
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::GoOn);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("FAA"));
    QCOMPARE(sent->exitCode(), int(app::kIncomplete));
    QCOMPARE(store.asked.size(), std::size_t(3));  // the one that failed is not asked for again
    QVERIFY(sent->sentence().contains(QStringLiteral("Ada")));
    const QJsonObject json = app::sentJson(*sent, "1");
    QCOMPARE(json[QStringLiteral("applied")].toInt(), 2);
    QCOMPARE(json[QStringLiteral("remaining")].toInt(), 0);
    QVERIFY(!json[QStringLiteral("complete")].toBool());
    const QJsonObject row = json[QStringLiteral("failed")].toArray().first().toObject();
    QCOMPARE(row[QStringLiteral("name")].toString(), QStringLiteral("Ada"));
    QVERIFY(row[QStringLiteral("sentence")].toString().startsWith(QStringLiteral("It was not changed")));
  }

  void whoseAnswerIsLostIsLookedAt() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    store.failures = {failed(map::FailureKind::Unreachable, map::Applied::Maybe)};  // and it does it
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::GoOn);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("ANN"));  // over a lost link nothing goes on
  }

  // It may be at work on it still: that nothing is to be seen yet proves nothing.
  void whoseAnswerIsLostMayDoItLater() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    store.failures = {failed(map::FailureKind::Unreachable, map::Applied::Maybe)};
    store.does_what_fails = false;
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::GoOn);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("UNN"));
    QVERIFY2(sent->sentence().contains(QStringLiteral("Whether it was changed is unknown")),
             qPrintable(sent->sentence()));
  }

  void whatIsTakenInPartSaysWhichPart() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    map::Failure tags = failed(map::FailureKind::RejectedByRobot, map::Applied::Yes);
    tags.reason = map::FailureReason::Unfit;
    tags.cause = {robot::ros::fault::TagsNotTaken, {"Ada"}};
    store.failures = {tags};
    store.does_what_fails = false;
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::GoOn);
    QVERIFY(sent.has_value());
    QCOMPARE(int(sent->steps.front().outcome.state), int(app::StepState::Failed));
    QCOMPARE(exchange::sentenceOf(sent->steps.front().outcome),
             QString::fromStdString(sentences::sentenceOf(tags)));
  }

  void whatNobodyCanTellIsNamed() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    store.failures = {failed(map::FailureKind::RejectedByRobot, map::Applied::Maybe)};
    store.before_performing = [&] { store.unreadable = true; };
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::Stop);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("UNN"));
    QCOMPARE(sent->exitCode(), int(app::kIncomplete));
    QVERIFY2(sent->sentence().contains(QStringLiteral("Ada: Whether it was changed is unknown")),
             qPrintable(sent->sentence()));
    const QJsonObject json = app::sentJson(*sent, "1");
    QCOMPARE(json[QStringLiteral("unknown")].toArray().size(), 1);
    QCOMPARE(json[QStringLiteral("remaining")].toInt(), 2);
  }

  void whatOthersChangedStopsItBeforeAnythingIsSent() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    const auto edits = threeMoves(store);
    store.put(waypoint("b", 7, 7, "Bo"));
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, edits, app::AtFailure::GoOn);
    QVERIFY(sent.has_value());
    QCOMPARE(sent->conflicts.size(), std::size_t(1));
    QCOMPARE(sent->exitCode(), int(app::kRobotError));
    QVERIFY(store.asked.empty());
    QVERIFY2(sent->sentence().contains(QStringLiteral("Nothing was sent")), qPrintable(sent->sentence()));
  }

  void whatDoesNotGoThroughInTimeIsGivenUp() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    store.hold = true;
    const auto robot = reading(5);
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::GoOn);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("NNN"));
    QCOMPARE(store.asked.size(), std::size_t(1));
    QVERIFY2(sent->sentence().contains(QStringLiteral("within 5 s")), qPrintable(sent->sentence()));
    QCOMPARE(sent->exitCode(), int(app::kUnreachable));
  }

  // It was sent, and nobody answers: that is neither a robot out of reach nor one that refused.
  void whetherItWasMadeIsNotKnownHasACodeOfItsOwn() {
    for (const auto kind : {map::FailureKind::TimedOut, map::FailureKind::Unreachable,
                            map::FailureKind::RejectedByRobot, map::FailureKind::MalformedAnswer}) {
      map::Failure change = failed(kind, map::Applied::Maybe);
      change.asked_for = map::AskedFor::Change;
      QCOMPARE(int(app::exitCodeOf(change)), int(app::kIncomplete));
      change.applied = map::Applied::No;
      QCOMPARE(int(app::exitCodeOf(change)), int(app::exitCodeOf(kind)));
    }
  }

  void whoIsOutOfReachBeforeAnythingIsSentIsNoErrorOfTheRobot() {
    FakeWaypointStore store(FakeWaypointStore::Mode::OneByOne);
    fill(store);
    store.readable = 1;
    const auto robot = reading();
    QVERIFY(robot);
    app::ListedWaypoints list{robot.get(), {}, {}, &store};
    const auto sent = app::sendWaypoints(list, threeMoves(store), app::AtFailure::GoOn);
    QVERIFY(sent.has_value());
    QCOMPARE(states(*sent), QStringLiteral("NNN"));
    QCOMPARE(sent->exitCode(), int(app::kUnreachable));
  }
};

}  // namespace test_waypoint_sending

MAPWRIGHT_TEST(test_waypoint_sending, WaypointSendingTest, Widgets)
#include "test_waypoint_sending.moc"
