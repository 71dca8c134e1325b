// A submission: sends changes to the store, one request after the other. It reads the store before and
// afterwards, may stop half-way, reports the result of every request, and can be resumed. GUI thread.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <QPointer>

#include "edit/submission_events.h"
#include "robot/call.h"

namespace mapwright::edit {

enum class SubmissionPhase {
  Idle,
  Looking,  // how it is kept now
  Sending,
  LookingAgain,  // what became of it
  Done,          // everything is applied, and the result has been read
  Undecided,     // the stored state conflicts with the changes: the user has to decide
  Stopped,       // half-way or before: see failure()
};

/// What to do with the requests after one that failed.
enum class AtFailure {
  Stop,  // nothing more is sent
  GoOn,  // send those that do not depend on it, unless the connection failed
};

/// The failure is about the connection, not about the request.
inline bool isOfTheLink(const map::Failure& failure) {
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
/// The failure is about one request and says nothing about the next.
inline bool concernsOneRequest(const map::Failure& failure) {
  return !isOfTheLink(failure) && failure.kind != map::FailureKind::Conflict;
}

/// How one request stands.
template <typename Request>
struct SubmittedRequest {
  enum class State {
    Waiting,
    UnderWay,
    Done,
    Failed,   // see `failure`, and whether it was applied anyway
    NotSent,  // the submission stopped before
  };
  Request request;
  State state = State::Waiting;
  std::optional<map::Failure> failure = {};
};

template <typename Stored, typename Request, typename Receipt>
class Submission : public SubmissionEvents {
 public:
  using Row = SubmittedRequest<Request>;
  struct Store {
    std::function<robot::Call(robot::OutcomeTo<Stored>)> read;
    std::function<robot::Call(const Request&, robot::OutcomeTo<Receipt>)> perform;
  };
  /// Callbacks for the document.
  struct Listener {
    /// The requests needed, given the stored state; nullopt = the user has to decide first.
    std::function<std::optional<std::vector<Request>>(const Stored&)> plan;
    std::function<void(const Request&)> sending;
    std::function<void(const Request&, const Receipt&)> done;
    /// A request ended, and it is not known to be applied.
    std::function<void(const Request&, const map::Failure&)> failed;
    std::function<void(const Stored&)> looked;  // afterwards
    /// True if `later` cannot be sent because `failed` was not carried out. Empty = requests are independent.
    std::function<bool(const Request& later, const Request& failed)> needs = {};
  };
  struct Way {
    AtFailure at_failure = AtFailure::Stop;
    bool look_after_failure = false;  // reads the result before it is Stopped
  };

  Submission(Store store, Listener listener, QObject* parent = nullptr)
      : SubmissionEvents(parent), store_(std::move(store)), listener_(std::move(listener)) {}
  /// Requests in progress continue, but their results are ignored.
  ~Submission() override { ++round_; }

  SubmissionPhase phase() const { return phase_; }
  bool running() const {
    return phase_ == SubmissionPhase::Looking || phase_ == SubmissionPhase::Sending ||
           phase_ == SubmissionPhase::LookingAgain;
  }
  /// Why it is Stopped.
  const std::optional<map::Failure>& failure() const { return failure_; }
  /// In the order of sending. After a resume, requests that were done before stay in the list.
  const std::vector<Row>& rows() const { return rows_; }
  std::size_t done() const {
    std::size_t done = 0;
    for (const Row& row : rows_) done += row.state == Row::State::Done ? 1 : 0;
    return done;
  }
  robot::Progress progress() const { return call_.progress(); }  // of the request in progress

  /// Starts, or resumes after it stopped or a conflict was decided: reads the stored state, so that nothing
  /// whose answer was lost is sent twice, plans again, and sends.
  void start(Way way = {}) {
    if (running()) return;
    if (phase_ == SubmissionPhase::Done) rows_.clear();
    way_ = way;
    failure_.reset();
    met_.reset();
    enter(SubmissionPhase::Looking);
    call_ = store_.read(inThisRound<Stored>([this](robot::Outcome<Stored> stored) {
      if (!stored) return stop(stored.error());
      if (cancelled_) return stop(cancelled());
      auto planned = listener_.plan(*stored);
      // Only now is the result of unfinished requests known.
      std::erase_if(rows_, [](const Row& row) { return row.state != Row::State::Done; });
      if (!planned) return enter(SubmissionPhase::Undecided);
      if (planned->empty() && rows_.empty()) return enter(SubmissionPhase::Done);
      for (Request& request : *planned) rows_.push_back({std::move(request)});
      enter(SubmissionPhase::Sending);
      sendNext();
    }));
  }
  /// Sends nothing more and cancels the request in progress if possible. The phase becomes Stopped when that
  /// has been answered.
  void cancel() {
    // After everything was sent, only the final read can be cancelled.
    if (!running() || (phase_ == SubmissionPhase::LookingAgain && !met_)) return;
    cancelled_ = true;
    call_.cancel();
  }
  /// The robot is gone: no answer will come.
  void abandon() {
    if (!running()) return;
    ++round_;
    for (Row& row : rows_) {
      if (row.state != Row::State::UnderWay) continue;
      row.state = Row::State::Failed;
      row.failure = map::Failure{map::FailureKind::Unreachable, {}, map::Applied::Maybe};
      listener_.failed(row.request, *row.failure);
    }
    stop(met_.value_or(map::Failure{map::FailureKind::Unreachable}));
  }

 private:
  static map::Failure cancelled() { return map::Failure{map::FailureKind::Cancelled}; }
  void enter(SubmissionPhase phase) {
    phase_ = phase;
    if (!running()) cancelled_ = false;
    Q_EMIT changed();
  }
  void stop(map::Failure failure) {
    failure_ = std::move(failure);
    leaveOutTheRest();
    enter(SubmissionPhase::Stopped);
  }
  void leaveOutTheRest() {
    for (Row& row : rows_) {
      if (row.state == Row::State::Waiting) row.state = Row::State::NotSent;
    }
  }
  /// A request has failed.
  void goOnAfter(const Row& row) {
    const map::Failure failure = *row.failure;
    if (!met_) met_ = failure;
    if (way_.at_failure == AtFailure::GoOn && !cancelled_ && concernsOneRequest(failure)) {
      // Requests that depend on a skipped one are skipped, too.
      std::vector<const Request*> lacking{&row.request};
      for (Row& later : rows_) {
        const bool needed = later.state == Row::State::Waiting && listener_.needs &&
                            std::any_of(lacking.begin(), lacking.end(), [&](const Request* one) {
                              return listener_.needs(later.request, *one);
                            });
        if (!needed) continue;
        later.state = Row::State::NotSent;
        lacking.push_back(&later.request);
      }
      Q_EMIT changed();
      return sendNext();
    }
    if (!way_.look_after_failure || failure.kind == map::FailureKind::Conflict) return stop(failure);
    leaveOutTheRest();
    lookAgain();
  }
  /// Drops answers that arrive when nobody waits for them any more.
  template <typename T, typename Then>
  robot::OutcomeTo<T> inThisRound(Then then) {
    return [self = QPointer<Submission>(this), round = ++round_,
            then = std::move(then)](robot::Outcome<T> outcome) {
      if (self && self->round_ == round) then(std::move(outcome));
    };
  }
  void sendNext() {
    std::size_t next = 0;
    while (next < rows_.size() && rows_[next].state != Row::State::Waiting) ++next;
    if (next == rows_.size()) return met_ && !way_.look_after_failure ? stop(*met_) : lookAgain();
    if (cancelled_) return stop(cancelled());
    rows_[next].state = Row::State::UnderWay;
    listener_.sending(rows_[next].request);
    call_ = store_.perform(rows_[next].request,
                           inThisRound<Receipt>([this, next](robot::Outcome<Receipt> receipt) {
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
                           }));
    Q_EMIT changed();
  }
  void lookAgain() {
    enter(SubmissionPhase::LookingAgain);
    call_ = store_.read(inThisRound<Stored>([this](robot::Outcome<Stored> stored) {
      // A failed read matters only if no request failed before it.
      if (!stored) return stop(met_.value_or(stored.error()));
      listener_.looked(*stored);
      met_ ? stop(*met_) : enter(SubmissionPhase::Done);
    }));
  }

  Store store_;
  Listener listener_;
  SubmissionPhase phase_ = SubmissionPhase::Idle;
  std::vector<Row> rows_;
  std::optional<map::Failure> failure_, met_;  // met_: the first failure of a request, while running
  Way way_;
  robot::Call call_;
  bool cancelled_ = false;
  std::uint64_t round_ = 0;
};

}  // namespace mapwright::edit
