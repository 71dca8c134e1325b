// The Agibot robot beside the Autoxing one: docs/protocols/agibot-aimdk.md.
#include <QImage>

#include "running.h"
#include "test_program.h"

namespace test_aimdk {

using namespace mapwright::simulator;

namespace {

const std::string kMapping = "/rpc/aimdk.protocol.MappingService/";
const std::string kTopo = "/rpc/aimdk.protocol.LocalizationService/GetTopoMsgs";

raw::HttpReply post(const Running& robot, const std::string& path, const std::string& body) {
  return raw::send(robot.aimdkPort(), "POST", path, body);
}

QJsonObject object(const raw::HttpReply& reply) { return ::object(reply.body); }
QJsonValue data(const raw::HttpReply& reply) { return object(reply)[QLatin1String("data")]; }

raw::HttpReply names(const Running& robot) {
  return post(robot, kMapping + "GetStoredMapNames", R"({"command":"MappingCommand_GET_STORED_MAP_NAME"})");
}
raw::HttpReply whole(const Running& robot, const QString& id) {
  return post(robot, kMapping + "Get2DWholeMap",
              R"({"command":"MappingCommand_GET_2D_WHOLE_MAP","map_id":")" + id.toStdString() + "\"}");
}
raw::HttpReply topo(const Running& robot, const QString& id) {
  return post(robot, kTopo, R"({"command":"TopoCommand_GET_TOPO_MSG","map_id":)" + id.toStdString() + "}");
}

}  // namespace

}  // namespace test_aimdk

namespace test_aimdk {  // opened again: moc loses count of the braces in raw strings above

class TestAimdk : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void itsAddressIsAnotherPort() {
    Running robot;
    QVERIFY(robot.aimdkPort() != 0 && robot.aimdkPort() != robot.port());
    QCOMPARE(robot.aimdkAddress(), "aimdk+http://127.0.0.1:" + std::to_string(robot.aimdkPort()));
  }

  void mapsAreNamedByTextsOfThirteenDigits() {
    Running robot;
    const QJsonArray maps = data(names(robot))[QLatin1String("map_lists")].toArray();
    QCOMPARE(maps.size(), 3);
    for (const QJsonValue& map : maps) {
      QCOMPARE(map[QLatin1String("map_id")].toString().size(), 13);
      QVERIFY(!map[QLatin1String("map_name")].toString().isEmpty());
      QVERIFY(map[QLatin1String("map_index")].isDouble());
    }
    const QJsonValue current = data(post(robot, kMapping + "GetCurrentWorkingMap",
                                         R"({"command":"MappingCommand_GET_CURRENT_WORKING_MAP"})"));
    QCOMPARE(current[QLatin1String("map_id")].toString(), QStringLiteral("1764059676131"));
  }

  void everyMapIsAPicture() {
    Running robot;
    int with_prefix = 0, lying = 0;
    for (const QJsonValue& listed : data(names(robot))[QLatin1String("map_lists")].toArray()) {
      const QJsonValue map = data(whole(robot, listed[QLatin1String("map_id")].toString()));
      QCOMPARE(map[QLatin1String("map_id")], listed[QLatin1String("map_id")]);
      QString text = map[QLatin1String("map_data")].toString();
      const QString prefix = QStringLiteral("data:image/png;base64,");
      if (text.startsWith(prefix)) {
        ++with_prefix;
        text.remove(0, prefix.size());
      }
      const QImage picture = QImage::fromData(QByteArray::fromBase64(text.toLatin1()), "PNG");
      QVERIFY(picture.width() > 100);
      if (picture.width() != map[QLatin1String("width")].toInt()) ++lying;
      const double resolution = map[QLatin1String("resolution")].toDouble();
      QVERIFY(resolution == 20 || resolution == 10);
      for (const char* key : {"origin_x", "origin_y", "rotate_angle"})
        QVERIFY2(map[QLatin1String(key)].isDouble(), key);
    }
    QCOMPARE(with_prefix, 1);
    QCOMPARE(lying, 1);
  }

  void pointsLieOnFreeGroundAndOneIsMisplaced() {
    Running robot;
    const QString id = QStringLiteral("1764059676131");
    const QJsonValue map = data(whole(robot, id));
    const QImage picture =
        QImage::fromData(QByteArray::fromBase64(map[QLatin1String("map_data")].toString().toLatin1()), "PNG");
    const QJsonValue topology = data(topo(robot, id));
    QVERIFY(topology[QLatin1String("paths")].isArray() && topology[QLatin1String("regions")].isArray());
    const QJsonArray points = topology[QLatin1String("points")].toArray();
    QCOMPARE(points.size(), 9);
    int misplaced = 0;
    const double scale = map[QLatin1String("resolution")].toDouble();
    for (const QJsonValue& value : points) {
      const QJsonValue pose = value[QLatin1String("pose")][QLatin1String("position")],
                       pixel = value[QLatin1String("pixel_pose")][QLatin1String("position")];
      const double u =
          map[QLatin1String("origin_x")].toDouble() + pose[QLatin1String("x")].toDouble() * scale;
      const double v =
          map[QLatin1String("origin_y")].toDouble() - pose[QLatin1String("y")].toDouble() * scale;
      QCOMPARE(qGray(picture.pixel(static_cast<int>(u), static_cast<int>(v))), 255);
      const double off =
          std::hypot(u - pixel[QLatin1String("u")].toDouble(), v - pixel[QLatin1String("v")].toDouble());
      QVERIFY(off < 1 || off > 3);
      if (off > 1) ++misplaced;
    }
    QCOMPARE(misplaced, 1);
  }

