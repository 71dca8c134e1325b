// Recognises Agibot robots. Source: docs/protocols/agibot-aimdk.md.
#pragma once

#include <vector>

#include "robot/probe.h"

namespace mapwright::robot::aimdk {

std::vector<Probe> probesOf(const Host& host);

}  // namespace mapwright::robot::aimdk
