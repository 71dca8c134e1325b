// What every connection of the simulated robot works with. Outlives all connections.
#pragma once

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/request_log.h"
#include "simulator/topic_messages.h"
#include "simulator/web_socket_hub.h"

namespace boost::asio {
class thread_pool;
}

namespace mapwright::simulator {

struct Services {
  const Options& options;
  const RobotState& state;
  FaultPlan& faults;
  RequestLog& log;
  Answerer& routes;
  TopicMessages& messages;
  WebSocketHub& hub;
  boost::asio::thread_pool& workers;  // for what takes milliseconds to make
};

}  // namespace mapwright::simulator