  void wrongRequestsAreAnswered() {
    Running robot;
    const std::string good = R"({"command":"MappingCommand_GET_STORED_MAP_NAME"})";
    QCOMPARE(post(robot, "/nothing", good).status, 404);
    QCOMPARE(post(robot, kMapping + "DeleteMap", good).status, 404);
    QCOMPARE(raw::get(robot.aimdkPort(), kMapping + "GetStoredMapNames").status, 405);
    QCOMPARE(raw::get(robot.aimdkPort(), "/ws/v2/topics").status, 404);
    QCOMPARE(post(robot, kMapping + "GetStoredMapNames", "{").status, 400);
    QCOMPARE(post(robot, kMapping + "GetStoredMapNames", "[]").status, 400);
    const raw::HttpReply other = post(robot, kMapping + "Get2DWholeMap", good);
    QCOMPARE(other.status, 200);
    QVERIFY(object(other).contains(QLatin1String("error")));
    // A text where a number belongs, and the other way round.
    QVERIFY(object(topo(robot, QStringLiteral("\"1764059676131\""))).contains(QLatin1String("error")));
    const raw::HttpReply number =
        post(robot, kMapping + "Get2DWholeMap",
             R"({"command":"MappingCommand_GET_2D_WHOLE_MAP","map_id":1764059676131})");
    QVERIFY(object(number).contains(QLatin1String("error")));
    // Unknown maps.
    QVERIFY(data(whole(robot, QStringLiteral("1"))).toObject().isEmpty());
    QVERIFY(object(topo(robot, QStringLiteral("1"))).contains(QLatin1String("error")));
  }

  void newerFirmwareIsThereOnRequestOnly() {
    const auto ask = [](const Running& robot, const char* method, const char* members) {
      return post(robot, kMapping + method, std::string("{\"header\":{},") + members + "}");
    };
    Running older;
    const char* const realtime = "\"command\":\"MappingCommand_GET_REALTIME_MAP\"";
    QCOMPARE(ask(older, "GetRealtimeMapData", realtime).status, 404);
    Options options = paused();
    options.aimdk.newer = true;
    Running robot(options);
    const auto code = [](const raw::HttpReply& reply) {
      return object(reply)[QLatin1String("header")][QLatin1String("code")].toString();
    };
    QCOMPARE(code(ask(robot, "GetRealtimeMapData", realtime)), QStringLiteral("0"));
    QVERIFY(data(ask(robot, "GetRealtimeMapData", realtime)).toObject().isEmpty());
    QCOMPARE(code(ask(robot, "StartMapping", "\"command\":\"MappingCommand_START_MAPPING\"")),
             QStringLiteral("0"));
    QVERIFY(data(ask(robot, "GetRealtimeMapData", realtime)).toObject().contains(QLatin1String("map_data")));
    QCOMPARE(code(ask(robot, "StartMapping", "\"command\":\"MappingCommand_START_MAPPING\"")),
             QStringLiteral("1002"));
    QCOMPARE(
        code(ask(robot, "StopMapping", "\"command\":\"MappingCommand_SAVING_MAP\",\"map_name\":\"Yard\"")),
        QStringLiteral("0"));
    QCOMPARE(data(names(robot))[QLatin1String("map_lists")].toArray().size(), 4);
    Faults faults;
    faults.requests.push_back({FaultKind::Ignore, kWrites});
    robot.setFaults(faults);
    const char* const removal = "\"command\":\"MappingCommand_DELETE_MAP\",\"map_id\":\"1764137567113\"";
    QCOMPARE(code(ask(robot, "DeleteMap", removal)), QStringLiteral("0"));
    QCOMPARE(data(names(robot))[QLatin1String("map_lists")].toArray().size(), 4);
    robot.setFaults({});
    QCOMPARE(code(ask(robot, "DeleteMap", removal)), QStringLiteral("0"));
    QCOMPARE(data(names(robot))[QLatin1String("map_lists")].toArray().size(), 3);
  }

  void itGoesWrongOnRequest() {
    Running robot;
    Faults faults;
    faults.requests.push_back({FaultKind::Refuse, kMapList, 1, 500});
    robot.setFaults(faults);
    QCOMPARE(names(robot).status, 500);
    faults = {};
    faults.garbage_base64 = true;
    robot.setFaults(faults);
    const QByteArray text =
        data(whole(robot, QStringLiteral("1764059676131")))[QLatin1String("map_data")].toString().toLatin1();
    QVERIFY(QByteArray::fromBase64Encoding(text, QByteArray::AbortOnBase64DecodingErrors).decodingStatus !=
            QByteArray::Base64DecodingStatus::Ok);
    faults = {};
    faults.grid_fault = "zero-resolution";
    robot.setFaults(faults);
    QCOMPARE(data(whole(robot, QStringLiteral("1764059676131")))[QLatin1String("resolution")].toDouble(-1),
             0.0);
  }

  void theSecretStaysWithTheOtherRobot() {
    Options options = paused();
    options.secret = "s";
    Running robot(options);
    QCOMPARE(names(robot).status, 200);
    QCOMPARE(robot.requestLog().size(), std::size_t{1});
    QVERIFY(!robot.requestLog().front().had_secret);
  }

  void anEmptyRobotHasEmptyData() {
    Options options = paused();
    options.scene = "empty";
    Running robot(options);
    QVERIFY(data(names(robot))[QLatin1String("map_lists")].toArray().isEmpty());
    QVERIFY(data(whole(robot, QStringLiteral("1764059676131"))).toObject().isEmpty());
  }
};

}  // namespace test_aimdk

MAPWRIGHT_TEST(test_aimdk, TestAimdk, Core)
#include "test_aimdk.moc"
