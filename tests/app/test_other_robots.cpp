// The program against robots that refuse, fail, are none at all, or are somebody else's: what it sends to
// whom, and the exit code and sentence that a script sees.
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QTest>

#include "../net/scripted_server.h"
#include "../net/secure_server.h"
#include "../robot/scripted_robot.h"
#include "net/trust.h"
#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_other_robots {

using namespace mapwright;
using net::testing::ScriptedServer;
using net::testing::SecureServer;
using net::testing::SeenRequest;
using robot::testing::ScriptedRobot;

namespace {

using Outcome = tests::Ended;

QString axbot(const QUrl& url) { return QStringLiteral("axbot+%1").arg(url.toString(QUrl::RemovePath)); }
QString aimdk(const QUrl& url) { return QStringLiteral("aimdk+%1").arg(url.toString(QUrl::RemovePath)); }

}  // namespace

class OtherRobotsTest : public QObject {
  Q_OBJECT
 private:
  tests::Program program_;

  QString at(const QString& name) const { return program_.path(name); }
  QString file(const QString& name, const QByteArray& content) const {
    QFile out(at(name));
    if (out.open(QIODevice::WriteOnly)) out.write(content);
    return out.fileName();
  }
  Outcome run(const QStringList& arguments, const QMap<QString, QString>& more = {}) const {
    return program_.run(arguments, {.environment = more});
  }
  Outcome run(const QString& line) const { return run(line.split(QLatin1Char(' '))); }

  static QByteArray picture() {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    QImage image(8, 8, QImage::Format_Grayscale8);
    image.fill(254);
    image.save(&buffer, "png");
    return png;
  }
  /// A robot with the map 1.
  static void serveMap(ScriptedRobot& robot) {
    robot.serve("/device/info", R"({"caps":{"supportsEnableTopicList":true}})");
    robot.serve("/maps/", R"([{"id":1,"uid":"u","map_name":"Hall","map_version":1}])");
    robot.serve("/mappings/", "[]");
    robot.serve("/chassis/current-map", R"({"id":1})");
    robot.serve("/maps/1",
                R"({"id":1,"map_name":"Hall","grid_resolution":0.05,"grid_origin_x":0,"grid_origin_y":0,)"
                R"("image_url":"/maps/1.png"})");
    robot.serve("/maps/1.png", picture());
    robot.greeting =
        R"({"topic":"/map_v2","resolution":0.05,"size":[8,8],"origin":[0,0],"data_url":"/maps/1.png"})";
  }
  static QSet<QByteArray> secretsSeenBy(const ScriptedRobot& robot) {
    QSet<QByteArray> secrets;
    for (const auto& asked : robot.asked) secrets.insert(asked.headers.value("secret"));
    return secrets;
  }

