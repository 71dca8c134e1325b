// A recording as a robot: what it plays is what was recorded, whatever range is asked for.
#include <cmath>
#include <random>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "foxglove_recordings.h"
#include "map/world.h"
#include "recording/message.h"
#include "replay/chunks.h"
#include "replay/reading.h"
#include "replay/replay_robot.h"
#include "replay/track.h"
#include "robot/axbot/parse_topics.h"
#include "robot/recorded/faults.h"
#include "robot/recorded/recorded_robot.h"
#include "robot/ros/faults.h"
#include "ros_messages/slam.pb.h"
#include "ros_recordings.h"
#include "sentences/failure_sentence.h"
#include "test_program.h"

namespace test_recorded_robot {

using namespace mapwright;
using namespace mapwright::robot;
using recordings::Drive;
using recordings::Encoding;
using recordings::RosOut;

namespace {

constexpr int kLongMs = 60'000;

bool waitFor(const std::function<bool()>& condition) {
  // With a limit of its own processEvents() does not wait: what is waited for would have to share its core.
  QTimer look;
  look.start(20);
  const QDeadlineTimer deadline(kLongMs);
  while (!condition()) {
    if (deadline.hasExpired()) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  }
  return true;
}

/// A frame of an Autoxing robot, and when it was recorded.
struct Said {
  double at_s = 0;
  std::string topic, text;
};

std::vector<Said> axbotSession(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto number = [&](int below) { return int(random() % unsigned(below)); };
  std::vector<Said> all;
  double at_s = 1'717'405'200.25;
  const auto say = [&](const std::string& topic, const std::string& rest) {
    all.push_back({at_s, topic, "{\"topic\": \"" + topic + "\"" + rest + "}"});
  };
  for (int i = 0; i < count; ++i) {
    if (number(4) > 0) at_s += double(number(200)) / 1000;
    if (number(200) == 0) at_s += number(30);
    const std::string x = std::to_string(double(i) / 10), n = std::to_string(number(9));
    switch (number(9)) {
      case 0:
        say("/submap_list",
            ",\"uuid\":\"s" + std::to_string(i / 300) + "\",\"slam_state\":\"slam\",\"submap\":[]");
        break;
      case 1:
        say("/alerts", ",\"alerts\":[{\"code\":600" + n + ",\"level\":\"error\",\"msg\":\"Hot " + n + "\"}]");
        break;
      case 2:
        say("/wheel_state", ",\"control_mode\":\"auto\",\"emergency_stop_pressed\":" +
                                std::string(number(2) ? "true" : "false"));
        break;
      case 3:
        say("/path", ",\"positions\":[[" + x + ",1],[" + n + ",2]]");
        break;
      case 4:
        say("/unheard_of", ",\"n\":" + n);
        break;
      case 5:
        say("/battery_state", ",\"percentage\":0." + n);
        break;
      default:
        say("/tracked_pose", ",\"pos\":[" + x + "," + n + "],\"ori\":0.5");
    }
  }
  return all;
}

std::string recordingOf(const std::vector<Said>& said, recording::WriterOptions options = {}) {
  const auto bytes = std::make_shared<std::string>();
  const auto writer = recordings::writerInto(bytes, options);
  for (const Said& one : said) {
    recording::Channel channel;
    channel.topic = one.topic;
    channel.message_encoding = "json";
    const std::int64_t at_ns = recordings::nanoseconds(one.at_s);
    writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(one.text));
  }
  writer->close();
  return *bytes;
}

/// The world that playing all of them until then makes, by nothing that plays files.
map::World foldedUntil(const std::vector<Said>& said, double at_s) {
  map::World world;
  for (const Said& one : said) {
    const double stamp_s = recording::secondsOf(recordings::nanoseconds(one.at_s));
    if (stamp_s > at_s) break;
    const axbot::TextFrame frame = axbot::parseTextFrame(one.text);
    if (frame.message) world = map::reduce(std::move(world), {*frame.message, stamp_s, {}, one.topic});
  }
  return world;
}

map::World foldedUntil(const BagChunk& chunk, double at_s) {
  std::vector<const BagMessage*> all;
  for (const BagMessage& message : chunk.messages) all.push_back(&message);
  std::stable_sort(all.begin(), all.end(), [](const BagMessage* a, const BagMessage* b) {
    return a->message.received_s < b->message.received_s;
  });
  map::World world;
  for (const BagMessage* message : all) {
    if (message->known && message->message.received_s <= at_s)
      world = map::reduce(std::move(world), message->message);
  }
  return world;
}

/// A robot on a curve, with everything at odd rates and in no order among equal times; and what all of it
/// says of a time, by nothing that plays files.
class Curve {
 public:
  static constexpr double kStartS = 1'700'000'003.125;
  struct World {
    std::optional<geometry::Pose2> pose;
    int path = -1, markers = 0;
  };

  explicit Curve(unsigned seed) {
    std::mt19937 random(seed);
    const auto stamp = [](double after_s) {
      return recording::secondsOf(recordings::nanoseconds(kStartS) + std::llround(after_s * 1e9));
    };
    for (int step = 0; step < 40 * 37; ++step) {
      const double at_s = stamp(step / 37.0), of_s = at_s - 0.004;
      const double part = step / 37.0, x_m = 3 * std::sin(part / 4), y_m = part * 0.9, yaw = part / 7;
      std::vector<Drive::Said> now{tf("/tf", at_s, of_s, "odom", "base_link", x_m, y_m, yaw)};
      moves_.push_back({at_s, of_s, {x_m, y_m, yaw}});
      if (step % 4 == 0) {
        // Where the map lies drifts; it is told ahead of its time, as localisations do.
        now.push_back(tf("/tf", at_s, at_s + 0.1, "map", "odom", 10 + part / 10, -3, 0.25));
        drifts_.push_back({at_s, at_s + 0.1, {10 + part / 10, -3, 0.25}});
      }
      // It says nothing of where the robot is on the map, once transforms do.
      now.push_back({"/odom", "nav_msgs/Odometry", at_s, [=](RosOut& out) {
                       out.header(of_s, "odom").text("child_frame_id", "base_link");
                       const geometry::Pose2 wheels = wheelsOf({x_m, y_m, yaw});
                       out.object("pose", [&] { out.pose("pose", wheels.x_m, wheels.y_m, wheels.yaw_rad); });
                     }});
      if (step % 61 == 7) {
        const int path = int(paths_.size());
        paths_.push_back(at_s);
        now.push_back({"/plan", "nav_msgs/Path", at_s, [=](RosOut& out) {
                         out.header(of_s, "map").list("poses", 2, [&](std::size_t i) {
                           out.header(of_s, "map").pose("pose", path + double(i) / 8, 0, 0);
                         });
                       }});
      }
      if (step % 113 == 50) {
        const int id = int(random() % 3);
        const double lives_s = double(random() % 6'000) / 1000 + 0.001;
        put_.push_back({at_s, id, lives_s});
        now.push_back({"/markers", "visualization_msgs/MarkerArray", at_s, [=](RosOut& out) {
                         out.list("markers", 1, [&](std::size_t) {
                           out.header(of_s, "map").text("ns", "box").i32("id", id);
                           out.i32("type", 1).i32("action", 0).pose("pose", 1, 1, 0);
                           out.object("scale", [&] { out.f64("x", 1).f64("y", 1).f64("z", 1); });
                           out.time("lifetime", lives_s);
                         });
                       }});
      }
      std::shuffle(now.begin(), now.end(), random);
      said_.insert(said_.end(), now.begin(), now.end());
    }
  }

  const std::vector<Drive::Said>& said() const { return said_; }
  World foldedUntil(double at_s) const {
    World world;
    const Place *move = last(moves_, at_s), *drift = last(drifts_, at_s);
    if (move && drift) {
      // By the transforms, where they have a time in common; else where its wheels say that it is.
      const auto of_s = commonOf(at_s);
      const geometry::Pose2 from = of_s ? at(drifts_, *of_s) : drift->pose;
      const geometry::Pose2 robot = of_s ? at(moves_, *of_s) : wheelsOf(move->pose);
      const double c = std::cos(from.yaw_rad), s = std::sin(from.yaw_rad);
      world.pose = {from.x_m + c * robot.x_m - s * robot.y_m, from.y_m + s * robot.x_m + c * robot.y_m,
                    geometry::normalizeAngle(from.yaw_rad + robot.yaw_rad)};
    }
    for (std::size_t i = 0; i < paths_.size() && paths_[i] <= at_s; ++i) world.path = int(i);
    std::map<int, double> until;
    for (const Put& put : put_) {
      if (put.at_s <= at_s) until[put.id] = put.at_s + put.lives_s;
    }
    for (const auto& [id, until_s] : until) world.markers += until_s > at_s ? 1 : 0;
    return world;
  }
  /// The times at which another place of the robot was known.
  std::vector<double> posed() const {
    std::vector<double> times;
    std::optional<double> of_s;
    for (const Place& move : moves_) {
      const auto now_s = commonOf(move.at_s);
      if (!now_s || now_s != of_s) times.push_back(move.at_s);
      of_s = now_s;
    }
    return times;
  }

 private:
  struct Place {
    double at_s = 0, of_s = 0;  // when it was said, and of which time
    geometry::Pose2 pose;
  };
  struct Put {
    double at_s = 0;
    int id = 0;
    double lives_s = 0;
  };
  static geometry::Pose2 wheelsOf(const geometry::Pose2& robot) {
    return {robot.x_m - 0.1, robot.y_m, robot.yaw_rad};
  }
  static Drive::Said tf(const char* topic, double at_s, double of_s, std::string parent, std::string child,
                        double x_m, double y_m, double yaw) {
    return {topic, "tf2_msgs/TFMessage", at_s, [=](RosOut& out) {
              out.list("transforms", 1, [&](std::size_t) {
                out.header(of_s, parent).text("child_frame_id", child);
                out.object("transform", [&] {
                  out.object("translation", [&] { out.f64("x", x_m).f64("y", y_m).f64("z", 0); });
                  out.turn("rotation", yaw);
                });
              });
            }};
  }
  /// The latest time of which both parts of the chain tell (tf2).
  std::optional<double> commonOf(double at_s) const {
    const Place* const move = last(moves_, at_s);
    const Place* const drift = last(drifts_, at_s);
    if (!move || !drift) return std::nullopt;
    const double of_s = std::min(move->of_s, drift->of_s);
    const bool known = of_s >= moves_.front().of_s && of_s >= drifts_.front().of_s;
    return known ? std::optional(of_s) : std::nullopt;
  }
  static const Place* last(const std::vector<Place>& places, double at_s) {
    const Place* found = nullptr;
    for (const Place& place : places) {
      if (place.at_s <= at_s) found = &place;
    }
    return found;
  }
  static geometry::Pose2 at(const std::vector<Place>& places, double of_s) {
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Place &before = places[i - 1], &after = places[i];
      if (of_s < before.of_s || of_s > after.of_s) continue;
      const double share = (of_s - before.of_s) / (after.of_s - before.of_s);
      return {before.pose.x_m + share * (after.pose.x_m - before.pose.x_m),
              before.pose.y_m + share * (after.pose.y_m - before.pose.y_m),
              before.pose.yaw_rad + share * (after.pose.yaw_rad - before.pose.yaw_rad)};
    }
    return places.front().pose;
  }

