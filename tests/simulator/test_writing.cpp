// What programs change of the simulated robot's maps: names, overlays, new maps, the current one, the pose,
// and what goes wrong with that on request.
#include <cmath>

#include <QBuffer>
#include <QImage>
#include <QTcpSocket>

#include "listening.h"
#include "test_program.h"

namespace test_writing {

using namespace mapwright::simulator;

namespace {

std::string text(const QJsonObject& object) {
  return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString();
}

const char* const kOverlays =
    R"({ "type":"FeatureCollection", "extra" : {"kept":1.50}, "features":[{"type":"Feature","id":"a",)"
    R"("geometry":{"type":"Point","coordinates":[1.10,2]},"properties":{"type":"9","yaw":"90.0"}}]})";

std::string gridPng() {
  QImage image(30, 20, QImage::Format_Grayscale8);
  image.fill(255);
  image.setPixel(3, 4, qRgb(0, 0, 0));
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return png.toStdString();
}

QJsonObject wholeMap() {
  return {{QStringLiteral("map_name"), QStringLiteral("Handed in")},
          {QStringLiteral("carto_map"), QStringLiteral("YmluYXJ5")},
          {QStringLiteral("occupancy_grid"),
           QString::fromLatin1(QByteArray::fromStdString(gridPng()).toBase64())},
          {QStringLiteral("grid_origin_x"), -1.5},
          {QStringLiteral("grid_origin_y"), 2},
          {QStringLiteral("grid_resolution"), 0.1},
          {QStringLiteral("overlays"), QString::fromLatin1(kOverlays)}};
}

QJsonObject mapOf(const Running& robot, int id) {
  return object(robot.get("/maps/" + std::to_string(id)).body);
}
QJsonObject currentOf(const Running& robot) { return object(robot.get("/chassis/current-map").body); }

}  // namespace

class TestWriting : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aNameChangesAloneAndTheOverlaysKeepEveryByte() {
    Running robot;
    const QJsonObject before = mapOf(robot, 2);
    const auto renamed = robot.send("PATCH", "/maps/2", "{\"map_name\":\"Lobby \\\"new\\\" 🏭\"}");
    QCOMPARE(renamed.status, 200);
    QCOMPARE(object(renamed.body), mapOf(robot, 2));
    QJsonObject after = mapOf(robot, 2);
    QCOMPARE(after[QLatin1String("map_name")].toString(), QString::fromUtf8("Lobby \"new\" 🏭"));
    QVERIFY(after[QLatin1String("last_modified_time")].toInt() >
            before[QLatin1String("last_modified_time")].toInt());
    for (const char* same :
         {"uid", "map_version", "overlays_version", "overlays", "create_time", "grid_origin_x"})
      QCOMPARE(after[QLatin1String(same)], before[QLatin1String(same)]);
  }

  void overlaysAreKeptByteForByteAndCounted() {
    Running robot;
    const QJsonObject patch{{QStringLiteral("overlays"), QString::fromLatin1(kOverlays)}};
    for (int version = 6; version < 9; ++version) {
      QCOMPARE(robot.send("PATCH", "/maps/1", text(patch)).status, 200);
      const QJsonObject map = mapOf(robot, 1);
      QCOMPARE(map[QLatin1String("overlays")].toString(), QString::fromLatin1(kOverlays));
      QCOMPARE(map[QLatin1String("overlays_version")].toInt(), version);
      QCOMPARE(map[QLatin1String("map_version")].toInt(), 3);
      QCOMPARE(currentOf(robot)[QLatin1String("overlays_version")].toInt(), version);
    }
    QCOMPARE(robot.get("/ros/map/overlays").body, std::string(kOverlays));
  }

  void onlyTheCurrentMapIsAnnouncedAgain() {
    Listening robot(paused());
    QCOMPARE(robot.of("/map/info")[QLatin1String("overlays_version")].toInt(), 5);
    QVERIFY(!robot.of("/map").isEmpty());
    QCOMPARE(robot.send("PATCH", "/maps/2", R"({"map_name":"Not this one"})").status, 200);
    const QJsonObject patch{{QStringLiteral("map_name"), QStringLiteral("This one")},
                            {QStringLiteral("overlays"), QString::fromLatin1(kOverlays)}};
    QCOMPARE(robot.send("PATCH", "/maps/1", text(patch)).status, 200);
    QTRY_COMPARE(robot.count("/map/info"), 2);
    const QJsonObject info = robot.last("/map/info");
    QCOMPARE(info[QLatin1String("name")].toString(), QStringLiteral("This one"));
    QCOMPARE(info[QLatin1String("overlays_version")].toInt(), 6);
    QCOMPARE(info[QLatin1String("overlays")].toObject(), QJsonDocument::fromJson(kOverlays).object());
    QCOMPARE(robot.count("/map"), 1);  // its picture is the same
  }

