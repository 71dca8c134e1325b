#include <cmath>

#include <QTest>

#include "robot/axbot/parse_topics.h"
#include "test_program.h"

namespace test_axbot_topics {

using namespace mapwright;
using namespace mapwright::robot::axbot;

namespace {

template <typename T>
T read(const std::string& text) {
  const TextFrame frame = parseTextFrame(text);
  if (!frame.message || !std::holds_alternative<T>(*frame.message)) {
    QTest::qFail("not such a message", __FILE__, __LINE__);
    return T{};
  }
  return std::get<T>(*frame.message);
}

/// A message of a topic, its other members as they are written.
std::string of(std::string_view topic, std::string_view members) {
  std::string text("{\"topic\":\"");
  return text.append(topic).append("\",").append(members).append("}");
}

bool unreadable(const std::string& text) {
  const TextFrame frame = parseTextFrame(text);
  return frame.message && std::holds_alternative<map::UnreadableMessage>(*frame.message) &&
         !frame.grid_to_fetch;
}

}  // namespace

class AxbotTopicsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void slamStateAndBatteryAreRead() {
    const auto slam = read<map::SlamStatus>(
        "{\"topic\":\"/slam/"
        "state\",\"state\":\"positioning\",\"reliable\":\"false\",\"position_quality\":\"8\",\"lidar_"
        "matching_score\":0.5,\"lidar_matched\":1,\"wheel_slipping\":null}");
    QCOMPARE(slam.state, std::string("positioning"));
    QCOMPARE(slam.reliable, std::optional(false));
    QCOMPARE(slam.position_quality, std::optional(8));
    QCOMPARE(slam.lidar_matched, std::optional(true));
    QVERIFY(!slam.wheel_slipping);
    QCOMPARE(*read<map::BatteryState>("{\"topic\":\"/battery_state\",\"percentage\":0.64}").level, 0.64);
    QCOMPARE(*read<map::BatteryState>("{\"topic\":\"/battery_state\",\"percentage\":\"64\"}").level, 0.64);
    const auto full = read<map::BatteryState>(
        "{\"topic\":\"/"
        "detailed_battery_state\",\"percentage\":250,\"voltage\":26.3,\"power_supply_status\":\"full\"}");
    QCOMPARE(*full.level, 1.0);
    QCOMPARE(full.supply, std::string("full"));
    QVERIFY(!read<map::BatteryState>("{\"topic\":\"/battery_state\",\"percentage\":NaN}").level);
  }

  void pathsAreReadAndTheirBadPointsLeftOut() {
    QCOMPARE(read<map::PathMessage>(
                 "{\"topic\":\"/"
                 "path\",\"stamp\":1653301966860,\"positions\":[[1,2],[\"3\",4.5,0],[null,1],[NaN,2],7,[5]]}")
                 .points,
             (map::Polyline{{1, 2}, {3, 4.5}}));
    for (const char* topic : {"/trajectory", "/trajectory_node_list"}) {
      QCOMPARE(read<map::TrajectoryMessage>(of(topic, "\"points\":[[1,2],[3,4]]")).points.size(),
               std::size_t(2));
    }
    QVERIFY(read<map::PathMessage>("{\"topic\":\"/path\",\"positions\":null}").points.empty());
    QVERIFY(read<map::PathMessage>("{\"topic\":\"/path\"}").points.empty());
  }

  void theLocalPathHasItsColour() {
    const auto colour = [](const std::string& text) {
      std::string members("\"width\":1.1,\"poses\":[[1,2,3]],\"color\":");
      return read<map::LocalPathMessage>(of("/local_path", members.append(text))).rgba;
    };
    QCOMPARE(colour("\"#FFEACD50\""), std::optional(0xffeacd50u));
    QCOMPARE(colour("\"##FFEACD50\""), std::optional(0xffeacd50u));
    QCOMPARE(colour("\"#ffeacd\""), std::optional(0xffeacdffu));
    QVERIFY(!colour("\"red\"") && !colour("null") && !colour("\"#12345\""));
  }

  void planningIsRead() {
    const auto state = read<map::PlanningState>(
        "{\"topic\":\"/"
        "planning_state\",\"action_id\":9007199254740993,\"action_type\":\"charge\",\"move_state\":"
        "\"failed\",\"fail_reason\":3,\"fail_reason_str\":\"stuck\",\"remaining_distance\":2.5,\"stuck_"
        "state\":\"none\",\"target_poses\":[{\"pos\":[4,3],\"ori\":1},{\"pos\":\"x\"},null]}");
    QCOMPARE(state.action_id, std::optional<std::int64_t>(9007199254740993));
    QCOMPARE(state.fail_reason, std::string("stuck"));
    QVERIFY(state.stuck_state.empty());
    QCOMPARE(state.targets, (std::vector<geometry::Pose2>{{4, 3, 1}}));
    for (const char* none : {"none", "None", "None - None", "0"}) {
      const auto well = read<map::PlanningState>(
          "{\"topic\":\"/planning_state\",\"move_state\":\"moving\",\"fail_reason_str\":\"" +
          std::string(none) + "\"}");
      QVERIFY2(well.fail_reason.empty(), none);
    }
  }