  std::vector<Drive::Said> said_;
  std::vector<Place> moves_, drifts_;
  std::vector<double> paths_;
  std::vector<Put> put_;
};

}  // namespace

}  // namespace test_recorded_robot

namespace test_recorded_robot {  // opened again: moc loses count of the braces in raw strings above

class RecordedRobotTest : public QObject {
  Q_OBJECT
  using RecordedRobot = recorded::RecordedRobot;
  QTemporaryDir folder_;
  int files_ = 0;

  QString written(const std::string& bytes, const QString& suffix = QStringLiteral("mcap")) {
    const QString path = folder_.filePath(QStringLiteral("%1.%2").arg(++files_).arg(suffix));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
    file.write(bytes.data(), qint64(bytes.size()));
    return path;
  }
  static std::unique_ptr<recorded::RecordedRobot> opened(const QString& path) {
    recorded::RecordedOptions options;
    options.path = path;
    return std::make_unique<recorded::RecordedRobot>(QStringLiteral("file:") + path, options);
  }
  static BagKey keyOf(const QString& path) { return {BagKind::File, recorded::bagNameOf(path)}; }

  template <typename T>
  static Outcome<T> answer(const std::function<Call(OutcomeTo<T>)>& ask) {
    std::optional<Outcome<T>> told;
    ask([&](Outcome<T> outcome) { told = std::move(outcome); });
    if (!waitFor([&] { return told.has_value(); })) qFatal("no answer");
    return std::move(*told);
  }
  static Outcome<BagChunkPtr> range(RecordedRobot& robot, const BagKey& key, double from_s, double until_s) {
    return answer<BagChunkPtr>([&](auto reply) {
      return robot.bagLibrary()->messages(key, {from_s, until_s}, std::move(reply));
    });
  }
  static Outcome<BagChunkPtr> forPrograms(RecordedRobot& robot, const BagKey& key) {
    BagRange all{0, 4e9};
    all.whole_texts = true;
    return answer<BagChunkPtr>(
        [&](auto reply) { return robot.bagLibrary()->messages(key, all, std::move(reply)); });
  }
  static QJsonObject jsonOf(const BagChunk& chunk, const BagMessage& message) {
    const std::string_view text = chunk.textOf(message);
    return QJsonDocument::fromJson(QByteArray(text.data(), qsizetype(text.size()))).object();
  }
  static Outcome<BagInfo> infoOf(RecordedRobot& robot, const BagKey& key) {
    return answer<BagInfo>([&](auto reply) { return robot.bagLibrary()->info(key, std::move(reply)); });
  }
  static std::string sentence(const map::Failure& failure) { return sentences::sentenceOf(failure); }

  /// As the window would: jumps there, waits until the world is exact.
  static map::World worldAt(replay::Reading& reading, double at_s) {
    reading.want(at_s);
    replay::Moment moment;
    const bool exact = waitFor([&] {
      if (!reading.chunks().readUntil(at_s)) return false;
      moment = reading.moment();
      return moment.knowledge == replay::Knowledge::Exact;
    });
    if (!exact) qFatal("not exact");
    return moment.at.world;
  }
  static void compareSeeks(RecordedRobot& robot, const BagKey& key, int seeks,
                           const std::function<map::World(double)>& expected) {
    replay::Reading::Options options;
    options.chunks.messages_per_cell = 40;
    replay::Reading reading(*robot.bagLibrary(), key, options);
    bool open = false;
    connect(&reading, &replay::Reading::opened, &reading, [&] { open = true; });
    reading.open();
    QVERIFY(waitFor([&] { return open; }));
    std::mt19937 random(7);
    const double length_s = reading.info()->end_s - reading.info()->start_s;
    for (int seek = 0; seek < seeks; ++seek) {
      const double at_s = reading.info()->start_s - 1 + (length_s + 3) * double(random() % 10'000) / 10'000;
      const map::World world = worldAt(reading, at_s), wanted = expected(at_s);
      QVERIFY2(world.live == wanted.live, qPrintable(QString::number(at_s - reading.info()->start_s)));
      QVERIFY(world.submaps == wanted.submaps);
      QCOMPARE(world.at_s, wanted.at_s);
    }
  }

 private Q_SLOTS:
  void aSessionOfAnAutoxingRobotIsPlayedAsItWas() {
    const std::vector<Said> said = axbotSession(3, 1500);
    const QString path = written(recordingOf(said));
    const auto robot = opened(path);
    const auto rows = answer<std::vector<BagEntry>>(
        [&](auto reply) { return robot->bagLibrary()->list(std::move(reply)); });
    QVERIFY(rows && rows->size() == 1);
    QCOMPARE(rows->front().key, keyOf(path));
    const auto info = infoOf(*robot, keyOf(path));
    QVERIFY(info);
    QCOMPARE(info->messages, std::int64_t(said.size()));
    QVERIFY(std::abs(info->start_s - said.front().at_s) < 1e-5 &&
            std::abs(info->end_s - said.back().at_s) < 1e-5);
    compareSeeks(*robot, keyOf(path), 60, [&](double at_s) { return foldedUntil(said, at_s); });
  }

  void theTextOfAFrameIsTheFrameWithItsTime() {
    const std::vector<Said> said = axbotSession(4, 50);
    const QString path = written(recordingOf(said));
    const auto robot = opened(path);
    const auto chunk = range(*robot, keyOf(path), 0, 4e9);
    QVERIFY(chunk && (*chunk)->messages.size() == said.size());
    for (std::size_t i = 0; i < said.size(); ++i) {
      char stamp[60];
      const long long at_ns = recordings::nanoseconds(said[i].at_s);
      std::snprintf(stamp, sizeof(stamp), ",\"__stamp\":%lld.%09lld}", at_ns / 1'000'000'000,
                    at_ns % 1'000'000'000);
      QCOMPARE(std::string((*chunk)->textOf((*chunk)->messages[i])),
               said[i].text.substr(0, said[i].text.size() - 1) + stamp);
    }
  }

  void whatAFrameDoesNotSayItsChannelSays() {
    const std::string path_text = R"({"pos":[1,2],"ori":0})";
    const QString path = written(recordingOf({{10.5, "/tracked_pose", path_text},
                                              {11, "/tracked_pose", "{}"},
                                              {12, "/odd", R"({"topic":null,"__stamp":7, "n":1} )"}}));
    const auto robot = opened(path);
    const auto chunk = range(*robot, keyOf(path), 0, 100);
    QVERIFY(chunk && (*chunk)->messages.size() == 3);
    const auto text = [&](std::size_t i) { return std::string((*chunk)->textOf((*chunk)->messages[i])); };
    QCOMPARE(text(0), std::string(R"({"pos":[1,2],"ori":0,"topic":"/tracked_pose","__stamp":10.500000000})"));
    QCOMPARE(text(1), std::string(R"({"topic":"/tracked_pose","__stamp":11.000000000})"));
    QCOMPARE(
        text(2),
        std::string(R"({"topic":"/odd","__stamp":12.000000000,"msg":{"topic":null,"__stamp":7, "n":1} })"));
    const map::World world = foldedUntil(**chunk, 10.75);
    QVERIFY((*chunk)->messages[0].known && world.live.robot_pose);
  }

  void whatAMessageSaysItselfStaysAndItsChannelCounts_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("as_it_is");
    const auto row = [](const char* text, bool as_it_is) { QTest::newRow(text) << text << as_it_is; };
    row(R"({"n":1})", true);
    row(R"({"topic":"/a","n":1})", true);
    row(R"({"n":1,"__stamp":10.5})", true);
    row(R"({"topic":"/a","__stamp":10.500000000,"n":1})", true);
    row(R"({"topic":"/door/3","text":"open"})", false);
    row(R"({"topic":"","n":1})", false);
    row(R"({"topic":7})", false);
    row(R"({"topic":{"name":"/a"}})", false);
    row(R"({"__stamp":5})", false);
    row(R"({"__stamp":"10.5"})", false);
    row(R"({"__stamp":null})", false);
    row(R"({"topic":"/a","__stamp":10.6})", false);
    row(R"({"topic":"/tracked_pose","pos":[1,2],"ori":0})", false);
  }
  void whatAMessageSaysItselfStaysAndItsChannelCounts() {
    QFETCH(QString, text);
    QFETCH(bool, as_it_is);
    const QString path = written(recordingOf({{10.5, "/a", text.toStdString()}}));
    const auto robot = opened(path);
    for (const bool programs : {true, false}) {
      const auto chunk = programs ? forPrograms(*robot, keyOf(path)) : range(*robot, keyOf(path), 0, 100);
      QVERIFY(chunk && (*chunk)->messages.size() == 1);
      const BagMessage& message = (*chunk)->messages[0];
      QCOMPARE(message.message.topic, std::string("/a"));
      QVERIFY(!message.known);  // whatever topic it names itself
      const QJsonObject line = jsonOf(**chunk, message);
      QCOMPARE(line[QLatin1String("topic")].toString(), QStringLiteral("/a"));
      QCOMPARE(line[QLatin1String("__stamp")].toDouble(), 10.5);
      const QJsonObject own = QJsonDocument::fromJson(text.toUtf8()).object();
      QCOMPARE(line.contains(QLatin1String("msg")), !as_it_is);
      const QJsonObject got = as_it_is ? line : line[QLatin1String("msg")].toObject();
      for (const QString& key : own.keys()) QCOMPARE(got[key], own[key]);
    }
  }

  void whatCannotBeDecodedIsSaid_data() {
    QTest::addColumn<std::string>("encoding");
    QTest::addColumn<std::string>("schema_encoding");
    for (const char* encoding : {"flatbuffer", "msgpack", "protobuf", "ros3", "cdr", ""}) {
      for (const char* schema : {"", "protobuf", "flatbuffer", "ros2msg"})
        QTest::addRow("%s, %s", encoding, schema) << std::string(encoding) << std::string(schema);
    }
  }
  void whatCannotBeDecodedIsSaid() {
    QFETCH(std::string, encoding);
    QFETCH(std::string, schema_encoding);
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    recording::Channel channel;
    channel.topic = "/a";
    channel.message_encoding = encoding;
    channel.schema_name = "a.B";
    channel.schema_encoding = schema_encoding;
    channel.schema_data = "?";
    writer->write(*writer->addChannel(channel), {10, 10, 0}, recordings::bytesOf("\x7f?"));
    writer->close();
    const QString path = written(*bytes);
    for (const bool programs : {true, false}) {
      const auto robot = opened(path);
      std::vector<map::Problem> problems;
      connect(robot.get(), &Robot::problemFound, robot.get(),
              [&](const map::Problem& problem) { problems.push_back(problem); });
      const auto chunk = programs ? forPrograms(*robot, keyOf(path)) : range(*robot, keyOf(path), 0, 100);
      QVERIFY(chunk && (*chunk)->messages.size() == 1);
      const QJsonObject line = jsonOf(**chunk, (*chunk)->messages[0]);
      QCOMPARE(line[QLatin1String("bytes")].toInt(), 2);
      QCOMPARE(line.contains(QLatin1String("base64")), programs);
      QVERIFY(waitFor([&] { return !problems.empty(); }));
      QCOMPARE(problems.size(), std::size_t(1));
      QCOMPARE(problems[0].subject.id, std::string("/a"));
      // For people it is no loss: nothing would be drawn of it.
      QCOMPARE(problems[0].severity, programs ? map::Severity::Warning : map::Severity::Info);
      if (programs) QCOMPARE(problems[0].code, map::ProblemCode::Unreadable);
    }
  }

  void bytesBeyondTheDefinitionAreSaid_data() {
    QTest::addColumn<bool>("ros1");
    QTest::addColumn<int>("more");  // bytes
    QTest::addColumn<int>("said");
    QTest::newRow("ROS 1, exact") << true << 0 << 0;
    QTest::newRow("ROS 1, longer") << true << 1 << 1;
    QTest::newRow("CDR, exact") << false << 0 << 0;
    QTest::newRow("CDR, padded") << false << 7 << 0;
    QTest::newRow("CDR, longer") << false << 8 << 1;
  }
  void bytesBeyondTheDefinitionAreSaid() {
    QFETCH(const bool, ros1);
    QFETCH(const int, more);
    QFETCH(const int, said);
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    recording::Channel channel;
    channel.topic = "/a";
    channel.message_encoding = ros1 ? "ros1" : "cdr";
    channel.schema_name = ros1 ? "std_msgs/Bool" : "std_msgs/msg/Bool";
    channel.schema_encoding = ros1 ? "ros1msg" : "ros2msg";
    channel.schema_data = "bool data";
    const std::string message =
        (ros1 ? std::string("\1") : std::string("\0\1\0\0\1", 5)) + std::string(std::size_t(more), '\0');
    for (const std::int64_t at_ns : {10, 20})
      writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(message));
    writer->close();
    const QString path = written(*bytes);
    const auto robot = opened(path);
    std::vector<map::Problem> problems;
    connect(robot.get(), &Robot::problemFound, robot.get(),
            [&](const map::Problem& problem) { problems.push_back(problem); });
    const auto chunk = forPrograms(*robot, keyOf(path));
    QVERIFY(chunk && (*chunk)->messages.size() == 2);
    QVERIFY(jsonOf(**chunk, (*chunk)->messages[0])[QLatin1String("msg")].isObject());
    if (said > 0) QVERIFY(waitFor([&] { return !problems.empty(); }));
    QCoreApplication::processEvents();
    QCOMPARE(int(problems.size()), said);
    if (said > 0) QCOMPARE(problems[0].reason.code, recorded::fault::RosMessageLonger);
  }

