// A request to a robot in progress: its progress, and how to cancel it. Why:
// docs/decisions/0004-a-thread-for-each-adapter.md. Everything here happens on the caller's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <tl/expected.hpp>

#include "map/failure.h"

namespace mapwright::robot {

/// The result of a request.
template <typename T>
using Outcome = tl::expected<T, map::Failure>;
/// Called exactly once, later, never from within the request or cancel(); never after the robot is gone.
template <typename T>
using OutcomeTo = std::function<void(Outcome<T>)>;
/// Results without a value.
inline tl::unexpected<map::Failure> fail(map::Failure failure) {
  return tl::make_unexpected(std::move(failure));
}
inline tl::unexpected<Fault> refused(Fault why) { return tl::make_unexpected(std::move(why)); }

/// How much of a body has been transferred, up or down.
struct Progress {
  std::int64_t bytes = 0;
  std::optional<std::int64_t> of_bytes;  // nullopt = not known
  bool operator==(const Progress&) const = default;
};

/// The handle of a request. Copies refer to the same request; destroying them does not cancel it.
class Call {
 public:
  /// The adapter's side of a request. The adapter sets over when it delivers the result.
  struct State {
    std::function<void()> cancel;  // requests an early end; null = nothing can be cancelled
    std::function<void(Progress)> on_progress;
    Progress progress;
    bool over = false;
  };

  /// No request: over from the start.
  Call() = default;
  explicit Call(std::shared_ptr<State> state) : state_(std::move(state)) {}

  bool over() const { return !state_ || state_->over; }
  Progress progress() const { return state_ ? state_->progress : Progress{}; }
  /// Ends it early if possible: the result is FailureKind::Cancelled, with applied as far as known. If it is
  /// too late, the result is the usual one. No effect once it is over.
  void cancel() const {
    if (!over() && state_->cancel) state_->cancel();
  }
  /// Called with every further progress, before the result.
  void onProgress(std::function<void(Progress)> listener) const {
    if (!over()) state_->on_progress = std::move(listener);
  }

 private:
  std::shared_ptr<State> state_;
};

}  // namespace mapwright::robot
