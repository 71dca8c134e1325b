// An Agibot robot with newer firmware, over the simulator: what only third parties tell of its interface.
#include <QTest>

#include "robot/aimdk/aimdk_robot.h"
#include "robot/aimdk/faults.h"
#include "robot/wire/faults.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_aimdk_newer {

using namespace mapwright;
using namespace mapwright::robot;
using aimdk::AimdkRobot;
using map::Applied;
using map::FailureKind;
using std::chrono::milliseconds;

namespace {

constexpr int kPatienceMs = 20'000;
const map::MapKey kPark{map::MapKind::Stored, "1764059676131"};  // in use
const map::MapKey kRiver{map::MapKind::Stored, "1764137567113"};

template <typename T, typename Ask>
Outcome<T> answerTo(Ask ask) {
  std::optional<Outcome<T>> answer;
  ask([&](Outcome<T> given) { answer = std::move(given); });
  if (!QTest::qWaitFor([&] { return answer.has_value(); }, kPatienceMs))
    return tl::make_unexpected(map::Failure{.subject = "test", .detail = "no answer"});
  return *answer;
}

template <typename T>
QByteArray why(const Outcome<T>& outcome) {
  return outcome ? QByteArray() : QByteArray::fromStdString(sentences::sentenceOf(outcome.error()));
}

}  // namespace

class AimdkNewerTest : public QObject {
  Q_OBJECT
  std::unique_ptr<simulator::Simulator> simulator_;
  std::unique_ptr<AimdkRobot> robot_;