  void manyChannelsAreNoMoreWorkThanTheirMessages() {
    for (const char* encoding : {"json", "cdr"}) {
      const auto bytes = std::make_shared<std::string>();
      const auto writer = recordings::writerInto(bytes);
      constexpr int kChannels = 65'535;
      for (int i = 0; i < kChannels; ++i) {
        recording::Channel channel;
        channel.topic = "/t" + std::to_string(i);
        channel.message_encoding = encoding;
        if (channel.message_encoding == "cdr") {
          channel.schema_name = "std_msgs/msg/Bool";
          channel.schema_encoding = "ros2msg";
          channel.schema_data = "bool data";
        }
        const auto id = *writer->addChannel(channel);
        for (const std::int64_t s : {0, 1}) {
          const std::int64_t at_ns = s * 1'000'000'000 + i;
          writer->write(
              id, {at_ns, at_ns, 0},
              recordings::bytesOf(std::string(encoding) == "json" ? "{}" : std::string("\0\1\0\0\1", 5)));
        }
      }
      writer->close();
      const QString path = written(*bytes);
      const auto robot = opened(path);
      const auto info = answer<BagInfo>(
          [&](auto reply) { return robot->bagLibrary()->info(keyOf(path), std::move(reply)); });
      QVERIFY(info);
      QCOMPARE(info->topics.size(), std::size_t(kChannels));
      for (const auto& topic : info->topics) QCOMPARE(topic.rate_hz, std::optional(1.0));
      BagRange last{0.5, 0.6};
      last.back_fill = true;
      const auto chunk = answer<BagChunkPtr>(
          [&](auto reply) { return robot->bagLibrary()->messages(keyOf(path), last, std::move(reply)); });
      QVERIFY(chunk);
      QCOMPARE((*chunk)->messages.size(), std::size_t(kChannels));
    }
  }

  void forProgramsNothingOfAMessageIsCut_data() { messagesOfRosAreTheSameInEveryRange_data(); }
  void forProgramsNothingOfAMessageIsCut() {
    QFETCH(Encoding, encoding);
    const std::vector<Drive::Said> drive = Drive{10}.all();
    const bool bag = encoding == Encoding::Bag;
    const QString path = written(recordings::recordingOf(drive, encoding),
                                 bag ? QStringLiteral("bag") : QStringLiteral("mcap"));
    const auto robot = opened(path);
    const auto chunk = forPrograms(*robot, keyOf(path));
    QVERIFY(chunk);
    // Those that were recorded, and none that was only made of them.
    QCOMPARE((*chunk)->messages.size(), drive.size());
    int grids = 0;
    for (std::size_t i = 0; i < drive.size(); ++i) {
      const QJsonObject line = jsonOf(**chunk, (*chunk)->messages[i]);
      QCOMPARE(line[QLatin1String("topic")].toString().toStdString(), drive[i].topic);
      recordings::RosOut out(Encoding::Json);
      drive[i].fill(out);
      const QJsonObject wanted = QJsonDocument::fromJson(QByteArray::fromStdString(out.done())).object();
      QJsonObject got = line[QLatin1String("msg")].toObject();
      if (drive[i].type != "nav_msgs/OccupancyGrid") continue;
      QCOMPARE(got[QLatin1String("data")], wanted[QLatin1String("data")]);
      QVERIFY(got[QLatin1String("data")].toArray().size() > 32);
      ++grids;
    }
    QCOMPARE(grids, 2);
  }

  void whatCannotBeReadIsCountedOnceAndLosesNoBytes() {
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    recording::Channel channel;
    channel.topic = "/tf";
    channel.message_encoding = "cdr";
    channel.schema_name = "tf2_msgs/msg/TFMessage";
    channel.schema_encoding = "ros2msg";
    channel.schema_data = recordings::definitionOf("tf2_msgs/TFMessage", true);
    const auto id = *writer->addChannel(channel);
    const std::string text("\0\1\0\0\7", 5);
    // One at the very start of a range is read for the one before, too.
    for (std::int64_t s = 0; s < 20; ++s)
      writer->write(id, {s * 1'000'000'000, s * 1'000'000'000, 0}, recordings::bytesOf(text));
    writer->close();
    const QString path = written(*bytes);
    const auto robot = opened(path);
    std::size_t counted = 0;
    for (int s = 0; s < 20; ++s) {
      const auto part = range(*robot, keyOf(path), s, s + 1);
      QVERIFY(part);
      counted += (*part)->unreadable;
    }
    QCOMPARE(counted, std::size_t(20));
    const auto whole = forPrograms(*robot, keyOf(path));
    QVERIFY(whole && (*whole)->messages.size() == 20);
    QCOMPARE((*whole)->unreadable, std::size_t(0));
    const QJsonObject line = jsonOf(**whole, (*whole)->messages[0]);
    QCOMPARE(line[QLatin1String("bytes")].toInt(), 5);
    QCOMPARE(QByteArray::fromBase64(line[QLatin1String("base64")].toString().toLatin1()).toStdString(), text);
  }

  void messagesWithoutAUsableTimeAreCounted() {
    recordings::RawMcap raw;
    recordings::RawMcap::channel(raw.out, 1, "/tracked_pose");
    for (const std::uint64_t at : {std::uint64_t(0), std::uint64_t(1) << 63, ~std::uint64_t(0)})
      recordings::RawMcap::message(raw.out, 1, at, R"({"pos":[1,2],"ori":0})");
    raw.end();
    const QString path = written(*raw.bytes());
    const auto robot = opened(path);
    const auto info = infoOf(*robot, keyOf(path));
    QVERIFY(info && info->start_s == 0 && info->end_s == 0);
    const auto whole = range(*robot, keyOf(path), -1, 4e9);
    QVERIFY(whole);
    QCOMPARE((*whole)->messages.size(), std::size_t(1));
    QCOMPARE((*whole)->without_stamp, std::size_t(2));
    const auto again = range(*robot, keyOf(path), -1, 4e9);
    QVERIFY(again && (*again)->without_stamp == 0);  // they are told once
  }

  void everyMessageLiesInOneRangeWhereverRangesMeet() {
    const std::vector<Said> said = axbotSession(5, 600);
    const QString path = written(recordingOf(said));
    const auto robot = opened(path);
    std::size_t count = 0;
    double from_s = said.front().at_s;
    while (from_s <= said.back().at_s) {
      const double until_s = from_s + 0.75;
      const auto chunk = range(*robot, keyOf(path), from_s, until_s);
      QVERIFY(chunk);
      for (const BagMessage& message : (*chunk)->messages)
        QVERIFY(message.message.received_s >= from_s && message.message.received_s < until_s);
      count += (*chunk)->messages.size();
      from_s = until_s;
    }
    QCOMPARE(count, said.size());
  }

