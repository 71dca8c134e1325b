// Long work beside the pool: its result arrives once and on the GUI thread, or not at all.
#include <future>
#include <memory>
#include <thread>
#include <vector>

#include <QTest>

#include "test_program.h"
#include "ui/kit/background_run.h"

namespace test_background_run {

using namespace mapwright;
using mapwright::ui::BackgroundRun;

namespace {

/// Work that stands still in the middle until it is let go on, and then says whether it was cancelled.
class Held {
 public:
  BackgroundRun::Job job(std::vector<QString>& heard, const QString& name) {
    return [this, &heard, name](const BackgroundRun::Running& run) -> BackgroundRun::Then {
      reached_.set_value();
      may_go_on_.get_future().wait();
      const bool proceeds = run.proceed(1);
      return [&heard, said = name + (proceeds ? QStringLiteral(" done") : QStringLiteral(" cancelled"))] {
        heard.push_back(said);
      };
    };
  }
  void waitUntilReached() { reached_.get_future().wait(); }
  void goOn() { may_go_on_.set_value(); }

 private:
  std::promise<void> reached_, may_go_on_;
};

class BackgroundRunTest : public QObject {
  Q_OBJECT
 private:
  const std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>(1);
  std::vector<QString> heard_;

  /// Whatever was posted by work that is over has arrived.
  void waitForAll() {
    QTRY_COMPARE(workers_->running(), 0);
    QCoreApplication::processEvents();
  }

 private Q_SLOTS:
  void init() { heard_.clear(); }

  void theResultArrivesOnceOnTheThreadOfTheOwner() {
    BackgroundRun run(workers_);
    const std::thread::id mine = std::this_thread::get_id();
    int arrived = 0;
    run.start([&](const auto&) -> BackgroundRun::Then {
      return [&, worked_on = std::this_thread::get_id()] {
        ++arrived;
        QVERIFY(worked_on != mine);
        QCOMPARE(std::this_thread::get_id(), mine);
        QVERIFY(!run.running());
      };
    });
    QVERIFY(run.running());
    waitForAll();
    QCOMPARE(arrived, 1);
    waitForAll();
    QCOMPARE(arrived, 1);
  }

  void workWithoutResultEndsToo() {
    BackgroundRun run(workers_);
    run.start([](const auto&) { return BackgroundRun::Then(); });
    QTRY_VERIFY(!run.running());
  }

  void progressArrivesBeforeTheResult() {
    BackgroundRun run(workers_);
    run.start(
        [&](const BackgroundRun::Running& running) -> BackgroundRun::Then {
          for (int i = 1; i <= 1000; ++i) running.proceed(i * 0.001);
          return [&] { heard_.push_back(QStringLiteral("done")); };
        },
        [&](double done) {
          QVERIFY(run.running());
          heard_.push_back(QString::number(done));
        });
    waitForAll();
    QVERIFY(heard_.size() > 1);
    QCOMPARE(heard_.front(), QStringLiteral("0.001"));
    QCOMPARE(heard_.back(), QStringLiteral("done"));
    QVERIFY2(heard_.size() < 500, "progress is said now and then, not at each step");
  }

  void cancelledWorkRunsUntilItHasSaidSo() {
    BackgroundRun run(workers_);
    Held work;
    run.start(work.job(heard_, QStringLiteral("it")));
    work.waitUntilReached();
    run.cancel();
    QVERIFY(run.running());
    work.goOn();
    waitForAll();
    QVERIFY(!run.running());
    QCOMPARE(heard_, std::vector<QString>{QStringLiteral("it cancelled")});
  }

  void nothingIsHeardOfForgottenWork() {
    BackgroundRun run(workers_);
    Held work;
    run.start(work.job(heard_, QStringLiteral("it")), [&](double) { heard_.push_back(QString()); });
    work.waitUntilReached();
    run.forget();
    QVERIFY(!run.running());
    work.goOn();
    waitForAll();
    QVERIFY(heard_.empty());
  }

  void resultsThatWaitToBeHeardAreForgottenToo() {
    BackgroundRun run(workers_);
    Held work;
    run.start(work.job(heard_, QStringLiteral("it")));
    work.goOn();
    while (workers_->running() > 0) std::this_thread::yield();
    run.forget();
    waitForAll();
    QVERIFY(heard_.empty());
  }

  void startingAgainForgetsWhatRuns() {
    BackgroundRun run(workers_);
    Held first, second;
    run.start(first.job(heard_, QStringLiteral("first")));
    first.waitUntilReached();
    run.start(second.job(heard_, QStringLiteral("second")));
    second.waitUntilReached();
    first.goOn();
    QTRY_COMPARE(workers_->running(), 1);
    QCoreApplication::processEvents();
    QVERIFY(run.running());
    second.goOn();
    waitForAll();
    QCOMPARE(heard_, std::vector<QString>{QStringLiteral("second done")});
  }

  void deletingItCancelsAndWaits() {
    bool ended = false;
    {
      BackgroundRun run(workers_);
      std::promise<void> reached;
      run.start([&](const BackgroundRun::Running& running) -> BackgroundRun::Then {
        reached.set_value();
        while (!running.cancelled) std::this_thread::yield();
        ended = true;
        return [&] { heard_.push_back(QStringLiteral("done")); };
      });
      reached.get_future().wait();
    }
    QVERIFY(ended);
    waitForAll();
    QVERIFY(heard_.empty());
  }

  void theResultMayDeleteTheRun() {
    auto run = std::make_unique<BackgroundRun>(workers_);
    run->start([&](const auto&) -> BackgroundRun::Then { return [&] { run.reset(); }; });
    waitForAll();
    QVERIFY(!run);
  }
};

}  // namespace

}  // namespace test_background_run

MAPWRIGHT_TEST(test_background_run, BackgroundRunTest, Core)
#include "test_background_run.moc"
