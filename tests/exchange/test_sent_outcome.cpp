// What has become of a request that was sent: nothing is said to be unchanged that was carried out, or may
// have been.
#include <QTest>

#include "exchange/waypoint_steps.h"
#include "test_program.h"

namespace test_sent_outcome {

using namespace mapwright;
using exchange::SentOutcome;
using exchange::SentState;
using map::Applied;
using map::FailureKind;
using Row = exchange::SentRequest;
namespace {

Row failedRow(FailureKind kind, Applied applied) {
  map::Failure failure{kind};
  failure.applied = applied;
  return {{}, Row::State::Failed, failure};
}

const QString kUnchanged = QStringLiteral("It was not changed");
const QString kNotKnown = QStringLiteral("Whether it was changed is unknown");

}  // namespace

class SentOutcomeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void onlyWhatHasNotBeenMadeIsSaidToBeUnchanged_data() {
    QTest::addColumn<FailureKind>("kind");
    QTest::addColumn<Applied>("applied");
    for (const FailureKind kind :
         {FailureKind::Unreachable, FailureKind::TimedOut, FailureKind::Refused, FailureKind::RejectedByRobot,
          FailureKind::MalformedAnswer, FailureKind::Cancelled, FailureKind::Unsupported}) {
      for (const Applied applied : {Applied::No, Applied::Maybe, Applied::Yes})
        QTest::addRow("%d %d", int(kind), int(applied)) << kind << applied;
    }
  }
  void onlyWhatHasNotBeenMadeIsSaidToBeUnchanged() {
    QFETCH(FailureKind, kind);
    QFETCH(Applied, applied);
    const SentOutcome told = exchange::answered(failedRow(kind, applied));
    const bool never_left =
        kind == FailureKind::Unreachable || kind == FailureKind::TimedOut || kind == FailureKind::Cancelled;
    const SentState states[] = {never_left ? SentState::NotSent : SentState::Failed, SentState::Unknown,
                                SentState::Applied};
    QCOMPARE(told.state, states[int(applied)]);
    QCOMPARE(exchange::sentenceOf(told).startsWith(kUnchanged), applied == Applied::No);
    QCOMPARE(exchange::sentenceOf(told).startsWith(kNotKnown), applied == Applied::Maybe);

    const SentOutcome seen = exchange::judged(told, true);
    QCOMPARE(seen.state, SentState::Applied);
    QVERIFY(exchange::sentenceOf(seen).isEmpty());

    // Nothing is to be seen of it: over a lost link it may come still.
    const SentOutcome unseen = exchange::judged(told, false);
    const bool may_come = applied == Applied::Maybe && edit::isOfTheLink(map::Failure{kind});
    const bool was_not_sent = applied == Applied::No && never_left;
    QCOMPARE(unseen.state, may_come       ? SentState::Unknown
                           : was_not_sent ? SentState::NotSent
                                          : SentState::Failed);
    if (applied == Applied::Maybe)
      QVERIFY(exchange::sentenceOf(unseen).startsWith(may_come ? kNotKnown : kUnchanged));
  }

  void whatWasTakenAndIsNotSoAfterwardsIsToldSo() {
    const SentOutcome taken = exchange::answered({{}, Row::State::Done});
    QCOMPARE(taken.state, SentState::Applied);
    const SentOutcome gone = exchange::judged(taken, false);
    QCOMPARE(gone.state, SentState::Failed);
    QCOMPARE(exchange::sentenceOf(gone),
             QStringLiteral("The robot accepted the change, but it has no effect."));
  }

  void whatIsInProgressIsNotKnownYet() {
    const SentOutcome told = exchange::answered({{}, Row::State::InProgress});
    QCOMPARE(told.state, SentState::Unknown);
    QVERIFY(exchange::sentenceOf(told).startsWith(kNotKnown));
    QCOMPARE(exchange::answered({{}, Row::State::Waiting}).state, SentState::NotSent);
  }
};

}  // namespace test_sent_outcome

MAPWRIGHT_TEST(test_sent_outcome, SentOutcomeTest, Core)
#include "test_sent_outcome.moc"