  void messagesOfRosAreTheSameInEveryRange_data() {
    QTest::addColumn<Encoding>("encoding");
    QTest::newRow("json") << Encoding::Json;
    QTest::newRow("cdr") << Encoding::Cdr;
    QTest::newRow("ros1") << Encoding::Ros1;
    QTest::newRow("bag") << Encoding::Bag;
  }
  void messagesOfRosAreTheSameInEveryRange() {
    QFETCH(Encoding, encoding);
    const Drive drive{40};
    const bool bag = encoding == Encoding::Bag;
    const QString path = written(recordings::recordingOf(drive.all(), encoding),
                                 bag ? QStringLiteral("bag") : QStringLiteral("mcap"));
    const auto robot = opened(path);
    const auto whole = range(*robot, keyOf(path), 0, 4e9);
    QVERIFY2(whole, whole ? "" : sentence(whole.error()).c_str());
    std::map<std::string, int> kinds;
    for (const BagMessage& message : (*whole)->messages) {
      if (message.known) ++kinds[std::to_string(message.message.message.index())];
      QVERIFY2(!message.known || !std::holds_alternative<map::UnreadableMessage>(message.message.message),
               message.message.topic.c_str());
    }
    QVERIFY(kinds.size() >= 5);  // poses, clouds, paths, grids, markers
    std::mt19937 random(11);
    for (int times = 0; times < 40; ++times) {
      const double from_s = Drive::kStartS + double(random() % 4000) / 100;
      const double until_s = from_s + double(random() % 1000) / 100;
      const auto part = range(*robot, keyOf(path), from_s, until_s);
      QVERIFY(part);
      std::size_t at = 0;
      for (const BagMessage& message : (*whole)->messages) {
        const double stamp_s = message.message.received_s;
        if (stamp_s < from_s || stamp_s >= until_s) continue;
        QVERIFY(at < (*part)->messages.size());
        const BagMessage& same = (*part)->messages[at++];
        QVERIFY2(same.message == message.message && same.known == message.known,
                 qPrintable(QStringLiteral("%1 at %2")
                                .arg(QString::fromStdString(message.message.topic))
                                .arg(stamp_s - Drive::kStartS)));
      }
      QCOMPARE(at, (*part)->messages.size());
    }
  }

  void whatWasSaidLastBeforeARangeComesWithItWhereItIsWanted_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("least");  // topics that are known before
    QTest::newRow("axbot") << written(recordingOf(axbotSession(6, 900))) << 7;
    const std::vector<std::pair<const char*, Encoding>> encodings = {
        {"json", Encoding::Json}, {"cdr", Encoding::Cdr}, {"bag", Encoding::Bag}};
    for (const auto& [name, encoding] : encodings) {
      const bool bag = encoding == Encoding::Bag;
      QTest::newRow(name) << written(recordings::recordingOf(Drive{40}.all(), encoding),
                                     bag ? QStringLiteral("bag") : QStringLiteral("mcap"))
                          << 5;
    }
  }
  void whatWasSaidLastBeforeARangeComesWithItWhereItIsWanted() {
    QFETCH(QString, path);
    QFETCH(int, least);
    const auto robot = opened(path);
    const auto info = infoOf(*robot, keyOf(path));
    const auto whole = range(*robot, keyOf(path), 0, 4e9);
    QVERIFY(info && whole);
    const double from_s = info->start_s + (info->end_s - info->start_s) * 0.8, until_s = from_s + 2;
    const auto plain = range(*robot, keyOf(path), from_s, until_s);
    const auto filled = answer<BagChunkPtr>([&](auto reply) {
      BagRange wish{from_s, until_s};
      wish.back_fill = true;
      return robot->bagLibrary()->messages(keyOf(path), wish, std::move(reply));
    });
    QVERIFY(plain && filled);
    const std::size_t added = (*filled)->messages.size() - (*plain)->messages.size();
    QVERIFY2(added >= std::size_t(least), qPrintable(QString::number(added)));
    std::map<std::string, double> last_s;
    for (const BagMessage& message : (*whole)->messages) {
      // What is to be seen of markers changes without anybody saying so.
      if (replay::isRecorded(message) && message.message.received_s < from_s)
        last_s[message.message.topic] = message.message.received_s;
    }
    for (std::size_t i = 0; i < added; ++i) {
      const BagMessage& early = (*filled)->messages[i];
      QVERIFY(early.message.received_s < from_s);
      QCOMPARE(early.message.received_s, last_s.at(early.message.topic));
      const bool played =
          std::any_of((*whole)->messages.begin(), (*whole)->messages.end(), [&](const BagMessage& message) {
            return message.message == early.message && message.known == early.known;
          });
      QVERIFY2(played, early.message.topic.c_str());
    }
    // The range itself is what it is without them.
    for (std::size_t i = 0; i < (*plain)->messages.size(); ++i)
      QVERIFY((*filled)->messages[added + i].message == (*plain)->messages[i].message);
  }

  void aFarJumpShowsAtOnceWhatHoldsThere() {
    const std::vector<Said> said = axbotSession(8, 3000);
    const QString path = written(recordingOf(said));
    const auto robot = opened(path);
    replay::Reading::Options options;
    options.chunks.messages_per_cell = 20;
    replay::Reading reading(*robot->bagLibrary(), keyOf(path), options);
    bool open = false;
    connect(&reading, &replay::Reading::opened, &reading, [&] { open = true; });
    reading.open();
    QVERIFY(waitFor([&] { return open; }));
    const double at_s = double(reading.chunks().cellAt(said[2500].at_s)->from) / replay::kTicksPerS;
    std::optional<replay::Moment> first;
    connect(&reading, &replay::Reading::changed, &reading, [&] {
      if (first) return;
      replay::Moment moment = reading.moment();
      if (moment.knowledge != replay::Knowledge::Buffering) first = std::move(moment);
    });
    reading.want(at_s);
    QVERIFY(waitFor([&] { return first.has_value(); }));
    const map::World all = foldedUntil(said, at_s);
    QCOMPARE(int(first->knowledge), int(replay::Knowledge::LookingBack));
    QVERIFY(first->at.world.live.path == all.live.path);
    QVERIFY(first->at.world.live.battery == all.live.battery);
    QVERIFY(first->at.world.live.wheels == all.live.wheels);
    QVERIFY(first->at.world.live.robot_pose == all.live.robot_pose);
    QVERIFY(first->at.world.submaps == all.submaps);
  }

  void whatARosRobotSawLiesWhereItWas() {
    const Drive drive{30};
    const QString path = written(recordings::recordingOf(drive.all(), Encoding::Cdr));
    const auto robot = opened(path);
    const auto whole = range(*robot, keyOf(path), 0, 4e9);
    QVERIFY(whole);
    int clouds = 0, poses = 0, grids = 0;
    for (const BagMessage& message : (*whole)->messages) {
      const double stamp_s = message.message.received_s;
      if (const auto* cloud = std::get_if<map::PointCloudMessage>(&message.message.message)) {
        ++clouds;
        QCOMPARE(cloud->points->size(), std::size_t(2));
        const map::CloudPoint& hit = cloud->points->front();
        QVERIFY(std::abs(hit.x_m - (Drive::xAt(*message.message.recorded_s) + 0.25 + 2)) < 1e-6);
        QVERIFY(std::abs(hit.y_m - Drive::kOffsetY) < 1e-6);
      } else if (const auto* pose = std::get_if<map::TrackedPose>(&message.message.message)) {
        ++poses;
        // The newest that all transforms have in common.
        QVERIFY(std::abs(pose->pose.x_m - Drive::xAt(stamp_s)) < 0.5 * 0.15);
      } else if (std::holds_alternative<map::GridMessage>(message.message.message)) {
        ++grids;
      }
    }
    QVERIFY2(clouds > 145, qPrintable(QString::number(clouds)));
    QVERIFY2(poses > 290, qPrintable(QString::number(poses)));
    QVERIFY2(grids > 15, qPrintable(QString::number(grids)));
  }

  /// Robots on circles around their own places, 10 m apart, with the same names of frames.
  static std::vector<Drive::Said> severalRobots(const std::vector<std::string>& robots, double seconds) {
    std::vector<Drive::Said> said;
    const auto tf = [&](const std::string& topic, double at_s, std::string parent, std::string child,
                        double x_m, double y_m) {
      said.push_back({topic, "tf2_msgs/TFMessage", at_s, [=](RosOut& out) {
                        out.list("transforms", 1, [&](std::size_t) {
                          out.header(at_s, parent).text("child_frame_id", child);
                          out.object("transform", [&] {
                            out.object("translation", [&] { out.f64("x", x_m).f64("y", y_m).f64("z", 0); });
                            out.turn("rotation", 0);
                          });
                        });
                      }});
    };
    for (std::size_t i = 0; i < robots.size(); ++i)
      tf(robots[i] + "/tf_static", Drive::kStartS + double(i) * 0.001, "base_link", "laser", 0.25 + double(i),
         0);
    for (int step = 0; step < int(seconds * 10); ++step) {
      const double at_s = Drive::kStartS + 0.1 + step * 0.1;
      for (std::size_t i = 0; i < robots.size(); ++i) {
        const Eigen::Vector2d place = placeOf(i, at_s);
        tf(robots[i] + "/tf", at_s, "map", "odom", 10 * double(i), 0);
        tf(robots[i] + "/tf", at_s, "odom", "base_link", place.x() - 10 * double(i), place.y());
        Drive::scan(said, at_s, (robots[i] + "/scan").c_str());
      }
    }
    return said;
  }
  static Eigen::Vector2d placeOf(std::size_t robot, double at_s) {
    const double angle = (at_s - Drive::kStartS) / 3;
    return {10 * double(robot) + std::cos(angle), std::sin(angle)};
  }

