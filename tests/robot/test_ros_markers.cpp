// Markers as ROS sends them, and which of them are to be seen.
#include <cmath>

#include <QTest>

#include "robot/ros/faults.h"
#include "robot/ros/map_values.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/seen_markers.h"
#include "ros_messages.h"
#include "test_program.h"

namespace test_ros_markers {

using namespace mapwright;
using namespace mapwright::robot::ros;
using test::byJson;

namespace {

const char* const kPose = R"({"position":{"x":1,"y":-2.5,"z":0.3},"orientation":{"x":0,"y":0,"z":1,"w":0}})";

std::vector<Marker> markersOf(const QByteArray& text) {
  return readMarkers(byJson(text).msg).value_or(std::vector<Marker>());
}

}  // namespace

class RosMarkersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void markersAreReadAloneAndInArrays() {
    const QByteArray cube =
        R"({"header":{"frame_id":"map"},"ns":"racks","id":4,"type":1,"action":0,"pose":)" +
        QByteArray(kPose) +
        R"(,"scale":{"x":2,"y":1,"z":0.5},"color":{"r":1,"g":0.5,"b":0,"a":1},)"
        R"("lifetime":{"sec":2,"nanosec":500000000},"text":"rack 4","points":[]})";
    for (const QByteArray& text : {cube, QByteArray(R"({"markers":[)" + cube + "]}")}) {
      const auto markers = markersOf(text);
      QCOMPARE(markers.size(), std::size_t(1));
      const Marker& marker = markers[0];
      QVERIFY(marker.kind == Marker::Kind::Cube && marker.action == Marker::Action::Add);
      QCOMPARE(marker.ns, std::string("racks"));
      QCOMPARE(marker.id, std::int64_t(4));
      QCOMPARE(marker.rgba, 0xff8000ffu);
      QCOMPARE(marker.lifetime_s, 2.5);
      const auto box = boxOf(marker, Transform3{{1, 0, 0}, Eigen::Quaterniond::Identity()});
      QVERIFY(box);
      QCOMPARE(box->label, std::string("rack 4"));
      QCOMPARE(box->length_m, 2.0);
      QCOMPARE(box->width_m, 1.0);
      QCOMPARE(box->pose.x_m, 2.0);
      QCOMPARE(box->rgba, std::optional(0xff8000ffu));
      QVERIFY(!drawingOf(marker, Transform3{}));
    }
    QCOMPARE(readMarkers(byJson("{}").msg).error(), Fault(robot::ros::fault::RosFieldMissing, {"markers"}));
  }

