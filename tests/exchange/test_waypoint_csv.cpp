// Waypoints as CSV and GeoJSON: what is written is read back, and what is none is refused with its place.
#include <QTest>

#include "exchange/waypoint_json.h"
#include "exchange/waypoint_table.h"
#include "test_program.h"

namespace test_waypoint_csv {

using namespace mapwright;

namespace {

map::Waypoint door() {
  map::Waypoint point;
  point.id = "17,5";
  point.name = "Tür \"A\",\nunten";
  point.position_m = {-1.25, 1.0 / 3};
  point.yaw_rad = 0.1;
  point.tags = {"map_entry", "a,b", "", "\"quoted\""};
  return point;
}

map::Waypoint bare() {
  map::Waypoint point;
  point.id = "2";
  point.name = "Lobby";
  return point;
}

/// A wanted one that says all that the waypoint is.
exchange::WantedWaypoint all(const map::Waypoint& point, int row) {
  exchange::WantedWaypoint wanted{row, point.id};
  wanted.name = point.name;
  wanted.position_m = point.position_m;
  wanted.yaw_rad = point.yaw_rad;
  wanted.tags = point.tags;
  return wanted;
}

}  // namespace

class WaypointCsvTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void fieldsComeBackAsTheyWere() {
    const std::vector<std::vector<std::string>> lines{
        {"a", "b"}, {"", ""}, {""}, {"a,b", "\"", "\"\""}, {"two\r\nlines", " blanks "}, {"Zürich", "階"}};
    std::string text;
    for (const auto& fields : lines) text += exchange::csvLine(fields) + "\r\n";
    const auto records = exchange::csvRecords(text);
    QVERIFY(records.has_value());
    QCOMPARE(records->size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) QVERIFY((*records)[i].fields == lines[i]);
    QCOMPARE(records->back().line, 7);  // one field is two lines long
  }

  void linesEndAsTheyLike() {
    for (const char* text : {"a,b\n1,2\n", "a,b\r\n1,2",
                             "\xef\xbb\xbf"
                             "a,b\n\n\n1,2\n\n"}) {
      const auto records = exchange::csvRecords(text);
      QVERIFY(records.has_value());
      QCOMPARE(records->size(), std::size_t(2));
      QVERIFY((records->front().fields == std::vector<std::string>{"a", "b"}));
      QVERIFY((records->back().fields == std::vector<std::string>{"1", "2"}));
    }
  }

  void aListComesBackAsItWas() {
    const std::vector<map::Waypoint> points{door(), bare()};
    const auto csv = exchange::wantedFromCsv(exchange::waypointsCsv(points, "hall"));
    QVERIFY2(csv.has_value(), csv ? "" : qPrintable(csv.error()));
    QVERIFY(csv->notes.isEmpty());
    QCOMPARE(csv->points.size(), std::size_t(2));
    QVERIFY(csv->points[0] == all(points[0], 2));
    QVERIFY(csv->points[1] == all(points[1], 4));
    const auto geojson =
        exchange::wantedFromGeoJson(exchange::waypointsGeoJson(points, "hall").toStdString());
    QVERIFY2(geojson.has_value(), geojson ? "" : qPrintable(geojson.error()));
    QVERIFY(geojson->notes.isEmpty());
    QVERIFY(geojson->points[0] == all(points[0], 1));
    QVERIFY(geojson->points[1] == all(points[1], 2));
  }

  void columnsAreThoseOfTheList() {
    QVERIFY(exchange::waypointsCsv({}, "1").starts_with("id,name,x,y,yaw_rad,tags,frame,map\r\n"));
    map::Waypoint typed = bare();
    typed.type = "charger";
    const std::string csv = exchange::waypointsCsv({typed}, "1");
    QCOMPARE(QString::fromStdString(csv),
             QStringLiteral("id,name,x,y,yaw_rad,tags,frame,map,type\r\n2,Lobby,0,0,,,map,1,charger\r\n"));
    QCOMPARE(exchange::wantedFromCsv(csv)->points.front().type, std::optional<std::string>("charger"));
  }

  void whatIsNotSaidIsLeftOpen() {
    const auto read = exchange::wantedFromCsv("Y, x ,NAME,colour\n+2.5,1e1,Lobby,red\n,,,\n");
    QVERIFY2(read.has_value(), read ? "" : qPrintable(read.error()));
    QCOMPARE(read->notes.size(), 1);
    QVERIFY(read->notes.front().contains(QStringLiteral("colour")));
    const exchange::WantedWaypoint& lobby = read->points.front();
    QVERIFY(lobby.id.empty() && !lobby.yaw_rad && !lobby.tags && !lobby.type);
    QVERIFY(lobby.position_m == Eigen::Vector2d(10, 2.5));
    QVERIFY(!read->points.back().name && !read->points.back().position_m);
  }

  void whatIsNoListIsRefusedWithItsLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const char* text, const char* says) {
      QTest::newRow(name) << QByteArray(text) << QString::fromLatin1(says);
    };
    row("empty", "", "empty");
    row("no header", "a,b,c\n", "two adjacent columns");
    row("no column of use", "type,tags\n", "Line 1: there is neither");
    row("column twice", "id,ID\n", "Line 1: the column \"id\" appears twice");
    row("x alone", "id,x\n", "Line 1: only one of the columns x and y");
    row("too few fields", "id,name\n1,a\n2\n", "Line 3: it has 1 fields");
    row("comma", "name,x,y\na,\"1,5\",2\n", "Line 2: x \"1,5\"");
    row("no number", "name,x,y\na,nan,2\n", "Line 2: x \"nan\"");
    row("half a place", "name,x,y\na,1,\n", "Line 2: x \"1\" and y \"\"");
    row("no turn", "name,yaw_rad\na,90 deg\n", "Line 2: yaw_rad");
    row("open quote", "id,name\n1,\"a\n2,b\n", "Line 2: a quote is missing");
    row("quote inside", "id,name\n1,a\"b\"\n", "Line 2: there is a quote in the middle");
    row("after a quote", "id,name\n1,\"a\"b\n", "Line 2: there is text after");
    row("other frame", "name,frame\na,odom\n", "Line 2: the frame is \"odom\"");
    row("tags", "name,tags\na,\"x,\"\"y\"\nb,\n", "Line 2: the tags");
    row("no UTF-8", "name\n\xff\n", "UTF-8");
  }
  void whatIsNoListIsRefusedWithItsLine() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const auto read = exchange::wantedFromCsv(std::string_view(text.constData(), std::size_t(text.size())));
    QVERIFY(!read.has_value());
    QVERIFY2(read.error().contains(says), qPrintable(read.error()));
  }

  void whatIsNoGeoJsonIsRefusedWithItsFeature_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const char* feature, const char* says) {
      QTest::newRow(name) << "{\"type\":\"FeatureCollection\",\"features\":[" + QByteArray(feature) + "]}"
                          << QString::fromLatin1(says);
    };
    QTest::newRow("no JSON") << QByteArray("{") << QStringLiteral("not JSON");
    QTest::newRow("no collection") << QByteArray("{\"type\":\"Feature\"}") << QStringLiteral("not a GeoJSON");
    row("no place", R"({"geometry":{"type":"Point","coordinates":["1",2]}})", "Feature 1: the coordinates");
    row("tags", R"({"geometry":{"type":"Point","coordinates":[1,2]},"properties":{"tags":"a"}})",
        "Feature 1: the tags");
    row("id", R"({"geometry":{"type":"Point","coordinates":[1,2]},"id":1.5})", "Feature 1: the id");
    row("turn", R"({"geometry":{"type":"Point","coordinates":[1,2]},"properties":{"yaw_rad":"N"}})",
        "Feature 1: yaw_rad");
  }
  void whatIsNoGeoJsonIsRefusedWithItsFeature() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const auto read =
        exchange::wantedFromGeoJson(std::string_view(text.constData(), std::size_t(text.size())));
    QVERIFY(!read.has_value());
    QVERIFY2(read.error().contains(says), qPrintable(read.error()));
  }

  void featuresThatAreNoPointsAreLeftOutWithANote() {
    const auto read = exchange::wantedFromGeoJson(
        R"({"type":"FeatureCollection","features":[{"geometry":{"type":"LineString"}},)"
        R"({"id":7,"geometry":{"type":"Point","coordinates":[1,2,0]},"properties":{"x":9}}]})");
    QVERIFY2(read.has_value(), read ? "" : qPrintable(read.error()));
    QVERIFY(read->notes.join(QLatin1Char(' ')).contains(QLatin1String("not a point")));
    QCOMPARE(read->points.size(), std::size_t(1));
    QCOMPARE(read->points.front().id, std::string("7"));
    QVERIFY(read->points.front().position_m == Eigen::Vector2d(1, 2));
  }
};

}  // namespace test_waypoint_csv

MAPWRIGHT_TEST(test_waypoint_csv, WaypointCsvTest, Core)
#include "test_waypoint_csv.moc"
