// What every connection of the simulated robot works with. Outlives all connections.
#pragma once

#include "simulator/request_log.h"
#include "simulator/routes.h"
#include "simulator/topic_messages.h"
#include "simulator/web_socket_link.h"

namespace mapwright::simulator {

class WebSocketSession;

struct Services {
  Robot robot;
  RequestLog& log;
  Answerer& routes;
  TopicMessages& messages;
  Links<WebSocketSession>& links;
  Loop& loop;
};

}  // namespace mapwright::simulator
