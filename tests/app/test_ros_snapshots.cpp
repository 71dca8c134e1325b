// Snapshots of ROS robots: what is placed late is in the picture, and what has no place is named.
#include <QTest>
#include <QTimer>

#include "../robot/scripted_bridge.h"
#include "program.h"
#include "test_program.h"

namespace test_ros_snapshots {

using namespace mapwright;
using robot::testing::ScriptedBridge;

namespace {

QJsonObject json(const QByteArray& text) {
  const QJsonDocument document = QJsonDocument::fromJson(text);
  if (!document.isObject()) qFatal("a test writes what is no JSON");
  return document.object();
}

QByteArray header(const char* frame) {
  return R"("header":{"frame_id":")" + QByteArray(frame) + R"(","stamp":{"secs":5,"nsecs":0}})";
}

QByteArray pose(double x) {
  return R"({"position":{"x":)" + QByteArray::number(x) +
         R"(,"y":0,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}})";
}

QByteArray cube(const char* frame, int id) {
  return "{" + header(frame) + R"(,"ns":"a","id":)" + QByteArray::number(id) +
         R"(,"type":1,"action":0,"pose":)" + pose(id) + R"(,"scale":{"x":1,"y":1,"z":1}})";
}

}  // namespace

}  // namespace test_ros_snapshots

namespace test_ros_snapshots {  // opened again: moc loses count of the braces in raw strings above

class RosSnapshotsTest : public QObject {
  Q_OBJECT
 private:
  tests::Program program_;

  struct Drawn {
    int code = -1;
    QByteArray picture;
    QString warnings;
    bool complete = false;
  };
  /// `tf_after_ms`: when the odometry is placed in the map; negative: never.
  Drawn draw(int tf_after_ms) const {
    ScriptedBridge bridge;
    const auto latched = [&](const char* topic, const char* type, const QByteArray& message) {
      bridge.advertise(QLatin1String(topic), QLatin1String(type));
      bridge.latch(QLatin1String(topic), json(message));
    };
    bridge.advertise(QStringLiteral("/tf"), QStringLiteral("tf2_msgs/TFMessage"));
    latched("/map", "nav_msgs/OccupancyGrid",
            "{" + header("map") + R"(,"info":{"resolution":1,"width":4,"height":1,"origin":)" + pose(0) +
                R"(},"data":[0,0,0,100]})");
    latched("/markers", "visualization_msgs/MarkerArray",
            R"({"markers":[)" + cube("map", 1) + "," + cube("odom", 2) + "," + cube("odom", 3) + "]}");
    const auto tf = [](const char* child) {
      return json(
          R"({"transforms":[{)" + header("map") + R"(,"child_frame_id":")" + child +
          R"(","transform":{"translation":{"x":0,"y":0,"z":0},"rotation":{"x":0,"y":0,"z":0,"w":1}}}]})");
    };
    // Where the robot is is told at once.
    bridge.keep(QStringLiteral("/tf"), tf("base_link"));
    QTimer look;
    QElapsedTimer asked;
    QObject::connect(&look, &QTimer::timeout, &look, [&] {
      if (!bridge.isAskedFor("/tf")) return;
      if (!asked.isValid()) asked.start();
      if (tf_after_ms < 0 || asked.elapsed() < tf_after_ms) return;
      bridge.send(QStringLiteral("/tf"), tf("odom"));
      look.stop();
    });
    look.start(20);
    const auto ended = program_.run(
        {QStringLiteral("snapshot"), QStringLiteral("--robot"),
         QStringLiteral("ros+") + bridge.url().toString(), QStringLiteral("--mode"), QStringLiteral("whole"),
         QStringLiteral("--layers"), QStringLiteral("boxes"), QStringLiteral("-o"), QStringLiteral("a.png"),
         QStringLiteral("--report"), QStringLiteral("a.json")});
    Drawn drawn;
    drawn.code = ended.code;
    drawn.picture = program_.bytes("a.png");
    const QJsonObject report = QJsonDocument::fromJson(program_.bytes("a.json")).object();
    for (const QJsonValue& one : report[QLatin1String("warnings")].toArray())
      drawn.warnings += one.toString() + QLatin1Char('\n');
    drawn.complete = report[QLatin1String("complete")].toBool();
    return drawn;
  }

 private Q_SLOTS:
  void markersOfAnyFrameAreInThePicture() {
    const Drawn early = draw(0), late = draw(1'500);
    QCOMPARE(early.code, 0);
    QVERIFY2(late.code == 0 && late.complete, qPrintable(late.warnings));
    QVERIFY(!early.picture.isEmpty() && early.picture == late.picture);
  }

  void markersWithoutATransformAreCountedAndNamed() {
    const Drawn drawn = draw(-1);
    QCOMPARE(drawn.code, 1);
    QVERIFY(!drawn.complete);
    QVERIFY2(drawn.warnings.contains(QLatin1String("2 markers of /markers")), qPrintable(drawn.warnings));
    QVERIFY(drawn.picture != draw(0).picture);
  }
};

}  // namespace test_ros_snapshots

MAPWRIGHT_TEST(test_ros_snapshots, RosSnapshotsTest, Core)
#include "test_ros_snapshots.moc"
