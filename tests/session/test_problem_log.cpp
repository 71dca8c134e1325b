#include <QTest>
#include <QTimeZone>

#include "robot/axbot/faults.h"
#include "session/problem_log.h"
#include "test_program.h"

namespace test_problem_log {

using namespace mapwright;
using fault::said;
using map::ProblemCode;
using map::Severity;
using map::Subject;
using map::SubjectKind;
using session::ProblemLog;

class ProblemLogTest : public QObject {
  Q_OBJECT
 private:
  const QDateTime noon_ = QDateTime(QDate(2026, 1, 2), QTime(12, 0), QTimeZone::utc()).toUTC();
  static Subject submap(int i) { return {SubjectKind::Submap, std::to_string(i)}; }
  static map::Problem problem(int i, ProblemCode code = ProblemCode::Unavailable) {
    return {Severity::Error, submap(i), said("It is gone."), code};
  }
  QDateTime after(int s) const { return noon_.addSecs(s); }

 private Q_SLOTS:
  void equalProblemsAreCounted() {
    ProblemLog log;
    log.add(problem(1), noon_);
    log.add(problem(1), after(60));
    log.add(problem(2), noon_);
    QCOMPARE(log.rows().size(), std::size_t(2));
    QCOMPARE(log.rows()[0].count, 2);
    QCOMPARE(log.rows()[0].first, noon_);
    QCOMPARE(log.rows()[0].last, after(60));
  }

  void sentencesThatDifferInNumbersOnlyAreOneRow_data() {
    QTest::addColumn<QString>("one");
    QTest::addColumn<QString>("other");
    QTest::addColumn<bool>("same");
    const auto row = [](const char* name, const char* one, const char* other, bool same) {
      QTest::newRow(name) << QString::fromUtf8(one) << QString::fromUtf8(other) << same;
    };
    row("whole numbers", "A message of 7 bytes.", "A message of 12345 bytes.", true);
    row("grouped", "3,200 bytes of 51,200.", "12 bytes of 1,000,000.", true);
    row("fractions", "0.5 m off.", "12 m off.", true);
    row("signs", "It lies at -3.5.", "It lies at 3.5.", true);
    row("exponents", "Off by 1e-05 m.", "Off by 2.5E+7 m.", true);
    row("versions", "Version v7: no.", "Version v70: no.", true);
    row("at the end", "It answered 500", "It answered 404", true);
    row("another word", "Row 7 is odd.", "Row 7 is even.", false);
    row("one number more", "Row 7 is odd.", "Row 7 8 is odd.", false);
    row("a dash is no sign", "1-593 is odd.", "1593 is odd.", false);
    row("a number less", "Row 7 is odd.", "Row is odd.", false);
    row("not ASCII", "Größe 7", "Größe 8", true);
  }
  void sentencesThatDifferInNumbersOnlyAreOneRow() {
    QFETCH(QString, one);
    QFETCH(QString, other);
    QFETCH(bool, same);
    ProblemLog log;
    log.add({Severity::Warning, "x", said(one.toStdString())}, noon_);
    log.add({Severity::Warning, "x", said(other.toStdString())}, after(1));
    QCOMPARE(log.rows().size(), std::size_t(same ? 1 : 2));
    QVERIFY(log.rows().back().problem.reason == said(other.toStdString()));  // the newest numbers
  }

