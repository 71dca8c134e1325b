// The service for submaps: what it counts on the way is what a count of everything would give.
#include <future>
#include <random>
#include <set>
#include <utility>

#include <QTest>

#include "../cells/scratch_files.h"
#include "cells/cell_texture.h"
#include "session/submaps.h"
#include "test_program.h"

namespace test_submaps {

using namespace mapwright;
using map::SubmapAnswer;
using map::SubmapId;
using session::SubmapCounts;
using session::Submaps;
using session::SubmapStatus;
using Outcome = SubmapAnswer::Outcome;

namespace {

class AskedSource : public robot::SubmapSource {
 public:
  robot::Call fetch(const map::SubmapKey& key, Reply reply) override {
    asked.emplace_back(key, std::move(reply));
    return {};
  }
  void cancel(const map::SubmapKey&) override {}
  void cancelAll() override {}  // the test does it when it answers
  void discard(const map::SubmapKey&, std::int32_t) override {}

  /// `kind` of a good answer: 0 one slice, 1 two, 2 none, 3 a corrupt one.
  static void answer(const map::SubmapKey& key, const Reply& reply, Outcome outcome, int kind) {
    SubmapAnswer answer;
    answer.key = key;
    answer.outcome = outcome;
    answer.version = key.version;
    answer.reason = fault::said("no");
    for (int i = 0; i < (kind == 1 ? 2 : kind == 2 ? 0 : 1); ++i) {
      map::RawSlice slice;
      slice.width = slice.height = 8;
      slice.resolution_m = 0.5;
      slice.cells.assign(kind == 3 ? 7 : 64, char(200));
      answer.slices.push_back(slice);
    }
    reply(std::move(answer));
  }

  std::vector<std::pair<map::SubmapKey, Reply>> asked;
};

map::SubmapList randomList(std::mt19937& random, const std::string& uuid, int most) {
  map::SubmapList list;
  list.uuid = uuid;
  for (int i = 0; i < most; ++i) {
    if (random() % 5 == 0) continue;
    map::SubmapEntry entry;
    entry.id = {int(random() % 2), i};
    entry.version = int(random() % 4);
    entry.pose = geometry::poseFromYaw(double(random() % 50), double(random() % 50), 0.3);
    if (random() % 9 == 0) entry.pose.qw = entry.pose.qz = 0;
    entry.is_frozen = random() % 2 == 0;
    list.entries.push_back(entry);
  }
  return list;
}

}  // namespace

class SubmapsTest : public QObject {
  Q_OBJECT
 private:
  AskedSource source_;
  submap::Millis now_{0};
  std::unique_ptr<Submaps> submaps_;

  static SubmapCounts recount(const Submaps& submaps) {
    SubmapCounts counts;
    std::set<int> trajectories;
    for (const auto& [id, row] : submaps.store().rows()) {
      ++counts.listed;
      trajectories.insert(id.trajectory);
      counts.hidden += !row.visible;
      const SubmapStatus status = submaps.status(id);
      counts.updating += status == SubmapStatus::Updating;
      if (row.drawable(submaps.slice())) {
        ++counts.held;
        counts.shown += row.visible;
      } else if (status == SubmapStatus::Missing) {
        ++counts.missing;
      } else if (status == SubmapStatus::Waiting) {
        ++counts.failed;
      } else if (status == SubmapStatus::Corrupt || status == SubmapStatus::Unplaced) {
        ++counts.corrupt;
      } else if (status == SubmapStatus::NoSlice) {
        ++counts.without_slice;
      } else {
        ++counts.pending;
      }
    }
    counts.trajectories = int(trajectories.size());
    return counts;
  }

  static geometry::WorldRect boundsByWalk(const Submaps& submaps) {
    geometry::WorldRect drawn, listed;
    for (const auto& [id, row] : submaps.store().rows()) {
      if (!row.visible) continue;
      const geometry::WorldRect bounds = submaps.store().bounds(id, submaps.slice());
      listed.extend(bounds);
      if (row.drawable(submaps.slice())) drawn.extend(bounds);
    }
    return drawn.empty() ? listed : drawn;
  }

 private Q_SLOTS:
  void init() {
    source_.asked.clear();
    now_ = submap::Millis(0);
    submaps_ =
        std::make_unique<Submaps>([this] { return &source_; }, Submaps::Options{}, [this] { return now_; });
    submaps_->setOnline(true);
  }
  void cleanup() { submaps_.reset(); }

  void countersEqualARecountWhateverHappens_data() {
    QTest::addColumn<int>("submaps");
    QTest::addColumn<int>("steps");
    QTest::newRow("few") << 30 << 1500;
    QTest::newRow("so many that lists are compared aside") << 2600 << 40;
  }
  void countersEqualARecountWhateverHappens() {
    QFETCH(int, submaps);
    QFETCH(int, steps);
    std::mt19937 random(submaps);
    std::string uuid = "u";
    for (int step = 0; step < steps; ++step) {
      now_ += submap::Millis(200);
      const auto someId = [&] { return SubmapId{int(random() % 2), int(random()) % submaps}; };
      const int what = int(random() % 20);
      if (what == 0) uuid = "u" + std::to_string(step);
      if (what <= 3) {
        submaps_->onList(randomList(random, uuid, submaps));
      } else if (what <= 12 && !source_.asked.empty()) {
        constexpr Outcome kOutcomes[] = {Outcome::Ok, Outcome::Ok,        Outcome::Ok,
                                         Outcome::Ok, Outcome::NotFound,  Outcome::Failed,
                                         Outcome::Ok, Outcome::WrongUuid, Outcome::Cancelled};
        const auto [key, reply] = source_.asked.front();
        source_.asked.erase(source_.asked.begin());
        const bool old = key.uuid != submaps_->store().uuid();
        AskedSource::answer(key, reply, old ? Outcome::Cancelled : kOutcomes[random() % 9],
                            int(random() % 4));
      } else if (what <= 14) {
        submaps_->setVisible({someId(), someId(), someId()}, random() % 2 == 0);
      } else if (what == 15) {
        submaps_->setSlice(int(random() % 2));
      } else if (what == 16) {
        submaps_->retryNow();
      } else {
        QCoreApplication::processEvents();
      }
      SubmapCounts counted = submaps_->counts();
      QVERIFY(counted.queued >= 0 && counted.fetching <= 4);
      counted.list_received = false;
      counted.queued = counted.fetching = 0;
      counted.texture_bytes = 0;
      QVERIFY2(counted == recount(*submaps_), qPrintable(QStringLiteral("step %1").arg(step)));
      QVERIFY(submaps_->contentBounds() == boundsByWalk(*submaps_));
    }
    QTRY_VERIFY(submaps_->store().listReceived());
  }

