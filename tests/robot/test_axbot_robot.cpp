#include <atomic>
#include <mutex>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "../net/scripted_server.h"
#include "net/http_cache.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/map_administration.h"
#include "robot/map_transfer.h"
#include "robot/overlay_store.h"
#include "ros_messages/wrapper.pb.h"
#include "scripted_robot.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_axbot_robot {

using namespace mapwright;
using namespace mapwright::robot;
using axbot::AxbotRobot;
using testing::ScriptedRobot;

namespace {

constexpr int kPatienceMs = 20'000;

/// The answer to one question, waited for.
template <typename T, typename Ask>
Outcome<T> answerTo(Ask ask) {
  std::optional<Outcome<T>> answer;
  ask([&](Outcome<T> given) { answer = std::move(given); });
  if (!QTest::qWaitFor([&] { return answer.has_value(); }, kPatienceMs)) {
    return tl::make_unexpected(map::Failure{.subject = "test", .detail = "no answer"});
  }
  return *answer;
}

/// Header of a PNG that says 3 x 2; the rest does not matter here.
QByteArray png() {
  return QByteArray::fromHex("89504e470d0a1a0a0000000d49484452000000030000000208000000") + "rest";
}

/// A submap's answer without pictures.
QByteArray submap(int version) {
  ros_messages::slam::SubmapQueryV2Response response;
  response.mutable_status()->set_code(ros_messages::slam::OK);
  response.set_submap_version(version);
  response.add_textures()->set_resolution(0.05);
  return QByteArray::fromStdString(response.SerializeAsString());
}

}  // namespace

class AxbotRobotTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<ScriptedRobot> server_;
  std::unique_ptr<QTemporaryDir> cache_;
  std::unique_ptr<AxbotRobot> robot_;
  std::vector<map::Problem> problems_;
  std::vector<map::Recovery> recoveries_;
  std::vector<map::TopicMessage> messages_;
  std::vector<map::StampedMessage> stamped_;  // the same, whole
  std::atomic<double> wall_s_ = 1;

  void makeRobot(const QString& prefix = {}, const QString& cache_folder = {}) {
    axbot::LinkOptions options;
    options.base = server_->url();
    options.base.setPath(prefix);
    options.secret = "hush";
    options.cache_folder = cache_folder.isEmpty() ? cache_->path() : cache_folder;
    options.socket.backoff_first = std::chrono::milliseconds(5);
    options.wall_s = [this] { return wall_s_.load(); };
    options.socket.backoff_limit = std::chrono::milliseconds(20);
    robot_ = std::make_unique<AxbotRobot>(QStringLiteral("axbot+test"), options);
    connect(robot_.get(), &Robot::problemFound, this,
            [this](const map::Problem& p) { problems_.push_back(p); });
    connect(robot_.get(), &Robot::recovered, this,
            [this](const map::Recovery& r) { recoveries_.push_back(r); });
    connect(robot_.get(), &Robot::topicReceived, this, [this](const map::StampedMessage& m) {
      messages_.push_back(m.message);
      stamped_.push_back(m);
    });
  }
  void connectRobot() {
    server_->serve("/device/info", "{\"caps\":{\"supportsEnableTopicList\":true}}");
    robot_->connectToRobot();
    QTRY_VERIFY_WITH_TIMEOUT(server_->topicsSent("enable_topic").contains(QStringLiteral("/slam/state")),
                             kPatienceMs);
  }
  template <typename T>
  const T* last() const {
    const T* found = nullptr;
    for (const auto& message : messages_) {
      if (const T* one = std::get_if<T>(&message)) found = one;
    }
    return found;
  }
  bool recovered(map::SubjectKind kind, const char* id) const {
    return std::any_of(recoveries_.begin(), recoveries_.end(),
                       [&](const auto& one) { return one.subject == map::Subject(kind, id); });
  }
  void sendMapV2(const QByteArray& url) {
    server_->send(
        "{\"topic\":\"/map_v2\",\"resolution\":0.05,\"size\":[3,2],\"origin\":[1,2],\"data_url\":"
        "\"" +
        url + "\"}");
  }
  Outcome<std::vector<map::CatalogueEntry>> list() {
    return answerTo<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { robot_->mapCatalogue()->list(reply); });
  }
  map::SubmapAnswer fetchSubmap(const map::SubmapKey& key) {
    std::optional<map::SubmapAnswer> answer;
    robot_->submapSource()->fetch(key, [&](map::SubmapAnswer given) { answer = std::move(given); });
    if (!QTest::qWaitFor([&] { return answer.has_value(); }, kPatienceMs)) return {};
    return *answer;
  }
  Outcome<map::WholeMap> fetch(const map::MapKey& key) {
    return answerTo<map::WholeMap>([&](auto reply) { robot_->wholeMapSource()->fetch(key, reply); });
  }

 private Q_SLOTS:
  void init() {
    cache_ = std::make_unique<QTemporaryDir>();
    server_ = std::make_unique<ScriptedRobot>();
    problems_.clear();
    recoveries_.clear();
    messages_.clear();
    makeRobot();
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  void picturesOfOtherHostsAreAskedOfTheRobotItself() {
    ScriptedRobot elsewhere;
    server_->serve("/static-files/a.png", png());
    connectRobot();
    sendMapV2(elsewhere.url().toEncoded() + "/static-files/a.png");
    QTRY_VERIFY_WITH_TIMEOUT(last<map::GridMessage>() != nullptr, kPatienceMs);
    QCOMPARE(QByteArray::fromStdString(*last<map::GridMessage>()->png), png());
    QVERIFY(!last<map::GridMessage>()->fingerprint.empty());
    QVERIFY2(elsewhere.asked.isEmpty(), "the secret belongs to one origin");
    QCOMPARE(server_->timesAsked("/static-files/a.png"), 1);
  }

  void aPictureThatIsGoneIsReported() {
    connectRobot();
    sendMapV2("static-files/gone.png");
    QTRY_VERIFY_WITH_TIMEOUT(last<map::UnreadableMessage>() != nullptr, kPatienceMs);
    QCOMPARE(last<map::UnreadableMessage>()->topic, std::string("/map_v2"));
    const QString why = sentences::wordsOf(last<map::UnreadableMessage>()->reason);
    QVERIFY2(why.contains(QLatin1String("404")) && !why.contains(QLatin1String("hush")), qPrintable(why));
  }

  void aTopicThatCanBeReadAgainIsTold_data() {
    QTest::addColumn<QByteArray>("topic");
    QTest::addColumn<QByteArray>("broken");
    QTest::addColumn<QByteArray>("well");
    const auto row = [](const char* topic, const char* broken, const char* well) {
      QTest::newRow(topic) << QByteArray(topic) << QByteArray(broken) << QByteArray(well);
    };
    row("/map_v2",
        R"({"topic":"/map_v2","resolution":0.05,"size":[3,2],"origin":[1,2],"data_url":"gone.png"})",
        R"({"topic":"/map_v2","resolution":0.05,"size":[3,2],"origin":[1,2],"data_url":"a.png"})");
    row("/submap_list", R"({"topic":"/submap_list","submap":7})",
        R"({"topic":"/submap_list","uuid":"u","submap":[]})");
    row("/tracked_pose", R"({"topic":"/tracked_pose","pos":"none"})",
        R"({"topic":"/tracked_pose","pos":[1,2],"ori":0})");
    row("/scan_matched_points2", R"({"topic":"/scan_matched_points2"})",
        R"({"topic":"/scan_matched_points2","points":[[1,2,0]]})");
    row("(unknown)", "]garbage[", R"({"topic":"/tracked_pose","pos":[1,2],"ori":0})");
  }
  void aTopicThatCanBeReadAgainIsTold() {
    QFETCH(QByteArray, topic);
    QFETCH(QByteArray, broken);
    QFETCH(QByteArray, well);
    server_->serve("/a.png", png());
    connectRobot();
    server_->send(well);
    server_->send(broken);
    QTRY_VERIFY_WITH_TIMEOUT(last<map::UnreadableMessage>() != nullptr, kPatienceMs);
    QCOMPARE(last<map::UnreadableMessage>()->topic, topic.toStdString());
    QVERIFY2(!recovered(map::SubjectKind::Topic, topic), "nothing was wrong before");
    server_->send(well);
    QTRY_VERIFY_WITH_TIMEOUT(recovered(map::SubjectKind::Topic, topic), kPatienceMs);
  }

  void aBinaryTopicThatCanBeReadAgainIsTold() {
    connectRobot();
    ros_messages::RosMessageWrapper wrapper;
    wrapper.mutable_submap_list()->set_uuid("u");
    const QByteArray head = QByteArray("\x0c/submap_list") + '\0';
    server_->sendBinary(head + "garbage");
    QTRY_VERIFY_WITH_TIMEOUT(last<map::UnreadableMessage>() != nullptr, kPatienceMs);
    server_->sendBinary(head + QByteArray::fromStdString(wrapper.SerializeAsString()));
    QTRY_VERIFY_WITH_TIMEOUT(recovered(map::SubjectKind::Topic, "/submap_list"), kPatienceMs);
  }

  void aPartOfTheListThatCanBeHadAgainIsTold() {
    server_->serve("/maps/", R"([{"id":1},{"uid":"no id"}])");
    server_->answers["/mappings/"] = ScriptedRobot::reply(500, "oops");
    server_->answers["/chassis/current-map"] = ScriptedRobot::reply(500, "oops");
    QVERIFY(list().has_value());
    QCOMPARE(problems_.size(), std::size_t(3));
    for (const map::Problem& problem : problems_) {
      QVERIFY(problem.subject.kind == map::SubjectKind::Catalogue);
      QVERIFY(problem.code != map::ProblemCode::Unspecified);
    }
    QVERIFY(!recovered(map::SubjectKind::Catalogue, map::kMappingsPart));
    server_->serve("/maps/", R"([{"id":1}])");
    // Firmware that does not know mappings has none.
    server_->answers["/mappings/"] = ScriptedRobot::reply(404, "what?");
    problems_.clear();
    QVERIFY(list().has_value());
    QCOMPARE(problems_.size(), std::size_t(1));
    QCOMPARE(problems_.front().subject.id, std::string(map::kCurrentMapPart));
    server_->serve("/mappings/", "[]");
    server_->answers.remove("/chassis/current-map");  // there is none: that is an answer too
    recoveries_.clear();
    QVERIFY(list().has_value());
    for (const char* part : {map::kMapsPart, map::kMappingsPart, map::kCurrentMapPart}) {
      QVERIFY2(recovered(map::SubjectKind::Catalogue, part), part);
    }
    QCOMPARE(problems_.size(), std::size_t(1));
  }

  void picturesThatMayBeKeptAreFetchedOnce() {
    server_->serve("/a.png", png(), "Cache-Control: public, max-age=2592000\r\n");
    connectRobot();
    for (const char* url : {"a.png", "/a.png", "http://10.0.0.1:8090/a.png"}) {
      messages_.clear();
      sendMapV2(url);
      QTRY_VERIFY_WITH_TIMEOUT(last<map::GridMessage>() != nullptr, kPatienceMs);
    }
    QCOMPARE(server_->timesAsked("/a.png"), 1);
  }

  void whatOlderFirmwareCallsOtherwiseIsAskedForWhenTheUsualNameStaysSilent() {
    axbot::LinkOptions options;
    options.base = server_->url();
    options.older_names_after = std::chrono::milliseconds(30);
    options.socket.backoff_first = std::chrono::milliseconds(5);
    options.wall_s = [this] { return wall_s_.load(); };
    robot_ = std::make_unique<AxbotRobot>(QStringLiteral("axbot+test"), options);
    const auto asked = [&](const char* topic) {
      return server_->topicsSent("enable_topic").contains(QLatin1String(topic));
    };
    LiveTopics* topics = robot_->liveTopics();
    QCOMPARE(topics->topicsOf(map::Stream::WholeMap),
             (QStringList{QStringLiteral("/map_v2"), QStringLiteral("/map")}));
    topics->setWanted({map::Stream::WholeMap, map::Stream::Incremental, map::Stream::Path}, {});
    connectRobot();
    QVERIFY(asked("/map_v2") && asked("/incremental_map_v2") && asked("/path"));
    QTRY_VERIFY_WITH_TIMEOUT(asked("/map") && asked("/incremental_map"), kPatienceMs);
    // One that has spoken has no older name: not on the next connection, if it speaks at once.
    server_->greeting =
        "{\"topic\":\"/map_v2\",\"resolution\":0.05,\"size\":[3,2],\"origin\":[1,2],\"data\":\"" +
        png().toBase64() + "\"}";
    server_->texts.clear();
    server_->peers.first()->abort();
    QTRY_VERIFY_WITH_TIMEOUT(asked("/incremental_map"), kPatienceMs);
    QVERIFY(asked("/map_v2") && !asked("/map"));
    topics->setWanted({}, {});
    QTRY_VERIFY_WITH_TIMEOUT(
        server_->topicsSent("disable_topic").contains(QStringLiteral("/incremental_map")), kPatienceMs);
  }

  void whatIsSaidOnceIsAskedForAgainAfterAFrameThatNobodyCouldRead() {
    axbot::LinkOptions options;
    options.base = server_->url();
    options.ask_again_after = std::chrono::milliseconds(20);
    options.socket.backoff_first = std::chrono::milliseconds(5);
    options.wall_s = [this] { return wall_s_.load(); };
    robot_ = std::make_unique<AxbotRobot>(QStringLiteral("axbot+test"), options);
    robot_->liveTopics()->setWanted({}, {QStringLiteral("/map/info"), QStringLiteral("/battery_state")});
    connectRobot();
    QTRY_VERIFY_WITH_TIMEOUT(server_->topicsSent("enable_topic").contains(QStringLiteral("/map/info")),
                             kPatienceMs);
    for (int i = 0; i < 3; ++i) server_->send(R"({"topic":"/battery_state","percentage":0.5})");
    server_->texts.clear();
    server_->send("{\"topic\":\"/map/in#o\",\"overl");  // it was the map's, and nobody can know that
    QTRY_VERIFY_WITH_TIMEOUT(server_->topicsSent("enable_topic").contains(QStringLiteral("/map/info")),
                             kPatienceMs);
    QVERIFY(server_->topicsSent("disable_topic").contains(QStringLiteral("/map/info")));
    // What comes all the time comes by itself.
    QVERIFY(!server_->topicsSent("enable_topic").contains(QStringLiteral("/battery_state")));
  }

  void everyStreamHasATopicThatIsUnderstood() {
    for (int stream = 0; stream <= int(map::Stream::GlobalPositioning); ++stream) {
      const QStringList topics = robot_->liveTopics()->topicsOf(map::Stream(stream));
      QVERIFY2(!topics.isEmpty(), qPrintable(QString::number(stream)));
      for (const QString& topic : topics)
        QVERIFY2(robot_->liveTopics()->known().contains(topic), qPrintable(topic));
    }
  }

  void wantedTopicsAreSwitchedOnAndOffAndKept() {
    connectRobot();
    LiveTopics* topics = robot_->liveTopics();
    topics->setWanted({map::Stream::Path}, {QStringLiteral("/map"), QStringLiteral("/tracked_pose")});
    QTRY_VERIFY_WITH_TIMEOUT(server_->topicsSent("enable_topic").contains(QStringLiteral("/map")),
                             kPatienceMs);
    topics->setWanted({map::Stream::Alerts, map::Stream::Path}, {QStringLiteral("/path")});
    QTRY_VERIFY_WITH_TIMEOUT(server_->topicsSent("enable_topic").contains(QStringLiteral("/alerts")),
                             kPatienceMs);
    QCOMPARE(server_->topicsSent("disable_topic"), QStringList{QStringLiteral("/map")});
    QCOMPARE(server_->topicsSent("enable_topic").count(QStringLiteral("/path")), 1);
    QCOMPARE(server_->topicsSent("enable_topic").count(QStringLiteral("/tracked_pose")), 1);
    server_->texts.clear();
    server_->peers.first()->abort();
    QTRY_VERIFY_WITH_TIMEOUT(server_->topicsSent("enable_topic").contains(QStringLiteral("/alerts")),
                             kPatienceMs);
    const QStringList again = server_->topicsSent("enable_topic");
    QVERIFY(again.contains(QStringLiteral("/path")) && again.contains(QStringLiteral("/submap_list")));
    QVERIFY(!again.contains(QStringLiteral("/map")));
  }

  void watchingShowsEveryMessageAsItCame() {
    QSignalSpy raw(robot_.get(), &Robot::rawReceived);
    connectRobot();
    server_->send("{\"topic\":\"/before\"}");
    server_->send("{\"topic\":\"/tracked_pose\",\"pos\":[1,2],\"ori\":0}");
    QTRY_VERIFY_WITH_TIMEOUT(last<map::TrackedPose>() != nullptr, kPatienceMs);
    QCOMPARE(raw.size(), 0);
    robot_->liveTopics()->setWatching(true);
    // The order of a queued call and of what comes over the network is not fixed: ask until it shows.
    QTRY_VERIFY_WITH_TIMEOUT((server_->send("{\"topic\":\"/odd\",\"a\":1}"), !raw.isEmpty()), kPatienceMs);
    const auto text = raw.first().first().value<RawMessage>();
    QCOMPARE(text.topic, QStringLiteral("/odd"));
    QCOMPARE(text.text, QByteArray("{\"topic\":\"/odd\",\"a\":1}"));
    ros_messages::RosMessageWrapper wrapper;
    wrapper.mutable_point_cloud()->set_point_number(77);
    server_->sendBinary(QByteArray("\x04/pts") + '\0' +
                        QByteArray::fromStdString(wrapper.SerializeAsString()));
    QTRY_VERIFY_WITH_TIMEOUT(raw.last().first().value<RawMessage>().binary, kPatienceMs);
    QVERIFY(raw.last().first().value<RawMessage>().text.contains("77"));
  }

  void everyMessageBearsWhenItCameAndOfWhichTopic() {
    wall_s_ = 1000;
    connectRobot();
    server_->send("{\"topic\":\"/tracked_pose\",\"pos\":[1,2],\"ori\":0}");
    QTRY_VERIFY_WITH_TIMEOUT(last<map::TrackedPose>() != nullptr, kPatienceMs);
    QCOMPARE(stamped_.back().received_s, 1000.0);
    QCOMPARE(stamped_.back().topic, std::string("/tracked_pose"));
    QVERIFY(!stamped_.back().recorded_s);
    wall_s_ = 1001;
    server_->send("{\"topic\":\"/trajectory\",\"points\":[[1,2],[3,4]]}");  // goes by mail
    QTRY_VERIFY_WITH_TIMEOUT(last<map::TrajectoryMessage>() != nullptr, kPatienceMs);
    QCOMPARE(stamped_.back().received_s, 1001.0);
    QCOMPARE(stamped_.back().topic, std::string("/trajectory"));
  }

  void aTapGetsEveryFrameAlsoThoseThatOthersReplaceAndNoneAfterItsEnd() {
    connectRobot();
    std::mutex mutex;
    std::vector<std::string> frames;
    robot_->liveTopics()->setTap([&](const RawFrame& frame) {
      const std::lock_guard lock(mutex);
      frames.emplace_back(frame.bytes);
      if (frame.binary) frames.back() = "binary";
    });
    // The window is busy meanwhile: of the trajectory only the last is of use to it.
    constexpr int kFrames = 500;  // more than the inspector of messages takes in a second
    for (int i = 0; i < kFrames; ++i)
      server_->send("{\"topic\":\"/trajectory\",\"points\":[[" + QByteArray::number(i) + ",0]]}");
    server_->sendBinary("no frame");
    const auto count = [&] {
      const std::lock_guard lock(mutex);
      return frames.size();
    };
    QTRY_COMPARE_WITH_TIMEOUT(count(), std::size_t(kFrames + 1), kPatienceMs);
    QVERIFY(frames.front().find("[[0,0]]") != std::string::npos);
    QVERIFY(frames[kFrames - 1].find("[[499,0]]") != std::string::npos);
    QCOMPARE(frames.back(), std::string("binary"));
    robot_->liveTopics()->setTap({});
    messages_.clear();
    server_->send("{\"topic\":\"/tracked_pose\",\"pos\":[1,2],\"ori\":0}");
    QTRY_VERIFY_WITH_TIMEOUT(last<map::TrackedPose>() != nullptr, kPatienceMs);
    QCOMPARE(frames.size(), std::size_t(kFrames + 1));
  }

  // What cannot be read does not stay on disk.
  void aSubmapThatLiesBrokenOnTheDiskIsAskedOfTheRobot_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("not a submap") << QByteArray("\xff\xff not protobuf");
    QTest::newRow("cut off") << submap(7).chopped(3);
    QTest::newRow("empty") << QByteArray();
    ros_messages::slam::SubmapQueryV2Response refused;
    refused.mutable_status()->set_code(ros_messages::slam::NOT_FOUND);
    QTest::newRow("a refusal") << QByteArray::fromStdString(refused.SerializeAsString());
  }
  void aSubmapThatLiesBrokenOnTheDiskIsAskedOfTheRobot() {
    QFETCH(QByteArray, body);
    const map::SubmapKey key{"u", {0, 1}, 7};
    QUrl url = server_->url();
    url.setPath(QStringLiteral("/ros/slam/submaps/u/0/1"));
    url.setQuery(QStringLiteral("ver=7"));
    net::HttpCache(cache_->path(), 1 << 20)
        .store(url, body, {}, "immutable, max-age=31536000", "\"e\"", true);
    server_->serve("/ros/slam/submaps/u/0/1", submap(7), "ETag: \"e\"\r\n");
    const map::SubmapAnswer answer = fetchSubmap(key);
    QCOMPARE(answer.outcome, map::SubmapAnswer::Outcome::Ok);
    QCOMPARE(server_->timesAsked("/ros/slam/submaps/u/0/1"), 1);
    QVERIFY(!server_->asked.first().headers.contains("if-none-match"));
  }

  void aSubmapThatCannotBeDecodedIsAskedAgainNowAndAfterARestart() {
    const map::SubmapKey key{"u", {0, 1}, 7};
    // Asked for as version 7, it says that it is version 9: it lies under both names.
    server_->serve("/ros/slam/submaps/u/0/1", submap(9),
                   "ETag: \"e\"\r\nCache-Control: immutable, max-age=900\r\n");
    QCOMPARE(fetchSubmap(key).version, 9);
    QVERIFY(fetchSubmap(key).from_cache);
    QVERIFY(fetchSubmap({"u", {0, 1}, 9}).from_cache);
    QCOMPARE(server_->timesAsked("/ros/slam/submaps/u/0/1"), 1);
    robot_->submapSource()->discard(key, 9);
    QVERIFY(!fetchSubmap(key).from_cache);
    QCOMPARE(server_->timesAsked("/ros/slam/submaps/u/0/1"), 2);
    for (const auto& asked : server_->asked) QVERIFY(!asked.headers.contains("if-none-match"));
    robot_->submapSource()->discard(key, 9);
    makeRobot();
    QVERIFY(!fetchSubmap({"u", {0, 1}, 9}).from_cache);
    QVERIFY(!server_->asked.last().headers.contains("if-none-match"));
  }

  void aPictureThatCannotBeReadIsAskedAgain() {
    const QByteArray keep = "ETag: \"e\"\r\nCache-Control: max-age=2592000\r\n";
    server_->serve("/maps/7", "{\"id\":7,\"grid_origin_x\":0,\"grid_origin_y\":0,\"grid_resolution\":0.05}");
    server_->serve("/maps/7.png", png(), keep);
    server_->serve("/live.png", png() + "live", keep);
    server_->serve("/maps/7/thumbnail", "not even a picture", keep);
    const map::MapKey key{map::MapKind::Stored, "7"};
    const auto thumbnail = [&] {
      return answerTo<std::string>([&](auto reply) { robot_->mapCatalogue()->thumbnail(key, reply); });
    };
    connectRobot();
    const auto live = [&] {
      messages_.clear();
      sendMapV2("/live.png");
      return QTest::qWaitFor([&] { return last<map::GridMessage>() != nullptr; }, kPatienceMs);
    };
    for (int times = 0; times < 2; ++times) QVERIFY(fetch(key) && live() && thumbnail());
    for (const char* path : {"/maps/7.png", "/live.png", "/maps/7/thumbnail"})
      QCOMPARE(server_->timesAsked(path), 1);
    robot_->wholeMapSource()->discardPicture(fetch(key)->fingerprint);
    robot_->wholeMapSource()->discardPicture(last<map::GridMessage>()->fingerprint);
    robot_->mapCatalogue()->discardThumbnail(key);
    server_->asked.clear();
    QVERIFY(fetch(key) && live() && thumbnail());
    for (const char* path : {"/maps/7.png", "/live.png", "/maps/7/thumbnail"})
      QCOMPARE(server_->timesAsked(path), 1);
    for (const auto& asked : server_->asked) QVERIFY(!asked.headers.contains("if-none-match"));
  }

  void anEmptyPictureIsNotKept() {
    server_->serve("/maps/7", "{\"id\":7,\"grid_origin_x\":0,\"grid_origin_y\":0,\"grid_resolution\":0.05}");
    server_->serve("/maps/7.png", "", "ETag: \"e\"\r\nCache-Control: max-age=2592000\r\n");
    QVERIFY(!fetch({map::MapKind::Stored, "7"}));
    server_->serve("/maps/7.png", png(), "ETag: \"e\"\r\n");
    QVERIFY(fetch({map::MapKind::Stored, "7"}).has_value());
  }

  void aCacheThatCannotBeWrittenIsToldOnceAndHarmsNothing() {
    QFile obstacle(cache_->filePath(QStringLiteral("file")));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    makeRobot({}, obstacle.fileName());
    server_->serve("/ros/slam/submaps/u/0/1", submap(7));
    for (int version = 1; version < 4; ++version) {
      QCOMPARE(fetchSubmap({"u", {0, 1}, version}).outcome, map::SubmapAnswer::Outcome::Ok);
    }
    const auto told = std::count_if(problems_.begin(), problems_.end(), [](const map::Problem& problem) {
      return problem.subject == map::SubjectKind::DiskCache;
    });
    QCOMPARE(told, 1);
  }

  void mapsAndMappingsAreListedAndTheCurrentOneMarked() {
    server_->serve("/maps/",
                   "[{\"id\":1,\"uid\":\"a\",\"map_name\":\"<b>Hall</b> "
                   "🏭\",\"create_time\":1644568815,\"map_version\":9,\"thumbnail_url\":\"http://x/maps/1/"
                   "thumbnail\"},{\"id\":2,\"uid\":\"b\"},{\"uid\":\"no id\"}]");
    server_->serve("/mappings",
                   "{\"results\":[{\"id\":48,\"state\":\"finished\",\"start_time\":1647520760000,\"grid_"
                   "origin_x\":-8,\"grid_origin_y\":-5,\"grid_resolution\":0.05}]}");
    server_->serve("/chassis/current-map", "{\"id\":-1,\"uid\":\"b\"}");
    const auto entries = list();
    QVERIFY(entries.has_value());
    QCOMPARE(entries->size(), std::size_t(3));
    QCOMPARE(entries->at(0).name, std::string("<b>Hall</b> 🏭"));
    QVERIFY(entries->at(0).has_thumbnail && !entries->at(0).is_current);
    QVERIFY(entries->at(1).is_current);
    QCOMPARE(entries->at(2).key, (map::MapKey{map::MapKind::Mapping, "48"}));
    QCOMPARE(*entries->at(2).created_s, 1647520760.0);
    QVERIFY(entries->at(2).grid.has_value());
    QTRY_COMPARE(problems_.size(), std::size_t(1));  // the row without an id
    for (const auto& asked : server_->asked) QCOMPARE(asked.headers.value("secret"), QByteArray("hush"));
  }

  void halfAListIsAnAnswer() {
    server_->serve("/maps/", "[{\"id\":1}]");
    server_->answers["/mappings/"] = ScriptedRobot::reply(500, "<html><body>oops</body></html>");
    const auto entries = list();
    QCOMPARE(entries->size(), std::size_t(1));
    QCOMPARE(problems_.size(), std::size_t(1));
    QVERIFY(problems_[0].subject == map::Subject(map::SubjectKind::Catalogue, map::kMappingsPart));
  }

  void noListAtAllIsAnError() {
    const auto entries = list();
    QVERIFY(!entries.has_value());
    QCOMPARE(entries.error().robot_code, std::string("404"));
    QCOMPARE(entries.error().kind, map::FailureKind::RejectedByRobot);
  }

  void aStoredMapComesWhole() {
    server_->serve("/maps/7",
                   "{\"id\":7,\"map_name\":\"Hall\",\"grid_origin_x\":\"-53.2\",\"grid_origin_y\":-25,\"grid_"
                   "resolution\":0.05,\"image_url\":\"http://192.168.25.25:8090/maps/"
                   "7.png\",\"overlays\":\"{\\\"type\\\":\\\"FeatureCollection\\\",\\\"features\\\":[{"
                   "\\\"geometry\\\":{\\\"type\\\":\\\"Point\\\",\\\"coordinates\\\":[1,2]}}]}\"}");
    server_->serve("/maps/7.png", png());
    const auto map = fetch({map::MapKind::Stored, "7"});
    QVERIFY2(map.has_value(), map ? "" : sentences::sentenceOf(map.error()).c_str());
    QCOMPARE(map->name, std::string("Hall"));
    QCOMPARE(map->grid, (map::GridReference{3, 2, 0.05, {-53.2, -25, 0}}));
    QCOMPARE(QByteArray::fromStdString(*map->bytes), png());
    QCOMPARE(map->overlays.size(), std::size_t(1));
    QVERIFY(!map->fingerprint.empty());
    QCOMPARE(map->reading.mode, map::CellReading::Mode::Picture);
  }

  void dataOfAnotherSizeThanTheMapHasIsNoData_data() {
    QTest::addColumn<QByteArray>("data");
    QTest::newRow("cut") << QByteArray("01234");
    QTest::newRow("a page") << QByteArray("<html>login</html>");
    QTest::newRow("none") << QByteArray("");
  }
  void dataOfAnotherSizeThanTheMapHasIsNoData() {
    QFETCH(QByteArray, data);
    server_->serve("/maps/1", R"({"id":1,"uid":"u","map_version":3,"pbstream_size":10})");
    server_->serve("/maps/1.pbstream", data);
    MapFacts facts;
    facts.key = {map::MapKind::Stored, "1"};
    facts.uid = "u";
    facts.map_version = 3;
    facts.data_bytes = 10;
    const QString path = cache_->filePath(QStringLiteral("map.pbstream"));
    const auto download = [&] {
      return answerTo<DataDownload>([&](auto reply) { robot_->mapTransfer()->download(facts, path, reply); });
    };
    const auto got = download();
    QVERIFY(!got && got.error().kind == map::FailureKind::MalformedAnswer);
    QVERIFY2(sentences::sentenceOf(got.error()).find("10") != std::string::npos,
             sentences::sentenceOf(got.error()).c_str());
    // Nothing of it is gone on with.
    QVERIFY(!QFile::exists(path) && !QFile::exists(path + QStringLiteral(".part")));
    server_->serve("/maps/1.pbstream", "0123456789");
    const auto whole = download();
    QVERIFY(whole && whole->bytes == 10 && !whole->resumed);
  }

  void anIdInAnotherSpellingChangesNothing() {
    server_->serve("/maps/", R"([{"id":1,"map_name":"Hall"}])");
    server_->serve("/mappings/", "[]");
    server_->serve("/maps/01", R"({"id":1,"map_name":"Hall","overlays":""})");
    const map::MapKey key{map::MapKind::Stored, "01"};
    for (const MapChange change : {MapChange::Delete, MapChange::Rename, MapChange::Load}) {
      const auto done = answerTo<map::CatalogueEntry>([&](auto reply) {
        robot_->mapAdministration()->carryOut({change, key, "Hall"}, reply);
      });
      QVERIFY(!done && done.error().reason == map::FailureReason::NotThere);
    }
    const auto held = answerTo<OverlayText>([&](auto reply) { robot_->overlayStore()->read(key, reply); });
    QVERIFY(!held && held.error().reason == map::FailureReason::NotThere);
    for (const testing::Asked& asked : server_->asked) QCOMPARE(asked.method, QByteArray("GET"));
  }

  void aRefusalOfAChangeIsNotBelieved_data() {
    QTest::addColumn<bool>("makes_it");
    QTest::newRow("made all the same") << true;
    QTest::newRow("not made") << false;
  }
  void aRefusalOfAChangeIsNotBelieved() {
    QFETCH(const bool, makes_it);
    QByteArray name = "Hall";
    net::testing::ScriptedServer server([&](const net::testing::SeenRequest& request) {
      using Server = net::testing::ScriptedServer;
      if (request.method == "PATCH") {
        if (makes_it) name = "Yard";
        return Server::reply(409, {}, R"({"detail":"busy"})");
      }
      if (request.path == "/maps/1")
        return Server::reply(200, {}, R"({"id":1,"map_name":")" + name + R"("})");
      return Server::reply(404, {}, "{}");
    });
    axbot::LinkOptions link;
    link.base = server.url(QString());
    link.cache_folder = cache_->path();
    AxbotRobot robot(QStringLiteral("axbot"), link);
    const auto done = answerTo<map::CatalogueEntry>([&](auto reply) {
      robot.mapAdministration()->carryOut({MapChange::Rename, {map::MapKind::Stored, "1"}, "Yard"}, reply);
    });
    QCOMPARE(done.has_value(), makes_it);
    if (!done) QVERIFY(done.error().applied == map::Applied::No);
  }

  void aWrongPictureAddressFallsBackToTheUsualOne() {
    server_->serve("/maps/7",
                   "{\"id\":7,\"grid_origin_x\":0,\"grid_origin_y\":0,\"grid_resolution\":0.05,\"image_url\":"
                   "\"http://x/old/7.png\"}");
    server_->serve("/maps/7.png", png());
    QVERIFY(fetch({map::MapKind::Stored, "7"}).has_value());
  }

  void aMappingBringsItsTrajectoriesAndLandmarks() {
    server_->serve("/mappings/48",
                   "{\"id\":48,\"grid_origin_x\":0,\"grid_origin_y\":0,\"grid_resolution\":0.05}");
    server_->serve("/mappings/48.png", png());
    server_->serve("/mappings/48/trajectories.json", "[{\"id\":0,\"coordinates\":[[0,0],[1,1]]}]");
    server_->serve("/mappings/48/landmarks.json", "[{\"id\":\"landmark_1\",\"pos\":[1.5,2]}]");
    auto map = fetch({map::MapKind::Mapping, "48"});
    QVERIFY(map.has_value());
    QCOMPARE(map->trajectories.at(0).size(), std::size_t(2));
    QCOMPARE(map->landmarks.at(0).id, std::string("landmark_1"));
    server_->answers.remove("/mappings/48/landmarks.json");
    map = fetch({map::MapKind::Mapping, "48"});
    QVERIFY(map.has_value());
    QCOMPARE(map->notes.size(), std::size_t(1));
  }

  void mapsThatCannotBePlacedAreRefused() {
    for (const QByteArray& members :
         {QByteArray("\"grid_resolution\":0,\"grid_origin_x\":0,\"grid_origin_y\":0"),
          QByteArray("\"grid_resolution\":0.05"), QByteArray("\"grid_resolution\":-1")}) {
      server_->serve("/maps/7", "{\"id\":7," + members + "}");
      const auto map = fetch({map::MapKind::Stored, "7"});
      QVERIFY(!map.has_value());
      QVERIFY(map.error().subject == map::Subject(map::SubjectKind::Map, "7"));
    }
    QVERIFY(!fetch({map::MapKind::Stored, "404"}).has_value());
    QVERIFY(!fetch({map::MapKind::Live, {}}).has_value());
    const auto asked = server_->asked.size();
    for (const char* id : {"", ".", "..", "/", "%2f", "1?x", "1/", "../device/info?x#y"}) {
      for (const map::MapKind kind : {map::MapKind::Stored, map::MapKind::Mapping}) {
        const auto refused = fetch({kind, id});
        QVERIFY2(!refused && refused.error().reason == map::FailureReason::NoSuchId, id);
      }
    }
    QCOMPARE(server_->asked.size(), asked);  // none of them was part of an address
  }

  void theOverviewIsAsked() {
    ros_messages::slam::GetMapImageResponse response;
    response.set_origin_x(-3);
    response.set_origin_y(4);
    response.set_resolution(0.2);
    response.set_png_bytes(png().toStdString());
    server_->serve("/ros/slam/map_image", QByteArray::fromStdString(response.SerializeAsString()));
    const auto ask = [&](auto reply) { robot_->overviewSource()->fetchOverview(0.2, reply); };
    auto overview = answerTo<map::WholeMap>(ask);
    QVERIFY(overview.has_value());
    QCOMPARE(overview->grid, (map::GridReference{3, 2, 0.2, {-3, 4, 0}}));
    QVERIFY(server_->asked.last().path.endsWith("?resolution=0.2"));
    response.set_status_code(ros_messages::slam::UNAVAILABLE);
    server_->serve("/ros/slam/map_image", QByteArray::fromStdString(response.SerializeAsString()));
    overview = answerTo<map::WholeMap>(ask);
    QVERIFY(!overview.has_value());
    QVERIFY(overview.error().cause.arguments == std::vector<FaultArgument>{"UNAVAILABLE"});
    server_->serve("/ros/slam/map_image", "<html>");
    QVERIFY(!answerTo<map::WholeMap>(ask).has_value());
  }

  void anOverviewThatTheFirmwareDoesNotKnowIsOfferedNoMore() {
    connectRobot();
    QTRY_COMPARE_WITH_TIMEOUT(robot_->connection().phase, ConnectionPhase::Online, kPatienceMs);
    QSignalSpy changed(robot_.get(), &Robot::capabilitiesChanged);
    const auto ask = [&](auto reply) { robot_->overviewSource()->fetchOverview(0.2, reply); };
    server_->answers["/ros/slam/map_image"] = ScriptedRobot::reply(502, "{}");
    QVERIFY(!answerTo<map::WholeMap>(ask).has_value());
    QVERIFY(robot_->overviewSource() && changed.isEmpty());  // it has none now
    server_->answers["/ros/slam/map_image"] = ScriptedRobot::reply(404, "{}");
    QVERIFY(!answerTo<map::WholeMap>(ask).has_value());
    QVERIFY(!robot_->overviewSource());
    QCOMPARE(changed.size(), 1);
    QCOMPARE(robot_->unavailableReason(Capability::Overview),
             (Absence{Absence::Reason::FirmwareLacks, {"404"}}));
    // It may have been given another one when it is back.
    for (QWebSocket* peer : std::as_const(server_->peers)) peer->abort();
    QTRY_VERIFY_WITH_TIMEOUT(robot_->overviewSource() != nullptr, kPatienceMs);
    QCOMPARE(changed.size(), 2);
  }

  void aRobotThatIsGoneAnswersNobody() {
    int answers = 0;
    robot_->mapCatalogue()->list([&](const auto&) { ++answers; });
    robot_.reset();
    QCoreApplication::processEvents();
    QCOMPARE(answers, 0);
  }
};

}  // namespace test_axbot_robot

MAPWRIGHT_TEST(test_axbot_robot, AxbotRobotTest, Core)
#include "test_axbot_robot.moc"
