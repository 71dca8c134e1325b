// KABAM's MapManagerV2: every service with every code, what each state allows, and the topics that tell of
// it.
#include <QTest>

#include "ros_socket.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_ros_kabam {

using namespace mapwright::simulator;

namespace {

constexpr const char* kInfo = "/map_manager/current_map_info";
constexpr const char* kList = "/map_manager/map_list";
constexpr const char* kArchived = "/map_manager/archived_map_list";
constexpr const char* kWaypoints = "/map_manager/current_map_waypoints";

class Kabam : public RosRobot {
 public:
  explicit Kabam(const Options& options = still()) : RosRobot(options) {
    for (const char* topic : {kInfo, kList, kArchived, kWaypoints}) {
      client->subscribe(topic);
      client->first(topic);
    }
  }
  /// Asks a service of the map manager for its code.
  int code(const char* verb, const QByteArray& args) {
    return client->result("/map_manager/" + QByteArray(verb), args);
  }
  QByteArray map(int index) const {
    return at(client->last(kList), "maps").toArray().at(index)[QLatin1String("map_id")].toString().toUtf8();
  }
  QByteArray archived() const { return at(client->last(kArchived), "maps.0.map_id").toString().toUtf8(); }
  QByteArray current() const { return at(client->last(kInfo), "map_id").toString().toUtf8(); }
  QString state() const { return at(client->last(kInfo), "map_manager_state").toString(); }
  QJsonArray waypoints() const { return at(client->last(kWaypoints), "waypoints").toArray(); }
  QJsonObject waypoint(int index) const { return waypoints().at(index).toObject(); }
  /// {"waypoint_info":{...}} of a waypoint with some members changed.
  static QByteArray info(QJsonObject waypoint, const QJsonObject& changes = {}, bool flag = false) {
    for (auto it = changes.begin(); it != changes.end(); ++it) waypoint[it.key()] = it.value();
    return QJsonDocument(QJsonObject{{QStringLiteral("waypoint_info"), waypoint},
                                     {QStringLiteral("delete_waypoint"), flag}})
        .toJson(QJsonDocument::Compact);
  }
  static QJsonObject named(const char* name) { return {{QStringLiteral("name"), QLatin1String(name)}}; }
};

/// ,"name":"value"
QByteArray member(const char* name, const QString& value) {
  return QByteArrayLiteral(",\"%1\":\"%2\"").replace("%1", name).replace("%2", value.toUtf8());
}

QByteArray id(const QByteArray& map, const QByteArray& more = {}) {
  return '{' + member("map_id", QString::fromUtf8(map)).mid(1) + more + '}';
}

/// ,"updated_image":{...}
QByteArray image(int width, int height, const QByteArray& data, const char* encoding = "mono8") {
  const QJsonObject image{{QStringLiteral("width"), width},
                          {QStringLiteral("height"), height},
                          {QStringLiteral("step"), width},
                          {QStringLiteral("encoding"), QLatin1String(encoding)},
                          {QStringLiteral("data"), QLatin1String(data.toBase64())}};
  return ",\"updated_image\":" + QJsonDocument(image).toJson(QJsonDocument::Compact);
}

}  // namespace