  void make(simulator::Options options) {
    robot_.reset();
    options.paused = true;
    simulator_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!simulator_->start());
    aimdk::LinkOptions link;
    link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(simulator_->aimdkPort()));
    link.changes = {milliseconds(200), milliseconds(20)};
    robot_ = std::make_unique<AimdkRobot>(QStringLiteral("aimdk+test"), std::move(link));
    robot_->connectToRobot();
    QTRY_COMPARE_WITH_TIMEOUT(robot_->connection().phase, ConnectionPhase::Online, kPatienceMs);
  }
  void makeNewer(const simulator::Faults& faults = {}, bool centimetres = false) {
    simulator::Options options;
    options.aimdk = {true, centimetres};
    options.faults = faults;
    make(options);
  }
  Outcome<map::CatalogueEntry> carryOut(const MapOrder& order) {
    return answerTo<map::CatalogueEntry>(
        [&](auto reply) { robot_->mapAdministration()->carryOut(order, reply); });
  }
  std::vector<map::CatalogueEntry> maps() {
    return answerTo<std::vector<map::CatalogueEntry>>(
               [&](auto reply) { robot_->mapCatalogue()->list(reply); })
        .value_or(std::vector<map::CatalogueEntry>());
  }
  StoredWaypoints points(const map::MapKey& key) {
    return answerTo<StoredWaypoints>([&](auto reply) { robot_->waypointStore()->read(key, reply); })
        .value_or(StoredWaypoints());
  }
  Outcome<WaypointReceipt> change(const map::MapKey& key, const WaypointChange& what) {
    WaypointStore& store = *robot_->waypointStore();
    const auto requests = store.plan({}, {what});
    return answerTo<WaypointReceipt>([&](auto reply) { store.perform(key, requests.front(), reply); });
  }
  int writes() const {
    int count = 0;
    for (const auto& one : simulator_->requestLog()) {
      const bool reads = one.target.find("/Get") != std::string::npos;
      count += reads ? 0 : 1;
    }
    return count;
  }
  static map::Waypoint newPoint(double x_m, double y_m, double yaw_rad) {
    map::Waypoint point;
    point.id = "ours";
    point.name = "Neu \"1\"";
    point.type = aimdk::kUsualPointType;
    point.position_m = {x_m, y_m};
    point.yaw_rad = yaw_rad;
    return point;
  }

 private Q_SLOTS:
  void cleanup() {
    robot_.reset();
    simulator_.reset();
  }

  void olderFirmwareIsReadOnlyAsEver() {
    make({});
    QVERIFY(!robot_->mapAdministration() && !robot_->waypointStore());
    QVERIFY(sentences::limitsOf(*robot_).startsWith(QLatin1String("Read only: Agibot's interface")));
    QVERIFY(sentences::unconfirmedOf(*robot_, Capability::Administration).isEmpty());
    QCOMPARE(writes(), 0);
  }

  void newerFirmwareIsOfferedAsUnconfirmed() {
    makeNewer();
    QVERIFY(robot_->mapAdministration() && robot_->waypointStore());
    QVERIFY(!sentences::limitsOf(*robot_).contains(QLatin1String("Read only")));
    QVERIFY(sentences::limitsOf(*robot_).contains(QLatin1String("not confirmed")));
    for (const Capability one : {Capability::Administration, Capability::WaypointEditing})
      QVERIFY(sentences::unconfirmedOf(*robot_, one).startsWith(QLatin1String("This is not confirmed")));
    QCOMPARE(writes(), 0);  // asking changes nothing
  }

  void mapsAreRenamedLoadedAndDeleted() {
    makeNewer();
    const auto renamed = carryOut({MapChange::Rename, kRiver, "Halle \"2\" 🏭"});
    QVERIFY2(renamed, why(renamed));
    QCOMPARE(renamed->name, std::string("Halle \"2\" 🏭"));
    const auto loaded = carryOut({MapChange::Load, kRiver});
    QVERIFY2(loaded && loaded->is_current, why(loaded));
    const auto deleted = carryOut({MapChange::Delete, kPark});
    QVERIFY2(deleted && deleted->name == "Park", why(deleted));
    QCOMPARE(maps().size(), std::size_t(2));
    const auto used = carryOut({MapChange::Delete, kRiver});
    QVERIFY(!used && used.error().kind == FailureKind::RejectedByRobot &&
            used.error().applied == Applied::No);
    QCOMPARE(used.error().robot_code, std::string("1006"));
    QCOMPARE(writes(), 4);
    const auto archived = carryOut({MapChange::Archive, kRiver});
    QVERIFY(!archived && archived.error().kind == FailureKind::Unsupported);
    const auto nowhere = carryOut({MapChange::Rename, {map::MapKind::Stored, "17"}, "x"});
    QVERIFY(!nowhere && nowhere.error().reason == map::FailureReason::NotThere);
    QCOMPARE(writes(), 4);
  }

  void aMappingEndsBySavingOrDiscardingIt() {
    makeNewer();
    const MapAdministration& admin = *robot_->mapAdministration();
    QVERIFY(!admin.obstacle(MapChange::StartMapping, nullptr));
    QVERIFY(admin.obstacle(MapChange::Save, nullptr) == Obstacle::NotMapping);
    const auto none = carryOut({MapChange::Save, {}, "Yard"});
    QVERIFY(!none && none.error().cause.code == robot::aimdk::fault::MapsNotNow);
    const auto started = carryOut({MapChange::StartMapping});
    QVERIFY2(started && started->key == kPark, why(started));
    QVERIFY(admin.obstacle(MapChange::StartMapping, nullptr) == Obstacle::WhileMapping);
    QVERIFY(!carryOut({MapChange::StartMapping}));
    // Merely stopping it would lose what was mapped.
    QVERIFY(admin.obstacle(MapChange::StopMapping, nullptr) == Obstacle::EndsBySaving);
    QVERIFY(!carryOut({MapChange::StopMapping}));
    const auto saved = carryOut({MapChange::Save, {}, "Yard"});
    QVERIFY2(saved && saved->name == "Yard", why(saved));
    QCOMPARE(maps().size(), std::size_t(4));
    QVERIFY(admin.obstacle(MapChange::Save, nullptr) == Obstacle::NotMapping);
    QVERIFY(carryOut({MapChange::StartMapping}));
    const auto discarded = carryOut({MapChange::CancelMapping});
    QVERIFY2(discarded, why(discarded));
    QCOMPARE(maps().size(), std::size_t(4));
  }

  void whatTheRobotAcceptsAndDoesNotDoIsAFailure() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Ignore, simulator::kWrites});
    makeNewer(faults);
    const auto renamed = carryOut({MapChange::Rename, kRiver, "Lobby"});
    QVERIFY(renamed && renamed->name == "River Park");  // the caller compares
    const auto cause = [](const auto& outcome) { return outcome ? FaultCode() : outcome.error().cause.code; };
    QVERIFY(cause(carryOut({MapChange::Delete, kRiver})) == wire::fault::StillListed);
    QVERIFY(cause(carryOut({MapChange::StartMapping})) == wire::fault::NotMapping);
    QVERIFY(cause(change(kPark, {"ours", std::nullopt, newPoint(1, 2, 0)})) ==
            robot::aimdk::fault::PointNotListed);
    const map::Waypoint first = points(kPark).points.front();
    map::Waypoint moved = first;
    moved.position_m.x() += 1;
    QVERIFY(cause(change(kPark, {first.id, first, moved})) == robot::aimdk::fault::PointElsewhere);
    map::Waypoint named = first;
    named.name = "Dock";
    QVERIFY(cause(change(kPark, {first.id, first, named})) == robot::aimdk::fault::PointOtherwise);
  }

  void anAnswerThatIsLostIsLookedFor() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    makeNewer(faults);
    const auto renamed = carryOut({MapChange::Rename, kRiver, "Lobby"});
    QVERIFY2(renamed && renamed->name == "Lobby", why(renamed));
    const auto made = change(kPark, {"ours", std::nullopt, newPoint(1, 2, 0)});
    QVERIFY2(made, why(made));
    QCOMPARE(made->ids.at("ours"), std::string("10"));
    QCOMPARE(writes(), 2);  // nothing is sent twice
    faults = {};
    faults.requests.push_back({simulator::FaultKind::Drop, simulator::kWrites});
    simulator_->setFaults(faults);
    const auto lost = carryOut({MapChange::Rename, kRiver, "Hall"});
    QVERIFY(!lost && lost.error().applied == Applied::Maybe && lost.error().kind == FailureKind::Unreachable);
  }

  void waypointsAreCreatedMovedAndRenamed_data() {
    QTest::addColumn<bool>("centimetres");
    QTest::newRow("pixels per metre") << false;
    QTest::newRow("centimetres per pixel") << true;
  }
  void waypointsAreCreatedMovedAndRenamed() {
    QFETCH(bool, centimetres);
    makeNewer({}, centimetres);
    const double turn = geometry::radiansFromDegrees(30);
    const auto made = change(kPark, {"ours", std::nullopt, newPoint(1.513, -2.04, turn)});
    QVERIFY2(made, why(made));
    const std::string id = made->ids.at("ours");
    const auto stored = [&] {
      for (const map::Waypoint& point : points(kPark).points)
        if (point.id == id) return point;
      return map::Waypoint();
    };
    map::Waypoint now = stored();
    QCOMPARE(now.name, std::string("Neu \"1\""));
    QVERIFY((now.position_m - Eigen::Vector2d(1.513, -2.04)).cwiseAbs().maxCoeff() <= 0.03);
    QVERIFY(map::sameHeading(*now.yaw_rad, turn));  // not mirrored
    QCOMPARE(robot_->waypointStore()->keeps().pixel_m, 0.05);
    map::Waypoint moved = now;
    moved.position_m = {3, 1};
    const auto went = change(kPark, {id, now, moved});
    QVERIFY2(went, why(went));
    // However little it is.
    map::Waypoint turned = now = stored();
    turned.yaw_rad = turn + geometry::radiansFromDegrees(0.7);
    const auto round = change(kPark, {id, now, turned});
    QVERIFY2(round, why(round));
    QVERIFY(map::sameHeading(*stored().yaw_rad, *turned.yaw_rad));
    turned = now = stored();
    turned.yaw_rad = turn;
    QVERIFY(change(kPark, {id, now, turned}));
    map::Waypoint named = now = stored();
    QVERIFY((now.position_m - Eigen::Vector2d(3, 1)).cwiseAbs().maxCoeff() <= 0.03);
    QVERIFY(map::sameHeading(*now.yaw_rad, turn));
    named.name = "Tür";
    const auto called = change(kPark, {id, now, named});
    QVERIFY2(called, why(called));
    QCOMPARE(stored().name, std::string("Tür"));
    QCOMPARE(points(kPark).points.size(), std::size_t(10));
  }

  void whatCannotBeDoneIsNotSent() {
    makeNewer();
    const map::Waypoint first = points(kPark).points.front();
    const auto deleted = change(kPark, {first.id, first, std::nullopt});
    QVERIFY(!deleted && deleted.error().cause.code == robot::aimdk::fault::PointsStay);
    map::Waypoint tagged = first;
    tagged.tags = {"a"};
    const auto tags = change(kPark, {first.id, first, tagged});
    QVERIFY(!tags && tags.error().cause.code == robot::aimdk::fault::PointsWithoutTags);
    map::Waypoint other = first, mine = first;
    other.name = "Somebody was faster";
    mine.name = "Mine";
    const auto late = change(kPark, {first.id, other, mine});
    QVERIFY(!late && late.error().kind == FailureKind::Conflict);
    // Its pixels are elsewhere than its metres: with its new name it might jump there.
    const auto list = points(kPark).points;
    const auto fourth = std::find_if(list.begin(), list.end(), [](const map::Waypoint& point) {
      return point.name == "Navigation Point 4";
    });
    QVERIFY(fourth != list.end());
    map::Waypoint renamed = *fourth;
    renamed.name = "Gate";
    const auto jumps = change(kPark, {fourth->id, *fourth, renamed});
    QVERIFY(!jumps && jumps.error().cause.code == robot::aimdk::fault::PointInTwoPlaces);
    QCOMPARE(writes(), 0);
  }

  void withoutPointsThatTellTheScaleNoneIsSet() {
    makeNewer();
    QVERIFY(carryOut({MapChange::StartMapping}));
    const auto yard = carryOut({MapChange::Save, {}, "Yard"});
    QVERIFY2(yard, why(yard));
    const int before = writes();
    const auto made = change(yard->key, {"ours", std::nullopt, newPoint(1, 2, 0)});
    QVERIFY(!made && made.error().cause.code == robot::aimdk::fault::PointScaleUntold);
    QCOMPARE(made.error().applied, Applied::No);
    QCOMPARE(writes(), before);
  }

  void aMapIsDrawnInTheReadingThatItsPointsTell() {
    for (const bool centimetres : {false, true}) {
      makeNewer({}, centimetres);
      const auto map =
          answerTo<map::WholeMap>([&](auto reply) { robot_->wholeMapSource()->fetch(kPark, reply); });
      QVERIFY2(map, why(map));
      QCOMPARE(map->grid.resolution_m, 0.05);
      QCOMPARE(map->notes.size(), std::size_t(centimetres ? 1 : 0));
      if (centimetres) QVERIFY(map->notes.front().reason.code == robot::aimdk::fault::ScaleInCentimetres);
    }
  }
};

}  // namespace test_aimdk_newer

MAPWRIGHT_TEST(test_aimdk_newer, AimdkNewerTest, Core)
#include "test_aimdk_newer.moc"