  void rowsThatAreToldAreThoseThatChanged() {
    map::SubmapList list;
    list.uuid = "u";
    for (int i = 0; i < 50; ++i) list.entries.push_back({{0, i}, 1, geometry::poseFromYaw(i, 0, 0)});
    submaps_->setOnline(false);  // nothing is asked for, so no row changes by itself
    std::vector<session::TouchedRows> told;
    connect(submaps_.get(), &Submaps::touched, this,
            [&](const session::TouchedRows& rows) { told.push_back(rows); });
    submaps_->onList(list);
    QTRY_COMPARE(told.size(), std::size_t(1));
    QVERIFY2(told[0].all, "a new session");
    list.entries[7].pose.x = 99;
    list.entries.erase(list.entries.begin() + 20);
    submaps_->onList(list);
    QTRY_COMPARE(told.size(), std::size_t(2));
    QVERIFY(!told[1].all);
    QCOMPARE(told[1].ids, std::vector<SubmapId>({{0, 7}, {0, 20}}));
  }

  void aPictureThatIsLostIsFetchedAgain() {
    Submaps::Options options;
    options.texture_bytes = 0;  // everything lies on disk
    submaps_ = std::make_unique<Submaps>([this] { return &source_; }, options, [this] { return now_; });
    submaps_->setOnline(true);
    map::SubmapList list;
    list.uuid = "u";
    list.entries.push_back({{0, 0}, 1, geometry::poseFromYaw(0, 0, 0)});
    submaps_->onList(list);
    const auto answerIt = [this] {
      const auto [key, reply] = source_.asked.at(0);
      source_.asked.clear();
      AskedSource::answer(key, reply, Outcome::Ok, 0);
    };
    answerIt();
    QTRY_COMPARE(submaps_->counts().shown, 1);
    std::vector<SubmapId> placed;
    connect(submaps_.get(), &Submaps::placed, this,
            [&](const std::vector<SubmapId>& ids) { placed.insert(placed.end(), ids.begin(), ids.end()); });
    now_ += submap::Millis(1000);
    test::truncateScratchFiles();
    submaps_->store().find({0, 0})->slices[0].texture->expand(0);  // as a tile does that needs it
    QTRY_COMPARE(source_.asked.size(), std::size_t(1));
    QCOMPARE(placed, std::vector<SubmapId>({{0, 0}}));
    QCOMPARE(submaps_->counts().shown, 0);
    QCOMPARE(submaps_->counts().pending, 1);
    QCOMPARE(submaps_->lost(), 1);
    QVERIFY(!submaps_->settled(1));
    answerIt();
    QTRY_COMPARE(submaps_->counts().shown, 1);
    QCOMPARE(submaps_->lost(), 0);
    QVERIFY(submaps_->settled(1));
  }

  void leavesNoWorkBehindWhenItGoes() {
    const auto workers = std::make_shared<work::Workers>(1);
    std::promise<void> gate;
    work::Tasks other(workers);
    other.start(work::Urgency::InView, [opened = gate.get_future().share()] { opened.wait(); });
    Submaps::Options options;
    options.workers = workers;
    submaps_ = std::make_unique<Submaps>([this] { return &source_; }, options, [this] { return now_; });
    submaps_->setOnline(true);
    map::SubmapList list;
    list.uuid = "u";
    for (int i = 0; i < 3; ++i) list.entries.push_back({{0, i}, 1, geometry::poseFromYaw(0, 0, 0)});
    submaps_->onList(list);
    for (const auto& [key, reply] : source_.asked) AskedSource::answer(key, reply, Outcome::Ok, 0);
    QTRY_COMPARE(workers->waiting(), 3);  // to be decoded, behind the other's job
    submaps_.reset();
    QCOMPARE(workers->waiting(), 0);
    gate.set_value();
    QVERIFY(other.waitForDone());
  }

  void theLastOfManyLongListsHolds() {
    map::SubmapList list;
    list.uuid = "u";
    for (int i = 0; i < 5000; ++i) list.entries.push_back({{0, i}, 1, geometry::poseFromYaw(i, 0, 0)});
    for (int shift = 0; shift < 5; ++shift) {
      for (map::SubmapEntry& entry : list.entries) entry.pose.y = shift;
      submaps_->onList(list);
    }
    QVERIFY2(!submaps_->settled(1), "a list that has come and is not looked at yet is work to do");
    QTRY_VERIFY(submaps_->store().find({0, 0}) && submaps_->store().find({0, 0})->entry.pose.y == 4);
    QCOMPARE(submaps_->counts().listed, 5000);
    QCOMPARE(submaps_->store().find({0, 4999})->entry.pose.y, 4.0);
  }
};

}  // namespace test_submaps

MAPWRIGHT_TEST(test_submaps, SubmapsTest, Core)
#include "test_submaps.moc"