  void aRowIsASubjectWithACodeAndAReason() {
    const Subject topic(SubjectKind::Topic, "/x");
    const map::Problem first{
        Severity::Warning, topic, {robot::axbot::fault::MessageNotJson, {7}}, ProblemCode::Unreadable};
    map::Problem numbers = first, reason = first, code = first, subject = first, cause = first;
    numbers.reason.arguments = {12'345};
    reason.reason.code = robot::axbot::fault::BinaryTooShort;
    code.code = ProblemCode::Odd;
    subject.subject.id = "/y";
    cause.reason.because = {said("the disk is full")};
    ProblemLog log;
    for (const map::Problem& each : {first, numbers, reason, code, subject, cause}) log.add(each, noon_);
    QCOMPARE(log.rows().size(), std::size_t(5));
    QCOMPARE(log.rows()[0].count, 2);
  }

  void requestsThatFailAlikeAreOneRow() {
    map::Failure failure{.kind = map::FailureKind::RejectedByRobot,
                         .subject = Subject(SubjectKind::Map, "12"),
                         .robot_code = "500",
                         .detail = "boom 1"};
    ProblemLog log;
    log.add(map::problemOf(failure), noon_);
    failure.detail = "boom 2";
    log.add(map::problemOf(failure), noon_);
    QCOMPARE(log.rows().size(), std::size_t(1));
    failure.detail = "bang";
    log.add(map::problemOf(failure), noon_);
    QCOMPARE(log.rows().size(), std::size_t(2));
  }

  void onePerSecondBuriesNothing() {
    ProblemLog log;
    log.add(problem(1), noon_);
    for (int i = 0; i < 2 * int(ProblemLog::kLimit); ++i) {
      log.add(
          {Severity::Warning, Subject(SubjectKind::Topic, "/x"), {robot::axbot::fault::MessageNotJson, {i}}},
          after(i));
    }
    QCOMPARE(log.rows().size(), std::size_t(2));
    QCOMPARE(log.rows()[1].count, 2 * int(ProblemLog::kLimit));
  }

  void subjectsAreToldApartByKindAndIdAlone() {
    ProblemLog log;
    log.add({Severity::Error, Subject(SubjectKind::Map, "12"), said("No.")}, noon_);
    log.add({Severity::Error, Subject(SubjectKind::Map, "12", "Map \"Hall\""), said("No.")}, noon_);
    log.add({Severity::Error, Subject(SubjectKind::Map, "13"), said("No.")}, noon_);
    log.add({Severity::Error, Subject(SubjectKind::Submap, "12"), said("No.")}, noon_);
    QCOMPARE(log.rows().size(), std::size_t(3));
    QVERIFY(log.resolve({Subject(SubjectKind::Map, "12", "another name")}, noon_));
    QCOMPARE(log.unresolved(), 2);
  }

  void recoveryResolvesAndARepetitionReopens() {
    ProblemLog log;
    log.add(problem(1), noon_);
    QCOMPARE(log.unresolved(), 1);
    QVERIFY(log.resolve({submap(1)}, after(1)));
    QCOMPARE(log.unresolved(), 0);
    QVERIFY(!log.resolve({submap(1)}, after(2)));
    QCOMPARE(*log.rows()[0].resolved, after(1));
    log.add(problem(1), after(3));
    QCOMPARE(log.unresolved(), 1);
    QVERIFY(!log.rows()[0].resolved);
  }

  void aSubjectRecoversFromEachTroubleByItself() {
    ProblemLog log;
    log.add(problem(1, ProblemCode::Unavailable), noon_);
    log.add(problem(1, ProblemCode::Unplaced), noon_);
    QCOMPARE(log.rows().size(), std::size_t(2));
    QVERIFY(log.resolve({submap(1), ProblemCode::Unplaced}, noon_));
    QCOMPARE(log.unresolved(), 1);
    QVERIFY(!log.resolve({submap(1), ProblemCode::Odd}, noon_));
    QVERIFY(!log.rows()[0].resolved);
  }

  void everySubjectOfAKindRecoversTogether() {
    ProblemLog log;
    for (int i = 0; i < 3; ++i) log.add(problem(i), noon_);
    log.add({Severity::Error, "else", said("No.")}, noon_);
    QVERIFY(log.resolveAll(SubjectKind::Submap, after(5)));
    QCOMPARE(log.unresolved(), 1);
    QVERIFY(!log.resolveAll(SubjectKind::Submap, after(6)));
    log.add(problem(1), after(7));
    QVERIFY(log.resolve({submap(1)}, after(8)));
  }

  void theTimeThatItLastedIsKeptWithoutThePausesBetween() {
    ProblemLog log;
    log.add(problem(1), noon_);
    QCOMPARE(log.rows()[0].lastedMs(after(4)), 4'000);
    log.add(problem(1), after(5));
    log.resolve({submap(1)}, after(10));
    QCOMPARE(log.rows()[0].lastedMs(after(999)), 10'000);
    log.add(problem(1), after(7200));
    QCOMPARE(log.rows()[0].lastedMs(after(7201)), 11'000);
    log.resolve({submap(1)}, after(7202));
    QCOMPARE(log.rows()[0].lastedMs(after(9999)), 12'000);
    QCOMPARE(log.rows()[0].first, noon_);
  }

  void spansReadWell_data() {
    QTest::addColumn<qint64>("ms");
    QTest::addColumn<QString>("text");
    QTest::newRow("backwards") << qint64(-5) << QStringLiteral("0 s");
    QTest::newRow("short") << qint64(420) << QStringLiteral("0.4 s");
    QTest::newRow("seconds") << qint64(59'999) << QStringLiteral("59 s");
    QTest::newRow("minutes") << qint64(200'000) << QStringLiteral("3 min 20 s");
    QTest::newRow("whole minutes") << qint64(180'000) << QStringLiteral("3 min");
    QTest::newRow("hours") << qint64(7'500'000) << QStringLiteral("2 h 5 min");
    QTest::newRow("days") << qint64(100) * 3'600'000 << QStringLiteral("4 d 4 h");
  }
  void spansReadWell() {
    QFETCH(qint64, ms);
    QTEST(session::spanText(ms), "text");
  }

  void theLogIsBoundedAndSaysSo() {
    ProblemLog log;
    for (int i = 0; i < int(ProblemLog::kLimit) + 5; ++i) log.add(problem(i), noon_);
    QCOMPARE(log.rows().size(), ProblemLog::kLimit);
    QCOMPARE(log.forgotten(), std::size_t(5));
    QVERIFY(log.toText(noon_).endsWith(QStringLiteral("5 older problems are no longer listed.\n")));
  }

  void whatIsResolvedIsForgottenFirst() {
    ProblemLog log;
    for (int i = 0; i < int(ProblemLog::kLimit); ++i) log.add(problem(i), noon_);
    log.resolve({submap(1000)}, noon_);
    log.add(problem(-1), noon_);
    QCOMPARE(log.unresolved(), int(ProblemLog::kLimit));
    QCOMPARE(log.rows()[0].problem.subject.id, std::string("0"));
    QVERIFY(!log.resolve({submap(1000)}, noon_));
  }

  void rowsKeepTheirNames() {
    ProblemLog log;
    for (int i = 0; i < 3; ++i) log.add(problem(i), noon_);
    const quint64 second = log.rows()[1].row;
    QVERIFY(second != log.rows()[0].row);
    log.add(problem(1), after(1));
    QCOMPARE(log.rows()[1].row, second);
    log.clear();
    log.add(problem(1), after(2));
    QVERIFY(log.rows()[0].row > second);
  }

  void theTextHoldsEveryRowAsPlainText() {
    ProblemLog log;
    log.add({Severity::Warning, "<b>x</b>", said("Odd %1.")}, noon_);
    log.add(problem(7), noon_);
    log.add(problem(7), after(60));
    log.resolve({submap(7)}, after(90));
    QCOMPARE(log.toText(after(500)),
             QStringLiteral("2026-01-02T12:00:00Z  warning  <b>x</b>: Odd %1.\n"
                            "2026-01-02T12:01:00Z  error  Submap 7: It is gone.  (2 times since "
                            "2026-01-02T12:00:00Z)  (resolved after 1 min 30 s)\n"));
  }
};

}  // namespace test_problem_log

MAPWRIGHT_TEST(test_problem_log, ProblemLogTest, Core)
#include "test_problem_log.moc"
