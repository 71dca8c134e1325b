// What lasts in a recording: what is to be seen at a time follows from everything before it, whether it is
// played to there, jumped to, or lies in a part that is played alone.
#include <cmath>
#include <random>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "../robot/ros_recordings.h"
#include "excerpt/excerpt.h"
#include "excerpt/recording_slice.h"
#include "map/world.h"
#include "recording/message.h"
#include "replay/chunks.h"
#include "replay/reading.h"
#include "robot/recorded/recorded_robot.h"
#include "test_program.h"

namespace test_lasting {

using namespace mapwright;
using namespace mapwright::robot;
using recordings::Drive;
using recordings::Encoding;
using recordings::RosOut;

namespace {

constexpr double kStartS = 1'700'000'003.125;

/// Everything that is drawn, said at random times, and what of it is to be seen at a time: reckoned from the
/// rules of ROS alone (tf2, visualization_msgs/Marker, map_msgs/OccupancyGridUpdate).
class Story {
 public:
  struct Seen {
    std::vector<std::pair<double, double>> markers;  // places, sorted
    std::optional<std::pair<double, double>> hit;    // of the scan
    std::optional<double> path_x;
    std::string cells;  // of the costmap, rows from below
  };

  /// `ns`: of the topics. `repeated`: static transforms are said again and again.
  Story(unsigned seed, double seconds, const std::string& ns, bool repeated)
      : random_(seed), ns_(ns), seconds_(seconds) {
    const double mounted_s = 3 + any(int(seconds * 0.6));
    transforms("/tf_static", kStartS, {{"base_link", "camera", 0, 0}});
    grid(kStartS + 0.01);
    for (int step = 0; step < int(seconds * 5); ++step) {
      const double at_s = kStartS + step * 0.2 + 0.003;
      if (step > 0 && step % 2 == 0) transforms("/tf", at_s, {{"odom", "base_link", moved(at_s), 0}});
      if (step % 5 == 0) transforms("/tf", at_s + 0.01, {{"map", "odom", drifted(at_s + 0.01), 0}});
      const bool mounts = !laser_m_ && step * 0.2 > mounted_s;
      if (mounts || (laser_m_ && !repeated && any(150) == 0)) {
        laser_m_ = 0.25 + any(100) / 100.0;
        mounts_.push_back({at_s + 0.02, *laser_m_});
        transforms("/tf_static", at_s + 0.02, {{"base_link", "laser", *laser_m_, 0}});
        next_scan_ = step + 8;  // what is mounted later places it as well
      } else if (repeated && laser_m_) {
        transforms("/tf_static", at_s + 0.02, {{"base_link", "laser", *laser_m_, 0}});
      }
      if (any(30) == 0)
        transforms("/tf_static", at_s + 0.03, {{"laser", "laser", 9, 0}});  // nobody can use it
      if (step > 10 && step >= next_scan_ && step % 4 == 1 && any(3) > 0) scan(at_s + 0.05);
      if (step > 15 && any(12) == 0) markers(at_s + 0.07);
      if (any(40) == 0) grid(at_s + 0.08);
      if (step > 0 && any(9) == 0) patch(at_s + 0.09);
      if (any(60) == 0) path(at_s + 0.1);
    }
    std::stable_sort(said_.begin(), said_.end(),
                     [](const Drive::Said& a, const Drive::Said& b) { return a.at_s < b.at_s; });
  }

  const std::vector<Drive::Said>& said() const { return said_; }
  double any(int below) { return double(random_() % unsigned(below)); }