  void alertsKeepTheirTextAsItIs() {
    const auto alerts = read<map::AlertsMessage>(
        "{\"topic\":\"/alerts\",\"alerts\":[{\"code\":\"6004\",\"level\":\"error\",\"msg\":\"<b>Hot</b> "
        "🔥\"},{\"code\":1,\"level\":\"warning\"},3]}");
    QCOMPARE(alerts.alerts.size(), std::size_t(2));
    QCOMPARE(alerts.alerts[0].code, std::int64_t(6004));
    QCOMPARE(alerts.alerts[0].level, map::AlertLevel::Error);
    QCOMPARE(alerts.alerts[0].text, std::string("<b>Hot</b> 🔥"));
    QVERIFY(read<map::AlertsMessage>("{\"topic\":\"/alerts\",\"alerts\":null}").alerts.empty());
    QVERIFY(unreadable("{\"topic\":\"/alerts\",\"alerts\":\"many\"}"));
  }

  void otherRobotsAndTheirFootprintsAreRead() {
    const auto robots = read<map::NearbyRobotsMessage>(
        "{\"topic\":\"/"
        "nearby_robots\",\"robots\":[{\"uid\":\"a\",\"pose\":{\"pos\":[1,2],\"ori\":3},\"trend\":[[1,2],[2,2]"
        "],\"footprint_digest\":\"d\"},{\"uid\":\"lost\"}]}");
    QCOMPARE(robots.robots.size(), std::size_t(1));
    QCOMPARE(robots.robots[0].trend.size(), std::size_t(2));
    const auto footprints = read<map::NearbyFootprintsMessage>(
        "{\"topic\":\"/"
        "nearby_robot_footprints\",\"footprints\":[{\"digest\":\"d\",\"coordinates\":[[0,0],[1,0],[1,1]]},{"
        "\"digest\":\"e\",\"coordinates\":[[0,0]]}]}");
    QCOMPARE(footprints.by_digest.size(), std::size_t(1));
  }

  void doorsLandmarksPalletsRacksAndObjectsAreRead() {
    QCOMPARE(read<map::LandmarksMessage>(
                 "{\"topic\":\"/"
                 "landmarks\",\"landmarks\":[{\"id\":7,\"pos\":[1,2],\"in_use\":true},{\"id\":\"x\"}]}")
                 .landmarks.at(0)
                 .id,
             std::string("7"));
    QCOMPARE(read<map::AutoDoorsMessage>(
                 "{\"topic\":\"/"
                 "nearby_auto_doors\",\"doors\":[{\"name\":\"A\",\"mac\":\"1\",\"state\":\"open\","
                 "\"polygon\":[[[0,0],[1,0],[1,1]]]},{\"name\":\"B\",\"polygon\":[[0,0],[1,0],[1,1]]}]}")
                 .doors.size(),
             std::size_t(2));
    const auto pallet = read<map::PalletsMessage>(
                            "{\"topic\":\"/"
                            "detected_pallets\",\"pallets\":[{\"frame\":\"base_link\",\"pallet_id\":\"P\","
                            "\"pose\":{\"pos\":[1,2],\"ori\":0.5},\"size\":{\"width\":1.0,\"depth\":1.3}}]}")
                            .pallets.at(0);
    QCOMPARE(pallet.length_m, 1.3);
    QVERIFY(pallet.in_robot_frame);
    QVERIFY(read<map::RackMessage>(
                "{\"topic\":\"/"
                "detected_rack\",\"rack_detected\":false,\"rack_box\":{\"pose\":{\"pos\":[0,0],\"ori\":0}}}")
                .racks.empty());
    QCOMPARE(
        read<map::RackMessage>("{\"topic\":\"/"
                               "detected_rack\",\"rack_detected\":true,\"frame\":\"map\",\"rack_box\":{"
                               "\"pose\":{\"pos\":[0,0],\"ori\":0},\"width\":0.6,\"height\":0.7},\"rack_box_"
                               "aligned\":{\"pose\":{\"pos\":[0,0],\"ori\":0},\"width\":0.6,\"height\":0.7}}")
            .racks.size(),
        std::size_t(2));
    for (const auto& [topic, list, kind] : {std::tuple("racks_v2", "racks", map::BoxKind::Rack),
                                            {"pallets", "pallets", map::BoxKind::Pallet},
                                            {"chargers", "poses", map::BoxKind::Charger}}) {
      const auto seen = read<map::DetectedFeaturesMessage>(
          std::string("{\"topic\":\"/detected_features/") + topic + "\",\"" + list +
          "\":[{\"pos\":[1,2],\"ori\":0.5},{\"pose\":{\"pos\":[3,4],\"ori\":0},\"size\":{\"width\":0.8,"
          "\"depth\":"
          "1.2}},{\"id\":\"no pose\"}]}");
      QCOMPARE(seen.boxes.size(), std::size_t(2));
      QVERIFY(seen.kind == kind && seen.boxes[0].pose.x_m == 1 && seen.boxes[1].length_m == 1.2);
    }
    const auto jack =
        read<map::JackState>("{\"topic\":\"/jack_state\",\"state\":\"hold\",\"progress\":0.35}");
    QVERIFY(jack.state == "hold" && jack.progress == 0.35 && !jack.weight);
    const auto towing = read<map::TowingState>(
        "{\"topic\":\"/towing_state\",\"state\":\"error\",\"cargo_detected\":true,\"error_code\":7}");
    QVERIFY(towing.state == "error" && towing.cargo_detected == true && towing.error_code == 7);
    const auto person = read<map::SeenObjectsMessage>(
                            "{\"topic\":\"/"
                            "vision_detected_objects\",\"boxes\":[{\"pose\":{\"pos\":[0.3,1],\"ori\":0},"
                            "\"dimensions\":[0.5,0.4,1.8],\"label\":1}]}")
                            .objects.at(0);
    QCOMPARE(person.label, std::string("person"));
    QCOMPARE(person.width_m, 0.5);
  }

