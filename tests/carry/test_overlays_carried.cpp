// Overlays of an old map on a new one: what belongs together goes together.
#include <functional>

#include <QtTest>

#include "carry/overlays_carried.h"
#include "geometry/rect.h"
#include "overlays/overlay_box.h"
#include "overlays/overlay_shapes.h"
#include "site.h"
#include "test_program.h"

namespace test_overlays_carried {

using namespace mapwright;
using namespace mapwright::testing;
using carry::CarriedFeature;
using carry::Verdict;
using overlays::OverlayDocument;

namespace {

std::string feature(const std::string& head, const std::string& kind, const std::string& coordinates,
                    const std::string& properties) {
  return "{\"type\":\"Feature\"," + head + "\"geometry\":{\"type\":\"" + kind +
         "\",\"coordinates\":" + coordinates + "},\"properties\":" + properties + "}";
}

std::string positionAt(const Eigen::Vector2d& at) {
  return '[' + std::to_string(at.x()) + ',' + std::to_string(at.y()) + ']';
}

std::string point(const std::string& id, double x, double y, const std::string& properties) {
  return feature("\"id\":\"" + id + "\",", "Point", positionAt({x, y}), properties);
}

OverlayDocument documentOf(const std::vector<std::string>& features) {
  std::string list;
  for (const std::string& one : features) list += (list.empty() ? "" : ",") + one;
  return *OverlayDocument::read("{\"type\":\"FeatureCollection\",\"features\":[" + list + "]}");
}

const std::string kCharger = point("c1", 1.5, 2, R"({"type":9,"yaw":"90","dockingPointId":"d1"})");
const std::string kDock = point("d1", 2.5, 2, R"({"type":36,"yaw":0})");
const std::string kTable = point("t1", 18, 5, R"({"type":11,"name":"Table","yaw":180})");
const std::string kWall = feature("", "LineString", "[[2,7,0.5],[4,8]]", R"({"lineType":"2","kept":[1.50]})");

std::vector<CarriedFeature> carriedTo(const TwoMaps& maps, const OverlayDocument& old_overlays,
                                      const OverlayDocument& new_overlays = {}) {
  return carry::carriedOverlays(maps.site(), old_overlays, new_overlays, maps.newGrid(), {});
}

}  // namespace

class TestOverlaysCarried : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shapesAndHeadingsTurnAndAllElseStays() {
    const auto all = carriedTo({}, documentOf({kCharger, kDock, kTable, kWall}));
    QCOMPARE(all.size(), std::size_t(4));
    for (const CarriedFeature& one : all) QCOMPARE(one.carried.verdict, Verdict::Kept);
    const double turned = geometry::degreesFromRadians(kTruth.yaw_rad);
    QVERIFY(std::abs(*overlays::yawOf(all[1].moved) - turned) < 0.01);
    QCOMPARE(*all[1].carried.spot.yaw_rad, geometry::radiansFromDegrees(*overlays::yawOf(all[1].moved)));
    const auto wall = overlays::shapesOf(all[3].moved).paths.front().points;
    QVERIFY((wall[0] - kTruth.apply({2, 7})).norm() < 1e-3);
    QVERIFY((wall[1] - kTruth.apply({4, 8})).norm() < 1e-3);
    QVERIFY(all[3].moved.text().find(R"("kept":[1.50])") != std::string::npos);
    QVERIFY(all[3].moved.text().find(",0.5]") != std::string::npos);  // its height
  }

