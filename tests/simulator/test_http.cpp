// What the simulated robot answers over HTTP: status codes, cache headers, conditions, limits, secrets, the
// log.
#include <thread>

#include <QTcpSocket>

#include "running.h"
#include "test_program.h"

namespace test_http {

using namespace mapwright::simulator;

namespace {

std::string submapPath(const Running& robot, const std::string& rest) {
  return "/ros/slam/submaps/" + robot.uuid() + "/" + rest;
}

ros_messages::slam::SubmapQueryV2Response parsed(const std::string& body) {
  ros_messages::slam::SubmapQueryV2Response response;
  if (!response.ParseFromString(body)) response.mutable_status()->set_code(ros_messages::slam::DATA_LOSS);
  return response;
}

}  // namespace

class TestHttp : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aVersionedAnswerIsImmutable() {
    Running robot;
    const raw::HttpReply reply = robot.get(submapPath(robot, "0/0?ver=24"));
    QCOMPARE(reply.status, 200);
    QCOMPARE(reply.headers.at("content-type"), std::string("application/x-protobuf"));
    QCOMPARE(reply.headers.at("cache-control"), std::string("public, max-age=31536000, immutable"));
    QVERIFY(reply.whole);
    const auto response = parsed(reply.body);
    QCOMPARE(response.status().code(), ros_messages::slam::OK);
    QCOMPARE(response.submap_version(), 24);
    QVERIFY(response.textures_size() >= 1);
  }

  void theBodyIsTheCurrentVersionWhateverWasAsked() {
    Running robot;
    QCOMPARE(parsed(robot.get(submapPath(robot, "0/0?ver=3")).body).submap_version(), 24);
    robot.bumpVersion(0, 0);
    QCOMPARE(parsed(robot.get(submapPath(robot, "0/0?ver=24")).body).submap_version(), 25);
  }

  void withoutAVersionItMustBeAskedAgain() {
    Running robot;
    const raw::HttpReply reply = robot.get(submapPath(robot, "0/0"));
    QCOMPARE(reply.status, 200);
    QCOMPARE(reply.headers.at("cache-control"), std::string("no-cache"));
    QVERIFY(reply.headers.at("etag").starts_with("W/\""));
  }

  void aKnownTagIsAnsweredWith304() {
    Running robot;
    for (const std::string target : {"0/0", "0/0?ver=24"}) {
      const std::string tag = robot.get(submapPath(robot, target)).headers.at("etag");
      const raw::HttpReply again = robot.get(submapPath(robot, target), {{"If-None-Match", tag}});
      QCOMPARE(again.status, 304);
      QVERIFY(again.body.empty());
      QCOMPARE(again.headers.at("etag"), tag);
      const raw::HttpReply other =
          robot.get(submapPath(robot, target), {{"If-None-Match", "\"nonsense\", " + tag}});
      QCOMPARE(other.status, 304);
    }
    const std::string tag = robot.get(submapPath(robot, "0/0")).headers.at("etag");
    robot.bumpVersion(0, 0);
    QCOMPARE(robot.get(submapPath(robot, "0/0"), {{"If-None-Match", tag}}).status, 200);
  }

