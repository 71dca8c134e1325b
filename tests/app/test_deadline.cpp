// The end of a command's time comes whatever the main thread does, and not when the command was in time.
#include <atomic>

#include <QTest>

#include "app/deadline.h"

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

  void startAndGraceTogetherAreLessThanASecond_data() {
    QTest::addColumn<double>("before_s");
    for (const double before_s : {0.0, 0.1, 0.3, 0.5}) QTest::addRow("%g s", before_s) << before_s;
  }
  void startAndGraceTogetherAreLessThanASecond() {
    QFETCH(double, before_s);
    const app::Grace grace = app::graceAfter(before_s);
    QVERIFY(before_s + grace.end_s < 0.7);  // the rest is for the system to end the process
    QVERIFY(grace.draw_s > 0.05 && grace.draw_s < grace.end_s);
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

QTEST_GUILESS_MAIN(DeadlineTest)
#include "test_deadline.moc"
