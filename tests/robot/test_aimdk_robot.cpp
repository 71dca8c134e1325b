#include <QSignalSpy>
#include <QTest>

#include "robot/aimdk/aimdk_robot.h"
#include "robot/aimdk/faults.h"
#include "scripted_robot.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_aimdk_robot {

using namespace mapwright;
using namespace mapwright::robot;
using aimdk::AimdkRobot;
using testing::ScriptedRobot;

namespace {

constexpr int kPatienceMs = 20'000;
const QByteArray kNames = "/rpc/aimdk.protocol.MappingService/GetStoredMapNames";
const QByteArray kCurrent = "/rpc/aimdk.protocol.MappingService/GetCurrentWorkingMap";
const QByteArray kWhole = "/rpc/aimdk.protocol.MappingService/Get2DWholeMap";
const QByteArray kRealtime = "/rpc/aimdk.protocol.MappingService/GetRealtimeMapData";
const QByteArray kTopo = "/rpc/aimdk.protocol.LocalizationService/GetTopoMsgs";

QByteArray png() {
  return QByteArray::fromHex("89504e470d0a1a0a0000000d49484452000000030000000208000000") + "rest";
}

template <typename T, typename Ask>
Outcome<T> answerTo(Ask ask) {
  std::optional<Outcome<T>> answer;
  ask([&](Outcome<T> given) { answer = std::move(given); });
  if (!QTest::qWaitFor([&] { return answer.has_value(); }, kPatienceMs)) {
    return tl::make_unexpected(map::Failure{.subject = "test", .detail = "no answer"});
  }
  return *answer;
}

}  // namespace

class AimdkRobotTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<ScriptedRobot> server_;
  std::unique_ptr<AimdkRobot> robot_;

  void serveAll() {
    server_->serve(kNames,
                   "{\"data\":{\"map_lists\":[{\"map_id\":\"17\",\"map_name\":\"Park\",\"map_index\":3},{"
                   "\"map_id\":\"1764059676131\",\"map_name\":\"River\",\"map_index\":5}]}}");
    server_->serve(kCurrent, "{\"data\":{\"map_id\":\"1764059676131\"}}");
    server_->serve(kWhole,
                   "{\"data\":{\"map_id\":\"1764059676131\",\"map_name\":\"River\",\"width\":3,\"height\":2,"
                   "\"resolution\":20,\"origin_x\":1,\"origin_y\":1,\"map_data\":"
                   "\"" +
                       png().toBase64() + "\"}}");
    server_->serve(kTopo,
                   "{\"data\":{\"points\":[{\"point_id\":1,\"name\":\"A\",\"pixel_pose\":{\"position\":{"
                   "\"u\":9,\"v\":9},\"angle\":0},\"pose\":{\"position\":{\"x\":1,\"y\":1,\"z\":0}}}]}}");
  }
  void makeRobot(aimdk::LinkOptions options = {}) {
    options.base = server_->url();
    options.poll_every = std::chrono::milliseconds(5);
    options.backoff_first = std::chrono::milliseconds(5);
    options.backoff_limit = std::chrono::milliseconds(20);
    robot_ = std::make_unique<AimdkRobot>(QStringLiteral("aimdk+test"), options);
  }
  bool isIn(ConnectionPhase phase) const { return robot_->connection().phase == phase; }

 private Q_SLOTS:
  void init() {
    server_ = std::make_unique<ScriptedRobot>();
    serveAll();
    makeRobot();
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  void itIsOnlineOnceItListsItsMaps() {
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Online), kPatienceMs);
    QCOMPARE(server_->asked.first().method, QByteArray("POST"));
    QCOMPARE(server_->asked.first().body, QByteArray("{\"command\":\"MappingCommand_GET_STORED_MAP_NAME\"}"));
    robot_->disconnectFromRobot();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Offline), kPatienceMs);
  }

  void oneThatDoesNotAnswerIsSilentBeforeItIsLost() {
    aimdk::LinkOptions options;
    options.quiet_after = std::chrono::milliseconds(300);
    options.timeout = std::chrono::milliseconds(3'000);
    makeRobot(options);
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(server_->timesAsked(kCurrent) > 3, kPatienceMs);
    QVERIFY(isIn(ConnectionPhase::Online) && !silentSince(*robot_));
    server_->held << kCurrent << kNames;
    const QDateTime before = QDateTime::currentDateTime();
    QTRY_VERIFY_WITH_TIMEOUT(silentSince(*robot_), kPatienceMs);
    QVERIFY(isIn(ConnectionPhase::Online));
    const QDateTime heard = *silentSince(*robot_);
    QVERIFY(heard.msecsTo(before) > -250);  // what was on its way
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Interrupted), kPatienceMs);
    QCOMPARE(silentSince(*robot_), std::optional(heard));
    server_->held.clear();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Online), kPatienceMs);
    QVERIFY(!silentSince(*robot_));
  }

  void aLossIsNoticedAndMended() {
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Online), kPatienceMs);
    server_->goAway();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Interrupted), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(robot_->connection().reason.any(), kPatienceMs);
    server_->listen();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Online), kPatienceMs);
  }

  void aServerOfAnotherKindIsNotOnline() {
    server_->serve(kNames, "<html>hello</html>");
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Interrupted) && robot_->connection().reason.any(),
                             kPatienceMs);
  }

  void aRobotThatRefusesItsListSaysWhyInItsOwnWords_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* answer, const char* sentence) {
      QTest::newRow(answer) << QByteArray(answer) << QString::fromLatin1(sentence);
    };
    row("{\"code\":-3,\"message\":\"busy\"}",
        "The list cannot be loaded: the robot refused (code -3): busy.");
    row("{\"code\":7}", "The list cannot be loaded: the robot refused (code 7).");
    row("{\"code\":503,\"msg\":\"later.\"}",
        "The list cannot be loaded: the robot answered 503 (unavailable): later.");
    row("{\"error\":{}}", "The list cannot be loaded: the robot refused.");
    row("{\"message\":\"no maps!\"}", "The list cannot be loaded: the robot refused: no maps!");
    row("{\"data\":{}}", "The list cannot be loaded: the robot refused: the answer contains no data.");
    row("{\"data\":{\"maps\":3}}", "The robot's list of maps is not a list.");
  }
  void aRobotThatRefusesItsListSaysWhyInItsOwnWords() {
    QFETCH(QByteArray, answer);
    QFETCH(QString, sentence);
    server_->serve(kNames, answer);
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(robot_->connection().reason.any(), kPatienceMs);
    const Fault reason = robot_->connection().reason;
    QCOMPARE(sentences::wordsOf(reason), sentence);
    // Only what the robot sent counts as its words.
    const auto isOurs = [](const Fault& each) { return each.code != mapwright::fault::Said; };
    QVERIFY(isOurs(reason));
    for (const Fault& cause : reason.because)
      QVERIFY(isOurs(cause) || answer.contains(std::get<std::string>(cause.arguments.front()).c_str()));
  }

  void anotherCurrentMapIsTold() {
    QSignalSpy changed(robot_.get(), &Robot::mapsChanged);
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(server_->timesAsked(kCurrent) >= 2, kPatienceMs);
    QCOMPARE(changed.size(), 0);
    server_->serve(kCurrent, "{\"data\":{\"map_id\":\"17\"}}");
    QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kPatienceMs);
  }

  void theListMarksTheCurrentMap() {
    const auto entries =
        answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) { robot_->mapCatalogue()->list(reply); });
    QCOMPARE(entries->size(), std::size_t(2));
    QVERIFY(!entries->at(0).is_current && entries->at(1).is_current);
    const auto one = answerTo<map::CatalogueEntry>([&](auto reply) {
      robot_->mapCatalogue()->describe({map::MapKind::Stored, "17"}, reply);
    });
    QCOMPARE(one->name, std::string("Park"));
  }

  void theListStandsWithoutACurrentMap() {
    server_->serve(kCurrent, "{\"code\":5,\"message\":\"none\"}");
    QSignalSpy problems(robot_.get(), &Robot::problemFound);
    const auto entries =
        answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) { robot_->mapCatalogue()->list(reply); });
    QCOMPARE(entries->size(), std::size_t(2));
    QCOMPARE(problems.size(), 1);
    QSignalSpy recovered(robot_.get(), &Robot::recovered);
    server_->serve(kCurrent, "{\"data\":{\"map_id\":\"17\"}}");
    QVERIFY(answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) {
              robot_->mapCatalogue()->list(reply);
            }).has_value());
    QCOMPARE(recovered.size(), 1);
    QCOMPARE(recovered.first().first().value<map::Recovery>().subject,
             problems.first().first().value<map::Problem>().subject);
  }

  void aMapAndItsPointsCome() {
    const map::MapKey key{map::MapKind::Stored, "1764059676131"};
    const auto map =
        answerTo<map::WholeMap>([&](auto reply) { robot_->wholeMapSource()->fetch(key, reply); });
    QVERIFY2(map.has_value(), map ? "" : sentences::sentenceOf(map.error()).c_str());
    QCOMPARE(map->grid, (map::GridReference{3, 2, 0.05, {-0.05, -0.05, 0}}));
    const auto points =
        answerTo<map::WaypointList>([&](auto reply) { robot_->waypointSource()->waypoints(key, reply); });
    QCOMPARE(points->points.size(), std::size_t(1));
    QCOMPARE(points->notes.size(), std::size_t(1));
    QVERIFY(server_->asked.last().body.endsWith("\"map_id\":1764059676131}"));
    QCOMPARE(server_->timesAsked(kWhole), 1);
    // They tell how the map is meant, and are not asked for again at once; later they are.
    QCOMPARE(server_->timesAsked(kTopo), 1);
    server_->serve(kTopo, R"({"data":{"points":[]}})");
    const auto later =
        answerTo<map::WaypointList>([&](auto reply) { robot_->waypointSource()->waypoints(key, reply); });
    QVERIFY(later && later->points.empty());
    QCOMPARE(server_->timesAsked(kTopo), 2);
  }

  void mapAndPointsAskedTogetherLoadTheMapOnce() {
    const map::MapKey key{map::MapKind::Stored, "1764059676131"};
    int maps = 0;
    robot_->wholeMapSource()->fetch(key, [&](const auto& map) { maps += map ? 1 : 0; });
    const auto points =
        answerTo<map::WaypointList>([&](auto reply) { robot_->waypointSource()->waypoints(key, reply); });
    QCOMPARE(maps, 1);
    QCOMPARE(points->notes.size(), std::size_t(1));
    QCOMPARE(server_->timesAsked(kWhole), 1);
    QCOMPARE(server_->timesAsked(kTopo), 1);
  }

  void failuresAreProblemsOfTheMap() {
    server_->answers[kWhole] =
        ScriptedRobot::reply(500, "{\"message\":\"boom\"}", "Content-Type: application/json\r\n");
    const auto map = answerTo<map::WholeMap>([&](auto reply) {
      robot_->wholeMapSource()->fetch({map::MapKind::Stored, "17"}, reply);
    });
    QVERIFY(!map.has_value());
    QVERIFY(map.error().subject == map::Subject(map::SubjectKind::Map, "17"));
    QVERIFY(map.error().detail.find("boom") != std::string::npos);
  }

  void anIdThatIsNoNumberIsAskedForAsItIs() {
    const auto points = answerTo<map::WaypointList>([&](auto reply) {
      robot_->waypointSource()->waypoints({map::MapKind::Stored, "x y"}, reply);
    });
    QVERIFY(points && points->points.size() == 1);
    QVERIFY(server_->asked.last().body.endsWith("\"map_id\":\"x y\"}"));
    QVERIFY(!answerTo<map::WaypointList>([&](auto reply) {
               robot_->waypointSource()->waypoints({map::MapKind::Stored, ""}, reply);
             }).has_value());
  }

  void mapsThatAreLeftOutAreAProblem() {
    QSignalSpy problems(robot_.get(), &Robot::problemFound), recovered(robot_.get(), &Robot::recovered);
    server_->serve(kNames, R"({"data":{"map_lists":[{"map_id":"17"},{"map_name":"nameless"}]}})");
    const auto list = [&] {
      return answerTo<std::vector<map::CatalogueEntry>>(
          [&](auto reply) { robot_->mapCatalogue()->list(reply); });
    };
    QCOMPARE(list()->size(), std::size_t(1));
    QCOMPARE(problems.size(), 1);
    QCOMPARE(problems.first().first().value<map::Problem>().reason,
             Fault(aimdk::fault::MapsWithoutId, {std::int64_t(1)}));
    serveAll();
    const auto before = recovered.size();
    QCOMPARE(list()->size(), std::size_t(2));
    QVERIFY(recovered.size() > before);
  }

  void whileItHasNotToldWhetherItCanBeEditedNobodyClaimsToKnow_data() {
    QTest::addColumn<QByteArray>("answer");  // instead of the one that tells; empty = it is slow
    QTest::newRow("slow") << QByteArray();
    QTest::newRow("hung up") << QByteArray(" ");
    QTest::newRow("busy") << ScriptedRobot::reply(503, "{}");
  }
  void whileItHasNotToldWhetherItCanBeEditedNobodyClaimsToKnow() {
    QFETCH(QByteArray, answer);
    aimdk::LinkOptions options;
    options.quiet_after = std::chrono::milliseconds(50);
    options.map_timeout = std::chrono::milliseconds(300);
    options.probe_again = std::chrono::milliseconds(20);
    makeRobot(options);
    if (answer.isEmpty()) server_->held << kRealtime;
    server_->answers[kRealtime] = answer;
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Online), kPatienceMs);
    const Absence untold{Absence::Reason::NotToldYet, {}};
    for (const Capability one : {Capability::Administration, Capability::WaypointEditing})
      QCOMPARE(robot_->unavailableReason(one), untold);
    QVERIFY2(!sentences::limitsOf(*robot_).contains(QLatin1String("Read only")), "a claim");
    QVERIFY(sentences::limitsOf(*robot_).contains(QLatin1String("not known yet")));
    // It is asked again, and the other questions do not wait for it.
    QTRY_VERIFY_WITH_TIMEOUT(server_->timesAsked(kRealtime) > 2, kPatienceMs);
    QVERIFY(isIn(ConnectionPhase::Online) && !silentSince(*robot_));
    QVERIFY(server_->timesAsked(kCurrent) > 2);
    QSignalSpy changed(robot_.get(), &Robot::capabilitiesChanged);
    server_->held.clear();
    server_->serve(kRealtime, R"({"header":{"code":"0"},"data":{}})");
    QTRY_VERIFY_WITH_TIMEOUT(robot_->mapAdministration(), kPatienceMs);
    QVERIFY(robot_->waypointStore() && !changed.isEmpty());
    QVERIFY(!robot_->mapAdministration()->obstacle(MapChange::StartMapping, nullptr));
    // Where it does not tell at the next connection, nothing is taken away.
    server_->held << kRealtime;
    server_->goAway();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Interrupted), kPatienceMs);
    server_->listen();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Online), kPatienceMs);
    QVERIFY(robot_->mapAdministration()->obstacle(MapChange::StartMapping, nullptr) == Obstacle::NotKnownYet);
    server_->held.clear();
    QTRY_VERIFY_WITH_TIMEOUT(!robot_->mapAdministration()->obstacle(MapChange::StartMapping, nullptr),
                             kPatienceMs);
    // Another answer does.
    server_->goAway();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Interrupted), kPatienceMs);
    server_->answers.remove(kRealtime);
    server_->listen();
    QTRY_VERIFY_WITH_TIMEOUT(!robot_->mapAdministration(), kPatienceMs);
    QCOMPARE(robot_->unavailableReason(Capability::Administration),
             (Absence{Absence::Reason::ReadOnly, {"Agibot"}}));
  }

  void itSaysThatItCannotEdit() {
    QVERIFY(!robot_->mapAdministration());
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(isIn(ConnectionPhase::Online), kPatienceMs);
    QCOMPARE(robot_->unavailableReason(Capability::Administration),
             (Absence{Absence::Reason::ReadOnly, {"Agibot"}}));
    QCOMPARE(robot_->unavailableReason(Capability::Live),
             (Absence{Absence::Reason::NoService, {"?tf=ws://HOST:9090"}}));
    QCOMPARE(
        sentences::limitsOf(*robot_),
        QStringLiteral("Read only: Agibot's interface offers no editing. Its interface does not report its "
                       "pose. If a rosbridge server runs on it, add ?tf=ws://HOST:9090 to its address."));
    QVERIFY(!robot_->liveTopics() && !robot_->submapSource());
  }
};

}  // namespace test_aimdk_robot

MAPWRIGHT_TEST(test_aimdk_robot, AimdkRobotTest, Core)
#include "test_aimdk_robot.moc"
