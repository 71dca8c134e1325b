// One crew for all background work: what is urgent goes first, and owners do not get into each other's way.
#include <atomic>
#include <future>
#include <mutex>
#include <vector>

#include <QTest>

#include "test_program.h"
#include "work/budgets.h"
#include "work/workers.h"

namespace test_workers {

using namespace mapwright::work;

namespace {

/// Keeps a thread busy until it is opened.
class Gate {
 public:
  Tasks::Job job() {
    return [entered = entered_, open = open_.get_future().share()] {
      entered->set_value();
      open.wait();
    };
  }
  void waitUntilReached() { entered_->get_future().wait(); }
  void open() { open_.set_value(); }

 private:
  std::shared_ptr<std::promise<void>> entered_ = std::make_shared<std::promise<void>>();
  std::promise<void> open_;
};

class WorkersTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyJobRunsOnce() {
    const auto workers = std::make_shared<Workers>(3);
    QCOMPARE(workers->threads(), 3);
    std::vector<std::atomic<int>> runs(500);
    Tasks share(workers);
    for (auto& run : runs) share.start(Urgency::Wanted, [&run] { ++run; });
    QVERIFY(share.waitForDone());
    for (const auto& run : runs) QCOMPARE(run.load(), 1);
    QCOMPARE(workers->running() + workers->waiting(), 0);
  }

  void urgentWorkGoesFirstAndEqualsInTheirOrder() {
    const auto workers = std::make_shared<Workers>(1);
    Gate gate;
    Tasks one(workers), other(workers);
    one.start(Urgency::Background, gate.job());
    gate.waitUntilReached();
    std::vector<int> order;  // one thread runs them
    one.start(Urgency::Background, [&] { order.push_back(5); });
    other.start(Urgency::Wanted, [&] { order.push_back(3); });
    one.start(Urgency::Wanted, [&] { order.push_back(4); });
    other.start(Urgency::InView, [&] { order.push_back(1); });
    one.start(Urgency::InView, [&] { order.push_back(2); });
    QCOMPARE(workers->waiting(), 5);
    gate.open();
    QVERIFY(one.waitForDone() && other.waitForDone());
    QVERIFY((order == std::vector{1, 2, 3, 4, 5}));
  }

  void anOwnerDropsOnlyItsOwn() {
    const auto workers = std::make_shared<Workers>(1);
    Gate gate;
    std::atomic<int> mine{0}, others{0};
    Tasks one(workers), other(workers);
    one.start(Urgency::InView, gate.job());
    gate.waitUntilReached();
    for (int i = 0; i < 4; ++i) {
      one.start(Urgency::Wanted, [&] { ++mine; });
      other.start(Urgency::Wanted, [&] { ++others; });
    }
    QCOMPARE(one.waiting(), 4);
    QCOMPARE(one.running(), 1);
    QCOMPARE(one.drop(), 4);
    QVERIFY(!one.waitForDone(std::chrono::milliseconds(0)));  // one still runs
    gate.open();
    QVERIFY(one.waitForDone() && other.waitForDone());
    QCOMPARE(mine.load(), 0);
    QCOMPARE(others.load(), 4);
  }

  void whatAJobHeldIsGoneWhenItIsDone() {
    const auto workers = std::make_shared<Workers>(2);
    Tasks share(workers);
    std::weak_ptr<int> watched;
    {
      auto held = std::make_shared<int>(1);
      watched = held;
      share.start(Urgency::Wanted, [held] {});
    }
    QVERIFY(share.waitForDone());
    QVERIFY(watched.expired());
  }

  void aShareThatGoesAwayWaitsForWhatRunsAndForgetsTheRest() {
    const auto workers = std::make_shared<Workers>(1);
    Gate gate;
    std::atomic<bool> ended{false}, ran{false};
    std::thread opener;
    {
      Tasks share(workers);
      share.start(Urgency::Wanted, [&, wait = gate.job()] {
        wait();
        ended = true;
      });
      gate.waitUntilReached();
      share.start(Urgency::Wanted, [&] { ran = true; });
      share.drop();
      opener = std::thread([&] { gate.open(); });
    }
    QVERIFY(ended && !ran);
    opener.join();
  }

  void longWorkTakesNoThreadOfTheCrew() {
    const auto workers = std::make_shared<Workers>(1);
    Gate gate;
    Tasks map(workers), tiles(workers);
    map.startLong(gate.job());
    gate.waitUntilReached();
    std::atomic<int> made{0};
    for (int i = 0; i < 10; ++i) tiles.start(Urgency::InView, [&] { ++made; });
    QVERIFY(tiles.waitForDone());
    QCOMPARE(made.load(), 10);
    QCOMPARE(workers->running(), 1);
    gate.open();
    QVERIFY(map.waitForDone());
  }

  void budgetsAreSharedOutOfOneSum() {
    QVERIFY(budgetsFrom(0) == budgetsFrom(kLeastBudget));
    for (const std::size_t bytes : {kLeastBudget, kUsualBudget, std::size_t(5) << 30}) {
      const Budgets budgets = budgetsFrom(bytes);
      QVERIFY(budgets.all() <= bytes && budgets.all() > bytes - 24);
      QVERIFY(budgets.textures && budgets.dense && budgets.tiles && budgets.grid_tiles && budgets.unpacked &&
              budgets.regions);
    }
    QCOMPARE(budgetsFrom().tiles, std::size_t(192) << 20);
  }
};

}  // namespace

}  // namespace test_workers

MAPWRIGHT_TEST(test_workers, WorkersTest, Nothing)
#include "test_workers.moc"
