// Recognises rosbridge servers, and what kind of robot is behind one. Source: docs/protocols/rosbridge.md.
#pragma once

#include <vector>

#include "robot/probe.h"
#include "robot/ros/ros_api.h"

namespace mapwright::robot::ros {

/// Finds every kind that can be connected to at a server: with a map manager, with a dispatcher, plain.
std::vector<Probe> probesOf(const Host& host);

/// The kinds behind `server`, the most particular one first.
std::vector<FoundRobot> robotsIn(const RosGraph& graph, const QUrl& server);

}  // namespace mapwright::robot::ros