  void theLiveOverlaysCanBeReplacedWhole() {
    Listening robot(paused());
    QVERIFY(!robot.of("/map/info").isEmpty());
    const auto reply = robot.send("PUT", "/ros/map/overlays", kOverlays);
    QCOMPARE(reply.status, 200);
    QVERIFY(object(reply.body)[QLatin1String("success")].toBool());
    QCOMPARE(robot.get("/ros/map/overlays").body, std::string(kOverlays));
    QCOMPARE(mapOf(robot, 1)[QLatin1String("overlays")].toString(), QString::fromLatin1(kOverlays));
    QTRY_COMPARE(robot.count("/map/info"), 2);
    QCOMPARE(robot.last("/map/info")[QLatin1String("overlays_version")].toInt(), 6);
  }

  void aMapIsMadeFromAMapping() {
    Running robot;
    const auto reply = robot.send("POST", "/maps/", R"({"map_name":"From 48","mapping_id":48})");
    QCOMPARE(reply.status, 201);
    const int id = object(reply.body)[QLatin1String("id")].toInt();
    QCOMPARE(id, 13);
    QCOMPARE(mapOf(robot, id)[QLatin1String("map_name")].toString(), QStringLiteral("From 48"));
    QCOMPARE(mapOf(robot, id)[QLatin1String("map_version")].toInt(), 1);
    QCOMPARE(robot.get("/maps/13.png").body, robot.get("/mappings/48.png").body);
    QCOMPARE(array(robot.get("/maps/").body).size(), 5);
    const auto next = robot.send("POST", "/maps", R"({"map_name":"Again","mapping_id":31})");
    QCOMPARE(object(next.body)[QLatin1String("id")].toInt(), 14);
    QVERIFY(object(next.body)[QLatin1String("uid")] != object(reply.body)[QLatin1String("uid")]);
  }

  void aMapIsHandedInAndGivenBackAsItWas() {
    Running robot;
    const auto reply = robot.send("POST", "/maps/", text(wholeMap()));
    QCOMPARE(reply.status, 201);
    const std::string path = "/maps/" + std::to_string(object(reply.body)[QLatin1String("id")].toInt());
    const QJsonObject map = object(robot.get(path).body);
    QCOMPARE(map[QLatin1String("grid_origin_x")].toDouble(), -1.5);
    QCOMPARE(map[QLatin1String("grid_origin_y")].toDouble(), 2.0);
    QCOMPARE(map[QLatin1String("grid_resolution")].toDouble(), 0.1);
    QCOMPARE(map[QLatin1String("overlays")].toString(), QString::fromLatin1(kOverlays));
    QCOMPARE(robot.get(path + ".png").body, gridPng());
    QCOMPARE(robot.get(path + ".pbstream").body, std::string("binary"));
    const QImage small = QImage::fromData(QByteArray::fromStdString(robot.get(path + "/thumbnail").body));
    QCOMPARE(small.size(), QSize(30, 20));
    const std::string tag = robot.get(path + ".png").headers.at("etag");
    QCOMPARE(robot.get(path + ".png", {{"If-None-Match", tag}}).status, 304);
  }

  void aMapIsHandedInAsAForm() {
    Running robot;
    std::string body;
    const auto part = [&](const std::string& name, const std::string& value, const std::string& more = {}) {
      body += "--mark\r\nContent-Disposition: form-data; name=\"" + name + "\"" + more + "\r\n\r\n" + value +
              "\r\n";
    };
    part("map_name", "A form");
    part("carto_map", "YmluYXJ5");
    part("occupancy_grid", gridPng(), "; filename=\"grid.png\"\r\nContent-Type: image/png");
    part("grid_origin_x", "-1.5");
    part("grid_origin_y", "2");
    part("grid_resolution", "0.1");
    const std::map<std::string, std::string> form{{"Content-Type", "multipart/form-data; boundary=mark"}};
    const auto reply = robot.send("POST", "/maps/", body + "--mark--\r\n", form);
    QCOMPARE(reply.status, 201);
    QCOMPARE(robot.get("/maps/13.png").body, gridPng());
    QCOMPARE(robot.send("POST", "/maps/", body, form).status, 400);  // its end is missing
  }

