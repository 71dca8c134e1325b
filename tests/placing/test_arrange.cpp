// Groups of waypoints: turned, along a line, in line; and their names.
#include <QtTest>

#include "geometry/pose.h"
#include "placing/arrange.h"
#include "placing/warnings.h"
#include "test_program.h"

namespace test_arrange {

using namespace mapwright;
using namespace mapwright::placing;

namespace {

bool same(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return (a - b).norm() < 1e-9; }
constexpr double kQuarter = geometry::radiansFromDegrees(90);

}  // namespace

class TestArrange : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aGroupTurnsWithItsHeadings() {
    const std::vector<Spot> spots{{{1, 0}, 0.0}, {{3, 0}, geometry::radiansFromDegrees(170)}, {{2, 5}}};
    const auto turned = placing::turned(spots, {2, 0}, kQuarter);
    QVERIFY(same(turned[0].position_m, {2, -1}));
    QVERIFY(same(turned[1].position_m, {2, 1}));
    QVERIFY(same(turned[2].position_m, {-3, 0}));
    QVERIFY(std::abs(*turned[0].yaw_rad - kQuarter) < 1e-9);
    QVERIFY(std::abs(*turned[1].yaw_rad - geometry::radiansFromDegrees(-100)) < 1e-9);
    QVERIFY(!turned[2].yaw_rad);  // what heads nowhere goes on doing so
  }

  void aMirrorTurnsHeadingsToo() {
    const std::vector<Spot> spots{{{1, 0}, 0.0}, {{3, 5}, kQuarter}, {{2, 2}}};
    // About a vertical line: left and right change places.
    auto seen = placing::mirrored(spots, {2, 0}, kQuarter);
    QVERIFY(same(seen[0].position_m, {3, 0}) && same(seen[1].position_m, {1, 5}));
    QVERIFY(std::abs(std::abs(*seen[0].yaw_rad) - 2 * kQuarter) < 1e-9);
    QVERIFY(std::abs(*seen[1].yaw_rad - kQuarter) < 1e-9);
    QVERIFY(!seen[2].yaw_rad && same(seen[2].position_m, {2, 2}));
    // About a horizontal one: up and down.
    seen = placing::mirrored(spots, {0, 1}, 0);
    QVERIFY(same(seen[1].position_m, {3, -3}));
    QVERIFY(std::abs(*seen[1].yaw_rad + kQuarter) < 1e-9);
    // About x = y: x and y change places.
    seen = placing::mirrored(spots, {0, 0}, kQuarter / 2);
    QVERIFY(same(seen[1].position_m, {5, 3}));
    QVERIFY(std::abs(*seen[0].yaw_rad - kQuarter) < 1e-9);
    // Twice is as before.
    seen = placing::mirrored(placing::mirrored(spots, {7, 3}, 0.4), {7, 3}, 0.4);
    for (std::size_t i = 0; i < spots.size(); ++i) QVERIFY(same(seen[i].position_m, spots[i].position_m));
  }

  void eachHeadsTowardsTheNext() {
    const std::vector<Spot> way{{{0, 0}}, {{1, 0}, 2.0}, {{1, 1}}};
    auto heads = placing::headingOn(way, LastHeads::OnAsBefore);
    QVERIFY(std::abs(*heads[0].yaw_rad) < 1e-9);
    QVERIFY(std::abs(*heads[1].yaw_rad - kQuarter) < 1e-9);
    QVERIFY(std::abs(*heads[2].yaw_rad - kQuarter) < 1e-9);
    heads = placing::headingOn(way, LastHeads::BackToFirst);
    QVERIFY(std::abs(*heads[2].yaw_rad + 3 * kQuarter / 2) < 1e-9);
    for (std::size_t i = 0; i < way.size(); ++i) QVERIFY(same(heads[i].position_m, way[i].position_m));
  }

  void whatLiesInOnePlaceHeadsOnTogether() {
    auto heads = placing::headingOn({{{0, 0}}, {{0, 0}}, {{0, 2}}, {{0, 2}}}, LastHeads::OnAsBefore);
    for (const Spot& spot : heads) QVERIFY(std::abs(*spot.yaw_rad - kQuarter) < 1e-9);
    heads = placing::headingOn({{{0, 0}}, {{0, 0}}, {{0, 2}}, {{0, 2}}}, LastHeads::BackToFirst);
    QVERIFY(std::abs(*heads[3].yaw_rad + kQuarter) < 1e-9);
    // Nowhere to go: as they were.
    heads = placing::headingOn({{{1, 1}, 0.5}, {{1, 1}}}, LastHeads::BackToFirst);
    QCOMPARE(*heads[0].yaw_rad, 0.5);
    QVERIFY(!heads[1].yaw_rad);
    QVERIFY(placing::headingOn({}, LastHeads::BackToFirst).empty());
    // A loop that ends where it begins.
    heads = placing::headingOn({{{0, 0}}, {{1, 0}}, {{0, 0}}}, LastHeads::BackToFirst);
    QVERIFY(std::abs(std::abs(*heads[2].yaw_rad) - 2 * kQuarter) < 1e-9);
  }

