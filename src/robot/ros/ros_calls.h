// Service calls over rosbridge, as requests of the port.
#pragma once

#include <functional>
#include <optional>

#include "map/failure.h"
#include "net/rosbridge/client.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

/// Calls for `task`: if that is cancelled, the answer is Cancelled. `client` outlives the call.
void call(const wire::TaskPtr& task, net::rosbridge::Client& client, net::rosbridge::CallRequest request,
          net::rosbridge::Client::Reply reply);

/// `then` once it is known what the robot can do, or with a failure about `subject`.
using WhenKnown =
    std::function<void(const wire::TaskPtr& task, const map::Subject& subject, map::AskedFor asked_for,
                       std::function<void(std::optional<map::Failure>)> then)>;

/// Of an answer that is not Answered. What a server refuses may have been done all the same
/// (docs/protocols/rosbridge.md, "Calls").
map::Failure failed(const net::rosbridge::CallAnswer& answer, map::Subject subject,
                    map::AskedFor asked_for = map::AskedFor::All);

}  // namespace mapwright::robot::ros
