// --log and MAPWRIGHT_LOG: what they switch on, and what never stands in the log.
#include <sys/resource.h>

#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QTest>

#include "../robot/scripted_bridge.h"
#include "../robot/scripted_robot.h"
#include "app/log.h"
#include "app/log_file.h"
#include "program.h"
#include "test_program.h"

namespace test_log {

using namespace mapwright;
using namespace mapwright::app;
namespace {

using robot::testing::ScriptedBridge;
using robot::testing::ScriptedRobot;

using Outcome = tests::EndedBytes;

const QByteArray kSecret = "hush/hush=";

}  // namespace

class LogTest : public QObject {
  Q_OBJECT
 private:
  tests::Program program_;

  QString at(const char* name) const { return program_.path(name); }
  Outcome run(const QString& line, const QMap<QString, QString>& more = {}) const {
    return program_.runForBytes(line.split(QLatin1Char(' ')), {.environment = more});
  }
  QString secretFile() const {
    QFile file(at("secret"));
    if (file.open(QIODevice::WriteOnly)) file.write(kSecret);
    return file.fileName();
  }
  static QString axbot(const ScriptedRobot& robot) {
    return QStringLiteral("axbot+") + robot.url().toString();
  }
  static void serveMaps(ScriptedRobot& robot) {
    robot.serve("/device/info", R"({"model":"T1","caps":{"supportsEnableTopicList":true}})");
    robot.serve("/maps/", R"([{"id":1,"uid":"u","map_name":"Hall","map_version":1}])");
    robot.serve("/mappings/", "[]");
    robot.serve("/chassis/current-map", R"({"id":1})");
  }

 private Q_SLOTS:
  void rulesAreThoseOfQtWithShortFormsForOurs_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("rules");  // behind those that are always there; empty = refused
    const auto row = [](const char* typed, const char* rules) {
      QTest::newRow(typed) << QString::fromLatin1(typed) << QString::fromLatin1(rules);
    };
    row("all", "mapwright.*=true");
    row("net", "mapwright.net=true");
    row("mapwright.net", "mapwright.net=true");
    row("net, session;ros", "mapwright.net=true|mapwright.session=true|mapwright.ros=true");
    row("all,cache=false", "mapwright.*=true|mapwright.cache=false");
    row("net.info=true", "mapwright.net.info=true");
    row("mapwright.net.debug=false", "mapwright.net.debug=false");
    row("mapwright.*.debug=true", "mapwright.*.debug=true");
    row("qt.network.*=true", "qt.network.*=true");
    row("*=true;", "*=true");
    for (const char* wrong :
         {"nte", "net=maybe", "net=", "=true", "mapwright.nte=true", "a*b=true", "net true"})
      row(wrong, "");
  }
  void rulesAreThoseOfQtWithShortFormsForOurs() {
    QFETCH(QString, typed);
    QFETCH(QString, rules);
    const auto read = logRules(typed);
    QCOMPARE(read.has_value(), !rules.isEmpty());
    if (read) QCOMPARE(read->split(QLatin1Char('\n')).mid(3).join(QLatin1Char('|')), rules);
    if (!read) QVERIFY2(read.error().contains(typed), qPrintable(read.error()));
  }

  void wrongRulesAreOneLineAndExitCodeTwo() {
    const QString log = QStringLiteral("MAPWRIGHT_LOG");
    for (const Outcome& outcome :
         {run(QStringLiteral("maps list --robot demo: --log nonsense")),
          run(QStringLiteral("--log nonsense")), run(QStringLiteral("--log  maps list --robot demo:")),
          run(QStringLiteral("maps list --robot demo:"), {{log, QStringLiteral("nonsense")}})}) {
      QCOMPARE(outcome.code, 2);
      QCOMPARE(outcome.err.count('\n'), 1);
      QVERIFY(outcome.out.isEmpty());
    }
  }

