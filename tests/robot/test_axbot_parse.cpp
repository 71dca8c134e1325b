#include <cmath>
#include <zlib.h>

#include <QTest>

#include "map/submap_version.h"
#include "net/json_numbers.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_maps.h"
#include "robot/axbot/parse_topics.h"
#include "ros_messages/wrapper.pb.h"
#include "test_program.h"

namespace test_axbot_parse {

using namespace mapwright;
using namespace mapwright::robot::axbot;
using mapwright::net::repairNumbers;
using Outcome = map::SubmapAnswer::Outcome;

namespace {

constexpr const char* kSeedList = R"({"topic":"/submap_list","slam_state":"positioning",
  "uuid":"681dc447472ac49d7b074fa1","submap":[{"trajectory_id":12,"submap_index":3,"submap_version":42,
  "pose":{"x":1.25,"y":-3.5,"z":0,"qx":0,"qy":0,"qz":0.7071,"qw":0.7071},
  "is_frozen":true,"is_incremental_submap":false,"is_nearby_map":false}]})";

std::string gzip(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(text.size() + 200, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = uInt(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string binaryList() {
  ros_messages::RosMessageWrapper wrapper;
  wrapper.set_type(ros_messages::SUBMAP_LIST);
  auto* list = wrapper.mutable_submap_list();
  list->set_uuid("abc");
  list->set_slam_state(ros_messages::slam::SLAM_STATE_SLAM);
  auto* entry = list->add_submaps();
  entry->set_trajectory_id(1);
  entry->set_submap_index(2);
  entry->set_submap_version(3);
  entry->mutable_pose()->set_x(4);
  entry->mutable_pose()->set_qw(1);
  entry->set_is_nearby_map(true);
  return wrapper.SerializeAsString();
}

std::string frame(const std::string& topic, char zipped, const std::string& body) {
  return std::string(1, char(topic.size())) + topic + std::string(1, zipped) + body;
}

map::SubmapList listOf(const std::string& text) {
  return std::get<map::SubmapList>(*parseTextFrame(text).message);
}

}  // namespace

class AxbotParseTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theDocumentedListIsRead() {
    const map::SubmapList list = listOf(kSeedList);
    QCOMPARE(list.uuid, std::string("681dc447472ac49d7b074fa1"));
    QCOMPARE(list.slam_state, map::SlamState::Positioning);
    QCOMPARE(list.entries.size(), std::size_t(1));
    QCOMPARE(list.entries[0].id, (map::SubmapId{12, 3}));
    QCOMPARE(list.entries[0].version, 42);
    QCOMPARE(list.entries[0].pose.qz, 0.7071);
    QVERIFY(list.entries[0].is_frozen && !list.entries[0].is_nearby);
  }

  void theOtherKeyAndANumericStateAreReadToo() {
    const map::SubmapList list = listOf(
        R"({"topic":"/submap_list","slam_state":1,"uuid":"u","submaps":[{"trajectory_id":0,"submap_index":1.0,
        "submap_version":2,"pose":{"x":1,"y":2}}]})");
    QCOMPARE(list.slam_state, map::SlamState::Slam);
    QCOMPARE(list.entries.at(0).id.index, 1);
    QCOMPARE(list.entries.at(0).pose.qw, 1.0);
  }

  void aLiteralNaNSpoilsOnlyItsRow() {
    std::string text(kSeedList);
    text.insert(text.find("]}"), R"(,{"trajectory_id":0,"submap_index":0,"submap_version":1,
      "pose":{"x":NaN,"y":-Infinity,"z":1e999,"qx":0,"qy":0,"qz":0,"qw":1}})");
    const map::SubmapList list = listOf(text);
    QCOMPARE(list.entries.size(), std::size_t(2));
    QVERIFY(std::isnan(list.entries[1].pose.x));
    QCOMPARE(list.entries[0].pose.x, 1.25);
  }

  void aByteOrderMarkInFrontIsPassedOver() {
    const TextFrame read = parseTextFrame(std::string("\xEF\xBB\xBF") + kSeedList);
    QVERIFY(read.message && std::holds_alternative<map::SubmapList>(*read.message));
  }

  void rowsWithoutUsableIdsAreRejectedWithTheirPlace() {
    const map::SubmapList list = listOf(
        R"({"topic":"/submap_list","uuid":"u","submap":[{"trajectory_id":99999999999999999999,"submap_index":0,
        "submap_version":1},{"submap_index":1},7,null,{"trajectory_id":0,"submap_index":0,"submap_version":5}]})");
    QCOMPARE(list.entries.size(), std::size_t(1));
    QCOMPARE(list.rejected.size(), std::size_t(4));
    QVERIFY(list.rejected[2] == Fault(robot::axbot::fault::RowWithoutNumbers, {3}));
    QVERIFY2(std::isnan(list.entries[0].pose.x), "a row without a pose is kept, but cannot be placed");
  }

  void onlyAListThatIsThereIsEmpty() {
    QVERIFY(
        listOf(R"({"topic":"/submap_list","slam_state":"invalid","uuid":"","submap":[]})").entries.empty());
    for (const char* none :
         {R"({"topic":"/submap_list","uuid":"u"})", R"({"topic":"/submap_list","uuid":null,"submap":null})",
          R"({"topic":"/submap_list","submap":[{"trajectory_id":0,"submap_index":0,"submap_version":1}]})",
          R"({"topic":"/submap_list","uuid":"u","submap":[null,7]})"})
      QVERIFY2(std::holds_alternative<map::UnreadableMessage>(*parseTextFrame(none).message), none);
  }

  void whatIsNoVersionIsNone() {
    for (const char* version : {"null", "-3", "\"new\"", "1.5", "99999999999"}) {
      const map::SubmapList list =
          listOf(R"({"topic":"/submap_list","uuid":"u","submap":[{"trajectory_id":0,"submap_index":0,)"
                 R"("submap_version":)" +
                 std::string(version) + "}]}");
      QCOMPARE(list.entries.at(0).version, map::kNoVersion);
    }
  }

  void numbersInNamesAreLeftAlone() {
    QCOMPARE(repairNumbers("{\"a\":\"NaN \\\" -Infinity\",\"b\":NaN,\"c\":[1,-2.5e3,123456789012345678901]}"),
             std::string("{\"a\":\"NaN \\\" -Infinity\",\"b\":null,\"c\":[1,-2.5e3,null]}"));
  }

  void garbageIsReportedNotFatal() {
    for (const std::string text : {"", "{", "[]", "hello", "{\"topic\":", "\xff\xfe\x00"}) {
      const TextFrame read = parseTextFrame(text);
      QVERIFY(read.message && std::holds_alternative<map::UnreadableMessage>(*read.message));
    }
    QVERIFY(std::holds_alternative<map::UnreadableMessage>(
        *parseTextFrame(R"({"topic":"/submap_list","submap":{"a":1}})").message));
    QVERIFY(std::holds_alternative<map::UnreadableMessage>(
        *parseTextFrame(R"({"topic":"/tracked_pose","pos":[null,2],"ori":0})").message));
  }

  void answersAndUnknownTopicsAreToldApart() {
    QCOMPARE(parseTextFrame(R"({"enabled_topics":["/a","/b"]})").enabled_topics->size(), std::size_t(2));
    QVERIFY(!parseTextFrame(R"({"topic":"/no_such_state","progress":0.5})").message);
    QCOMPARE(parseTextFrame(R"({"error":"no such topic"})").error, std::string("no such topic"));
  }

  void poseModelAndSlamStateAreRead() {
    const auto pose = std::get<map::TrackedPose>(
        *parseTextFrame(R"({"topic":"/tracked_pose","pos":[1.5,-2],"ori":0.25})").message);
    QCOMPARE(pose.pose, (geometry::Pose2{1.5, -2, 0.25}));
    const auto model = std::get<map::RobotModel>(
        *parseTextFrame(R"({"topic":"/robot_model","footprint":[[0,0],[1,0],[1,1]],"width":0.6})").message);
    QCOMPARE(model.footprint.size(), std::size_t(3));
    QCOMPARE(std::get<map::SlamStatus>(
                 *parseTextFrame(R"({"topic":"/slam/state","state":"slam","reliable":true})").message)
                 .state,
             std::string("slam"));
  }

  void binaryListsAreReadPlainAndZipped() {
    for (const bool zipped : {false, true}) {
      const auto message =
          parseBinaryFrame(frame("/submap_list", zipped ? 1 : 0, zipped ? gzip(binaryList()) : binaryList()));
      const auto& list = std::get<map::SubmapList>(*message);
      QCOMPARE(list.uuid, std::string("abc"));
      QCOMPARE(list.slam_state, map::SlamState::Slam);
      QCOMPARE(list.entries.at(0).id, (map::SubmapId{1, 2}));
      QVERIFY(list.entries[0].is_nearby);
    }
  }

  void brokenBinaryFramesAreReported() {
    const std::string zipped = gzip(binaryList());
    for (const std::string& bytes :
         {std::string(), std::string("\xff/sub"), frame("/submap_list", 0, "\x0f\x0f\x0f"),
          frame("/submap_list", 1, "not gzip"), frame("/submap_list", 1, zipped.substr(0, zipped.size() / 2)),
          frame("/submap_list", 0, "")}) {
      const auto message = parseBinaryFrame(bytes);
      QVERIFY(message && std::holds_alternative<map::UnreadableMessage>(*message));
    }
    QVERIFY(!parseBinaryFrame(frame("/point_cloud", 0, "xyz")));
  }

  void aSubmapIsReadWithItsOwnVersion() {
    ros_messages::slam::SubmapQueryV2Response response;
    response.set_submap_version(9);
    auto* texture = response.add_textures();
    texture->set_cells("abcd");
    texture->set_width(2);
    texture->set_height(1);
    texture->set_resolution(0.05);
    const map::SubmapAnswer answer = parseSubmapResponse({"u", {1, 2}, 7}, response.SerializeAsString());
    QCOMPARE(answer.outcome, Outcome::Ok);
    QCOMPARE(answer.version, 9);
    QCOMPARE(answer.slices.at(0).cells, std::string("abcd"));
    QCOMPARE(answer.slices[0].slice_pose.qw, 1.0);  // none was sent: identity
  }

  void statusCodesDecideTheOutcome() {
    const auto outcome = [](ros_messages::slam::StatusCode code) {
      ros_messages::slam::SubmapQueryV2Response response;
      response.mutable_status()->set_code(code);
      response.mutable_status()->set_message("why");
      return parseSubmapResponse({"u", {0, 0}, 1}, response.SerializeAsString());
    };
    QCOMPARE(outcome(ros_messages::slam::NOT_FOUND).outcome, Outcome::NotFound);
    QCOMPARE(outcome(ros_messages::slam::UUID_MISMATCH).outcome, Outcome::WrongUuid);
    QCOMPARE(outcome(ros_messages::slam::UNAVAILABLE).outcome, Outcome::Failed);
    QVERIFY(outcome(ros_messages::slam::UNAVAILABLE).reason ==
            Fault(robot::axbot::fault::RobotAnswered, {"UNAVAILABLE"}, {mapwright::fault::said("why")}));
    QCOMPARE(outcome(ros_messages::slam::StatusCode(77)).outcome, Outcome::Failed);
  }

  void garbageAndEmptyAnswersFail() {
    QCOMPARE(parseSubmapResponse({"u", {0, 0}, 1}, "").outcome, Outcome::Failed);
    QCOMPARE(parseSubmapResponse({"u", {0, 0}, 1}, "<html>gateway</html>").outcome, Outcome::Failed);
  }
};

}  // namespace test_axbot_parse

MAPWRIGHT_TEST(test_axbot_parse, AxbotParseTest, Core)
#include "test_axbot_parse.moc"
