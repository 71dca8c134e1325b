// A map dispatcher of REP 130 behind a rosbridge server: what of it is found, what it is asked, what it
// tells.
#include <algorithm>
#include <cmath>

#include <QSignalSpy>
#include <QTest>

#include "robot/map_dispatch.h"
#include "robot/ros/faults.h"
#include "robot/ros/ros_robot.h"
#include "scripted_bridge.h"
#include "test_program.h"

namespace test_ros_dispatch {

using namespace mapwright;
using namespace mapwright::robot;
using map::FailureKind;
using map::Projection;
using ros::RosRobot;
using std::chrono::milliseconds;
using testing::ScriptedBridge;

namespace {

constexpr int kPatienceMs = 30'000;

QString text(const char* latin) { return QString::fromLatin1(latin); }

QJsonObject json(const QByteArray& text) { return QJsonDocument::fromJson(text).object(); }

QJsonObject grid(const QByteArray& data = "[0,100]") {
  return json(
      R"({"header":{"frame_id":"/map"},"info":{"resolution":0.05,"width":2,"height":1,"origin":{"position":)"
      R"({"x":1,"y":2,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}},"data":)" +
      data + "}");
}

QJsonObject cloud() {
  // Two points of three float32 (0, 0, 0) and (1, 0, 0).
  const char bytes[24] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, char(0x80), 0x3f};
  QJsonArray fields;
  for (int i = 0; i < 3; ++i) {
    fields << QJsonObject{{text("name"), QString(QChar('x' + i))},
                          {text("offset"), 4 * i},
                          {text("datatype"), 7},
                          {text("count"), 1}};
  }
  return {{text("header"), QJsonObject{{text("frame_id"), text("map")}}},
          {text("height"), 1},
          {text("width"), 2},
          {text("fields"), fields},
          {text("is_bigendian"), false},
          {text("point_step"), 12},
          {text("row_step"), 24},
          {text("data"), QString::fromLatin1(QByteArray(bytes, 24).toBase64())}};
}

QJsonObject projected(double min_z) {
  return {{text("map"), grid()}, {text("min_z"), min_z}, {text("max_z"), min_z + 2}};
}

QJsonObject infos(const char* member = "projected_maps_info") {
  QByteArray text =
      R"({"NAME":[{"frame_id":"/map","x":-1,"y":-2,"width":3,"height":4,"min_z":0.5,"max_z":2}]})";
  return json(text.replace("NAME", member));
}

const map::GridRegion kRegion{{3, 4}, {10, 20}};

}  // namespace

class RosDispatchTest : public QObject {
  Q_OBJECT
  std::unique_ptr<ScriptedBridge> server_;
  std::unique_ptr<RosRobot> robot_;
  QMap<QString, QString> types_;
  int capabilities_ = 0, map_changes_ = 0;

