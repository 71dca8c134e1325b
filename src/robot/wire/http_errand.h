// The HTTP requests of an errand.
#pragma once

#include "net/http_client.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::wire {

/// Sends `request` for `errand`; once that is cancelled, it is not sent, and the reply comes with
/// net::HttpAnswer::Kind::Cancelled. `http` outlives the request. `tells`: how far it is, is how far the
/// errand is.
void send(const ErrandPtr& errand, net::HttpClient& http, net::HttpRequest request,
          net::HttpClient::Reply reply, bool tells = false);

}  // namespace mapwright::robot::wire