  void errors_data() {
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("target");
    QTest::addColumn<int>("status");
    const auto row = [](const char* name, const char* method, const char* target, int status) {
      QTest::newRow(name) << QString::fromLatin1(method) << QString::fromLatin1(target) << status;
    };
    row("trajectory is no number", "GET", "/ros/slam/submaps/UUID/a/0?ver=1", 400);
    row("index is no number", "GET", "/ros/slam/submaps/UUID/0/1x?ver=1", 400);
    row("index too large", "GET", "/ros/slam/submaps/UUID/0/99999999999?ver=1", 400);
    row("no index", "GET", "/ros/slam/submaps/UUID/0", 400);
    row("one part too many", "GET", "/ros/slam/submaps/UUID/0/0/0", 400);
    row("uuid with a slash of dots", "GET", "/ros/slam/submaps/..%2f/0/0", 400);
    row("unknown index", "GET", "/ros/slam/submaps/UUID/0/99999?ver=1", 404);
    row("negative index", "GET", "/ros/slam/submaps/UUID/0/-1?ver=1", 404);
    row("unknown trajectory", "GET", "/ros/slam/submaps/UUID/77/0?ver=1", 404);
    row("unknown path", "GET", "/nothing/here", 404);
    row("map image of no resolution", "GET", "/ros/slam/map_image?resolution=0", 400);
    row("map image at nan", "GET", "/ros/slam/map_image?resolution=nan", 400);
    row("map image of no trajectory", "GET", "/ros/slam/map_image?trajectory_id=77", 502);
    row("topics without upgrade", "GET", "/ws/v2/topics", 400);
    row("a list that cannot be overwritten", "PUT", "/maps/", 405);
    row("a picture that cannot be changed", "PATCH", "/maps/1.png", 405);
    row("a map that cannot be posted to", "POST", "/maps/1", 405);
    row("a mapping that cannot be changed", "PATCH", "/mappings/48", 405);
    row("a pose that cannot be read", "GET", "/chassis/pose", 405);
    row("bags that cannot be made", "POST", "/bags/", 405);
    row("device info that cannot be deleted", "DELETE", "/device/info", 405);
    row("delete a submap", "DELETE", "/ros/slam/submaps/UUID/0/0", 405);
    row("a method that nobody knows", "BREW", "/maps/", 405);
    row("post nothing", "POST", "/maps/", 400);
    row("nothing to finish", "PATCH", "/mappings/current", 400);
  }
  void errors() {
    QFETCH(QString, method);
    QFETCH(QString, target);
    QFETCH(int, status);
    Running robot;
    target.replace(QStringLiteral("UUID"), QString::fromStdString(robot.uuid()));
    const raw::HttpReply reply = robot.get(target.toStdString(), {}, method.toStdString());
    QCOMPARE(reply.status, status);
    QVERIFY(!object(reply.body)[QLatin1String("detail")].toString().isEmpty());
    QCOMPARE(reply.headers.contains("allow"), status == 405);
    if (status == 405) QVERIFY(reply.headers.at("allow").find(method.toStdString()) == std::string::npos);
  }

  void headIsGetWithoutABody() {
    Running robot;
    const std::string request = "HEAD /maps/1.png HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n";
    const std::string reply = raw::exchange(robot.port(), request, 1);
    QVERIFY(reply.starts_with("HTTP/1.1 200") && reply.ends_with("\r\n\r\n"));
    QVERIFY(reply.find("ETag: ") != std::string::npos);
  }

  void aWrongUuidIsAStatusInsideTheAnswer() {
    Running robot;
    const raw::HttpReply reply = robot.get("/ros/slam/submaps/0123456789abcdef01234567/0/0?ver=24");
    QCOMPARE(reply.status, 200);
    QCOMPARE(parsed(reply.body).status().code(), ros_messages::slam::UUID_MISMATCH);
    QCOMPARE(reply.headers.at("cache-control"), std::string("no-cache"));
  }

  void theDeviceTellsItsModelAndWhatItCan() {
    for (const bool lists : {true, false}) {
      Options options = paused();
      options.enable_topic_list = lists;
      Running robot(options);
      const QJsonObject info = object(robot.get("/device/info").body);
      QVERIFY(!info[QLatin1String("device")][QLatin1String("model")].toString().isEmpty());
      QVERIFY(!info[QLatin1String("device")][QLatin1String("sn")].toString().isEmpty());
      QCOMPARE(info[QLatin1String("caps")][QLatin1String("supportsEnableTopicList")].toBool(!lists), lists);
    }
  }

  void mapsAreListed() {
    Running robot;
    const raw::HttpReply maps = robot.get("/maps/");
    QCOMPARE(maps.status, 200);
    QVERIFY(QJsonDocument::fromJson(QByteArray::fromStdString(maps.body)).isArray());
    QCOMPARE(object(robot.get("/chassis/current-map").body)[QLatin1String("id")].toInt(), 1);
  }

  void aSecretIsAskedForWhenThereIsOne() {
    Options options = paused();
    options.secret = "open sesame";
    Running robot(options);
    QCOMPARE(robot.get("/device/info").status, 401);
    QCOMPARE(robot.get("/device/info", {{"Secret", "guess"}}).status, 401);
    QCOMPARE(robot.get("/device/info", {{"Secret", "open sesame"}}).status, 200);
    const std::vector<RequestRecord> log = robot.requestLog();
    QCOMPARE(log.size(), std::size_t(3));
    QVERIFY(!log[0].had_secret);
    QVERIFY(log[1].had_secret);
  }

  void aConnectionServesManyRequests() {
    Running robot;
    const std::string one = "GET /device/info HTTP/1.1\r\nHost: x\r\n\r\n";
    const std::string all = raw::exchange(robot.port(), one + one + one, 3);
    std::size_t answers = 0;
    for (std::size_t at = all.find("HTTP/1.1 200"); at != std::string::npos;
         at = all.find("HTTP/1.1 200", at + 1))
      ++answers;
    QCOMPARE(answers, std::size_t(3));
  }