  void badRequestsChangeNothing_data() {
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("path");
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<int>("status");
    const auto row = [](const char* name, const char* method, const char* path, const QByteArray& body,
                        int status = 400) {
      QTest::newRow(name) << QString::fromLatin1(method) << QString::fromLatin1(path) << body << status;
    };
    row("no JSON", "PATCH", "/maps/1", "{");
    row("a list", "PATCH", "/maps/1", "[1]");
    row("deep nesting", "PATCH", "/maps/1", QByteArray(5000, '['));
    row("no UTF-8", "PATCH", "/maps/1", "{\"map_name\":\"\xff\"}");
    row("the name is a number", "PATCH", "/maps/1", R"({"map_name":7})");
    row("the name is empty", "PATCH", "/maps/1", R"({"map_name":""})");
    row("the overlays are no text", "PATCH", "/maps/1", R"({"overlays":{"features":[]}})");
    row("the overlays are no GeoJSON", "PATCH", "/maps/1", R"({"map_name":"x","overlays":"[1,2]"})");
    row("no such map", "PATCH", "/maps/99", R"({"map_name":"x"})", 404);
    row("delete no map", "DELETE", "/maps/99", "", 404);
    row("no such mapping", "POST", "/maps/", R"({"map_name":"x","mapping_id":99})");
    row("a mapping without a map", "POST", "/maps/", R"({"map_name":"x","mapping_id":47})");
    row("a mapping and no name", "POST", "/maps/", R"({"mapping_id":48})");
    row("live overlays that are a list", "PUT", "/ros/map/overlays", "[]");
    row("live overlays without features", "PUT", "/ros/map/overlays", "{}");
    row("no live overlays", "PUT", "/ros/map/overlays", "");
    row("no such map to work with", "POST", "/chassis/current-map", R"({"map_id":99})");
    row("no such uid to work with", "POST", "/chassis/current-map", R"({"map_uid":"?"})");
    row("nothing to work with", "POST", "/chassis/current-map", "{}");
    row("files of the robot's own", "POST", "/chassis/current-map",
        "{\"data_url\":\"file:///etc/passwd\",\"map_name\":\"x\"}");
    row("a pose without a place", "POST", "/chassis/pose", R"({"ori":0})");
    row("a pose with too few numbers", "POST", "/chassis/pose", R"({"position":[1],"ori":0})");
    row("a pose of texts", "POST", "/chassis/pose", R"({"position":["1","2"],"ori":0})");
    row("a pose without a heading", "POST", "/chassis/pose", R"({"position":[1,2,0]})");
    row("no such control mode", "POST", "/services/wheel_control/set_control_mode",
        R"({"control_mode":"x"})");
    row("half a stop", "POST", "/services/wheel_control/set_emergency_stop", R"({"enable":1})");
    const auto lacking = [&](const char* name, const char* key,
                             const QJsonValue& value = QJsonValue::Undefined) {
      QJsonObject map = wholeMap();
      map[QLatin1String(key)] = value;
      row(name, "POST", "/maps/", QByteArray::fromStdString(text(map)));
    };
    for (const char* key : {"map_name", "carto_map", "occupancy_grid", "grid_origin_x", "grid_resolution"})
      lacking(qPrintable(QStringLiteral("without %1").arg(QLatin1String(key))), key);
    lacking("a resolution of nothing", "grid_resolution", 0);
    lacking("a place that is a text", "grid_origin_x", QStringLiteral("1"));
    lacking("no base64", "occupancy_grid", QStringLiteral("***"));
    lacking("no PNG", "occupancy_grid", QStringLiteral("AAAA"));
    lacking("the uid of another map", "uid", QStringLiteral("62a1e0b4c9d84f5a9b7f3c21"));
    lacking("overlays that are none", "overlays", QStringLiteral("{"));
  }
  void badRequestsChangeNothing() {
    QFETCH(QString, method);
    QFETCH(QString, path);
    QFETCH(QByteArray, body);
    QFETCH(int, status);
    Running robot;
    const auto state = [&] {
      std::string all;
      for (const char* part : {"/maps/", "/chassis/current-map", "/ros/map/overlays"})
        all += robot.get(part).body;
      return all;
    };
    const std::string before = state();
    const auto reply = robot.send(method.toStdString(), path.toStdString(), body.toStdString());
    QCOMPARE(reply.status, status);
    QVERIFY(!object(reply.body)[QLatin1String("detail")].toString().isEmpty());
    QCOMPARE(state(), before);
  }

