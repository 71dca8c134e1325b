// Files of waypoints as people have them: what they say is read, and what is not read is named.
#include <cmath>
#include <random>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "exchange/waypoint_file.h"
#include "exchange/waypoint_table.h"
#include "test_program.h"

namespace test_waypoint_files {

using namespace mapwright::exchange;
using mapwright::map::Waypoint;

namespace {

constexpr double kPi = 3.14159265358979323846;

WantedFile reading(std::string_view bytes, AngleUnit angles = AngleUnit::Guess) {
  return wantedFromFile(bytes, waypointFormatOf(bytes), angles);
}

/// Empty where it was refused.
WantedList read(std::string_view bytes, AngleUnit angles = AngleUnit::Guess) {
  const WantedFile file = reading(bytes, angles);
  if (!file) qWarning("%s", qPrintable(file.error()));
  return file.value_or(WantedList{});
}

QString saidOf(const WantedList& list) { return list.notes.join(QLatin1Char(' ')); }

std::string feature(const char* properties, const char* coordinates = "[1, 2]") {
  return std::string(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )") +
         properties + R"(, "geometry": {"type": "Point", "coordinates": )" + coordinates + "}}]}";
}

bool isAt(const WantedWaypoint& point, double x, double y) {
  return point.position_m && std::abs(point.position_m->x() - x) < 1e-9 &&
         std::abs(point.position_m->y() - y) < 1e-9;
}
bool isTurned(const WantedWaypoint& point, double yaw_rad) {
  return point.yaw_rad && *point.yaw_rad &&
         std::abs(std::remainder(**point.yaw_rad - yaw_rad, 2 * kPi)) < 1e-6;
}

/// A field of a random file: what is written, and what must come of it.
struct Field {
  std::string name;
  QJsonValue value;
  bool known = true;
};

}  // namespace

class TestWaypointFiles : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void headingsAreReadWhateverTheyAreCalled_data() {
    QTest::addColumn<QByteArray>("properties");
    QTest::addColumn<double>("yaw_rad");
    QTest::addColumn<bool>("guessed");
    const auto row = [](const char* properties, double yaw, bool guessed) {
      QTest::newRow(properties) << QByteArray(properties) << yaw << guessed;
    };
    row(R"({"yaw_rad": 1.57})", 1.57, false);
    row(R"({"yaw_deg": 90})", kPi / 2, false);
    row("{\"Heading (deg)\": -90}", -kPi / 2, false);
    row(R"({"yaw": 1.57})", 1.57, true);
    row(R"({"heading": 270})", -kPi / 2, true);
    row(R"({"theta": -0.5})", -0.5, true);
    row(R"({"yaw": 0})", 0, false);
    row(R"({"orientation": {"x": 0, "y": 0, "z": 0.7071068, "w": 0.7071068}})", kPi / 2, false);
    row(R"({"orientation": [0, 0, 0.7071068, 0.7071068]})", kPi / 2, false);
    row(R"({"orientation": [0.7071068, 0, 0, 0.7071068]})", kPi / 2, false);
    row(R"({"pose": {"orientation": {"x": 0, "y": 0, "z": 1, "w": 0}}})", kPi, false);
    row(R"({"qz": 0.7071068, "qw": 0.7071068})", kPi / 2, false);
    row(R"({"rotation": 2.5})", 2.5, true);
  }
  void headingsAreReadWhateverTheyAreCalled() {
    QFETCH(QByteArray, properties);
    QFETCH(double, yaw_rad);
    QFETCH(bool, guessed);
    const WantedList list = read(feature(properties.constData()));
    QCOMPARE(list.points.size(), std::size_t(1));
    QVERIFY(isTurned(list.points.front(), yaw_rad));
    QCOMPARE(list.unit_guessed, guessed);
    QCOMPARE(saidOf(list).contains(QLatin1String("unit of the headings")), guessed);
    QVERIFY2(!saidOf(list).contains(QLatin1String("no place for it")), qPrintable(saidOf(list)));
  }

