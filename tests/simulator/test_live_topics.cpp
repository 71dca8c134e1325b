// The topics that show the robot's live world: their shapes, that they fit each other, load, faults.
#include <zlib.h>

#include <QImage>
#include <QPointF>
#include <QSet>

#include "listening.h"
#include "ros_messages/wrapper.pb.h"
#include "test_program.h"
#include "topic_socket.h"

namespace test_live_topics {

using mapwright::simulator::Faults;
using mapwright::simulator::Options;
using mapwright::simulator::Simulator;

namespace {

QPointF point(const QJsonValue& value) { return {value[0].toDouble(), value[1].toDouble()}; }
double apart(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

const char* const kAllTopics[] = {"/tracked_pose",
                                  "/robot_model",
                                  "/slam/state",
                                  "/map",
                                  "/map_v2",
                                  "/map/costmap",
                                  "/map/costmap_v2",
                                  "/incremental_map",
                                  "/incremental_map_v2",
                                  "/maps/5cm/1hz",
                                  "/maps/1cm/1hz",
                                  "/env_match_map",
                                  "/env_symmetry_map",
                                  "/scan_matched_points2",
                                  "/left_laser_2d/matched",
                                  "/semantic_points",
                                  "/path",
                                  "/local_path",
                                  "/trajectory",
                                  "/trajectory_node_list",
                                  "/planning_state",
                                  "/map/info",
                                  "/alerts",
                                  "/battery_state",
                                  "/detailed_battery_state",
                                  "/wheel_state",
                                  "/sensor_manager_state",
                                  "/nearby_robots",
                                  "/nearby_robot_footprints",
                                  "/landmarks",
                                  "/nearby_auto_doors",
                                  "/detected_pallets",
                                  "/detected_rack",
                                  "/constraint_list",
                                  "/vision_detected_objects",
                                  "/global_positioning_state",
                                  "/collected_barcode"};

/// The picture of a grid topic, after checking what goes with it.
QImage pictureOf(const QJsonObject& message, int port) {
  const QJsonArray size = message[QLatin1String("size")].toArray(),
                   origin = message[QLatin1String("origin")].toArray();
  QByteArray png;
  if (message.contains(QLatin1String("data_url"))) {
    const QString url = message[QLatin1String("data_url")].toString();
    png = QByteArray::fromStdString(raw::get(port, "/" + url.toStdString()).body);
  } else {
    png = QByteArray::fromBase64(message[QLatin1String("data")].toString().toLatin1(),
                                 QByteArray::AbortOnBase64DecodingErrors);
  }
  const QImage picture = QImage::fromData(png, "PNG");
  const bool fits = size.size() == 2 && origin.size() == 2 &&
                    message[QLatin1String("resolution")].toDouble() > 0 &&
                    picture.width() == size[0].toInt() && picture.height() == size[1].toInt();
  return fits ? picture : QImage();
}

/// Gray at a world point; -1 outside.
int grayAt(const QImage& picture, const QJsonObject& message, const QPointF& world) {
  const double resolution = message[QLatin1String("resolution")].toDouble();
  const QPointF offset = (world - point(message[QLatin1String("origin")])) / resolution;
  const int u = static_cast<int>(std::floor(offset.x())),
            v = picture.height() - 1 - static_cast<int>(std::floor(offset.y()));
  return picture.valid(u, v) ? qGray(picture.pixel(u, v)) : -1;
}

std::string unzipped(const std::string& payload) {
  std::string plain(64u << 20, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(payload.data()));
  stream.avail_in = static_cast<uInt>(payload.size());
  stream.next_out = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_out = static_cast<uInt>(plain.size());
  inflate(&stream, Z_FINISH);
  plain.resize(stream.total_out);
  inflateEnd(&stream);
  return plain;
}

}  // namespace

class TestLiveTopics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyTopicComesAndIsTheSameOnEveryRun() {
    Listening one(paused(33)), two(paused(33));
    QTRY_VERIFY(one.client->isOpen() && two.client->isOpen());
    QByteArray all;
    for (const char* topic : kAllTopics) all += QByteArray(all.isEmpty() ? "\"" : ",\"") + topic + '"';
    for (Listening* robot : {&one, &two}) robot->client->send("{\"enable_topic\":[" + all + "]}");
    for (const char* topic : kAllTopics) {
      QTRY_VERIFY2(!one.client->of(topic).isEmpty() && !two.client->of(topic).isEmpty(), topic);
      QVERIFY2(!object(one.client->of(topic).first()).isEmpty(), topic);
      QCOMPARE(two.client->of(topic).first(), one.client->of(topic).first());
    }
  }