  void eachRobotOfARecordingSeesAroundItself_data() {
    QTest::addColumn<QStringList>("robots");
    QTest::newRow("namespaces") << QStringList{QStringLiteral("/r1"), QStringLiteral("/r2")};
    QTest::newRow("beside one without") << QStringList{QString(), QStringLiteral("/r2")};
  }
  void eachRobotOfARecordingSeesAroundItself() {
    QFETCH(QStringList, robots);
    std::vector<std::string> names;
    for (const QString& robot : robots) names.push_back(robot.toStdString());
    const std::vector<Drive::Said> said = severalRobots(names, 40);
    const QString path = written(recordings::recordingOf(said, Encoding::Cdr));
    std::mt19937 random(5);
    for (const QString& ns : QStringList{QString()} + robots) {
      recorded::RecordedOptions options;
      options.path = path;
      options.ns = ns.toStdString();
      RecordedRobot robot(QStringLiteral("file:") + path, options);
      const std::size_t shown = ns.isEmpty() ? 0 : std::size_t(robots.indexOf(ns));
      std::set<std::string> scans;
      for (int seek = 0; seek < 12; ++seek) {
        const double from_s = Drive::kStartS + 1 + double(random() % 300) / 10;
        const auto chunk = range(robot, keyOf(path), from_s, from_s + double(random() % 90) / 10);
        QVERIFY(chunk);
        for (const BagMessage& message : (*chunk)->messages) {
          const double at_s = message.message.received_s;
          // All of them have their place, however long ago it was said where the laser is.
          if (ns.isEmpty() && message.message.topic.ends_with("/scan"))
            QVERIFY(std::holds_alternative<map::PointCloudMessage>(message.message.message));
          if (const auto* const cloud = std::get_if<map::PointCloudMessage>(&message.message.message)) {
            const auto of =
                std::find(names.begin(), names.end(), cloud->topic.substr(0, cloud->topic.rfind('/'))) -
                names.begin();
            const Eigen::Vector2d hit =
                placeOf(std::size_t(of), at_s) + Eigen::Vector2d(0.25 + double(of) + 2, 0);
            QVERIFY((Eigen::Vector2d(cloud->points->front().x_m, cloud->points->front().y_m) - hit).norm() <
                    1e-3);
            scans.insert(cloud->topic);
          } else if (const auto* const pose = std::get_if<map::TrackedPose>(&message.message.message)) {
            if (!message.known) continue;
            const Eigen::Vector2d place(pose->pose.x_m, pose->pose.y_m);
            QVERIFY((place - placeOf(shown, at_s)).norm() < 0.1);
          }
        }
      }
      QCOMPARE(scans.size(), ns == QLatin1String("/r1") || (ns == QLatin1String("/r2") && !names[0].empty())
                                 ? std::size_t(1)
                                 : std::size_t(2));
      const auto info = infoOf(robot, keyOf(path));
      QVERIFY(info && info->robots.size() == 2);
      QCOMPARE(info->robots.back(), std::string("/r2"));
    }
    recorded::RecordedOptions other;
    other.path = path;
    other.ns = "/r3";
    RecordedRobot robot(QStringLiteral("file:") + path, other);
    const auto refused = infoOf(robot, keyOf(path));
    QVERIFY(!refused);
    QVERIFY(sentence(refused.error()).find("/r2") != std::string::npos);
  }

  void aRecordingOfOneRobotNamesNone() {
    const QString path = written(recordings::recordingOf(severalRobots({"/r1"}, 3), Encoding::Cdr));
    const auto robot = opened(path);
    const auto info = infoOf(*robot, keyOf(path));
    QVERIFY(info && info->robots.empty());
  }