  void whatIsTooLargeIsRefused() {
    Running robot;
    QCOMPARE(robot.get("/maps/1", {{"Content-Length", "100000000"}}, "PATCH").status, 413);
    QJsonObject map = wholeMap();
    std::string png = gridPng();
    png.replace(16, 8, std::string("\0\0\x4E\x20\0\0\x4E\x20", 8));  // 20,000 x 20,000
    map[QLatin1String("occupancy_grid")] = QString::fromLatin1(QByteArray::fromStdString(png).toBase64());
    QCOMPARE(robot.send("POST", "/maps/", text(map)).status, 400);
  }

  void deletedMapsAreGoneAndTheirIdsDoNotComeBack() {
    Running robot;
    const auto made = [&] {
      const auto reply = robot.send("POST", "/maps/", R"({"map_name":"x","mapping_id":48})");
      return object(reply.body)[QLatin1String("id")].toInt();
    };
    QCOMPARE(made(), 13);
    const auto reply = robot.send("DELETE", "/maps/13", "");
    QCOMPARE(reply.status, 204);
    QVERIFY(reply.body.empty());
    QCOMPARE(robot.get("/maps/13").status, 404);
    QCOMPARE(robot.get("/maps/13.png").status, 404);
    QCOMPARE(made(), 14);
    QCOMPARE(robot.send("DELETE", "/maps/", "").status, 204);
    QCOMPARE(array(robot.get("/maps/").body).size(), 0);
    // The robot goes on with what it has in its head.
    QCOMPARE(currentOf(robot)[QLatin1String("id")].toInt(), -1);
    QCOMPARE(currentOf(robot)[QLatin1String("map_name")].toString(), QStringLiteral("Ground floor"));
    QCOMPARE(made(), 15);
  }

  void theCurrentMapIsChosenByIdOrUidAndAnnounced() {
    Listening robot(paused());
    const QJsonObject first = robot.of("/map");
    const QString first_url = robot.of("/map_v2")[QLatin1String("data_url")].toString();
    QVERIFY(!robot.of("/map/info").isEmpty());
    QCOMPARE(robot.send("POST", "/chassis/current-map", R"({"map_id":2})").status, 200);
    QCOMPARE(currentOf(robot)[QLatin1String("id")].toInt(), 2);
    QTRY_VERIFY(robot.count("/map") == 2 && robot.count("/map_v2") == 2 && robot.count("/map/info") == 2);
    QVERIFY(robot.last("/map")[QLatin1String("data")] != first[QLatin1String("data")]);
    QVERIFY(robot.last("/map_v2")[QLatin1String("data_url")].toString() != first_url);
    QCOMPARE(robot.last("/map/info")[QLatin1String("uid")].toString(),
             QStringLiteral("620620f9c0fd0ecb0f66d981"));
    const std::string by_uid = R"({"map_uid":"61e95264c0fd0ecb0f66c71e"})";
    QCOMPARE(robot.send("POST", "/chassis/current-map", by_uid).status, 200);
    QCOMPARE(currentOf(robot)[QLatin1String("id")].toInt(), 7);
  }

  void aMapCanBeWorkedWithWithoutBeingKept() {
    Listening robot(paused());
    QVERIFY(!robot.of("/map").isEmpty());
    QCOMPARE(robot.send("POST", "/chassis/current-map", text(wholeMap())).status, 200);
    QCOMPARE(currentOf(robot)[QLatin1String("id")].toInt(), -1);
    QCOMPARE(currentOf(robot)[QLatin1String("map_name")].toString(), QStringLiteral("Handed in"));
    QCOMPARE(array(robot.get("/maps/").body).size(), 4);
    QTRY_COMPARE(robot.count("/map"), 2);
    const QJsonObject map = robot.last("/map");
    QCOMPARE(QByteArray::fromBase64(map[QLatin1String("data")].toString().toLatin1()).toStdString(),
             gridPng());
    QCOMPARE(map[QLatin1String("origin")].toArray(), (QJsonArray{-1.5, 2}));
    QCOMPARE(robot.get("/ros/map/overlays").body, std::string(kOverlays));
    QVERIFY(robot.send("PUT", "/ros/map/overlays", R"({"features":[]})").status == 200);
    QCOMPARE(currentOf(robot)[QLatin1String("overlays_version")].toInt(), 2);
  }

