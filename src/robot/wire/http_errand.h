// HTTP requests that are part of an errand.
#pragma once

#include "net/http_client.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::wire {

/// Sends `request` for `errand`; if that is cancelled, the reply is net::HttpAnswer::Kind::Cancelled. `http`
/// outlives the request. `tells`: its progress is that of the errand.
void send(const ErrandPtr& errand, net::HttpClient& http, net::HttpRequest request,
          net::HttpClient::Reply reply, bool tells = false);

}  // namespace mapwright::robot::wire
