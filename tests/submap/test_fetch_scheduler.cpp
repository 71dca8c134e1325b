#include <map>

#include <QTest>

#include "submap/fetch_scheduler.h"

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

  void atMostFourAreUnderWay() {
    FetchScheduler scheduler = ready(10);
    const auto first = scheduler.take(ms(0));
    QCOMPARE(first.size(), std::size_t(4));
    QVERIFY(scheduler.take(ms(0)).empty());
    scheduler.answered(first[1], Outcome::Ok, 1, ms(1));
    QCOMPARE(scheduler.take(ms(1)).size(), std::size_t(1));
    QCOMPARE(scheduler.underWay(), 4);
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

  void theOrderFollowsThePriorityAndItsChanges() {
    SchedulerOptions one;
    one.max_concurrent = 1;
    FetchScheduler scheduler = ready(5, one);
    double center = 4;
    scheduler.setPriority([&](SubmapId id) { return std::abs(id.index - center); });
    auto keys = scheduler.take(ms(0));
    QCOMPARE(keys.at(0).id.index, 4);
    scheduler.answered(keys[0], Outcome::Ok, 1, ms(0));
    center = 0;
    scheduler.reorder();
    QCOMPARE(scheduler.take(ms(0)).at(0).id.index, 0);
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

QTEST_GUILESS_MAIN(FetchSchedulerTest)
#include "test_fetch_scheduler.moc"