  void theUnitOfAFileIsTheSameForAllOfIt() {
    const std::string_view csv = "name,x,y,yaw\na,0,0,1\nb,0,1,2\nc,0,2,180\n";
    const WantedList list = read(csv);
    QVERIFY(isTurned(list.points[0], kPi / 180) && isTurned(list.points[2], kPi));
    QVERIFY(saidOf(list).contains(QLatin1String("degrees: 180")));
    QVERIFY(isTurned(read(csv, AngleUnit::Radians).points[2], 180));
    QVERIFY(isTurned(read("name,x,y,yaw\na,0,0,3\n", AngleUnit::Degrees).points[0], 3 * kPi / 180));
    QVERIFY(!read(csv, AngleUnit::Degrees).unit_guessed);
  }

  void headingsThatCannotBeAreSaid() {
    QVERIFY(saidOf(read("name,yaw_rad\na,90\n")).contains(QLatin1String("more than a full turn")));
    QVERIFY(saidOf(read(feature(R"({"orientation": {"x": 0, "y": 0, "z": 0, "w": 0}})")))
                .contains(QLatin1String("no rotation")));
    const WantedList tilted = read(feature(R"({"orientation": {"x": 0.5, "y": 0, "z": 0.5, "w": 0.7071}})"));
    QVERIFY(saidOf(tilted).contains(QLatin1String("tilted")));
    // Two headings: the one with a unit counts, the other is named.
    const WantedList two = read(feature(R"({"yaw_deg": 90, "theta": 3})"));
    QVERIFY(isTurned(two.points.front(), kPi / 2) && saidOf(two).contains(QLatin1String("theta")));
    QVERIFY(reading(feature(R"({"yaw": "north"})")).error().contains(QLatin1String("yaw \"north\"")));
    // A compass turns the other way.
    const WantedList compass = read(feature(R"({"bearing": 90})"));
    QVERIFY(!compass.points.front().yaw_rad && saidOf(compass).contains(QLatin1String("bearing")));
  }