  void constraintsAreSegmentsHoweverTheyAreWritten() {
    const auto constraints = read<map::ConstraintsMessage>(
        "{\"topic\":\"/constraint_list\",\"stamp\":1,\"Inter residuals, different "
        "trajectories\":[[0,0],[1,1],[2,2],[3,3],[9,9]],\"flat\":[[0,0,1,1]],\"nested\":[[[0,0],[1,1]]],"
        "\"odd\":[null,\"x\",[1]]}");
    QCOMPARE(constraints.by_name.at("Inter residuals, different trajectories").size(), std::size_t(2));
    QCOMPARE(constraints.by_name.at("flat").size(), std::size_t(1));
    QCOMPARE(constraints.by_name.at("nested").size(), std::size_t(1));
    QVERIFY(constraints.by_name.at("odd").empty());
  }

  void positioningAndBarcodesAreRead() {
    const auto positioning = read<map::GlobalPositioning>(
        "{\"topic\":\"/"
        "global_positioning_state\",\"state\":\"succeeded\",\"score\":\"82.1\",\"needs_confirmation\":false,"
        "\"pose\":{\"pos\":[1,2],\"ori\":0}}");
    QCOMPARE(*positioning.score, 82.1);
    QVERIFY(positioning.pose.has_value());
    const auto barcode = read<map::BarcodeMessage>(
        "{\"topic\":\"/"
        "collected_barcode\",\"state\":\"ok\",\"barcode\":{\"id\":\"D2_125\",\"pose\":{\"pos\":[1,2],\"ori\":"
        "3}}}");
    QCOMPARE(barcode.id, std::string("D2_125"));
    QVERIFY(barcode.pose.has_value());
  }

  void mapInfoTakesOverlaysAsObjectAndAsText() {
    const std::string overlays =
        "{\"type\":\"FeatureCollection\",\"features\":[{\"geometry\":{\"type\":\"Point\",\"coordinates\":[1,"
        "2]}}]}";
    std::string members("\"name\":\"<b>\",\"uid\":\"u\",\"map_version\":\"3\",\"overlays\":");
    const auto info = read<map::MapInfo>(of("/map/info", members.append(overlays)));
    QCOMPARE(info.overlays.size(), std::size_t(1));
    QCOMPARE(info.map_version, std::optional(3));
    std::string quoted("\"overlays\":\"");
    for (const char c : overlays) quoted.append(c == '"' ? "\\" : "").push_back(c);
    quoted.append("\"");
    QCOMPARE(read<map::MapInfo>(of("/map/info", quoted)).overlays.size(), std::size_t(1));
  }

