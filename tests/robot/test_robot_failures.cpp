// What a robot that fails, refuses, or is none at all is told as: of which kind, in whose words, and how
// often it is asked again. The same for every back-end with a network.
#include <QSignalSpy>
#include <QTest>

#include "../net/scripted_server.h"
#include "../net/secure_server.h"
#include "net/faults.h"
#include "robot/aimdk/aimdk_robot.h"
#include "robot/axbot/axbot_robot.h"
#include "scripted_robot.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_robot_failures {

using namespace mapwright;
using namespace mapwright::robot;
using map::FailureKind;
using net::testing::ScriptedServer;
using net::testing::SecureServer;
using net::testing::SeenRequest;
using std::chrono::milliseconds;
using testing::ScriptedRobot;

namespace {

constexpr int kPatienceMs = 20'000;
const QByteArray kNames = R"({"data":{"map_lists":[{"map_id":"17","map_name":"Park"}]}})";

enum class Kind { Axbot, Aimdk };

std::unique_ptr<Robot> robotAt(Kind kind, const QUrl& url, const net::Trust& trust = {}) {
  if (kind == Kind::Axbot) {
    axbot::LinkOptions options;
    options.base = url.adjusted(QUrl::RemovePath);
    options.secret = "hush";
    options.trust = trust;
    options.socket.backoff_first = milliseconds(2);
    options.socket.backoff_limit = milliseconds(10);
    options.socket.connect_timeout = milliseconds(1'000);
    return std::make_unique<axbot::AxbotRobot>(QStringLiteral("axbot+test"), options);
  }
  aimdk::LinkOptions options;
  options.base = url.adjusted(QUrl::RemovePath);
  options.trust = trust;
  options.backoff_first = milliseconds(2);
  options.backoff_limit = milliseconds(10);
  options.timeout = milliseconds(1'000);
  return std::make_unique<aimdk::AimdkRobot>(QStringLiteral("aimdk+test"), options);
}

/// All states that a robot went through.
struct Watched {
  explicit Watched(Robot& robot) {
    QObject::connect(&robot, &Robot::connectionChanged, &robot,
                     [this, &robot] { states << robot.connection(); });
  }
  bool reached(ConnectionPhase phase, int attempt = 0) const {
    return std::any_of(states.begin(), states.end(), [&](const ConnectionState& state) {
      return state.phase == phase && state.attempt >= attempt;
    });
  }
  QList<ConnectionState> states;
};

}  // namespace

class RobotFailuresTest : public QObject {
  Q_OBJECT

  static void kinds() {
    QTest::addColumn<int>("kind");
    QTest::newRow("axbot") << int(Kind::Axbot);
    QTest::newRow("aimdk") << int(Kind::Aimdk);
  }

 private Q_SLOTS:
  void everyStateOfALostLinkSaysWhy_data() { kinds(); }
  void everyStateOfALostLinkSaysWhy() {
    QFETCH(int, kind);
    QTcpServer gone;
    QVERIFY(gone.listen(QHostAddress::LocalHost));
    const QUrl url(QStringLiteral("http://127.0.0.1:%1").arg(gone.serverPort()));
    gone.close();
    const auto robot = robotAt(Kind(kind), url);
    const Watched watched(*robot);
    robot->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(watched.reached(ConnectionPhase::Interrupted, 5), kPatienceMs);
    for (const ConnectionState& state : watched.states) {
      if (state.phase != ConnectionPhase::Interrupted) continue;
      QCOMPARE(state.reason.code, net::fault::ConnectionRefused);
      QCOMPARE(state.failure, FailureKind::Unreachable);
    }
  }

  void whatAnswersIsTold_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<FailureKind>("failure");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* name, const QByteArray& answer, FailureKind axbot, FailureKind aimdk,
                        const char* word) {
      QTest::addRow("axbot, %s", name) << int(Kind::Axbot) << answer << axbot << QString::fromLatin1(word);
      QTest::addRow("aimdk, %s", name) << int(Kind::Aimdk) << answer << aimdk << QString::fromLatin1(word);
    };
    const QByteArray page = "<!DOCTYPE html><html><body>It works</body></html>";
    row("a web page", ScriptedServer::reply(200, "Content-Type: text/html\r\n", page), FailureKind::NotARobot,
        FailureKind::NotARobot, "robot");
    row("404", ScriptedServer::reply(404, "Content-Type: text/html\r\n", page), FailureKind::NotARobot,
        FailureKind::NotARobot, "404");
    row("405", ScriptedServer::reply(405, {}, {}), FailureKind::NotARobot, FailureKind::NotARobot, "405");
    row("401", ScriptedServer::reply(401, {}, {}), FailureKind::Refused, FailureKind::Refused, "401");
    row("401, a password", ScriptedServer::reply(401, "WWW-Authenticate: Basic realm=\"robot\"\r\n", {}),
        FailureKind::Refused, FailureKind::Refused, "401");
    row("403", ScriptedServer::reply(403, {}, {}), FailureKind::Refused, FailureKind::Refused, "403");
    row("500", ScriptedServer::reply(500, {}, {}), FailureKind::Unreachable, FailureKind::RejectedByRobot,
        "500");
    row("503", ScriptedServer::reply(503, {}, {}), FailureKind::Unreachable, FailureKind::RejectedByRobot,
        "503");
    row("hang up", ScriptedServer::kHangUp, FailureKind::Unreachable, FailureKind::Unreachable, "closed");
    row("silence", {}, FailureKind::TimedOut, FailureKind::TimedOut, "no answer within 1 s");
  }
  void whatAnswersIsTold() {
    QFETCH(int, kind);
    QFETCH(QByteArray, answer);
    QFETCH(FailureKind, failure);
    QFETCH(QString, word);
    ScriptedServer server([answer](const SeenRequest&) { return answer; });
    const auto robot = robotAt(Kind(kind), server.url());
    const Watched watched(*robot);
    robot->connectToRobot();
    const auto expected =
        failure == FailureKind::Refused ? ConnectionPhase::Refused : ConnectionPhase::Interrupted;
    QTRY_VERIFY_WITH_TIMEOUT(watched.reached(expected, 1), kPatienceMs);
    QVERIFY(!watched.reached(ConnectionPhase::Online));
    for (const ConnectionState& state : watched.states) {
      if (state.phase != expected) continue;
      QCOMPARE(state.failure, failure);
      const QString said = sentences::wordsOf(state.reason);
      QVERIFY2(said.contains(word), qPrintable(said));
      QVERIFY2(!said.contains(QStringLiteral("nknown error")), qPrintable(said));
      QVERIFY(!said.contains(QStringLiteral("hush")));
    }
  }

