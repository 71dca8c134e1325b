// Lists of submaps as robots should not send them, and answers that do not fit them: what is shown, what is
// asked for and what is said about it equals what a second reading of the same rules gives.
#include <map>
#include <optional>
#include <random>
#include <set>

#include <QTest>

#include "fake_robot.h"
#include "map/submap_version.h"
#include "robot/axbot/parse_topics.h"
#include "ros_messages/wrapper.pb.h"
#include "session/session_options.h"
#include "session/submaps_complete.h"
#include "submap/faults.h"
#include "submap/submap_store.h"
#include "test_program.h"

namespace test_odd_lists {

using namespace mapwright;
using map::SubmapId;
using Outcome = map::SubmapAnswer::Outcome;

namespace {

constexpr const char* kTopic = "/submap_list";

/// A row as it is sent, and what it means.
struct Row {
  std::string json;
  std::optional<SubmapId> id;  // nullopt: it cannot be told which one it is
  std::optional<int> version;  // nullopt: none, or none that is one
  bool placed = true;
};

struct List {
  std::string text;  // JSON, or a binary frame
  bool binary = false;
  bool readable = true;
  std::string uuid;
  std::vector<Row> rows;
};

/// How the fake robot answers for one submap, and what must be on screen then.
struct Expected {
  std::optional<int> listed;
  std::optional<int> shown;
  bool placed_ever = false, placed_now = false;
  bool missing = false;  // the last answer
};

std::string pick(std::mt19937& random, std::initializer_list<const char*> words) {
  return *(words.begin() + std::ptrdiff_t(random() % words.size()));
}

Row randomRow(std::mt19937& random, SubmapId id, int version) {
  Row row;
  row.id = id;
  row.version = version;
  std::string index = std::to_string(id.index), said = ",\"submap_version\":" + std::to_string(version);
  if (random() % 12 == 0) {
    row.id.reset();
    index = pick(random, {"null", "\"first\"", "99999999999999", "1.5", "[]", "{}"});
  }
  if (random() % 4 == 0) {
    row.version.reset();
    said = pick(random, {"", ",\"submap_version\":null", ",\"submap_version\":-7", ",\"submap_version\":-1",
                         ",\"submap_version\":\"new\"", ",\"submap_version\":2.5",
                         ",\"submap_version\":99999999999", ",\"submap_version\":true"});
  } else if (random() % 6 == 0) {
    said = ",\"submap_version\":\"" + std::to_string(version) + "\"";
  }
  std::string pose = "{\"x\":" + std::to_string(id.index) + ",\"y\":1}";
  if (random() % 12 == 0) {
    row.placed = false;
    pose = pick(random, {"{\"x\":NaN,\"y\":1}", "{\"x\":1e9,\"y\":0}", "null", "{}",
                         "{\"x\":1,\"y\":1,\"qx\":0,\"qy\":0,\"qz\":0,\"qw\":0}"});
  }
  row.json = "{\"trajectory_id\":" + std::to_string(id.trajectory) + ",\"submap_index\":" + index + said +
             ",\"pose\":" + pose + "}";
  if (random() % 25 == 0) {
    row.id.reset();
    row.json = pick(random, {"null", "7", "\"row\"", "[]"});
  }
  return row;
}

/// The same in protobuf, where a version of 0 and one that is left out are the same.
Row randomBinaryRow(std::mt19937& random, SubmapId id, int version, ros_messages::slam::SubmapList& list) {
  Row row{{}, id, version};
  auto& entry = *list.add_submaps();
  entry.set_trajectory_id(id.trajectory);
  entry.set_submap_index(id.index);
  entry.mutable_pose()->set_x(id.index);
  entry.mutable_pose()->set_qw(1);
  if (random() % 4 == 0) {
    row.version.reset();
    if (random() % 2 == 0) entry.set_submap_version(-int(random() % 9));
  } else {
    entry.set_submap_version(version);
  }
  return row;
}

bool anyNamed(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.id.has_value(); });
}

}  // namespace

class OddListsTest : public QObject {
  Q_OBJECT
 private:
  static constexpr int kSubmaps = 6;
  std::mt19937 random_;
  submap::Millis now_{0};
  std::unique_ptr<session::Session> session_;
  test::FakeRobot* robot_ = nullptr;
  std::map<SubmapId, int> versions_;  // of the robot; they only grow
  std::map<SubmapId, Expected> expected_;
  std::set<SubmapId> missing_;  // 404
  std::string uuid_ = "u0";

