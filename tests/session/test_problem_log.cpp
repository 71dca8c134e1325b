#include <QTest>

#include "session/problem_log.h"

using namespace mapwright;
using session::ProblemLog;

class ProblemLogTest : public QObject {
  Q_OBJECT
 private:
  const QDateTime noon_ = QDateTime(QDate(2026, 1, 2), QTime(12, 0), Qt::UTC);
  static map::Problem problem(int i) {
    return {map::Severity::Error, "Submap " + std::to_string(i), "It is gone."};
  }

 private Q_SLOTS:
  void equalProblemsAreCounted() {
    ProblemLog log;
    log.add(problem(1), noon_);
    log.add(problem(1), noon_.addSecs(60));
    log.add(problem(2), noon_);
    QCOMPARE(log.rows().size(), std::size_t(2));
    QCOMPARE(log.rows()[0].count, 2);
    QCOMPARE(log.rows()[0].last, noon_.addSecs(60));
  }

  void recoveryResolvesAndARepetitionReopens() {
    ProblemLog log;
    log.add(problem(1), noon_);
    QCOMPARE(log.unresolved(), 1);
    log.resolve("Submap 1");
    QCOMPARE(log.unresolved(), 0);
    log.add(problem(1), noon_);
    QCOMPARE(log.unresolved(), 1);
  }

  void theLogIsBoundedAndSaysSo() {
    ProblemLog log;
    for (int i = 0; i < int(ProblemLog::kLimit) + 5; ++i) log.add(problem(i), noon_);
    QCOMPARE(log.rows().size(), ProblemLog::kLimit);
    QCOMPARE(log.forgotten(), std::size_t(5));
    QVERIFY(log.toText().endsWith(QStringLiteral("5 older problems are not kept.\n")));
  }

  void theTextHoldsEveryRowAsPlainText() {
    ProblemLog log;
    log.add({map::Severity::Warning, "<b>x</b>", "Odd."}, noon_);
    QCOMPARE(log.toText(), QStringLiteral("2026-01-02T12:00:00Z  warning  <b>x</b>: Odd.\n"));
  }
};

QTEST_GUILESS_MAIN(ProblemLogTest)
#include "test_problem_log.moc"