  void allKindsOfMarkersAreDrawn_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("drawn");
    QTest::addColumn<int>("points");
    using Kind = Marker::Kind;
    using Drawn = map::GroundDrawing::Kind;
    constexpr int kNothing = -1;
    const auto row = [](const char* name, int type, Kind kind, int drawn, int points) {
      QTest::newRow(name) << type << int(kind) << drawn << points;
    };
    row("arrow", 0, Kind::Arrow, int(Drawn::Line), 5);
    row("cube", 1, Kind::Cube, kNothing, 0);
    row("sphere", 2, Kind::Sphere, kNothing, 0);
    row("cylinder", 3, Kind::Cylinder, kNothing, 0);
    row("line strip", 4, Kind::LineStrip, int(Drawn::Line), 4);
    row("line list", 5, Kind::LineList, int(Drawn::Segments), 4);
    row("cube list", 6, Kind::CubeList, int(Drawn::Points), 4);
    row("sphere list", 7, Kind::SphereList, int(Drawn::Points), 4);
    row("points", 8, Kind::Points, int(Drawn::Points), 4);
    row("text", 9, Kind::Text, int(Drawn::Text), 1);
    row("mesh", 10, Kind::Mesh, int(Drawn::Points), 1);
    row("triangles", 11, Kind::Triangles, int(Drawn::Triangles), 3);
    row("unheard of", 77, Kind::Other, kNothing, 0);
  }
  void allKindsOfMarkersAreDrawn() {
    QFETCH(int, type);
    QFETCH(int, kind);
    QFETCH(int, drawn);
    QFETCH(int, points);
    const auto markers =
        markersOf(R"({"type":)" + QByteArray::number(type) + R"(,"action":0,"text":"Here","pose":)" + kPose +
                  R"(,"scale":{"x":2,"y":0.1,"z":0.3},"points":[{"x":0,"y":0,"z":0},{"x":1,"y":0,"z":0},)"
                  R"({"x":2,"y":1,"z":0},{"x":3,"y":1,"z":0},{"x":null}]})");
    QCOMPARE(markers.size(), std::size_t(1));
    QCOMPARE(int(markers[0].kind), kind);
    QCOMPARE(markers[0].points.size(), std::size_t(4));
    const auto drawing = drawingOf(markers[0], Transform3{});
    QCOMPARE(drawing ? int(drawing->kind) : -1, drawn);
    QCOMPARE(drawing ? int(drawing->points.size()) : 0, points);
    const bool boxed = kind == int(Marker::Kind::Cube) || kind == int(Marker::Kind::Sphere) ||
                       kind == int(Marker::Kind::Cylinder);
    QCOMPARE(boxOf(markers[0], Transform3{}).has_value(), boxed);
    // Points are in the marker's own coordinates, which are turned round here.
    if (markers[0].kind == Marker::Kind::LineList)
      QVERIFY((drawing->points[3] - Eigen::Vector2d(1 - 3, -2.5 - 1)).norm() < 1e-9);
    if (markers[0].kind == Marker::Kind::Text) {
      QCOMPARE(drawing->text, std::string("Here"));
      QCOMPARE(drawing->size_m, 0.3);
    }
  }

  void eachPointMayHaveAColourOfItsOwn() {
    const QByteArray begin =
        R"({"type":8,"pose":)" + QByteArray(kPose) +
        R"(,"scale":{"x":0.1},"color":{"r":0,"g":0,"b":0,"a":0},"points":[{"x":0,"y":0},{"x":null},{"x":1,"y":0}])";
    const QByteArray red = R"({"r":1,"g":0,"b":0,"a":1})", blue = R"({"r":0,"g":0,"b":1,"a":0.5})";
    const auto coloured = markersOf(begin + R"(,"colors":[)" + red + ',' + red + ',' + blue + "]}");
    const auto drawing = drawingOf(coloured.at(0), {});
    QVERIFY(drawing && drawing->points.size() == 2);
    // That of a point that is left out goes with it.
    QCOMPARE(drawing->colors, (std::vector<std::uint32_t>{0xff0000ffu, 0x0000ff80u}));
    // What cannot be seen at all is no colour.
    QVERIFY(!drawing->rgba);
    const auto few = markersOf(begin + R"(,"colors":[)" + red + "]}");
    QVERIFY(drawingOf(few.at(0), {})->colors.empty());
  }

  void anArrowLiesAlongItsAxisOrBetweenTwoPoints() {
    const QByteArray begin = R"({"type":0,"pose":)" + QByteArray(kPose) + R"(,"scale":{"x":2,"y":1,"z":1})";
    const auto along = markersOf(begin + "}");
    const auto by_points = markersOf(begin + R"(,"points":[{"x":0,"y":0,"z":0},{"x":0,"y":1,"z":0}]})");
    QVERIFY((drawingOf(along.at(0), {})->points[1] - Eigen::Vector2d(-1, -2.5)).norm() < 1e-9);
    QVERIFY((drawingOf(by_points.at(0), {})->points[1] - Eigen::Vector2d(1, -3.5)).norm() < 1e-9);
  }

  void markersComeAndGo() {
    const auto marker = [](const char* ns, int id, Marker::Action action, double lifetime_s = 0) {
      Marker made;
      made.ns = ns;
      made.id = id;
      made.action = action;
      made.kind = Marker::Kind::Cube;
      made.lifetime_s = lifetime_s;
      return made;
    };
    using Action = Marker::Action;
    SeenMarkers markers;
    const auto labelsAt = [&](double now_s) {
      markers.look({}, "map", now_s);
      std::vector<std::string> labels;
      for (const map::GroundBox& box : markers.seen().objects) labels.push_back(box.label);
      return labels;
    };
    using Labels = std::vector<std::string>;
    markers.apply("/m",
                  {marker("a", 1, Action::Add), marker("a", 2, Action::Add, 5), marker("b", 1, Action::Add)},
                  100);
    QCOMPARE(labelsAt(100), (Labels{"a 1", "a 2", "b 1"}));
    markers.apply(
        "/m", {marker("a", 1, Action::Add), marker("b", 1, Action::Delete), marker("b", 9, Action::Delete)},
        101);
    QCOMPARE(labelsAt(104.9), (Labels{"a 1", "a 2"}));
    QCOMPARE(labelsAt(105), (Labels{"a 1"}));
    markers.apply("/m", {marker("", 0, Action::DeleteAll), marker("c", 1, Action::Add)}, 106);
    QCOMPARE(labelsAt(106), (Labels{"c 1"}));
    // As they are written.
    const auto read = markersOf(
        R"({"markers":[{"type":1,"action":3},{"type":1,"action":2,"id":3},{"type":1,"action":1,"pose":{}}]})");
    QCOMPARE(read.size(), std::size_t(2));
    QVERIFY(read[0].action == Action::DeleteAll && read[1].action == Action::Delete);
  }
};

}  // namespace test_ros_markers

MAPWRIGHT_TEST(test_ros_markers, RosMarkersTest, Core)
#include "test_ros_markers.moc"
