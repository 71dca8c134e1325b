#include "exchange/sent_outcome.h"

#include <algorithm>

#include <QCoreApplication>

#include "sentences/failure_sentence.h"

namespace mapwright::exchange {
namespace {

class OutcomeWords {
  Q_DECLARE_TR_FUNCTIONS(SentOutcome)
};

/// The stored state is what the request should produce.
bool isSo(const robot::WaypointRequest& request, const edit::WaypointDocument& document) {
  return std::all_of(request.changes.begin(), request.changes.end(), [&](const robot::WaypointChange& one) {
    const edit::Key key = document.ourName(one.id);
    const std::vector<WaypointStep> steps = stepsOf({{key, one.before, one.after}});
    return std::all_of(steps.begin(), steps.end(),
                       [&](const WaypointStep& step) { return isDone(step, document.findKept(key)); });
  });
}

}  // namespace

SentOutcome answered(const SentRequest& sent) {
  using State = SentRequest::State;
  switch (sent.state) {
    case State::Done:
      return {SentState::Applied};
    case State::UnderWay:
      return {SentState::Unknown};
    case State::Failed: {
      map::Failure failure = *sent.failure;
      failure.asked_for = map::AskedFor::Change;
      const SentState state = failure.applied == map::Applied::Yes     ? SentState::Applied
                              : failure.applied == map::Applied::Maybe ? SentState::Unknown
                                                                       : SentState::Failed;
      return {state, std::move(failure)};
    }
    case State::Waiting:
    case State::NotSent:
      break;
  }
  return {};
}

SentOutcome judged(SentOutcome by_answer, bool is_so) {
  if (is_so) return {SentState::Applied};
  if (by_answer.state == SentState::Applied) {
    // A partial result says which part was applied.
    const bool says_why = by_answer.failure && by_answer.failure->reason == map::FailureReason::Unfit;
    return {SentState::Failed, says_why ? std::move(by_answer.failure) : std::nullopt};
  }
  // A request without an answer may still be carried out: not seeing its effect yet proves nothing.
  const bool may_come = !by_answer.failure || edit::isOfTheLink(*by_answer.failure);
  if (by_answer.state == SentState::Unknown && !may_come) {
    by_answer.state = SentState::Failed;
    by_answer.failure->applied = map::Applied::No;
  }
  return by_answer;
}

SentOutcome outcomeOf(const SentRequest& sent, const edit::WaypointDocument* looked) {
  SentOutcome outcome = answered(sent);
  const bool in_doubt = sent.state == SentRequest::State::Failed;
  return in_doubt && looked ? judged(std::move(outcome), isSo(sent.request, *looked)) : outcome;
}

SentCounts countsOf(const std::vector<SentRequest>& sent, const edit::WaypointDocument* looked) {
  SentCounts counts;
  for (const SentRequest& one : sent) {
    switch (outcomeOf(one, looked).state) {
      case SentState::Applied:
        ++counts.applied;
        break;
      case SentState::Failed:
        ++counts.failed;
        break;
      case SentState::Unknown:
        ++counts.unknown;
        break;
      case SentState::NotSent:
        ++counts.not_sent;
    }
  }
  return counts;
}

QString sentenceOf(const SentOutcome& outcome) {
  if (outcome.state == SentState::Applied || outcome.state == SentState::NotSent) return {};
  if (outcome.failure) return QString::fromStdString(sentences::sentenceOf(*outcome.failure));
  if (outcome.state == SentState::Unknown) return OutcomeWords::tr("Whether it was changed is unknown.");
  return OutcomeWords::tr("The robot accepted the change, but it has no effect.");
}

}  // namespace mapwright::exchange
