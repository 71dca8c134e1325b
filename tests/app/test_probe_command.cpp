// `mapwright probe` and what is behind it: every kind of robot is recognised at its port, what is none is
// not, no secret is sent, and nobody is waited for longer than asked.
#include <QEventLoop>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTcpServer>
#include <QtTest>

#include "../net/scripted_server.h"
#include "../net/secure_server.h"
#include "app/robot_factory.h"
#include "jobs/robot_search.h"
#include "program.h"
#include "sentences/fault_sentence.h"
#include "sentences/found_sentence.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_probe_command {

using namespace mapwright;
using net::testing::ScriptedServer;
using net::testing::SecureServer;
using net::testing::SeenRequest;
using robot::FoundRobot;

namespace {

using Outcome = tests::Ended;

/// What was found, and the reasons of those that were not, by title and scheme ("Autoxing http").
struct Result {
  std::vector<FoundRobot> found;
  QMap<QString, QString> reasons;
};

/// These servers are silent where they are greeted by TLS: nobody waits for that.
constexpr auto kShort = std::chrono::milliseconds(1500);

Result search(int port, std::chrono::milliseconds within = std::chrono::seconds(20)) {
  jobs::RobotSearch looking(app::probesOf({QStringLiteral("127.0.0.1"), port}), within);
  QEventLoop loop;
  QObject::connect(&looking, &jobs::RobotSearch::ended, &loop, &QEventLoop::quit);
  if (!looking.over()) loop.exec();
  Result result{looking.found(), {}};
  for (const auto& row : looking.rows()) {
    if (row.answer->found.empty())
      result.reasons[row.title + QLatin1Char(' ') + row.server.scheme()] =
          sentences::wordsOf(row.answer->reason);
  }
  return result;
}

QStringList addressesIn(const Result& result) {
  QStringList all;
  for (const FoundRobot& robot : result.found) all << robot.address;
  return all;
}

QString at(const char* prefix, int port) {
  return QLatin1String(prefix) + QStringLiteral("127.0.0.1:") + QString::number(port);
}

}  // namespace

class TestProbeCommand : public QObject {
  Q_OBJECT
  tests::Program program_;

  Outcome run(const QStringList& arguments) const {
    return program_.run(arguments,
                        {.environment = {{QStringLiteral("MAPWRIGHT_SECRET"), QStringLiteral("hunter2")}}});
  }

 private Q_SLOTS:
  void recognisesEachKindAtItsPort() {
    simulator::Options options;
    options.ros.dispatcher.there = true;
    options.ros.dispatcher.edge_m = 10;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const Result axbot = search(robot.port());
    QCOMPARE(addressesIn(axbot), QStringList{at("axbot+http://", robot.port())});
    QVERIFY(!axbot.found[0].identity.model.isEmpty() && !axbot.found[0].wants_secret);
    QCOMPARE(axbot.found[0].identity.version, QStringLiteral("2.11.0"));
    QVERIFY2(axbot.reasons.contains(QStringLiteral("Agibot http")), "it is one kind only");
    QCOMPARE(addressesIn(search(robot.aimdkPort())), QStringList{at("aimdk+http://", robot.aimdkPort())});
    const Result ros = search(robot.rosPort());
    QCOMPARE(addressesIn(ros),
             (QStringList{at("kabam+ws://", robot.rosPort()), at("rep130+ws://", robot.rosPort()),
                          at("ros+ws://", robot.rosPort())}));
    QVERIFY(ros.found[2].topics.value_or(0) > 3 && ros.found[2].services.value_or(0) > 3);
    QCOMPARE(ros.found[2].identity.version, QStringLiteral("ROS 1"));
    for (const Result& result : {axbot, ros}) {
      for (const FoundRobot& found : result.found) QVERIFY(app::knownAddresses().parse(found.address));
    }
  }

  void aPlainRosRobotIsNothingElse() {
    simulator::Options options;
    options.ros.kabam = false;
    options.ros.dialect = simulator::RosDialect::Ros2;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const Result ros = search(robot.rosPort());
    QCOMPARE(addressesIn(ros), QStringList{at("ros+ws://", robot.rosPort())});
    QVERIFY2(sentences::foundCalled(ros.found[0]).startsWith(QLatin1String("ROS 2, ")),
             qPrintable(sentences::foundCalled(ros.found[0])));
  }

  void aMapManagerIsFoundWithoutRosapi() {
    simulator::Options options;
    options.ros.rosapi = false;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const Result ros = search(robot.rosPort());
    QCOMPARE(addressesIn(ros),
             (QStringList{at("kabam+ws://", robot.rosPort()), at("ros+ws://", robot.rosPort())}));
    QVERIFY(!ros.found[0].topics && !ros.found[0].services);
  }

  void saysWhichRobotsAskForASecret() {
    simulator::Options options;
    options.secret = "hunter2";
    options.ros.needs_auth = true;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    for (const auto& [port, address] : {std::pair{robot.port(), at("axbot+http://", robot.port())},
                                        std::pair{robot.rosPort(), at("ros+ws://", robot.rosPort())}}) {
      const Result result = search(port);
      QCOMPARE(addressesIn(result), QStringList{address});
      QVERIFY(result.found[0].wants_secret);
      QVERIFY(sentences::foundCalled(result.found[0]).contains(QLatin1String("secret")));
    }
  }