  void aPoseIsBelievedAndLosesThePositionWhenItIsWrong() {
    Listening robot(paused());
    const QJsonObject before = robot.of("/tracked_pose");
    QVERIFY(robot.of("/slam/state")[QLatin1String("reliable")].toBool());
    const auto pose = [&](double x, double y, double ori, const char* adjust) {
      const std::string body = "{\"position\":[" + std::to_string(x) + "," + std::to_string(y) +
                               ",0],\"ori\":" + std::to_string(ori) + adjust + "}";
      return robot.send("POST", "/chassis/pose", body).status;
    };
    const auto isAt = [&](double x, double y, double ori) {
      const QJsonObject now = robot.last("/tracked_pose");
      const QJsonArray pos = now[QLatin1String("pos")].toArray();
      return std::hypot(pos[0].toDouble() - x, pos[1].toDouble() - y) < 1e-3 &&
             std::abs(now[QLatin1String("ori")].toDouble() - ori) < 1e-3;
    };
    QCOMPARE(pose(100, -50, 1.5, ""), 200);
    QTRY_VERIFY(isAt(100, -50, 1.5));
    QTRY_VERIFY(!robot.last("/slam/state")[QLatin1String("reliable")].toBool(true));
    QVERIFY(robot.text("/alerts").contains(QLatin1String("7002")));
    // The robot drives on from where it believes to be.
    robot.advance(5);
    QTRY_VERIFY(!isAt(100, -50, 1.5));
    QCOMPARE(robot.send("POST", "/services/start_global_positioning", "{}").status, 200);
    QTRY_VERIFY(robot.last("/slam/state")[QLatin1String("reliable")].toBool());
  }