 private Q_SLOTS:
  void aSecretReachesItsOwnRobotOnly_data() {
    QTest::addColumn<QStringList>("line");
    QTest::addColumn<QString>("environment_robot");
    QTest::addColumn<bool>("in_environment");
    QTest::addColumn<QStringList>("own");    // what the robot of --robot is told
    QTest::addColumn<QStringList>("other");  // what the other one is told
    const auto row = [](const char* name, const char* line, const char* robot, bool in_environment,
                        const QStringList& own, const QStringList& other) {
      QTest::newRow(name) << QString::fromLatin1(line).split(QLatin1Char(' ')) << QString::fromLatin1(robot)
                          << in_environment << own << other;
    };
    const QString a = QStringLiteral("secret-a"), b = QStringLiteral("secret-b"), none;
    row("a file", "maps diff 1 OTHER --robot OWN --secret-file FILE_A", "", false, {a}, {none});
    row("the environment", "maps diff 1 OTHER --robot OWN", "", true, {a}, {none});
    row("both from the environment", "maps diff 1 OTHER", "OWN", true, {a}, {none});
    row("two secrets", "maps diff 1 OTHER --robot OWN --secret-file FILE_A --secret-file-for OTHER FILE_B",
        "", false, {a}, {b});
    row("only the other's", "maps diff 1 OTHER --robot OWN --secret-file-for OTHER FILE_B", "", false, {none},
        {b});
    row("the environment and the other's", "maps diff 1 OTHER --robot OWN --secret-file-for OTHER FILE_B", "",
        true, {a}, {b});
    row("own robot as an operand", "maps diff OWN OTHER --robot OWN --secret-file FILE_A", "", false, {a},
        {none});
    row("before the subcommand", "--robot OWN --secret-file FILE_A maps diff 1 OTHER", "", false, {a},
        {none});
    row("another robot after the subcommand", "--robot OWN --secret-file FILE_A maps list --robot OTHER", "",
        false, {}, {none});
    row("another robot than the environment's", "maps list --robot OTHER", "OWN", true, {}, {none});
  }
  void aSecretReachesItsOwnRobotOnly() {
    QFETCH(QStringList, line);
    QFETCH(QString, environment_robot);
    QFETCH(bool, in_environment);
    QFETCH(QStringList, own);
    QFETCH(QStringList, other);
    ScriptedRobot own_robot, other_robot;
    serveMap(own_robot);
    serveMap(other_robot);
    const QMap<QString, QString> words{
        {QStringLiteral("OWN"), axbot(own_robot.url())},
        {QStringLiteral("OTHER"), axbot(other_robot.url())},
        {QStringLiteral("FILE_A"), file(QStringLiteral("a.secret"), "secret-a\n")},
        {QStringLiteral("FILE_B"), file(QStringLiteral("b.secret"), "secret-b\n")}};
    for (QString& word : line) word = words.value(word, word);
    QMap<QString, QString> env;
    if (in_environment) env.insert(QStringLiteral("MAPWRIGHT_SECRET"), QStringLiteral("secret-a"));
    if (!environment_robot.isEmpty())
      env.insert(QStringLiteral("MAPWRIGHT_ROBOT"), words.value(environment_robot));
    const Outcome outcome = run(line + QStringList{QStringLiteral("--timeout"), QStringLiteral("20")}, env);
    QVERIFY2(outcome.code == 0, qPrintable(outcome.err));
    const auto bytes = [](const QStringList& texts) {
      QSet<QByteArray> set;
      for (const QString& text : texts) set.insert(text.toLatin1());
      return set;
    };
    QCOMPARE(secretsSeenBy(own_robot), bytes(own));
    QCOMPARE(secretsSeenBy(other_robot), bytes(other));
  }

