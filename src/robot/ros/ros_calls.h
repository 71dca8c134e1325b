// Service calls over rosbridge, as requests of the port.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include "map/failure.h"
#include "net/rosbridge/client.h"
#include "robot/call.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

/// Calls for `task`: if that is cancelled, the answer is Cancelled. `client` outlives the call.
void call(const wire::TaskPtr& task, net::rosbridge::Client& client, net::rosbridge::CallRequest request,
          net::rosbridge::Client::Reply reply);

/// Called once with the failure, or with nothing where there is none.
using Checked = std::function<void(std::optional<map::Failure>)>;
/// `then` once it is known what the robot can do, or with a failure about `subject`.
using WhenKnown = std::function<void(const wire::TaskPtr& task, const map::Subject& subject,
                                     map::AskedFor asked_for, Checked then)>;

/// Goes on with `next` unless something failed, which `reply` is told.
template <typename T, typename Next>
Checked unlessFailed(OutcomeTo<T> reply, Next next) {
  return [reply = std::move(reply), next = std::move(next)](std::optional<map::Failure> failure) {
    if (failure) return reply(fail(std::move(*failure)));
    next();
  };
}
/// The same with a value, as `next` takes it.
template <typename Value, typename T, typename Next>
OutcomeTo<Value> withValue(OutcomeTo<T> reply, Next next) {
  return [reply = std::move(reply), next = std::move(next)](Outcome<Value> outcome) {
    if (!outcome) return reply(fail(std::move(outcome.error())));
    next(std::move(*outcome));
  };
}

/// Of an answer that is not Answered. What a server refuses may have been done all the same
/// (docs/protocols/rosbridge.md, "Calls").
map::Failure failed(const net::rosbridge::CallAnswer& answer, map::Subject subject,
                    map::AskedFor asked_for = map::AskedFor::All);
/// Of waiting that ended otherwise than hoped for; the cause is `late` or `dropped`.
map::Failure failed(wire::WaitList::End how, map::Subject subject, FaultCode late, FaultCode dropped);
/// Nothing more will be learned about the change by looking: it was not made, or nobody can be asked.
bool isFinal(const map::Failure& of_change);

/// No answer can be had; `cause` says why, if there is more to be said of it.
map::Failure unsupported(map::Subject subject, Fault cause = {});
/// The robot said that it was done, and does not show it.
map::Failure unconfirmed(map::Subject subject, std::chrono::milliseconds within);
/// The change was sent; whether it was made is unknown.
map::Failure cancelled(map::Subject subject);

}  // namespace mapwright::robot::ros