  void nothingComesUnasked() {
    Listening robot(paused(33));
    QVERIFY(!robot.text("/tracked_pose").isEmpty());
    QTRY_VERIFY(robot.client->of("/tracked_pose").size() >= 25);
    QCOMPARE(robot.client->texts.size(), robot.client->of("/tracked_pose").size() + 1);
  }

  void theWholeMapComesInPiecesOfFourBits() {
    Listening robot(paused(33));
    const QJsonObject message = robot.of("/map");
    const QByteArray png = QByteArray::fromBase64(message[QLatin1String("data")].toString().toLatin1());
    QCOMPARE(static_cast<int>(png[24]), 4);
    const QImage picture = pictureOf(message, robot.port());
    QVERIFY(!picture.isNull());
    QSet<int> grays;
    for (int v = 0; v < picture.height(); ++v) {
      for (int u = 0; u < picture.width(); ++u) grays << qGray(picture.pixel(u, v));
    }
    QCOMPARE(grays, (QSet<int>{0, 0x77, 255}));
    // The robot stands on free ground.
    QCOMPARE(grayAt(picture, message, point(robot.of("/tracked_pose")[QLatin1String("pos")])), 255);
  }

  void pictureTopicsHaveAPlaceAndAPicture_data() {
    QTest::addColumn<QByteArray>("topic");
    for (const char* topic :
         {"/map_v2", "/map/costmap", "/map/costmap_v2", "/incremental_map", "/incremental_map_v2",
          "/maps/5cm/1hz", "/maps/1cm/1hz", "/env_match_map", "/env_symmetry_map"})
      QTest::newRow(topic) << QByteArray(topic);
  }
  void pictureTopicsHaveAPlaceAndAPicture() {
    QFETCH(QByteArray, topic);
    Listening robot(paused(33));
    const QJsonObject message = robot.of(topic.constData());
    QCOMPARE(message.contains(QLatin1String("data_url")), topic.endsWith("_v2"));
    QVERIFY(!pictureOf(message, robot.port()).isNull());
  }

  void staticFilesMayBeKeptForEver() {
    Listening robot(paused(33));
    const std::string path = "/" + robot.of("/map_v2")[QLatin1String("data_url")].toString().toStdString();
    QVERIFY(path.starts_with("/static-files/map-"));
    const raw::HttpReply file = robot.get(path);
    QCOMPARE(file.status, 200);
    QCOMPARE(file.headers.at("content-type"), std::string("image/png"));
    QCOMPARE(file.headers.at("cache-control"), std::string("public, max-age=2592000"));
    const std::string tag = file.headers.at("etag");
    QCOMPARE("/static-files/map-" + tag + ".png", path);  // without quotes, as these robots send it
    QCOMPARE(robot.get(path, {{"If-None-Match", tag}}).status, 304);
    QCOMPARE(robot.get(path, {{"If-None-Match", "\"" + tag + "\""}}).status, 304);
    QCOMPARE(robot.get(path, {{"If-None-Match", "other"}}).status, 200);
  }