  void aRefusedRobotIsNotAskedAgainByItself_data() { kinds(); }
  void aRefusedRobotIsNotAskedAgainByItself() {
    QFETCH(int, kind);
    ScriptedServer server([](const SeenRequest&) { return ScriptedServer::reply(401, {}, {}); });
    const auto robot = robotAt(Kind(kind), server.url());
    robot->connectToRobot();
    QTRY_COMPARE_WITH_TIMEOUT(robot->connection().phase, ConnectionPhase::Refused, kPatienceMs);
    QVERIFY(!robot->connection().retry_in_ms);
    QCOMPARE(server.seen.size(), 1);
  }

  void aFailedRequestSaysOfWhichKind_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<FailureKind>("failure");
    QTest::newRow("401") << ScriptedRobot::reply(401, "{}") << FailureKind::Refused;
    QTest::newRow("403") << ScriptedRobot::reply(403, "{}") << FailureKind::Refused;
    QTest::newRow("404") << ScriptedRobot::reply(404, "{}") << FailureKind::RejectedByRobot;
    QTest::newRow("500") << ScriptedRobot::reply(500, "{}") << FailureKind::RejectedByRobot;
    QTest::newRow("hang up") << QByteArray() << FailureKind::Unreachable;
    QTest::newRow("broken off") << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 99\r\n\r\n[")
                                << FailureKind::Unreachable;
    QTest::newRow("garbage") << ScriptedRobot::reply(200, "{{{", "Content-Type: application/json\r\n")
                             << FailureKind::MalformedAnswer;
    QTest::newRow("a web page") << ScriptedRobot::reply(200, "<html></html>", "Content-Type: text/html\r\n")
                                << FailureKind::NotARobot;
    QTest::newRow("elsewhere") << ScriptedRobot::reply(302, {}, "Location: http://127.0.0.1:1/\r\n")
                               << FailureKind::MalformedAnswer;
  }
  void aFailedRequestSaysOfWhichKind() {
    QFETCH(QByteArray, answer);
    QFETCH(FailureKind, failure);
    ScriptedRobot server;
    for (const char* path :
         {"/maps/", "/maps", "/mappings/", "/mappings", "/maps/1", "/ros/slam/submaps/u/0/1",
          "/rpc/aimdk.protocol.MappingService/GetStoredMapNames",
          "/rpc/aimdk.protocol.MappingService/Get2DWholeMap"}) {
      server.answers[path] = answer;
    }
    for (const Kind kind : {Kind::Axbot, Kind::Aimdk}) {
      const auto robot = robotAt(kind, server.url());
      std::optional<FailureKind> listed, fetched;
      robot->mapCatalogue()->list(
          [&](const auto& given) { listed = given ? FailureKind::None : given.error().kind; });
      robot->wholeMapSource()->fetch({map::MapKind::Stored, "1"}, [&](const auto& given) {
        fetched = given ? FailureKind::None : given.error().kind;
      });
      QTRY_VERIFY_WITH_TIMEOUT(listed && fetched, kPatienceMs);
      QCOMPARE(*listed, failure);
      QCOMPARE(*fetched, failure);
    }
    if (failure == FailureKind::MalformedAnswer || failure == FailureKind::NotARobot) return;
    const auto robot = robotAt(Kind::Axbot, server.url());
    std::optional<FailureKind> submap;
    robot->submapSource()->fetch({"u", {0, 1}, 1},
                                 [&](const map::SubmapAnswer& given) { submap = given.failure; });
    QTRY_VERIFY_WITH_TIMEOUT(submap.has_value(), kPatienceMs);
    QCOMPARE(*submap, failure);
  }

