// The report of a moment: what lies on the way, what is not known, and that nothing of others becomes markup.
#include <cmath>

#include <QBuffer>
#include <QRegularExpression>
#include <QTest>

#include "incident/report.h"
#include "test_program.h"

namespace test_incident {

using namespace mapwright;
using incident::OnTheWay;
using incident::Run;

namespace {

constexpr double kAt = 1'717'405'200;

map::OverlayFeature line(int type, std::vector<Eigen::Vector2d> points, std::string name = {}) {
  return {map::OverlayShape::Line, type, {}, std::move(name), {}, {std::move(points)}};
}
map::OverlayFeature region(int type, std::vector<Eigen::Vector2d> ring, std::string name = {}) {
  return {map::OverlayShape::Polygon, type, {}, std::move(name), {}, {std::move(ring)}};
}
std::vector<Eigen::Vector2d> square(double x, double y, double edge) {
  return {{x, y}, {x + edge, y}, {x + edge, y + edge}, {x, y + edge}};
}
incident::Way straight() { return {{{0, 0}, {10, 0}}, 0, false}; }

map::LiveState drivingEast() {
  map::LiveState live;
  live.robot_pose = geometry::Pose2{2, 0, 0};
  live.path = {{0, 0}, {10, 0}};
  live.model.footprint = {{-0.4, -0.3}, {0.4, -0.3}, {0.4, 0.3}, {-0.4, 0.3}};
  return live;
}

/// A run that tells everything, all of it in odd words.
Run toldBy(const std::string& word) {
  Run run;
  run.name = word;
  run.at_s = kAt;
  run.live = drivingEast();
  run.live.slam = {word, false, 3, 0.4, false, true};
  run.live.planning = map::PlanningState{7, word, "failed", word, word, 3.5, {{1, 2, 3}}};
  run.live.wheels = map::WheelState{word, true, true};
  run.live.battery = map::BatteryState{0.42, 24, 1, word};
  run.live.sensors = map::SensorState{word};
  run.live.alerts = {{1001, map::AlertLevel::Error, word, kAt - 3}};
  run.live.map_info = map::MapInfo{word, "u", 3, 4, {}, {}};
  run.live.doors = {{word, "mac", word, square(7, -1, 2)}};
  map::SafetyCondition condition;
  condition.text = word;
  condition.since_s = kAt - 3;
  run.conditions.all = {{condition, condition.since_s}};
  run.conditions.poor_since_s = kAt - 12;
  run.overlays = {line(2, {{4, -1}, {4, 1}}, word), region(1, square(5, -1, 1), word)};
  run.map_name = word;
  run.topics = {{word, kAt - 60}, {"/other", kAt - 1}};
  run.info.topics = {{"later " + word, {}, {}, {}}};
  run.events = {{kAt - 20, replay::EventKind::AlertBegan, 1001, word, 0},
                {kAt - 10, replay::EventKind::PositionJump, 0, {}, 2.5},
                {kAt + 5, replay::EventKind::MapChanged, 0, word, 0}};
  run.curves = {{series::Quantity::Speed, {{{kAt - 20, 0.5}, {kAt, 0}}}, 0.0}};
  run.said = {{"/bumper_state " + word, "{\"front\":\"" + word + "\"}"}};
  run.picture = "png";
  run.picture_px = {10, 10};
  run.remarks = {QString::fromStdString(word)};
  return run;
}

QString htmlOf(const incident::Report& report) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  incident::writeReport(buffer, report);
  return QString::fromUtf8(buffer.data());
}

QStringList tagsOf(const QString& html) {
  static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
  QStringList all;
  for (auto it = tag.globalMatch(html); it.hasNext();) all << it.next().captured();
  return all;
}

}  // namespace

class IncidentTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatThePathCrossesIsToldWithItsDistance() {
    const auto met =
        incident::onTheWay(straight(), 0,
                           {region(1, square(7, -1, 1), "R"), line(2, {{4, -1}, {4, 1}}, "W"),
                            line(2, {{4, 1}, {4, 2}}, "beside"), line(3, {{3, -1}, {3, 1}}, "guide"),
                            region(12, square(1, -1, 1), "free")},
                           {});
    QCOMPARE(met.size(), std::size_t(2));
    QCOMPARE(met[0].name, std::string("W"));
    QVERIFY(std::abs(met[0].along_m - 4) < 0.06);
    QCOMPARE(met[0].away_m, 0.0);
    QCOMPARE(met[1].name, std::string("R"));
    QVERIFY(std::abs(met[1].along_m - 7) < 0.06);
  }

  void whatComesWithinTheRadiusIsToldWithHowNear() {
    const auto wall = line(2, {{4, 0.2}, {6, 0.2}});
    QVERIFY(incident::onTheWay(straight(), 0.1, {wall}, {}).empty());
    const auto met = incident::onTheWay(straight(), 0.3, {wall}, {});
    QCOMPARE(met.size(), std::size_t(1));
    QVERIFY(std::abs(met[0].away_m - 0.2) < 1e-6);
    QVERIFY(met[0].along_m > 3.7 && met[0].along_m < 4);
    QVERIFY(!met[0].here);
  }

  void aRobotInsideOfARegionIsThere() {
    const auto met = incident::onTheWay(straight(), 0, {region(2, square(-1, -1, 3))}, {});
    QCOMPARE(met.size(), std::size_t(1));
    QVERIFY(met[0].here);
    QCOMPARE(met[0].along_m, 0.0);
  }

  void doorsOfTheRobotAreObstaclesToo() {
    const auto met = incident::onTheWay(straight(), 0, {}, {{"D1", "m", "closed", square(5, -1, 2)}});
    QCOMPARE(met.size(), std::size_t(1));
    QCOMPARE(met[0].state, std::string("closed"));
    QVERIFY(met[0].seen_door);
  }

  void onlyTheRestOfThePathCounts() {
    map::LiveState live = drivingEast();
    const auto rest = incident::remainingWay(live);
    QCOMPARE(rest.points.size(), std::size_t(2));
    QVERIFY((rest.points.front() - Eigen::Vector2d(2, 0)).norm() < 1e-9);
    // Out and back over the same place: what is still to go tells which time it is.
    live.path = {{0, 0}, {10, 0}, {10, 0.01}, {0, 0.01}};
    live.planning = map::PlanningState{};
    live.planning->remaining_distance_m = 2;
    QCOMPARE(incident::remainingWay(live).points.size(), std::size_t(2));
    live.planning->remaining_distance_m = 18;
    QCOMPARE(incident::remainingWay(live).points.size(), std::size_t(4));
    live.planning.reset();
    QCOMPARE(incident::remainingWay(live).points.size(), std::size_t(4));
    live.robot_pose.reset();
    QVERIFY(incident::remainingWay(live).points.empty());
  }

  void theRadiusIsHalfTheWidth() {
    QCOMPARE(incident::radiusOf(drivingEast().model), 0.3);
    QCOMPARE(incident::radiusOf({{}, {}, 0.8}), 0.4);
    QCOMPARE(incident::radiusOf({}), 0.0);
  }

  void whatIsNotInTheBagIsListed() {
    Run run;
    run.at_s = kAt;
    const QString all = incident::notKnown(run).join(QLatin1Char('\n'));
    for (const char* what : {"Position:", "Position quality:", "Planner state:", "Path:", "Emergency stop:",
                             "Bumpers:", "Battery:", "Scan:", "outline:", "Map:", "Overlays:", "Speed:"})
      QVERIFY2(all.contains(QLatin1String(what)), what);
    run = toldBy("word");
    run.live.clouds["/scan"] = nullptr;
    QCOMPARE(incident::notKnown(run).size(), 1);  // the topic that begins later
  }

  /// A reason stands for itself only where a task has failed, in words where the code is known.
  void aReasonIsToldInWordsOnceSomethingFailed() {
    Run run = toldBy("14");
    QVERIFY(htmlOf({run, {}, {}, false}).contains(QLatin1String("no way was found for too long (14)")));
    run.live.planning->fail_reason = "EndingPointOutOfMap - the goal";
    QVERIFY(
        htmlOf({run, {}, {}, false})
            .contains(QLatin1String("the target lies outside of the map (EndingPointOutOfMap - the goal)")));
    run.live.planning->fail_reason = "odd";
    QVERIFY(htmlOf({run, {}, {}, false}).contains(QLatin1String("reason, as the robot says it")));
    run.live.planning->move_state = "moving";
    QVERIFY(!htmlOf({run, {}, {}, false}).contains(QLatin1String("reason, as the robot says it")));
  }

  /// Targets alone, as ROS robots tell them, are no state.
  void aPlannerThatTellsOnlyItsTargetIsNotIdle() {
    Run run;
    run.at_s = kAt;
    run.live.planning = map::PlanningState{};
    run.live.planning->targets = {{1, 2, 0}};
    const QString html = htmlOf({run, {}, {}, false});
    QVERIFY(html.contains(QLatin1String("state unknown")) && !html.contains(QLatin1String("idle")));
    QVERIFY(html.contains(QLatin1String("Planner state: not in the bag")));
  }

  /// A report of nothing is a report.
  void aBagWithoutPosesIsReported() {
    Run run;
    run.at_s = kAt;
    const QString html = htmlOf({run, {}, {}, false});
    QVERIFY(html.contains(QLatin1String("not known")));
    QVERIFY(html.contains(QLatin1String("No path is known")));
    QVERIFY(html.endsWith(QLatin1String("</html>\n")));
  }

  void wordsOfOthersStayText() {
    const std::string odd = "<b>\"&\xe2\x80\xae \xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d \xf0\x9f\xa4\x96</td>";
    const incident::Report plain{toldBy("word"), toldBy("word"), 0.5, true};
    const incident::Report odds{toldBy(odd), toldBy(odd), 0.5, true};
    const QString html = htmlOf(odds);
    QCOMPARE(tagsOf(html), tagsOf(htmlOf(plain)));
    QVERIFY(html.contains(QString::fromUtf8(
        "&lt;b&gt;&quot;&amp; \xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d \xf0\x9f\xa4\x96&lt;/td&gt;")));
    QVERIFY(!html.contains(QChar(0x202e)));
    QCOMPARE(html, htmlOf(odds));
  }

  /// Why something happened is told only where the robot says so.
  void causesAreOnlyWhatTheRobotSays() {
    Run run = toldBy("blocked by a box");
    QVERIFY(!htmlOf({run, run, 0.1, true}).contains(QLatin1String("because"), Qt::CaseInsensitive));
    const QString all = incident::consistent(run).join(QLatin1Char('\n'));
    QVERIFY(all.contains(QLatin1String("The robot says itself why it failed")));
    QVERIFY(all.contains(QLatin1String("consistent with the emergency stop")));
    QVERIFY(
        all.contains(QLatin1String("jumped by 2.50 m at 08:59:50.000, which is consistent with its "
                                   "localization, poor since 08:59:48.000.")));
    // It stands a step before the wall.
    run.live.robot_pose = geometry::Pose2{3.2, 0, 0};
    QVERIFY(incident::consistent(run)
                .join(QLatin1Char('\n'))
                .contains(QLatin1String("consistent with being held up at Virtual wall")));
    run.curves.front().at_moment = 0.5;
    QVERIFY(!incident::consistent(run).join(QLatin1Char('\n')).contains(QLatin1String("held up")));
  }

  /// Where the recording begins nobody knows since when.
  void whatIsThereFromTheBeginningHasNoTime() {
    Run run = toldBy("word");
    run.info.start_s = kAt - 4;
    run.first_s[map::topicIndex<map::AlertsMessage>()] = kAt - 3;
    const QString before = QStringLiteral("(since before the recording begins)");
    QString html = htmlOf({run, {}, {}, false});
    QVERIFY(html.contains(before) && !html.contains(QLatin1String("(since 08:59:57.000")));
    // Of another kind, told before without it, or first told of in the middle.
    for (int how = 0; how < 3; ++how) {
      Run other = run;
      if (how == 0) other.conditions.all.front().said.kind = map::SafetyKind::EmergencyStop;
      if (how == 1) other.first_s.begin()->second = kAt - 3.5;
      if (how == 2) other.info.start_s = kAt - 30;
      html = htmlOf({other, {}, {}, false});
      QVERIFY(!html.contains(before) && html.contains(QLatin1String("(since 08:59:57.000, for 3.0 s)")));
    }
  }

  void anEventThatWasThereFromTheBeginningDidNotBegin() {
    Run run = toldBy("word");
    run.info.start_s = kAt - 4;
    run.first_s[map::topicIndex<map::AlertsMessage>()] = kAt - 3;
    run.events = {{kAt - 3, replay::EventKind::AlertBegan, 6004, "M"},
                  {kAt - 1, replay::EventKind::AlertBegan, 6005, "N"}};
    const QString there = QString::fromUtf8("\u2069 (was there already when the recording begins)");
    QString html = htmlOf({run, {}, {}, false});
    QVERIFY(html.contains(QLatin1String("Alert 6004: M") + there));
    QVERIFY(!html.contains(QLatin1String("Alert 6005: N") + there));
    // First told of in the middle.
    run.info.start_s = kAt - 30;
    html = htmlOf({run, {}, {}, false});
    QVERIFY(!html.contains(there));
  }

  void dataThatIsOldIsToldWithItsAge() {
    const QString html = htmlOf({toldBy("word"), {}, {}, false});
    QVERIFY(html.contains(QLatin1String("2024-06-03 08:59:00.000")));
    QVERIFY(html.contains(QLatin1String("60.0 s")));
    QVERIFY(!html.contains(QLatin1String("/other")));
  }

  void topicsThatAreLeftOutAreCounted() {
    Run run = toldBy("word");
    run.live.clouds["/scan"] = nullptr;
    run.topics.clear();
    run.info.topics.clear();
    for (int i = 0; i < 250; ++i) {
      run.topics["/old" + std::to_string(i)] = kAt - 60;
      run.info.topics.push_back({"/later" + std::to_string(i), {}, {}, {}});
    }
    const QStringList not_known = incident::notKnown(run);
    QCOMPARE(not_known.size(), 201);
    QCOMPARE(not_known.last(), QStringLiteral("50 more topics begin only later."));
    QVERIFY(htmlOf({run, {}, {}, false}).contains(QLatin1String("50 more are not listed.")));
    run.topics.clear();
    run.info.topics.resize(201);
    QCOMPARE(incident::notKnown(run).last(), QStringLiteral("1 more topic begins only later."));
  }

  void aMessageThatIsCutEndsInDots() {
    const QChar dots(0x2026);
    Run run = toldBy("word");
    run.said = {{"/bumper", std::string(400, 'x')}};
    QVERIFY(!htmlOf({run, {}, {}, false}).contains(dots));
    run.said = {{"/bumper", std::string(401, 'x')}};
    QVERIFY(htmlOf({run, {}, {}, false}).contains(dots));
  }

  void aCurveHasAxesAndAMark() {
    incident::Minute minute(kAt);
    replay::Digest digest;
    digest.from_s = kAt - 64;
    digest.until_s = kAt + 64;
    for (int i = -640; i < 640; ++i) digest.poses.push_back({kAt + i * 0.1, 0, {i < 0 ? i * 0.1 : 0, 0, 0}});
    minute.addPoses({{replay::tickOf(digest.from_s), digest}});
    const auto curves = minute.curves();
    QCOMPARE(curves.size(), std::size_t(1));
    const QByteArray svg = incident::svgOf(curves.front(), kAt);
    for (const char* part :
         {"Speed (m/s)", "class=\"curve\"", "class=\"mark\"", ">-30 s<", ">+30 s<", ">0 s<", ">1<"})
      QVERIFY2(svg.contains(part), part);
    QVERIFY(!svg.contains("nan"));
    QCOMPARE(svg, incident::svgOf(curves.front(), kAt));
    QVERIFY(incident::Minute(kAt).curves().empty());
  }

  void timesAreUtc() {
    QCOMPARE(incident::utcText(kAt + 0.25), QStringLiteral("2024-06-03 09:00:00.250"));
    QCOMPARE(incident::utcText(std::nan("")), QStringLiteral("-"));
  }
};

}  // namespace test_incident

MAPWRIGHT_TEST(test_incident, IncidentTest, Core)
#include "test_incident.moc"