  void aLifetimeEndsWhereNothingIsSaid() {
    std::vector<Drive::Said> said = Drive{1}.all();
    std::erase_if(said, [](const Drive::Said& one) { return one.topic == "/markers"; });
    const double start_s = Drive::kStartS;
    said.push_back({"/markers", "visualization_msgs/MarkerArray", start_s + 0.75, [=](RosOut& out) {
                      out.list("markers", 1, [&](std::size_t) {
                        out.header(start_s + 0.75, "map").text("ns", "box").i32("id", 1);
                        out.i32("type", 1).i32("action", 0).pose("pose", 1, 1, 0);
                        out.object("scale", [&] { out.f64("x", 1).f64("y", 1).f64("z", 1); });
                        out.time("lifetime", 15);
                      });
                    }});
    std::stable_sort(said.begin(), said.end(), [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
    Drive::scan(said, start_s + 60);  // the recording goes on so long
    const QString path = written(recordings::recordingOf(said, Encoding::Json));
    const auto robot = opened(path);
    for (const double from_s : {start_s - 1, start_s + 12}) {
      const auto chunk = range(*robot, keyOf(path), from_s, start_s + 40);
      QVERIFY(chunk);
      if (from_s < start_s)
        QCOMPARE(foldedUntil(**chunk, start_s + 10).live.seen_objects.size(), std::size_t(1));
      QCOMPARE(foldedUntil(**chunk, start_s + 30).live.seen_objects.size(), std::size_t(0));
    }
  }

  void whatIsDrawnLikeMarkersIsInARecordingToo() {
    std::vector<Drive::Said> said = Drive{20}.all();
    std::erase_if(said, [](const Drive::Said& one) { return one.topic == "/markers"; });
    for (int second = 1; second < 20; ++second) {
      const double at_s = Drive::kStartS + second;
      said.push_back({"/zone", "geometry_msgs/PolygonStamped", at_s, [=](RosOut& out) {
                        out.header(at_s, "base_link").object("polygon", [&] {
                          out.list("points", 3, [&](std::size_t i) {
                            out.f64("x", double(i)).f64("y", double(i * i)).f64("z", 0);
                          });
                        });
                      }});
      said.push_back({"/poses", "geometry_msgs/PoseArray", at_s + 0.5, [=](RosOut& out) {
                        out.header(at_s, "map").list("poses", std::size_t(second), [&](std::size_t i) {
                          out.object("position", [&] { out.f64("x", double(i)).f64("y", 0).f64("z", 0); });
                          out.turn("orientation", 0);
                        });
                      }});
    }
    std::stable_sort(said.begin(), said.end(), [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
    const QString path = written(recordings::recordingOf(said, Encoding::Json));
    const auto robot = opened(path);
    for (const double from_s : {Drive::kStartS, Drive::kStartS + 9.2}) {
      const auto chunk = range(*robot, keyOf(path), from_s, Drive::kStartS + 11.75);
      QVERIFY(chunk);
      const map::World world = foldedUntil(**chunk, Drive::kStartS + 11.7);
      QCOMPARE(world.live.drawings.size(), std::size_t(2));
      const map::GroundDrawing& poses = world.live.drawings[0];
      QCOMPARE(poses.kind, map::GroundDrawing::Kind::Segments);
      QCOMPARE(poses.points.size(), std::size_t(11 * 6));
      const map::GroundDrawing& zone = world.live.drawings[1];
      QCOMPARE(zone.kind, map::GroundDrawing::Kind::Line);
      QVERIFY((zone.points[0] - Eigen::Vector2d(Drive::xAt(Drive::kStartS + 11), Drive::kOffsetY)).norm() <
              0.01);
    }
  }

  void scansThatNothingPlacesAreShownInTheirOwnFrame_data() {
    QTest::addColumn<bool>("mounted");
    QTest::newRow("no transforms") << false;
    QTest::newRow("how the lidar is mounted") << true;
  }
  // An old bag of scans alone: neither a map nor where the robot was.
  void scansThatNothingPlacesAreShownInTheirOwnFrame() {
    QFETCH(const bool, mounted);
    std::vector<Drive::Said> said;
    for (const Drive::Said& one : Drive{1}.all()) {
      if (mounted && one.topic == "/tf_static") said.push_back(one);
    }
    for (int i = 0; i < 40; ++i) Drive::scan(said, Drive::kStartS + 0.1 + i * 0.25, "/base_scan");
    std::string bag = recordings::bagOf(said);
    for (std::size_t at = 0; (at = bag.find("std_msgs/Header", at)) != std::string::npos;)
      if (bag.compare(at - 5, 5, "MSG: ") == 0) {
        bag.replace(at, 15, "roslib/Header\n#");
      } else {
        ++at;
      }
    const QString path = written(bag, QStringLiteral("bag"));
    const auto robot = opened(path);
    std::vector<map::Problem> problems;
    connect(robot.get(), &Robot::problemFound, robot.get(), [&](const map::Problem& problem) {
      if (problem.subject.kind == map::SubjectKind::Topic) problems.push_back(problem);
    });
    const auto whole = range(*robot, keyOf(path), 0, 4e9);
    QVERIFY(whole);
    int clouds = 0;
    for (const BagMessage& message : (*whole)->messages) {
      const auto* const cloud = std::get_if<map::PointCloudMessage>(&message.message.message);
      if (!cloud) continue;
      ++clouds;
      QCOMPARE(cloud->points->front().x_m, mounted ? 2.25 : 2.0);
    }
    QCOMPARE(clouds, 40);
    QVERIFY(waitFor([&] { return !problems.empty(); }));
    QCOMPARE(problems.size(), std::size_t(1));
    QCOMPARE(problems.front().reason,
             Fault(robot::ros::fault::RosFrameAlone, {mounted ? "base_link" : "laser"}));
    QCOMPARE(problems.front().subject, map::Subject(map::SubjectKind::Topic, "/base_scan"));
  }

  void whatPrecedesTheFirstTransformIsNoTrouble_data() {
    QTest::addColumn<double>("late_s");
    QTest::addColumn<bool>("troubled");
    QTest::newRow("they follow at once") << 0.0 << false;
    QTest::newRow("they follow later") << 3.5 << true;
  }
  // A recording begins at any time, and the clock of the robot may be another one.
  void whatPrecedesTheFirstTransformIsNoTrouble() {
    QFETCH(const double, late_s);
    QFETCH(const bool, troubled);
    std::vector<Drive::Said> said;
    const auto odometry = [&](double at_s) {
      said.push_back({"/odom", "nav_msgs/Odometry", at_s, [=](RosOut& out) {
                        out.header(at_s, "odom").text("child_frame_id", "base_link");
                        out.object("pose", [&] { out.pose("pose", 1, 2, 0); });
                      }});
    };
    for (int i = 0; i < 40; ++i) odometry(Drive::kStartS + 0.0002 + i * 0.1);
    Drive::scan(said, Drive::kStartS + 0.0001);
    for (const Drive::Said& one : Drive{5}.all()) {
      if (one.topic != "/tf" || one.at_s >= Drive::kStartS + late_s) said.push_back(one);
    }
    // It was recorded much later by another clock.
    for (Drive::Said& one : said) one.at_s += 1e6;
    std::stable_sort(said.begin(), said.end(), [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
    const QString path = written(recordings::recordingOf(said, Encoding::Ros1));
    const auto robot = opened(path);
    std::vector<std::string> problems;
    connect(robot.get(), &Robot::problemFound, robot.get(), [&](const map::Problem& problem) {
      if (problem.code == map::ProblemCode::Unplaced) problems.push_back(map::patternOf(problem));
    });
    QVERIFY(range(*robot, keyOf(path), 0, 4e9));
    QCoreApplication::processEvents();
    QCOMPARE(!problems.empty(), troubled);
  }

  void aLayerOfARecordingIsTakenFromTheTopicThatPeopleChoose() {
    Drive drive{20};
    std::vector<Drive::Said> said = drive.all();
    const std::size_t count = said.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (said[i].topic != "/plan" && said[i].topic != "/global_costmap/costmap") continue;
      Drive::Said again = said[i];
      again.topic = again.topic == "/plan" ? "/teb/way" : "/semantic";
      again.at_s += 0.0005;
      if (again.topic == "/teb/way")
        again.fill = [at_s = again.at_s](RosOut& out) {
          out.header(at_s, "map").list("poses", 1, [&](std::size_t) {
            out.header(at_s, "map").pose("pose", 77, 7, 0);
          });
        };
      said.push_back(again);
    }
    std::stable_sort(said.begin(), said.end(), [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
    const QString path = written(recordings::recordingOf(said, Encoding::Ros1));
    replay::ReplayRobot robot(opened(path), keyOf(path));
    map::World world;
    bool exact = false;
    connect(&robot, &replay::ReplayRobot::jumped, &robot,
            [&](const map::World& now, replay::Knowledge known) {
              world = now;
              exact = known == replay::Knowledge::Exact;
            });
    robot.connectToRobot();
    QVERIFY(waitFor([&] { return robot.connection().phase == ConnectionPhase::Online; }));
    robot.goTo(Drive::kStartS + 12);
    QVERIFY(waitFor([&] { return exact; }));
    const map::World usual = world;
    QVERIFY(usual.live.path.size() == 2);
    QCOMPARE(robot.choicesFor(map::Stream::Path),
             (QStringList{QStringLiteral("/plan"), QStringLiteral("/teb/way")}));
    exact = false;
    robot.choose({{map::Stream::Path, QStringLiteral("/teb/way")},
                  {map::Stream::CostmapHigh, QStringLiteral("/semantic")}});
    QVERIFY(waitFor([&] { return exact; }));
    QVERIFY(world.live.path == map::Polyline{Eigen::Vector2d(77, 7)});
    QCOMPARE(world.live.grids.at(map::GridKind::CostmapHigh).topic, std::string("/semantic"));
    exact = false;
    robot.choose({});
    QVERIFY(waitFor([&] { return exact; }));
    QVERIFY(world == usual);
    const auto offered = robot.offered();
    QVERIFY(offered);
    const OfferedTopic chatter{QStringLiteral("/chatter"), QStringLiteral("std_msgs/String")};
    QVERIFY(std::find(offered->begin(), offered->end(), chatter) != offered->end());
  }

  void theEncodingsTellTheSame() {
    const Drive drive{12};
    std::optional<map::World> first;
    for (const Encoding encoding : {Encoding::Json, Encoding::Cdr, Encoding::Ros1, Encoding::Bag}) {
      const QString path =
          written(recordings::recordingOf(drive.all(), encoding),
                  encoding == Encoding::Bag ? QStringLiteral("bag") : QStringLiteral("mcap"));
      const auto robot = opened(path);
      const auto whole = range(*robot, keyOf(path), 0, 4e9);
      QVERIFY(whole);
      const map::World world = foldedUntil(**whole, Drive::kStartS + 11);
      QVERIFY(world.live.robot_pose && world.live.grids.size() == 2 && !world.live.path.empty());
      if (first) QVERIFY(world == *first);
      first = world;
    }
  }

  void theWorldOfADriveIsTheSameByEveryWay() {
    const Drive drive{40};
    const QString path = written(recordings::recordingOf(drive.all(), Encoding::Ros1));
    const auto robot = opened(path);
    const auto whole = range(*robot, keyOf(path), 0, 4e9);
    QVERIFY(whole);
    compareSeeks(*robot, keyOf(path), 30, [&](double at_s) { return foldedUntil(**whole, at_s); });
  }

  void theWorldOfAnyTimeIsWhatAllMessagesUntilThenSay_data() {
    QTest::addColumn<Encoding>("encoding");
    QTest::newRow("JSON") << Encoding::Json;
    QTest::newRow("CDR") << Encoding::Cdr;
    QTest::newRow("ROS 1") << Encoding::Ros1;
    QTest::newRow("a bag") << Encoding::Bag;
  }
  void theWorldOfAnyTimeIsWhatAllMessagesUntilThenSay() {
    QFETCH(Encoding, encoding);
    const Curve curve(unsigned(11 + int(encoding)));
    const QString path = written(recordings::recordingOf(curve.said(), encoding),
                                 encoding == Encoding::Bag ? QStringLiteral("bag") : QStringLiteral("mcap"));
    const auto robot = opened(path);
    replay::Reading::Options options;
    options.chunks.messages_per_cell = 300;
    replay::Reading reading(*robot->bagLibrary(), keyOf(path), options);
    bool open = false;
    connect(&reading, &replay::Reading::opened, &reading, [&] { open = true; });
    reading.open();
    QVERIFY(waitFor([&] { return open; }));
    std::mt19937 random(5);
    const std::vector<Drive::Said> said = curve.said();
    for (int seek = 0; seek < 150; ++seek) {
      // Every second time is that of a message.
      const double at_s = seek % 2 ? said[random() % said.size()].at_s
                                   : Curve::kStartS + 40.0 * double(random() % 1'000'000) / 1e6;
      const map::World world = worldAt(reading, at_s);
      const Curve::World wanted = curve.foldedUntil(at_s);
      const QByteArray when = QByteArray::number(at_s - Curve::kStartS, 'f', 6);
      QVERIFY2(world.live.robot_pose.has_value() == wanted.pose.has_value(), when);
      if (wanted.pose) {
        QVERIFY2(std::abs(world.live.robot_pose->x_m - wanted.pose->x_m) < 1e-6, when);
        QVERIFY2(std::abs(world.live.robot_pose->y_m - wanted.pose->y_m) < 1e-6, when);
        QVERIFY2(std::abs(world.live.robot_pose->yaw_rad - wanted.pose->yaw_rad) < 1e-6, when);
      }
      QVERIFY2((world.live.path.empty() ? -1 : int(std::lround(world.live.path.front().x()))) == wanted.path,
               when);
      QVERIFY2(int(world.live.seen_objects.size()) == wanted.markers, when);
      // Each topic with the stamp of its last message, and no other.
      std::map<std::string, double> topics;
      for (const Drive::Said& one : said) {
        if (one.at_s <= at_s) topics[one.topic] = one.at_s;
      }
      const replay::Moment moment = reading.moment();
      QVERIFY2(moment.topics.size() == topics.size(), when);
      for (const auto& [topic, stamp_s] : topics) {
        const auto told = moment.topics.find(topic);
        QVERIFY2(told != moment.topics.end() && told->second == stamp_s, (when + ' ' + topic.c_str()).data());
      }
    }
    // The way has a place for every time at which one was told, each once, and each as it was then.
    reading.setWhole(true);
    QVERIFY(waitFor([&] { return reading.chunks().wholeRead(); }));
    const std::vector<replay::TrackPoint> track = replay::trackOf(reading.index().digests());
    const std::vector<double> told = curve.posed();
    QCOMPARE(track.size(), told.size());
    for (std::size_t i = 0; i < track.size(); ++i) {
      QCOMPARE(track[i].stamp_s, told[i]);
      const Curve::World wanted = curve.foldedUntil(told[i]);
      QVERIFY(std::hypot(track[i].pose.x_m - wanted.pose->x_m, track[i].pose.y_m - wanted.pose->y_m) < 1e-6);
    }
  }

  void patchesAreInTheGridWhereverOneBegins() {
    std::vector<Drive::Said> said = Drive{40}.all();
    std::vector<std::int8_t> cells(64);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = std::int8_t(i % 5 == 0 ? 100 : 0);
    int step_of_patch = 11;
    for (const Drive::Said& one : said) {
      if (one.topic != "/global_costmap/costmap_updates") continue;
      const int x = step_of_patch % 7, y = step_of_patch % 5;
      cells[std::size_t(y * 8 + x)] = std::int8_t(step_of_patch % 100);
      cells[std::size_t((y + 1) * 8 + x)] = 50;
      step_of_patch += 30;
    }
    const QString path = written(recordings::recordingOf(said, Encoding::Json));
    const auto robot = opened(path);
    const auto last = range(*robot, keyOf(path), Drive::kStartS + 37, Drive::kStartS + 41);
    QVERIFY(last);
    const map::GridMessage* grid = nullptr;
    for (const BagMessage& message : (*last)->messages) {
      if (const auto* one = std::get_if<map::GridMessage>(&message.message.message)) grid = one;
    }
    QVERIFY(grid && grid->png);
    std::string pixels;
    for (int row = 7; row >= 0; --row) {
      for (int column = 0; column < 8; ++column) pixels += char(cells[std::size_t(row * 8 + column)]);
    }
    QVERIFY(grid->png->ends_with(pixels));
  }

  void whatWasFetchedIsGivenAgain() {
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    const auto attach = [&](const std::string& name, const std::string& content, std::int64_t at_ns = 5) {
      writer->attach({name, "application/octet-stream", at_ns, 0, content});
    };
    ros_messages::slam::SubmapQueryV2Response response;
    response.mutable_status()->set_code(ros_messages::slam::OK);
    response.set_submap_version(7);
    response.add_textures()->set_width(3);
    attach("submaps/a%2Fb/1/2/7", response.SerializeAsString());
    attach("pictures/http://robot/map.png?v=1", "first", 100);
    attach("pictures/http://robot/map.png?v=1", "second", 2'000'000'000);
    attach("maps/stored/12", "picture");
    attach(
        "maps/stored/12.json",
        R"({"kind":"stored","id":"12","name":"Hall","current":true,"grid":{"width":4,"height":3,)"
        R"("resolution_m":0.05,"x_m":1,"y_m":2,"yaw_rad":0},"reading":{"mode":"trinary","negate":false}})");
    attach("waypoints/stored/12.json",
           R"({"waypoints":[{"id":"7","name":"Dock","x_m":1.5,"y_m":2,"tags":["a"]}]})");
    const auto say = [&](double at_s, const std::string& text) {
      recording::Channel channel;
      channel.topic = "/map_v2";
      channel.message_encoding = "json";
      const std::int64_t at_ns = recordings::nanoseconds(at_s);
      writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(text));
    };
    const std::string frame = R"({"topic":"/map_v2","resolution":0.05,"size":[4,3],"origin":[0,0],)"
                              R"("data_url":"http://robot/map.png?v=1"})";
    say(1, frame);
    say(3, frame);
    writer->close();
    const QString path = written(*bytes);
    const auto robot = opened(path);

    std::optional<map::SubmapAnswer> submap;
    robot->submapSource()->fetch({"a/b", {1, 2}, 7},
                                 [&](map::SubmapAnswer told) { submap = std::move(told); });
    QVERIFY(waitFor([&] { return submap.has_value(); }));
    QCOMPARE(submap->outcome, map::SubmapAnswer::Outcome::Ok);
    QCOMPARE(submap->version, 7);
    submap.reset();
    robot->submapSource()->fetch({"a/b", {9, 9}, 7},
                                 [&](map::SubmapAnswer told) { submap = std::move(told); });
    QVERIFY(waitFor([&] { return submap.has_value(); }));
    QCOMPARE(submap->outcome, map::SubmapAnswer::Outcome::NotFound);

    const map::MapKey hall{map::MapKind::Stored, "12"};
    const auto map = answer<map::WholeMap>(
        [&](auto reply) { return robot->wholeMapSource()->fetch(hall, std::move(reply)); });
    QVERIFY(map && *map->bytes == "picture" && map->name == "Hall" && map->grid.width == 4);
    QCOMPARE(map->reading.mode, map::CellReading::Mode::Trinary);
    const auto places = answer<map::WaypointList>(
        [&](auto reply) { return robot->waypointSource()->waypoints(hall, std::move(reply)); });
    QVERIFY(places && places->points.size() == 1 && places->points.front().name == "Dock");
    const auto maps = answer<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot->mapCatalogue()->list(std::move(reply)); });
    QVERIFY(maps && maps->size() == 1 && maps->front().is_current && maps->front().key == hall);

    // Under one address the robot had two pictures by and by.
    const auto chunk = range(*robot, keyOf(path), 0, 10);
    QVERIFY(chunk && (*chunk)->messages.size() == 2);
    std::vector<std::string> pictures;
    for (const BagMessage& message : (*chunk)->messages) {
      const auto picture = answer<std::shared_ptr<const std::string>>([&](auto reply) {
        return robot->bagLibrary()->picture("/map_v2", message.picture_url, std::move(reply));
      });
      QVERIFY(picture);
      pictures.push_back(**picture);
    }
    QCOMPARE(pictures == (std::vector<std::string>{"first", "second"}), true);
    const auto none = answer<std::shared_ptr<const std::string>>(
        [&](auto reply) { return robot->bagLibrary()->picture("/map_v2", "elsewhere", std::move(reply)); });
    QVERIFY(!none && !sentence(none.error()).empty());
  }

  void whatIsNoRecordingSaysSo() {
    const QString text = written("This is a text.\n");
    const auto robot = opened(text);
    const auto info = infoOf(*robot, keyOf(text));
    QVERIFY(!info);
    QVERIFY(info.error().cause.any());
    robot->connectToRobot();
    QTRY_COMPARE(robot->connection().phase, ConnectionPhase::Refused);
    const auto nowhere = opened(folder_.filePath(QStringLiteral("nowhere.mcap")));
    const auto none = infoOf(*nowhere, {BagKind::File, "nowhere.mcap"});
    QVERIFY(!none && none.error().cause.any());
    QVERIFY(!recorded::isRecording(folder_.path()));
    const QString unnamed = written(recordingOf(axbotSession(1, 3)), QStringLiteral("data"));
    QVERIFY(recorded::isRecording(unnamed) && !recorded::isRecording(written("text", QStringLiteral("txt"))));
  }

  void aFileIsOnlyRead() {
    const QString path = written(recordingOf(axbotSession(1, 3)));
    const auto robot = opened(path);
    const auto gone = answer<BagKey>(
        [&](auto reply) { return robot->bagLibrary()->remove(keyOf(path), std::move(reply)); });
    QVERIFY(!gone && gone.error().kind == map::FailureKind::Unsupported);
    const auto copied = answer<BagDownload>([&](auto reply) {
      return robot->bagLibrary()->download(keyOf(path), QStringLiteral("x"), std::move(reply));
    });
    QVERIFY(!copied && copied.error().kind == map::FailureKind::Unsupported);
    QVERIFY(QFile::exists(path));
  }

  void whatIsSoundOfABrokenFileIsPlayed() {
    recording::WriterOptions options;
    options.chunk_bytes = 4000;
    const std::vector<Said> said = axbotSession(6, 800);
    const std::string sound = recordingOf(said, options);
    std::mt19937 random(2);
    for (int times = 0; times < 12; ++times) {
      std::string broken = sound.substr(0, times % 2 ? sound.size() : 100 + random() % sound.size());
      for (int hits = 0; hits < times % 3; ++hits) {
        char& hit = broken[random() % broken.size()];
        hit = char(hit ^ char(1 + random() % 255));
      }
      const QString path = written(broken);
      const auto robot = opened(path);
      std::vector<map::Problem> problems;
      connect(robot.get(), &Robot::problemFound, this,
              [&](const map::Problem& one) { problems.push_back(one); });
      const auto chunk = range(*robot, keyOf(path), 0, 4e9);
      if (!chunk) {
        QVERIFY(chunk.error().cause.any());
        continue;
      }
      QVERIFY((*chunk)->messages.size() <= said.size() + 1);
      if (broken.size() < sound.size()) QVERIFY(!problems.empty());
    }
  }

  void aFileThatGrowsIsFollowed() {
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    const std::vector<Said> said = axbotSession(8, 200);
    const auto write = [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        recording::Channel channel;
        channel.topic = said[i].topic;
        channel.message_encoding = "json";
        const std::int64_t at_ns = recordings::nanoseconds(said[i].at_s);
        writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(said[i].text));
      }
      writer->flush();
    };
    write(0, 100);
    const QString path = written(*bytes);
    const auto robot = opened(path);
    QCOMPARE(infoOf(*robot, keyOf(path))->messages, std::int64_t(100));
    write(100, 200);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes->data(), qint64(bytes->size()));
    file.close();
    QCOMPARE(infoOf(*robot, keyOf(path))->messages, std::int64_t(200));
    QCOMPARE((*range(*robot, keyOf(path), 0, 4e9))->messages.size(), std::size_t(200));
  }

  void thatAFileHasGrownIsToldWhoeverSawItFirst() {
    const std::vector<Said> said = axbotSession(8, 200);
    const std::string all = recordingOf(said, {});
    const QString path = written(all.substr(0, all.size() / 2));
    const auto robot = opened(path);
    const BagInfo before = *infoOf(*robot, keyOf(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(all.data(), qint64(all.size()));
    file.close();
    // A request for messages looks at the file, too.
    QVERIFY(range(*robot, keyOf(path), 0, 4e9).has_value());
    const BagInfo after = *infoOf(*robot, keyOf(path));
    QVERIFY(after.end_s > before.end_s);
    QVERIFY(after.messages > before.messages);
  }

  void whatIsPlayedGetsLongerWithItsFile() {
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    const std::vector<Said> said = axbotSession(12, 400);
    const QString path = written({});
    const auto write = [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        recording::Channel channel;
        channel.topic = said[i].topic;
        channel.message_encoding = "json";
        const std::int64_t at_ns = recordings::nanoseconds(said[i].at_s);
        writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(said[i].text));
      }
      if (to == said.size()) {
        writer->close();
      } else {
        writer->flush();
      }
      QFile file(path);
      // Only what is new: what is there may be read at the same time.
      QVERIFY(file.open(QIODevice::Append));
      file.write(bytes->data() + file.size(), qint64(bytes->size()) - file.size());
    };
    write(0, 150);
    const auto robot = opened(path);
    replay::Reading::Options options;
    options.chunks.messages_per_cell = 40;
    replay::Reading reading(*robot->bagLibrary(), keyOf(path), options);
    bool open = false;
    int replaced = 0;
    connect(&reading, &replay::Reading::opened, &reading, [&] { open = true; });
    connect(&reading, &replay::Reading::replaced, &reading, [&] { ++replaced; });
    reading.open();
    QVERIFY(waitFor([&] { return open; }));
    QVERIFY(worldAt(reading, said[149].at_s).live == foldedUntil(said, said[149].at_s).live);
    const double end_s = reading.chunks().end_s();
    for (const std::size_t until : {std::size_t(151), std::size_t(300), said.size()}) {
      write(until == 151 ? 150 : until == 300 ? 151 : 300, until);
      const double last_s = double(recordings::nanoseconds(said[until - 1].at_s)) / 1e9;
      reading.lookAgain();
      QVERIFY(waitFor([&] { return reading.chunks().end_s() >= last_s; }));
      QVERIFY(waitFor([&] { return worldAt(reading, last_s).live == foldedUntil(said, last_s).live; }));
      for (const std::size_t i : {std::size_t(20), until / 2, until - 1})
        QVERIFY(worldAt(reading, said[i].at_s).live == foldedUntil(said, said[i].at_s).live);
    }
    QVERIFY(replaced > 0);
    QVERIFY(reading.chunks().end_s() > end_s);
    // What does not grow any more is not read again.
    const int before = replaced;
    reading.lookAgain();
    QVERIFY(infoOf(*robot, keyOf(path)));
    QCOMPARE(replaced, before);
  }

  void theMapThatMessagesNameIsTheCurrentOne() {
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    const auto attach = [&](const std::string& id, const std::string& facts, std::int64_t at_ns) {
      writer->attach({"maps/stored/" + id, "image/png", at_ns, 0, "picture " + id});
      const std::string text =
          "{\"kind\":\"stored\",\"id\":\"" + id + "\"," + facts +
          R"(,"grid":{"width":4,"height":3,"resolution_m":0.05,"x_m":0,"y_m":0,"yaw_rad":0}})";
      writer->attach({"maps/stored/" + id + ".json", "application/json", at_ns, 0, text});
    };
    attach("1", R"("name":"Hall","uid":"u-1","current":true)", 1'000);
    attach("2", R"("name":"Yard","uid":"u-2","current":true)", 2'000);
    attach("3", R"("name":"Roof","current":false)", 3'000);
    const auto say = [&](double at_s, const std::string& map) {
      recording::Channel channel;
      channel.topic = "/map/info";
      channel.message_encoding = "json";
      const std::int64_t at_ns = recordings::nanoseconds(at_s);
      const std::string text = R"({"topic":"/map/info",)" + map + "}";
      writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(text));
    };
    say(100, R"("map_uid":"u-1","map_name":"Renamed")");
    say(200, R"("map_uid":"u-2","map_name":"Yard")");
    say(300, R"("map_uid":"","map_name":"Roof")");
    say(400, R"("map_uid":"u-9","map_name":"Gone")");
    writer->close();
    const QString path = written(*bytes);
    const auto current = [](Robot& robot) {
      const auto maps = answer<std::vector<map::CatalogueEntry>>(
          [&](auto reply) { return robot.mapCatalogue()->list(std::move(reply)); });
      std::string all;
      for (const map::CatalogueEntry& entry : *maps) all += entry.is_current ? entry.key.id : "";
      return all;
    };
    replay::ReplayRobot robot(opened(path), recorded::bagNameOf(path));
    QCOMPARE(current(robot), std::string("2"));  // the last one that was
    int told = 0;
    connect(&robot, &Robot::mapsChanged, this, [&] { ++told; });
    robot.connectToRobot();
    QTRY_COMPARE(robot.connection().phase, ConnectionPhase::Online);
    for (const auto& [at_s, id] : std::vector<std::pair<double, std::string>>{
             {101, "1"}, {201, "2"}, {301, "3"}, {401, ""}, {102, "1"}, {99, "2"}}) {
      robot.goTo(at_s);
      QVERIFY(waitFor([&] { return robot.knowledge() == replay::Knowledge::Exact; }));
      QCOMPARE(current(robot), id);
    }
    QVERIFY(told >= 5);
  }

  void messagesByTheSchemasOfFoxgloveAreSeen_data() {
    QTest::addColumn<bool>("protobuf");
    QTest::newRow("JSON") << false;
    QTest::newRow("protobuf") << true;
  }
  void messagesByTheSchemasOfFoxgloveAreSeen() {
    QFETCH(bool, protobuf);
    const QString path = written(foxglove::drive(protobuf));
    const auto robot = opened(path);
    std::vector<std::string> problems;
    connect(robot.get(), &Robot::problemFound, this,
            [&](const map::Problem& one) { problems.push_back(map::patternOf(one)); });
    const auto chunk = range(*robot, keyOf(path), 0, 4e9);
    QVERIFY(chunk);
    const map::World world = foldedUntil(**chunk, 4e9);
    for (const std::string& problem : problems) qWarning("%s", problem.c_str());
    QVERIFY(problems.empty());
    // Everything in the frame of the map, which lies 10 m to the left of the robot's own.
    QVERIFY(world.live.robot_pose.has_value());
    QVERIFY(std::abs(world.live.robot_pose->x_m - 12) < 1e-6);
    const auto grid = world.live.grids.find(map::GridKind::WholeMap);
    QVERIFY(grid != world.live.grids.end());
    QCOMPARE(grid->second.grid.width, 3);
    QCOMPARE(grid->second.grid.height, 2);
    QVERIFY(std::abs(grid->second.grid.resolution_m - 0.5) < 1e-9);
    QVERIFY(std::abs(grid->second.grid.origin.x_m - 1) < 1e-9);
    for (const auto& [topic, count, x_m] : {std::tuple("/scan", 2, 14.0), std::tuple("/lidar", 1, 13.0)}) {
      const auto cloud = world.live.clouds.find(topic);
      QVERIFY2(cloud != world.live.clouds.end() && int(cloud->second->size()) == count, topic);
      QVERIFY2(std::abs(cloud->second->front().x_m - x_m) < 1e-3,
               qPrintable(QString::number(cloud->second->front().x_m)));
    }
    QCOMPARE(world.live.path.size(), std::size_t(2));
  }

  void everythingInAMessageOfProtobufIsTold() {
    foxglove::Everything all;
    const QString path = written(all.recording());
    const auto robot = opened(path);
    const auto chunk = forPrograms(*robot, keyOf(path));
    QVERIFY(chunk);
    QCOMPARE((*chunk)->messages.size(), std::size_t(2));
    const auto textOf = [&](std::size_t which) {
      const std::string_view text = (*chunk)->textOf((*chunk)->messages[which]);
      const std::size_t from = text.find("\"msg\":");
      return QByteArray(text.data() + from + 6, qsizetype(text.size() - from - 7));
    };
    QCOMPARE(textOf(0),
             QByteArray(R"({"small":-3,"large":18446744073709551615,"real":0.5,"yes":true,"name":"q",)"
                        R"("kind":2,"inner":{"small":7,"large":0,"real":0,"yes":false,"name":"",)"
                        R"("kind":0,"smalls":[],"larges":[],"reals":[],"yeses":[],"names":[],)"
                        R"("kinds":[],"inners":[],"by_name":{}},"smalls":[1,0,-1],)"
                        R"("larges":[9223372036854775808,1],"reals":[0.25,0],)"
                        R"("yeses":[true,false],"names":["a",""],"kinds":[0,2],)"
                        R"("inners":[],"by_name":{"left":1,"right":0}})"));
    // Zeros are values; only what can be absent is.
    QCOMPARE(textOf(1), QByteArray(R"({"small":0,"large":0,"real":0,"yes":false,"name":"","kind":0,)"
                                   R"("smalls":[],"larges":[],"reals":[],"yeses":[],"names":[],"kinds":[],)"
                                   R"("inners":[],"by_name":{}})"));
  }

  void wholeNumbersOfAnySizeAreTold_data() { theWorldOfAnyTimeIsWhatAllMessagesUntilThenSay_data(); }
  void wholeNumbersOfAnySizeAreTold() {
    QFETCH(Encoding, encoding);
    if (encoding == Encoding::Json) return;  // as it was recorded
    const std::vector<std::uint64_t> numbers{0, 9'007'199'254'740'993, 18'446'744'073'709'551'615U};
    const std::vector<Drive::Said> said{
        {"/numbers", "std_msgs/UInt64MultiArray", Drive::kStartS,
         [&](RosOut& out) { out.u64("one", numbers.back()).numbers("data", numbers); }},
        {"/go", "std_msgs/Empty", Drive::kStartS + 1, [](RosOut& out) { out.nothing(); }}};
    const QString path = written(recordings::recordingOf(said, encoding),
                                 encoding == Encoding::Bag ? QStringLiteral("bag") : QStringLiteral("mcap"));
    const auto robot = opened(path);
    std::vector<std::string> problems;
    connect(robot.get(), &Robot::problemFound, this, [&](const map::Problem& one) {
      if (one.subject.kind == map::SubjectKind::Topic) problems.push_back(map::patternOf(one));
    });
    const auto chunk = forPrograms(*robot, keyOf(path));
    QVERIFY(chunk && (*chunk)->messages.size() == 2);
    const std::string text((*chunk)->textOf((*chunk)->messages[0]));
    QVERIFY2(text.ends_with(R"("msg":{"one":18446744073709551615,)"
                            R"("data":[0,9007199254740993,18446744073709551615]}})"),
             text.c_str());
    // A type without members has an empty definition, and is described.
    const std::string nothing((*chunk)->textOf((*chunk)->messages[1]));
    QVERIFY2(nothing.ends_with(R"("msg":{}})"), nothing.c_str());
    QVERIFY2(problems.empty(), problems.empty() ? "" : problems.front().c_str());
  }

  void messagesThatSayTheSameAtOneTimeAreAsManyAsTheyWere() {
    std::vector<Said> said;
    for (int second = 0; second < 12; ++second) {
      for (int times = 0; times < 200; ++times)
        said.push_back({1'717'405'200.0 + second, "/tracked_pose",
                        R"({"topic":"/tracked_pose","pos":[1,2],"ori":0.5})"});
    }
    const QString path = written(recordingOf(said));
    const auto robot = opened(path);
    for (const double each : {50.0, 400.0, 1e6}) {
      replay::Reading::Options options;
      options.chunks.messages_per_cell = each;
      replay::Reading reading(*robot->bagLibrary(), keyOf(path), options);
      bool open = false;
      connect(&reading, &replay::Reading::opened, &reading, [&] { open = true; });
      reading.open();
      QVERIFY(waitFor([&] { return open; }));
      reading.setWhole(true);
      reading.want(0);
      QVERIFY(waitFor([&] { return reading.chunks().wholeRead(); }));
      QCOMPARE(reading.chunks().messagesRead(), said.size());
    }
  }

  void whatLiesInMessagesOfFoxgloveIsNoHarm() {
    const std::string sound = foxglove::drive(true);
    std::mt19937 random(4);
    for (int times = 0; times < 60; ++times) {
      std::string broken = sound;
      for (int hits = 0; hits < 1 + times % 8; ++hits) {
        char& hit = broken[random() % broken.size()];
        hit = char(hit ^ char(1 + random() % 255));
      }
      const QString path = written(broken);
      const auto robot = opened(path);
      const auto chunk = range(*robot, keyOf(path), 0, 4e9);
      QVERIFY(chunk || chunk.error().cause.any());
    }
  }

  void aRangeThatIsGivenUpEndsAsCancelled() {
    const QString path = written(recordings::recordingOf(Drive{200}.all(), Encoding::Cdr));
    const auto robot = opened(path);
    std::optional<Outcome<BagChunkPtr>> told;
    const Call call = robot->bagLibrary()->messages(
        keyOf(path), {0, 4e9}, [&](Outcome<BagChunkPtr> outcome) { told = std::move(outcome); });
    call.cancel();
    QVERIFY(waitFor([&] { return told.has_value(); }));
    QVERIFY(!*told && told->error().kind == map::FailureKind::Cancelled);
  }

  void anAnswerThatWouldBeTooLongIsAskedForInParts() {
    const QString path = written(recordingOf(axbotSession(9, 400)));
    const auto robot = opened(path);
    const auto chunk = answer<BagChunkPtr>([&](auto reply) {
      return robot->bagLibrary()->messages(keyOf(path), {0, 4e9, 1000}, std::move(reply));
    });
    QVERIFY(!chunk && chunk.error().cause.code == fault::AnswerTooLong);
  }

  void itIsPlayedAsARobot() {
    const std::vector<Said> said = axbotSession(10, 300);
    const QString path = written(recordingOf(said));
    replay::ReplayRobot robot(opened(path), recorded::bagNameOf(path));
    std::optional<map::World> world;
    connect(&robot, &replay::ReplayRobot::jumped, this, [&](const map::World& now, replay::Knowledge how) {
      if (how == replay::Knowledge::Exact) world = now;
    });
    robot.connectToRobot();
    QTRY_COMPARE(robot.connection().phase, ConnectionPhase::Online);
    robot.goTo(said[200].at_s + 1e-4);
    QTRY_VERIFY(world.has_value());
    QVERIFY(world->live == foldedUntil(said, said[200].at_s + 1e-4).live);
    QVERIFY(robot.liveTopics()->topicsOf(map::Stream::Pose).contains(QStringLiteral("/tracked_pose")));
  }
};

}  // namespace test_recorded_robot

MAPWRIGHT_TEST(test_recorded_robot, RecordedRobotTest, Core)
#include "test_recorded_robot.moc"