  void overlaysThatNobodyCanReadAreNotTakenForNone_data() {
    QTest::addColumn<QByteArray>("overlays");
    QTest::addColumn<bool>("readable");
    QTest::newRow("none") << QByteArray("null") << true;
    QTest::newRow("empty") << QByteArray("\"\"") << true;
    QTest::newRow("no features") << QByteArray("{\"features\":[]}") << true;
    QTest::newRow("cut off") << QByteArray("\"{\\\"features\\\":[{\"") << false;
    QTest::newRow("garbage") << QByteArray("\"#%\"") << false;
    QTest::newRow("a number") << QByteArray("7") << false;
  }
  void overlaysThatNobodyCanReadAreNotTakenForNone() {
    QFETCH(QByteArray, overlays);
    const TextFrame frame =
        parseTextFrame(of("/map/info", "\"name\":\"a\",\"overlays\":" + overlays.toStdString()));
    QVERIFY(frame.message && std::holds_alternative<map::MapInfo>(*frame.message));
    QTEST(!frame.left_out, "readable");
  }

  void picturesComeAsBase64() {
    const auto grid = read<map::GridMessage>(
        "{\"topic\":\"/maps/1cm/"
        "1hz\",\"resolution\":\"0.01\",\"size\":[4,2],\"origin\":[-1,2.5],\"data\":\"data:image/"
        "png;base64,aGVs\\nbG8\"}");
    QCOMPARE(grid.kind, map::GridKind::CostmapHigh);
    QCOMPARE(*grid.png, std::string("hello"));
    QCOMPARE(grid.grid, (map::GridReference{4, 2, 0.01, {-1, 2.5, 0}}));
    QVERIFY(!grid.fingerprint.empty());
  }

  void picturesThatAreElsewhereAreToBeFetched() {
    const TextFrame frame = parseTextFrame(
        "{\"topic\":\"/"
        "map_v2\",\"resolution\":0.05,\"size\":[4,2],\"origin\":[0,0],\"data\":null,\"data_url\":\"static-"
        "files/a.png\"}");
    QVERIFY(frame.grid_to_fetch && !frame.message);
    QCOMPARE(frame.grid_to_fetch->data_url, std::string("static-files/a.png"));
  }

  void picturesThatCannotBeUsedAreReported_data() {
    QTest::addColumn<QByteArray>("members");
    QTest::newRow("garbage") << QByteArray("\"resolution\":0.05,\"origin\":[0,0],\"data\":\"!!!\"");
    QTest::newRow("no resolution") << QByteArray("\"origin\":[0,0],\"data\":\"aGVs\"");
    QTest::newRow("zero") << QByteArray("\"resolution\":0,\"origin\":[0,0],\"data\":\"aGVs\"");
    QTest::newRow("negative") << QByteArray("\"resolution\":-1,\"origin\":[0,0],\"data\":\"aGVs\"");
    QTest::newRow("NaN") << QByteArray("\"resolution\":NaN,\"origin\":[0,0],\"data\":\"aGVs\"");
    QTest::newRow("no origin") << QByteArray("\"resolution\":1,\"data\":\"aGVs\"");
    QTest::newRow("huge origin") << QByteArray("\"resolution\":1,\"origin\":[1e300,0],\"data\":\"aGVs\"");
    QTest::newRow("nothing") << QByteArray("\"resolution\":1,\"origin\":[0,0]");
    QTest::newRow("empty") << QByteArray("\"resolution\":1,\"origin\":[0,0],\"data\":\"\"");
  }
  void picturesThatCannotBeUsedAreReported() {
    QFETCH(QByteArray, members);
    QVERIFY(unreadable(of("/map", members.toStdString())));
  }

  void absurdSizesAreNoSizes() {
    const auto grid = read<map::GridMessage>(
        "{\"topic\":\"/"
        "map\",\"resolution\":1,\"size\":[99999999999,-3],\"origin\":{\"x\":1,\"y\":2},\"data\":\"aGVs\"}");
    QCOMPARE(grid.grid.width, 0);
    QCOMPARE(grid.grid.height, 0);
    QCOMPARE(grid.grid.origin.y_m, 2.0);
  }

  void everyKnownTopicStandsGarbage() {
    for (const QString& topic : knownTopics()) {
      for (const char* members :
           {"\"a\":1", "\"points\":3", "\"robots\":{},\"doors\":[[]],\"boxes\":[null],\"pallets\":[{}]",
            "\"pos\":\"x\",\"pose\":[],\"size\":[],\"fields\":[{}],\"data\":[[]]",
            "\"alerts\":[[]],\"overlays\":\"[\""}) {
        const std::string text = of(topic.toStdString(), members);
        QVERIFY(!parseTextFrame(text).grid_to_fetch);
      }
    }
  }
};

}  // namespace test_axbot_topics

MAPWRIGHT_TEST(test_axbot_topics, AxbotTopicsTest, Core)
#include "test_axbot_topics.moc"
