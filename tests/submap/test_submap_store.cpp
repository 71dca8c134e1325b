#include <cmath>

#include <QTest>

#include "cells/cell_texture.h"
#include "submap/faults.h"
#include "submap/submap_store.h"
#include "test_program.h"

namespace test_submap_store {

using namespace mapwright;
using submap::DecodedSubmap;
using submap::SubmapChange;
using submap::SubmapStore;

namespace {

map::SubmapEntry entry(int trajectory, int index, int version, double x = 0, double yaw = 0) {
  map::SubmapEntry e;
  e.id = {trajectory, index};
  e.version = version;
  e.pose = geometry::poseFromYaw(x, 0, yaw);
  return e;
}

map::SubmapList listOf(std::vector<map::SubmapEntry> entries, const std::string& uuid = "u") {
  map::SubmapList list;
  list.uuid = uuid;
  list.slam_state = map::SlamState::Slam;
  list.entries = std::move(entries);
  return list;
}

/// A 10 x 20 texture of 0.1 m cells whose cells all hold `value`.
DecodedSubmap decoded(map::SubmapId id, int version, std::uint8_t value = 7, const std::string& uuid = "u") {
  map::SubmapAnswer answer;
  answer.key = {uuid, id, version};
  answer.version = version;
  map::RawSlice slice;
  slice.width = 10;
  slice.height = 20;
  slice.resolution_m = 0.1;
  slice.cells.assign(10 * 20 * 2, 0);
  for (std::size_t i = 0; i < slice.cells.size(); i += 2) slice.cells[i] = char(value);
  answer.slices.push_back(slice);
  return submap::decode(answer);
}

}  // namespace

class SubmapStoreTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aListAddsAndRemovesSubmaps() {
    SubmapStore store;
    QVERIFY(store.apply(listOf({entry(0, 0, 1), entry(0, 1, 1)})).new_session);
    QCOMPARE(store.rows().size(), std::size_t(2));
    const SubmapChange change = store.apply(listOf({entry(0, 1, 1)}));
    QVERIFY(!change.new_session && change.set_changed);
    QCOMPARE(change.removed, std::vector<map::SubmapId>({{0, 0}}));
  }

