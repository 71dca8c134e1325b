// Mapping with the simulated robot: a task runs, the session and the pictures follow, its end leaves a map.
#include <QImage>
#include <QSet>

#include "listening.h"
#include "test_program.h"

namespace test_mapping {

using mapwright::simulator::Options;

namespace {

raw::HttpReply start(const Running& robot, const char* body = R"({"continue_mapping":false})") {
  return robot.send("POST", "/mappings/", body);
}
raw::HttpReply end(const Running& robot, const char* body = R"({"state":"finished"})") {
  return robot.send("PATCH", "/mappings/current", body);
}
QSize pictureSize(const Running& robot, const std::string& path) {
  return QImage::fromData(QByteArray::fromStdString(robot.get(path).body), "PNG").size();
}
QString stateOf(const QJsonObject& task) { return task[QLatin1String("state")].toString(); }

}  // namespace

class TestMapping : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aTaskRunsUntilItIsFinished() {
    Running robot(paused(60));
    const auto reply = start(robot);
    QCOMPARE(reply.status, 201);
    const QJsonObject task = object(reply.body);
    QCOMPARE(task[QLatin1String("id")].toInt(), 49);
    QCOMPARE(stateOf(task), QStringLiteral("running"));
    QVERIFY(task[QLatin1String("end_time")].isNull() && task[QLatin1String("image_url")].isNull());
    QCOMPARE(object(robot.get("/mappings/current").body), task);
    QCOMPARE(array(robot.get("/mappings/").body).first().toObject(), task);
    QCOMPARE(robot.get("/mappings/49.png").status, 404);

    robot.advance(40);
    const auto ended = end(robot);
    QCOMPARE(ended.status, 200);
    const QJsonObject done = object(robot.get("/mappings/49").body);
    QCOMPARE(object(ended.body), done);
    QCOMPARE(stateOf(done), QStringLiteral("finished"));
    QCOMPARE(done[QLatin1String("end_time")].toInt() - done[QLatin1String("start_time")].toInt(), 40);
    QVERIFY(pictureSize(robot, "/mappings/49.png").width() > 100);
    QCOMPARE(array(robot.get("/mappings/49/trajectories.json").body).size(), 2);
    QVERIFY(!array(robot.get("/mappings/49/landmarks.json").body).isEmpty());
    QCOMPARE(robot.get("/mappings/current").status, 404);

    const auto map = robot.send("POST", "/maps/", R"({"map_name":"New","mapping_id":49})");
    QCOMPARE(map.status, 201);
    QCOMPARE(pictureSize(robot, "/maps/13.png"), pictureSize(robot, "/mappings/49.png"));
  }

  void theSessionIsTheMappingWhileItRuns() {
    Listening robot(paused(60));
    QCOMPARE(robot.of("/slam/state")[QLatin1String("state")].toString(), QStringLiteral("positioning"));
    QVERIFY(!robot.text("/submap_list").isEmpty());
    const auto list = [&] { return raw::readList(robot.client->of("/submap_list").last().toStdString()); };
    const raw::List before = list();
    QVERIFY(before.find(0, 0) != nullptr && before.slam_state == "positioning");
    QCOMPARE(start(robot).status, 201);
    QTRY_COMPARE(robot.last("/slam/state")[QLatin1String("state")].toString(), QStringLiteral("slam"));
    QTRY_VERIFY(list().slam_state == "slam");
    QVERIFY(list().uuid != before.uuid);
    for (const raw::Entry& entry : list().entries) QCOMPARE(entry.trajectory, 1);
    // Nothing of what is mapped is forgotten, and all of it can be fetched.
    robot.advance(200);
    QTRY_VERIFY(list().entries.size() > 20);
    const raw::List grown = list();
    QVERIFY(grown.find(1, 0) != nullptr);
    QVERIFY(raw::fetch(robot.port(), grown.uuid, *grown.find(1, 0)).has_value());
    QCOMPARE(end(robot, R"({"state":"cancelled"})").status, 200);
    QTRY_VERIFY(list().slam_state == "positioning");
    QVERIFY(list().find(0, 0) != nullptr && list().uuid != grown.uuid);
  }