  void oversizedAndGarbledRequestsAreRefused() {
    Running robot;
    QCOMPARE(robot.get("/" + std::string(40'000, 'x')).status, 431);
    QCOMPARE(robot.get("/maps/", {{"Content-Length", "100000000"}}, "POST").status, 413);
    QVERIFY(raw::exchange(robot.port(), "\x01\x02 garbage\r\n\r\n", 1).starts_with("HTTP/1.1 400"));
    QCOMPARE(robot.get("/device/info").status, 200);
  }

  void theLogTellsWhatCameAndWhatWasAnswered() {
    Running robot;
    const raw::HttpReply reply = robot.get(submapPath(robot, "0/1?ver=24"), {{"If-None-Match", "\"old\""}});
    QTRY_VERIFY(robot.requestLog().size() == 1 && robot.requestLog()[0].until_s >= 0);
    const RequestRecord record = robot.requestLog().front();
    QCOMPARE(record.method, std::string("GET"));
    QCOMPARE(record.target, submapPath(robot, "0/1?ver=24"));
    QCOMPARE(record.status, 200);
    QCOMPARE(record.bytes, reply.body.size());
    QCOMPARE(record.concurrent, 1);
    QCOMPARE(record.if_none_match, std::string("\"old\""));
    QVERIFY(record.until_s >= record.at_s);
    robot.clearRequestLog();
    QVERIFY(robot.requestLog().empty());
  }

  void theLogCountsRequestsThatAreInProgressTogether() {
    Options options = paused();
    options.faults.requests.push_back(
        {FaultKind::Delay, kSubmaps, 1, 60'000});  // nothing is answered while this test looks
    Running robot(options);
    const std::string request = "GET " + submapPath(robot, "0/0?ver=24") + " HTTP/1.1\r\nHost: x\r\n\r\n";
    std::vector<std::thread> clients;
    for (int i = 0; i < 3; ++i) {
      clients.emplace_back([&, port = robot.port()] { raw::exchange(port, request, 1); });
    }
    QTRY_COMPARE(robot.requestLog().size(), std::size_t(3));
    int most = 0;
    for (const RequestRecord& record : robot.requestLog()) {
      QCOMPARE(record.until_s, -1.0);
      most = std::max(most, record.concurrent);
    }
    QCOMPARE(most, 3);
    QCOMPARE(robot.get("/device/info").status, 200);
    QCOMPARE(robot.requestLog().back().concurrent, 3);  // other requests do not count
    robot.stop();
    for (std::thread& client : clients) client.join();
    for (const RequestRecord& record : robot.requestLog()) QVERIFY(record.until_s >= 0);
  }

  void aClientThatHangsUpIsNoLongerInProgress() {
    Options options = paused();
    options.faults.requests.push_back({FaultKind::Delay, kSubmaps, 1, 60'000});
    Running robot(options);
    const std::string request = "GET " + submapPath(robot, "0/0?ver=24") + " HTTP/1.1\r\nHost: x\r\n\r\n";
    QTcpSocket client;
    client.connectToHost(QStringLiteral("127.0.0.1"), robot.port());
    QVERIFY(client.waitForConnected());
    client.write(request.data(), qint64(request.size()));
    QTRY_COMPARE(robot.requestLog().size(), std::size_t(1));
    QCOMPARE(robot.requestLog()[0].until_s, -1.0);
    client.abort();
    QTRY_VERIFY(robot.requestLog()[0].until_s >= 0);
    QCOMPARE(robot.requestLog()[0].status, 0);
  }

  void badOptionsAreASentence_data() {
    QTest::addColumn<QString>("part");
    QTest::newRow("scene") << QStringLiteral("office");
    QTest::newRow("submaps") << QStringLiteral("submaps");
    QTest::newRow("port") << QStringLiteral("port");
  }
  void badOptionsAreASentence() {
    QFETCH(QString, part);
    Running first;
    Options options = paused();
    if (part == QLatin1String("office")) options.scene = "moon";
    if (part == QLatin1String("submaps")) options.submaps = -5;
    if (part == QLatin1String("port")) options.port = first.port();
    Simulator robot(options);
    const auto problem = robot.start();
    QVERIFY(problem.has_value());
    QVERIFY(QString::fromStdString(*problem).contains(part));
  }

  void itCanStopAndStartAgain() {
    Running robot;
    robot.stop();
    QCOMPARE(int(robot.port()), 0);
    QVERIFY(!robot.start());
    QCOMPARE(robot.get("/device/info").status, 200);
  }
};

}  // namespace test_http

MAPWRIGHT_TEST(test_http, TestHttp, Core)
#include "test_http.moc"
