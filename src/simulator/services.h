// What every connection of the simulated robot works with. Outlives all connections.
#pragma once

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/request_log.h"
#include "simulator/topic_messages.h"
#include "simulator/web_socket_link.h"

namespace mapwright::simulator {

class WebSocketSession;

struct Services {
  const Options& options;
  const RobotState& state;
  FaultPlan& faults;
  RequestLog& log;
  Answerer& routes;
  TopicMessages& messages;
  Links<WebSocketSession>& links;
  Loop& loop;
};

}  // namespace mapwright::simulator
