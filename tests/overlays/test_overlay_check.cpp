// What is wrong with overlays is found, and what robots write themselves is not.
#include <cmath>
#include <malloc.h>
#include <thread>

#include <QTest>

#include "grids/grid_pyramid.h"
#include "overlays/overlay_check.h"
#include "overlays/overlay_reach.h"
#include "overlays/overlay_shapes.h"
#include "test_program.h"

namespace test_overlay_check {

using namespace mapwright;
using overlays::Rule;

namespace {

/// Rows of '.' free, '#' wall, ' ' unknown; 0.1 m a cell, the lower left corner at (0, 0).
placing::PlacedMap mapOf(const std::vector<std::string>& rows, int times = 1) {
  placing::PlacedMap map;
  const int width = int(rows[0].size()) * times, height = int(rows.size()) * times;
  const auto builder =
      grids::buildGrid(width, height, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const char cell = rows[std::size_t(y / times)][std::size_t(x / times)];
      cells[std::size_t(x)] = cell == '#' ? 100 : cell == '.' ? 0 : 255;
    }
    builder->pushRow(cells);
  }
  builder->finish();
  map.cells = builder->pyramid();
  map.reference.width = width;
  map.reference.height = height;
  map.reference.resolution_m = 0.1;
  return map;
}

std::vector<overlays::Flaw> flawsIn(const std::string& features, overlays::CheckOptions options = {}) {
  const auto document = overlays::OverlayDocument::read(R"({"features":[)" + features + "]}");
  if (!document) qFatal("no overlays: %s", features.c_str());
  return overlays::flawsOf(*document, options);
}

/// "rule rule …"
std::string rulesIn(const std::string& features, overlays::CheckOptions options = {}) {
  std::string rules;
  for (const overlays::Flaw& flaw : flawsIn(features, std::move(options)))
    rules += (rules.empty() ? "" : " ") + std::string(overlays::nameOf(flaw.rule));
  return rules;
}

std::string point(const std::string& type, const std::string& at, const std::string& more = "") {
  return R"({"geometry":{"type":"Point","coordinates":)" + at + R"(},"properties":{"type":)" + type + more +
         "}}";
}
std::string shape(const std::string& kind, const std::string& coordinates,
                  const std::string& properties = "{}") {
  return "{\"geometry\":{\"type\":\"" + kind + "\",\"coordinates\":" + coordinates +
         "},\"properties\":" + properties + "}";
}
std::string dock(const char* id) {
  return "{\"id\":\"" + std::string(id) +
         "\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[5,1]},\"properties\":{\"type\":36}},";
}

}  // namespace

class OverlayCheckTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatRobotsWriteThemselvesIsNoFlaw() {
    QCOMPARE(rulesIn(shape("Polygon", "[[[0,0],[1,0],[1,1]]]") + "," +           // an open ring
                     shape("Polygon", "[[[0,0],[1,0],[1,1],[0,0]]]") + "," +     // a closed one
                     point("25", "[1,2,0]", R"(,"yaw":"90","name":"")") + "," +  // no id, yaw as text
                     R"({"geometry":null,"properties":{"name":"A"}},null,{"x":1})"),
             std::string());
  }

  void whatCannotBeReadIsFound() {
    QCOMPARE(rulesIn(R"({"type":"FeatureCollection","features":[]},5)"),
             std::string("unreadable unreadable"));
    QCOMPARE(rulesIn(shape("Circle", "[1,2]")), std::string("unreadable"));
    QCOMPARE(rulesIn(R"({"type":"Feature","geometry":{"radius":3}})"), std::string("unreadable"));
    QCOMPARE(rulesIn(R"({"geometry":{"type":"GeometryCollection","geometries":[{"type":"Arc"}]}})"),
             std::string("unreadable"));
    QCOMPARE(rulesIn(R"({"geometry":{"type":"Point"}})"), std::string("bad_number"));
    // Another program may read the other one.
    QCOMPARE(rulesIn(R"({"id":"a","properties":{"type":"9","type":"25"}})"), std::string("unreadable"));
    QCOMPARE(rulesIn(R"({"geometry":null,"geometry":{"type":"Point","coordinates":[1,2]}})"),
             std::string("unreadable"));
  }

  void idsAndNamesThatOccurTwiceAreFound() {
    QCOMPARE(rulesIn(R"({"id":7},{"id":"7"},{"properties":{"id":7}})"),
             std::string("duplicate_id duplicate_id"));
    const std::string named = R"(,"name":"Dock")";
    QCOMPARE(rulesIn(point("25", "[1,2]", named) + "," + point("11", "[2,2]", named)),
             std::string("duplicate_name"));
    QCOMPARE(rulesIn(point("25", "[1,2]", named) + "," +
                     shape("LineString", "[[0,0],[1,0]]", R"({"name":"Dock"})")),
             std::string());
  }

  void outlinesThatAreNoneAreFound_data() {
    QTest::addColumn<QByteArray>("feature");
    QTest::addColumn<QByteArray>("rules");
    const auto row = [](const char* name, const std::string& feature, const char* rules) {
      QTest::newRow(name) << QByteArray::fromStdString(feature) << QByteArray(rules);
    };
    row("bow tie", shape("Polygon", "[[[0,0],[2,2],[2,0],[0,2]]]"), "self_intersection");
    row("spike", shape("Polygon", "[[[0,0],[2,0],[2,2],[3,3],[2,2],[0,2]]]"), "self_intersection");
    row("touching corner", shape("Polygon", "[[[0,0],[2,0],[1,1],[2,2],[0,2],[1,1]]]"), "");
    row("concave", shape("Polygon", "[[[0,0],[3,0],[3,3],[2,3],[2,1],[1,1],[1,3],[0,3]]]"), "");
    row("on one line", shape("Polygon", "[[[0,0],[1,1],[3,3]]]"), "zero_area");
    row("two points", shape("Polygon", "[[[0,0],[1,1],[0,0]]]"), "too_few_points");
    row("no ring", shape("Polygon", "[]"), "too_few_points");
    row("hole of two points", shape("Polygon", "[[[0,0],[9,0],[9,9]],[[1,1],[2,1]]]"), "too_few_points");
    row("line of one point", shape("LineString", "[[1,1]]"), "too_few_points");
    row("line to itself", shape("LineString", "[[1,1],[1,1]]"), "too_few_points");
    row("crossing line", shape("LineString", "[[0,0],[2,2],[2,0],[0,2]]"), "");
    row("of many", shape("MultiPolygon", "[[[[0,0],[1,0],[1,1]]],[[[0,0],[2,2],[2,0],[0,2]]]]"),
        "self_intersection");
  }
  void outlinesThatAreNoneAreFound() {
    QFETCH(const QByteArray, feature);
    QFETCH(const QByteArray, rules);
    QCOMPARE(rulesIn(feature.toStdString()), rules.toStdString());
  }

  void whereAnOutlineCrossesItselfIsTold() {
    const auto flaws = flawsIn(shape("Polygon", "[[[0,0],[2,2],[2,0],[0,2]]]"));
    QVERIFY(flaws.at(0).at_m && (*flaws[0].at_m - Eigen::Vector2d(1, 1)).norm() < 1e-12);
  }

  void numbersThatCannotBeUsedAreFound() {
    for (const char* at : {"[NaN,1]", "[1]", "[\"1\",\"2\"]", "[1e308,0]", "null", "[1e999,0]", "{}"})
      QVERIFY2(rulesIn(point("25", at)) == "bad_number", at);
    for (const char* yaw : {"NaN", "\"north\"", "\"90°\"", "[]", "1e999", "true"})
      QVERIFY2(rulesIn(point("25", "[1,2]", std::string(R"(,"yaw":)") + yaw)) == "bad_number", yaw);
    for (const char* yaw : {"null", "\"\"", "\"-90.5\"", "1e2"})
      QVERIFY2(rulesIn(point("25", "[1,2]", std::string(R"(,"yaw":)") + yaw)).empty(), yaw);
    QCOMPARE(rulesIn(shape("LineString", R"([[0,0],["x",1],[2,2]])")), std::string("bad_number"));
  }

  void chargersAndDoorsHaveWhatTheyNeed() {
    QCOMPARE(rulesIn(point("9", "[1,2]")), std::string("charger_without_dock"));
    QCOMPARE(rulesIn(point("\"9\"", "[1,2]", R"(,"dockingPointId":"gone")")),
             std::string("charger_without_dock"));
    QCOMPARE(rulesIn(dock("d") + point("9", "[1,2]", R"(,"dockingPointId":"d")")), std::string());
    QCOMPARE(rulesIn(point("8", "[1,2]")), std::string("door_without_mac"));
    QCOMPARE(rulesIn(shape("Polygon", "[[[0,0],[1,0],[1,1]]]", R"({"regionType":"4","mac":""})")),
             std::string("door_without_mac"));
    QCOMPARE(rulesIn(shape("Polygon", "[[[0,0],[1,0],[1,1]]]", R"({"regionType":5,"mac":"30:AE"})")),
             std::string());
  }

  void theMapTellsWhatLiesOutsideOrInAWall() {
    overlays::CheckOptions options;
    options.map = mapOf({"..........", "....##....", ".........."}, 10);  // 10 m x 3 m
    QCOMPARE(rulesIn(point("25", "[11,1]"), options), std::string("outside_map"));
    QCOMPARE(rulesIn(shape("LineString", "[[1,1],[1,9]]"), options), std::string("outside_map"));
    QCOMPARE(rulesIn(point("25", "[5,1.5]"), options), std::string("in_wall"));
    QCOMPARE(rulesIn(shape("LineString", "[[5,1.5],[5,1.2]]", R"({"lineType":2})"), options), std::string());
    QCOMPARE(rulesIn(point("39", "[5,1.5]"), options), std::string());  // a landmark is on a wall
    const std::string docked = R"(,"dockingPointId":"d")";
    QCOMPARE(rulesIn(dock("d") + point("9", "[5,1.8]", docked), options), std::string());  // 0.2 m deep
    QCOMPARE(rulesIn(dock("d") + point("9", "[5,1.5]", docked), options), std::string());
    // The docking point, too.
    options.map = mapOf({"##########", "####.#####", "##########"}, 10);
    QCOMPARE(rulesIn(dock("d") + point("9", "[1,1.5]", docked), options), std::string("in_wall in_wall"));
  }

  void whatTheChargerCannotReachAnyMoreIsFound() {
    overlays::CheckOptions options;
    options.map = mapOf({"..........", "..........", ".........."}, 20);  // 20 m x 6 m
    options.radius_m = 0.3;
    const std::string charger = dock("d") + point("9", "[1,3]", R"(,"dockingPointId":"d")");
    const std::string there = point("25", "[18,3]"), here = point("25", "[5,3]");
    const auto wall = [](const char* from, const char* to) {
      return "," + shape("LineString", std::string("[") + from + "," + to + "]", R"({"lineType":"2"})");
    };
    const auto region = [](const char* type, const char* left, const char* right, const char* top) {
      return "," + shape("Polygon",
                         std::string("[[[") + left + ",-1],[" + right + ",-1],[" + right + "," + top + "],[" +
                             left + "," + top + "]]]",
                         std::string(R"({"regionType":)") + type + "}");
    };
    options.off = {Rule::OutsideMap, Rule::InWall};
    const std::string all = charger + "," + there + "," + here;
    QCOMPARE(rulesIn(all, options), std::string());
    QCOMPARE(rulesIn(all + wall("[10,-1]", "[10,7]"), options), std::string("unreachable"));
    QCOMPARE(rulesIn(all + wall("[9,-1]", "[11,7]"), options), std::string("unreachable"));     // askew
    QCOMPARE(rulesIn(all + wall("[10,-1]", "[10,5.0]"), options), std::string());               // 1 m is left
    QCOMPARE(rulesIn(all + wall("[10,-1]", "[10,5.6]"), options), std::string("unreachable"));  // too narrow
    QCOMPARE(rulesIn(all + region("1", "9", "11", "7"), options), std::string("unreachable"));
    QCOMPARE(rulesIn(all + region("2", "9", "11", "7"), options), std::string());  // slow
    QCOMPARE(rulesIn(all + shape("LineString", "[[0,0],[0,0]]").insert(0, ","), options),
             std::string("too_few_points"));
    const auto flaws = flawsIn(all + wall("[10,-1]", "[10,7]"), options);
    QVERIFY(flaws.at(0).at_m == Eigen::Vector2d(18, 3));
    // Without a charger nothing is known.
    QCOMPARE(rulesIn(there + "," + here + wall("[10,-1]", "[10,7]"), options), std::string());
    // A free region opens a wall of the map, and the unknown is no way.
    options.map = mapOf({"....#.....", "....#.....", "....#....."}, 20);
    QCOMPARE(rulesIn(all, options), std::string("unreachable"));
    QCOMPARE(rulesIn(all + region("12", "7", "11", "3.5"), options), std::string());
    options.map = mapOf({".... .....", ".... .....", ".... ....."}, 20);
    QCOMPARE(rulesIn(all, options), std::string("unreachable"));
  }

  /// Each check has a thread of its own, and OpenCV keeps something for each that its own threads have
  /// helped.
  void nothingIsKeptOfACheckWhenItsThreadEnds() {
    const auto document = *overlays::OverlayDocument::read(
        R"({"type":"FeatureCollection","features":[)" + dock("d") +
        point("9", "[1,3]", R"(,"dockingPointId":"d")") + "," + point("25", "[18,3]") + "]}");
    const placing::PlacedMap map = mapOf({"..........", "..........", ".........."}, 20);
    const auto checkOften = [&] {
      for (int i = 0; i < 100; ++i) std::thread([&] { (void)overlays::wayTo(2, document, map, 0.3); }).join();
      return mallinfo2().uordblks;
    };
    const std::size_t before = checkOften(), after = checkOften();
    QVERIFY2(after < before + 20'000, qPrintable(QString::number(after - before)));
  }

  void besideTheWayIsNotBehindAWall_data() {
    QTest::addColumn<double>("radius_m");
    for (const double radius : {0.2, 0.3, 0.6}) QTest::newRow(qPrintable(QString::number(radius))) << radius;
  }
  void besideTheWayIsNotBehindAWall() {
    QFETCH(const double, radius_m);
    overlays::CheckOptions options;
    options.radius_m = radius_m;
    options.off = {Rule::OutsideMap, Rule::InWall, Rule::ChargerWithoutDock};
    options.map = mapOf({"..........", "..........", ".........."}, 20);  // 20 m x 6 m
    const std::string charger = point("9", "[3,3]") + ",";
    const auto at = [&](double x) { return charger + point("11", "[" + std::to_string(x) + ",3]"); };
    const std::string wall = "," + shape("LineString", "[[7,-1],[7,8]]", R"({"lineType":2})");
    const std::string askew = "," + shape("LineString", "[[4,0],[10,6]]", R"({"lineType":2})");
    const std::string region =
        "," + shape("Polygon", "[[[7,-1],[7.2,-1],[7.2,8],[7,8]]]", R"({"regionType":1})");
    for (const double x : {7.15, 7.25, 7.35, 7.45, 7.55, 7.75, 8.2}) {
      QVERIFY2(rulesIn(at(x) + wall, options) == "unreachable", qPrintable(QString::number(x)));
      QVERIFY2(rulesIn(at(x) + askew, options) == "unreachable", qPrintable(QString::number(x)));
      QVERIFY2(rulesIn(at(x) + region, options) == "unreachable", qPrintable(QString::number(x)));
    }
    // On this side it may stand close to it.
    for (const double x : {6.9, 6.7, 6.5})
      QVERIFY2(rulesIn(at(x) + wall, options).empty(), qPrintable(QString::number(x)));
    // Nor does a charger reach through one.
    QCOMPARE(rulesIn(point("9", "[7.3,3]") + "," + point("11", "[3,3]") + wall, options),
             std::string("unreachable"));
    // A wall of the map, 0.1 m thick: what stands in it reaches out, what stands behind it does not.
    std::string row(100, '.');
    row[70] = '#';
    options.map = mapOf(std::vector<std::string>(60, row));  // the wall is at 7 m to 7.1 m
    QCOMPARE(rulesIn(at(7.05), options), std::string());
    QCOMPARE(rulesIn(at(7.35), options), std::string("unreachable"));
  }

  void theWayToAPointEndsWhereItIsBlocked() {
    const auto read = [](const std::string& features) {
      return *overlays::OverlayDocument::read(R"({"type":"FeatureCollection","features":[)" + features +
                                              "]}");
    };
    const placing::PlacedMap map = mapOf({"..........", "..........", ".........."}, 20);
    const std::string charger = point("9", "[2,3]"), there = point("25", "[18,3]");
    const std::string wall = shape("LineString", "[[10,-1],[10,7]]", R"({"lineType":2})");
    const auto open = overlays::wayTo(1, read(charger + "," + there), map, 0.3);
    QVERIFY(open && open->blocked.empty() && open->open.size() > 10);
    QVERIFY((open->open.front() - Eigen::Vector2d(2, 3)).norm() < 0.2);
    QVERIFY((open->open.back() - Eigen::Vector2d(18, 3)).norm() < 0.2);
    const auto shut = overlays::wayTo(1, read(charger + "," + there + "," + wall), map, 0.3);
    QVERIFY(shut && !shut->blocked.empty());
    QVERIFY2(shut->open.back().x() > 9.3 && shut->open.back().x() < 10,
             qPrintable(QString::number(shut->open.back().x())));
    QVERIFY(shut->blocked.back() == Eigen::Vector2d(18, 3));
    QVERIFY(!overlays::wayTo(0, read(there), map, 0.3));
    QVERIFY(!overlays::wayTo(7, read(charger), map, 0.3));
  }

  void ofAMapOfWhichNothingIsKnownNothingIsSaid() {
    overlays::CheckOptions options;
    options.map = mapOf({"   ", "   "}, 20);
    QCOMPARE(rulesIn(point("25", "[1000,2]"), options), std::string());
  }

  void rulesCanBeSwitchedOff() {
    overlays::CheckOptions options;
    options.off = {Rule::ChargerWithoutDock};
    QCOMPARE(rulesIn(point("9", "[1,2]"), options), std::string());
    for (int i = 0; i <= int(overlays::kLastRule); ++i)
      QVERIFY(overlays::ruleCalled(overlays::nameOf(Rule(i))) == Rule(i));
    QVERIFY(!overlays::ruleCalled("nonsense"));
  }

  void tenThousandPointsInARingAreNoTrouble() {
    std::string ring;
    for (int i = 0; i < 10'000; ++i) {
      const double angle = 2 * M_PI * i / 10'000;
      ring += (i ? ",[" : "[") + std::to_string(100 * std::cos(angle)) + "," +
              std::to_string(100 * std::sin(angle)) + "]";
    }
    QCOMPARE(rulesIn(shape("Polygon", "[[" + ring + "]]")), std::string());
  }
};

}  // namespace test_overlay_check

MAPWRIGHT_TEST(test_overlay_check, OverlayCheckTest, Nothing)
#include "test_overlay_check.moc"
