// A submission: changes on their way to where they are kept, one request after the other. It looks before it
// asks and after, may stop half-way, says of each request what came of it, and can be gone on with. GUI
// thread.
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
  Done,          // all is applied, and what is kept now has been read
  Undecided,     // what is kept now does not go together with what is to be sent: somebody has to decide
  Stopped,       // half-way or before: see failure()
};

/// What becomes of the requests behind one that failed.
enum class AtFailure {
  Stop,  // nothing more is sent
  GoOn,  // those that do not need it are, unless the link is what failed
};

/// It says something about the way there, and nothing about what was asked for.
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
/// It says something about one request, and nothing about the next.
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
    Failed,   // see `failure`, and what of it was applied there
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
  /// What happens on the way, for the document.
  struct Listener {
    /// What is to be asked for, now that this is kept; nullopt = somebody has to decide first.
    std::function<std::optional<std::vector<Request>>(const Stored&)> plan;
    std::function<void(const Request&)> sending;
    std::function<void(const Request&, const Receipt&)> done;
    /// A request ended without being known to be applied.
    std::function<void(const Request&, const map::Failure&)> failed;
    std::function<void(const Stored&)> looked;  // afterwards
    /// `later` makes no sense when `failed` has not been carried out. Empty = none needs another.
    std::function<bool(const Request& later, const Request& failed)> needs = {};
  };
  struct Way {
    AtFailure at_failure = AtFailure::Stop;
    bool look_after_failure = false;  // what became of it, before it is Stopped
  };

  Submission(Store store, Listener listener, QObject* parent = nullptr)
      : SubmissionEvents(parent), store_(std::move(store)), listener_(std::move(listener)) {}
  /// What is still under way goes on, and nobody hears of it.
  ~Submission() override { ++round_; }

  SubmissionPhase phase() const { return phase_; }
  bool running() const {
    return phase_ == SubmissionPhase::Looking || phase_ == SubmissionPhase::Sending ||
           phase_ == SubmissionPhase::LookingAgain;
  }
  /// Why it Stopped.
  const std::optional<map::Failure>& failure() const { return failure_; }
  /// In the order that they are sent in. Of what it went on from, those that were done stay.
  const std::vector<Row>& rows() const { return rows_; }
  std::size_t done() const {
    std::size_t done = 0;
    for (const Row& row : rows_) done += row.state == Row::State::Done ? 1 : 0;
    return done;
  }
  robot::Progress progress() const { return call_.progress(); }  // of the request under way

  /// Begins, or goes on after it stopped or was decided: looks how it is kept now, so that nothing whose
  /// answer was lost is asked for twice, plans anew, and sends.
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
      // Only now is it known what has become of those that were not done.
      std::erase_if(rows_, [](const Row& row) { return row.state != Row::State::Done; });
      if (!planned) return enter(SubmissionPhase::Undecided);
      if (planned->empty() && rows_.empty()) return enter(SubmissionPhase::Done);
      for (Request& request : *planned) rows_.push_back({std::move(request)});
      enter(SubmissionPhase::Sending);
      sendNext();
    }));
  }
  /// Nothing more is sent; what is under way is ended early where that is possible. It is Stopped when that
  /// has been answered.
  void cancel() {
    // When all is sent there is nothing to be cancelled but a look that would not end.
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
      // What needs one that is left out is left out, too.
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
  /// Answers that come when nobody waits for them any more are dropped.
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
      // What the look itself says matters only where nothing worse has been met.
      if (!stored) return stop(met_.value_or(stored.error()));
      listener_.looked(*stored);
      met_ ? stop(*met_) : enter(SubmissionPhase::Done);
    }));
  }

  Store store_;
  Listener listener_;
  SubmissionPhase phase_ = SubmissionPhase::Idle;
  std::vector<Row> rows_;
  std::optional<map::Failure> failure_, met_;  // met_: the first one of a request, while it is under way
  Way way_;
  robot::Call call_;
  bool cancelled_ = false;
  std::uint64_t round_ = 0;
};

}  // namespace mapwright::edit
