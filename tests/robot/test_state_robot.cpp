// A state file as a robot: what it sends, what can be fetched, and that it follows its file.
#include <QSignalSpy>
#include <QTest>

#include "../pbstream/state_bytes.h"
#include "robot/pbstream/state_robot.h"
#include "test_program.h"

namespace test_state_robot {

using namespace mapwright;
using namespace mapwright::robot;
namespace state = mapwright::pbstream::tests;

namespace {

constexpr int kWaitMs = 20'000;

/// A robot over a file, and what it has sent.
struct Opened {
  explicit Opened(const QString& path) {
    robot::pbstream::StateOptions options;
    options.path = path;
    options.settle = std::chrono::milliseconds(1);
    robot = std::make_unique<robot::pbstream::StateRobot>(QStringLiteral("file:") + path, options);
    QObject::connect(robot.get(), &Robot::topicReceived, robot.get(),
                     [this](const map::StampedMessage& message) {
                       if (const auto* const list = std::get_if<map::SubmapList>(&message.message))
                         lists.push_back(*list);
                       if (const auto* const line = std::get_if<map::TrajectoryMessage>(&message.message))
                         trajectory = *line;
                       if (const auto* const drawn = std::get_if<map::ConstraintsMessage>(&message.message))
                         constraints = *drawn;
                     });
    QObject::connect(robot.get(), &Robot::problemFound, robot.get(),
                     [this](const map::Problem& problem) { problems.push_back(problem); });
    robot->connectToRobot();
  }

  std::vector<map::SubmapList> lists;
  map::TrajectoryMessage trajectory;
  map::ConstraintsMessage constraints;
  std::vector<map::Problem> problems;
  std::unique_ptr<robot::pbstream::StateRobot> robot;
};

}  // namespace

class StateRobotTest : public QObject {
  Q_OBJECT
  state::Folder folder_;

  /// As a whole, as programs replace files.
  void replace(const std::string& bytes) const {
    const QString part = QString::fromStdString(folder_.write(bytes, "part")),
                  path = QString::fromStdString(folder_.path("map.pbstream"));
    QCOMPARE(::rename(part.toStdString().c_str(), path.toStdString().c_str()), 0);
  }
  QString write(const std::string& bytes) const { return QString::fromStdString(folder_.write(bytes)); }

  map::SubmapAnswer fetch(Opened& opened, const map::SubmapKey& key) const {
    std::optional<map::SubmapAnswer> answer;
    opened.robot->submapSource()->fetch(key, [&](map::SubmapAnswer given) { answer = std::move(given); });
    (void)QTest::qWaitFor([&] { return answer.has_value(); }, kWaitMs);
    return answer.value_or(map::SubmapAnswer());
  }

 private Q_SLOTS:
  void lossesOfOneKindAreAllNamed() {
    Opened opened(write(state::wholeFile() + state::sized("hello", 5) + state::sized("hullo", 5)));
    QTRY_VERIFY(!opened.problems.empty());
    QCOMPARE(opened.problems.size(), std::size_t(1));
    const std::string said = inEnglish(opened.problems.front().reason);
    QVERIFY2(said.find("2 losses") != std::string::npos && said.find("Record 17") != std::string::npos &&
                 said.find("Record 18") != std::string::npos,
             said.c_str());
  }

  void itSendsWhatItHolds() {
    Opened opened(write(state::wholeFile()));
    QTRY_VERIFY_WITH_TIMEOUT(!opened.constraints.by_name.empty(), kWaitMs);
    QCOMPARE(opened.robot->connection().phase, ConnectionPhase::Online);
    QCOMPARE(opened.lists.size(), std::size_t(1));
    const map::SubmapList& list = opened.lists.front();
    QCOMPARE(list.entries.size(), std::size_t(3));
    QVERIFY(list.entries[1].id == (map::SubmapId{0, 1}) && list.entries[1].version == 40 &&
            list.entries[1].pose.x == 2);
    // Four nodes, a break, two nodes.
    QCOMPARE(opened.trajectory.points.size(), std::size_t(7));
    QVERIFY(!opened.trajectory.points[4].allFinite());
    QCOMPARE(opened.constraints.by_name["Intra constraints"].size(), std::size_t(6));
    QCOMPARE(opened.constraints.by_name["Inter residuals, same trajectory"].size(), std::size_t(1));
    QCOMPARE(opened.constraints.by_name["Inter residuals, different trajectories"].size(), std::size_t(1));
    const auto& [expected, lies] = opened.constraints.by_name["Inter residuals, same trajectory"].front();
    QCOMPARE(expected, Eigen::Vector2d(5, 0));
    QCOMPARE(lies, Eigen::Vector2d(3, 0));
    QVERIFY(opened.problems.empty());
  }