  void theLogGoesToStandardErrorAndChangesNothingElse() {
    ScriptedRobot robot;
    serveMaps(robot);
    const QString list = QStringLiteral("maps list --robot ") + axbot(robot);
    const Outcome quiet = run(list);
    QCOMPARE(quiet.code, 0);
    QVERIFY2(quiet.err.isEmpty(), quiet.err.constData());
    const QString log = QStringLiteral("MAPWRIGHT_LOG"), net = QStringLiteral("net");
    for (const Outcome& told :
         {run(list + QStringLiteral(" --log net")), run(QStringLiteral("--log net ") + list),
          run(list, {{log, net}}),
          run(list + QStringLiteral(" --log net"), {{log, QStringLiteral("nonsense")}})}) {
      QCOMPARE(told.code, 0);
      QCOMPARE(told.out, quiet.out);
      QVERIFY2(told.err.contains(" mapwright.net: GET http://127.0.0.1:"), told.err.constData());
      QVERIFY2(told.err.contains("/maps/: 200, "), told.err.constData());
      QVERIFY2(!told.err.contains("mapwright.axbot"), told.err.constData());
    }
  }

  void aRobotDoesNotConnectIsToldByEachKindReason() {
    for (const char* scheme : {"axbot+http", "aimdk+http", "ros+ws", "kabam+ws"}) {
      const Outcome outcome = run(QStringLiteral("maps list --timeout 3 --log all --robot %1://127.0.0.1:1")
                                      .arg(QLatin1String(scheme)));
      QVERIFY(outcome.code != 0);
      QVERIFY2(outcome.err.contains("127.0.0.1:1: connecting") && outcome.err.contains("refused"),
               outcome.err.constData());
    }
  }

  void wordsOfOthersCommandNoTerminal() {
    ScriptedRobot robot;
    serveMaps(robot);
    robot.answers["/maps/"] = ScriptedRobot::reply(
        500, "{\"detail\":\"\\u001b[2Jgone\\nmapwright.net: forged\"}", "Content-Type: application/json\r\n");
    const Outcome outcome = run(QStringLiteral("maps list --log all --robot ") + axbot(robot));
    QVERIFY2(outcome.err.contains("gone"), outcome.err.constData());
    QVERIFY(!outcome.err.contains('\x1b') && !outcome.err.contains("\nmapwright.net: forged"));
  }

  void theFileHoldsAllOfItAndStandardErrorNothing() {
    ScriptedRobot robot;
    serveMaps(robot);
    const QString list = QStringLiteral("maps list --secret-file %1 --robot %2 --log-file log.txt")
                             .arg(secretFile(), axbot(robot));
    robot.answers["/mappings/"] = ScriptedRobot::reply(
        500, "{\"detail\":\"not with " + kSecret + " " + kSecret.toPercentEncoding() + " hush\\\\/hush=\"}",
        "Content-Type: application/json\r\n");
    const Outcome first = run(list);
    QVERIFY2(!first.err.contains("mapwright.net"), first.err.constData());
    const QByteArray log = program_.bytes("log.txt");
    QVERIFY2(log.startsWith("# mapwright log\n") && log.contains(" mapwright.net: GET http://127.0.0.1:") &&
                 log.contains(" mapwright.app: mapwright "),
             log.constData());
    QVERIFY2(log.contains("not with ***") && !log.contains(kSecret), log.constData());
    QCOMPARE(QFileInfo(at("log.txt")).permissions() & QFileDevice::Permissions(0x0077),
             QFileDevice::Permissions());
    run(list + QStringLiteral(" --log app"));
    const QByteArray longer = program_.bytes("log.txt");
    QVERIFY(longer.startsWith(log) && longer.size() > log.size());
    QVERIFY(!longer.mid(log.size()).contains("mapwright.net") && !longer.mid(1).contains("# mapwright log"));
  }

