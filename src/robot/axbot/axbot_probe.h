// Recognises Autoxing robots. Source: docs/protocols/autoxing.md, "Requests".
#pragma once

#include <vector>

#include "robot/probe.h"

namespace mapwright::robot::axbot {

/// Its own port and those of the web; `host` may name another one.
std::vector<Probe> probesOf(const Host& host);

}  // namespace mapwright::robot::axbot