  void aWebServerIsNoRobot_data() {
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("a page") << 200 << QByteArray("<html>Printer</html>");
    QTest::newRow("JSON of somebody else") << 200 << QByteArray(R"({"ok":true,"name":"router"})");
    QTest::newRow("nothing there") << 404 << QByteArray("Not Found");
    QTest::newRow("a login") << 401 << QByteArray("<html>Log in</html>");
    QTest::newRow("broken") << 500 << QByteArray("Oops");
  }
  void aWebServerIsNoRobot() {
    QFETCH(int, status);
    QFETCH(QByteArray, body);
    ScriptedServer server([&](const SeenRequest&) { return ScriptedServer::reply(status, {}, body); });
    const Result result = search(server.port(), kShort);
    QVERIFY(result.found.empty());
    QCOMPARE(result.reasons.size(), 6);
    QVERIFY2(result.reasons[QStringLiteral("Autoxing http")].contains(QLatin1String("Autoxing")),
             qPrintable(result.reasons[QStringLiteral("Autoxing http")]));
    for (const SeenRequest& seen : server.seen) {
      // Only what is known to change nothing.
      const bool reads = seen.method == "GET" || seen.path.endsWith("/GetStoredMapNames");
      QVERIFY2(reads, seen.method + ' ' + seen.path);
    }
  }

  void nobodyIsWaitedForForLong() {
    QTcpServer swallows;  // takes connections and never says a word
    QVERIFY(swallows.listen(QHostAddress::LocalHost));
    const Result result = search(swallows.serverPort(), std::chrono::milliseconds(300));
    QVERIFY(result.found.empty());
    QCOMPARE(result.reasons.size(), 6);
    for (const QString& reason : result.reasons)
      QVERIFY2(reason.contains(QLatin1String("answer")), qPrintable(reason));
  }

  void anUntrustedCertificateIsAReason() {
    SecureServer server(QStringLiteral("self_signed"));
    const Result result = search(server.port(), kShort);
    QVERIFY(result.found.empty());
    QVERIFY2(result.reasons[QStringLiteral("Autoxing https")].contains(QLatin1String("certificate")),
             qPrintable(result.reasons[QStringLiteral("Autoxing https")]));
    QVERIFY(server.seen.isEmpty());
  }

  void printsWhatItFoundAndSendsNoSecret() {
    QList<QByteArray> secrets;
    ScriptedServer server([&](const SeenRequest& seen) {
      if (seen.headers.contains("secret")) secrets << seen.headers["secret"];
      return seen.path == "/device/info"
                 ? ScriptedServer::reply(
                       200, {}, QByteArray("{\"axbot_version\":\"2.14\",\"nickname\":\"dock-3\\u001b[31m\"}"))
                 : ScriptedServer::reply(404, {}, "{}");
    });
    const QString host = QStringLiteral("127.0.0.1:%1").arg(server.port());
    const Outcome table =
        run({QStringLiteral("probe"), QStringLiteral("--timeout"), QStringLiteral("2"), host});
    QCOMPARE(table.code, 0);
    QVERIFY2(table.out.contains(QStringLiteral("axbot+http://") + host), qPrintable(table.out));
    QVERIFY(table.out.contains(QLatin1String("dock-3")) && !table.out.contains(QLatin1Char('\x1b')));
    QVERIFY2(table.err.isEmpty(), qPrintable(table.err));
    const Outcome json = run({QStringLiteral("probe"), QStringLiteral("--timeout"), QStringLiteral("2"), host,
                              QStringLiteral("--json")});
    const QJsonObject told = QJsonDocument::fromJson(json.out.toUtf8()).object();
    QCOMPARE(told[QStringLiteral("host")].toString(), host);
    const QJsonArray found = told[QStringLiteral("found")].toArray();
    QCOMPARE(found.size(), 1);
    QCOMPARE(found[0][QStringLiteral("kind")].toString(), QStringLiteral("axbot"));
    QCOMPARE(found[0][QStringLiteral("version")].toString(), QStringLiteral("2.14"));
    QVERIFY(found[0][QStringLiteral("topics")].isNull());
    QCOMPARE(told[QStringLiteral("not_found")].toArray().size(), 5);
    QVERIFY(secrets.isEmpty());
  }

  void saysWhyThereIsNone() {
    ScriptedServer server([](const SeenRequest&) { return ScriptedServer::reply(404, {}, "Not Found"); });
    const QString host = QStringLiteral("127.0.0.1:%1").arg(server.port());
    const Outcome brief =
        run({QStringLiteral("probe"), QStringLiteral("--timeout"), QStringLiteral("2"), host});
    QCOMPARE(brief.code, 3);
    QCOMPARE(brief.err.count(QLatin1Char('\n')), 1);
    QVERIFY(brief.out.isEmpty());
    const Outcome full = run({QStringLiteral("probe"), QStringLiteral("--timeout"), QStringLiteral("2"), host,
                              QStringLiteral("--details")});
    QCOMPARE(full.code, 3);
    QVERIFY2(full.err.count(QLatin1Char('\n')) == 7, qPrintable(full.err));
    const Outcome wrong = run({QStringLiteral("probe"), QStringLiteral("axbot+http://192.0.2.7")});
    QCOMPARE(wrong.code, 2);
    QVERIFY2(wrong.err.contains(QLatin1String("is not a host")), qPrintable(wrong.err));
  }
};

}  // namespace test_probe_command

MAPWRIGHT_TEST(test_probe_command, TestProbeCommand, Core)
#include "test_probe_command.moc"