  void theyAreCountedInTheOrderInWhichTheyLie() {
    using Indices = std::vector<std::size_t>;
    const std::vector<Spot> spots{{{3, 0}}, {{1, 2}}, {{2, 1}}};
    QCOMPARE(placing::orderOf(spots, Order::AsGiven), (Indices{0, 1, 2}));
    QCOMPARE(placing::orderOf(spots, Order::X), (Indices{1, 2, 0}));
    QCOMPARE(placing::orderOf(spots, Order::Y), (Indices{0, 2, 1}));
    // A corridor at an angle, in which x alone would miss the order.
    const std::vector<Spot> corridor{{{0.1, 9}}, {{0.2, 1}}, {{0, 5}}, {{0.3, 0}}};
    QCOMPARE(placing::orderOf(corridor, Order::AlongLine), (Indices{0, 2, 1, 3}));
    const std::vector<Spot> upright{{{2, 9}}, {{2, 1}}, {{2, 5}}};
    QCOMPARE(placing::orderOf(upright, Order::AlongLine), (Indices{1, 2, 0}));
    QVERIFY(placing::orderOf({}, Order::AlongLine).empty());
  }

  void theMiddleStaysWhereItIsHoweverOftenAGroupIsTurned() {
    std::vector<Spot> spots{{{1, 0}}, {{4, 0}}, {{2, 7}}, {{9, 1}}};
    const Eigen::Vector2d middle = middleOf(spots);
    for (int i = 0; i < 24; ++i)
      spots = placing::turned(spots, middleOf(spots), geometry::radiansFromDegrees(15));
    QVERIFY(same(middleOf(spots), middle));
    QVERIFY(same(spots[3].position_m, {9, 1}));
    QCOMPARE(middleOf({}), Eigen::Vector2d(0, 0));
  }

  void aLineHasOneAtItsBeginningAndEverySpacing() {
    const auto spots = alongLine({0, 0}, {0, 1}, 0.25);
    QCOMPARE(spots.size(), std::size_t(5));  // 1 m is four times 25 cm, whatever numbers lose
    QVERIFY(same(spots[0].position_m, {0, 0}) && same(spots[4].position_m, {0, 1}));
    for (const Spot& spot : spots) QVERIFY(std::abs(*spot.yaw_rad - kQuarter) < 1e-9);
    QCOMPARE(alongLine({0, 0}, {0, 0.99}, 0.25).size(), std::size_t(4));
    QCOMPARE(alongLine({0, 0}, {3, 4}, 0.1).size(), std::size_t(51));
    QCOMPARE(alongLine({0, 0}, {1, 0}, 5).size(), std::size_t(1));
  }

  void whatIsNoLineGivesNone() {
    QVERIFY(alongLine({1, 1}, {1, 1}, 0.5).empty());
    QVERIFY(alongLine({0, 0}, {1, 1}, 0).empty());
    QVERIFY(alongLine({0, 0}, {1, 1}, -1).empty());
    QVERIFY(alongLine({0, 0}, {std::nan(""), 1}, 1).empty());
    QVERIFY(alongLine({0, 0}, {1e300, 1e300}, 1e-300).empty());
    QCOMPARE(alongLine({0, 0}, {double(kMostAlongLine) - 1, 0}, 1).size(), kMostAlongLine);
    QVERIFY(alongLine({0, 0}, {double(kMostAlongLine), 0}, 1).empty());
  }

  void theyAreAlignedInTheMiddleOfTheirRange() {
    const auto spots = aligned({{{1, 0}, 0.5}, {{3, 1}}, {{2, 9}}}, Axis::X);
    for (const Spot& spot : spots) QCOMPARE(spot.position_m.x(), 2.0);
    QCOMPARE(spots[2].position_m.y(), 9.0);
    QCOMPARE(spots[0].yaw_rad, std::optional(0.5));
    QVERIFY(aligned({}, Axis::Y).empty());
  }

  void theyAreDistributedInTheirOrder() {
    const auto spots = distributed({{{10, 1}}, {{0, 2}}, {{1, 3}}, {{2, 4}}, {{4, 5}}}, Axis::X);
    QCOMPARE(spots[0].position_m, Eigen::Vector2d(10, 1));
    QCOMPARE(spots[1].position_m, Eigen::Vector2d(0, 2));
    QCOMPARE(spots[2].position_m, Eigen::Vector2d(2.5, 3));
    QCOMPARE(spots[4].position_m, Eigen::Vector2d(7.5, 5));
    const std::vector<Spot> two{{{0, 0}}, {{1, 0}}};
    QCOMPARE(distributed(two, Axis::Y), two);
  }

  void namesThatTwoBearAreFound() {
    QCOMPARE(namesTwice({"Dock", "Gate", "Dock", "Rack", "Dock"}), std::set<std::string>{"Dock"});
    QVERIFY(namesTwice({"Dock", "Gate", "dock"}).empty());
    QVERIFY(namesTwice({"", "", "Gate"}).empty());  // no name is none that is borne twice
  }

  void theNextNameIsFree() {
    std::set<std::string> taken{"Dock", "Rack 3", "Rack 4", "A7"};
    QCOMPARE(nextName("Dock", taken), std::string("Dock 2"));
    QCOMPARE(nextName("Dock", taken), std::string("Dock 3"));
    QCOMPARE(nextName("Rack 3", taken), std::string("Rack 5"));
    QCOMPARE(nextName("A7", taken), std::string("A7 2"));
    QCOMPARE(nextName("42", taken), std::string("42 2"));
    QCOMPARE(nextName("x 99999999999999999999", taken), std::string("x 99999999999999999999 2"));
  }
};

}  // namespace test_arrange

MAPWRIGHT_TEST(test_arrange, TestArrange, Nothing)
#include "test_arrange.moc"
