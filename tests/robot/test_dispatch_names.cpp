// What of a robot's services and topics is a map dispatcher.
#include <QTest>

#include "robot/ros/dispatch_names.h"
#include "robot/ros/ros_address.h"
#include "test_program.h"

namespace test_dispatch_names {

using namespace mapwright::robot;
using namespace mapwright::robot::ros;
using Service = DispatchService;
using Services = std::vector<Endpoint>;
using Topics = std::vector<Endpoint>;

namespace {

std::string nameOf(const Dispatcher& found, Service service) {
  const auto there = found.serviceOf(service);
  return there ? there->name : std::string();
}

Dispatcher in(const Services& services, const DispatchSettings& wish = {}) {
  return dispatcherIn(services, std::nullopt, wish);
}

}  // namespace

class DispatchNamesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aMapServerIsNoDispatcher() {
    QVERIFY(!in({{"/static_map", "nav_msgs/GetMap"}}).any());
    QVERIFY(!in({{"/get_map", "nav_msgs/GetMap"}, {"/save_map", "map_msgs/SaveMap"}}).any());
    QVERIFY(!in({}).any());
    QVERIFY(!dispatcherIn(std::nullopt, std::nullopt, {}).any());
    // Who says that it is one is believed.
    DispatchSettings wish;
    wish.expected = true;
    QVERIFY(in({{"/get_map", "nav_msgs/GetMap"}}, wish).has(Service::Grid));
  }

  void pointsAndVoxelsHaveOneType() {
    const auto found = in({{"/a/get_sub_occupancy_map", "map_msgs/GetPointMapROI"},
                           {"/a/get_sub_point_map", "map_msgs/GetPointMapROI"},
                           {"/a/occupied_cells", "map_msgs/GetPointMap"}});
    QCOMPARE(nameOf(found, Service::CloudRegion), std::string("/a/get_sub_point_map"));
    QCOMPARE(nameOf(found, Service::OccupancyRegion), std::string("/a/get_sub_occupancy_map"));
    QCOMPARE(nameOf(found, Service::Occupancy), std::string("/a/occupied_cells"));
    QVERIFY(!found.has(Service::Cloud) && !found.has(Service::Grid));
  }

  // REP 130 writes nav_msgs/GetPointMap, map_msg/GetMapROI and private names.
  void theTypesAndNamesOfTheRepAreKnown() {
    for (const char* written : {"nav_msgs/GetPointMap", "map_msgs/GetPointMap", "map_msg/GetPointMap"}) {
      const auto found =
          in({{"/get_point_map", written}, {"/get_occupancy_map", written}, {"/get_map", "nav_msgs/GetMap"}});
      QCOMPARE(nameOf(found, Service::Cloud), std::string("/get_point_map"));
      QCOMPARE(nameOf(found, Service::Occupancy), std::string("/get_occupancy_map"));
      QCOMPARE(nameOf(found, Service::Grid), std::string("/get_map"));
    }
    QCOMPARE(dispatchType("nav_msgs/srv/GetPointMap"), std::string("map_msgs/GetPointMap"));
    QCOMPARE(dispatchType("nav_msgs/GetMap"), std::string("nav_msgs/GetMap"));
    // Also where no types are told; a map manager's own is another one.
    for (const char* save : {"/map_dispatcher/save_map", "/map_manager/save_map"}) {
      const auto found = in({{"/get_sub_map", ""}, {save, ""}});
      QCOMPARE(found.has(Service::Save), QByteArray(save).contains("dispatcher"));
    }
  }

  void aServiceThatIsNotListedIsTriedByItsPrivateNameFirst() {
    using Names = std::vector<std::string>;
    DispatchSettings wish;
    QCOMPARE(namesToTry(wish, Service::Save), (Names{"/map_dispatcher/save_map", "/save_map"}));
    QCOMPARE(namesToTry(wish, Service::Grid), Names{"/get_map"});
    wish.ns = "/slam";
    QCOMPARE(namesToTry(wish, Service::Save), (Names{"/slam/map_dispatcher/save_map", "/slam/save_map"}));
    wish.ns = "/slam/map_dispatcher";
    QCOMPARE(namesToTry(wish, Service::Save), Names{"/slam/map_dispatcher/save_map"});
    wish.names[Service::Save] = "/x";
    QCOMPARE(namesToTry(wish, Service::Save), Names{"/x"});
  }

  void whatIsNearGoesFirst() {
    const Services two{{"/a/get_sub_map", "map_msgs/GetMapROI"}, {"/b/get_sub_map", "map_msgs/GetMapROI"}};
    QCOMPARE(nameOf(in(two), Service::GridRegion), std::string("/a/get_sub_map"));
    DispatchSettings near;
    near.near = "/b";
    QCOMPARE(nameOf(in(two, near), Service::GridRegion), std::string("/b/get_sub_map"));
    DispatchSettings only;
    only.ns = "/c";
    QVERIFY(!in(two, only).any());
  }

  void aSaverOfUnknownTypeIsOneBesideADispatcher() {
    const auto beside = in({{"/d/get_sub_map", "map_msgs/GetMapROI"}, {"/d/save_map", ""}});
    QVERIFY(beside.has(Service::Save));
    const auto apart = in({{"/d/get_sub_map", "map_msgs/GetMapROI"}, {"/map_manager/save_map", ""}});
    QVERIFY(!apart.has(Service::Save));
    const auto other =
        in({{"/d/get_sub_map", "map_msgs/GetMapROI"}, {"/d/save_map", "nav2_msgs/srv/SaveMap"}});
    QVERIFY(!other.has(Service::Save));
  }

