// Tables out of spreadsheets: what they look like is found out, and what they say is read.
#include <QTest>

#include "exchange/waypoint_table.h"
#include "test_program.h"

namespace test_pasted_waypoints {

using namespace mapwright::exchange;
using mapwright::map::Waypoint;

namespace {

WantedList read(std::string_view text) {
  const auto wanted = wantedFromTable(text, shapeOf(text));
  if (!wanted) qWarning("%s", qPrintable(wanted.error()));
  return wanted.value_or(WantedList{});
}

}  // namespace

class TestPastedWaypoints : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsCopiedComesBackAsItWas() {
    Waypoint point;
    point.id = "7";
    point.name = "Gate \"A\"\twest\nlow";
    point.position_m = {1.0 / 3, -2};
    point.yaw_rad = 1.25;
    point.tags = {"a", "b,c"};
    const WantedList list = read(waypointsTable({point}));
    QCOMPARE(list.points.size(), std::size_t(1));
    const WantedWaypoint& wanted = list.points.front();
    QCOMPARE(wanted.id, point.id);
    QCOMPARE(*wanted.name, point.name);
    QVERIFY(*wanted.position_m == point.position_m);
    QVERIFY(*wanted.yaw_rad == point.yaw_rad);
    QVERIFY(*wanted.tags == point.tags);
  }

  void aHeaderNamesTheColumnsInAnyOrder() {
    const WantedList list = read("Heading (deg)\tY [m]\tX [m]\tName\n90\t2\t1\tDoor\n\t4\t3\tLift\n");
    QCOMPARE(list.points.size(), std::size_t(2));
    QCOMPARE(*list.points[0].name, std::string("Door"));
    QVERIFY(*list.points[0].position_m == Eigen::Vector2d(1, 2));
    QVERIFY(std::abs(**list.points[0].yaw_rad - 1.5707963) < 1e-6);
    QVERIFY(list.points[1].yaw_rad && !*list.points[1].yaw_rad);
  }

  void withoutAHeaderTheColumnsTellThemselves() {
    const WantedList list = read("Door\t1\t2\t180\tdock\nLift\t3.5\t4\t\t\"a,b\"\n");
    QCOMPARE(list.points.size(), std::size_t(2));
    QCOMPARE(*list.points[1].name, std::string("Lift"));
    QVERIFY(*list.points[1].position_m == Eigen::Vector2d(3.5, 4));
    QVERIFY(std::abs(**list.points[0].yaw_rad - 3.14159265) < 1e-6);
    QVERIFY((*list.points[1].tags == std::vector<std::string>{"a", "b"}));
    const WantedList ids = read("17,Door,1,2\n18,Lift,3,4\n");
    QCOMPARE(ids.points[1].id, std::string("18"));
    QCOMPARE(*ids.points[1].name, std::string("Lift"));
  }

  void decimalCommasAreNumbers() {
    const char* const text = "Name;x;y\nDoor;1,5;-2,25\n";
    QVERIFY(shapeOf(text).decimal_comma && shapeOf(text).separator == ';');
    QVERIFY(*read(text).points.front().position_m == Eigen::Vector2d(1.5, -2.25));
    const char* const tabs = "Door\t1,5\t2\n";
    QVERIFY(*read(tabs).points.front().position_m == Eigen::Vector2d(1.5, 2));
  }

  void placesWithoutNamesGetSome() {
    WantedList list = read("1\t2\n3\t4\n");
    QCOMPARE(list.points.size(), std::size_t(2));
    QVERIFY(!list.points[0].name);
    Waypoint there;
    there.name = "Waypoint 1";
    nameNameless(list.points, {{"k", there}});
    QCOMPARE(*list.points[0].name, std::string("Waypoint 2"));
    QCOMPARE(*list.points[1].name, std::string("Waypoint 3"));
  }

  void aQuoteInACellIsALetter() {
    QCOMPARE(*read("name\tx\ty\nHall 3\" pipe\t1\t2\n").points.front().name, std::string("Hall 3\" pipe"));
  }

  void whatIsNoTableIsRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    QTest::newRow("empty") << QByteArray() << QStringLiteral("empty");
    QTest::newRow("words") << QByteArray("Hello there") << QStringLiteral("two adjacent columns");
    QTest::newRow("heading") << QByteArray("name\tx\ty\theading\na\t1\t2\tnorth\n")
                             << QStringLiteral("Line 2: heading \"north\"");
    QTest::newRow("no utf-8") << QByteArray("a\xff\t1\t2") << QStringLiteral("UTF-8");
    QTest::newRow("many columns") << QByteArray(500, '\t') << QStringLiteral("too many columns");
  }
  void whatIsNoTableIsRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const std::string_view table(text.constData(), std::size_t(text.size()));
    const auto wanted = wantedFromTable(table, shapeOf(table));
    QVERIFY(!wanted);
    QVERIFY2(wanted.error().contains(says), qPrintable(wanted.error()));
  }
};

}  // namespace test_pasted_waypoints

MAPWRIGHT_TEST(test_pasted_waypoints, TestPastedWaypoints, Nothing)
#include "test_pasted_waypoints.moc"
