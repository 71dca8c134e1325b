// Recordings of robots, over their simulators: what is in the file is what came.
#include <algorithm>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <QJsonDocument>
#include <QTemporaryDir>
#include <QtTest>

#include "net/rosbridge/frame.h"
#include "recorder/layout.h"
#include "recorder/recorder.h"
#include "recording/ros_cbor.h"
#include "recording/source.h"
#include "robot/aimdk/aimdk_robot.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/axbot/parse_topics.h"
#include "robot/delivery.h"
#include "robot/ros/ros_robot.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_recorder {

using namespace mapwright;
using namespace mapwright::recorder;
using map::Stream;
using robot::ConnectionPhase;

namespace {

struct Row {
  std::string topic, encoding, schema, bytes;
  recording::ChannelPtr channel;
  bool before = false;
  std::int64_t log_ns = 0, publish_ns = 0;
  std::uint32_t sequence = 0;
};

/// A file that was read.
struct Film {
  std::vector<Row> rows;
  std::map<std::string, recording::Attachment> files;
  std::map<std::string, recording::Values> metadata;
  bool finished = false;
  std::size_t notes = 0;

  std::vector<Row> of(const std::string& topic, bool before = false) const {
    std::vector<Row> some;
    for (const Row& row : rows) {
      if (row.topic == topic && row.before == before) some.push_back(row);
    }
    return some;
  }
  bool hasFile(const std::string& start) const {
    return std::any_of(files.begin(), files.end(),
                       [&](const auto& one) { return one.first.starts_with(start); });
  }
};

Film read(const QString& path) {
  Film film;
  auto source = recording::openRecording(path.toStdString());
  if (!source) return film;
  film.finished = (*source)->summary().finished;
  film.notes = (*source)->summary().notes.size();
  const auto cursor = (*source)->messages({});
  while (const auto message = cursor->next()) {
    Row row;
    row.topic = message->channel->topic;
    row.encoding = message->channel->message_encoding;
    row.schema = message->channel->schema_name;
    row.channel = message->channel;
    row.bytes.assign(message->bytes.begin(), message->bytes.end());
    row.before = message->channel->metadata.contains(kSaid);
    row.log_ns = message->log_time_ns;
    row.publish_ns = message->publish_time_ns;
    row.sequence = message->sequence;
    film.rows.push_back(std::move(row));
  }
  for (const auto& location : (*source)->attachments()) {
    if (auto file = (*source)->attachment(location)) film.files[location.name] = std::move(*file);
  }
  for (const auto& metadata : (*source)->metadata()) film.metadata[metadata.name] = metadata.values;
  return film;
}

/// What a message says, whichever way it is written.
QJsonValue contentOf(const Row& row) {
  const auto json = [](const QByteArray& text) { return QJsonValue(QJsonDocument::fromJson(text).object()); };
  const auto wire = recording::rosWire(row.encoding);
  if (!wire) return json(QByteArray::fromStdString(row.bytes));
  const auto schema = recording::parseRosSchema(
      row.schema, row.channel->schema_data,
      row.encoding == "cdr" ? recording::RosDialect::Ros2 : recording::RosDialect::Ros1);
  if (!schema) return {};
  const auto cbor = recording::rosToCbor(
      *schema, *wire, {reinterpret_cast<const std::uint8_t*>(row.bytes.data()), row.bytes.size()});
  if (!cbor) return {};
  return json(net::rosbridge::Frame::read(*cbor, net::rosbridge::Frame::Wire::Binary)->root().toWholeJson());
}

const map::Streams kMany{Stream::Pose,  Stream::WholeMap, Stream::CostmapLow, Stream::MapInfo, Stream::Path,
                         Stream::Cloud, Stream::Battery,  Stream::Trajectory, Stream::Planning};

}  // namespace

class RecorderTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  QString path_;
  std::unique_ptr<simulator::Simulator> simulator_;
  std::unique_ptr<robot::Robot> robot_;
  std::unique_ptr<Recorder> recorder_;
  std::mutex mutex_;
  std::vector<std::string> frames_;  // that a tap got

  void startSimulator(simulator::Options options = {}) {
    simulator_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!simulator_->start());
  }
  QUrl url(const char* scheme, quint16 port) const {
    return QUrl(QStringLiteral("%1://127.0.0.1:%2").arg(QLatin1String(scheme)).arg(port));
  }
  void makeAxbot() {
    robot::axbot::LinkOptions options;
    options.base = url("http", simulator_->port());
    robot_ = std::make_unique<robot::axbot::AxbotRobot>(QStringLiteral("axbot+test"), std::move(options));
  }
  std::unique_ptr<robot::Robot> rosRobot() const {
    robot::ros::LinkOptions options;
    options.url = url("ws", simulator_->rosPort());
    return std::make_unique<robot::ros::RosRobot>(QStringLiteral("ros+test"), std::move(options));
  }
  void makeAimdk() {
    robot::aimdk::LinkOptions options;
    options.base = url("http", simulator_->aimdkPort());
    robot::aimdk::RobotBeside beside{rosRobot(), QStringLiteral("127.0.0.1")};
    robot_ = std::make_unique<robot::aimdk::AimdkRobot>(QStringLiteral("aimdk+test"), std::move(options),
                                                        std::move(beside));
  }
  void tapFrames() {
    robot_->liveTopics()->setTap([this](const robot::RawFrame& frame) {
      const std::lock_guard lock(mutex_);
      frames_.emplace_back(frame.bytes);
    });
  }
  static auto frameOf(const std::string& bytes) {
    using net::rosbridge::Frame;
    const bool text = bytes.starts_with('{');
    return Frame::read(QByteArray::fromStdString(bytes), text ? Frame::Wire::Text : Frame::Wire::Binary);
  }
  bool hasCome(const std::string& topic) {
    const std::lock_guard lock(mutex_);
    return std::any_of(frames_.begin(), frames_.end(), [&](const std::string& bytes) {
      return frameOf(bytes)->root()["topic"].text() == topic;
    });
  }
  void connectRobot() {
    robot_->liveTopics()->setWanted(kMany, {});
    robot_->connectToRobot();
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Online);
  }
  void startRecording(SubmapRequests::Which submaps = SubmapRequests::Which::Listed) {
    auto target = recording::appendFile(path_.toStdString(), recording::Existing::Replace);
    QVERIFY(target);
    Recorder::Options options;
    options.kind = "test";
    options.submaps = submaps;
    auto started = Recorder::start(*robot_, std::move(*target), std::move(options));
    QVERIFY(started);
    recorder_ = std::move(*started);
  }
  std::uint64_t messages() const { return recorder_->progress().written.messages; }
  Film end() {
    QSignalSpy finished(recorder_.get(), &Recorder::finished);
    recorder_->stop();
    if (finished.isEmpty()) finished.wait(30'000);
    const Recorder::Progress progress = recorder_->progress();
    QTest::qVerify(progress.finished && !progress.end_fault && progress.written.lost == 0, "whole", "",
                   __FILE__, __LINE__);
    recorder_.reset();
    robot_->liveTopics()->setTap({});
    return read(path_);
  }

 private Q_SLOTS:
  void init() {
    path_ = folder_.filePath(QStringLiteral("%1.mcap").arg(QLatin1String(QTest::currentTestFunction())));
    frames_.clear();
  }
  void cleanup() {
    recorder_.reset();
    robot_.reset();
    simulator_.reset();
  }

  void everyFrameOfAnAutoxingRobotIsInTheFileAsItWasSentAndInOrder() {
    startSimulator();
    makeAxbot();
    startRecording(SubmapRequests::Which::None);
    tapFrames();
    connectRobot();
    QTRY_VERIFY(messages() > 100);
    const Film film = end();
    QVERIFY(film.finished);
    QCOMPARE(film.notes, std::size_t(0));
    QVERIFY(film.rows.size() > 100);
    const std::lock_guard lock(mutex_);
    QVERIFY(frames_.size() >= film.rows.size());
    std::int64_t last_ns = 0;
    bool binary = false;
    for (std::size_t i = 0; i < film.rows.size(); ++i) {
      const Row& row = film.rows[i];
      const auto frame = robot::axbot::unpackBinaryFrame(frames_[i]);
      const bool is_binary = row.encoding == "protobuf";
      QVERIFY2(row.bytes == (is_binary ? frame->body : frames_[i]), row.topic.c_str());
      QVERIFY(film.rows[i].log_ns >= last_ns);
      last_ns = film.rows[i].log_ns;
      binary |= is_binary && row.schema == robot::axbot::kBinaryType && !row.channel->schema_data.empty();
    }
    QVERIFY(binary);
    const auto poses = film.of("/tracked_pose");
    QVERIFY(poses.size() > 5);
    for (std::size_t i = 0; i < poses.size(); ++i) QCOMPARE(std::size_t(poses[i].sequence), i + 1);
    QCOMPARE(film.metadata.at(kAbout).at("kind"), std::string("test"));
    QCOMPARE(film.metadata.at(kAbout).at("address"), std::string("axbot+test"));
    QVERIFY(!film.metadata.at(kAbout).at("serial").empty());
    QCOMPARE(film.metadata.at(kEnd).at("lost"), std::string("0"));
  }

  void submapsMapsAndPicturesThatBelongToItAreInTheFile() {
    simulator::Options options;
    options.submaps = 12;
    startSimulator(options);
    makeAxbot();
    connectRobot();
    startRecording();
    QTRY_VERIFY(messages() > 30 && recorder_->fetches().submapsMissing() == 0);
    QTRY_VERIFY(recorder_->progress().written.files >= 12 + 3);  // the map: picture, facts and waypoints
    const std::string uuid = simulator_->uuid();
    const Film film = end();
    std::size_t submaps = 0;
    for (const auto& [name, file] : film.files) {
      const auto key = submapFrom(name);
      if (!key) continue;
      ++submaps;
      QCOMPARE(key->uuid, uuid);
      QCOMPARE(file.media_type, std::string("application/x-protobuf"));
      QVERIFY(!file.bytes.empty());
    }
    QVERIFY(submaps >= 10);
    bool whole = false;
    for (const auto& [name, file] : film.files) {
      const auto key = mapFrom(name);
      if (!key) continue;
      whole = true;
      QVERIFY(file.bytes.starts_with("\x89PNG"));
      const auto facts =
          QJsonDocument::fromJson(QByteArray::fromStdString(film.files.at(mapFactsName(*key)).bytes));
      QVERIFY(facts[QStringLiteral("grid")][QStringLiteral("resolution_m")].toDouble() > 0);
      const auto places =
          QJsonDocument::fromJson(QByteArray::fromStdString(film.files.at(waypointsName(*key)).bytes));
      QVERIFY(places[QStringLiteral("overlays")].isArray());
    }
    QVERIFY(whole);
  }

  void aMapThatIsOpenedMeanwhileBelongsToIt() {
    startSimulator();
    makeAxbot();
    connectRobot();
    std::vector<map::CatalogueEntry> maps;
    robot_->mapCatalogue()->list([&](const robot::Outcome<std::vector<map::CatalogueEntry>>& told) {
      if (told) maps = *told;
    });
    QTRY_VERIFY(maps.size() > 1);
    const auto other =
        std::find_if(maps.begin(), maps.end(), [](const auto& entry) { return !entry.is_current; });
    const auto current =
        std::find_if(maps.begin(), maps.end(), [](const auto& entry) { return entry.is_current; });
    QVERIFY(other != maps.end() && current != maps.end());
    startRecording(SubmapRequests::Which::None);
    recorder_->fetches().wantMap(other->key);
    recorder_->fetches().wantMap(other->key);
    recorder_->fetches().wantMap({map::MapKind::Live, {}});
    QTRY_VERIFY(recorder_->progress().written.files >= 6);
    const Film film = end();
    for (const auto& [entry, is_current] : {std::pair(*other, false), std::pair(*current, true)}) {
      QVERIFY(film.files.contains(mapName(entry.key)));
      QVERIFY(film.files.contains(waypointsName(entry.key)));
      const auto facts =
          QJsonDocument::fromJson(QByteArray::fromStdString(film.files.at(mapFactsName(entry.key)).bytes));
      QCOMPARE(facts[QStringLiteral("current")].toBool(), is_current);
      QCOMPARE(facts[QStringLiteral("uid")].toString().toStdString(), entry.uid);
    }
    QVERIFY(!film.hasFile("maps/live"));
  }

  void aRecordingThatBeginsInTheMiddleBeginsWithWhatWasSaidOnce() {
    startSimulator();
    makeAxbot();
    std::set<std::string> topics;
    connect(robot_.get(), &robot::Robot::topicReceived, this,
            [&](const map::StampedMessage& message) { topics.insert(message.topic); });
    connectRobot();
    QTRY_VERIFY(topics.contains("/robot_model") && topics.contains("/submap_list") &&
                topics.contains("/tracked_pose"));
    startRecording(SubmapRequests::Which::None);
    QTRY_VERIFY(messages() > 40);
    const Film film = end();
    for (const char* topic : {"/robot_model", "/submap_list", "/tracked_pose"}) {
      const auto before = film.of(topic, true);
      QVERIFY2(before.size() == 1, topic);
      QCOMPARE(std::to_string(before.front().log_ns), film.metadata.at(kAbout).at("started_ns"));
      QVERIFY(before.front().publish_ns <= before.front().log_ns);
    }
    const auto later =
        std::find_if(film.rows.begin(), film.rows.end(), [](const Row& row) { return !row.before; });
    QVERIFY(later != film.rows.end());
    QVERIFY2(std::none_of(later, film.rows.end(), [](const Row& row) { return row.before; }),
             "they come first");
  }

  void everyMessageOfARosRobotIsInTheFileAsRosWritesIt_data() {
    QTest::addColumn<bool>("ros2");
    QTest::addColumn<bool>("rosapi");
    QTest::newRow("ROS 1") << false << true;
    QTest::newRow("ROS 2") << true << true;
    QTest::newRow("nobody tells what types are made of") << false << false;
  }
  void everyMessageOfARosRobotIsInTheFileAsRosWritesIt() {
    QFETCH(bool, ros2);
    QFETCH(bool, rosapi);
    simulator::Options options;
    options.ros.dialect = ros2 ? simulator::RosDialect::Ros2 : simulator::RosDialect::Ros1;
    options.ros.rosapi = rosapi;
    startSimulator(options);
    robot_ = rosRobot();
    startRecording();
    tapFrames();
    connectRobot();
    // The map is the largest message, and others overtake it.
    QTRY_VERIFY_WITH_TIMEOUT(messages() > 60 && hasCome("/map"), 30'000);
    // What a type is made of is told after its first message; until then that is held back.
    const auto so_far = messages();
    QTRY_VERIFY_WITH_TIMEOUT(messages() > so_far + 150, 30'000);
    const Film film = end();
    QVERIFY(film.finished);
    const std::lock_guard lock(mutex_);
    std::map<std::string, std::vector<QJsonValue>> sent;
    for (const std::string& bytes : frames_) {
      const auto frame = frameOf(bytes);
      sent[frame->root()["topic"].text()].push_back(
          QJsonDocument::fromJson(frame->root()["msg"].toWholeJson()).object());
    }
    const std::string encoding = !rosapi ? "json" : ros2 ? "cdr" : "ros1";
    std::set<std::string> topics;
    for (const Row& row : film.rows) {
      if (row.before) continue;
      const std::vector<QJsonValue>& of = sent[row.topic];
      QVERIFY2(std::find(of.begin(), of.end(), contentOf(row)) != of.end(), row.topic.c_str());
      QVERIFY2(row.encoding == encoding, (row.topic + ' ' + row.encoding).c_str());
      QCOMPARE(row.channel->schema_encoding, std::string(!rosapi ? "jsonschema"
                                                         : ros2  ? "ros2msg"
                                                                 : "ros1msg"));
      QVERIFY(!row.channel->schema_data.empty());
      topics.insert(row.topic);
    }
    QVERIFY(topics.size() >= 5 && topics.contains("/tf") && topics.contains("/map"));
  }

  void aRosRecordingInTheMiddleHasTheMapAndTheFramesThatWereSaidOnce() {
    startSimulator();
    robot_ = rosRobot();
    std::set<std::string> topics;
    connect(robot_.get(), &robot::Robot::topicReceived, this,
            [&](const map::StampedMessage& message) { topics.insert(message.topic); });
    connectRobot();
    QTRY_VERIFY(topics.contains("/map") && !topics.empty());
    startRecording();
    QTRY_VERIFY(messages() > 20);
    const Film film = end();
    QCOMPARE(film.of("/map", true).size(), std::size_t(1));
    QVERIFY(!film.of("/tf_static", true).empty());
    QVERIFY(!film.of("/tf").empty());
  }

  void anAgibotRobotIsRecordedWithWhatItIsAskedAndTheBridgeBesideIt() {
    startSimulator();
    makeAimdk();
    connectRobot();
    startRecording();
    QTRY_VERIFY(messages() > 20 && recorder_->progress().written.files >= 3);
    const Film film = end();
    auto names = film.of("/aimdk/GetStoredMapNames", true);
    QCOMPARE(names.size(), std::size_t(1));
    QVERIFY(QJsonDocument::fromJson(QByteArray::fromStdString(names.front().bytes)).isObject());
    QVERIFY(!film.of("/aimdk/GetTopoMsgs").empty());
    QVERIFY(!film.of("/tf").empty());
    QVERIFY(film.hasFile("maps/stored/"));
    QVERIFY(film.hasFile("waypoints/stored/"));
  }

  void whatLiesOnTheDiskWhileItIsRecordedCanBeReadAlready() {
    startSimulator();
    makeAxbot();
    connectRobot();
    startRecording(SubmapRequests::Which::None);
    QTRY_VERIFY(recorder_->progress().written.messages > 60);
    const Film now = read(path_);
    QVERIFY(!now.finished);
    QVERIFY(!now.rows.empty());
    const Film film = end();
    QVERIFY(film.finished);
    QVERIFY(film.rows.size() >= now.rows.size());
  }

  void whereTheLinkWasAwayStandsInTheFile() {
    startSimulator();
    makeAxbot();
    connectRobot();
    startRecording(SubmapRequests::Which::None);
    QTRY_VERIFY(messages() > 10);
    simulator::Options again;
    again.port = simulator_->port();
    simulator_->stop();
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Interrupted);
    startSimulator(again);
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Online);
    const std::uint64_t until_then = messages();
    QTRY_VERIFY(messages() > until_then + 10);
    const Film film = end();
    const recording::Values& link = film.metadata.at(kLink);  // the last one counts
    const auto number = [&](const char* name) {
      return QByteArray::fromStdString(link.at(name)).toLongLong();
    };
    QVERIFY(number("lost_ns") < number("back_ns"));
    for (const Row& row : film.rows)
      QVERIFY(row.log_ns < number("lost_ns") || row.log_ns >= number("back_ns") - 1'000'000'000);
  }

  void aRobotThatIsGoneEndsNothingButItself() {
    startSimulator();
    makeAxbot();
    connectRobot();
    startRecording(SubmapRequests::Which::None);
    QTRY_VERIFY(messages() > 10);
    robot_.reset();
    recorder_->finish();
    QVERIFY(recorder_->progress().finished);
    recorder_.reset();
    QVERIFY(read(path_).finished);
  }
};

}  // namespace test_recorder

MAPWRIGHT_TEST(test_recorder, RecorderTest, Core)
#include "test_recorder.moc"