  void wrongAccessIsOneLineAndExitCodeTwo_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"maps diff a.yaml b.yaml --secret-file /no/such/file",
          "maps list --robot demo: --secret-file-for demo: f",
          "maps list --robot demo: --secret-file-for http://127.0.0.1:1 /no/such/file",
          "maps list --robot demo: --ca-file /no/such/file",
          "maps list --robot demo: --ca-file /etc/hostname",
          "snapshot --robot demo: -o p.png --ca-file /etc/hostname", "--ca-file /etc/hostname --robot demo:",
          "maps list --robot demo: --secret-file-for http://127.0.0.1:1"}) {
      QTest::newRow(line) << QString::fromLatin1(line);
    }
  }
  void wrongAccessIsOneLineAndExitCodeTwo() {
    QFETCH(QString, line);
    const Outcome outcome = run(line);
    QVERIFY2(outcome.code == 2, qPrintable(outcome.err));
    QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
  }

  void aPasswordInAnAddressIsNotRepeated_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"maps diff http://u:hush@127.0.0.1:1/ 1", "maps diff u:hush@127.0.0.1:1 1",
          "maps diff 1 axbot+http://u:hush@127.0.0.1:1 --robot demo:", "maps list --robot u:hush@127.0.0.1:1",
          "maps export --robot ros+ws://u:hush@127.0.0.1:1 -o m.png",
          "maps list --robot demo: --secret-file-for http://u:hush@127.0.0.1:1 /no/such/file",
          "snapshot --robot http://u:hush@127.0.0.1:1 -o p.png"}) {
      QTest::newRow(line) << QString::fromLatin1(line);
    }
  }
  void aPasswordInAnAddressIsNotRepeated() {
    QFETCH(QString, line);
    const Outcome outcome = run(line);
    QVERIFY2(outcome.code == 2, qPrintable(outcome.err));
    QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
    QVERIFY2(!outcome.err.contains(QStringLiteral("hush")), qPrintable(outcome.err));
    QVERIFY2(outcome.err.contains(QStringLiteral("127.0.0.1:1")), qPrintable(outcome.err));
    QVERIFY2(outcome.err.contains(QStringLiteral("MAPWRIGHT_SECRET")), qPrintable(outcome.err));
  }

  void aSecretFileWithoutItsRobotIsRefused() {
    const QString secret = file(QStringLiteral("s"), "hush");
    const Outcome outcome = run(QStringLiteral("maps diff axbot+http://127.0.0.1:1 axbot+http://127.0.0.1:2 "
                                               "--secret-file %1")
                                    .arg(secret));
    QCOMPARE(outcome.code, 2);
    QVERIFY(outcome.err.contains(QStringLiteral("--secret-file-for")));
    QVERIFY(!outcome.err.contains(QStringLiteral("hush")));
  }

  void theExitCodeTellsWhoseFaultItWas_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("axbot_code");
    QTest::addColumn<int>("aimdk_code");
    QTest::addColumn<QString>("word");
    const QByteArray page = "<!DOCTYPE html><html><body>It works</body></html>";
    const auto row = [](const char* name, const QByteArray& answer, int axbot_code, int aimdk_code,
                        const char* word) {
      QTest::newRow(name) << answer << axbot_code << aimdk_code << QString::fromLatin1(word);
    };
    row("a web page", ScriptedServer::reply(200, "Content-Type: text/html\r\n", page), 3, 3, "robot");
    row("404", ScriptedServer::reply(404, "Content-Type: text/html\r\n", page), 3, 3, "404");
    row("401", ScriptedServer::reply(401, {}, {}), 3, 3, "401");
    row("403", ScriptedServer::reply(403, {}, {}), 3, 3, "403");
    row("500", ScriptedServer::reply(500, {}, {}), 3, 4, "500");
    row("hang up", ScriptedServer::kHangUp, 3, 3, "closed");
  }
  void theExitCodeTellsWhoseFaultItWas() {
    QFETCH(QByteArray, answer);
    QFETCH(int, axbot_code);
    QFETCH(int, aimdk_code);
    QFETCH(QString, word);
    ScriptedServer server([answer](const SeenRequest&) { return answer; });
    for (const QString& command : {QStringLiteral("maps list"), QStringLiteral("snapshot -o p.png")}) {
      for (const auto& [address, code] :
           {std::pair(axbot(server.url()), axbot_code), std::pair(aimdk(server.url()), aimdk_code)}) {
        const Outcome outcome = run(command + QStringLiteral(" --timeout 20 --robot ") + address);
        QVERIFY2(outcome.code == code, qPrintable(command + address + outcome.err));
        QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
        QVERIFY2(outcome.err.contains(word), qPrintable(outcome.err));
        QVERIFY2(!outcome.err.contains(QStringLiteral("nknown error")), qPrintable(outcome.err));
      }
    }
  }

  void whetherItCanBeEditedIsSaidNotToBeKnownWhereItIsNotTold() {
    ScriptedRobot robot;
    const QByteArray service = "/rpc/aimdk.protocol.MappingService/";
    robot.serve(service + "GetStoredMapNames",
                R"({"data":{"map_lists":[{"map_id":"17","map_name":"Park"}]}})");
    robot.serve(service + "GetCurrentWorkingMap", R"({"data":{"map_id":"17"}})");
    robot.held << service + "GetRealtimeMapData";
    const QString asked = QStringLiteral(" --timeout 5 --robot ") + aimdk(robot.url());
    for (const char* command : {"maps rename 17 Hall", "waypoints create New --at 1,2"}) {
      const Outcome untold = run(QString::fromLatin1(command) + asked);
      QVERIFY2(untold.code == 3 && untold.err.contains(QStringLiteral("whether it can be edited")) &&
                   untold.err.contains(QStringLiteral("--timeout")),
               qPrintable(untold.err));
      QVERIFY(!untold.err.contains(QStringLiteral("Read only")) && untold.err.count(QLatin1Char('\n')) == 1);
    }
    // Who only reads need not know.
    const Outcome listed = run(QStringLiteral("maps list") + asked);
    QVERIFY2(listed.code == 0 && listed.err.isEmpty(), qPrintable(listed.err));
  }

  void nobodyAtAnAddressIsSaidToBeSoWhateverTheRobot_data() {
    QTest::addColumn<QString>("scheme");
    QTest::newRow("axbot") << QStringLiteral("axbot+http");
    QTest::newRow("aimdk") << QStringLiteral("aimdk+http");
  }
  void nobodyAtAnAddressIsSaidToBeSoWhateverTheRobot() {
    QFETCH(QString, scheme);
    for (const QString& command : {QStringLiteral("maps list"), QStringLiteral("snapshot -o p.png")}) {
      const Outcome outcome =
          run(command + QStringLiteral(" --robot ") + scheme + QStringLiteral("://127.0.0.1:1"));
      QCOMPARE(outcome.code, 3);
      QVERIFY2(outcome.err.contains(QStringLiteral("connection refused by 127.0.0.1:1")),
               qPrintable(outcome.err));
      QVERIFY2(!outcome.err.contains(QStringLiteral("within")), qPrintable(outcome.err));
    }
  }

  void aRequestThatIsRefusedIsExitCodeThree_data() {
    QTest::addColumn<int>("status");
    QTest::newRow("401") << 401;
    QTest::newRow("403") << 403;
  }
  void aRequestThatIsRefusedIsExitCodeThree() {
    QFETCH(int, status);
    ScriptedRobot robot;  // its WebSocket is open to everybody
    serveMap(robot);
    const QByteArray no = ScriptedRobot::reply(status, R"({"detail":"who are you"})");
    for (const char* path : {"/maps/", "/mappings/", "/maps/1", "/maps/1.png"}) robot.answers[path] = no;
    for (const char* command :
         {"maps list", "maps show 1", "maps export 1 --force -o e.png",
          "snapshot --mode whole --map 1 -o p.png", "snapshot --raw --mode whole --map 1 -o p.png"}) {
      const Outcome outcome =
          run(QLatin1String(command) + QStringLiteral(" --timeout 20 --robot ") + axbot(robot.url()));
      QVERIFY2(outcome.code == 3, qPrintable(QLatin1String(command) + outcome.err));
      QVERIFY2(outcome.err.contains(QString::number(status)), qPrintable(outcome.err));
    }
    // Its submaps.
    robot.greeting = R"({"topic":"/submap_list","slam_state":"positioning","uuid":"u","submap":[
        {"trajectory_id":0,"submap_index":0,"submap_version":1,"pose":{"x":0,"y":0,"z":0,"qx":0,"qy":0,"qz":0,"qw":1}},
        {"trajectory_id":0,"submap_index":1,"submap_version":1,"pose":{"x":1,"y":0,"z":0,"qx":0,"qy":0,"qz":0,"qw":1}}]})";
    robot.answers["/ros/slam/submaps/u/0/0"] = robot.answers["/ros/slam/submaps/u/0/1"] = no;
    for (const char* command : {"maps export submaps --force -o e.png", "snapshot --mode submaps -o p.png"}) {
      const Outcome outcome =
          run(QLatin1String(command) + QStringLiteral(" --timeout 8 --robot ") + axbot(robot.url()));
      QVERIFY2(outcome.code == 3, qPrintable(QLatin1String(command) + outcome.err));
      QVERIFY2(outcome.err.contains(QString::number(status)), qPrintable(outcome.err));
    }
    // With the list, but without the map.
    serveMap(robot);
    robot.answers["/maps/1"] = no;
    QCOMPARE(run(QStringLiteral("maps show 1 --timeout 20 --robot ") + axbot(robot.url())).code, 3);
    serveMap(robot);
    robot.answers["/maps/1"] = ScriptedRobot::reply(500, "{}");
    QCOMPARE(run(QStringLiteral("maps show 1 --timeout 20 --robot ") + axbot(robot.url())).code, 4);
  }

  void aMapThatDoesNotComeInTimeIsNoPicture_data() {
    QTest::addColumn<QString>("command");
    for (const char* command : {"snapshot --raw --mode whole --map 1", "snapshot --mode whole --map 1",
                                "snapshot --raw --mode whole", "snapshot --mode whole --map 1 --settle 0.5",
                                "snapshot --raw --mode whole --map 1 --settle 0.5"}) {
      QTest::newRow(command) << QString::fromLatin1(command);
    }
  }
  void aMapThatDoesNotComeInTimeIsNoPicture() {
    QFETCH(QString, command);
    simulator::Options options;
    options.paused = true;
    options.faults.requests.push_back({simulator::FaultKind::Delay, simulator::kMaps, 1, 600'000});
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const QString picture = at(QStringLiteral("late.png"));
    const Outcome outcome =
        run(command + QStringLiteral(" --timeout 2 -o %1 --robot axbot+http://127.0.0.1:%2")
                          .arg(picture)
                          .arg(robot.port()));
    QVERIFY2(outcome.code == 3, qPrintable(outcome.err));
    QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
    QVERIFY2(outcome.err.contains(QStringLiteral("had not arrived")), qPrintable(outcome.err));
    QVERIFY(!outcome.out.contains(QStringLiteral("0 x 0")));
    QVERIFY(!QFile::exists(picture));
  }

  void aCertificateIsNamedAndAnAuthorityIsAWayOn() {
    SecureServer server(QStringLiteral("signed"));
    server.answer = R"({"data":{"map_lists":[{"map_id":"17","map_name":"Park"}]}})";
    const QString fingerprint =
        mapwright::net::fingerprintText(mapwright::net::testing::sha256(QStringLiteral("signed")));
    for (const QString& address :
         {axbot(server.url(QStringLiteral("https"))), aimdk(server.url(QStringLiteral("https")))}) {
      const Outcome refused = run(QStringLiteral("maps list --timeout 20 --robot ") + address);
      QCOMPARE(refused.code, 3);
      QVERIFY2(refused.err.contains(fingerprint), qPrintable(refused.err));
      QVERIFY2(refused.err.contains(QStringLiteral("Fleet authority")), qPrintable(refused.err));
      QVERIFY2(refused.err.contains(QStringLiteral("--ca-file")), qPrintable(refused.err));
    }
    QVERIFY(server.seen.isEmpty());
    const Outcome listed = run(QStringLiteral("maps list --timeout 20 --ca-file %1 --robot %2")
                                   .arg(QStringLiteral(MAPWRIGHT_TEST_DATA "/tls/authority.pem"),
                                        aimdk(server.url(QStringLiteral("https")))));
    QVERIFY2(listed.out.contains(QStringLiteral("Park")), qPrintable(listed.err));
  }
};

}  // namespace test_other_robots

MAPWRIGHT_TEST(test_other_robots, OtherRobotsTest, Widgets)
#include "test_other_robots.moc"