  void anAdjustedPoseIsPutRightWhenItIsNearlyRight() {
    Listening robot(paused());
    const QJsonObject here = robot.of("/tracked_pose");
    const QJsonArray pos = here[QLatin1String("pos")].toArray();
    const std::string body = "{\"position\":[" + std::to_string(pos[0].toDouble() + 0.7) + "," +
                             std::to_string(pos[1].toDouble() - 0.6) +
                             ",0],\"ori\":" + std::to_string(here[QLatin1String("ori")].toDouble() + 0.2);
    const auto send = [&](const std::string& adjust) {
      const qsizetype before = robot.count("/tracked_pose");
      robot.send("POST", "/chassis/pose", body + adjust + "}");
      (void)QTest::qWaitFor([&] { return robot.count("/tracked_pose") >= before + 3; }, 20'000);
      return robot.last("/tracked_pose");
    };
    QVERIFY(send(",\"adjust_position\":false") != here);
    QCOMPARE(send(",\"adjust_position\":true"), here);
  }

  void failedWritesChangeNothingAndLostAnswersDo_data() {
    QTest::addColumn<FaultKind>("kind");
    QTest::addColumn<bool>("changes");
    QTest::newRow("error") << FaultKind::Refuse << false;
    QTest::newRow("dropped") << FaultKind::Drop << false;
    QTest::newRow("answer lost") << FaultKind::Cut << true;
  }
  void failedWritesChangeNothingAndLostAnswersDo() {
    QFETCH(FaultKind, kind);
    QFETCH(bool, changes);
    const bool error = kind == FaultKind::Refuse;
    Options options = paused();
    options.faults.requests.push_back({kind, kWrites});
    Running robot(options);
    const auto reply = robot.send("PATCH", "/maps/1", R"({"map_name":"New"})");
    QCOMPARE(reply.status >= 500, error);
    QCOMPARE(reply.status == 0, !error);
    const QString name = mapOf(robot, 1)[QLatin1String("map_name")].toString();  // reading is not disturbed
    QCOMPARE(name, changes ? QStringLiteral("New") : QStringLiteral("Ground floor"));
  }

  void ignoredWritesAreAcceptedAndChangeNothingWhereTheyAreWanted() {
    Options options = paused();
    options.faults.requests.push_back({FaultKind::Ignore, kWrites, 1, 0, "/maps/"});
    Running robot(options);
    QCOMPARE(robot.send("PATCH", "/maps/1", R"({"map_name":"New"})").status, 200);
    QCOMPARE(robot.send("DELETE", "/maps/2", "").status, 204);
    QCOMPARE(mapOf(robot, 1)[QLatin1String("map_name")].toString(), QStringLiteral("Ground floor"));
    QCOMPARE(robot.get("/maps/2").status, 200);
    QCOMPARE(robot.send("POST", "/chassis/current-map", R"({"map_id":2})").status, 200);
    QCOMPARE(currentOf(robot)[QLatin1String("id")].toInt(), 2);
  }

  void theDataOfAMapComesFromAnyPlaceOnWhileItIsTheSame() {
    Running robot;
    const std::string path = "/maps/1.pbstream";
    const auto whole = robot.get(path);
    const std::string tag = whole.headers.at("etag");
    QCOMPARE(std::size_t(mapOf(robot, 1)[QLatin1String("pbstream_size")].toInt()), whole.body.size());
    const auto rest = robot.get(path, {{"Range", "bytes=1000-"}, {"If-Range", tag}});
    QCOMPARE(rest.status, 206);
    QCOMPARE(rest.body, whole.body.substr(1000));
    robot.publishMapChange();
    const auto other = robot.get(path, {{"Range", "bytes=1000-"}, {"If-Range", tag}});
    QCOMPARE(other.status, 200);
    QVERIFY(other.headers.at("etag") != tag && other.body != whole.body);
    Faults faults;
    faults.requests.push_back({FaultKind::Truncate, kDownloads});
    robot.setFaults(faults);
    QVERIFY(!robot.get(path).whole);
  }

  void someWritesFailAndTheSameOnesOnEveryRun() {
    QList<QList<int>> seen;
    for (int run = 0; run < 2; ++run) {
      Options options = paused();
      options.faults.requests.push_back({FaultKind::Refuse, kWrites, 0.5});
      Running robot(options);
      QList<int> statuses;
      for (int i = 0; i < 24; ++i) statuses << robot.send("PATCH", "/maps/1", R"({"map_name":"New"})").status;
      QVERIFY(statuses.contains(200) && (statuses.contains(500) || statuses.contains(503)));
      seen << statuses;
    }
    QCOMPARE(seen[0], seen[1]);
  }

  void writesCanBeSlow() {
    Options options = paused();
    options.faults.requests.push_back({FaultKind::Delay, kWrites, 1, 60'000});
    Running robot(options);
    QTcpSocket client;
    client.connectToHost(QStringLiteral("127.0.0.1"), robot.port());
    QVERIFY(client.waitForConnected());
    client.write("PATCH /maps/1 HTTP/1.1\r\nHost: x\r\nContent-Length: 19\r\n\r\n{\"map_name\":\"Slow\"}");
    QTRY_COMPARE(robot.requestLog().size(), std::size_t(1));
    QCOMPARE(robot.get("/maps/").status, 200);
    QCOMPARE(robot.requestLog().front().until_s, -1.0);
  }

  void everyWriteAsksForTheSecret() {
    Options options = paused();
    options.secret = "s";
    Running robot(options);
    for (const auto& [method, path] : {std::pair{"POST", "/maps/"},
                                       {"PATCH", "/maps/1"},
                                       {"DELETE", "/maps/1"},
                                       {"POST", "/chassis/current-map"},
                                       {"POST", "/chassis/pose"},
                                       {"PUT", "/ros/map/overlays"},
                                       {"POST", "/mappings/"},
                                       {"PATCH", "/mappings/current"},
                                       {"POST", "/recording/"},
                                       {"DELETE", "/bags/"}}) {
      QCOMPARE(robot.send(method, path, "{}").status, 401);
      QCOMPARE(robot.send(method, path, "{}", {{"Secret", "wrong"}}).status, 401);
    }
    QCOMPARE(robot.send("PATCH", "/maps/1", R"({"map_name":"Mine"})", {{"Secret", "s"}}).status, 200);
    const std::string handshake =
        "GET /ws/v2/topics HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    QVERIFY(raw::exchange(robot.port(), handshake + "\r\n", 1).starts_with("HTTP/1.1 401"));
    QVERIFY(raw::exchange(robot.port(), handshake + "Secret: s\r\n\r\n", 1).starts_with("HTTP/1.1 101"));
  }
};

}  // namespace test_writing

MAPWRIGHT_TEST(test_writing, TestWriting, Core)
#include "test_writing.moc"
