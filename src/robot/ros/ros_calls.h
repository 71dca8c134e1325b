// Service calls over rosbridge, as requests of the port.
#pragma once

#include "map/failure.h"
#include "net/rosbridge/client.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::ros {

/// Calls for `errand`: if that is cancelled, the answer is Cancelled. `client` outlives the call.
void call(const wire::ErrandPtr& errand, net::rosbridge::Client& client, net::rosbridge::CallRequest request,
          net::rosbridge::Client::Reply reply);

/// For any result but Answered. A call that the server refuses may have been carried out
/// (docs/protocols/rosbridge.md, "Calls").
map::Failure failed(const net::rosbridge::CallAnswer& answer, map::Subject subject,
                    map::AskedFor asked_for = map::AskedFor::All);

}  // namespace mapwright::robot::ros