  List randomList() {
    List list;
    list.uuid = uuid_;
    std::vector<Row> rows;
    list.binary = random_() % 4 == 0;
    ros_messages::RosMessageWrapper wrapper;
    wrapper.set_type(ros_messages::SUBMAP_LIST);
    auto& binary = *wrapper.mutable_submap_list();
    for (int i = 0; i < kSubmaps; ++i) {
      if (random_() % 4 == 0) continue;
      const SubmapId id{1, i};
      int& version = versions_.try_emplace(id, 1).first->second;
      version += int(random_() % 3) * 2;
      rows.push_back(list.binary ? randomBinaryRow(random_, id, version, binary)
                                 : randomRow(random_, id, version));
    }
    const int without = int(random_() % 10);
    if (without == 0) list.uuid.clear();
    if (list.binary) {
      binary.set_uuid(list.uuid);
      list.text = std::string(1, char(12)) + kTopic + std::string(1, '\0') + wrapper.SerializeAsString();
    } else {
      std::string joined;
      for (const Row& row : rows) joined += (joined.empty() ? "" : ",") + row.json;
      std::string member = ",\"" + pick(random_, {"submap", "submaps"}) + "\":[" + joined + "]";
      if (random_() % 8 == 0) {
        list.readable = false;
        member = pick(random_, {"", ",\"submap\":null", ",\"submaps\":null", ",\"submap\":{\"a\":1}",
                                ",\"submap\":\"none\"", ",\"submaps\":0", ",\"submap\":true"});
      }
      const std::string uuid = without == 0 ? pick(random_, {"", ",\"uuid\":null", ",\"uuid\":\"\""})
                                            : ",\"uuid\":\"" + list.uuid + "\"";
      list.text = std::string("{\"topic\":\"") + kTopic + "\"" + uuid + member + "}";
    }
    // Rows that nobody can load, or tell apart, are no list.
    if (!rows.empty() && (!anyNamed(rows) || list.uuid.empty())) list.readable = false;
    list.rows = std::move(rows);
    return list;
  }

  void say(const List& list) {
    const auto message = list.binary ? robot::axbot::parseBinaryFrame(list.text)
                                     : robot::axbot::parseTextFrame(list.text).message;
    QVERIFY2(message, list.text.c_str());
    if (list.readable)
      Q_EMIT robot_->recovered({map::Subject(map::SubjectKind::Topic, kTopic), map::ProblemCode::Unreadable});
    robot_->say(*message, kTopic);
  }

  /// What the rules say of it, read a second time.
  void expect(const List& list) {
    if (!list.readable) return;
    if (list.uuid != shown_uuid_) expected_.clear();
    shown_uuid_ = list.uuid;
    std::map<SubmapId, Expected> now;
    for (const Row& row : list.rows) {
      if (!row.id) continue;
      Expected& one = now[*row.id];
      if (const auto before = expected_.find(*row.id); before != expected_.end()) one = before->second;
      one.listed = row.version;
      one.placed_now = row.placed;
      one.placed_ever |= row.placed;
    }
    expected_ = std::move(now);
  }

  /// Answers everything that is asked for until nothing is; the robot has `bodies`.
  void answerAll(const std::map<SubmapId, int>& bodies) {
    for (int turn = 0; turn < 400; ++turn) {
      if (!robot_->open.empty()) {
        const map::SubmapKey key = robot_->open.front().first;
        const auto found = expected_.find(key.id);
        QVERIFY(found != expected_.end() && key.uuid == shown_uuid_);
        Expected& one = found->second;
        QVERIFY2(one.placed_ever, "what has no place is not asked for");
        QCOMPARE(key.version, one.listed.value_or(map::kNoVersion));
        QVERIFY2(!one.listed || !one.shown || *one.listed > *one.shown, "it is there already");
        if (missing_.contains(key.id)) {
          one.missing = true;
          robot_->answer(Outcome::NotFound);
          continue;
        }
        one.missing = false;
        const int body = bodies.at(key.id);
        one.shown = one.listed ? std::max(one.shown.value_or(0), body) : body;
        robot_->answer(Outcome::Ok, body);
        continue;
      }
      QCoreApplication::processEvents();
      if (!robot_->open.empty()) continue;
      const auto done = [&] { return !session_->submaps().listReceived() || session_->settled(1); };
      if (done()) return;
      QVERIFY(QTest::qWaitFor([&] { return done() || !robot_->open.empty(); }));
    }
    QFAIL("it never ends");
  }

