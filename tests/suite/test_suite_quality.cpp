// The SLAM session behind a view, held against its limits: places are named, and figures beside those before.
#include <QTest>

#include "suite/quality.h"
#include "test_program.h"

namespace test_suite_quality {

using namespace mapwright;
using suite::Verdict;
using suite::ViewOutcome;

namespace {

map::Closure closure(map::ConstraintKind kind, double residual_m) {
  map::Closure made;
  made.submap = {0, 4};
  made.node = {1, 512};
  made.kind = kind;
  made.residual_m = residual_m;
  made.at = {12.4, -3.1};
  made.expected = {12.0, -3.1};
  return made;
}

/// Two INTER of 0.75 and 0.5 m, behind an INTRA that is larger.
suite::Examined examined() {
  map::Closures closures;
  closures.ranked = {closure(map::ConstraintKind::Intra, 2), closure(map::ConstraintKind::Inter, 0.75),
                     closure(map::ConstraintKind::Inter, 0.5)};
  closures.inter = 2;
  closures.intra = 1;
  return {std::make_shared<const map::Closures>(closures),
          suite::DisagreementFact{4, 1000, 24},
          {{{12.5, -3.5}, 23, {{0, 1}, {0, 4}}}, {{1.5, 0.5}, 1, {{0, 1}, {0, 2}}}},
          {}};
}

ViewOutcome judged(const suite::Quality& limits, const suite::Examined& examined,
                   Verdict verdict = Verdict::AsExpected, const std::optional<suite::Facts>& before = {}) {
  ViewOutcome outcome;
  outcome.verdict = verdict;
  suite::judgeQuality(limits, examined, before, outcome);
  return outcome;
}

}  // namespace

class SuiteQualityTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void onlyLargerIsOver_data() {
    QTest::addColumn<double>("closures");
    QTest::addColumn<double>("share");
    QTest::addColumn<bool>("held");
    QTest::newRow("both at their limits") << 0.75 << 0.024 << true;
    QTest::newRow("a closure") << 0.7499 << 0.024 << false;
    QTest::newRow("the share") << 0.75 << 0.0239 << false;
    QTest::newRow("both") << 0.0 << 0.0 << false;
  }
  void onlyLargerIsOver() {
    QFETCH(double, closures);
    QFETCH(double, share);
    QFETCH(bool, held);
    const ViewOutcome outcome = judged({closures, 0, share}, examined());
    QCOMPARE(outcome.verdict, held ? Verdict::AsExpected : Verdict::OverLimit);
    QCOMPARE(outcome.worst_closures.isEmpty(), closures >= 0.75);
    QCOMPARE(outcome.worst_squares.isEmpty(), share >= 0.024);
  }

  void theWorstPlacesAreNamed() {
    const ViewOutcome outcome = judged({0.6, 0, 0.02}, examined());
    QCOMPARE(outcome.worst_closures,
             QStringList{QString::fromUtf8("0.75 m and 0°: submap 0-4, node 1-512 at (12.4, -3.1), by the "
                                           "closure at (12.0, -3.1)")});
    QCOMPARE(outcome.worst_squares, (QStringList{QStringLiteral("23 cells at (12.5, -3.5), submaps 0-1 0-4"),
                                                 QStringLiteral("1 cell at (1.5, 0.5), submaps 0-1 0-2")}));
    const QString percent =
        QStringLiteral("Submaps contradict each other in 2.4 % of the occupied cells, more than 2 %.");
    QCOMPARE(outcome.sentence.split(QLatin1Char('\n')).value(1), percent);
    const QStringList lines = suite::linesOf(QStringLiteral("hall: over a limit"), outcome);
    QCOMPARE(lines[0], QStringLiteral("hall: over a limit"));
    QCOMPARE(lines[2], QStringLiteral("  ") + percent);
    for (const QString& place : outcome.worst_closures + outcome.worst_squares)
      QVERIFY2(lines.contains(QStringLiteral("    ") + place), qPrintable(lines.join(QLatin1Char('\n'))));
    QVERIFY2(outcome.sentence.contains(QStringLiteral("by more than 0.6 m: 1 of 2.")),
             qPrintable(outcome.sentence));
  }

