#include <cstring>

#include <QByteArray>
#include <QTest>

#include "robot/axbot/parse_topics.h"
#include "ros_messages/wrapper.pb.h"
#include "test_program.h"

namespace test_axbot_clouds {

using namespace mapwright;
using namespace mapwright::robot::axbot;

namespace {

using Points = std::vector<map::CloudPoint>;

Points cloud(const std::string& text) {
  const TextFrame frame = parseTextFrame(text);
  if (!frame.message || !std::holds_alternative<map::PointCloudMessage>(*frame.message))
    return {{-99, -99, 0, 0}};
  return *std::get<map::PointCloudMessage>(*frame.message).points;
}

template <typename T>
void append(QByteArray& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

std::string binary(const std::string& topic, const ros_messages::RosMessageWrapper& wrapper) {
  return std::string(1, char(topic.size())) + topic + std::string(1, '\0') + wrapper.SerializeAsString();
}

Points binaryCloud(bool delta, bool with_z) {
  ros_messages::RosMessageWrapper wrapper;
  wrapper.set_type(ros_messages::POINT_CLOUD);
  auto* points = wrapper.mutable_point_cloud();
  points->set_center_x(10);
  points->set_center_y(-20);
  points->set_center_z(1);
  points->set_resolution(0.5f);
  for (const int x : {2, delta ? 1 : 3}) points->add_xs(x);
  for (const int y : {-4, delta ? 2 : -2}) points->add_ys(y);
  if (with_z) {
    for (const int z : {1, 1}) points->add_zs(z);
  }
  points->set_intensities("\x05\xff");
  points->set_is_delta_encoded(delta);
  const auto message = parseBinaryFrame(binary("/scan_matched_points2", wrapper));
  return *std::get<map::PointCloudMessage>(*message).points;
}

}  // namespace

class AxbotCloudsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void listedPointsOfAllLengthsAreRead() {
    const Points points = cloud(
        R"({"topic":"/scan_matched_points2","stamp":1653302201889,"points":[[1,2],[3,4,0.5],[5,"6",0.5,255],
            [NaN,1],[Infinity,1,1],[null,2],[],[1],{"x":7,"y":8,"z":1},"x",[1e300,0]]})");
    QCOMPARE(points.size(), std::size_t(4));
    QCOMPARE(points[1].z_m, 0.5f);
    QCOMPARE(points[2].y_m, 6.0);
    QCOMPARE(int(points[2].intensity), 255);
    QCOMPARE(points[3].x_m, 7.0);
  }

  void probabilitiesOfZeroToOneFillTheWholeRange() {
    const Points points =
        cloud(R"({"topic":"/semantic_points","points":[[0,0,0,0.5],[0,0,0,1],[0,0,0,-1]]})");
    QCOMPARE(int(points[0].intensity), 128);
    QCOMPARE(int(points[1].intensity), 255);
    QCOMPARE(int(points[2].intensity), 0);
  }

  void packedFieldsAreReadInAnyOrderAndType() {
    QByteArray records;
    for (const double x : {1.5, 2.5}) {
      append(records, std::uint8_t(200));
      append(records, std::int16_t(-7));
      append(records, x);
      append(records, 0.25f);
    }
    records.append("cut");  // an unfinished record
    const std::string text =
        R"({"topic":"/semantic_points","fields":[{"name":"Intensity","data_type":"u8"},{"name":"Y","data_type":"i16"},
            {"name":"X","data_type":"f64"},{"name":"z","data_type":"F32"}],"data":)"
        "\"" +
        records.toBase64().toStdString() + "\"}";
    const Points points = cloud(text);
    QCOMPARE(points.size(), std::size_t(2));
    QCOMPARE(points[1].x_m, 2.5);
    QCOMPARE(points[1].y_m, -7.0);
    QCOMPARE(points[1].z_m, 0.25f);
    QCOMPARE(int(points[1].intensity), 200);
  }

  void tabledFieldsAreReadToo() {
    const Points points = cloud(
        R"({"topic":"/matched_depth_points/forward","fields":[{"name":"y","data_type":"f32"},{"name":"x","data_type":"f32"}],"data":[[1,2],[3],[]]})");
    QCOMPARE(points.size(), std::size_t(1));
    QCOMPARE(points[0].x_m, 2.0);
  }

  void emptyCloudsAreClouds() {
    QVERIFY(cloud(R"({"topic":"/scan_matched_points2","points":[]})").empty());
    QVERIFY(cloud(R"({"topic":"/x_laser_2d/matched","fields":[{"name":"x","data_type":"f32"},
                      {"name":"y","data_type":"f32"}],"data":""})")
                .empty());
  }

  void cloudsThatCannotBeReadAreReported() {
    for (
        const char* text :
        {R"({"topic":"/scan_matched_points2"})", R"({"topic":"/scan_matched_points2","points":"x"})",
         R"({"topic":"/semantic_points","fields":[{"name":"x","data_type":"f32"}],"data":"AAAA"})",
         R"({"topic":"/semantic_points","fields":[{"name":"x","data_type":"f99"},{"name":"y","data_type":"f32"}],"data":"AAAA"})",
         R"({"topic":"/semantic_points","fields":[{"name":"x","data_type":"f32"},{"name":"y","data_type":"f32"}],"data":"!"})"}) {
      const TextFrame frame = parseTextFrame(text);
      QVERIFY2(frame.message && std::holds_alternative<map::UnreadableMessage>(*frame.message), text);
    }
  }

  void noMoreThanTwoMillionPointsAreTaken() {
    std::string text = R"({"topic":"/scan_matched_points2","points":[)";
    for (int i = 0; i < 2'000'010; ++i) text += "[0,1],";
    text.back() = ']';
    QCOMPARE(cloud(text + "}").size(), std::size_t(2'000'000));
  }

  void binaryCloudsAreReadPlainAndDeltaEncoded() {
    for (const bool delta : {false, true}) {
      const Points points = binaryCloud(delta, true);
      QCOMPARE(points.size(), std::size_t(2));
      QCOMPARE(points[1].x_m, 11.5);
      QCOMPARE(points[1].y_m, -21.0);
      QCOMPARE(points[1].z_m, delta ? 2.0f : 1.5f);
      QCOMPARE(int(points[0].intensity), 5);
      QCOMPARE(int(points[1].intensity), 255);
    }
    QCOMPARE(binaryCloud(true, false)[1].z_m, 0.0f);
  }

  void binaryCloudsWithNonsenseAreReported() {
    ros_messages::RosMessageWrapper wrapper;
    wrapper.mutable_point_cloud()->set_resolution(std::numeric_limits<float>::infinity());
    const auto message = parseBinaryFrame(binary("/semantic_points", wrapper));
    QVERIFY(message && std::holds_alternative<map::UnreadableMessage>(*message));
    const auto empty = parseBinaryFrame(binary("/semantic_points", {}));
    QVERIFY(empty && std::holds_alternative<map::UnreadableMessage>(*empty));
  }

  void onlyKnownTopicsAreClouds_data() {
    QTest::addColumn<QString>("topic");
    QTest::addColumn<bool>("known");
    const auto row = [](const char* topic, bool known) {
      QTest::newRow(topic) << QString::fromLatin1(topic) << known;
    };
    row("/scan_matched_points2", true);
    row("/semantic_points", true);
    row("/left_laser_2d/matched", true);
    row("/right_laser_2d/matched", true);
    row("/matched_depth_points/downward", true);
    row("/left_laser_2d", false);
    row("/scan_matched_points", false);
    row("/depth_points", false);
    row("/recorded_points", false);
    row("/", false);
  }
  void onlyKnownTopicsAreClouds() {
    QFETCH(QString, topic);
    QFETCH(bool, known);
    const std::string name = topic.toStdString();
    ros_messages::RosMessageWrapper wrapper;
    wrapper.mutable_point_cloud()->add_xs(1);
    wrapper.mutable_point_cloud()->add_ys(2);
    const std::string head = "{\"topic\":\"" + name + "\",";
    const auto points = parseTextFrame(head + "\"points\":[[1,2]]}").message;
    const auto fields = parseTextFrame(head +
                                       "\"fields\":[{\"name\":\"x\",\"data_type\":\"f32\"},{\"name\":"
                                       "\"y\",\"data_type\":\"f32\"}],\"data\":\"\"}")
                            .message;
    for (const auto& message : {points, fields, parseBinaryFrame(binary(name, wrapper))}) {
      QCOMPARE(message.has_value(), known);
      if (known) QVERIFY(std::holds_alternative<map::PointCloudMessage>(*message));
    }
  }
};

}  // namespace test_axbot_clouds

MAPWRIGHT_TEST(test_axbot_clouds, AxbotCloudsTest, Core)
#include "test_axbot_clouds.moc"
