// The simulated map dispatcher of REP 130: regions of a building that nobody could hold in memory, the
// readings of what the REP leaves open, and clouds as all kinds of senders lay them down.
#include <cmath>

#include <QTest>
#include <QtEndian>

#include "ros_socket.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_ros_dispatcher {

using mapwright::simulator::Options;
using mapwright::simulator::RosDialect;

namespace {

Options with(double edge_m = 1000) {
  Options options = RosRobot::still();
  options.ros.kabam = false;
  options.ros.dispatcher.there = true;
  options.ros.dispatcher.edge_m = edge_m;
  return options;
}

QByteArray square(double x, double y, double edge) {
  return QStringLiteral(R"({"x":%1,"y":%2,"l_x":%3,"l_y":%3})").arg(x).arg(y).arg(edge).toUtf8();
}

QByteArray box(double x, double y, double z, double edge, double radius = 0) {
  return QStringLiteral(R"({"x":%1,"y":%2,"z":%3,"r":%5,"l_x":%4,"l_y":%4,"l_z":%4})")
      .arg(x)
      .arg(y)
      .arg(z)
      .arg(edge)
      .arg(radius)
      .toUtf8();
}

QJsonObject grid(const RosRobot& robot, const QByteArray& region) {
  return at(robot->values("/map_dispatcher/get_sub_map", region), "sub_map").toObject();
}

QJsonObject cloud(const RosRobot& robot, const QByteArray& region,
                  const QByteArray& service = "/map_dispatcher/get_sub_point_map") {
  return at(robot->values(service, region), "sub_map").toObject();
}

QByteArray bytesOf(const QJsonObject& cloud) {
  return QByteArray::fromBase64(at(cloud, "data").toString().toLatin1());
}

/// The coordinates of a cloud of little-endian float32 without odd offsets.
QList<std::array<float, 3>> pointsOf(const QJsonObject& cloud) {
  const QByteArray bytes = bytesOf(cloud);
  const int step = at(cloud, "point_step").toInt();
  QList<std::array<float, 3>> points;
  for (int i = 0; step > 0 && (i + 1) * step <= bytes.size(); ++i) {
    std::array<float, 3> point;
    for (int axis = 0; axis < 3; ++axis)
      point[std::size_t(axis)] = qFromLittleEndian<float>(bytes.constData() + i * step + axis * 4);
    points << point;
  }
  return points;
}

}  // namespace