  bool complete() const { return session::submapsComplete(session_->counts(), session_->problems()); }

  void compare(const List& last) {
    const auto& rows = session_->submaps().rows();
    QCOMPARE(rows.size(), expected_.size());
    bool up_to_date = true;
    for (const auto& [id, one] : expected_) {
      const auto row = rows.find(id);
      QVERIFY(row != rows.end());
      QCOMPARE(row->second.shown_version, one.shown.value_or(-1));
      QVERIFY2(!row->second.stale_texture, "no version went back");
      const bool held = one.placed_ever && one.shown;
      up_to_date &= held && !one.missing && one.placed_now && (!one.listed || *one.shown >= *one.listed);
    }
    const auto rejected =
        std::count_if(last.rows.begin(), last.rows.end(), [](const Row& row) { return !row.id.has_value(); });
    const bool expected = last.readable && rejected == 0 && up_to_date;
    QCOMPARE(complete(), expected);
    QCOMPARE(session::listUnreadable(session_->problems()), !last.readable);
    if (expected) return;
    const auto& problems = session_->problems().rows();
    QVERIFY2(std::any_of(problems.begin(), problems.end(),
                         [](const session::LoggedProblem& row) {
                           return !row.resolved && row.problem.severity >= map::Severity::Warning;
                         }),
             "something is missing, and nobody says so");
  }

  std::string shown_uuid_ = "-";

