#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <QTest>

#include "submap/fetch_scheduler.h"
#include "test_program.h"

namespace test_fetch_scheduler {

using namespace mapwright::submap;
using mapwright::map::SubmapAnswer;
using mapwright::map::SubmapId;
using mapwright::map::SubmapKey;
using Outcome = SubmapAnswer::Outcome;

class FetchSchedulerTest : public QObject {
  Q_OBJECT
 private:
  static FetchScheduler ready(int submaps, SchedulerOptions options = {}) {
    FetchScheduler scheduler(options);
    scheduler.setUuid("u");
    for (int i = 0; i < submaps; ++i) scheduler.want({0, i}, 1);
    return scheduler;
  }
  static Millis ms(int value) { return Millis(value); }

 private Q_SLOTS:
  void nothingGoesOutWithoutASession() {
    FetchScheduler scheduler;
    scheduler.want({0, 0}, 1);
    QVERIFY(scheduler.take(ms(0)).empty());
  }

  void atMostFourAreInProgress() {
    FetchScheduler scheduler = ready(10);
    const auto first = scheduler.take(ms(0));
    QCOMPARE(first.size(), std::size_t(4));
    QVERIFY(scheduler.take(ms(0)).empty());
    scheduler.answered(first[1], Outcome::Ok, 1, ms(1));
    QCOMPARE(scheduler.take(ms(1)).size(), std::size_t(1));
    QCOMPARE(scheduler.inProgress(), 4);
  }

  void everyKeyGoesOutOnce() {
    FetchScheduler scheduler = ready(100);
    std::map<SubmapKey, int> sent;
    for (int round = 0; round < 300; ++round) {
      for (int i = 0; i < 100; ++i) scheduler.want({0, i}, 1);  // every list says the same
      scheduler.listArrived();
      for (const SubmapKey& key : scheduler.take(ms(round * 1000))) {
        ++sent[key];
        scheduler.answered(key, Outcome::Ok, 1, ms(round * 1000));
      }
    }
    QCOMPARE(sent.size(), std::size_t(100));
    for (const auto& [key, times] : sent) QCOMPARE(times, 1);
  }

  void aSupersededVersionStillQueuedIsNeverSent() {
    FetchScheduler scheduler = ready(1);
    scheduler.want({0, 0}, 2);
    const auto keys = scheduler.take(ms(0));
    QCOMPARE(keys.size(), std::size_t(1));
    QCOMPARE(keys[0].version, 2);
  }

  void anAnswerWithANewerVersionCountsAsThatVersion() {
    FetchScheduler scheduler = ready(1);
    const auto keys = scheduler.take(ms(0));
    scheduler.answered(keys[0], Outcome::Ok, 3, ms(1));
    scheduler.want({0, 0}, 3);
    QVERIFY(scheduler.take(ms(5000)).empty());
    scheduler.want({0, 0}, 4);
    QCOMPARE(scheduler.take(ms(6000)).at(0).version, 4);
  }

