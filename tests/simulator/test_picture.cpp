// The bytes of submaps: every way of packing, the same on every run, and all of them pictures of one
// building.
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "running.h"
#include "test_program.h"
#include "topic_socket.h"

namespace test_picture {

using mapwright::simulator::Options;

namespace {

/// The robot's list, over a WebSocket of its own.
std::string listOf(const Running& robot) {
  TopicSocket client(robot.port());
  if (!QTest::qWaitFor([&] { return client.isOpen(); })) return {};
  client.send(R"({"enable_topic":"/submap_list"})");
  if (!QTest::qWaitFor([&] { return client.of("/submap_list").size() == 1; })) return {};
  return client.of("/submap_list").first().toStdString();
}

/// World cells of 5 cm, and what a submap says of them: occupied or free for sure.
struct Reading {
  std::set<std::pair<int, int>> occupied, free;
};

Reading readingOf(const raw::Entry& entry, const ros_messages::slam::SubmapTexture& texture) {
  Reading reading;
  const auto pairs = raw::unpack(texture);
  for (int v = 0; pairs && v < pairs->height; ++v) {
    for (int u = 0; u < pairs->width; ++u) {
      const bool intensity = texture.cell_format() == 2;
      const bool occupied =
          intensity ? pairs->alpha(u, v) == 255 && pairs->value(u, v) < 60 : pairs->alpha(u, v) > 60;
      const bool free = intensity ? pairs->value(u, v) > 200 : pairs->value(u, v) > 60;
      if (!occupied && !free) continue;
      const raw::Point p = raw::worldOf(entry, texture, u, v);
      (occupied ? reading.occupied : reading.free)
          .insert({int(std::floor(p.x / 0.05)), int(std::floor(p.y / 0.05))});
    }
  }
  return reading;
}

/// The share of `walls` with a cell of `others` at most one cell away.
double shareNear(const std::vector<std::pair<int, int>>& walls, const std::set<std::pair<int, int>>& others) {
  std::size_t near = 0;
  for (const auto& [x, y] : walls) {
    bool found = false;
    for (int dy = -1; dy <= 1 && !found; ++dy) {
      for (int dx = -1; dx <= 1 && !found; ++dx) found = others.contains({x + dx, y + dy});
    }
    near += found ? 1 : 0;
  }
  return walls.empty() ? 0 : double(near) / double(walls.size());
}

/// The cells of `walls` that the other reading has seen, or should have: free or occupied within one cell.
std::vector<std::pair<int, int>> seenByBoth(const Reading& one, const Reading& other) {
  std::vector<std::pair<int, int>> walls;
  for (const auto& cell : one.occupied) {
    for (const auto& step : {std::pair{0, 0}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}}) {
      const std::pair<int, int> at{cell.first + step.first, cell.second + step.second};
      if (other.free.contains(at) || other.occupied.contains(at)) {
        walls.push_back(cell);
        break;
      }
    }
  }
  return walls;
}

}  // namespace