  Seen seenAt(double at_s) const {
    Seen seen;
    std::map<std::pair<std::string, int>, std::pair<double, std::pair<double, double>>> there;
    for (const Put& put : puts_) {
      if (put.at_s > at_s) break;
      if (put.action == 3) {
        std::erase_if(there, [&](const auto& one) { return one.first.first.starts_with(put.topic + ' '); });
      } else if (put.action == 2) {
        there.erase({put.topic + ' ' + put.ns, put.id});
      } else {
        const double until_s = put.lives_s > 0 ? put.at_s + put.lives_s : HUGE_VAL;
        there[{put.topic + ' ' + put.ns, put.id}] = {until_s, put.place};
      }
    }
    for (const auto& [key, one] : there) {
      if (one.first > at_s) seen.markers.push_back(one.second);
    }
    std::sort(seen.markers.begin(), seen.markers.end());
    for (const Scan& scan : scans_) {
      if (scan.at_s > at_s) break;
      std::optional<double> laser_m;
      for (const auto& [since_s, x_m] : mounts_) {
        if (since_s <= scan.at_s + 1) laser_m = x_m;
      }
      if (laser_m) seen.hit = {robotAt(scan.of_s) + *laser_m + 2, kY};
    }
    for (const auto& [since_s, x_m] : paths_) {
      if (since_s <= at_s) seen.path_x = x_m;
    }
    for (const auto& [since_s, change] : cells_) {
      if (since_s <= at_s) change(seen.cells);
    }
    return seen;
  }

 private:
  struct Transform {
    std::string parent, child;
    double x, y;
  };
  struct Put {
    double at_s;
    std::string topic, ns;
    int id, action;
    double lives_s;
    std::pair<double, double> place;
  };
  struct Scan {
    double at_s, of_s;
  };
  static constexpr double kY = -3;
  static constexpr std::uint32_t kSize = 8;

  // Along lines, so that what lies between two transforms is known.
  static double moved(double at_s) { return (at_s - kStartS) * 0.5; }
  static double drifted(double at_s) { return 10 + (at_s - kStartS) * 0.125; }
  static double robotAt(double at_s) { return moved(at_s) + drifted(at_s); }