  void make(ros::DispatchSettings wish = {}) {
    ros::LinkOptions options;
    options.url = server_->url();
    options.look_every = milliseconds(50);
    options.look_timeout = milliseconds(20'000);
    options.dispatch = std::move(wish);
    options.dispatch_timeouts.settles = milliseconds(400);
    options.client.link.backoff_first = milliseconds(5);
    options.client.link.backoff_limit = milliseconds(20);
    robot_ = std::make_unique<RosRobot>(text("ros+test"), options);
    connect(robot_.get(), &Robot::capabilitiesChanged, this, [this] { ++capabilities_; });
  }
  /// Connects, and waits until it is known what there is.
  bool begin() {
    robot_->connectToRobot();
    return QTest::qWaitFor([this] { return robot_->connection().phase == ConnectionPhase::Online; },
                           kPatienceMs);
  }
  MapDispatch* dispatch() { return robot_->mapDispatch(); }
  void serve(const char* service, const char* type, const QJsonObject& answer) {
    types_[text(service)] = text(type);
    server_->serve(text(service), [answer](const QJsonObject&) { return answer; });
  }
  template <typename T>
  Outcome<T> outcome(const std::function<Call(OutcomeTo<T>)>& ask) {
    std::optional<Outcome<T>> ended;
    const Call call = ask([&](Outcome<T> told) { ended = std::move(told); });
    if (!QTest::qWaitFor([&] { return ended.has_value(); }, kPatienceMs)) qFatal("no answer");
    return *ended;
  }
  Outcome<map::GridPart> askGrid(const std::optional<map::GridRegion>& region) {
    return outcome<map::GridPart>([&](auto reply) { return dispatch()->grid(region, reply); });
  }
  Outcome<std::shared_ptr<const map::SpatialCloud>> askCloud(CloudKind kind,
                                                             const std::optional<map::CloudRegion>& region) {
    return outcome<std::shared_ptr<const map::SpatialCloud>>(
        [&](auto reply) { return dispatch()->cloud(kind, region, reply); });
  }
  Outcome<std::vector<Projection>> askProjections() {
    return outcome<std::vector<Projection>>([&](auto reply) { return dispatch()->projections(reply); });
  }
  Outcome<std::vector<Projection>> askProject(const std::vector<Projection>& wanted) {
    return outcome<std::vector<Projection>>([&](auto reply) { return dispatch()->project(wanted, reply); });
  }
  DispatchOffer offerOf(DispatchService service) {
    for (const DispatchOffer& offer : dispatch()->offers()) {
      if (offer.service == service) return offer;
    }
    return {};
  }

 private Q_SLOTS:
  void init() {
    server_ = std::make_unique<ScriptedBridge>();
    types_.clear();
    capabilities_ = 0;
    server_->serve(text("/rosapi/service_type"), [this](const QJsonObject& args) {
      return QJsonObject{{text("type"), types_.value(args[text("service")].toString())}};
    });
    make();
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  void aRobotWithoutOneSaysWhatItLacks() {
    serve("/static_map", "nav_msgs/GetMap", {{text("map"), grid()}});
    serve("/map_manager/save_map", "kabam_msgs/SaveMap", {});
    QVERIFY(begin());
    QVERIFY(!dispatch());
    QCOMPARE(robot_->unavailableReason(Capability::Dispatch).reason, Absence::Reason::NoService);
  }

  void regionsOfAGridAreAskedByTheirCentre() {
    serve("/map_dispatcher/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    QVERIFY(begin());
    QVERIFY(dispatch());
    const auto part = askGrid(kRegion);
    QVERIFY(part);
    QCOMPARE(part->frame, std::string("map"));
    QCOMPARE(part->grid.width, 2);
    QCOMPARE(part->grid.origin.x_m, 1.0);
    QCOMPARE(*part->cells, (std::vector<std::int8_t>{0, 100}));
    QCOMPARE(server_->argumentsOf(text("/map_dispatcher/get_sub_map")),
             QList{json(R"({"x":3,"y":4,"l_x":10,"l_y":20})")});
    // What is not there is said, and nobody is asked.
    QVERIFY(!dispatch()->offered(DispatchService::Grid));
    const auto whole = askGrid(std::nullopt);
    QVERIFY(!whole);
    QCOMPARE(whole.error().kind, FailureKind::Unsupported);
  }

  void aRegionThatMeansNothingIsNotAskedFor() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    serve("/d/get_sub_point_map", "map_msgs/GetPointMapROI", {{text("sub_map"), cloud()}});
    QVERIFY(begin());
    for (const map::GridRegion& region :
         {map::GridRegion{{0, 0}, {0, 1}}, map::GridRegion{{0, 0}, {1, -1}},
          map::GridRegion{{std::nan(""), 0}, {1, 1}}, map::GridRegion{{0, 0}, {1, INFINITY}}}) {
      const auto part = askGrid(region);
      QVERIFY(!part);
      QCOMPARE(part.error().kind, FailureKind::Refused);
      QCOMPARE(part.error().cause.code, robot::ros::fault::RegionMeansNothing);
    }
    for (const map::CloudRegion& region :
         {map::CloudRegion{{0, 0, 0}, -1, {1, 1, 1}}, map::CloudRegion{{0, 0, 0}, 0, {1, 1, 0}},
          map::CloudRegion{{0, 0, INFINITY}, 1, {}}, map::CloudRegion{{0, 0, 0}, std::nan(""), {1, 1, 1}}}) {
      const auto part = askCloud(CloudKind::Points, region);
      QVERIFY(!part);
      QCOMPARE(part.error().kind, FailureKind::Refused);
      QCOMPARE(part.error().cause.code, robot::ros::fault::RegionMeansNothing);
    }
    QCOMPARE(server_->timesCalled(text("/d/get_sub_map")), 0);
    QCOMPARE(server_->timesCalled(text("/d/get_sub_point_map")), 0);
  }

  void cloudsAreAskedForAsSpheresAndBoxes() {
    serve("/d/get_sub_point_map", "map_msgs/srv/GetPointMapROI", {{text("sub_map"), cloud()}});
    serve("/d/get_occupancy_map", "map_msgs/srv/GetPointMap", {{text("map"), cloud()}});
    QVERIFY(begin());
    const auto box = askCloud(CloudKind::Points, map::CloudRegion{{1, 2, 3}, 0, {4, 5, 6}});
    QVERIFY(box);
    QCOMPARE((*box)->points.size(), std::size_t(2));
    QCOMPARE((*box)->points[1].x(), 1.0F);
    QVERIFY(askCloud(CloudKind::Points, map::CloudRegion{{1, 2, 3}, 7, {4, 5, 6}}));
    QCOMPARE(server_->argumentsOf(text("/d/get_sub_point_map")),
             (QList{json(R"({"x":1,"y":2,"z":3,"r":0,"l_x":4,"l_y":5,"l_z":6})"),
                    json(R"({"x":1,"y":2,"z":3,"r":7,"l_x":0,"l_y":0,"l_z":0})")}));
    QVERIFY(askCloud(CloudKind::Occupancy, std::nullopt));
    QCOMPARE(askCloud(CloudKind::Points, std::nullopt).error().kind, FailureKind::Unsupported);
  }

  void theTypeTellsWhatAServiceIs_data() {
    QTest::addColumn<QByteArray>("type");
    for (const char* type :
         {"map_msgs/GetMapROI", "map_msg/GetMapROI", "map_msgs/srv/GetMapROI", "map_msg/srv/GetMapROI"})
      QTest::newRow(type) << QByteArray(type);
  }
  void theTypeTellsWhatAServiceIs() {
    QFETCH(QByteArray, type);
    serve("/big/part_of_the_map", type, {{text("sub_map"), grid()}});
    serve("/big/get_sub_map", "std_srvs/Empty", {});  // called so, and something else
    QVERIFY(begin());
    QVERIFY(dispatch());
    QCOMPARE(offerOf(DispatchService::GridRegion).name, std::string("/big/part_of_the_map"));
    QCOMPARE(offerOf(DispatchService::GridRegion).type, type.toStdString());
    QVERIFY(askGrid(kRegion));
  }

  void itComesAndGoesWithItsServices() {
    QVERIFY(begin());
    QVERIFY(!dispatch());
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    QTRY_VERIFY_WITH_TIMEOUT(dispatch(), kPatienceMs);
    serve("/d/get_map", "nav_msgs/GetMap", {{text("map"), grid()}});
    QTRY_VERIFY_WITH_TIMEOUT(dispatch()->offered(DispatchService::Grid), kPatienceMs);
    QVERIFY(askGrid(std::nullopt));
    server_->withdraw(text("/d/get_sub_map"));
    server_->withdraw(text("/d/get_map"));
    // What it has told stays, and nothing more can be asked for.
    QTRY_VERIFY_WITH_TIMEOUT(!dispatch()->offered(DispatchService::GridRegion), kPatienceMs);
    QVERIFY(!dispatch()->offered(DispatchService::Grid));
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    QTRY_VERIFY_WITH_TIMEOUT(dispatch()->offered(DispatchService::GridRegion), kPatienceMs);
  }

  void namesOfTheAddressCount() {
    server_->withdraw(text("/rosapi/service_type"));
    ros::DispatchSettings wish;
    wish.expected = true;
    wish.ns = "/right";
    wish.names[DispatchService::Cloud] = "/elsewhere/points";
    make(wish);
    serve("/right/get_sub_map", "", {{text("sub_map"), grid("[1,2]")}});
    serve("/wrong/get_sub_map", "", {{text("sub_map"), grid("[3,4]")}});
    serve("/elsewhere/points", "", {{text("map"), cloud()}});
    serve("/wrong/get_point_map", "", {});
    QVERIFY(begin());
    QVERIFY(dispatch());
    QCOMPARE(*askGrid(kRegion)->cells, (std::vector<std::int8_t>{1, 2}));
    QVERIFY(askCloud(CloudKind::Points, std::nullopt));
  }

  void withoutRosapiWhatIsNotThereIsFoundOut() {
    for (const char* service : {"/rosapi/topics", "/rosapi/services", "/rosapi/service_type"})
      server_->withdraw(text(service));
    ros::DispatchSettings wish;
    wish.expected = true;
    wish.ns = "/map_dispatcher";
    make(wish);
    serve("/map_dispatcher/get_sub_map", "", {{text("sub_map"), grid()}});
    QVERIFY(begin());
    QVERIFY(dispatch());
    QVERIFY(askGrid(kRegion));
    QVERIFY(dispatch()->offered(DispatchService::Cloud));
    const auto cloud = askCloud(CloudKind::Points, std::nullopt);
    QCOMPARE(cloud.error().kind, FailureKind::Unsupported);
    QTRY_VERIFY_WITH_TIMEOUT(!dispatch()->offered(DispatchService::Cloud), kPatienceMs);
    QVERIFY(dispatch()->offered(DispatchService::GridRegion));
    // What would set something is not asked in order to read it.
    QVERIFY(!askProjections());
    QCOMPARE(server_->timesCalled(text("/map_dispatcher/set_map_projections")), 0);
  }

  void withoutRosapiTheMapIsSavedByItsPrivateName_data() {
    QTest::addColumn<QString>("ns");
    QTest::addColumn<QString>("service");
    QTest::newRow("private") << QString() << text("/map_dispatcher/save_map");
    QTest::newRow("beside the others") << QString() << text("/save_map");
    QTest::newRow("in a namespace") << text("/slam") << text("/slam/map_dispatcher/save_map");
    QTest::newRow("in that of the node") << text("/slam") << text("/slam/save_map");
  }
  void withoutRosapiTheMapIsSavedByItsPrivateName() {
    QFETCH(QString, ns);
    QFETCH(QString, service);
    for (const char* one : {"/rosapi/topics", "/rosapi/services", "/rosapi/service_type"})
      server_->withdraw(text(one));
    ros::DispatchSettings wish;
    wish.expected = true;
    wish.ns = ns.toStdString();
    make(wish);
    server_->serve(service, [](const QJsonObject&) { return QJsonObject(); });
    QVERIFY(begin());
    QVERIFY(dispatch());
    for (const char* name : {"a.png", "b.png"}) {
      const auto saved = outcome<std::string>([&](auto reply) { return dispatch()->save(name, reply); });
      QVERIFY(saved);
    }
    QCOMPARE(server_->timesCalled(service), 2);
    // Where it is not there at all, that is said.
    server_->withdraw(service);
    const auto failed = outcome<std::string>([&](auto reply) { return dispatch()->save("c.png", reply); });
    QCOMPARE(failed.error().kind, FailureKind::Unsupported);
    QTRY_VERIFY_WITH_TIMEOUT(!dispatch()->offered(DispatchService::Save), kPatienceMs);
  }

  // It may be gigabytes: neither lists nor previews ask for it, and nobody listens to it.
  void theWholeMapOfWhoGivesRegionsIsNotAskedForByItself_data() {
    QTest::addColumn<bool>("manager");
    QTest::newRow("alone") << false;
    QTest::newRow("beside a map manager") << true;
  }
  void theWholeMapOfWhoGivesRegionsIsNotAskedForByItself() {
    QFETCH(bool, manager);
    serve("/d/get_map", "nav_msgs/GetMap", {{text("map"), grid()}});
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    server_->latch(text("/map"), grid());
    if (manager) {
      const QJsonObject one{{text("map_id"), text("m1")}, {text("map_name"), text("one")}};
      const auto topic = [&](const char* name, const char* type, const QJsonObject& msg) {
        server_->advertise(text("/map_manager/") + text(name), text("kabam_msgs/") + text(type));
        server_->latch(text("/map_manager/") + text(name), msg);
      };
      topic("current_map_info", "MapInfo", one);
      topic("map_list", "MapList", {{text("maps"), QJsonArray{one}}});
      topic("archived_map_list", "MapList", {{text("maps"), QJsonArray()}});
      serve("/map_manager/load_map", "kabam_msgs/LoadMap", {});
    }
    robot_->liveTopics()->setWanted({map::Stream::WholeMap, map::Stream::Pose}, {});
    QVERIFY(begin());
    QVERIFY(dispatch() && dispatch()->offered(DispatchService::GridRegion));
    const auto listed = outcome<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(listed && !listed->empty());
    for (const map::CatalogueEntry& entry : *listed) {
      QVERIFY(!entry.has_thumbnail);
      const auto preview = outcome<std::string>(
          [&](auto reply) { return robot_->mapCatalogue()->thumbnail(entry.key, reply); });
      QVERIFY(!preview);
      QCOMPARE(preview.error().cause.code, robot::ros::fault::WholeMapNotFetched);
    }
    const int looks = server_->timesCalled(text("/rosapi/topics"));
    QTRY_VERIFY_WITH_TIMEOUT(server_->timesCalled(text("/rosapi/topics")) > looks + 2, kPatienceMs);
    QCOMPARE(server_->timesCalled(text("/d/get_map")), 0);
    QVERIFY(!server_->isAskedFor("/map"));
  }

  void whereThereIsOnlyAMapInSpaceItsFirstProjectionStandsForIt() {
    serve("/d/get_sub_point_map", "map_msgs/GetPointMapROI", {{text("sub_map"), cloud()}});
    for (const char* topic : {"/d/projected_map_0", "/d/projected_map_1"}) {
      server_->advertise(text(topic), text("map_msgs/ProjectedMap"));
      server_->latch(text(topic), projected(0));
    }
    QVERIFY(begin());
    const auto listed = outcome<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(listed && listed->size() == 2);
    QVERIFY(listed->at(0).is_current && !listed->at(1).is_current && listed->at(0).has_thumbnail);
    QCOMPARE(listed->at(0).key.id, std::string("projected_map_0"));
    const auto whole = outcome<map::WholeMap>(
        [&](auto reply) { return robot_->wholeMapSource()->fetch(listed->at(0).key, reply); });
    QVERIFY(whole && whole->grid.width == 2);
  }

  void anAnswerThatCannotBeReadIsAFailure() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid("[0]")}});
    serve("/d/get_point_map", "map_msgs/GetPointMap", {{text("map"), QJsonObject{}}});
    QVERIFY(begin());
    const auto part = askGrid(kRegion);
    QCOMPARE(part.error().kind, FailureKind::MalformedAnswer);
    QCOMPARE(part.error().cause.code, robot::ros::fault::RosLengthDiffers);
    QCOMPARE(askCloud(CloudKind::Points, std::nullopt).error().kind, FailureKind::MalformedAnswer);
  }

  void aRefusalIsToldInTheRobotsWords() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI",
          {{text("refused"), text("service [/d/get_sub_map] responded with an error: b'no map yet'")}});
    QVERIFY(begin());
    const auto part = askGrid(kRegion);
    QCOMPARE(part.error().kind, FailureKind::RejectedByRobot);
    QCOMPARE(part.error().detail, std::string("no map yet"));
    QVERIFY(dispatch()->offered(DispatchService::GridRegion));
  }

  void whatIsCancelledEndsAtOnce() {
    types_[text("/d/get_sub_map")] = text("map_msgs/GetMapROI");
    server_->serve(text("/d/get_sub_map"), [](const QJsonObject&) { return std::optional<QJsonObject>(); });
    QVERIFY(begin());
    std::optional<Outcome<map::GridPart>> ended;
    const Call call =
        dispatch()->grid(kRegion, [&](Outcome<map::GridPart> told) { ended = std::move(told); });
    QTRY_COMPARE_WITH_TIMEOUT(server_->timesCalled(text("/d/get_sub_map")), 1, kPatienceMs);
    call.cancel();
    QTRY_VERIFY_WITH_TIMEOUT(ended.has_value(), kPatienceMs);
    QCOMPARE(ended->error().kind, FailureKind::Cancelled);
  }

  void aRobotThatGoesMeanwhileIsAFailure() {
    types_[text("/d/get_sub_map")] = text("map_msgs/GetMapROI");
    server_->serve(text("/d/get_sub_map"), [](const QJsonObject&) { return std::optional<QJsonObject>(); });
    QVERIFY(begin());
    std::optional<Outcome<map::GridPart>> ended;
    dispatch()->grid(kRegion, [&](Outcome<map::GridPart> told) { ended = std::move(told); });
    QTRY_COMPARE_WITH_TIMEOUT(server_->timesCalled(text("/d/get_sub_map")), 1, kPatienceMs);
    server_->goAway();
    QTRY_VERIFY_WITH_TIMEOUT(ended.has_value(), kPatienceMs);
    QCOMPARE(ended->error().kind, FailureKind::Unreachable);
  }

  void theWholeMapIsNotAskedForByItself() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    serve("/d/get_map", "nav_msgs/GetMap", {{text("map"), grid()}});
    robot_->liveTopics()->setWanted({map::Stream::WholeMap}, {});
    QVERIFY(begin());
    const int looks = server_->timesCalled(text("/rosapi/topics"));
    QTRY_VERIFY_WITH_TIMEOUT(server_->timesCalled(text("/rosapi/topics")) > looks + 3, kPatienceMs);
    QCOMPARE(server_->timesCalled(text("/d/get_map")), 0);
    QVERIFY(askGrid(std::nullopt));
    QCOMPARE(server_->timesCalled(text("/d/get_map")), 1);
  }

  void norIsTheTopicThatBringsAllOfIt() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    server_->advertise(text("/map_updates"), text("map_msgs/OccupancyGridUpdate"));
    server_->latch(text("/map"), grid());
    robot_->liveTopics()->setWanted({map::Stream::WholeMap}, {});
    QVERIFY(begin());
    const int looks = server_->timesCalled(text("/rosapi/topics"));
    QTRY_VERIFY_WITH_TIMEOUT(server_->timesCalled(text("/rosapi/topics")) > looks + 3, kPatienceMs);
    const auto asked = [this](const char* topic) {
      return std::any_of(server_->asked.begin(), server_->asked.end(), [&](const QJsonObject& one) {
        return one[text("op")] == text("subscribe") && one[text("topic")] == text(topic);
      });
    };
    QVERIFY(!asked("/map") && !asked("/map_updates"));
    // Who wants it gets it, once.
    const auto whole = outcome<map::WholeMap>([&](auto reply) {
      return robot_->wholeMapSource()->fetch({map::MapKind::Live, {}}, reply);
    });
    QVERIFY(whole);
    QTRY_VERIFY_WITH_TIMEOUT(asked("/map") && !server_->isAskedFor("/map"), kPatienceMs);
  }

  void aTopicOfTheMapIsLeftOnceItComesByRegion() {
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    server_->latch(text("/map"), grid());
    robot_->liveTopics()->setWanted({map::Stream::WholeMap}, {});
    QVERIFY(begin());
    QTRY_VERIFY_WITH_TIMEOUT(server_->isAskedFor("/map"), kPatienceMs);
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    QTRY_VERIFY_WITH_TIMEOUT(!server_->isAskedFor("/map"), kPatienceMs);
  }

  void theWholeMapIsAskedByTheNameOfTheAddress() {
    ros::DispatchSettings wish;
    wish.expected = true;
    wish.ns = "/d";
    wish.names[DispatchService::Grid] = "/slam/whole";
    make(wish);
    serve("/slam/whole", "nav_msgs/GetMap", {{text("map"), grid()}});
    serve("/static_map", "nav_msgs/GetMap", {{text("map"), grid("[1,1]")}});
    robot_->liveTopics()->setWanted({map::Stream::WholeMap}, {});
    QVERIFY(begin());
    QTRY_COMPARE_WITH_TIMEOUT(server_->timesCalled(text("/slam/whole")), 1, kPatienceMs);
    const auto listed = outcome<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(listed);
    QCOMPARE(listed->at(0).name, std::string("/slam/whole"));
    QVERIFY(listed->at(0).is_current);
    QCOMPARE(server_->timesCalled(text("/static_map")), 0);
  }

  void savingEndsInTheNameThatWasSent() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {});
    serve("/d/save_map", "map_msgs/SaveMap", {});
    QVERIFY(begin());
    const auto save = [this](const std::string& name) {
      return outcome<std::string>([&](auto reply) { return dispatch()->save(name, reply); });
    };
    const auto saved = save("office.png");
    QVERIFY(saved);
    QCOMPARE(*saved, std::string("office.png"));
    QCOMPARE(server_->argumentsOf(text("/d/save_map")), QList{json(R"({"filename":{"data":"office.png"}})")});
    QCOMPARE(save("").error().kind, FailureKind::Refused);
    QCOMPARE(save("").error().cause.code, robot::ros::fault::FileNameMeansNothing);
    QCOMPARE(save("a\nb.png").error().kind, FailureKind::Refused);
    QCOMPARE(server_->timesCalled(text("/d/save_map")), 1);
    serve("/d/save_map", "map_msgs/SaveMap", {{text("refused"), text("disk full")}});
    const auto failed = save("b.png");
    QCOMPARE(failed.error().kind, FailureKind::RejectedByRobot);
    QCOMPARE(failed.error().applied, map::Applied::Maybe);
  }

  void theServiceOfTheRepTellsProjectionsAndSetsNone_data() {
    QTest::addColumn<QByteArray>("member");
    QTest::newRow("REP") << QByteArray("projected_maps_info");
    QTest::newRow("map_msgs") << QByteArray("projected_maps");
  }
  void theServiceOfTheRepTellsProjectionsAndSetsNone() {
    QFETCH(QByteArray, member);
    serve("/d/set_map_projections", "map_msgs/SetMapProjections", infos(member));
    QVERIFY(begin());
    QVERIFY(dispatch()->offered(DispatchService::ReadProjections));
    QVERIFY(!dispatch()->offered(DispatchService::ChangeProjections));
    const auto told = askProjections();
    QVERIFY(told);
    QCOMPARE(*told, std::vector{(Projection{"map", {-1, -2}, {3, 4}, 0.5, 2})});
    QCOMPARE(server_->argumentsOf(text("/d/set_map_projections")), QList{QJsonObject{}});
    QCOMPARE(askProject({}).error().kind, FailureKind::Unsupported);
  }

  void theOneOfMapMsgsSetsThemAndTheTopicsTell() {
    types_[text("/d/set_map_projections")] = text("map_msgs/ProjectedMapsInfo");
    server_->serve(text("/d/set_map_projections"), [this](const QJsonObject&) {
      server_->advertise(text("/d/projected_map_0"), text("map_msgs/ProjectedMap"));
      server_->latch(text("/d/projected_map_0"), projected(0.25));
      return QJsonObject{};
    });
    QVERIFY(begin());
    QVERIFY(dispatch()->offered(DispatchService::ChangeProjections));
    const auto none = askProjections();
    QVERIFY(none && none->empty());
    QCOMPARE(server_->timesCalled(text("/d/set_map_projections")), 0);
    QSignalSpy changed(dispatch(), &MapDispatch::projectedChanged);
    ros::DispatchSettings wish;
    const auto set = askProject({{"map", {1, 2}, {0.1, 0.05}, 0.2, 2}});
    QVERIFY(set);
    QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kPatienceMs);
    QCOMPARE(dispatch()->projected().size(), std::size_t(1));
    QCOMPARE(dispatch()->projected()[0].min_z_m, 0.25);
    const auto told = askProjections();
    QVERIFY(told);
    QCOMPARE(told->size(), std::size_t(1));
    QCOMPARE(told->at(0).min_z_m, 0.25);  // not what was asked for
    QCOMPARE(told->at(0).corner_m, Eigen::Vector2d(1, 2));
    const QJsonObject args = server_->argumentsOf(text("/d/set_map_projections")).at(0);
    QCOMPARE(args[text("projected_maps_info")].toArray().at(0).toObject(),
             json(R"({"frame_id":"map","x":1,"y":2,"width":0.1,"height":0.05,"min_z":0.2,"max_z":2})"));
    QCOMPARE(askProject({{"map", {1, 2}, {0, 1}, 0, 1}}).error().kind, FailureKind::Refused);
    const auto crossed = askProject({{"map", {1, 2}, {1, 1}, 2, 1}});
    QCOMPARE(crossed.error().kind, FailureKind::Refused);
    QCOMPARE(crossed.error().cause.code, robot::ros::fault::ProjectionMeansNothing);
  }

  void projectedMapsComeAndGo() {
    serve("/d/set_map_projections", "map_msgs/SetMapProjections", infos());
    server_->advertise(text("/d/projected_map_1"), text("map_msgs/msg/ProjectedMap"));
    server_->advertise(text("/d/projected_map_x"), text("map_msgs/msg/ProjectedMap"));
    server_->advertise(text("/d/projected_map_2"), text("std_msgs/String"));
    server_->latch(text("/d/projected_map_1"), projected(3));
    QVERIFY(begin());
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(1), kPatienceMs);
    QCOMPARE(dispatch()->projected()[0].index, 1);
    QCOMPARE(dispatch()->projected()[0].max_z_m, 5.0);
    QVERIFY(!server_->isAskedFor("/d/projected_map_x") && !server_->isAskedFor("/d/projected_map_2"));
    server_->forget(text("/d/projected_map_1"));
    server_->advertise(text("/d/projected_map_0"), text("map_msgs/msg/ProjectedMap"));
    QTRY_VERIFY_WITH_TIMEOUT(dispatch()->projected().empty(), kPatienceMs);
  }

  void projectedMapsAreListedAndFetchedLikeMaps() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {});
    server_->advertise(text("/d/projected_map_1"), text("map_msgs/msg/ProjectedMap"));
    server_->latch(text("/d/projected_map_1"), projected(0.5));
    QSignalSpy told(robot_.get(), &Robot::mapsChanged);
    QVERIFY(begin());
    QTRY_VERIFY_WITH_TIMEOUT(dispatch() && dispatch()->projected().size() == 1, kPatienceMs);
    QVERIFY(told.size() > 0);
    const auto listed = outcome<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(listed);
    const map::MapKey key{map::MapKind::Stored, "projected_map_1"};
    const auto entry = std::find_if(listed->begin(), listed->end(),
                                    [&](const map::CatalogueEntry& one) { return one.key == key; });
    QVERIFY(entry != listed->end());
    QCOMPARE(entry->name, std::string("projected_map_1: z 0.50 … 2.50 m"));
    const auto fetched =
        outcome<map::WholeMap>([&](auto reply) { return robot_->wholeMapSource()->fetch(key, reply); });
    QVERIFY(fetched);
    QCOMPARE(fetched->grid.width, 2);
    QCOMPARE(fetched->grid.origin.x_m, 1.0);
    QCOMPARE(*fetched->bytes, std::string("P5\n2 1\n255\n\0d", 13));
    const auto other = outcome<map::WholeMap>([&](auto reply) {
      return robot_->wholeMapSource()->fetch({map::MapKind::Stored, "projected_map_7"}, reply);
    });
    QVERIFY(!other);
    QCOMPARE(other.error().reason, map::FailureReason::NotThere);
  }

  void anotherMapIsToldOfByItsMetadata() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    server_->advertise(text("/map_metadata"), text("nav_msgs/MapMetaData"));
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    const QJsonObject info = grid()[text("info")].toObject();
    server_->latch(text("/map_metadata"), info);
    QVERIFY(begin());
    QSignalSpy changed(dispatch(), &MapDispatch::mapChanged);
    QTRY_VERIFY_WITH_TIMEOUT(server_->isAskedFor("/map_metadata"), kPatienceMs);
    server_->send(text("/map_metadata"), info);  // the same once more
    QJsonObject other = info;
    other[text("width")] = 3;
    server_->latch(text("/map_metadata"), other);
    QTRY_COMPARE_WITH_TIMEOUT(changed.size(), 1, kPatienceMs);
    QVERIFY(!server_->isAskedFor("/map"));  // the whole map nobody wants
  }
  void howLargeTheMapIsIsToldByItsMetadata() {
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid()}});
    server_->advertise(text("/map_metadata"), text("nav_msgs/MapMetaData"));
    QJsonObject info = grid()[text("info")].toObject();
    info[text("width")] = 40'000;
    info[text("height")] = 50'000;
    info[text("resolution")] = 0.05;
    server_->latch(text("/map_metadata"), info);
    QVERIFY(begin());
    QTRY_VERIFY_WITH_TIMEOUT(dispatch() && dispatch()->extent(), kPatienceMs);
    const robot::MapExtent extent = *dispatch()->extent();
    QCOMPARE(extent.grid.width, 40'000);
    QCOMPARE(extent.grid.height, 50'000);
    QCOMPARE(extent.grid.resolution_m, 0.05);
    QCOMPARE(extent.most_bytes, std::int64_t(256) << 20);
    QVERIFY(extent.least_bytes < extent.about_bytes);
    QVERIFY(extent.beyondLink());
    QSignalSpy changed(dispatch(), &MapDispatch::extentChanged);
    info[text("width")] = 4;
    info[text("height")] = 5;
    server_->latch(text("/map_metadata"), info);
    QTRY_COMPARE_WITH_TIMEOUT(changed.size(), 1, kPatienceMs);
    QVERIFY(!dispatch()->extent()->beyondLink());
    // What is no size any more is not the one of before.
    info[text("width")] = 0;
    server_->latch(text("/map_metadata"), info);
    QTRY_COMPARE_WITH_TIMEOUT(changed.size(), 2, kPatienceMs);
    QVERIFY(!dispatch()->extent());
  }
};

}  // namespace test_ros_dispatch

MAPWRIGHT_TEST(test_ros_dispatch, RosDispatchTest, Core)
#include "test_ros_dispatch.moc"