  void aMovedPoseMovesThePictureWithoutANewVersion() {
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 1, 5)}));
    store.commit(decoded({0, 0}, 1));
    const auto before = store.placement({0, 0}, 0);
    const SubmapChange change = store.apply(listOf({entry(0, 0, 1, 6, 0.5)}));
    QCOMPARE(change.placed, std::vector<map::SubmapId>({{0, 0}}));
    const auto after = store.placement({0, 0}, 0);
    QCOMPARE(after->texture.get(), before->texture.get());
    QCOMPARE(after->world_from_texture.x_m, 6.0);
    QVERIFY(store.apply(listOf({entry(0, 0, 1, 6, 0.5)})).placed.empty());
  }

  void theOldPictureStaysUntilTheNewOneIsCommitted() {
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 1)}));
    store.commit(decoded({0, 0}, 1, 1));
    store.apply(listOf({entry(0, 0, 2)}));
    QCOMPARE(int(store.placement({0, 0}, 0)->texture->at(0, 0).value), 1);
    store.commit(decoded({0, 0}, 2, 2));
    QCOMPARE(int(store.placement({0, 0}, 0)->texture->at(0, 0).value), 2);
  }

  void aLateOlderAnswerIsDropped() {
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 3)}));
    store.commit(decoded({0, 0}, 3, 3));
    QVERIFY(store.commit(decoded({0, 0}, 2, 2)).placed.empty());
    QCOMPARE(int(store.placement({0, 0}, 0)->texture->at(0, 0).value), 3);
  }

  void anAnswerOfAnotherSessionIsDropped() {
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 1)}));
    QVERIFY(store.commit(decoded({0, 0}, 1, 1, "other")).placed.empty());
    QVERIFY(store.commit(decoded({5, 5}, 1)).placed.empty());
  }

  void aNewUuidDropsEverything() {
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 1)}));
    store.commit(decoded({0, 0}, 1));
    QVERIFY(store.find({0, 0})->texture_bytes > 0);
    QVERIFY(store.apply(listOf({entry(0, 0, 1)}, "v")).new_session);
    QCOMPARE(store.find({0, 0})->texture_bytes, std::size_t(0));
    QVERIFY(!store.placement({0, 0}, 0));
  }

  void aBadPoseCostsOnlyItself() {
    SubmapStore store;
    auto broken = entry(0, 0, 1), zero = entry(0, 1, 1), far = entry(0, 2, 1, 1e9);
    broken.pose.x = std::nan("");
    zero.pose = {0, 0, 0, 0, 0, 0, 0};
    const SubmapChange change = store.apply(listOf({broken, zero, far, entry(0, 3, 1)}));
    QCOMPARE(change.problems.size(), std::size_t(3));
    QVERIFY(change.problems[1] == (map::Problem{map::Severity::Error,
                                                map::subjectOf(map::SubmapId{0, 1}),
                                                {submap::fault::VersionCannotBePlaced,
                                                 {1},
                                                 {submap::fault::TurnIsZero},
                                                 Consequence::ShownWithoutIt},
                                                map::ProblemCode::Unplaced}));
    QVERIFY(!store.find({0, 0})->pose_usable);
    QVERIFY(store.find({0, 3})->pose_usable);
    QVERIFY2(store.apply(listOf({broken, zero, far, entry(0, 3, 1)})).problems.empty(),
             "said once, not at every list");
  }

  void aPoseThatTurnsBadLeavesTheSubmapWhereItWas() {
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 1, 4)}));
    store.commit(decoded({0, 0}, 1));
    auto broken = entry(0, 0, 1);
    broken.pose.qw = std::nan("");
    QCOMPARE(store.apply(listOf({broken})).problems.size(), std::size_t(1));
    QCOMPARE(store.placement({0, 0}, 0)->world_from_texture.x_m, 4.0);
  }

  void aDuplicateCountsOnceAndTheHighestUsableVersionWins() {
    SubmapStore store;
    auto unusable = entry(0, 0, 9);
    unusable.pose.y = std::nan("");
    const SubmapChange change = store.apply(listOf({entry(0, 0, 1), entry(0, 0, 2), unusable}));
    QCOMPARE(store.rows().size(), std::size_t(1));
    QCOMPARE(store.find({0, 0})->entry.version, 2);
    QCOMPARE(change.problems.size(), std::size_t(2));
  }

  void aVersionThatGoesBackKeepsTheNewerPictureUnlessTheRobotInsists() {
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 5)}));
    store.commit(decoded({0, 0}, 5, 5));
    QCOMPARE(store.apply(listOf({entry(0, 0, 3)})).problems.size(), std::size_t(1));
    QVERIFY(store.commit(decoded({0, 0}, 3, 3)).placed.empty());
    QVERIFY(store.apply(listOf({entry(0, 0, 3)})).restarted.empty());
    QCOMPARE(store.apply(listOf({entry(0, 0, 3)})).restarted.size(), std::size_t(1));
    QCOMPARE(store.commit(decoded({0, 0}, 3, 3)).placed.size(), std::size_t(1));
    QCOMPARE(int(store.placement({0, 0}, 0)->texture->at(0, 0).value), 3);
  }

  void aCorruptSliceLeavesTheOthers() {
    map::SubmapAnswer answer;
    answer.key = {"u", {0, 0}, 4};
    answer.version = 4;
    map::RawSlice bad, good, absent, crooked;
    bad.width = bad.height = 160;
    bad.resolution_m = 0.05;
    bad.cells.assign(3200, 'x');
    good.width = good.height = 1;
    good.resolution_m = 0.05;
    good.cells = std::string("\x05\x00", 2);
    crooked = good;
    crooked.slice_pose = {0, 0, 0, 0, 0, 0, 0};
    answer.slices = {bad, good, absent, crooked};
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 4)}));
    const SubmapChange change = store.commit(submap::decode(answer));
    QCOMPARE(change.problems.size(), std::size_t(1));
    const Fault& reason = change.problems[0].reason;
    QVERIFY(reason.code == submap::fault::VersionBroken);
    QVERIFY(reason.arguments == std::vector<FaultArgument>{4});
    QCOMPARE(reason.because.size(), std::size_t(2));
    QVERIFY(reason.because[0].arguments == std::vector<FaultArgument>{0});
    QVERIFY(reason.because[1] == Fault(submap::fault::OneSlice, {3}, {submap::fault::SlicePoseUnusable}));
    QVERIFY(!store.placement({0, 0}, 0));
    QVERIFY(store.placement({0, 0}, 1));
    QVERIFY(!store.placement({0, 0}, 2));
    QVERIFY(!store.placement({0, 0}, 3));
    QVERIFY(!store.placement({0, 0}, 99));
  }

  void boundsFollowTheTextureAxes() {
    // Columns run along -y and rows along -x of the slice: 20 rows and 10 columns of 0.1 m from (5, 0).
    SubmapStore store;
    store.apply(listOf({entry(0, 0, 1, 5)}));
    const geometry::WorldRect point = store.bounds({0, 0}, 0);
    QCOMPARE(point.width(), 0.0);
    store.commit(decoded({0, 0}, 1));
    const geometry::WorldRect rect = store.bounds({0, 0}, 0);
    QVERIFY(std::abs(rect.min_x - 3) < 1e-9 && std::abs(rect.max_x - 5) < 1e-9);
    QVERIFY(std::abs(rect.min_y + 1) < 1e-9 && std::abs(rect.max_y) < 1e-9);
  }
};

}  // namespace test_submap_store

MAPWRIGHT_TEST(test_submap_store, SubmapStoreTest, Core)
#include "test_submap_store.moc"