  void transforms(const std::string& topic, double at_s, const std::vector<Transform>& rows) {
    said_.push_back({ns_ + topic, "tf2_msgs/TFMessage", at_s, [=](RosOut& out) {
                       out.list("transforms", rows.size(), [&](std::size_t i) {
                         out.header(at_s, rows[i].parent).text("child_frame_id", rows[i].child);
                         out.object("transform", [&] {
                           const double y = rows[i].parent == "map" ? kY : rows[i].y;
                           out.object("translation",
                                      [&] { out.f64("x", rows[i].x).f64("y", y).f64("z", 0); });
                           out.turn("rotation", 0);
                         });
                       });
                     }});
  }
  void scan(double at_s) {
    const double of_s = at_s - 0.1;
    scans_.push_back({at_s, of_s});
    said_.push_back({ns_ + "/scan", "sensor_msgs/LaserScan", at_s, [=](RosOut& out) {
                       out.header(of_s, "laser").f32("angle_min", 0).f32("angle_max", 0);
                       out.f32("angle_increment", 0.5).f32("time_increment", 0).f32("scan_time", 0);
                       out.f32("range_min", 0.125).f32("range_max", 30);
                       out.numbers("ranges", std::vector<float>{2});
                       out.numbers("intensities", std::vector<float>{});
                     }});
  }
  void markers(double at_s) {
    const std::string topic = ns_ + (any(2) > 0 ? "/markers" : "/objects");
    const double of_s = at_s - 1.3;  // all transforms of then have come
    std::vector<Put> all;
    std::vector<std::string> frames;
    const int count = 1 + int(any(3));
    for (int i = 0; i < count; ++i) {
      constexpr const char* kFrames[] = {"map", "odom", "base_link"};
      const std::string frame = kFrames[int(any(3))];
      const int what = int(any(12));
      Put put{at_s, topic, any(2) > 0 ? "box" : "door", int(any(4)), what == 0 ? 3 : what < 3 ? 2 : 0, 0, {}};
      constexpr double kLives[] = {0, 0, 2, 15, 70};
      put.lives_s = put.action == 0 ? kLives[int(any(5))] : 0;
      const double x = any(1000) / 8, y = any(1000) / 8;
      put.place = frame == "map"    ? std::pair(x, y)
                  : frame == "odom" ? std::pair(x + drifted(of_s), y + kY)
                                    : std::pair(x + robotAt(of_s), y + kY);
      frames.push_back(frame);
      places_.push_back({x, y});
      all.push_back(put);
      puts_.push_back(put);
    }
    const std::vector<std::pair<double, double>> own(places_.end() - count, places_.end());
    said_.push_back({topic, "visualization_msgs/MarkerArray", at_s, [=](RosOut& out) {
                       out.list("markers", all.size(), [&](std::size_t i) {
                         out.header(of_s, frames[i]).text("ns", all[i].ns).i32("id", all[i].id);
                         out.i32("type", 1).i32("action", all[i].action);
                         out.pose("pose", own[i].first, own[i].second, 0);
                         out.object("scale", [&] { out.f64("x", 1).f64("y", 1).f64("z", 1); });
                         out.time("lifetime", all[i].lives_s);
                       });
                     }});
  }
  void grid(double at_s) {
    std::string cells;
    for (std::uint32_t i = 0; i < kSize * kSize; ++i) cells += char(any(101));
    cells_.push_back({at_s, [=](std::string& seen) { seen = cells; }});
    said_.push_back({ns_ + "/global_costmap/costmap", "nav_msgs/OccupancyGrid", at_s, [=](RosOut& out) {
                       out.header(at_s, "map").object("info", [&] {
                         out.time("map_load_time", at_s).f32("resolution", 0.5);
                         out.u32("width", kSize).u32("height", kSize).pose("origin", -1, -2, 0);
                       });
                       out.numbers("data", std::vector<std::int8_t>(cells.begin(), cells.end()));
                     }});
  }
  void patch(double at_s) {
    const auto x = std::uint32_t(any(kSize)), y = std::uint32_t(any(kSize - 1));
    const auto a = std::int8_t(any(101)), b = std::int8_t(any(101));
    cells_.push_back({at_s, [=](std::string& seen) {
                        seen[y * kSize + x] = char(a);
                        seen[(y + 1) * kSize + x] = char(b);
                      }});
    said_.push_back(
        {ns_ + "/global_costmap/costmap_updates", "map_msgs/OccupancyGridUpdate", at_s, [=](RosOut& out) {
           out.header(at_s, "map").i32("x", int(x)).i32("y", int(y)).u32("width", 1).u32("height", 2);
           out.numbers("data", std::vector<std::int8_t>{a, b});
         }});
  }
  void path(double at_s) {
    const double x_m = any(1000) / 8;
    paths_.push_back({at_s, x_m});
    said_.push_back({ns_ + "/plan", "nav_msgs/Path", at_s, [=](RosOut& out) {
                       out.header(at_s, "map").list("poses", 2, [&](std::size_t i) {
                         out.header(at_s, "map").pose("pose", x_m + double(i), 1, 0);
                       });
                     }});
  }