  void submapsAreFetchedByTheirKeys() {
    Opened opened(write(state::wholeFile()));
    QTRY_VERIFY_WITH_TIMEOUT(!opened.lists.empty(), kWaitMs);
    const std::string uuid = opened.lists.front().uuid;
    const map::SubmapAnswer answer = fetch(opened, {uuid, {0, 1}, 40});
    QCOMPARE(answer.outcome, map::SubmapAnswer::Outcome::Ok);
    QCOMPARE(answer.version, 40);
    QCOMPARE(answer.slices.size(), std::size_t(1));
    QCOMPARE(fetch(opened, {uuid, {5, 5}, 40}).outcome, map::SubmapAnswer::Outcome::NotFound);
    QCOMPARE(fetch(opened, {"another", {0, 1}, 40}).outcome, map::SubmapAnswer::Outcome::WrongUuid);
  }

  void aFileThatIsReplacedIsReadAgain() {
    Opened opened(write(state::wholeFile()));
    QTRY_VERIFY_WITH_TIMEOUT(!opened.lists.empty(), kWaitMs);
    QSignalSpy changed(opened.robot.get(), &Robot::mapsChanged);
    replace(state::header() + state::record(state::graphRecord()) + state::record(state::submapRecord(1, 0)));
    QTRY_VERIFY_WITH_TIMEOUT(changed.size() == 1, kWaitMs);
    QVERIFY(opened.lists.back().uuid != opened.lists.front().uuid);
    QCOMPARE(opened.lists.back().entries.size(), std::size_t(1));
    QVERIFY(!opened.problems.empty());  // two submaps are missing
    QCOMPARE(fetch(opened, {opened.lists.back().uuid, {1, 0}, 40}).outcome, map::SubmapAnswer::Outcome::Ok);
  }

  void aFileThatBecomesOneIsOpened() {
    Opened opened(write("hello"));
    QTRY_COMPARE_WITH_TIMEOUT(opened.robot->connection().phase, ConnectionPhase::Refused, kWaitMs);
    replace(state::wholeFile());
    QTRY_COMPARE_WITH_TIMEOUT(opened.robot->connection().phase, ConnectionPhase::Online, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!opened.lists.empty(), kWaitMs);
  }

  void aDamagedSubmapIsMissingAndTheOthersAreThere() {
    auto broken = state::submapRecord(0, 1);
    broken.mutable_submap()->mutable_submap_2d()->mutable_grid()->mutable_known_cells_box()->set_max_x(99);
    Opened opened(write(state::header() + state::record(state::graphRecord()) +
                        state::record(state::submapRecord(0, 0)) + state::record(broken) +
                        state::record(state::submapRecord(1, 0))));
    QTRY_VERIFY_WITH_TIMEOUT(!opened.lists.empty(), kWaitMs);
    const std::string uuid = opened.lists.front().uuid;
    QCOMPARE(fetch(opened, {uuid, {0, 1}, 40}).outcome, map::SubmapAnswer::Outcome::NotFound);
    QCOMPARE(fetch(opened, {uuid, {0, 0}, 40}).outcome, map::SubmapAnswer::Outcome::Ok);
  }

  void itEndsWhileMuchIsAsked() {
    Opened opened(write(state::wholeFile()));
    QTRY_VERIFY_WITH_TIMEOUT(!opened.lists.empty(), kWaitMs);
    int replies = 0;
    for (int i = 0; i < 500; ++i)
      opened.robot->submapSource()->fetch({opened.lists.front().uuid, {0, i % 2}, 40},
                                          [&](const auto&) { ++replies; });
    opened.robot->submapSource()->cancelAll();
    opened.robot.reset();
    QVERIFY(replies <= 500);
  }
};

}  // namespace test_state_robot

MAPWRIGHT_TEST(test_state_robot, StateRobotTest, Core)
#include "test_state_robot.moc"