  void aChangedMapIsSentAgainUnderAnotherName() {
    Listening robot(paused(33));
    const QJsonObject before = robot.of("/map_v2"), info = robot.of("/map/info");
    QCOMPARE(info[QLatin1String("uid")].toString().isEmpty(), false);
    QVERIFY(info[QLatin1String("overlays")].isObject());
    robot.publishMapChange();
    QTRY_COMPARE(robot.client->of("/map_v2").size(), 2);
    const QJsonObject after = object(robot.client->of("/map_v2").last());
    QVERIFY(after[QLatin1String("data_url")] != before[QLatin1String("data_url")]);
    QVERIFY(pictureOf(after, robot.port()) != pictureOf(before, robot.port()));
    QTRY_COMPARE(robot.client->of("/map/info").size(), 2);
    QCOMPARE(object(robot.client->of("/map/info").last())[QLatin1String("map_version")].toInt(),
             info[QLatin1String("map_version")].toInt() + 1);
    QVERIFY(robot.setCurrentMap(2));
    QTRY_COMPARE(robot.client->of("/map/info").size(), 3);
    QVERIFY(object(robot.client->of("/map/info").last())[QLatin1String("uid")] != info[QLatin1String("uid")]);
  }

  void costsSurroundTheRobotAndItsWalls() {
    Listening robot(paused(33));
    const QPointF here = point(robot.of("/tracked_pose")[QLatin1String("pos")]);
    for (const char* topic : {"/maps/5cm/1hz", "/maps/1cm/1hz"}) {
      const QJsonObject message = robot.of(topic);
      const QImage picture = pictureOf(message, robot.port());
      QVERIFY(picture.width() >= 200 && picture.width() == picture.height());
      const double half = picture.width() / 2.0 * message[QLatin1String("resolution")].toDouble();
      QVERIFY(apart(here, point(message[QLatin1String("origin")]) + QPointF(half, half)) < 0.1);
      const int cost = grayAt(picture, message, here);
      QVERIFY2(cost >= 0 && cost < 253, qPrintable(QString::number(cost)));
    }
    const QJsonObject wide = robot.of("/maps/5cm/1hz");
    const QImage picture = pictureOf(wide, robot.port());
    // Most of what the lidar hits is lethal.
    int lethal = 0, within = 0;
    for (const QJsonValue& hit : robot.of("/scan_matched_points2")[QLatin1String("points")].toArray()) {
      const int cost = grayAt(picture, wide, point(hit));
      if (cost < 0) continue;
      ++within;
      if (cost >= 253) ++lethal;
    }
    QVERIFY2(within > 20 && lethal > within * 9 / 10,
             qPrintable(QStringLiteral("%1 of %2").arg(lethal).arg(within)));
  }

