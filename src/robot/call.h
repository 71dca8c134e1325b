// A request to a robot that is under way: how far it is, and how to stop it. Why:
// docs/decisions/0004-a-thread-for-each-adapter.md. Everything here happens on the thread that asked.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <tl/expected.hpp>

#include "map/failure.h"

namespace mapwright::robot {

/// What a request ended in.
template <typename T>
using Outcome = tl::expected<T, map::Failure>;
/// Called exactly once, later, never from within the request or from within cancel(); never after the robot
/// is gone.
template <typename T>
using OutcomeTo = std::function<void(Outcome<T>)>;
/// The outcomes of what came to nothing.
inline tl::unexpected<map::Failure> fail(map::Failure failure) {
  return tl::make_unexpected(std::move(failure));
}
inline tl::unexpected<Fault> refused(Fault why) { return tl::make_unexpected(std::move(why)); }

/// How much of a body has travelled, up or down.
struct Progress {
  std::int64_t bytes = 0;
  std::optional<std::int64_t> of_bytes;  // nullopt = not known
  bool operator==(const Progress&) const = default;
};

/// The handle of a request. Copies are handles of the same request; letting go of all of them stops nothing.
class Call {
 public:
  /// What an adapter keeps of a request. The adapter sets over when it hands out the outcome.
  struct State {
    std::function<void()> cancel;  // asks for an early end; null = there is nothing to stop
    std::function<void(Progress)> on_progress;
    Progress progress;
    bool over = false;
  };

  /// Of nothing: over from the start.
  Call() = default;
  explicit Call(std::shared_ptr<State> state) : state_(std::move(state)) {}

  bool over() const { return !state_ || state_->over; }
  Progress progress() const { return state_ ? state_->progress : Progress{}; }
  /// Ends it early where that is possible: its outcome is FailureKind::Cancelled, with applied as far as is
  /// known. Where it is too late, the outcome is what it would have been. Without effect once it is over.
  void cancel() const {
    if (!over() && state_->cancel) state_->cancel();
  }
  /// From now on called whenever there is more progress, before the outcome.
  void onProgress(std::function<void(Progress)> listener) const {
    if (!over()) state_->on_progress = std::move(listener);
  }

 private:
  std::shared_ptr<State> state_;
};

}  // namespace mapwright::robot