class TestRosKabam : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTopicsTellOfMapsAndWaypoints() {
    Kabam robot;
    QCOMPARE(robot.state(), QStringLiteral("ACTIVE"));
    QCOMPARE(at(robot->last(kList), "maps").toArray().size(), 3);
    QCOMPARE(at(robot->last(kArchived), "maps").toArray().size(), 1);
    QCOMPARE(robot.waypoints().size(), 12);
    QCOMPARE(robot.current(), robot.map(0));
    for (const char* member : {"map_name", "map_label", "updated_at", "created_at"})
      QVERIFY2(!at(robot->last(kInfo), member).toString().isEmpty(), member);
    QVERIFY(at(robot.waypoint(0), "waypoint_tags").toArray().contains(QLatin1String("localisation")));
    QCOMPARE(at(robot.waypoint(0), "map_id").toString().toUtf8(), robot.current());
    Options options = RosRobot::still();
    options.ros.waypoints = 500;
    QCOMPARE(Kabam(options).waypoints().size(), 500);
  }

  void mappingStartsOnceAndEndsOnce() {
    Kabam robot;
    const auto trigger = [&](const char* verb) {
      return at(robot->values("/map_manager/" + QByteArray(verb)), "success").toBool();
    };
    QVERIFY(!trigger("stop_mapping"));
    QVERIFY(trigger("start_mapping"));
    QTRY_COMPARE(robot.state(), QStringLiteral("MAPPING"));
    QCOMPARE(robot.waypoints().size(), 0);
    QVERIFY(!trigger("start_mapping"));
    QVERIFY(trigger("stop_mapping"));
    QTRY_COMPARE(robot.state(), QStringLiteral("IDLE"));
    QVERIFY(!trigger("stop_mapping"));
  }

  void onlyWhatWasMappedIsSaved() {
    Kabam robot;
    QCOMPARE(robot.code("save_map", R"({"map_name":"new"})"), 1);  // nothing was mapped
    robot->values("/map_manager/start_mapping");
    robot.robot.advance(20);
    robot->values("/map_manager/stop_mapping");
    QCOMPARE(robot.code("save_map", R"({"map_name":""})"), 1);
    QCOMPARE(robot.code("save_map", R"({"map_name":"annex"})"), 2);
    const QJsonObject saved = robot->values("/map_manager/save_map", R"({"map_name":"new"})");
    QCOMPARE(at(saved, "result").toInt(-1), 0);
    QTRY_COMPARE(at(robot->last(kList), "maps").toArray().size(), 4);
    QCOMPARE(robot.map(3), at(saved, "map_id").toString().toUtf8());
    QCOMPARE(robot.code("save_map", R"({"map_name":"newer"})"), 1);  // it has been saved
    robot->subscribe("/map");
    QCOMPARE(robot.code("load_map", id(robot.map(3))), 0);
    QVERIFY(!robot->first("/map").isEmpty());
  }

  void aMapIsLoadedUnlessSomethingForbidsIt() {
    Kabam robot;
    QCOMPARE(robot.code("load_map", id("no-such-map")), 1);
    QCOMPARE(robot.code("load_map", id(robot.map(0))), 2);
    QCOMPARE(robot.code("load_map", id("")), 3);
    QCOMPARE(robot.code("load_map", id(robot.archived())), 3);
    QCOMPARE(robot.code("load_map", id(robot.map(1), R"(,"loc_waypoint_name":"Nowhere")")), 3);
    QCOMPARE(robot.code("load_map", id(robot.map(1), R"(,"loc_waypoint_name":"Start")")), 0);
    QTRY_COMPARE(robot.current(), robot.map(1));
    QCOMPARE(robot.waypoints().size(), 1);
    const QString other = QStringLiteral("Café");  // is there, but not to find one's place by
    QCOMPARE(robot.code("load_map", id(robot.map(0), member("loc_waypoint_name", other))), 3);
    robot->values("/map_manager/start_mapping");
    QCOMPARE(robot.code("load_map", id(robot.map(0))), 3);
    robot->values("/map_manager/stop_mapping");
    QCOMPARE(robot.code("load_map", id(robot.map(0))), 0);
    QTRY_COMPARE(robot.state(), QStringLiteral("ACTIVE"));
  }

  void aMapIsDeletedButNotTheCurrentOne() {
    Kabam robot;
    QCOMPARE(robot.code("delete_map", id("none", R"(,"delete_map":true)")), 2);
    QCOMPARE(robot.code("delete_map", id(robot.map(0), R"(,"delete_map":true)")), 3);
    QCOMPARE(robot.code("delete_map", id(robot.map(1))), 1);  // the flag is not needed here
    QTRY_COMPARE(at(robot->last(kList), "maps").toArray().size(), 2);
    robot->values("/map_manager/start_mapping");
    QCOMPARE(robot.code("delete_map", id(robot.map(1), R"(,"delete_map":true)")), 3);
  }

  void aMapIsArchivedAndBroughtBack() {
    Kabam robot;
    QCOMPARE(robot.code("archive_map", id("none", R"(,"set_archive":true)")), 2);
    QCOMPARE(robot.code("archive_map", id(robot.map(0), R"(,"set_archive":true)")), 3);
    const QByteArray map = robot.map(1);
    QCOMPARE(robot.code("archive_map", id(map, R"(,"set_archive":true)")), 0);
    QTRY_COMPARE(at(robot->last(kArchived), "maps").toArray().size(), 2);
    QTRY_COMPARE(at(robot->last(kList), "maps").toArray().size(), 2);
    QCOMPARE(robot.code("archive_map", id(map, R"(,"set_archive":false)")), 0);
    QTRY_COMPARE(at(robot->last(kList), "maps").toArray().size(), 3);
  }

  void aMapIsCalledOtherwise() {
    Kabam robot;
    QCOMPARE(robot.code("rename_map", id("none", R"(,"new_map_label":"New")")), 2);
    QCOMPARE(robot.code("rename_map", id(robot.map(0))), 3);
    const QByteArray in_use = member("new_map_label", QStringLiteral("Anbau Süd"));
    QCOMPARE(robot.code("rename_map", id(robot.map(0), in_use)), 3);
    QCOMPARE(robot.code("rename_map", id(robot.map(0), R"(,"new_map_label":"New")")), 0);
    QTRY_COMPARE(at(robot->last(kInfo), "map_label").toString(), QStringLiteral("New"));
    QCOMPARE(at(robot->last(kInfo), "map_name").toString(), QStringLiteral("ground_floor"));
    QTRY_COMPARE(at(robot->last(kList), "maps.0.map_label").toString(), QStringLiteral("New"));
  }

  void aPictureReplacesTheMapsCells() {
    Kabam robot;
    robot->subscribe("/map");
    const QJsonObject map = robot->first("/map");
    const int width = at(map, "info.width").toInt(), height = at(map, "info.height").toInt();
    QByteArray cells(qsizetype(width) * height, char(254));
    cells[0] = 0;  // top left
    cells[1] = char(205);
    QCOMPARE(robot.code("update_map_image", id("none", image(width, height, cells))), 2);
    QCOMPARE(robot.code("update_map_image", id(robot.map(0), image(height, width + 1, cells))), 3);
    QCOMPARE(robot.code("update_map_image", id(robot.map(0), image(width, height, cells.chopped(1)))), 3);
    QCOMPARE(robot.code("update_map_image", id(robot.map(0), image(width, height, cells, "rgb8"))), 3);
    QCOMPARE(robot->count("/map"), 1);
    QCOMPARE(robot.code("update_map_image", id(robot.map(0), image(width, height, cells))), 0);
    QTRY_COMPARE(robot->count("/map"), 2);
    const QJsonArray now = at(robot->last("/map"), "data").toArray();
    QCOMPARE(now[qsizetype(width) * (height - 1)].toInt(), 100);
    QCOMPARE(now[qsizetype(width) * (height - 1) + 1].toInt(), -1);
    QCOMPARE(now[0].toInt(), 0);
  }

  void aPictureMayComeInPieces() {
    Kabam robot;
    robot->subscribe("/map");
    const QJsonObject map = robot->first("/map");
    const int width = at(map, "info.width").toInt(), height = at(map, "info.height").toInt();
    const QByteArray cells(qsizetype(width) * height, char(254));
    const QByteArray whole =
        R"({"op":"call_service","id":"p","service":"/map_manager/update_map_image","args":)" +
        id(robot.map(0), image(width, height, cells)) + '}';
    constexpr qsizetype kPiece = 10'000;
    const qsizetype total = (whole.size() + kPiece - 1) / kPiece;
    for (qsizetype i = total; i-- > 0;) {  // in whatever order
      const QJsonObject piece{{QStringLiteral("op"), QStringLiteral("fragment")},
                              {QStringLiteral("id"), QStringLiteral("p")},
                              {QStringLiteral("num"), i},
                              {QStringLiteral("total"), total},
                              {QStringLiteral("data"), QString::fromUtf8(whole.mid(i * kPiece, kPiece))}};
      robot->send(QJsonDocument(piece).toJson(QJsonDocument::Compact));
    }
    QCOMPARE(at(robot->answerTo(QStringLiteral("p")), "values.result").toInt(), 0);
    QTRY_COMPARE(robot->count("/map"), 2);
  }

  void somebodyElseMayPaint() {
    Kabam robot;
    robot->subscribe("/map");
    const QJsonArray before = at(robot->first("/map"), "data").toArray();
    robot.robot.otherPainter();
    QTRY_COMPARE(robot->count("/map"), 2);
    QVERIFY(at(robot->last("/map"), "data").toArray() != before);
    robot.robot.otherPainter();
    QTRY_COMPARE(robot->count("/map"), 3);
  }

  void aPictureMayBeRefusedOrIgnored() {
    Options options = RosRobot::still();
    options.faults.requests = {{FaultKind::Refuse, kWrites, 1, 4, "/map_manager/update_map_image"}};
    QCOMPARE(Kabam(options).code("update_map_image", "{}"), 4);
    options.faults.requests = {{FaultKind::Ignore, kWrites, 1, 0, "/map_manager/update_map_image"}};
    Kabam robot(options);
    robot->subscribe("/map");
    const QJsonObject map = robot->first("/map");
    const int width = at(map, "info.width").toInt(), height = at(map, "info.height").toInt();
    const QByteArray cells(qsizetype(width) * height, char(254));
    QCOMPARE(robot.code("update_map_image", id(robot.map(0), image(width, height, cells))), 0);
    QVERIFY(robot->settle());
    QCOMPARE(robot->count("/map"), 1);
  }

  void waypointsAreCreatedWithAnIdOfTheRobots() {
    Kabam robot;
    const QJsonObject like = robot.waypoint(0);
    QCOMPARE(robot.code("create_waypoint", Kabam::info(like)), 2);
    QCOMPARE(robot.code("create_waypoint",
                        Kabam::info(like, {{QStringLiteral("map_id"), QStringLiteral("none")}})),
             1);
    QCOMPARE(robot.code("create_waypoint", Kabam::info(like, Kabam::named(""))), 6);
    const QJsonObject made =
        robot->values("/map_manager/create_waypoint", Kabam::info(like, Kabam::named("New")));
    QCOMPARE(at(made, "result").toInt(-1), 0);
    QVERIFY(at(made, "waypoint_response.id") != at(like, "id"));
    QCOMPARE(at(made, "waypoint_response.pose"), at(like, "pose"));
    QTRY_COMPARE(robot.waypoints().size(), 13);
    QCOMPARE(robot.waypoint(12), at(made, "waypoint_response").toObject());
  }

  void waypointsAreDeleted() {
    Kabam robot;
    const QJsonObject first = robot.waypoint(3);
    QCOMPARE(robot.code("delete_waypoint",
                        Kabam::info(first, {{QStringLiteral("map_id"), QStringLiteral("none")}})),
             1);
    QCOMPARE(
        robot.code("delete_waypoint", Kabam::info(first, {{QStringLiteral("id"), QStringLiteral("none")}})),
        4);
    QCOMPARE(robot.code("delete_waypoint", Kabam::info(first)), 5);
    QTRY_COMPARE(robot.waypoints().size(), 11);
    QCOMPARE(robot.code("delete_waypoint", Kabam::info(first)), 4);
  }

  void waypointsAreRenamedAndMoved() {
    Kabam robot;
    const QJsonObject first = robot.waypoint(1);
    QCOMPARE(
        robot.code("rename_waypoint", Kabam::info(first, {{QStringLiteral("id"), QStringLiteral("none")}})),
        4);
    QCOMPARE(robot.code("rename_waypoint", Kabam::info(first, Kabam::named("Start"))), 2);
    QCOMPARE(robot.code("rename_waypoint", Kabam::info(first, Kabam::named(""))), 6);
    QCOMPARE(robot.code("rename_waypoint",
                        Kabam::info(first, {{QStringLiteral("map_id"), QStringLiteral("none")}})),
             1);
    QJsonObject pose = at(first, "pose").toObject();
    pose[QStringLiteral("position")] =
        QJsonObject{{QStringLiteral("x"), 7.5}, {QStringLiteral("y"), -2}, {QStringLiteral("z"), 0}};
    const QJsonObject moved{
        {QStringLiteral("pose"), pose},
        {QStringLiteral("name"), QStringLiteral("Elsewhere")},
        {QStringLiteral("waypoint_tags"), QJsonArray{QStringLiteral("a"), QStringLiteral("b")}}};
    QCOMPARE(robot.code("rename_waypoint", Kabam::info(first, moved)),
             3);  // the name and the tags, not the pose
    QTRY_COMPARE(at(robot.waypoint(1), "name").toString(), QStringLiteral("Elsewhere"));
    QCOMPARE(at(robot.waypoint(1), "pose"), at(first, "pose"));
    QCOMPARE(at(robot.waypoint(1), "waypoint_tags").toArray().size(), 2);
    QCOMPARE(robot.code("reposition_waypoint", Kabam::info(first, {{QStringLiteral("pose"), pose}})), 3);
    QTRY_COMPARE(at(robot.waypoint(1), "pose.position.x").toDouble(), 7.5);
    QCOMPARE(at(robot.waypoint(1), "name").toString(), QStringLiteral("Elsewhere"));
    QCOMPARE(robot.code("reposition_waypoint", Kabam::info(first, {{QStringLiteral("id"), QString()}})), 4);
  }

  void waypointsOfAnyMapAreAskedFor() {
    Kabam robot;
    const auto ask = [&](const QByteArray& args) {
      return at(robot->values("/map_manager/get_waypoint", args), "waypoints.waypoints").toArray();
    };
    QCOMPARE(ask(id(robot.map(0))), robot.waypoints());
    QCOMPARE(ask(id(robot.map(2))).size(), 1);
    QCOMPARE(ask(id("none")).size(), 0);
    const QByteArray one = member("waypoint_id", at(robot.waypoint(4), "id").toString());
    QCOMPARE(ask(id(robot.map(0), one)), QJsonArray{robot.waypoint(4)});
  }

  void whatTheDocumentLeavesOpenIsChosen() {
    Options options = RosRobot::still();
    options.ros.kabam_list_holds_archived = options.ros.kabam_needs_flags =
        options.ros.kabam_empty_tags_keep = true;
    Kabam robot(options), plain;
    QCOMPARE(at(robot->last(kList), "maps").toArray().size(), 4);
    QCOMPARE(robot.code("delete_map", id(robot.map(1))), 3);
    QCOMPARE(robot.code("delete_map", id(robot.map(1), R"(,"delete_map":true)")), 1);
    QCOMPARE(robot.code("delete_waypoint", Kabam::info(robot.waypoint(3))), 6);
    QCOMPARE(robot.code("delete_waypoint", Kabam::info(robot.waypoint(3), {}, true)), 5);
    const QJsonObject no_tags{{QStringLiteral("waypoint_tags"), QJsonArray{}}};
    for (Kabam* one : {&robot, &plain}) {
      QCOMPARE(one->code("rename_waypoint", Kabam::info(one->waypoint(0), no_tags)), 3);
      QVERIFY((*one)->settle());
    }
    QCOMPARE(at(robot.waypoint(0), "waypoint_tags").toArray().size(), 2);
    QTRY_COMPARE(at(plain.waypoint(0), "waypoint_tags").toArray().size(), 0);
  }

  void aChangeIsToldBeforeItsAnswerOrAfterIt() {
    Kabam robot;
    QSet<bool> before;
    for (const char* label : {"A", "B"}) {
      robot->order.clear();
      const qsizetype known = robot->count(kList);
      QCOMPARE(robot.code("rename_map", id(robot.map(0), member("new_map_label", QLatin1String(label)))), 0);
      QTRY_COMPARE(robot->count(kList), known + 1);
      before.insert(robot->order.indexOf(QLatin1String(kList)) <
                    robot->order.indexOf(QLatin1String("service_response")));
    }
    QCOMPARE(before.size(), 2);
  }
};

}  // namespace test_ros_kabam

MAPWRIGHT_TEST(test_ros_kabam, TestRosKabam, Core)
#include "test_ros_kabam.moc"
