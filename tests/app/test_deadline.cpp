// The end of a command's time comes whatever the main thread does, and not when the command was in time.
#include <atomic>

#include <QTest>

#include "app/deadline.h"
#include "test_program.h"

namespace test_deadline {

using namespace mapwright;

class DeadlineTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aBusyMainThreadDoesNotPutItOff() {
    std::atomic<int> ended = 0;
    const app::Deadline deadline(
        std::chrono::steady_clock::now(), [] { return 7; }, [&](int code) { ended = code; });
    while (ended == 0) {
    }  // no event loop, no mercy
    QCOMPARE(ended.load(), 7);
  }

  void theLastWordsAreTheLatest() {
    std::atomic<int> ended = 0;
    std::atomic<bool> may_speak = false;
    {
      app::Deadline deadline(
          app::later(std::chrono::steady_clock::now(), 0.05), [] { return 3; },
          [&](int code) { ended = code; });
      deadline.setLastWords([&] {
        while (!may_speak) {
        }
        return 1;
      });
      may_speak = true;
      QTRY_COMPARE(ended.load(), 1);
    }
  }

  void loadingTheProgramCountsAndALifeBeforeDoesNot_data() {
    QTest::addColumn<double>("timeout_s");
    QTest::addColumn<double>("age_s");
    QTest::addColumn<bool>("counts");
    QTest::newRow("loaded at once") << 10.0 << 0.1 << true;
    QTest::newRow("a busy machine") << 10.0 << 1.5 << true;
    QTest::newRow("a shell that became this") << 10.0 << 900.0 << false;
    QTest::newRow("longer than the time itself") << 0.5 << 0.7 << false;
  }
  void loadingTheProgramCountsAndALifeBeforeDoesNot() {
    QFETCH(double, timeout_s);
    QFETCH(double, age_s);
    QFETCH(bool, counts);
    const app::SteadyTime now = std::chrono::steady_clock::now();
    const app::CommandStart start = app::commandStart(timeout_s, age_s, now);
    QVERIFY(start.begun == (counts ? app::later(now, -age_s) : now));
    // The rest of the second is for the system to end the process.
    QVERIFY(start.grace.draw_s > 0 && start.grace.draw_s < start.grace.end_s && start.grace.end_s < 0.5);
  }
  void aProcessKnowsItsAge() {
    const double before = app::processAge();
    QVERIFY(before >= 0 && before < 3600);
    QTRY_VERIFY(app::processAge() > before);
  }

  void whatIsInTimeIsLeftAlone() {
    std::atomic<int> ended = 0;
    {
      const app::Deadline deadline(
          app::later(std::chrono::steady_clock::now(), 3600), [] { return 1; },
          [&](int code) { ended = code; });
    }
    QCOMPARE(ended.load(), 0);
  }
};

}  // namespace test_deadline

MAPWRIGHT_TEST(test_deadline, DeadlineTest, Core)
#include "test_deadline.moc"
