// Stored maps, mapping tasks, the current map and the whole map's picture over HTTP.
#include <QImage>
#include <QSet>

#include "running.h"
#include "test_program.h"

namespace test_maps {

using namespace mapwright::simulator;

namespace {

QImage image(const std::string& png) { return QImage::fromData(QByteArray::fromStdString(png), "PNG"); }

QJsonArray overlaysOf(const QJsonObject& detail) {
  const QByteArray text = detail[QLatin1String("overlays")].toString().toUtf8();
  return QJsonDocument::fromJson(text).object()[QLatin1String("features")].toArray();
}

/// Shares of black, white and other pixels.
struct Tally {
  int black = 0, white = 0, other = 0;
};
Tally tally(const QImage& picture) {
  Tally count;
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const int gray = qGray(picture.pixel(u, v));
      ++(gray == 0 ? count.black : gray == 255 ? count.white : count.other);
    }
  }
  return count;
}

}  // namespace

class TestMaps : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bothSpellingsListTheSameMaps() {
    Running robot;
    const raw::HttpReply list = robot.get("/maps/");
    QCOMPARE(list.status, 200);
    QCOMPARE(robot.get("/maps").body, list.body);
    const QJsonArray maps = array(list.body);
    QVERIFY(maps.size() >= 3);
    QString names;
    for (const QJsonValue& value : maps) {
      const QJsonObject map = value.toObject();
      for (const char* key : {"id", "uid", "map_name", "create_time", "map_version", "overlays_version"})
        QVERIFY2(map.contains(QLatin1String(key)), key);
      for (const char* key : {"thumbnail_url", "image_url", "url"}) {
        // The robot knows itself by another address than the one connected to.
        QVERIFY2(
            map[QLatin1String(key)].toString().startsWith(QLatin1String("http://192.168.25.25:8090/maps/")),
            key);
      }
      names += map[QLatin1String("map_name")].toString();
    }
    QVERIFY(names.contains(QString::fromUtf8("前台")));
    QVERIFY(names.contains(QLatin1String("<b>")));
    QVERIFY(names.contains(QString::fromUtf8("🏭")));
  }

  void everyListedMapHasADetailAPictureAndAThumbnail() {
    Running robot;
    for (const QJsonValue& value : array(robot.get("/maps/").body)) {
      const std::string path = "/maps/" + std::to_string(value[QLatin1String("id")].toInt());
      const QJsonObject detail = object(robot.get(path).body);
      QCOMPARE(detail[QLatin1String("uid")], value[QLatin1String("uid")]);
      QVERIFY(detail[QLatin1String("grid_resolution")].toDouble() > 0);
      for (const char* key : {"last_modified_time", "grid_origin_x", "grid_origin_y"})
        QVERIFY2(detail[QLatin1String(key)].isDouble(), key);
      QVERIFY(!detail[QLatin1String("pbstream_url")].toString().isEmpty());

      const raw::HttpReply png = robot.get(path + ".png");
      QCOMPARE(png.status, 200);
      QCOMPARE(png.headers.at("content-type"), std::string("image/png"));
      QCOMPARE(static_cast<int>(png.body.at(24)), 8);  // bits per pixel
      const QImage picture = image(png.body);
      QVERIFY(picture.width() > 100 && picture.height() > 100);
      const Tally count = tally(picture);
      QVERIFY2(count.black > 500, qPrintable(QString::number(count.black)));
      QVERIFY(count.white > 10 * count.black / 4);

      const QImage small = image(robot.get(path + "/thumbnail").body);
      QVERIFY(!small.isNull() && small.width() <= 160 && small.height() <= 160);
      QVERIFY(tally(small).black > 20 && tally(small).white > 20);
    }
  }

  void overlaysAreATextWithEveryKindOfFeature() {
    Running robot;
    const QJsonObject detail = object(robot.get("/maps/1").body);
    QVERIFY(detail[QLatin1String("overlays")].isString());
    QSet<int> points, lines, regions;
    bool yaw_as_text = false, yaw_as_number = false, type_as_text = false, open_ring = false, no_id = false;
    for (const QJsonValue& feature : overlaysOf(detail)) {
      const QJsonObject properties = feature[QLatin1String("properties")].toObject();
      const QJsonValue geometry = feature[QLatin1String("geometry")];
      if (!feature.toObject().contains(QLatin1String("id"))) no_id = true;
      yaw_as_text |= properties[QLatin1String("yaw")].isString();
      yaw_as_number |= properties[QLatin1String("yaw")].isDouble();
      type_as_text |= properties[QLatin1String("type")].isString();
      const auto number = [&](const char* key) { return properties[QLatin1String(key)].toVariant().toInt(); };
      points << number("type");
      lines << number("lineType");
      regions << number("regionType");
      const QJsonArray ring = geometry[QLatin1String("coordinates")][0].toArray();
      if (geometry[QLatin1String("type")] == QLatin1String("Polygon") && ring.size() > 2)
        open_ring |= ring.first() != ring.last();
    }
    QVERIFY(yaw_as_text && yaw_as_number && type_as_text && open_ring && no_id);
    QVERIFY((points.contains(QSet<int>{3, 6, 9, 10, 11, 19, 25, 27, 28, 29, 34, 36, 37, 39, 77})));
    QVERIFY((lines.contains(QSet<int>{1, 2, 3, 4, 88})));
    QVERIFY((regions.contains(QSet<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17, 99})));
  }

  void aPictureIsNotSentAgainToWhoHasIt() {
    Running robot;
    const raw::HttpReply first = robot.get("/maps/1.png");
    QCOMPARE(first.headers.at("cache-control"), std::string("no-cache"));
    const std::string tag = first.headers.at("etag");
    QVERIFY(tag.front() == '"');
    const raw::HttpReply again = robot.get("/maps/1.png", {{"If-None-Match", tag}});
    QCOMPARE(again.status, 304);
    QVERIFY(again.body.empty());
    QCOMPARE(again.headers.at("etag"), tag);
    robot.publishMapChange();
    const raw::HttpReply changed = robot.get("/maps/1.png", {{"If-None-Match", tag}});
    QCOMPARE(changed.status, 200);
    QVERIFY(changed.headers.at("etag") != tag);
    QCOMPARE(object(robot.get("/maps/1").body)[QLatin1String("map_version")].toInt(), 4);
  }

  void theCurrentMapCanBeScripted() {
    Running robot;
    const auto id = [&] {
      return object(robot.get("/chassis/current-map").body)[QLatin1String("id")].toInt();
    };
    QCOMPARE(id(), 1);
    QVERIFY(robot.setCurrentMap(2));
    QCOMPARE(id(), 2);
    QVERIFY(!robot.setCurrentMap(99));
    QCOMPARE(id(), 2);
  }

  void mappingTasksAreListedWithWhatTheyMade() {
    Running robot;
    const QJsonArray tasks = array(robot.get("/mappings/").body);
    QSet<QString> states;
    for (const QJsonValue& task : tasks) {
      states << task[QLatin1String("state")].toString();
      const std::string path = "/mappings/" + std::to_string(task[QLatin1String("id")].toInt());
      QCOMPARE(object(robot.get(path).body), task.toObject());
      const bool made = task[QLatin1String("image_url")].isString();
      QCOMPARE(made, task[QLatin1String("state")] == QLatin1String("finished"));
      QCOMPARE(robot.get(path + ".png").status, made ? 200 : 404);
      QCOMPARE(robot.get(path + "/thumbnail").status, made ? 200 : 404);
      if (!made) continue;
      const QJsonArray ways = array(robot.get(path + "/trajectories.json").body);
      QCOMPARE(ways.size(), 2);
      QVERIFY(ways[0][QLatin1String("coordinates")].toArray().size() > 10);
      QCOMPARE(array(robot.get(path + "/landmarks.json").body).size(), 6);
    }
    QVERIFY((states.contains(QSet<QString>{QStringLiteral("finished"), QStringLiteral("cancelled")})));
  }

  void whatIsNotThereIs404_data() {
    QTest::addColumn<QString>("path");
    for (const char* path :
         {"/maps/99", "/maps/99.png", "/maps/x", "/maps/1/nothing", "/maps/1.jpg", "/maps/-1", "/maps/1x.png",
          "/mappings/99", "/mappings/x.png", "/mappings/48/nothing", "/static-files/map-0.png",
          "/static-files/", "/maps/99999999999999999999"})
      QTest::newRow(path) << QString::fromLatin1(path);
  }
  void whatIsNotThereIs404() {
    QFETCH(QString, path);
    Running robot;
    const raw::HttpReply reply = robot.get(path.toStdString());
    QCOMPARE(reply.status, 404);
    QVERIFY(!object(reply.body)[QLatin1String("detail")].toString().isEmpty());
  }

  void theWholeMapComesAtAnyResolution() {
    Running robot;
    QSize last;
    for (const double resolution : {0.2, 0.1, 0.05}) {
      const raw::HttpReply reply = robot.get("/ros/slam/map_image?resolution=" + std::to_string(resolution));
      QCOMPARE(reply.status, 200);
      ros_messages::slam::GetMapImageResponse response;
      QVERIFY(response.ParseFromString(reply.body));
      QCOMPARE(response.status_code(), ros_messages::slam::OK);
      QCOMPARE(response.resolution(), resolution);
      const QImage picture = image(response.png_bytes());
      QVERIFY(picture.width() > 1.8 * last.width() && picture.height() > 1.8 * last.height());
      last = picture.size();
      const QJsonObject detail = object(robot.get("/maps/1").body);
      QVERIFY(std::abs(response.origin_x() - detail[QLatin1String("grid_origin_x")].toDouble()) < 0.5);
      QVERIFY(std::abs(response.origin_y() - detail[QLatin1String("grid_origin_y")].toDouble()) < 0.5);
    }
  }

  void anEmptyRobotHasNoMaps() {
    Options options = paused();
    options.scene = "empty";
    Running robot(options);
    QCOMPARE(array(robot.get("/maps/").body).size(), 0);
    QCOMPARE(array(robot.get("/mappings/").body).size(), 0);
    QCOMPARE(object(robot.get("/chassis/current-map").body)[QLatin1String("id")].toInt(), -1);
    QCOMPARE(robot.get("/maps/1").status, 404);
    QCOMPARE(robot.get("/ros/slam/map_image?resolution=0.1").status, 502);
  }

  void everyRouteAsksForTheSecret() {
    Options options = paused();
    options.secret = "s";
    Running robot(options);
    for (const char* path :
         {"/maps", "/maps/", "/maps/1", "/maps/1.png", "/maps/1/thumbnail", "/mappings/", "/mappings/48.png",
          "/chassis/current-map", "/static-files/map-0.png", "/ros/slam/map_image"}) {
      QCOMPARE(robot.get(path).status, 401);
      QCOMPARE(robot.get(path, {{"Secret", "wrong"}}).status, 401);
      QVERIFY(robot.get(path, {{"Secret", "s"}}).status != 401);
    }
    const auto log = robot.requestLog();
    QVERIFY(log.size() >= 30 && !log[0].had_secret && log[1].had_secret);
    QCOMPARE(log[3].target, std::string("/maps/"));
  }

  void everyRunGivesTheSameBytes() {
    std::vector<std::string> seen;
    for (int run = 0; run < 2; ++run) {
      Running robot;
      std::string all;
      for (const char* path : {"/maps/", "/maps/1", "/maps/2.png", "/maps/7/thumbnail", "/mappings/48",
                               "/mappings/48/trajectories.json", "/ros/slam/map_image?resolution=0.15"})
        all += robot.get(path).body;
      seen.push_back(all);
    }
    QVERIFY(seen[0] == seen[1]);
  }

  void mapsGoWrongOnRequest() {
    Running robot;
    const std::string whole = robot.get("/maps/1.png").body;
    Faults faults;
    faults.truncated_maps = true;
    robot.setFaults(faults);
    const raw::HttpReply half = robot.get("/maps/1.png");
    QVERIFY(half.whole && half.body == whole.substr(0, whole.size() / 2));
    faults = {};
    faults.lying_map_size = true;
    robot.setFaults(faults);
    QCOMPARE(robot.get("/maps/1.png").body.substr(16, 8), std::string("\0\0\xEA\x60\0\0\xEA\x60", 8));
    faults = {};
    faults.requests.push_back({FaultKind::Refuse, kMapList, 1, 500});
    robot.setFaults(faults);
    QCOMPARE(robot.get("/maps/").status, 500);
    QCOMPARE(robot.get("/maps").status, 500);
    for (const char* fault : {"zero-resolution", "negative-resolution", "no-resolution", "no-origin"}) {
      faults = {};
      faults.grid_fault = fault;
      robot.setFaults(faults);
      const QJsonObject detail = object(robot.get("/maps/1").body);
      const QJsonValue resolution = detail[QLatin1String("grid_resolution")];
      if (faults.grid_fault == "no-origin") {
        QVERIFY(!detail.contains(QLatin1String("grid_origin_x")) && resolution.toDouble() > 0);
      } else {
        QVERIFY(detail.contains(QLatin1String("grid_origin_x")) && resolution.toDouble() <= 0);
      }
    }
  }
};

}  // namespace test_maps

MAPWRIGHT_TEST(test_maps, TestMaps, Core)
#include "test_maps.moc"