  void aBoxThatWasRightIsRightThereToo() {
    const std::string boxed =
        R"({"type":"Feature","bbox":[2,7,0.5, 4,8,0.5],"geometry":{"type":"LineString",)"
        R"("bbox": [2.0, 7, 4, 8],"coordinates":[[2,7,0.5],[4,8]]},)"
        R"("properties":{"lineType":"2","kept":[1.50]}})";
    const auto all = carriedTo({}, documentOf({boxed, kWall}));
    QVERIFY(!all[0].box_removed && !all[1].box_removed);
    const auto points = overlays::shapesOf(all[0].moved).paths.front().points;
    const auto root = all[0].moved.root();
    const auto outer = root.member("bbox")->children(),
               inner = root.member("geometry")->member("bbox")->children();
    QCOMPARE(outer.size(), std::size_t(6));
    QCOMPARE(inner.size(), std::size_t(4));
    for (int axis = 0; axis < 2; ++axis) {
      const double low = std::min(points[0][axis], points[1][axis]);
      const double high = std::max(points[0][axis], points[1][axis]);
      QCOMPARE(outer[std::size_t(axis)].number(), low);
      QCOMPARE(outer[std::size_t(axis) + 3].number(), high);
      QCOMPARE(inner[std::size_t(axis)].number(), low);
      QCOMPARE(inner[std::size_t(axis) + 2].number(), high);
    }
    QCOMPARE(std::string(outer[2].text()), std::string("0.5"));
    QVERIFY(all[0].moved.text().find(R"("kept":[1.50])") != std::string::npos);
  }

  void aBoxThatWasWrongIsLeftOutAndSaid_data() {
    QTest::addColumn<QByteArray>("box");
    QTest::newRow("elsewhere") << QByteArray("[2,7,5,8]");
    QTest::newRow("too few numbers") << QByteArray("[2,7]");
    QTest::newRow("no numbers") << QByteArray("[2,7,\"4\",8]");
    QTest::newRow("no list") << QByteArray("null");
  }
  void aBoxThatWasWrongIsLeftOutAndSaid() {
    QFETCH(QByteArray, box);
    const std::string line = R"({"type":"LineString","coordinates":[[2,7],[4,8]])";
    const std::string bbox = ",\"bbox\":" + box.toStdString();
    const std::string tail = R"(,"properties":{"lineType":"2"}})";
    const auto all =
        carriedTo({}, documentOf({R"({"type":"Feature")" + bbox + ",\"geometry\":" + line + "}" + tail,
                                  R"({"type":"Feature","geometry":)" + line + bbox + "}" + tail}));
    for (const CarriedFeature& one : all) {
      QVERIFY(one.box_removed);
      QVERIFY2(one.moved.text().find("bbox") == std::string::npos, one.moved.text().c_str());
      QCOMPARE(overlays::shapesOf(one.moved).paths.front().points.size(), std::size_t(2));
    }
  }