class TestRosDispatcher : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aRegionIsCellsOfTheMap() {
    RosRobot robot(with());
    const QJsonObject part = grid(robot, square(10, -20, 4));
    QCOMPARE(at(part, "info.width").toInt(), 80);
    QCOMPARE(at(part, "info.height").toInt(), 80);
    QVERIFY(std::abs(at(part, "info.origin.position.x").toDouble() - 8) < 1e-6);
    QVERIFY(std::abs(at(part, "info.origin.position.y").toDouble() + 22) < 1e-6);
    QCOMPARE(at(part, "data").toArray().size(), 6400);
    // The same place is the same cells, whatever region it lies in.
    const QJsonArray smaller = at(grid(robot, square(10, -20, 2)), "data").toArray();
    const QJsonArray larger = at(part, "data").toArray();
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 40; ++column)
        QCOMPARE(smaller[row * 40 + column], larger[(row + 20) * 80 + column + 20]);
    }
  }

  void theMapIsTooLargeToBeHadWhole() {
    RosRobot robot(with());
    QVERIFY(at(robot->ask("/map_dispatcher/get_map"), "values")
                .toString()
                .contains(QLatin1String("not enough memory")));
    QVERIFY(!at(robot->ask("/map_dispatcher/get_point_map"), "result").toBool(true));
    const QJsonObject metadata = [&] {
      robot->subscribe("/map_metadata");
      return robot->first("/map_metadata");
    }();
    QCOMPARE(at(metadata, "width").toInt(), 20'000);
    RosRobot small(with(10));
    const QJsonObject whole = at(small->values("/map_dispatcher/get_map"), "map").toObject();
    QCOMPARE(at(whole, "info.width").toInt(), 200);
    QCOMPARE(at(whole, "data").toArray().size(), 40'000);
    const QJsonObject points = at(small->values("/map_dispatcher/get_point_map"), "map").toObject();
    QCOMPARE(at(points, "width").toInt(), 4'000);  // 40 a square metre: 40 million of the large one
    QVERIFY(at(at(small->values("/map_dispatcher/get_occupancy_map"), "map").toObject(), "width").toInt() >
            0);
  }

  void aRegionBeyondTheMapIsCutFilledUpOrEmpty_data() {
    QTest::addColumn<QString>("answer");
    QTest::addColumn<int>("width");
    QTest::newRow("cut") << QString() << 100;
    QTest::newRow("pad") << QStringLiteral("pad") << 200;
    QTest::newRow("empty") << QStringLiteral("empty") << 0;
  }
  void aRegionBeyondTheMapIsCutFilledUpOrEmpty() {
    QFETCH(QString, answer);
    QFETCH(int, width);
    Options options = with();
    options.faults.ros.dispatcher.answer = answer.toStdString();
    RosRobot robot(options);
    const QJsonObject part = grid(robot, square(500, 0, 10));
    QCOMPARE(at(part, "info.width").toInt(), width);
    QCOMPARE(at(part, "data").toArray().size(), qsizetype(width) * at(part, "info.height").toInt());
    QCOMPARE(at(grid(robot, square(2000, 0, 10)), "info.width").toInt(),
             answer == QLatin1String("pad") ? 200 : 0);
  }

  void anAnswerMayHaveSoManyCellsAtMost() {
    Options options = with();
    options.faults.ros.dispatcher.most_cells = 10'000;
    RosRobot cutting(options);
    const QJsonObject less = grid(cutting, square(0, 0, 10));
    QCOMPARE(at(less, "info.width").toInt(), 100);
    QCOMPARE(at(less, "data").toArray().size(), 10'000);
    QVERIFY(std::abs(at(less, "info.origin.position.x").toDouble() + 5) < 1e-6);
    QCOMPARE(at(grid(cutting, square(0, 0, 5)), "info.width").toInt(), 100);
    options.faults.ros.dispatcher.too_much = "empty";
    QCOMPARE(at(grid(RosRobot(options), square(0, 0, 10)), "info.width").toInt(), 0);
    options.faults.ros.dispatcher.too_much = "error";
    RosRobot refusing(options);
    QVERIFY(!at(refusing->ask("/map_dispatcher/get_sub_map", square(0, 0, 10)), "result").toBool(true));
    QCOMPARE(at(grid(refusing, square(0, 0, 5)), "info.width").toInt(), 100);
  }

  void aTurnedAnswerIsLarger() {
    Options options = with();
    options.faults.ros.dispatcher.answer = "rotated";
    RosRobot robot(options);
    const QJsonObject part = grid(robot, square(0, 0, 10));
    QVERIFY(at(part, "info.width").toInt() > 200);
    QVERIFY(at(part, "info.origin.orientation.z").toDouble() > 0.1);
  }

  void anAnswerMayBeOfAnotherRegionAndResolution() {
    Options options = with();
    options.faults.ros.dispatcher.answer = "elsewhere";
    options.faults.ros.dispatcher.resolution_changes = true;
    RosRobot robot(options);
    const QJsonObject first = grid(robot, square(0, 0, 10)), second = grid(robot, square(0, 0, 10));
    QCOMPARE(at(first, "info.origin.position.x").toDouble(), 15.0);
    QCOMPARE(at(first, "info.width").toInt(), 200);
    QCOMPARE(at(second, "info.width").toInt(), 100);
  }

  void aGridThatIsLaidOutAnewIsTold() {
    Options options = with();
    options.faults.ros.dispatcher.regrids = true;
    RosRobot robot(options);
    robot->subscribe("/map_metadata");
    robot->first("/map_metadata");
    for (int i = 0; i < 4; ++i) grid(robot, square(0, 0, 1));
    QVERIFY(QTest::qWaitFor([&] { return robot->count("/map_metadata") > 1; }, 30'000));
    QVERIFY(at(robot->last("/map_metadata"), "origin.position.x").toDouble() > -500);
  }

  void aBoxAndASphereHoldTheirPoints() {
    RosRobot robot(with());
    const auto in_box = pointsOf(cloud(robot, box(3, 4, 2, 6)));
    QVERIFY(!in_box.isEmpty());
    for (const auto& point : in_box) {
      QVERIFY(std::abs(point[0] - 3) <= 3.001F && std::abs(point[1] - 4) <= 3.001F &&
              std::abs(point[2] - 2) <= 3.001F);
    }
    const auto in_sphere = pointsOf(cloud(robot, box(3, 4, 2, 0, 3)));
    QVERIFY(!in_sphere.isEmpty() && in_sphere.size() < in_box.size());
    for (const auto& point : in_sphere)
      QVERIFY(std::hypot(point[0] - 3, point[1] - 4, point[2] - 2) <= 3.001F);
    QVERIFY(!at(robot->ask("/map_dispatcher/get_sub_point_map", box(0, 0, 0, 1, -1)), "result").toBool(true));
    const auto voxels = pointsOf(cloud(robot, box(3, 4, 2, 6), "/map_dispatcher/get_sub_occupancy_map"));
    QVERIFY(!voxels.isEmpty());
    for (const auto& voxel : voxels) {
      const float cells = voxel[0] / 0.25F - 0.5F;
      QVERIFY(std::abs(cells - std::round(cells)) < 1e-3F);
    }
  }

  void storeysLieAboveEachOther() {
    RosRobot robot(with());
    float lowest = 1e9F, highest = -1e9F;
    for (const auto& point : pointsOf(cloud(robot, box(0, 0, 8, 40)))) {
      lowest = std::min(lowest, point[2]);
      highest = std::max(highest, point[2]);
    }
    QVERIFY(lowest >= 0 && lowest < 0.1F && highest > 16 && highest < 18);
  }

  void cloudsAreLaidDownInManyWays_data() {
    QTest::addColumn<QString>("layout");
    for (const char* layout :
         {"big-endian", "float64", "odd offsets", "no z", "point-step", "row-step", "width", "data"})
      QTest::newRow(layout) << QString::fromLatin1(layout);
  }
  void cloudsAreLaidDownInManyWays() {
    QFETCH(QString, layout);
    const auto is = [&](const char* what) { return layout == QLatin1String(what); };
    RosRobot usual(with());
    const QJsonObject right = cloud(usual, box(3, 4, 2, 6));
    Options options = with();
    auto& odd = options.faults.ros.dispatcher.cloud;
    odd.big_endian = is("big-endian");
    odd.float64 = is("float64");
    odd.odd_offsets = is("odd offsets");
    odd.no_z = is("no z");
    if (layout.contains(QLatin1Char('-')) && !odd.big_endian) odd.lie = layout.toStdString();
    if (is("width") || is("data")) odd.lie = layout.toStdString();
    RosRobot robot(options);
    const QJsonObject other = cloud(robot, box(3, 4, 2, 6));
    QVERIFY(other != right);
    QCOMPARE(at(other, "is_bigendian").toBool(), odd.big_endian);
    QCOMPARE(at(other, "fields").toArray().size(), odd.no_z ? 4 : 5);
    QCOMPARE(at(other, "width").toInt() == at(right, "width").toInt(), !is("width"));
    const qint64 said = at(other, "width").toInteger() * at(other, "point_step").toInteger();
    QCOMPARE(said == bytesOf(other).size(), odd.lie.empty() || is("row-step"));
  }

  void theTypeOfTheRepOnlyTellsProjections() {
    RosRobot robot(with());
    QCOMPARE(at(robot->values("/rosapi/service_type", R"({"service":"/map_dispatcher/set_map_projections"})"),
                "type")
                 .toString(),
             QStringLiteral("map_msgs/SetMapProjections"));
    QCOMPARE(at(robot->values("/map_dispatcher/set_map_projections"), "projected_maps_info").toArray().size(),
             2);
    QVERIFY(!at(robot->ask("/map_dispatcher/set_map_projections", R"({"projected_maps_info":[]})"), "result")
                 .toBool(true));
  }

  void projectionsThatAreSetAreShown() {
    Options options = with();
    options.ros.dispatcher.writable = true;
    options.ros.dialect = RosDialect::Ros2;
    RosRobot robot(options);
    QCOMPARE(at(robot->values("/rosapi/service_type", R"({"service":"/map_dispatcher/set_map_projections"})"),
                "type")
                 .toString(),
             QStringLiteral("map_msgs/srv/ProjectedMapsInfo"));
    robot->subscribe("/map_dispatcher/projected_map_0", R"(,"type":"map_msgs/msg/ProjectedMap")");
    QCOMPARE(at(robot->first("/map_dispatcher/projected_map_0"), "map.info.width").toInt(), 400);
    QVERIFY(at(robot->ask("/map_dispatcher/set_map_projections",
                          R"({"projected_maps_info":[{"frame_id":"map","x":1.04,"y":0,"width":3,"height":2,)"
                          R"("min_z":4,"max_z":5}]})"),
               "result")
                .toBool());
    QVERIFY(QTest::qWaitFor([&] { return robot->count("/map_dispatcher/projected_map_0") > 1; }, 30'000));
    const QJsonObject told = robot->last("/map_dispatcher/projected_map_0");
    QCOMPARE(at(told, "map.info.width").toInt(), 30);
    QCOMPARE(at(told, "map.info.origin.position.x").toDouble(), 1.0);
    QCOMPARE(at(told, "min_z").toDouble(), 4.0);
    const QJsonArray topics = robot->values("/rosapi/topics")[QLatin1String("topics")].toArray();
    QVERIFY(topics.contains(QStringLiteral("/map_dispatcher/projected_map_0")));
    QVERIFY(!topics.contains(QStringLiteral("/map_dispatcher/projected_map_1")));
  }

  void theExtensionTellsWhatIsSaved() {
    RosRobot robot(with());
    QVERIFY(at(robot->ask("/map_dispatcher/save_map", R"({"filename":{"data":"office.png"}})"), "result")
                .toBool());
    QVERIFY(!at(robot->ask("/map_dispatcher/save_map", R"({"filename":{"data":"office.docx"}})"), "result")
                 .toBool(true));
  }

  void withoutOneNothingOfItIsThere() {
    RosRobot robot;
    QVERIFY(!at(robot->ask("/map_dispatcher/get_sub_map", square(0, 0, 1)), "result").toBool(true));
    const QJsonArray services = robot->values("/rosapi/services")[QLatin1String("services")].toArray();
    QVERIFY(!services.contains(QStringLiteral("/map_dispatcher/get_sub_map")));
    QVERIFY(services.contains(QStringLiteral("/static_map")));
  }
};

}  // namespace test_ros_dispatcher

MAPWRIGHT_TEST(test_ros_dispatcher, TestRosDispatcher, Core)
#include "test_ros_dispatcher.moc"
