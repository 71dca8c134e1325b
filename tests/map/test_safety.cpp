// What is dangerous or wrong now, from the robot's state alone.
#include <QTest>

#include "map/live_state.h"
#include "test_program.h"

namespace test_safety {

using namespace mapwright::map;

namespace {

AlertsMessage alerts(std::vector<std::pair<int, std::string>> errors) {
  AlertsMessage message;
  for (auto& [code, text] : errors) message.alerts.push_back({code, AlertLevel::Error, text, 0});
  return message;
}

WheelState stop(bool pressed) { return {"auto", pressed, false}; }

SlamStatus position(std::string state, std::optional<bool> reliable, std::optional<int> quality) {
  SlamStatus slam;
  slam.state = std::move(state);
  slam.reliable = reliable;
  slam.position_quality = quality;
  return slam;
}

std::vector<SafetyKind> kinds(const std::vector<SafetyCondition>& conditions) {
  std::vector<SafetyKind> all;
  for (const SafetyCondition& each : conditions) all.push_back(each.kind);
  return all;
}

}  // namespace

class SafetyTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aRobotThatSaysNothingIsInNoDanger() {
    QVERIFY(safetyOf({}, 100).empty());
    const LiveState quiet = reduce(reduce({}, stop(false), 1), position("positioning", true, 10), 1);
    QVERIFY(safetyOf(quiet, 100).empty());
    WheelState silent;  // it tells neither of a stop nor of its wheels
    QVERIFY(safetyOf(reduce({}, silent, 1), 100).empty());
  }

  void theGravestComesFirst() {
    LiveState live = reduce({}, WheelState{"Manual", true, true}, 10);
    live = reduce(live, position("positioning", false, 1), 11);
    AlertsMessage message = alerts({{6004, "hot"}});
    message.alerts.push_back({8501, AlertLevel::Warning, "low", 0});
    message.alerts.push_back({1, AlertLevel::None, "a note", 0});
    live = reduce(live, message, 12);
    const auto now = safetyOf(live, 13);
    QVERIFY((kinds(now) == std::vector{SafetyKind::EmergencyStop, SafetyKind::PositionLost, SafetyKind::Alert,
                                       SafetyKind::Alert, SafetyKind::WheelsReleased,
                                       SafetyKind::ManualControl}));
    QCOMPARE(now[2].severity, Severity::Error);
    QCOMPARE(now[2].code, 6004);
    QCOMPARE(now[3].severity, Severity::Warning);
    QCOMPARE(now[0].since_s, 10.0);
    QCOMPARE(now[1].since_s, 11.0);
    QCOMPARE(now[2].since_s, 12.0);
  }

  void itIsGoneWhenItIsGone() {
    LiveState live = reduce({}, stop(true), 10);
    QCOMPARE(safetyOf(live, 10).size(), std::size_t(1));
    live = reduce(live, stop(false), 20);
    QVERIFY(safetyOf(live, 20).empty());
    live = reduce(live, alerts({{6004, "hot"}}), 30);
    live = reduce(live, alerts({}), 31);
    QVERIFY(safetyOf(live, 31).empty());
  }

  void howThePositionCounts_data() {
    QTest::addColumn<QString>("state");
    QTest::addColumn<int>("reliable");  // -1: not said
    QTest::addColumn<int>("quality");   // -1: not said
    QTest::addColumn<int>("kind");      // -1: nothing
    const int lost = int(SafetyKind::PositionLost), uncertain = int(SafetyKind::PositionUncertain);
    QTest::newRow("excellent") << "positioning" << 1 << 10 << -1;
    QTest::newRow("good, not reliable") << "positioning" << 0 << 8 << uncertain;
    QTest::newRow("poor") << "positioning" << 1 << 3 << uncertain;
    QTest::newRow("lost") << "positioning" << -1 << 1 << lost;
    QTest::newRow("not reliable, quality unknown") << "positioning" << 0 << 0 << lost;
    QTest::newRow("older firmware, not reliable") << "positioning" << 0 << -1 << lost;
    QTest::newRow("says nothing") << "positioning" << -1 << -1 << -1;
    QTest::newRow("mapping has no position to lose") << "slam" << 0 << 1 << -1;
    QTest::newRow("inactive") << "inactive" << 0 << 1 << -1;
    QTest::newRow("a state of its own") << "Localizing" << 0 << 1 << lost;
  }
  void howThePositionCounts() {
    QFETCH(QString, state);
    QFETCH(int, reliable);
    QFETCH(int, quality);
    QFETCH(int, kind);
    const LiveState live =
        reduce({},
               position(state.toStdString(), reliable < 0 ? std::nullopt : std::optional(reliable == 1),
                        quality < 0 ? std::nullopt : std::optional(quality)),
               5);
    const auto now = safetyOf(live, 5);
    QCOMPARE(now.size(), std::size_t(kind < 0 ? 0 : 1));
    if (kind >= 0) QCOMPARE(int(now[0].kind), kind);
  }