class TestPicture : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPackingAndFormatOccurs() {
    Running robot(paused(200));
    const raw::List list = raw::readList(listOf(robot));
    std::set<std::string> packings;
    std::set<int> formats;
    int with_two_slices = 0, with_one = 0, rolled = 0, slices_turned = 0;
    for (const raw::Entry& entry : list.entries) {
      const auto response = raw::fetch(robot.port(), list.uuid, entry);
      QVERIFY(response.has_value());
      QCOMPARE(response->status().code(), ros_messages::slam::OK);
      QCOMPARE(response->submap_version(), entry.version);
      (response->textures_size() == 2 ? with_two_slices : with_one) += 1;
      for (const ros_messages::slam::SubmapTexture& texture : response->textures()) {
        QVERIFY2(raw::unpack(texture).has_value(), raw::packingOf(texture).c_str());
        packings.insert(raw::packingOf(texture));
        formats.insert(texture.cell_format());
        QVERIFY(texture.slice_pose().x() != 0 || texture.slice_pose().y() != 0);
      }
      if (response->textures_size() == 2) {
        QVERIFY(response->textures(0).z_level() != response->textures(1).z_level());
      }
      if (std::abs(entry.pose[3]) > 1e-3) ++rolled;
      if (std::abs(response->textures(0).slice_pose().qz()) > 1e-3) ++slices_turned;
      if (response->textures(0).cell_format() == 2) QVERIFY(entry.nearby);
    }
    QCOMPARE(packings, (std::set<std::string>{"png-gray", "png-palette", "png-gray-alpha", "gzip-2", "zlib-2",
                                              "raw-2", "raw-1", "gzip-1"}));
    QCOMPARE(formats, (std::set<int>{0, 1, 2}));
    QVERIFY(with_two_slices > 3 && with_one > 3 && rolled > 3 && slices_turned > 3);
  }

  void aPausedRobotSaysTheSameOnEveryRun() {
    const auto everything = [](std::uint32_t seed) {
      Options options = paused(100);
      options.seed = seed;
      Running robot(options);
      std::map<std::string, std::string> said;
      said["list"] = listOf(robot);
      said["info"] = robot.get("/device/info").body;
      const raw::List list = raw::readList(said["list"]);
      for (const raw::Entry& entry : list.entries) {
        if (entry.index % 5 != 0 && entry.trajectory == 0) continue;
        const std::string name = std::to_string(entry.trajectory) + "/" + std::to_string(entry.index);
        said[name] = robot.get("/ros/slam/submaps/" + list.uuid + "/" + name + "?ver=1").body;
      }
      return said;
    };
    const auto first = everything(7);
    QVERIFY(first.size() > 20);
    for (const auto& [name, body] : first) QVERIFY2(!body.empty(), name.c_str());
    QVERIFY(everything(7) == first);
    QVERIFY(everything(8) != first);
  }

  void neighboursShowTheSameWalls() {
    Running robot(paused(60));
    const raw::List list = raw::readList(listOf(robot));
    std::map<std::pair<int, int>, Reading> readings;
    for (const raw::Entry& entry : list.entries) {
      if (entry.index > 16) continue;
      const auto response = raw::fetch(robot.port(), list.uuid, entry);
      QVERIFY(response.has_value());
      const ros_messages::Pose& slice = response->textures(0).slice_pose();
      QVERIFY(std::abs(raw::worldOf(entry, response->textures(0), 40, 90).z) < 1e-9);
      QVERIFY(std::isfinite(slice.qw()));
      readings[{entry.trajectory, entry.index}] = readingOf(entry, response->textures(0));
    }
    int compared = 0;
    for (const auto& [id, reading] : readings) {
      const auto next = readings.find({id.first, id.second + 1});
      if (next == readings.end()) continue;
      const auto walls = seenByBoth(reading, next->second);
      if (walls.size() < 300) continue;
      ++compared;
      const double share = shareNear(walls, next->second.occupied);
      QVERIFY2(share > 0.8, qPrintable(QStringLiteral("%1-%2: %3").arg(id.first).arg(id.second).arg(share)));
      std::vector<std::pair<int, int>> shifted;  // the measure itself must notice a shift
      for (const auto& [x, y] : walls) shifted.emplace_back(x + 5, y + 5);
      QVERIFY(shareNear(shifted, next->second.occupied) < 0.5 * share);
    }
    QVERIFY(compared > 20);
  }

  void theLiveTrajectoryShowsTheWallsOfTheMap() {
    Running robot(paused(60));
    const raw::List list = raw::readList(listOf(robot));
    Reading map;
    std::vector<Reading> live;
    for (const raw::Entry& entry : list.entries) {
      if (entry.trajectory > 1 || (entry.trajectory == 1 && entry.version < 20)) continue;
      const auto response = raw::fetch(robot.port(), list.uuid, entry);
      QVERIFY(response.has_value());
      Reading reading = readingOf(entry, response->textures(0));
      if (entry.trajectory == 0) {
        map.occupied.merge(reading.occupied);
        map.free.merge(reading.free);
      } else {
        live.push_back(std::move(reading));
      }
    }
    QVERIFY(live.size() >= 5);
    for (const Reading& reading : live) {
      const auto walls = seenByBoth(reading, map);
      QVERIFY(walls.size() > 300);
      QVERIFY(shareNear(walls, map.occupied) > 0.9);
    }
  }

  void aNewVersionHasNewCells() {
    Running robot;
    const std::string path = "/ros/slam/submaps/" + robot.uuid() + "/0/6?ver=";
    const std::string before = robot.get(path + "24").body;
    robot.bumpVersion(0, 6);
    const std::string after = robot.get(path + "25").body;
    ros_messages::slam::SubmapQueryV2Response one, two;
    QVERIFY(one.ParseFromString(before) && two.ParseFromString(after));
    QVERIFY(one.textures(0).cells() != two.textures(0).cells());
  }

  void aPoseMovesWithoutNewCells() {
    Running robot;
    const std::string path = "/ros/slam/submaps/" + robot.uuid() + "/0/6?ver=24";
    const std::string before = robot.get(path).body;
    robot.closeLoop();
    QVERIFY(!before.empty());
    QVERIFY(robot.get(path).body == before);
  }
};

}  // namespace test_picture

MAPWRIGHT_TEST(test_picture, TestPicture, Core)
#include "test_picture.moc"