  std::mt19937 random_;
  std::string ns_;
  double seconds_;
  std::optional<double> laser_m_;
  int next_scan_ = 0;
  std::vector<Drive::Said> said_;
  std::vector<Put> puts_;
  std::vector<std::pair<double, double>> places_, mounts_, paths_;
  std::vector<Scan> scans_;
  std::vector<std::pair<double, std::function<void(std::string&)>>> cells_;
};

bool waitFor(const std::function<bool()>& condition) {
  QTimer look;
  look.start(20);
  const QDeadlineTimer deadline(120'000);
  while (!condition()) {
    if (deadline.hasExpired()) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  }
  return true;
}

/// A recording that is open, as the window has it.
class Open {
 public:
  explicit Open(const QString& path) : key_{BagKind::File, recorded::bagNameOf(path)} {
    recorded::RecordedOptions options;
    options.path = path;
    robot_ = std::make_unique<recorded::RecordedRobot>(QStringLiteral("file:") + path, options);
    replay::Reading::Options reading;
    reading.chunks.messages_per_cell = 200;
    reading_ = std::make_unique<replay::Reading>(*robot_->bagLibrary(), key_, reading);
    bool open = false;
    QObject::connect(reading_.get(), &replay::Reading::opened, reading_.get(), [&] { open = true; });
    reading_->open();
    if (!waitFor([&] { return open; })) qFatal("not opened");
  }
  map::LiveState jumpTo(double at_s) {
    reading_->want(at_s);
    replay::Moment moment;
    const bool exact = waitFor([&] {
      if (!reading_->chunks().readUntil(at_s)) return false;
      moment = reading_->moment();
      return moment.knowledge == replay::Knowledge::Exact;
    });
    if (!exact) qFatal("not exact");
    return moment.at.world.live;
  }
  BagChunkPtr whole() {
    std::optional<Outcome<BagChunkPtr>> told;
    robot_->bagLibrary()->messages(key_, {0, 4e9}, [&](auto outcome) { told = std::move(outcome); });
    if (!waitFor([&] { return told.has_value(); }) || !*told) qFatal("not played");
    return **told;
  }

 private:
  BagKey key_;
  std::unique_ptr<recorded::RecordedRobot> robot_;
  std::unique_ptr<replay::Reading> reading_;
};

/// All messages in order until then: playing from the beginning.
class Played {
 public:
  explicit Played(BagChunkPtr chunk) : chunk_(std::move(chunk)) {
    for (const BagMessage& message : chunk_->messages) all_.push_back(&message);
    std::stable_sort(all_.begin(), all_.end(), [](const BagMessage* a, const BagMessage* b) {
      return a->message.received_s < b->message.received_s;
    });
  }
  map::LiveState until(double at_s) const {
    map::World world;
    for (const BagMessage* message : all_) {
      if (message->known && message->message.received_s <= at_s)
        world = map::reduce(std::move(world), message->message);
    }
    return world.live;
  }

 private:
  BagChunkPtr chunk_;
  std::vector<const BagMessage*> all_;
};

std::vector<std::pair<double, double>> placesOf(const map::LiveState& live) {
  std::vector<std::pair<double, double>> places;
  for (const map::GroundBox& box : live.seen_objects) places.push_back({box.pose.x_m, box.pose.y_m});
  std::sort(places.begin(), places.end());
  return places;
}

QByteArray wordsOf(const std::vector<std::pair<double, double>>& places) {
  QByteArray words;
  for (const auto& [x, y] : places)
    words += QByteArray::number(x, 'f', 4) + ',' + QByteArray::number(y, 'f', 4) + ' ';
  return words;
}

/// Empty: it shows that.
QByteArray difference(const map::LiveState& live, const Story::Seen& seen) {
  if (wordsOf(placesOf(live)) != wordsOf(seen.markers))
    return "markers " + wordsOf(placesOf(live)) + " instead of " + wordsOf(seen.markers);
  std::vector<std::pair<double, double>> hits, wanted;
  for (const auto& [topic, points] : live.clouds) {
    for (const map::CloudPoint& point : *points) hits.push_back({point.x_m, point.y_m});
  }
  if (seen.hit) wanted.push_back(*seen.hit);
  if (wordsOf(hits) != wordsOf(wanted)) return "scan " + wordsOf(hits) + " instead of " + wordsOf(wanted);
  const bool path = live.path.empty() ? !seen.path_x : seen.path_x == live.path.front().x();
  if (!path) return "path";
  const auto grid = live.grids.find(map::GridKind::CostmapLow);
  std::string pixels;
  for (std::size_t row = 8; row-- > 0 && !seen.cells.empty();) pixels += seen.cells.substr(row * 8, 8);
  if ((grid == live.grids.end()) != pixels.empty()) return "costmap";
  if (!pixels.empty() && !grid->second.png->ends_with(pixels)) return "cells of the costmap";
  return {};
}

/// Everything but the way there.
QByteArray difference(const map::LiveState& part, const map::LiveState& whole) {
  if (placesOf(part) != placesOf(whole))
    return "markers " + wordsOf(placesOf(part)) + " instead of " + wordsOf(placesOf(whole));
  if (part.robot_pose != whole.robot_pose) return "pose";
  if (part.path != whole.path) return "path";
  if (part.grids != whole.grids) return "grids";
  if (part.clouds.size() != whole.clouds.size()) return "clouds";
  for (const auto& [topic, points] : part.clouds) {
    if (*points != *whole.clouds.at(topic)) return "cloud";
  }
  return part.drawings == whole.drawings ? QByteArray() : "drawings";
}

/// Sessions and maps that change, and what lies in them.
std::string sessionOfAnAutoxingRobot() {
  std::mt19937 random(3);
  const auto number = [&](int below) { return int(random() % unsigned(below)); };
  const auto bytes = std::make_shared<std::string>();
  recording::WriterOptions options;
  options.chunk_bytes = 5'000;
  const auto writer = recordings::writerInto(bytes, options);
  for (int i = 0; i < 1500; ++i) {
    const std::string n = std::to_string(number(9)), session = std::to_string(i / 400);
    const std::vector<std::pair<std::string, std::string>> all = {
        {"/submap_list", R"("uuid":"s)" + session + R"(","slam_state":"slam","submap":[])"},
        {"/map/info", R"("uid":"m)" + std::to_string(i / 250) + R"(","map_name":"Hall","map_version":1)"},
        {"/path", R"("positions":[[)" + n + ",1],[" + std::to_string(i) + ",2]]"},
        {"/battery_state", R"("percentage":0.)" + n},
        {"/nearby_robot_footprints", R"("footprints":[{"digest":"d)" + n +
                                         R"(","coordinates":[[0,0],[1,0],[1,)" + std::to_string(i) + "]]}]"},
        {"/tracked_pose", R"("pos":[)" + std::to_string(i * 0.1) + "," + n + R"(],"ori":0.5)"}};
    const auto& [topic, rest] = all[std::size_t(i % 400 > 200 && i % 3 > 0 ? 5 : number(6))];
    recording::Channel channel;
    channel.topic = topic;
    channel.message_encoding = "json";
    const std::int64_t at_ns = recordings::nanoseconds(kStartS + i * 0.1);
    writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0},
                  recordings::bytesOf(R"({"topic":")" + topic + "\"," + rest + "}"));
  }
  writer->close();
  return *bytes;
}

}  // namespace

}  // namespace test_lasting

