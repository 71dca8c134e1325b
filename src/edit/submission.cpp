#include "edit/submission.h"

#include <algorithm>
#include <utility>

#include <QPointer>

namespace mapwright::edit {
namespace {

using Row = SubmittedRequest;

/// `later` cannot be sent because `failed` was not carried out: it is about the same waypoint, or about the
/// name that one still has.
bool needs(const robot::WaypointRequest& later, const robot::WaypointRequest& failed) {
  return std::any_of(later.changes.begin(), later.changes.end(), [&](const robot::WaypointChange& one) {
    return std::any_of(failed.changes.begin(), failed.changes.end(), [&](const robot::WaypointChange& other) {
      return one.id == other.id || (one.after && other.before && one.after->name == other.before->name &&
                                    (!one.before || one.before->name != one.after->name));
    });
  });
}

}  // namespace

bool isOfTheLink(const map::Failure& failure) {
  switch (failure.kind) {
    case map::FailureKind::Unreachable:
    case map::FailureKind::TimedOut:
    case map::FailureKind::Refused:
    case map::FailureKind::NotARobot:
    case map::FailureKind::Certificate:
    case map::FailureKind::Cancelled:
      return true;
    default:
      return false;
  }
}

WaypointSubmission::WaypointSubmission(robot::WaypointStore& store, map::MapKey map, Listener listener)
    : store_(store), map_(std::move(map)), listener_(std::move(listener)) {}

bool WaypointSubmission::running() const {
  return phase_ == SubmissionPhase::Looking || phase_ == SubmissionPhase::Sending ||
         phase_ == SubmissionPhase::LookingAgain;
}

std::size_t WaypointSubmission::done() const {
  return std::size_t(std::count_if(rows_.begin(), rows_.end(),
                                   [](const Row& row) { return row.state == Row::State::Done; }));
}

void WaypointSubmission::start(Options options) {
  if (running()) return;
  if (phase_ == SubmissionPhase::Done) rows_.clear();
  options_ = options;
  failure_.reset();
  met_.reset();
  enter(SubmissionPhase::Looking);
  using Stored = robot::StoredWaypoints;
  call_ = store_.read(map_, inThisRound<Stored>([this](const robot::Outcome<Stored>& stored) {
                        if (!stored) return stop(stored.error());
                        if (cancelled_) return stop(map::Failure{map::FailureKind::Cancelled});
                        auto planned = listener_.plan(*stored);
                        // Only now is the result of unfinished requests known.
                        std::erase_if(rows_, [](const Row& row) { return row.state != Row::State::Done; });
                        if (!planned) return enter(SubmissionPhase::Undecided);
                        if (planned->empty() && rows_.empty()) return enter(SubmissionPhase::Done);
                        for (robot::WaypointRequest& request : *planned)
                          rows_.push_back({std::move(request)});
                        enter(SubmissionPhase::Sending);
                        sendNext();
                      }));
}

void WaypointSubmission::cancel() {
  // After everything was sent, only the final read can be cancelled.
  if (!running() || (phase_ == SubmissionPhase::LookingAgain && !met_)) return;
  cancelled_ = true;
  call_.cancel();
}

void WaypointSubmission::abandon() {
  if (!running()) return;
  ++round_;
  for (Row& row : rows_) {
    if (row.state != Row::State::InProgress) continue;
    row.state = Row::State::Failed;
    row.failure = map::Failure{map::FailureKind::Unreachable, {}, map::Applied::Maybe};
    listener_.failed(row.request, *row.failure);
  }
  stop(met_.value_or(map::Failure{map::FailureKind::Unreachable}));
}

void WaypointSubmission::enter(SubmissionPhase phase) {
  phase_ = phase;
  if (!running()) cancelled_ = false;
  Q_EMIT changed();
}

void WaypointSubmission::stop(map::Failure failure) {
  failure_ = std::move(failure);
  leaveOutTheRest();
  enter(SubmissionPhase::Stopped);
}

void WaypointSubmission::leaveOutTheRest() {
  for (Row& row : rows_) {
    if (row.state == Row::State::Waiting) row.state = Row::State::NotSent;
  }
}

void WaypointSubmission::goOnAfter(const Row& row) {
  const map::Failure failure = *row.failure;
  if (!met_) met_ = failure;
  const bool of_one_request = !isOfTheLink(failure) && failure.kind != map::FailureKind::Conflict;
  if (options_.at_failure == AtFailure::GoOn && !cancelled_ && of_one_request) {
    // Requests that depend on a skipped one are skipped, too.
    std::vector<const robot::WaypointRequest*> lacking{&row.request};
    for (Row& later : rows_) {
      const bool needed = later.state == Row::State::Waiting &&
                          std::any_of(lacking.begin(), lacking.end(),
                                      [&](const auto* one) { return needs(later.request, *one); });
      if (!needed) continue;
      later.state = Row::State::NotSent;
      lacking.push_back(&later.request);
    }
    Q_EMIT changed();
    return sendNext();
  }
  if (!mustLook() || failure.kind == map::FailureKind::Conflict) return stop(failure);
  leaveOutTheRest();
  lookAgain();
}

/// An answer may be lost although the request was carried out.
bool WaypointSubmission::mustLook() const {
  return options_.look_after_failure || std::any_of(rows_.begin(), rows_.end(), [](const Row& row) {
           return row.failure && row.failure->applied == map::Applied::Maybe;
         });
}

/// Drops answers that arrive when nobody waits for them any more.
template <typename T, typename Then>
robot::OutcomeTo<T> WaypointSubmission::inThisRound(Then then) {
  return [self = QPointer<WaypointSubmission>(this), round = ++round_,
          then = std::move(then)](robot::Outcome<T> outcome) {
    if (self && self->round_ == round) then(std::move(outcome));
  };
}

void WaypointSubmission::sendNext() {
  std::size_t next = 0;
  while (next < rows_.size() && rows_[next].state != Row::State::Waiting) ++next;
  if (next == rows_.size()) return met_ && !mustLook() ? stop(*met_) : lookAgain();
  if (cancelled_) return stop(map::Failure{map::FailureKind::Cancelled});
  rows_[next].state = Row::State::InProgress;
  listener_.sending(rows_[next].request);
  using Receipt = robot::WaypointReceipt;
  const auto end = [this, next](const robot::Outcome<Receipt>& receipt) {
    Row& row = rows_[next];
    if (receipt) {
      row.state = Row::State::Done;
      listener_.done(row.request, *receipt);
      Q_EMIT changed();
      return sendNext();
    }
    row.state = Row::State::Failed;
    row.failure = receipt.error();
    listener_.failed(row.request, receipt.error());
    goOnAfter(row);
  };
  call_ = store_.perform(map_, rows_[next].request, inThisRound<Receipt>(end));
  Q_EMIT changed();
}

void WaypointSubmission::lookAgain() {
  enter(SubmissionPhase::LookingAgain);
  using Stored = robot::StoredWaypoints;
  call_ = store_.read(map_, inThisRound<Stored>([this](const robot::Outcome<Stored>& stored) {
                        // A failed read matters only if no request failed before it.
                        if (!stored) return stop(met_.value_or(stored.error()));
                        const bool all = listener_.looked(*stored);
                        met_ && !all ? stop(*met_) : enter(SubmissionPhase::Done);
                      }));
}

}  // namespace mapwright::edit

#include "moc_submission.cpp"