  void projectionsAreReadByOneTypeAndSetByTheOther() {
    const auto read = in({{"/d/set_map_projections", "map_msgs/srv/SetMapProjections"}});
    QVERIFY(read.has(Service::ReadProjections) && !read.has(Service::ChangeProjections));
    const auto set = in({{"/d/set_map_projections", "map_msg/ProjectedMapsInfo"}});
    QVERIFY(set.has(Service::ReadProjections) && set.has(Service::ChangeProjections));
    const auto both = in({{"/d/set_map_projections", "map_msgs/SetMapProjections"},
                          {"/d/choose_projections", "map_msgs/ProjectedMapsInfo"}});
    QCOMPARE(nameOf(both, Service::ReadProjections), std::string("/d/set_map_projections"));
    QCOMPARE(nameOf(both, Service::ChangeProjections), std::string("/d/choose_projections"));
  }

  void everyServiceIsOfferedOnce() {
    const auto offers = in({{"/d/get_sub_map", "map_msgs/GetMapROI"}}).offers();
    QCOMPARE(offers.size(), std::size_t(9));
    QCOMPARE(std::count_if(offers.begin(), offers.end(), [](const auto& offer) { return offer.offered; }), 1);
  }

  void onlyWhatMayBeOneIsAskedForItsType() {
    const std::vector<std::string> names{"/rosout/get_loggers",
                                         "/map_manager/load_map",
                                         "/map_manager/get_sub_map",
                                         "/d/part_of_map",
                                         "/other",
                                         std::string(300, 'a') + "/get_map"};
    DispatchSettings wish;
    wish.names[DispatchService::Grid] = "/other";
    const auto asked = likeDispatchServices(names, wish);
    QCOMPARE(asked, (std::vector<std::string>{"/other", "/map_manager/get_sub_map", "/d/part_of_map"}));
    std::vector<std::string> many;
    for (int i = 0; i < 10'000; ++i) many.push_back("/map" + std::to_string(i));
    QVERIFY(likeDispatchServices(many, {}).size() <= 100);
  }

  void projectedMapsAreFoundByTypeAndNumber() {
    const Services services{{"/d/get_point_map", "map_msgs/GetPointMap"}};
    const Topics topics{{"/d/projected_map_0", "map_msgs/ProjectedMap"},
                        {"/d/projected_map_7", "map_msg/msg/ProjectedMap"},
                        {"/d/projected_map_99", "map_msgs/ProjectedMap"},
                        {"/d/projected_map_", "map_msgs/ProjectedMap"},
                        {"/d/projected_map_-1", "map_msgs/ProjectedMap"},
                        {"/d/projected_map_99999999999999999999", "map_msgs/ProjectedMap"},
                        {"/d/projected_map_3", "nav_msgs/OccupancyGrid"},
                        {"/map_metadata", "nav_msgs/MapMetaData"}};
    const auto found = dispatcherIn(services, topics, {});
    QCOMPARE(found.projected.size(), std::size_t(2));
    QVERIFY(found.projected.contains(0) && found.projected.contains(7));
    QCOMPARE(found.metadata.size(), std::size_t(1));
    DispatchSettings wish;
    wish.projected_map = "/x/p";
    QVERIFY(dispatcherIn(services, topics, wish).projected.empty());
    QCOMPARE(projectedTopic(wish, 2), std::string("/x/p_2"));
    wish = {};
    wish.ns = "/d";
    QCOMPARE(projectedTopic(wish, 2), std::string("/d/projected_map_2"));
  }

  void anAddressNamesThem() {
    const Addresses addresses({rosAddressScheme(), rep130AddressScheme()});
    const auto parsed = addresses.parse(
        QStringLiteral("rep130+ws://robot?ns=/map_dispatcher&get_map=/other/name&projected_map=/p"));
    QVERIFY(parsed);
    const DispatchSettings wish = dispatchSettingsOf(*parsed);
    QVERIFY(wish.expected);
    QCOMPARE(wish.ns, std::string("/map_dispatcher"));
    QCOMPARE(wish.names.at(DispatchService::Grid), std::string("/other/name"));
    QCOMPARE(wish.projected_map, std::string("/p"));
    const DispatchSettings usual =
        dispatchSettingsOf(*addresses.parse(QStringLiteral("ros+ws://robot?ns=/r1")));
    QVERIFY(!usual.expected && usual.ns.empty());
    QCOMPARE(usual.near, std::string("/r1"));
    // Without rosapi all of it is tried.
    const auto tried = dispatcherIn(std::nullopt, std::nullopt, wish);
    QCOMPARE(nameOf(tried, Service::Grid), std::string("/other/name"));
    QCOMPARE(nameOf(tried, Service::GridRegion), std::string("/map_dispatcher/get_sub_map"));
  }

  void aRelativeNameInAnAddressLiesInItsNamespace() {
    const Addresses addresses({rep130AddressScheme()});
    const auto named = [&](const char* options) {
      return dispatchSettingsOf(
                 *addresses.parse(QStringLiteral("rep130+ws://robot") + QLatin1String(options)))
          .names.at(DispatchService::GridRegion);
    };
    QCOMPARE(named("?ns=/slam/&get_sub_map=roi"), std::string("/slam/roi"));
    QCOMPARE(named("?get_sub_map=a/roi&ns=/slam"), std::string("/slam/a/roi"));
    QCOMPARE(named("?get_sub_map=roi"), std::string("/roi"));
    QCOMPARE(named("?ns=/slam&get_sub_map=/roi"), std::string("/roi"));
  }
};

}  // namespace test_dispatch_names

MAPWRIGHT_TEST(test_dispatch_names, DispatchNamesTest, Nothing)
#include "test_dispatch_names.moc"