  void theMapGrowsWhileItIsMade() {
    Listening robot(paused(60));
    const QJsonObject kept = robot.of("/map");
    QCOMPARE(start(robot).status, 201);
    QTRY_VERIFY(robot.last("/map")[QLatin1String("size")] != kept[QLatin1String("size")]);
    const QJsonObject small = robot.last("/map");
    robot.advance(60);
    QTRY_VERIFY_WITH_TIMEOUT(robot.last("/map")[QLatin1String("data")] != small[QLatin1String("data")],
                             20'000);
    const auto area = [](const QJsonObject& map) {
      return map[QLatin1String("size")][0].toInt() * map[QLatin1String("size")][1].toInt();
    };
    QVERIFY(area(robot.last("/map")) > area(small));
    QCOMPARE(end(robot, R"({"state":"cancelled"})").status, 200);
    QTRY_COMPARE(robot.last("/map")[QLatin1String("data")], kept[QLatin1String("data")]);
  }

  void aCancelledTaskLeavesNoMap() {
    Running robot(paused(60));
    QCOMPARE(start(robot).status, 201);
    QCOMPARE(stateOf(object(end(robot, R"({"state":"cancelled"})").body)), QStringLiteral("cancelled"));
    QCOMPARE(robot.get("/mappings/49.png").status, 404);
    QCOMPARE(robot.send("POST", "/maps/", R"({"map_name":"x","mapping_id":49})").status, 400);
  }

  void aContinuedMapHoldsTheOldOneUnlessOnlyTheNewIsWanted() {
    QSize sizes[2];
    int i = 0;
    for (const char* how :
         {R"({"state":"finished","new_map_only":false})", R"({"state":"finished","new_map_only":true})"}) {
      Running robot(paused(60));
      QCOMPARE(start(robot, R"({"continue_mapping":true,"start_pose_type":"current_pose"})").status, 201);
      robot.advance(10);
      QCOMPARE(end(robot, how).status, 200);
      sizes[i++] = pictureSize(robot, "/mappings/49.png");
    }
    QVERIFY(sizes[0].width() > sizes[1].width());
  }

  void onlyOneTaskRunsAndNothingDisturbsIt() {
    Running robot(paused(60));
    QCOMPARE(end(robot).status, 404);
    QCOMPARE(start(robot).status, 201);
    QCOMPARE(start(robot).status, 400);
    QCOMPARE(robot.send("DELETE", "/mappings/49", "").status, 400);
    QCOMPARE(robot.send("DELETE", "/mappings/", "").status, 400);
    QCOMPARE(robot.send("POST", "/chassis/current-map", R"({"map_id":2})").status, 400);
    QCOMPARE(robot.send("POST", "/chassis/pose", R"({"position":[0,0,0],"ori":0})").status, 400);
    QCOMPARE(robot.send("DELETE", "/mappings/48", "").status, 204);
    QCOMPARE(end(robot).status, 200);
    QCOMPARE(object(start(robot).body)[QLatin1String("id")].toInt(), 50);
    QCOMPARE(end(robot).status, 200);
    QCOMPARE(robot.send("DELETE", "/mappings/", "").status, 204);
    QCOMPARE(array(robot.get("/mappings/").body).size(), 0);
  }

  void badRequestsStartAndEndNothing_data() {
    QTest::addColumn<QByteArray>("first");
    QTest::addColumn<QByteArray>("second");
    QTest::newRow("no JSON") << QByteArray("no") << QByteArray("no");
    QTest::newRow("a list") << QByteArray("[]") << QByteArray("[]");
    QTest::newRow("texts for flags") << QByteArray(R"({"continue_mapping":"yes"})")
                                     << QByteArray(R"({"state":"finished","new_map_only":"no"})");
    QTest::newRow("words that mean nothing")
        << QByteArray(R"({"start_pose_type":"there"})") << QByteArray(R"({"state":"running"})");
  }
  void badRequestsStartAndEndNothing() {
    QFETCH(QByteArray, first);
    QFETCH(QByteArray, second);
    Running robot(paused(60));
    QCOMPARE(start(robot, first.constData()).status, 400);
    QCOMPARE(robot.get("/mappings/current").status, 404);
    QCOMPARE(start(robot, "{}").status, 201);
    QCOMPARE(end(robot, second.constData()).status, 400);
    QCOMPARE(robot.get("/mappings/current").status, 200);
  }

  void anEmptyRobotHasNothingToMap() {
    Options options = paused(60);
    options.scene = "empty";
    Running robot(options);
    QCOMPARE(start(robot).status, 400);
  }
};

}  // namespace test_mapping

MAPWRIGHT_TEST(test_mapping, TestMapping, Core)
#include "test_mapping.moc"