  void aRobotThatAnswersOnceAndFailsIsAskedLessAndLess() {
    // The first question is answered, what follows is not: again and again.
    ScriptedServer server([](const SeenRequest& request) {
      return request.path.endsWith("GetStoredMapNames") ? ScriptedServer::reply(200, {}, kNames)
                                                        : ScriptedServer::kHangUp;
    });
    aimdk::LinkOptions options;
    options.base = server.url().adjusted(QUrl::RemovePath);
    options.backoff_first = milliseconds(2);
    options.backoff_limit = milliseconds(3'600'000);
    aimdk::AimdkRobot robot(QStringLiteral("aimdk+test"), options);
    QList<int> waits;
    connect(&robot, &Robot::connectionChanged, this, [&] {
      if (const auto wait = robot.connection().retry_in_ms) waits << *wait;
    });
    robot.connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(waits.size() >= 6, kPatienceMs);
    for (int i = 1; i < 6; ++i) QVERIFY(waits[i] > waits[i - 1]);
    QVERIFY(waits[5] >= 64);
  }

  void anUntrustedCertificateIsForTheUserToDecide_data() { kinds(); }
  void anUntrustedCertificateIsForTheUserToDecide() {
    QFETCH(int, kind);
    SecureServer server(QStringLiteral("self_signed"));
    server.answer = kNames;
    const auto robot = robotAt(Kind(kind), server.url(QStringLiteral("https")));
    robot->connectToRobot();
    QTRY_COMPARE_WITH_TIMEOUT(robot->connection().phase, ConnectionPhase::Refused, kPatienceMs);
    ConnectionState state = robot->connection();
    QCOMPARE(state.failure, FailureKind::Certificate);
    QVERIFY(state.certificate);
    QVERIFY(state.certificate->trustable);
    QVERIFY(sentences::wordsOf(state.reason).contains(state.certificate->sha256));
    QCOMPARE(sentences::wordsOf(state.certificate->why), QStringLiteral("it is self-signed"));
    QVERIFY(state.certificate->pinned_sha256.isEmpty());
    QVERIFY(server.seen.isEmpty());

    robot->trustCertificate(state.certificate->sha256);
    QTRY_COMPARE_WITH_TIMEOUT(robot->connection().phase, ConnectionPhase::Online, kPatienceMs);
    QVERIFY(!robot->connection().certificate);
    QVERIFY(!server.seen.isEmpty());

    // A later session knows the pin; the robot has another certificate by then.
    net::Trust trust;
    trust.pinned_sha256 = net::fingerprintFrom(state.certificate->sha256);
    SecureServer changed(QStringLiteral("other_self_signed"));
    const auto later = robotAt(Kind(kind), changed.url(QStringLiteral("https")), trust);
    later->connectToRobot();
    QTRY_COMPARE_WITH_TIMEOUT(later->connection().phase, ConnectionPhase::Refused, kPatienceMs);
    QVERIFY(later->connection().certificate);
    QCOMPARE(later->connection().certificate->pinned_sha256, state.certificate->sha256);
    QVERIFY(later->connection().certificate->sha256 != state.certificate->sha256);
    QVERIFY(changed.seen.isEmpty());
  }
};

}  // namespace test_robot_failures

MAPWRIGHT_TEST(test_robot_failures, RobotFailuresTest, Core)
#include "test_robot_failures.moc"