  void anAlertWhoseNumberMovesIsOneThatLasts() {
    LiveState live = reduce({}, alerts({{6004, "80 degrees"}}), 10);
    live = reduce(live, alerts({{6004, "81 degrees"}}), 11);
    const auto now = safetyOf(live, 11);
    QCOMPARE(now.size(), std::size_t(1));
    QCOMPARE(now[0].since_s, 10.0);
    QCOMPARE(now[0].times, 1);
    QCOMPARE(now[0].text, std::string("81 degrees"));
    QCOMPARE(live.alerts[0].since_s, 10.0);  // what the panel shows agrees
  }

  void twoThatDifferInANumberAreTwo() {
    LiveState live = reduce({}, alerts({{7, "Motor 1"}, {7, "Motor 2"}}), 10);
    live = reduce(live, alerts({{7, "Motor 1"}, {7, "Motor 2"}}), 11);
    QCOMPARE(safetyOf(live, 11).size(), std::size_t(2));
    live = reduce(live, alerts({{7, "Motor 2"}}), 12);
    QCOMPARE(safetyOf(live, 12).size(), std::size_t(1));
    QCOMPARE(safetyOf(live, 12)[0].text, std::string("Motor 2"));
  }

  void whatIsOnAndOffIsOneThatStays() {
    LiveState live;
    for (int i = 0; i < 6; ++i) live = reduce(live, stop(i % 2 == 0), 10 + i);  // ends at 15
    auto now = safetyOf(live, 15);
    QCOMPARE(now.size(), std::size_t(1));
    QCOMPARE(now[0].since_s, 10.0);
    QCOMPARE(now[0].times, 3);
    QVERIFY(now[0].ended_s.has_value());
    QCOMPARE(safetyChangesAt(live, 15).value(), 15 + kSafetyHoldS);
    QVERIFY(safetyOf(live, 15 + kSafetyHoldS).empty());
    QVERIFY(!safetyChangesAt(live, 15 + kSafetyHoldS));
  }

  void afterALongPauseItBeginsAnew() {
    LiveState live = reduce(reduce({}, stop(true), 10), stop(false), 12);
    live = reduce(live, stop(true), 12 + kSafetyPauseS + 1);
    QCOMPARE(safetyOf(live, 30)[0].since_s, 12 + kSafetyPauseS + 1);
    QCOMPARE(safetyOf(live, 30)[0].times, 1);
  }

  void whatEndedLongAgoIsNotKept() {
    LiveState live;
    for (int i = 0; i < 1000; ++i) {
      live = reduce(live, alerts({{i, "x"}}), 100 * i);
      QVERIFY(live.safety.size() <= 2);
    }
  }

  void aClockThatWasSetBackDoesNoHarm() {
    LiveState live = reduce({}, stop(true), 1000);
    live = reduce(live, stop(true), 10);
    QCOMPARE(safetyOf(live, 10).size(), std::size_t(1));
    QCOMPARE(safetyOf(live, 10)[0].since_s, 10.0);
  }

  void aFloodOfAlertsIsTakenInTime() {
    std::vector<std::pair<int, std::string>> many;
    for (int i = 0; i < 50'000; ++i) many.emplace_back(i, std::string(50, char('a' + i % 26)));
    LiveState live = reduce({}, alerts(many), 1);
    live = reduce(std::move(live), alerts(many), 2);
    QCOMPARE(safetyOf(live, 2).size(), many.size());
    QCOMPARE(safetyOf(live, 2)[0].since_s, 1.0);
  }

  void everyConditionIsAProblemOfItsOwn() {
    std::set<std::string> subjects;
    for (int kind = 0; kind <= int(SafetyKind::WheelsSlipping); ++kind) {
      SafetyCondition condition;
      condition.kind = SafetyKind(kind);
      const Problem problem = problemOf(condition);
      QCOMPARE(problem.subject.kind, SubjectKind::Condition);
      QVERIFY(problem.reason.any());
      QVERIFY(subjects.insert(problem.subject.id).second);
    }
    const Problem hot = problemOf({SafetyKind::Alert, Severity::Error, 6004, "hot", 0, 1, {}});
    QCOMPARE(hot.subject.id, std::string("alert:6004"));
    QVERIFY(hot.reason == mapwright::fault::said("hot"));
  }
};

}  // namespace test_safety

MAPWRIGHT_TEST(test_safety, SafetyTest, Nothing)
#include "test_safety.moc"
