// What an Autoxing robot sees around it and has collected: as answers, and asked of the simulator.
#include <QTest>

#include "robot/axbot/axbot_robot.h"
#include "robot/axbot/sighting_requests.h"
#include "sentences/failure_sentence.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_axbot_sightings {

using namespace mapwright;
using namespace mapwright::robot;

namespace {

struct Bench {
  explicit Bench(bool sees_nothing = false) : sim(options(sees_nothing)) {
    if (sim.start()) qFatal("no simulator");
    axbot::LinkOptions link;
    link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(sim.port()));
    robot = std::make_unique<axbot::AxbotRobot>(QStringLiteral("axbot"), link);
  }
  static simulator::Options options(bool sees_nothing) {
    simulator::Options options;
    options.paused = true;
    options.faults.sees_nothing = sees_nothing;
    return options;
  }
  SightingSource& source() { return *robot->overlayStore()->sightings(); }
  Outcome<Sighting> look(Sight what, SightEdge edge = SightEdge::AsTheRobotHasIt) {
    std::optional<Outcome<Sighting>> outcome;
    source().look(what, edge, [&](Outcome<Sighting> given) { outcome = std::move(given); });
    if (!QTest::qWaitFor([&] { return outcome.has_value(); }, 60'000)) qFatal("no outcome");
    return std::move(*outcome);
  }
  Outcome<CollectedLandmarks> collected() {
    std::optional<Outcome<CollectedLandmarks>> outcome;
    source().collectedLandmarks([&](Outcome<CollectedLandmarks> given) { outcome = std::move(given); });
    if (!QTest::qWaitFor([&] { return outcome.has_value(); }, 60'000)) qFatal("no outcome");
    return std::move(*outcome);
  }

  simulator::Simulator sim;
  std::unique_ptr<axbot::AxbotRobot> robot;
};

}  // namespace

class AxbotSightingsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anAnswerIsRead() {
    const auto seen = axbot::parseSighting(
        R"({"pose":{"pos":[4.179,-26.094],"ori":3.18},"ref":"center_of_front_edge"})", Sight::Pallet);
    QVERIFY(seen);
    QCOMPARE(seen->pose.x_m, 4.179);
    QCOMPARE(seen->pose.yaw_rad, 3.18);
    QCOMPARE(seen->reference, std::string("center_of_front_edge"));
    QVERIFY(axbot::parseSighting(R"({"pose":{"pos":[1,2],"ori":0}})", Sight::Charger)->reference.empty());
    for (const char* text : {"", "7", "[]", R"({"pose":{"pos":[1]}})", R"({"pose":{"pos":[NaN,1],"ori":0}})"})
      QVERIFY2(!axbot::parseSighting(std::string_view(text), Sight::Charger), text);
  }

  void filesAreAskedForOldestFirst() {
    const auto names = axbot::parseCollectedNames(
        R"([{"filename":"b","modified_time":"2"},{"filename":"a","modified_time":"1"},{"size":"3"}])");
    QVERIFY(names);
    QCOMPARE(names->newest, (std::vector<std::string>{"a", "b"}));
    QCOMPARE(names->older, std::size_t(0));
    QVERIFY(!axbot::parseCollectedNames("{}"));
    std::string many;
    for (int i = 10; i < 70; ++i)
      many += (i == 10 ? "{\"filename\":\"f" : ",{\"filename\":\"f") + std::to_string(i) +
              "\",\"modified_time\":\"" + std::to_string(i) + "\"}";
    const auto newest = axbot::parseCollectedNames('[' + many + ']');
    QVERIFY(newest);
    QCOMPARE(newest->newest.size(), std::size_t(50));
    QCOMPARE(newest->newest.front(), std::string("f20"));
    QCOMPARE(newest->older, std::size_t(10));
  }

  void everyKindIsSeen() {
    Bench bench;
    const auto charger = bench.look(Sight::Charger);
    for (const Sight what : {Sight::Charger, Sight::Rack, Sight::Pallet, Sight::Trailer}) {
      const auto seen = bench.look(what);
      QVERIFY(seen);
      QVERIFY(std::hypot(seen->pose.x_m - charger->pose.x_m, seen->pose.y_m - charger->pose.y_m) < 1.5);
      QCOMPARE(seen->reference, what == Sight::Charger ? std::string() : std::string("center_of_front_edge"));
    }
    const auto rear = bench.look(Sight::Rack, SightEdge::Rear);
    QVERIFY(rear);
    QCOMPARE(rear->reference, std::string("center_of_rear_edge"));
  }

  void thatItSeesNoneIsToldInASentence() {
    Bench bench(true);
    const auto charger = bench.look(Sight::Charger), rack = bench.look(Sight::Rack),
               pallet = bench.look(Sight::Pallet);
    QVERIFY(!charger && !rack && !pallet);
    QCOMPARE(sentences::failureReason(charger.error()), std::string("The robot sees no charger here."));
    QCOMPARE(sentences::failureReason(rack.error()), std::string("The robot sees no rack here."));
    QVERIFY(sentences::failureReason(pallet.error()).find("Nothing was detected") != std::string::npos);
    QVERIFY(bench.collected() && bench.collected()->landmarks.empty());
  }

  void collectedLandmarksAreRead() {
    Bench bench;
    const auto found = bench.collected();
    QVERIFY(found);
    QCOMPARE(found->landmarks.size(), std::size_t(6));
    QCOMPARE(found->files, std::size_t(1));
    QCOMPARE(found->landmarks.front().id, std::string("landmark_1"));
  }
};

}  // namespace test_axbot_sightings

MAPWRIGHT_TEST(test_axbot_sightings, AxbotSightingsTest, Core)
#include "test_axbot_sightings.moc"