  /// Collections of geometries in one another, each with a box that is right, wrong or none.
  void boxesOfRandomCollectionsTurnOrAreLeftOut() {
    using Bounds = geometry::WorldRect;
    Chance chance(1);
    int wrong = 0;
    const auto boxOf = [&](const Bounds& bounds) -> std::string {
      const int kind = chance.below(3);
      if (kind == 0) return {};
      if (kind == 1) ++wrong;
      return ",\"bbox\":[" + std::to_string(bounds.min_x - (kind == 1 ? 0.5 : 0)) + ',' +
             std::to_string(bounds.min_y) + ',' + std::to_string(bounds.max_x) + ',' +
             std::to_string(bounds.max_y) + ']';
    };
    const std::function<std::string(int, Bounds&)> geometryOf = [&](int depth, Bounds& bounds) {
      std::string list;
      for (int i = 0; i < 2; ++i) {
        Bounds inner;
        const Eigen::Vector2d at(chance.between(2, 8), chance.between(2, 8));
        list += (i > 0 ? "," : "") + (depth > 0 ? geometryOf(chance.below(depth), inner) : positionAt(at));
        depth > 0 ? bounds.extend(inner) : bounds.extend(at);
      }
      return (depth > 0 ? R"({"type":"GeometryCollection","geometries":[)"
                        : R"({"type":"LineString","coordinates":[)") +
             list + ']' + boxOf(bounds) + '}';
    };
    std::vector<std::string> texts;
    std::vector<int> wrong_in;
    for (int i = 0; i < 40; ++i) {
      wrong = 0;
      Bounds bounds;
      const std::string geometry = geometryOf(6, bounds);
      texts.push_back(R"({"type":"Feature")" + boxOf(bounds) + R"(,"geometry":)" + geometry +
                      R"(,"properties":{"kept":[1.50]}})");
      wrong_in.push_back(wrong);
    }
    // How many there are; each must be around what it belongs to.
    const std::function<int(const json::JsonValue&)> boxesIn = [&](const json::JsonValue& object) {
      int found = 0;
      if (const auto box = object.member("bbox")) {
        Bounds there;
        const overlays::Feature alone(object.member("geometry")
                                          ? std::string(object.text())
                                          : "{\"geometry\":" + std::string(object.text()) + '}');
        for (const overlays::Path& path : overlays::shapesOf(alone).paths) {
          for (const Eigen::Vector2d& point : path.points) there.extend(point);
        }
        const auto sides = box->children();
        const double bounds[] = {there.min_x, there.min_y, there.max_x, there.max_y};
        for (std::size_t i = 0; i < 4; ++i) {
          if (std::abs(sides[i].number() - bounds[i]) > 1e-3) return -1000;
        }
        ++found;
      }
      if (const auto inner = object.member("geometry")) found += boxesIn(*inner);
      if (const auto parts = object.member("geometries")) {
        for (const json::JsonValue& part : parts->children()) found += boxesIn(part);
      }
      return found;
    };
    const auto all = carriedTo({}, documentOf(texts));
    QCOMPARE(all.size(), texts.size());
    int right_ones = 0, wrong_ones = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      int before = 0;
      for (auto at = texts[i].find("bbox"); at != std::string::npos; at = texts[i].find("bbox", at + 1))
        ++before;
      QCOMPARE(all[i].box_removed, wrong_in[i] > 0);
      QCOMPARE(boxesIn(all[i].moved.root()), before - wrong_in[i]);
      QVERIFY(all[i].moved.text().find(R"("kept":[1.50])") != std::string::npos);
      right_ones += before - wrong_in[i], wrong_ones += wrong_in[i];
    }
    QVERIFY(right_ones > 40 && wrong_ones > 40);
  }

  void theBoxOfTheWholeCollectionGrowsIfItWasRight() {
    const auto collection = [](const std::string& box) {
      return *OverlayDocument::read(R"({"type":"FeatureCollection","bbox":)" + box + R"(,"features":[)" +
                                    kWall + "]}");
    };
    OverlayDocument right = collection("[2, 7, 4, 8]");
    const OverlayDocument before = right;
    right.add(overlays::Feature(point("p", 10, 5, "{}")));
    QVERIFY(overlays::rebox(right, before));
    QVERIFY2(right.text().find(R"("bbox":[2, 5, 10, 8])") != std::string::npos, right.text().c_str());
    OverlayDocument wrong = collection("[0,0,4,8]");
    const OverlayDocument wrong_before = wrong;
    wrong.add(overlays::Feature(point("p", 10, 5, "{}")));
    QVERIFY(!overlays::rebox(wrong, wrong_before));
    QVERIFY(wrong.text().find("[0,0,4,8]") != std::string::npos);
    OverlayDocument none = documentOf({kWall});
    QVERIFY(overlays::rebox(none, none));
  }

  void aChargerAndItsDockingPointGoTogetherOrNotAtAll() {
    TwoMaps maps;
    box(maps.new_map, 2.3, 1.8, 2.8, 2.2);
    const auto all = carriedTo(maps, documentOf({kCharger, kDock, kWall}));
    QCOMPARE(all[0].carried.verdict, Verdict::InObstacle);
    QCOMPARE(all[1].carried.verdict, Verdict::InObstacle);
    QCOMPARE(all[0].with, std::vector<std::size_t>{1});
    QCOMPARE(all[1].with, std::vector<std::size_t>{0});
    QCOMPARE(all[2].carried.verdict, Verdict::Kept);
    QVERIFY(all[2].with.empty());
  }

  void aNameThatIsTheIdOfAnotherIsNoReference() {
    const auto all = carriedTo({}, documentOf({kDock, point("x", 3, 3, R"({"type":11,"name":"d1"})")}));
    QVERIFY(all[0].with.empty() && all[1].with.empty());
  }

  void whatRefersToOneDeviceGoesTogether() {
    const auto all =
        carriedTo({}, documentOf({point("g", 3, 3, R"({"type":7,"deviceIds":["a1"]})"),
                                  point("r", 4, 3, R"({"type":11,"deviceIds":["a1","b"]})"), kTable}));
    QCOMPARE(all[0].with, std::vector<std::size_t>{1});
    QVERIFY(all[2].with.empty());
  }

  void aNumberOrTextThatHappensToBeAnIdIsNoReference() {
    const auto all =
        carriedTo({}, documentOf({point("11", 3, 3, R"({"type":11,"note":"c1"})"), kTable, kDock}));
    for (const CarriedFeature& one : all) QVERIFY(one.with.empty());
  }

  void whatBelongsToSomethingThatIsThereIsLeftOut() {
    const auto all =
        carriedTo({}, documentOf({kCharger, kDock}), documentOf({point("d1", 0, 0, R"({"type":36})")}));
    QVERIFY(all[1].there_already);
    QVERIFY(!all[0].there_already && all[0].one_there);
  }

  void withoutAnIdTheSamePlaceCounts() {
    const std::string nameless = feature("", "Point", "[3,3]", R"({"type":11,"name":"Desk"})");
    const auto first = carriedTo({}, documentOf({nameless}));
    QVERIFY(!first[0].there_already);
    QVERIFY(carriedTo({}, documentOf({nameless}), documentOf({first[0].moved.text()}))[0].there_already);
  }

  void whatTheNewMapHasAlreadyIsSaid() {
    const auto all =
        carriedTo({}, documentOf({kDock, kTable}), documentOf({point("t1", 0, 0, R"({"type":11})")}));
    QVERIFY(!all[0].there_already);
    QVERIFY(all[1].there_already);
  }

  void aTableBehindAForbiddenRegionOfTheNewMapIsUnreachable() {
    std::string ring;
    for (const auto& corner : std::vector<Eigen::Vector2d>{{13, 0}, {13.5, 0}, {13.5, 10}, {13, 10}, {13, 0}})
      ring += (ring.empty() ? "" : ",") + positionAt(kTruth.apply(corner));
    const std::string region = feature("", "Polygon", "[[" + ring + "]]", R"({"regionType":1})");
    const auto all = carriedTo({}, documentOf({kCharger, kDock, kTable}), documentOf({region}));
    QCOMPARE(all[2].carried.verdict, Verdict::Unreachable);
    QCOMPARE(all[0].carried.verdict, Verdict::Kept);
  }

  void whatHasNoPlaceIsLeftOut() {
    const auto all = carriedTo({}, documentOf({feature("", "Point", "[]", "{}"), kDock}));
    QCOMPARE(all.size(), std::size_t(1));
    QCOMPARE(all[0].feature, std::size_t(1));
  }

  void whatCannotMoveAsAWholeIsLeftOut() {
    const std::string half = feature("", "LineString", "[[2,7],[NaN,8],[4,8]]", R"({"lineType":"2"})");
    const auto all = carriedTo({}, documentOf({half, kDock}));
    QCOMPARE(all.size(), std::size_t(1));
    QCOMPARE(all[0].feature, std::size_t(1));
  }
};

}  // namespace test_overlays_carried

MAPWRIGHT_TEST(test_overlays_carried, TestOverlaysCarried, Core)
#include "test_overlays_carried.moc"