  void longitudeAndLatitudeAreRefused_data() {
    QTest::addColumn<QByteArray>("file");
    const auto with_crs = [](const char* crs) {
      QByteArray file = QByteArray::fromStdString(feature(R"({"name": "A"})", "[24.9384, 60.1699]"));
      return file.replace("\"features\"", QByteArray("\"crs\": ") + crs + ", \"features\"");
    };
    for (const char* name : {"EPSG:4326", "urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::4326",
                             "EPSG:4258", "http://www.opengis.net/def/crs/OGC/1.3/CRS84"})
      QTest::newRow(name) << with_crs(
          (R"({"type": "name", "properties": {"name": ")" + std::string(name) + R"("}})").c_str());
    QTest::newRow("a text") << with_crs(R"("EPSG:4326")");
    QTest::newRow("a code") << with_crs(R"({"type": "EPSG", "properties": {"code": 4326}})");
    for (const char* properties :
         {R"({"longitude": 24.9384, "latitude": 60.1699})", R"({"lat": 60.1699, "lon": 24.9384})",
          R"({"crs": "EPSG:4326"})", R"({"frame": "wgs84"})"})
      QTest::newRow(properties) << QByteArray::fromStdString(feature(properties, "[24.9384, 60.1699]"));
    QTest::newRow("all within 5 cm") << QByteArray(
        R"({"type": "FeatureCollection", "features": [)"
        R"({"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [24.9384, 60.1699]}},)"
        R"({"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [24.9401, 60.1702]}}]})");
    QTest::newRow("columns") << QByteArray("name,lat,lon\nA,60.1699,24.9384\n");
    QTest::newRow("yaml") << QByteArray("waypoints:\n- {latitude: 60.1699, longitude: 24.9384, yaw: 0.0}\n");
  }
  void longitudeAndLatitudeAreRefused() {
    QFETCH(QByteArray, file);
    const WantedFile wanted = reading(file.toStdString());
    QVERIFY(!wanted);
    QVERIFY2(wanted.error().contains(QLatin1String("longitude and latitude")) ||
                 wanted.error().contains(QLatin1String("frame is \"wgs84\"")),
             qPrintable(wanted.error()));
  }

  void metresAreReadAndAGuessIsSaid() {
    const WantedList ours = read(feature(R"({"name": "A", "frame": "map"})"));
    QVERIFY2(ours.notes.isEmpty(), qPrintable(saidOf(ours)));
    QVERIFY(saidOf(read(feature(R"({"name": "A"})"))).contains(QLatin1String("metres of the map")));
    // Two systems of coordinates beside each other: those of the map count.
    const WantedList both = read(feature(R"({"name": "A", "lat": 60.1, "lon": 24.9})"));
    QVERIFY(isAt(both.points.front(), 1, 2) && saidOf(both).contains(QLatin1String("lat")));
  }

  void whatIsLeftOutOfGeoJsonIsNamed() {
    const WantedList list = read(
        R"({"type": "FeatureCollection", "name": "yard", "features": [)"
        R"({"type": "Feature", "bbox": [0, 0, 1, 1], "properties": {"name": "A", "colour": "red", "x": 9, "meta": {"a": 1}},)"
        R"( "geometry": {"type": "Point", "coordinates": [1, 2, 3]}},)"
        R"({"type": "Feature", "properties": {}, "geometry": null}]})");
    QCOMPARE(list.points.size(), std::size_t(1));
    for (const char* word : {"name, bbox", "colour", "meta", "(z)", "left out", "The coordinates count"})
      QVERIFY2(saidOf(list).contains(QLatin1String(word)), word);
  }

  void membersThatAreWrittenTwiceAreRefused() {
    const char* const head =
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )";
    const char* const tail = R"(, "geometry": {"type": "Point", "coordinates": [1, 2]}}])";
    const auto wanted = [&](const std::string& properties, const std::string& more) {
      return wantedFromFile(head + properties + tail + more + "}", WaypointFormat::Json, AngleUnit::Guess);
    };
    QVERIFY(wanted(R"({"name": "A", "x": {"name": 1}})", ""));
    for (const auto& twice :
         {wanted(R"({"name": "A", "name": "B"})", ""), wanted(R"({"name": "A"})", R"(, "features": [])"),
          wantedFromFile(R"([{"name": "A", "x": 1, "y": 2, "x": 3}])", WaypointFormat::Json,
                         AngleUnit::Guess)}) {
      QVERIFY(!twice);
      QVERIFY2(twice.error().contains(QLatin1String("twice")), qPrintable(twice.error()));
    }
  }

  void ofTwoIdsTheOneThatIsLeftOutIsNamed() {
    for (const char* id : {"7", "8"}) {
      const WantedList list = read(
          R"({"type": "FeatureCollection", "features": [{"type": "Feature", "id": 7, "properties": {"frame": "map", "id": ")" +
          std::string(id) + R"("}, "geometry": {"type": "Point", "coordinates": [1, 2]}}]})");
      QCOMPARE(list.points.front().id, std::string(id));
      QCOMPARE(saidOf(list).contains(QLatin1String("left out"), Qt::CaseInsensitive), *id == '8');
    }
  }

  void aGeometryAloneIsNoList() {
    const WantedFile wanted =
        wantedFromFile(R"({"type": "Point", "coordinates": [1, 2]})", WaypointFormat::Json, AngleUnit::Guess);
    QVERIFY(!wanted);
    QVERIFY2(wanted.error().contains(QLatin1String("FeatureCollection")), qPrintable(wanted.error()));
  }

  void nodesOfARouteGraphAreRead() {
    const WantedList list = read(
        R"({"type": "FeatureCollection", "name": "graph", "crs": {"type": "name", "properties": {"name": )"
        R"("urn:ogc:def:crs:EPSG::3857"}}, "features": [)"
        R"({"type": "Feature", "properties": {"id": 1}, "geometry": {"type": "Point", "coordinates": [-0.6, -1.6]}},)"
        R"({"type": "Feature", "properties": {"id": 2, "frame": "map"}, "geometry": {"type": "Point", "coordinates": [0.6, -1.6]}},)"
        R"({"type": "Feature", "properties": {"id": 3, "startid": 1, "endid": 2}, "geometry": {"type": "MultiLineString", )"
        R"("coordinates": [[[-0.6, -1.6], [0.6, -1.6]]]}}]})");
    QCOMPARE(list.points.size(), std::size_t(2));
    QVERIFY(isAt(list.points[1], 0.6, -1.6));
    QCOMPARE(*list.points[1].name, std::string("Node 2"));
    QVERIFY(list.points[1].id.empty());  // of the graph, not of the map
    for (const char* word : {"1 edge", "2 nodes", "3857"})
      QVERIFY2(saidOf(list).contains(QLatin1String(word)), word);
  }

  void listsOfPosesAreRead_data() {
    QTest::addColumn<QByteArray>("file");
    const auto row = [](const char* name, const char* file) { QTest::newRow(name) << QByteArray(file); };
    // All of them say the same: dock at (1.25, -4.5), turned by 90 degrees.
    row("fields", "- {name: dock, x: 1.25, y: -4.5, yaw: 1.5707963}\n");
    row("under waypoints", "waypoints:\n  - name: dock\n    x: 1.25\n    y: -4.5\n    theta: 1.5707963\n");
    row("pose",
        "waypoints:\n- name: dock\n  pose:\n    position: {x: 1.25, y: -4.5, z: 0.0}\n"
        "    orientation: {x: 0.0, y: 0.0, z: 0.7071068, w: 0.7071068}\n");
    row("stamped",
        "poses:\n- name: dock\n  header: {frame_id: map}\n  pose:\n    position: {x: 1.25, y: -4.5, z: 0.0}\n"
        "    orientation: {x: 0.0, y: 0.0, z: 0.7071068, w: 0.7071068}\n");
    row("by name", "dock: [1.25, -4.5, 1.5707963]\n");
    row("by name, fields", "locations:\n  dock: {x: 1.25, y: -4.5, yaw_deg: 90}\n");
    row("seven numbers", "dock: [1.25, -4.5, 0, 0, 0, 0.7071068, 0.7071068]\n");
    row("two lists",
        "goals:\n- name: dock\n  position: [1.25, -4.5, 0.0]\n  orientation: [0, 0, 0.7071068, 0.7071068]\n");
    row("rviz",
        "waypoints:\n  dock:\n    pose: [1.25, -4.5, 0]\n    orientation: [0.7071068, 0, 0, 0.7071068]\n");
    row("name first", "waypoints:\n- [dock, 1.25, -4.5, 1.5707963]\n");
    row("single names", "places:\n- dock: {x: 1.25, y: -4.5, yaw: 1.5707963}\n");
    row("deep",
        "robot:\n  ros__parameters:\n    goals:\n    - {label: dock, x: 1.25, y: -4.5, yaw: 1.5707963}\n");
    row("own container", "- name: dock\n  coords: {x: 1.25, y: -4.5}\n  yaw: 1.5707963\n");
    row("an alias", "a: &here {x: 1.25, y: -4.5, yaw: 1.5707963}\nwaypoints: {dock: *here}\n");
    row("JSON", R"([{"name": "dock", "x": 1.25, "y": -4.5, "yaw": 1.5707963}])");
    row("JSON by name", R"({"dock": {"x": 1.25, "y": -4.5, "yaw": 1.5707963}})");
    row("documents", "---\nname: dock\npoint: {x: 1.25, y: -4.5}\nyaw: 1.5707963\n---\n");
    row("graph",
        "levels:\n  L1:\n    lanes: []\n    vertices:\n    - [1.25, -4.5, {name: dock, yaw: 1.5707963}]\n");
  }
  void listsOfPosesAreRead() {
    QFETCH(QByteArray, file);
    const WantedList list = read(file.toStdString());
    QVERIFY(!list.points.empty());
    const WantedWaypoint& dock = list.points.back();
    QCOMPARE(QString::fromStdString(dock.name.value_or("")), QStringLiteral("dock"));
    QVERIFY(isAt(dock, 1.25, -4.5));
    QVERIFY(isTurned(dock, kPi / 2));
    QVERIFY2(!saidOf(list).contains(QLatin1String("no place for it")), qPrintable(saidOf(list)));
  }

  void listsWithoutNamesAreRead() {
    const WantedList list = read(
        "waypoints:\n- orientation: {w: 0.7071, x: 0.0, y: 0.0, z: 0.7071}\n  position: {x: 1.25, y: -4.5, "
        "z: "
        "0.0}\n");
    QVERIFY(isAt(list.points.front(), 1.25, -4.5) && isTurned(list.points.front(), kPi / 2));
    QVERIFY(!list.points.front().name && list.notes.isEmpty());
  }

  void whatIsNoListOfPosesIsRefusedByName_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const char* file, const char* says) {
      QTest::newRow(name) << QByteArray(file) << QString::fromLatin1(says);
    };
    row("building",
        "name: building\nlevels:\n  L1:\n    drawing: {filename: map.png}\n    vertices:\n"
        "      - [2951.4, 368.3, 0, magni1_charger, {is_charger: [4, true]}]\n",
        "building map of Open-RMF");
    row("map", "image: a.pgm\nresolution: 0.05\norigin: [1, 2, 0]\n", "map.yaml");
    row("frame", "- {name: a, x: 1, y: 2, frame_id: odom}\n", "Waypoint 1: the frame is \"odom\"");
    row("whole frame", "frame_id: odom\nwaypoints:\n- {x: 1, y: 2}\n", "frame is \"odom\"");
    row("flat", "waypoints: [1, 2, 0]\n", "flat list");
    row("words", "- hello\n", "Waypoint 1");
    row("nothing", "a: 1\nb: 2\n", "No waypoints were found");
    row("four numbers", "dock: [1, 2, 3, 4]\n", "Waypoint 1 (dock): the list is no pose");
    row("no number", "- {x: 1, y: north}\n", "x \"1\" and y \"north\"");
    row("what follows", "- {x: 1, y: 2}\nfoo: bar\n", "not YAML");
    row("levels", "levels:\n  L1: {vertices: [[1, 2, {}]]}\n  L2: {vertices: [[1, 2, {}]]}\n",
        "several levels");
    row("a comma", "- [1,2]\n---\n,\n", "not YAML");
    row("itself", "a: &a {x: 1, y: 2, pose: *a}\n", "YAML");
  }
  void whatIsNoListOfPosesIsRefusedByName() {
    QFETCH(QByteArray, file);
    QFETCH(QString, says);
    const WantedFile wanted = wantedFromFile(file.toStdString(), WaypointFormat::Yaml, AngleUnit::Guess);
    QVERIFY(!wanted);
    QVERIFY2(wanted.error().contains(says), qPrintable(wanted.error()));
  }

  void partsThatAreMergedAreThere() {
    const WantedList list = read(
        "- &first {name: A, x: 1, y: 2, yaw: 1.5, tags: [hall], frame: map}\n"
        "- &second {<<: *first, name: B, type: stop, tags: [lift]}\n"
        "- {name: C, yaw: 0.5, <<: [*second, *first]}\n");
    QCOMPARE(list.points.size(), std::size_t(3));
    for (const auto& point : list.points) QVERIFY(isAt(point, 1, 2));
    QCOMPARE(list.points[1].yaw_rad.value(), std::optional<double>(1.5));
    QCOMPARE(list.points[1].tags.value(), std::vector<std::string>{"lift"});
    QCOMPARE(list.points[2].name.value(), std::string("C"));
    QCOMPARE(list.points[2].yaw_rad.value(), std::optional<double>(0.5));
    QCOMPARE(list.points[2].type.value(), std::string("stop"));
    QCOMPARE(list.points[2].tags.value(), std::vector<std::string>{"lift"});
  }

  void partsThatAreRepeatedWithoutEndAreRefused() {
    std::string bomb = "a: &a [1, 2, 3, 4, 5, 6, 7, 8, 9]\n";
    for (char c = 'b'; c <= 'j'; ++c)
      bomb += std::string(1, c) + ": &" + c + " [*" + char(c - 1) + ", *" + char(c - 1) + ", *" +
              char(c - 1) + ", *" + char(c - 1) + ", *" + char(c - 1) + ", *" + char(c - 1) + ", *" +
              char(c - 1) + ", *" + char(c - 1) + "]\n";
    QVERIFY(!wantedFromFile(bomb, WaypointFormat::Yaml, AngleUnit::Guess));
    std::string many;
    for (int i = 0; i < 1'500; ++i)
      many +=
          "a: &a [1,2,3,4,5,6,7,8,9]\nb: &b [*a,*a,*a,*a,*a,*a,*a,*a,*a]\nc: &c [*b,*b,*b,*b,*b,*b,*b]\nd: "
          "[*c,*c,*c]\n---\n";
    const WantedFile heavy = wantedFromFile(many, WaypointFormat::Yaml, AngleUnit::Guess);
    QVERIFY(!heavy && heavy.error().contains(QLatin1String("too large")));
    QVERIFY(!wantedFromFile(std::string(100'000, '['), WaypointFormat::Yaml, AngleUnit::Guess));
  }

  void tablesOfAllShapesAreRead() {
    const WantedList bare = read("x,y,yaw\n3.1,2.85,2.35\n1.4,2.85,1.57\n");
    QCOMPARE(bare.points.size(), std::size_t(2));
    QVERIFY(isAt(bare.points[0], 3.1, 2.85) && isTurned(bare.points[0], 2.35) && !bare.points[0].name);
    const WantedList semicolons = read("id;name;x;y;yaw_rad\n1;A;1,5;2,5;0\n");
    QVERIFY(isAt(semicolons.points[0], 1.5, 2.5) && semicolons.points[0].id == "1");
    QVERIFY(saidOf(semicolons).contains(QLatin1String("decimal points")));
    const WantedList numbers = read("1,2,0.5\n3,4,0.25\n");
    QVERIFY(isAt(numbers.points[1], 3, 4) && isTurned(numbers.points[1], 0.25));
    QVERIFY(saidOf(numbers).contains(QLatin1String("read as x, y, heading")));
    const WantedList poses = read("1,2,0,0,0,0.7071068,0.7071068\n3,4,0,0,0,0,1\n");
    QVERIFY(isAt(poses.points[0], 1, 2) && isTurned(poses.points[0], kPi / 2) &&
            isTurned(poses.points[1], 0));
    // Which of more numbers is the heading nobody knows.
    const WantedList more = read("1,2,0,1.5,3\n3,4,0,2.5,3\n");
    QVERIFY(isAt(more.points[0], 1, 2) && !more.points[0].yaw_rad);
    for (const char* word : {"column 3", "column 4", "column 5"})
      QVERIFY2(saidOf(more).contains(QLatin1String(word)), word);
    const WantedList commented = read("# way of the robot\n# x, y, theta\n1,2,0.5\n");
    QVERIFY(isAt(commented.points.at(0), 1, 2) && saidOf(commented).contains(QLatin1String("1 comment")));
    const WantedList columns = read("pos_x,pos_y,pos_z,ori_x,ori_y,ori_z,ori_w\n1,2,0,0,0,1,0\n");
    QVERIFY(isAt(columns.points.at(0), 1, 2) && isTurned(columns.points.at(0), kPi));
    const WantedList ragged = read("x,y,,\n1,2,3,\n");
    QVERIFY(saidOf(ragged).contains(QLatin1String("column 3")) &&
            !saidOf(ragged).contains(QLatin1String("column 4")));
  }

  void theSameFileTwiceChangesNothing() {
    std::mt19937 random(32);
    std::uniform_real_distribution<double> place(-20, 20);
    WaypointItems kept;
    std::vector<WantedWaypoint> wanted;
    for (int i = 0; i < 500; ++i) {
      Waypoint point;
      point.id = "k" + std::to_string(i);
      point.name = "Waypoint " + std::to_string(i + 1);
      point.position_m = {place(random), place(random)};
      point.yaw_rad = place(random) / 10;
      kept[point.id] = point;
      WantedWaypoint one;
      one.position_m = point.position_m + Eigen::Vector2d(4e-5, -4e-5);
      one.yaw_rad = point.yaw_rad;
      wanted.push_back(one);
    }
    wanted.push_back(wanted.front());  // a second one at the same place is another
    wanted.push_back(wanted[1]);
    wanted.back().yaw_rad = 3.0;
    knowByPlace(wanted, kept);
    for (int i = 0; i < 500; ++i) QCOMPARE(wanted[std::size_t(i)].id, "k" + std::to_string(i));
    QVERIFY(wanted[500].id.empty() && wanted[501].id.empty());
    QVERIFY(nameNameless(wanted, kept).startsWith(QLatin1String("2 waypoints")));
    QCOMPARE(*wanted[500].name, std::string("Waypoint 501"));
  }

  /// Whatever stands in a file is in the list afterwards, or named.
  void nothingIsLostInSilence() {
    std::mt19937 random(6);
    const auto pick = [&](int below) { return int(random() % unsigned(below)); };
    for (int round = 0; round < 400; ++round) {
      const double x = pick(2000) / 100.0 - 10, y = pick(2000) / 100.0 - 10, yaw = pick(600) / 100.0 - 3;
      std::vector<Field> fields{{"name", QStringLiteral("P%1").arg(round)}, {"frame", QStringLiteral("map")}};
      const bool turned = pick(4) > 0;
      if (turned) {
        switch (pick(4)) {
          case 0:
            fields.push_back({pick(2) ? "yaw_rad" : "theta_rad", yaw});
            break;
          case 1:
            fields.push_back({pick(2) ? "yaw_deg" : "heading[deg]", yaw * 180 / kPi});
            break;
          case 2:
            fields.push_back({pick(2) ? "yaw" : "heading", yaw});
            break;
          default:
            fields.push_back({"qz", std::sin(yaw / 2)});
            fields.push_back({"qw", std::cos(yaw / 2)});
        }
      }
      for (const char* odd : {"speed", "colour", "Bearing", "qx9", "wait time", "yaw_offset"}) {
        if (pick(3) == 0)
          fields.push_back({odd, pick(2) ? QJsonValue(pick(50)) : QJsonValue(QStringLiteral("red")), false});
      }
      const bool high = pick(3) == 0;
      const double z = high ? 1.5 : 0;
      std::shuffle(fields.begin(), fields.end(), random);

      QJsonObject properties, entry;
      std::string header = "x,y,z", row;
      for (const double number : {x, y, z})
        row += (row.empty() ? "" : ",") + QString::number(number, 'g', 17).toStdString();
      std::string yaml = "- x: " + QString::number(x, 'g', 17).toStdString() +
                         "\n  y: " + QString::number(y, 'g', 17).toStdString() +
                         "\n  z: " + QString::number(z).toStdString() + "\n";
      for (const Field& field : fields) {
        properties[QString::fromStdString(field.name)] = field.value;
        header += "," + field.name;
        const std::string text = field.value.isString()
                                     ? field.value.toString().toStdString()
                                     : QString::number(field.value.toDouble(), 'g', 17).toStdString();
        row += "," + text;
        yaml += "  " + field.name + ": " + text + "\n";
      }
      entry = properties;
      entry[QStringLiteral("x")] = x;
      entry[QStringLiteral("y")] = y;
      entry[QStringLiteral("z")] = z;
      const QJsonObject collection{
          {QStringLiteral("type"), QStringLiteral("FeatureCollection")},
          {QStringLiteral("features"),
           QJsonArray{QJsonObject{{QStringLiteral("type"), QStringLiteral("Feature")},
                                  {QStringLiteral("properties"), properties},
                                  {QStringLiteral("geometry"),
                                   QJsonObject{{QStringLiteral("type"), QStringLiteral("Point")},
                                               {QStringLiteral("coordinates"), QJsonArray{x, y, z}}}}}}}};
      for (const std::string& file :
           {QJsonDocument(collection).toJson().toStdString(),
            QJsonDocument(QJsonArray{entry}).toJson().toStdString(), header + "\n" + row + "\n", yaml}) {
        const WantedList list = read(file);
        QVERIFY2(list.points.size() == 1, file.c_str());
        const WantedWaypoint& point = list.points.front();
        QVERIFY2(isAt(point, x, y), file.c_str());
        QVERIFY2(point.name == "P" + std::to_string(round), file.c_str());
        QVERIFY2(turned ? isTurned(point, yaw) : !point.yaw_rad, file.c_str());
        QVERIFY2(saidOf(list).contains(QLatin1String("(z)")) == high, file.c_str());
        for (const Field& field : fields) {
          const bool said = saidOf(list).contains(QString::fromStdString(field.name));
          QVERIFY2(field.known || said, (field.name + " in " + file).c_str());
        }
      }
    }
  }
};

}  // namespace test_waypoint_files

MAPWRIGHT_TEST(test_waypoint_files, TestWaypointFiles, Core)
#include "test_waypoint_files.moc"