namespace test_lasting {  // opened again: moc loses count of the braces in raw strings above

class LastingTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  int files_ = 0;

  QString written(const Story& story, Encoding encoding) {
    const bool bag = encoding == Encoding::Bag;
    const QString path = folder_.filePath(
        QStringLiteral("%1.%2").arg(++files_).arg(bag ? QStringLiteral("bag") : QStringLiteral("mcap")));
    recording::WriterOptions options;
    options.chunk_bytes = 20'000;
    const std::string bytes = recordings::recordingOf(story.said(), encoding, options);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
    file.write(bytes.data(), qint64(bytes.size()));
    return path;
  }
  static void stories() {
    QTest::addColumn<Encoding>("encoding");
    QTest::addColumn<QString>("ns");
    QTest::addColumn<bool>("repeated");
    QTest::newRow("CDR") << Encoding::Cdr << QString() << false;
    QTest::newRow("JSON, a namespace") << Encoding::Json << QStringLiteral("/robot1") << false;
    QTest::newRow("a bag, repeated") << Encoding::Bag << QString() << true;
    QTest::newRow("ROS 1, a namespace, repeated") << Encoding::Ros1 << QStringLiteral("/a/b") << true;
  }

 private Q_SLOTS:
  void theWorldOfAnyTimeIsAFoldOfEverythingBeforeIt_data() { stories(); }
  void theWorldOfAnyTimeIsAFoldOfEverythingBeforeIt() {
    QFETCH(const Encoding, encoding);
    QFETCH(const QString, ns);
    QFETCH(const bool, repeated);
    const unsigned seeds = qEnvironmentVariableIntValue("MAPWRIGHT_TEST_SEEDS") + 4u;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      constexpr double kSeconds = 150;
      Story story(seed * 7 + unsigned(encoding), kSeconds, ns.toStdString(), repeated);
      const QString path = written(story, encoding);
      const Played played(Open(path).whole());
      Open open(path);
      for (int jump = 0; jump < 12; ++jump) {
        const double at_s = kStartS + story.any(int(kSeconds * 1000) - 2000) / 1000;
        const QByteArray when =
            QByteArray::number(int(seed)) + " at " + QByteArray::number(at_s - kStartS) + ": ";
        const map::LiveState there = open.jumpTo(at_s);
        const QByteArray fold = difference(there, story.seenAt(at_s));
        QVERIFY2(fold.isEmpty(), when + fold);
        QVERIFY2(there == played.until(at_s), when + difference(there, played.until(at_s)));
      }
    }
  }

  void aPartShowsWhatTheWholeShows_data() { stories(); }
  void aPartShowsWhatTheWholeShows() {
    QFETCH(const Encoding, encoding);
    QFETCH(const QString, ns);
    QFETCH(const bool, repeated);
    const unsigned seeds = qEnvironmentVariableIntValue("MAPWRIGHT_TEST_SEEDS") + 3u;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      constexpr double kSeconds = 150;
      Story story(seed * 11 + unsigned(encoding), kSeconds, ns.toStdString(), repeated);
      const QString path = written(story, encoding);
      const Played whole(Open(path).whole());
      auto slicing = excerpt::Slicing::open(path.toStdString());
      QVERIFY(slicing.has_value());
      QString source = path;
      for (int cut = 0; cut < 6; ++cut) {
        const double from_s = kStartS + 1 + story.any(int(kSeconds * 900)) / 1000;
        const double to_s = from_s + 2 + story.any(30'000) / 1000;
        const QString part = folder_.filePath(QStringLiteral("part %1.mcap").arg(++files_));
        excerpt::Order order;
        order.path = part.toStdString();
        order.span = {from_s, to_s};
        const auto cut_out = slicing->slice(order);
        QVERIFY(cut_out && *cut_out);
        const auto said =
            std::int64_t(std::count_if(story.said().begin(), story.said().end(), [&](const Drive::Said& one) {
              return one.topic.ends_with("/tf_static") && one.at_s < from_s;
            }));
        // Ten seconds of transforms, and little more than what counts.
        QVERIFY2(!repeated || said < 300 || (*cut_out)->said_before < 300,
                 QByteArray::number((*cut_out)->said_before));
        const Played alone(Open(part).whole());
        Open open(part);
        for (int look = 0; look < 5; ++look) {
          const double at_s =
              look == 0 ? from_s + 0.25 : from_s + 0.25 + story.any(int((to_s - from_s) * 1000)) / 1000;
          const QByteArray when = QByteArray::number(int(seed)) + " from " +
                                  QByteArray::number(from_s - kStartS) + " at " +
                                  QByteArray::number(at_s - kStartS) + ": ";
          // At its end transforms of what came last may be missing: those of the map come once a second.
          if (at_s > std::min(to_s - 1.2, kStartS + kSeconds - 2)) continue;
          const QByteArray fold = difference(open.jumpTo(at_s), story.seenAt(at_s));
          QVERIFY2(fold.isEmpty(), when + fold);
          const QByteArray same = difference(alone.until(at_s), whole.until(at_s));
          QVERIFY2(same.isEmpty(), when + same);
        }
      }
    }
  }

  // Sessions and maps change, and a new one forgets what lay in the one before it.
  void aPartOfASessionWithAnAutoxingRobotShowsWhatTheWholeShows_data() {
    QTest::addColumn<bool>("copied");
    QTest::newRow("of a recording on this computer") << true;
    QTest::newRow("of a bag of a robot") << false;
  }
  void aPartOfASessionWithAnAutoxingRobotShowsWhatTheWholeShows() {
    QFETCH(const bool, copied);
    std::mt19937 random(3);
    const auto number = [&](int below) { return int(random() % unsigned(below)); };
    const std::string bytes = sessionOfAnAutoxingRobot();
    const QString path = folder_.filePath(QStringLiteral("session.mcap"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes.data(), qint64(bytes.size()));
    file.close();
    const BagChunkPtr all = Open(path).whole();
    const Played whole(all);
    int known = 0;
    for (int cut = 0; cut < 40; ++cut) {
      excerpt::Order order;
      order.path = folder_.filePath(QStringLiteral("part %1.mcap").arg(++files_)).toStdString();
      order.span.from_s = kStartS + 5 + number(1400) * 0.1 + 0.05;
      order.span.to_s = *order.span.from_s + 10;
      if (copied) {
        QVERIFY(excerpt::sliceRecording(path.toStdString(), order));
      } else {
        auto writing = excerpt::begin(order);
        QVERIFY(writing.has_value());
        QVERIFY(!(*writing)->add(replay::inRange(all)));
        QVERIFY((*writing)->place().has_value());
      }
      const Played part(Open(QString::fromStdString(order.path)).whole());
      for (int look = 0; look < 5; ++look) {
        const double at_s = *order.span.from_s + number(100) * 0.1;
        const map::LiveState alone = part.until(at_s), wanted = whole.until(at_s);
        const QByteArray when =
            QByteArray::number(*order.span.from_s - kStartS) + " at " + QByteArray::number(at_s - kStartS);
        QVERIFY2(alone.session_uuid == wanted.session_uuid, when);
        QVERIFY2(alone.map_info == wanted.map_info, when);
        QVERIFY2(alone.path == wanted.path, when);
        QVERIFY2(alone.battery == wanted.battery, when);
        QVERIFY2(alone.robot_pose == wanted.robot_pose, when);
        QVERIFY2(alone.nearby_footprints == wanted.nearby_footprints, when);
        known += wanted.nearby_footprints.size() > 3 ? 1 : 0;
      }
    }
    QVERIFY(known > 20);
  }

  // A part of a part is a part of the whole.
  void aPartOfAPartShowsIt() {
    constexpr double kSeconds = 120;
    Story story(5, kSeconds, "", false);
    const QString path = written(story, Encoding::Cdr);
    const Played whole(Open(path).whole());
    const QString first = folder_.filePath(QStringLiteral("first.mcap")),
                  second = folder_.filePath(QStringLiteral("second.mcap"));
    excerpt::Order order;
    order.path = first.toStdString();
    order.span.from_s = kStartS + 60.4;
    QVERIFY(excerpt::sliceRecording(path.toStdString(), order));
    order.path = second.toStdString();
    order.span.from_s = kStartS + 75.8;
    QVERIFY(excerpt::sliceRecording(first.toStdString(), order));
    Open open(second);
    for (const double after_s : {76.1, 80.0, 93.3, 118.0}) {
      const QByteArray fold = difference(open.jumpTo(kStartS + after_s), story.seenAt(kStartS + after_s));
      QVERIFY2(fold.isEmpty(), fold);
    }
  }
};

}  // namespace test_lasting

MAPWRIGHT_TEST(test_lasting, LastingTest, Core)
#include "test_lasting.moc"
