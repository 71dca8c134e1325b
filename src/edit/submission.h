// A submission: sends changes to the store, one request after the other. It reads the store before and
// afterwards, may stop half-way, reports the result of every request, and can be resumed. GUI thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <QObject>

#include "robot/waypoint_store.h"

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
bool isOfTheLink(const map::Failure& failure);

/// How one request stands.
struct SubmittedRequest {
  enum class State {
    Waiting,
    InProgress,
    Done,
    Failed,   // see `failure`, and whether it was applied anyway
    NotSent,  // the submission stopped before
  };
  robot::WaypointRequest request;
  State state = State::Waiting;
  std::optional<map::Failure> failure = {};
};

class WaypointSubmission : public QObject {
  Q_OBJECT
 public:
  /// Callbacks for the document.
  struct Listener {
    /// The requests needed, given the stored state; nullopt = the user has to decide first.
    std::function<std::optional<std::vector<robot::WaypointRequest>>(const robot::StoredWaypoints&)> plan;
    std::function<void(const robot::WaypointRequest&)> sending;
    std::function<void(const robot::WaypointRequest&, const robot::WaypointReceipt&)> done;
    /// A request ended, and it is not known to be applied.
    std::function<void(const robot::WaypointRequest&, const map::Failure&)> failed;
    /// Afterwards. True if everything is stored as it should be, whatever was answered.
    std::function<bool(const robot::StoredWaypoints&)> looked;
  };
  struct Options {
    AtFailure at_failure = AtFailure::Stop;
    bool look_after_failure = false;  // reads the result before it is Stopped, also where it is known
  };

  /// `store` is not used any more after abandon().
  WaypointSubmission(robot::WaypointStore& store, map::MapKey map, Listener listener);

  SubmissionPhase phase() const { return phase_; }
  bool running() const;
  /// Why it is Stopped.
  const std::optional<map::Failure>& failure() const { return failure_; }
  /// In the order of sending. After a resume, requests that were done before stay in the list.
  const std::vector<SubmittedRequest>& rows() const { return rows_; }
  std::size_t done() const;

  /// Starts, or resumes after it stopped or a conflict was decided: reads the stored state, so that nothing
  /// whose answer was lost is sent twice, plans again, and sends.
  void start(Options options);
  /// Sends nothing more and cancels the request in progress if possible. The phase becomes Stopped when that
  /// has been answered.
  void cancel();
  /// The robot is gone: no answer will come.
  void abandon();

 Q_SIGNALS:
  void changed();  // its phase, or the state of a request

 private:
  void enter(SubmissionPhase phase);
  void stop(map::Failure failure);
  void leaveOutTheRest();
  void goOnAfter(const SubmittedRequest& row);
  bool mustLook() const;
  template <typename T, typename Then>
  robot::OutcomeTo<T> inThisRound(Then then);
  void sendNext();
  void lookAgain();

  robot::WaypointStore& store_;
  map::MapKey map_;
  Listener listener_;
  SubmissionPhase phase_ = SubmissionPhase::Idle;
  std::vector<SubmittedRequest> rows_;
  std::optional<map::Failure> failure_, met_;  // met_: the first failure of a request, while running
  Options options_;
  robot::Call call_;
  bool cancelled_ = false;
  std::uint64_t round_ = 0;
};

}  // namespace mapwright::edit