  void aLowerVersionIsNotAskedForAgain() {
    FetchScheduler scheduler = ready(1);
    scheduler.want({0, 0}, 5);
    scheduler.answered(scheduler.take(ms(0)).at(0), Outcome::Ok, 5, ms(1));
    scheduler.want({0, 0}, 3);
    QVERIFY(scheduler.take(ms(10'000)).empty());
    scheduler.want({0, 0}, 5);
    QVERIFY(scheduler.take(ms(20'000)).empty());
  }

  void a404IsRememberedForItsKeyOnly() {
    FetchScheduler scheduler = ready(1);
    scheduler.answered(scheduler.take(ms(0)).at(0), Outcome::NotFound, 0, ms(1));
    QCOMPARE(scheduler.state({0, 0}), FetchState::Missing);
    scheduler.want({0, 0}, 1);
    scheduler.listArrived();
    QVERIFY(scheduler.take(ms(1'000'000)).empty());
    scheduler.want({0, 0}, 2);
    QCOMPARE(scheduler.take(ms(1'000'000)).at(0).version, 2);
  }

  void aFailureMakesOnlyThatSubmapWait() {
    FetchScheduler scheduler = ready(6);
    const auto keys = scheduler.take(ms(0));
    scheduler.answered(keys[0], Outcome::Failed, 0, ms(10));
    QCOMPARE(scheduler.state(keys[0].id), FetchState::Waiting);
    for (int i = 1; i < 4; ++i) scheduler.answered(keys[std::size_t(i)], Outcome::Ok, 1, ms(10));
    const auto others = scheduler.take(ms(10));
    QCOMPARE(others.size(), std::size_t(2));
    for (const SubmapKey& key : others) {
      QVERIFY(key.id != keys[0].id);
      scheduler.answered(key, Outcome::Ok, 1, ms(20));
    }
    QVERIFY(scheduler.take(ms(3009)).empty());
    const auto due = scheduler.nextDue(ms(3009));
    QVERIFY(due && *due >= ms(3010) && *due <= ms(10 + 3750));
    QCOMPARE(scheduler.take(*due).at(0), keys[0]);
  }

  void anewVersionDoesNotCutTheWaitShort() {
    FetchScheduler scheduler = ready(1);
    scheduler.answered(scheduler.take(ms(0)).at(0), Outcome::Failed, 0, ms(0));
    scheduler.want({0, 0}, 2);
    QVERIFY(scheduler.take(ms(2999)).empty());
    QCOMPARE(scheduler.take(ms(3750)).at(0).version, 2);
  }

  void waitsDoubleUpToAMinute() {
    FetchScheduler scheduler = ready(1);
    Millis now{0};
    std::vector<Millis> waits;
    for (int i = 0; i < 8; ++i) {
      const auto keys = scheduler.take(now);
      QCOMPARE(keys.size(), std::size_t(1));
      scheduler.answered(keys[0], Outcome::Failed, 0, now);
      const Millis due = *scheduler.nextDue(now);
      waits.push_back(due - now);
      now = due;
    }
    QVERIFY(waits[0] >= ms(3000) && waits[0] <= ms(3750));
    QVERIFY(waits[1] >= ms(6000) && waits[1] <= ms(7500));
    QVERIFY(waits[2] >= ms(12000) && waits[2] <= ms(15000));
    QCOMPARE(waits[7], ms(60'000));
    scheduler.answered(scheduler.take(now).at(0), Outcome::Ok, 1, now);
    QCOMPARE(scheduler.failures({0, 0}), 0);
  }

  void aWrongUuidWaitsForTheNextList() {
    FetchScheduler scheduler = ready(1);
    scheduler.answered(scheduler.take(ms(0)).at(0), Outcome::WrongUuid, 0, ms(0));
    QVERIFY(scheduler.take(ms(100'000)).empty());
    QVERIFY(!scheduler.nextDue(ms(100'000)));
    scheduler.listArrived();
    QCOMPARE(scheduler.take(ms(100'000)).size(), std::size_t(1));
  }

  void aNewSessionForgetsTheOldOne() {
    FetchScheduler scheduler = ready(10);
    const auto old_keys = scheduler.take(ms(0));
    scheduler.setUuid("v");
    scheduler.want({0, 0}, 1);
    QVERIFY2(scheduler.take(ms(0)).empty(), "aborted fetches keep their slots until they are answered");
    for (const SubmapKey& key : old_keys) scheduler.answered(key, Outcome::Cancelled, 0, ms(1));
    const auto keys = scheduler.take(ms(1));
    QCOMPARE(keys.size(), std::size_t(1));
    QCOMPARE(keys[0].uuid, std::string("v"));
  }

  void anUnwantedSubmapIsNotSent() {
    FetchScheduler scheduler = ready(3);
    scheduler.unwant({0, 1});
    const auto keys = scheduler.take(ms(0));
    QCOMPARE(keys.size(), std::size_t(2));
    for (const SubmapKey& key : keys) QVERIFY(key.id.index != 1);
  }

  void aSubmapThatComesBackIsNotAskedForTwiceAtOnce() {
    FetchScheduler scheduler = ready(1);
    const auto keys = scheduler.take(ms(0));
    scheduler.unwant({0, 0});
    scheduler.want({0, 0}, 1);
    QVERIFY(scheduler.take(ms(1)).empty());
    scheduler.answered(keys[0], Outcome::Ok, 1, ms(2));
    QVERIFY(scheduler.take(ms(5000)).empty());
  }

  void whatIsNearTheMiddleGoesFirstAndFollowsTheView() {
    SchedulerOptions one;
    one.max_concurrent = 1;
    FetchScheduler scheduler = ready(5, one);
    for (int i = 0; i < 5; ++i) scheduler.place({0, i}, {100.0 * i, 0}, false);
    scheduler.setView({}, {400, 0});
    auto keys = scheduler.take(ms(0));
    QCOMPARE(keys.at(0).id.index, 4);
    scheduler.answered(keys[0], Outcome::Ok, 1, ms(0));
    scheduler.setView({}, {0, 0});
    QCOMPARE(scheduler.take(ms(0)).at(0).id.index, 0);
  }

  void whatIsInViewGoesBeforeWhatIsNearerAndHiddenOnesGoLast() {
    FetchScheduler scheduler = ready(4);
    scheduler.place({0, 0}, {0, 1}, true);
    scheduler.place({0, 1}, {0, 60}, false);    // above the view
    scheduler.place({0, 2}, {300, 0}, false);   // at its side
    scheduler.place({0, 3}, {1000, 0}, false);  // far off
    scheduler.setView({-400, -20, 400, 20}, {0, 0});
    std::vector<int> order;
    for (const SubmapKey& key : scheduler.take(ms(0))) order.push_back(key.id.index);
    QCOMPARE(order, std::vector<int>({2, 1, 3, 0}));
  }

  /// Every one goes out, and never a far one long before a near one.
  void manySubmapsGoOutFromTheMiddleOutwards() {
    SchedulerOptions one;
    one.max_concurrent = 1;
    FetchScheduler scheduler = ready(3000, one);
    std::mt19937 random(5);
    std::map<int, double> distance;
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Vector2d at(double(random() % 2000) - 1000, double(random() % 2000) - 1000);
      distance[i] = at.norm();
      scheduler.place({0, i}, at, false);
    }
    scheduler.setView({}, {0, 0});
    double farthest = 0;
    for (int sent = 0; sent < 3000; ++sent) {
      const auto keys = scheduler.take(ms(sent));
      QCOMPARE(keys.size(), std::size_t(1));
      scheduler.answered(keys[0], Outcome::Ok, 1, ms(sent));
      const double here = distance.at(keys[0].id.index);
      QVERIFY2(here > farthest - 64, qPrintable(QStringLiteral("%1 after %2").arg(here).arg(farthest)));
      farthest = std::max(farthest, here);
    }
    QVERIFY(scheduler.take(ms(1'000'000)).empty());
  }

  /// What is counted on the way is what a count of all would give.
  void countersEqualARecount() {
    std::mt19937 random(11);
    SchedulerOptions options;
    options.max_concurrent = 6;
    FetchScheduler scheduler(options);
    scheduler.setUuid("u");
    std::vector<SubmapKey> in_progress;
    const Outcome outcomes[] = {Outcome::Ok, Outcome::NotFound, Outcome::WrongUuid, Outcome::Failed,
                                Outcome::Cancelled};
    std::set<SubmapId> wanted;
    for (int step = 0; step < 5000; ++step) {
      const Millis now(step * 40);
      const SubmapId id{0, int(random() % 40)};
      switch (random() % 9) {
        case 0:
        case 1:
          scheduler.want(id, int(random() % 4));
          wanted.insert(id);
          break;
        case 2:
          scheduler.unwant(id);
          wanted.erase(id);
          break;
        case 3:
          scheduler.listArrived();
          break;
        case 4:
          scheduler.place(id, {double(random() % 300), double(random() % 300)}, random() % 4 == 0);
          break;
        case 5:
          if (random() % 20 == 0) scheduler.retryNow();
          scheduler.again({"u", id, int(random() % 4)});
          break;
        case 6:
          scheduler.setView({0, 0, 100, 100}, {double(random() % 300), 0});
          break;
        default:
          if (!in_progress.empty()) {
            const std::size_t which = random() % in_progress.size();
            scheduler.answered(in_progress[which], outcomes[random() % 5], int(random() % 4), now);
            in_progress.erase(in_progress.begin() + std::ptrdiff_t(which));
          }
      }
      if (random() % 2 == 0) {
        for (const SubmapKey& key : scheduler.take(now)) in_progress.push_back(key);
      }
      int queued = 0;
      bool settled_1 = scheduler.inProgress() == 0, settled_3 = settled_1;
      for (const SubmapId one : wanted) {
        const FetchState state = scheduler.state(one);
        queued += state == FetchState::Queued;
        const bool pending = state == FetchState::Queued || state == FetchState::Fetching;
        settled_1 = settled_1 && !pending && (state != FetchState::Waiting || scheduler.failures(one) >= 1);
        settled_3 = settled_3 && !pending && (state != FetchState::Waiting || scheduler.failures(one) >= 3);
      }
      QCOMPARE(scheduler.queued(), queued);
      QCOMPARE(scheduler.settled(1), settled_1);
      QCOMPARE(scheduler.settled(3), settled_3);
      QCOMPARE(scheduler.inProgress(), int(in_progress.size()));
    }
  }

  void oneSubmapIsNotQueriedMoreOftenThanTheInterval() {
    FetchScheduler scheduler = ready(1);
    scheduler.answered(scheduler.take(ms(0)).at(0), Outcome::Ok, 1, ms(100));
    scheduler.want({0, 0}, 2);
    QVERIFY(scheduler.take(ms(349)).empty());
    QCOMPARE(*scheduler.nextDue(ms(349)), ms(350));
    QCOMPARE(scheduler.take(ms(350)).size(), std::size_t(1));
  }

  void retryNowForgetsWaitsAndMissingOnes() {
    FetchScheduler scheduler = ready(2);
    const auto keys = scheduler.take(ms(0));
    scheduler.answered(keys[0], Outcome::Failed, 0, ms(0));
    scheduler.answered(keys[1], Outcome::NotFound, 0, ms(0));
    scheduler.retryNow();
    QCOMPARE(scheduler.take(ms(1)).size(), std::size_t(2));
  }

  void everyOutcomeEndsOrIsTriedAgain_data() {
    QTest::addColumn<int>("outcome");
    QTest::addColumn<int>("state");
    QTest::addColumn<bool>("again");       // at the same version, given time
    QTest::addColumn<bool>("after_list");  // or once a new list came
    const auto row = [](const char* name, Outcome outcome, FetchState state, bool again, bool after_list) {
      QTest::newRow(name) << int(outcome) << int(state) << again << after_list;
    };
    row("ok", Outcome::Ok, FetchState::Idle, false, false);
    row("not found", Outcome::NotFound, FetchState::Missing, false, false);
    row("wrong uuid", Outcome::WrongUuid, FetchState::Waiting, false, true);
    row("failed", Outcome::Failed, FetchState::Waiting, true, true);
    row("cancelled", Outcome::Cancelled, FetchState::Queued, true, true);
  }
  void everyOutcomeEndsOrIsTriedAgain() {
    QFETCH(int, outcome);
    QFETCH(int, state);
    FetchScheduler scheduler = ready(1);
    scheduler.answered(scheduler.take(ms(0)).at(0), Outcome(outcome), 0, ms(1));
    QCOMPARE(int(scheduler.state({0, 0})), state);
    // What says that it is queued really goes out some day.
    QTEST(!scheduler.take(ms(100'000)).empty(), "again");
    FetchScheduler listed = ready(1);
    listed.answered(listed.take(ms(0)).at(0), Outcome(outcome), 0, ms(1));
    listed.listArrived();
    QTEST(!listed.take(ms(100'000)).empty(), "after_list");
  }

  void answersNobodyAskedForAreIgnored() {
    FetchScheduler scheduler = ready(1);
    scheduler.answered({"u", {0, 0}, 1}, Outcome::Ok, 1, ms(0));
    QCOMPARE(scheduler.take(ms(0)).size(), std::size_t(1));
  }
};

}  // namespace test_fetch_scheduler

MAPWRIGHT_TEST(test_fetch_scheduler, FetchSchedulerTest, Core)
#include "test_fetch_scheduler.moc"