  void whereNoLogCanBeItIsSaidOnceAndTheCommandGoesOn_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("no folder") << QStringLiteral("nowhere/log.txt");
    QTest::newRow("a folder") << QStringLiteral(".");
    QTest::newRow("a device") << QStringLiteral("/dev/null");
    QTest::newRow("another file") << QStringLiteral("notes.txt");
    QTest::newRow("another file in its row") << QStringLiteral("log");
  }
  void whereNoLogCanBeItIsSaidOnceAndTheCommandGoesOn() {
    QFETCH(QString, file);
    program_.put("notes.txt", "Buy milk\n");
    program_.put("log.2", "Buy eggs\n");
    ScriptedRobot robot;
    serveMaps(robot);
    const Outcome outcome = run(QStringLiteral("maps list --robot %1 --log-file %2").arg(axbot(robot), file));
    QCOMPARE(outcome.code, 0);
    QVERIFY(outcome.out.contains("Hall"));
    QCOMPARE(outcome.err.count('\n'), 1);
    QVERIFY2(outcome.err.startsWith("There is no log in "), outcome.err.constData());
    QCOMPARE(program_.bytes("notes.txt"), QByteArray("Buy milk\n"));
    QCOMPARE(program_.bytes("log.2"), QByteArray("Buy eggs\n"));
  }

  void aFullDiskIsSaidOnceAndTheCommandGoesOn() {
    ScriptedRobot robot;
    serveMaps(robot);
    const QStringList words =
        QStringLiteral("maps list --robot %1 --log-file full.txt").arg(axbot(robot)).split(QLatin1Char(' '));
    const Outcome outcome = program_.runForBytes(words, {.in_child = [] {
                                                   const rlimit most{300, 300};
                                                   ::setrlimit(RLIMIT_FSIZE, &most);
                                                 }});
    QCOMPARE(outcome.code, 0);
    QVERIFY(outcome.out.contains("Hall"));
    QCOMPARE(outcome.err.count("The log in full.txt lacks lines: "), 1);
  }

  void theLogIsBounded() {
    LogFile log({200, 3});
    const std::string path = at("bounded").toStdString();
    QVERIFY(!log.open(path));
    for (int i = 0; i < 100; ++i) QVERIFY(!log.write("line " + std::to_string(i) + std::string(40, '.')));
    QByteArray kept;
    for (const char* name : {"bounded.2", "bounded.1", "bounded"}) {
      const QByteArray bytes = program_.bytes(name);
      QVERIFY2(bytes.startsWith("# mapwright log\n") && bytes.size() <= 200, name);
      kept += bytes;
    }
    QVERIFY(!QFile::exists(at("bounded.3")) && !QFile::exists(at("bounded.new")));
    QVERIFY(kept.contains("line 99.") && kept.contains("line 93.") && !kept.contains("line 92."));
    QVERIFY(kept.indexOf("line 93.") < kept.indexOf("line 99."));
  }

  void aLineThatWasCutDoesNotSpoilTheNext() {
    {
      QFile file(at("cut"));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write("# mapwright log\nhalf a li");
    }
    LogFile log;
    QVERIFY(!log.open(at("cut").toStdString()) && !log.write("whole"));
    QCOMPARE(program_.bytes("cut"), QByteArray("# mapwright log\nhalf a li\nwhole\n"));
  }

  void aLinkStaysOneWhenTheLogIsTurned() {
    LogFile log({60, 3});
    QVERIFY(QFile::link(at("target"), at("link")));
    { QVERIFY(QFile(at("target")).open(QIODevice::WriteOnly)); }
    QVERIFY(!log.open(at("link").toStdString()));
    for (int i = 0; i < 3; ++i) QVERIFY(!log.write(std::string(30, '.')));
    QVERIFY(QFileInfo(at("link")).isSymLink() && QFile::exists(at("target.1")) &&
            !QFile::exists(at("link.1")));
  }

  void twoDoNotWriteIntoOne() {
    LogFile one, other;
    const std::string path = at("shared").toStdString();
    QVERIFY(!one.open(path));
    const auto refused = other.open(path);
    QVERIFY(refused && refused->contains(QLatin1String("another mapwright")));
    QVERIFY(!other.write("nothing"));
    QVERIFY(!program_.bytes("shared").contains("nothing"));
  }

  void valuesInAnAddressAreNotInTheLog() {
    const Outcome outcome =
        run(QStringLiteral("maps list --robot rep130+ws://127.0.0.1:1?ns=/hush&get_map=/token --log all"));
    QCOMPARE(outcome.code, 3);
    QVERIFY2(outcome.err.contains("robot rep130+ws://127.0.0.1:1?ns=…&get_map=…, secret: none"),
             outcome.err.constData());
    QVERIFY2(!outcome.err.contains("mapwright.app: robot rep130+ws://127.0.0.1:1?ns=/hush"),
             outcome.err.constData());
  }

  void aSecretIsNeverInTheLog_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("in_environment");
    const auto row = [](const char* name, const char* line, bool in_environment) {
      QTest::newRow(name) << QString::fromLatin1(line) << in_environment;
    };
    row("a file", "maps list --robot ROBOT --secret-file FILE --log all", false);
    row("a file before the command", "--log all --robot ROBOT --secret-file FILE maps list", false);
    row("the environment", "maps list --robot ROBOT --log all", true);
    row("of another robot", "maps list --robot ROBOT --secret-file-for ROBOT FILE --log all", false);
    row("live",
        "topics echo /tracked_pose --robot ROBOT --secret-file FILE --count 1 --timeout 3 --log *=true",
        false);
    row("a picture", "snapshot --mode whole --robot ROBOT --secret-file FILE --timeout 6 --log all -o p.png",
        false);
    row("a recording", "record --duration 2 --robot ROBOT --secret-file FILE --force -o r.mcap --log *=true",
        false);
    row("ROS", "topics echo /a --robot BRIDGE --secret-file FILE --count 1 --timeout 4 --log *=true", false);
    row("ROS, the environment", "topics echo /a --robot BRIDGE --count 1 --timeout 3 --log all", true);
  }
  void aSecretIsNeverInTheLog() {
    QFETCH(QString, line);
    QFETCH(bool, in_environment);
    // Both repeat what they are told, and more.
    ScriptedRobot robot;
    serveMaps(robot);
    robot.serve("/maps/1", R"({"id":1,"map_name":"Hall","grid_resolution":0.05,"grid_origin_x":0,)"
                           R"("grid_origin_y":0,"image_url":"/maps/1.png?token=tok-en"})");
    robot.answers["/mappings/"] = ScriptedRobot::reply(
        500, "{\"detail\":\"not with " + kSecret + " " + kSecret.toPercentEncoding() + " hush\\\\/hush=\"}",
        "Content-Type: application/json\r\n");
    robot.answers["/chassis/current-map"] =
        "HTTP/1.1 302 Found\r\nConnection: close\r\nContent-Length: 0\r\n"
        "Location: /chassis/there?secret=tok-en\r\n\r\n";
    robot.greeting = "{\"error\":\"no " + kSecret + "\"}";
    ScriptedBridge bridge;
    bridge.advertise(QStringLiteral("/a"), QStringLiteral("std_msgs/String"));
    const QString robot_address = axbot(robot);
    line.replace(QStringLiteral("ROBOT"), robot_address)
        .replace(QStringLiteral("BRIDGE"), QStringLiteral("ros+") + bridge.url().toString())
        .replace(QStringLiteral("FILE"), secretFile());
    QTimer repeat;
    connect(&repeat, &QTimer::timeout, &repeat, [&] {
      for (const QJsonObject& asked : std::as_const(bridge.asked)) {
        if (asked[QLatin1String("op")] != QLatin1String("auth")) continue;
        const QString said =
            QString::fromUtf8(kSecret) + QLatin1Char(' ') + asked[QLatin1String("mac")].toString();
        const QJsonObject status{{QStringLiteral("op"), QStringLiteral("status")},
                                 {QStringLiteral("level"), QStringLiteral("error")},
                                 {QStringLiteral("msg"), said}};
        for (QWebSocket* peer : std::as_const(bridge.peers))
          peer->sendTextMessage(QString::fromUtf8(QJsonDocument(status).toJson(QJsonDocument::Compact)));
      }
    });
    repeat.start(300);
    QMap<QString, QString> env;
    if (in_environment) env.insert(QStringLiteral("MAPWRIGHT_SECRET"), QString::fromUtf8(kSecret));
    const Outcome outcome = run(line, env);
    QByteArray log;  // what the commands say themselves is another matter
    for (const QByteArray& one : outcome.err.split('\n')) {
      if (one.contains(" mapwright.") || one.contains(" qt.")) log += one + '\n';
    }
    QVERIFY2(log.contains("mapwright.net: "), outcome.err.constData());
    for (const QByteArray& form :
         {kSecret, kSecret.toPercentEncoding(), QByteArray("hush\\/hush="), QByteArray("tok-en")})
      QVERIFY2(!log.contains(form), log.constData());
    for (const QJsonObject& asked : std::as_const(bridge.asked)) {
      const QByteArray mac = asked[QLatin1String("mac")].toString().toLatin1();
      QVERIFY2(mac.isEmpty() || !log.contains(mac), log.constData());
    }
    const bool ros = line.contains(QLatin1String("ros+"));
    const bool told =
        ros ? log.contains("status error: ***") : log.contains("not with ***") || log.contains("no ***");
    QVERIFY2(told, log.constData());
  }
};

}  // namespace test_log

MAPWRIGHT_TEST(test_log, LogTest, Widgets)
#include "test_log.moc"