  void theChangeIsShownWhereTheLimitHolds() {
    suite::Facts before;
    before.closures = suite::ClosuresFact{2, 0.25};
    before.disagreement = suite::DisagreementFact{4, 1000, 8};
    const ViewOutcome outcome = judged({1, 0, 1}, examined(), Verdict::AsExpected, before);
    QCOMPARE(outcome.verdict, Verdict::AsExpected);
    QCOMPARE(outcome.sentence,
             QStringLiteral("SLAM session: loop closures 2, largest residual 0.25 m -> 0.75 m, "
                            "share 0.8 % -> 2.4 %, contradicted cells 8 -> 24, "
                            "occupied cells 1,000, tolerance in cells 4."));
  }

  void whatCouldNotBeExaminedFails() {
    suite::Examined none;
    none.lacks = {QStringLiteral("There is no pose graph here.")};
    const ViewOutcome outcome = judged({0.5, 0, {}}, none);
    QCOMPARE(outcome.verdict, Verdict::Failed);
    QCOMPARE(outcome.sentence, none.lacks.first());
  }

  void otherVerdictsStayAndTheirSentenceComesFirst() {
    for (const Verdict verdict : {Verdict::Differs, Verdict::NotExpectedYet, Verdict::Failed}) {
      ViewOutcome outcome;
      outcome.verdict = verdict;
      outcome.sentence = QStringLiteral("Why.");
      suite::judgeQuality({0, 0, 0}, examined(), {}, outcome);
      QCOMPARE(outcome.verdict, verdict);
      QVERIFY(outcome.sentence.startsWith(QStringLiteral("Why.\nLoop closures")));
    }
  }

  void aSessionWithoutClosuresSaysSo() {
    suite::Examined one = examined();
    one.closures = std::make_shared<const map::Closures>();
    const ViewOutcome outcome = judged({0.0, 0, {}}, one);
    QCOMPARE(outcome.verdict, Verdict::AsExpected);
    QCOMPARE(outcome.sentence,
             QStringLiteral("No loop was closed, so there is nothing to hold against the limit of 0 m.\n"
                            "SLAM session: loop closures 0, largest residual none."));
  }

  void fewerClosuresThanWantedAreOverTheLimit() {
    suite::Quality limits{1, 2, {}};
    QCOMPARE(judged(limits, examined()).verdict, Verdict::AsExpected);
    limits.closures_at_least = 3;
    const ViewOutcome outcome = judged(limits, examined());
    QCOMPARE(outcome.verdict, Verdict::OverLimit);
    QVERIFY(outcome.sentence.startsWith(QStringLiteral("Loop closures: 2, at least 3 are wanted.\n")));
    QCOMPARE(outcome.figures[0].limit, QStringLiteral("at least 3"));
  }

  void constraintsThatAreNotRankedAreCounted() {
    suite::Examined one = examined();
    map::Closures closures = *one.closures;
    closures.dangling = 3;
    one.closures = std::make_shared<const map::Closures>(closures);
    QVERIFY(
        judged({1, 0, {}}, one).sentence.contains(QStringLiteral("constraints that could not be judged 3")));
  }

  void onlyTheWorstAreListed() {
    suite::Examined many = examined();
    map::Closures closures;
    for (int i = 0; i < 1000; ++i)
      closures.ranked.push_back(closure(map::ConstraintKind::Inter, 10 - i * 0.001));
    closures.inter = 1000;
    many.closures = std::make_shared<const map::Closures>(closures);
    const ViewOutcome outcome = judged({1, 0, {}}, many);
    QCOMPARE(outcome.worst_closures.size(), 20);
    QVERIFY(outcome.worst_closures.first().startsWith(QStringLiteral("10 m")));
    QCOMPARE(suite::linesOf(QString(), outcome).size(), 7);  // head, two sentences, title, three places
    QVERIFY2(outcome.sentence.size() < 600, qPrintable(outcome.sentence));
    QVERIFY(outcome.sentence.contains(QStringLiteral("1,000 of 1,000")));
  }
};

}  // namespace test_suite_quality

MAPWRIGHT_TEST(test_suite_quality, SuiteQualityTest, Core)
#include "test_suite_quality.moc"
