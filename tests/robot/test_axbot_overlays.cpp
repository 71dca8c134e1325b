#include <QTest>

#include "robot/axbot/parse_maps.h"
#include "test_program.h"

namespace test_axbot_overlays {

using namespace mapwright;
using robot::axbot::parseOverlays;
using Features = std::vector<map::OverlayFeature>;

namespace {

Features one(const std::string& geometry, const std::string& properties = "{}") {
  return parseOverlays(R"({"type":"FeatureCollection","features":[{"id":12,"type":"Feature","geometry":)" +
                       geometry + R"(,"properties":)" + properties + "}]}")
      .value_or(Features());
}

}  // namespace

class AxbotOverlaysTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void pointsHaveTypeNameAndHeadingInDegrees() {
    for (const char* properties :
         {R"({"type":"9","yaw":90,"name":"<b>💡"})", R"({"type":9,"yaw":"90","name":"<b>💡"})"}) {
      const Features features = one(R"({"type":"Point","coordinates":[1,2,0]})", properties);
      QCOMPARE(features.size(), std::size_t(1));
      QCOMPARE(features[0].type, 9);
      QCOMPARE(features[0].id, std::string("12"));
      QCOMPARE(features[0].name, std::string("<b>💡"));
      QCOMPARE(*features[0].yaw_rad, geometry::radiansFromDegrees(90));
      QCOMPARE(features[0].parts[0][0], Eigen::Vector2d(1, 2));
    }
  }

  void openRingsAreClosed() {
    const Features features =
        one(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]],[[0,0],[1,0],[1,1],[0,0]],[[1,1]]]})",
            R"({"regionType":"1"})");
    QCOMPARE(features[0].type, 1);
    QCOMPARE(features[0].parts.size(), std::size_t(2));
    for (const auto& ring : features[0].parts) {
      QCOMPARE(ring.size(), std::size_t(4));
      QVERIFY(ring.front() == ring.back());
    }
  }

  void multiGeometriesAreSeveralFeatures() {
    QCOMPARE(one(R"({"type":"MultiPoint","coordinates":[[0,0],[1,1]]})").size(), std::size_t(2));
    const Features lines =
        one(R"({"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[2,2],[3,3]],[[4,4]]]})",
            R"({"lineType":2})");
    QCOMPARE(lines.size(), std::size_t(2));
    QCOMPARE(lines[1].type, 2);
    QCOMPARE(
        one(R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[1,1]]],[[[5,5],[6,5],[6,6]]]]})").size(),
        std::size_t(2));
    QCOMPARE(
        one(R"({"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,1]}]})").size(),
        std::size_t(1));
  }

  void whatCannotBeDrawnIsLeftOut() {
    for (const char* text : {"", "null", "[]", "{", "7", R"("x")", R"({"features":3})",
                             R"({"features":[null,3,{},{"geometry":null}]})"}) {
      QVERIFY2(parseOverlays(std::string_view(text)).value_or(Features()).empty(), text);
    }
    QVERIFY(one(R"({"type":"Point","coordinates":[null,1]})").empty());
    QVERIFY(one(R"({"type":"LineString","coordinates":[[0,0]]})").empty());
    QVERIFY(one(R"({"type":"Polygon","coordinates":[]})").empty());
    QVERIFY(one(R"({"type":"Circle","coordinates":[0,0]})").empty());
  }

  void whatCannotBeReadIsToldWithAPlaceIfItHasOne() {
    std::vector<map::BrokenOverlay> broken;
    const auto features = parseOverlays(
        R"({"features":[
          {"id":"a","geometry":{"type":"Point","coordinates":[1,2]}},
          {"id":"b","properties":{"name":"Hall"},"geometry":{"type":"Polygon","coordinates":[[[3,4],[5]]]}},
          {"id":"c","geometry":{"type":"Circle","coordinates":[5,6]}},
          {"id":"d","geometry":{"type":"Point","coordinates":["x",1]}},
          {"id":"e","geometry":{"type":"LineString"}},
          {"id":"f","geometry":null}]})",
        &broken);
    QCOMPARE(features->size(), std::size_t(1));
    QCOMPARE(broken.size(), std::size_t(4));
    QCOMPARE(broken[0].id, std::string("b"));
    QCOMPARE(broken[0].name, std::string("Hall"));
    QCOMPARE(*broken[0].at_m, Eigen::Vector2d(3, 4));
    QVERIFY(inEnglish(broken[1].reason).find("Circle") != std::string::npos);
    QCOMPARE(*broken[1].at_m, Eigen::Vector2d(5, 6));
    QVERIFY(!broken[2].at_m && !broken[3].at_m);
  }

  void unknownAndMissingTypesAreZero() {
    QCOMPARE(one(R"({"type":"Point","coordinates":[1,2]})", "null")[0].type, 0);
    QCOMPARE(one(R"({"type":"Point","coordinates":[1,2]})", R"({"type":"charger"})")[0].type, 0);
    QCOMPARE(one(R"({"type":"Point","coordinates":[1,2]})", R"({"type":1e99})")[0].type, 0);
  }
};

}  // namespace test_axbot_overlays

MAPWRIGHT_TEST(test_axbot_overlays, AxbotOverlaysTest, Core)
#include "test_axbot_overlays.moc"