  void aScanHasAsManyPointsAsAskedFor() {
    for (const int points : {0, 37, 720, 30'000}) {
      Options options = paused(33);
      options.points_per_scan = points;
      Listening robot(options);
      const QJsonObject json = robot.of("/scan_matched_points2");
      QCOMPARE(json[QLatin1String("points")].toArray().size(), points);
      QVERIFY(json[QLatin1String("stamp")].toDouble() > 1e12);  // milliseconds
      const QJsonObject packed = robot.of("/left_laser_2d/matched");
      QCOMPARE(packed[QLatin1String("fields")].toArray().size(), 4);
      QCOMPARE(QByteArray::fromBase64(packed[QLatin1String("data")].toString().toLatin1()).size(),
               16 * points);
    }
  }

  void theThreeShapesOfAScanAreTheSamePoints() {
    Listening text(paused(33)), binary(paused(33), QStringLiteral("?pb=1"));
    const QJsonArray points = text.of("/scan_matched_points2")[QLatin1String("points")].toArray();
    const QByteArray packed = QByteArray::fromBase64(
        text.of("/left_laser_2d/matched")[QLatin1String("data")].toString().toLatin1());
    QTRY_VERIFY(binary.client->isOpen());
    binary.client->send(R"({"enable_topic":"/scan_matched_points2"})");
    QTRY_VERIFY(!binary.client->binaries.isEmpty());
    QVERIFY(binary.client->of("/scan_matched_points2").isEmpty());

    const std::string frame = binary.client->binaries.first().toStdString();
    const auto length = static_cast<std::size_t>(frame.at(0));
    QCOMPARE(frame.substr(1, length), std::string("/scan_matched_points2"));
    const std::string rest = frame.substr(2 + length);
    ros_messages::RosMessageWrapper wrapper;
    QVERIFY(wrapper.ParseFromString(frame[1 + length] != 0 ? unzipped(rest) : rest));
    QCOMPARE(wrapper.type(), ros_messages::POINT_CLOUD);
    const ros_messages::PointCloud& cloud = wrapper.point_cloud();
    QVERIFY(cloud.is_delta_encoded());
    QCOMPARE(cloud.header().frame_id(), std::string("map"));
    QCOMPARE(static_cast<qsizetype>(cloud.point_number()), points.size());
    QCOMPARE(static_cast<qsizetype>(cloud.xs_size()), points.size());
    QCOMPARE(static_cast<qsizetype>(cloud.intensities().size()), points.size());
    int x = 0, y = 0;
    for (int i = 0; i < cloud.xs_size(); ++i) {
      x += cloud.xs(i);
      y += cloud.ys(i);
      const auto resolution = static_cast<double>(cloud.resolution());
      const QPointF there(cloud.center_x() + x * resolution, cloud.center_y() + y * resolution);
      QVERIFY(apart(there, point(points[i])) < 0.002);
      float xy[2];
      memcpy(xy, packed.constData() + 16 * i, 8);
      QVERIFY(apart(there, {static_cast<double>(xy[0]), static_cast<double>(xy[1])}) < 0.002);
    }
  }

  void pathsBeginAtTheRobotAndLeadToTheTarget() {
    Listening robot(paused(33));
    const QPointF here = point(robot.of("/tracked_pose")[QLatin1String("pos")]);
    const QJsonArray path = robot.of("/path")[QLatin1String("positions")].toArray();
    const QJsonObject planning = robot.of("/planning_state");
    const QPointF target = point(planning[QLatin1String("target_poses")][0][QLatin1String("pos")]);
    QVERIFY(path.size() > 2);
    QVERIFY(apart(point(path.first()), here) < 0.01);
    QVERIFY(apart(point(path.last()), target) < 0.01);
    double length = 0;
    for (int i = 1; i < path.size(); ++i) length += apart(point(path[i - 1]), point(path[i]));
    QVERIFY(std::abs(length - planning[QLatin1String("remaining_distance")].toDouble()) < 1);
    QCOMPARE(planning[QLatin1String("move_state")].toString(), QStringLiteral("moving"));

    const QJsonObject local = robot.of("/local_path");
    QVERIFY(apart(point(local[QLatin1String("poses")][0]), here) < 0.01);
    QVERIFY(local[QLatin1String("color")].toString().startsWith(QLatin1Char('#')));
    const QJsonArray trail = robot.of("/trajectory")[QLatin1String("points")].toArray();
    QVERIFY(trail.size() > 10 && apart(point(trail.last()), here) < 0.01);
    const QString old = robot.text("/trajectory_node_list");
    QCOMPARE(object(old)[QLatin1String("points")].toArray(), trail);
  }

  void thingsMoveAndComeAndGoWithTime() {
    Listening robot(paused(33));
    const auto states = [&](const char* topic) {
      QSet<QString> seen;
      for (const QString& text : robot.client->of(topic)) {
        QJsonObject message = object(text);
        message.remove(QLatin1String("stamp"));
        seen << QString::fromUtf8(QJsonDocument(message).toJson());
      }
      return seen.size();
    };
    const char* const moving[] = {
        "/nearby_robots", "/nearby_auto_doors", "/detected_pallets", "/detected_rack",
        "/alerts",        "/wheel_state",       "/collected_barcode"};
    for (const char* topic : moving) QVERIFY(!robot.text(topic).isEmpty());
    for (int i = 0; i < 4; ++i) {
      robot.advance(23);
      const qsizetype before = robot.client->of("/alerts").size();
      QTRY_VERIFY(robot.client->of("/alerts").size() > before);
    }
    for (const char* topic : moving) QVERIFY2(states(topic) >= 2, topic);
  }

  void nearbyRobotsNameTheirFootprints() {
    Listening robot(paused(33));
    QSet<QString> digests;
    for (const QJsonValue& footprint :
         robot.of("/nearby_robot_footprints")[QLatin1String("footprints")].toArray()) {
      digests << footprint[QLatin1String("digest")].toString();
      QVERIFY(footprint[QLatin1String("coordinates")].toArray().size() >= 4);
    }
    const QJsonArray robots = robot.of("/nearby_robots")[QLatin1String("robots")].toArray();
    QCOMPARE(robots.size(), 3);
    for (const QJsonValue& other : robots) {
      const QJsonValue digest = other[QLatin1String("footprint_digest")];
      QVERIFY(digest.isUndefined() || digests.contains(digest.toString()));
      const QJsonArray trend = other[QLatin1String("trend")].toArray();
      if (!trend.isEmpty())
        QVERIFY(apart(point(trend[0]), point(other[QLatin1String("pose")][QLatin1String("pos")])) < 0.01);
    }
  }

  void picturesGoWrongOnRequest() {
    Listening robot(paused(33));
    // A message of before the fault may still be on its way: what is asked for is that one comes that shows
    // the fault.
    const auto comes = [&](const char* topic, const Faults& faults, auto shows) {
      robot.setFaults(faults);
      robot.publishMapChange();
      return QTest::qWaitFor(
          [&] {
            const auto& messages = robot.client->of(topic);
            return !messages.isEmpty() && shows(object(messages.last()));
          },
          20'000);
    };
    const auto picture = [](const QJsonObject& message) {
      return QByteArray::fromBase64Encoding(message[QLatin1String("data")].toString().toLatin1(),
                                            QByteArray::AbortOnBase64DecodingErrors);
    };
    QVERIFY(!robot.of("/map").isEmpty() && !robot.of("/map_v2").isEmpty());
    Faults faults;
    faults.foreign_data_url = true;
    QVERIFY(comes("/map_v2", faults, [](const QJsonObject& message) {
      return message[QLatin1String("data_url")].toString().startsWith(QLatin1String("http://127.0.0.2:1/"));
    }));
    faults = {};
    faults.garbage_base64 = true;
    QVERIFY(comes("/map", faults, [&](const QJsonObject& message) { return !picture(message); }));
    for (const char* fault : {"zero-resolution", "negative-resolution", "no-resolution", "no-origin"}) {
      faults = {};
      faults.grid_fault = fault;
      const bool no_origin = faults.grid_fault == "no-origin";
      QVERIFY2(comes("/map", faults,
                     [&](const QJsonObject& message) {
                       if (!message.contains(QLatin1String("data"))) return false;
                       return no_origin ? !message.contains(QLatin1String("origin"))
                                        : message[QLatin1String("resolution")].toDouble() <= 0;
                     }),
               fault);
    }
    faults = {};
    faults.truncated_maps = true;
    QVERIFY(comes("/map", faults, [&](const QJsonObject& message) {
      const auto half = picture(message);
      return half && half.decoded.startsWith("\x89PNG") && !half.decoded.contains("IEND");
    }));
  }

  void anEmptyRobotSendsOnlyHowItIs() {
    Options options = paused(33);
    options.scene = "empty";
    Listening robot(options);
    for (const char* topic : kAllTopics) {
      QTRY_VERIFY(robot.client->isOpen());
      robot.client->send(QByteArray("{\"enable_topic\":\"") + topic + "\"}");
    }
    QTRY_VERIFY(robot.client->of("/tracked_pose").size() >= 30);
    QVERIFY(!robot.client->of("/battery_state").isEmpty());
    for (const char* topic : {"/map", "/map_v2", "/maps/5cm/1hz", "/path", "/map/info", "/env_match_map"})
      QVERIFY2(robot.client->of(topic).isEmpty(), topic);
  }

  void impossibleLoadsAreRefused() {
    Options many = paused(33), often = paused(33), fine = paused(33);
    many.points_per_scan = 2'000'000;
    often.scan_hz = 0;
    fine.costmap_cells = 5;
    for (const Options& options : {many, often, fine}) {
      Simulator robot(options);
      QVERIFY(robot.start().has_value());
    }
  }
};

}  // namespace test_live_topics

MAPWRIGHT_TEST(test_live_topics, TestLiveTopics, Core)
#include "test_live_topics.moc"