 private Q_SLOTS:
  void whatIsShownAndSaidEqualsASecondReading_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 60; ++seed) QTest::addRow("%d", seed) << seed;
  }
  void whatIsShownAndSaidEqualsASecondReading() {
    QFETCH(int, seed);
    random_.seed(unsigned(seed));
    now_ = submap::Millis(0);
    expected_.clear();
    versions_.clear();
    shown_uuid_ = "-";
    auto robot = std::make_unique<test::FakeRobot>();
    robot_ = robot.get();
    session::Session::Options options;
    options.scheduler.min_interval = submap::Millis(0);
    options.overview = options.maps = false;
    session_ =
        std::make_unique<session::Session>(std::move(robot), options, nullptr, [this] { return now_; });
    robot_->setPhase(robot::ConnectionPhase::Online);
    bool any_readable = false;
    for (int round = 0; round < 12; ++round) {
      now_ += submap::Millis(120'000);  // every wait is over
      if (random_() % 6 == 0) {
        uuid_ = "u" + std::to_string(random_());
        versions_.clear();
      }
      const List list = randomList();
      // Older, newer or what is listed.
      std::map<SubmapId, int> bodies;
      missing_.clear();
      for (auto& [id, version] : versions_) {
        const int kind = int(random_() % 8);
        bodies[id] = std::max(1, kind == 0 ? version - 3 : kind == 1 ? version + 1 : version);
        if (kind == 1) ++version;
        if (kind == 2) missing_.insert(id);
      }
      expect(list);
      any_readable |= list.readable;
      say(list);
      answerAll(bodies);
      if (QTest::currentTestFailed()) {
        qWarning("round %d: %s", round, list.binary ? "binary" : list.text.c_str());
        return;
      }
      if (any_readable) compare(list);
      if (QTest::currentTestFailed()) {
        qWarning("round %d: %s", round, list.binary ? "binary" : list.text.c_str());
        return;
      }
      // A 404 of a version is remembered: the next one is asked for.
      for (const SubmapId id : missing_) versions_[id] += 1;
    }
    session_.reset();
  }

  void onlyAListThatIsReadEmptiesTheMap_data() {
    QTest::addColumn<QByteArray>("list");
    QTest::addColumn<bool>("empties");
    QTest::newRow("no list") << QByteArray(R"({"topic":"/submap_list","uuid":"u"})") << false;
    QTest::newRow("null") << QByteArray(R"({"topic":"/submap_list","uuid":"u","submap":null})") << false;
    QTest::newRow("no uuid")
        << QByteArray(R"({"topic":"/submap_list","submap":[{"trajectory_id":0,"submap_index":0}]})") << false;
    QTest::newRow("no row") << QByteArray(R"({"topic":"/submap_list","uuid":"u","submap":[null,7]})")
                            << false;
    QTest::newRow("empty") << QByteArray(R"({"topic":"/submap_list","uuid":"u","submap":[]})") << true;
    QTest::newRow("no session") << QByteArray(R"({"topic":"/submap_list","uuid":"","submap":[]})") << true;
  }
  void onlyAListThatIsReadEmptiesTheMap() {
    QFETCH(QByteArray, list);
    QFETCH(bool, empties);
    auto robot = std::make_unique<test::FakeRobot>();
    robot_ = robot.get();
    session_ = std::make_unique<session::Session>(std::move(robot), session::Session::Options{});
    robot_->setPhase(robot::ConnectionPhase::Online);
    robot_->say(*robot::axbot::parseTextFrame(
                     R"({"topic":"/submap_list","uuid":"u","submap":[{"trajectory_id":0,"submap_index":0,)"
                     R"("submap_version":1,"pose":{"x":0,"y":0}}]})")
                     .message,
                kTopic);
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 1);
    QVERIFY(complete());
    robot_->say(*robot::axbot::parseTextFrame(list.toStdString()).message, kTopic);
    QCOMPARE(session_->counts().shown, empties ? 0 : 1);
    QCOMPARE(complete(), empties);
    session_.reset();
  }

  void anOlderBodyIsShownAndStaysDue() {
    auto robot = std::make_unique<test::FakeRobot>();
    robot_ = robot.get();
    now_ = submap::Millis(0);
    session_ = std::make_unique<session::Session>(std::move(robot), session::Session::Options{}, nullptr,
                                                  [this] { return now_; });
    robot_->setPhase(robot::ConnectionPhase::Online);
    const auto list =
        *robot::axbot::parseTextFrame(
             R"({"topic":"/submap_list","uuid":"u","submap":[{"trajectory_id":0,"submap_index":0,)"
             R"("submap_version":42,"pose":{"x":0,"y":0}}]})")
             .message;
    robot_->say(list, kTopic);
    robot_->answer(Outcome::Ok, 37);
    QTRY_COMPARE(session_->counts().shown, 1);
    QVERIFY(!complete());
    QCOMPARE(session_->status({0, 0}), session::SubmapStatus::Waiting);
    QVERIFY(session_->reason({0, 0}).any());
    now_ += submap::Millis(2'000);
    robot_->say(list, kTopic);
    QVERIFY2(robot_->open.empty(), "it waits, as after a failure");
    now_ += submap::Millis(2'000);
    robot_->say(list, kTopic);
    QCOMPARE(robot_->open.size(), std::size_t(1));
    robot_->answer(Outcome::Ok, 42);
    QTRY_VERIFY(complete());
    QVERIFY(!session_->reason({0, 0}).any());
    session_.reset();
  }

  void withoutAVersionItIsAskedForNowAndThen() {
    auto robot = std::make_unique<test::FakeRobot>();
    robot_ = robot.get();
    now_ = submap::Millis(0);
    session_ = std::make_unique<session::Session>(std::move(robot), session::Session::Options{}, nullptr,
                                                  [this] { return now_; });
    robot_->setPhase(robot::ConnectionPhase::Online);
    const auto list =
        *robot::axbot::parseTextFrame(
             R"({"topic":"/submap_list","uuid":"u","submap":[{"trajectory_id":0,"submap_index":0,)"
             R"("pose":{"x":0,"y":0}}]})")
             .message;
    int asked = 0;
    for (int second = 0; second < 600; ++second) {
      robot_->say(list, kTopic);
      while (!robot_->open.empty()) {
        QCOMPARE(robot_->open.front().first.version, map::kNoVersion);
        robot_->answer(Outcome::Ok, 5);
        ++asked;
      }
      now_ += submap::Millis(1'000);
    }
    QTRY_VERIFY(complete());
    QVERIFY2(asked > 10 && asked < 25, qPrintable(QString::number(asked)));
    session_.reset();
  }
};

}  // namespace test_odd_lists

MAPWRIGHT_TEST(test_odd_lists, OddListsTest, Core)
#include "test_odd_lists.moc"
