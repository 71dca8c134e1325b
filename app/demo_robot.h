// The embedded simulator as a robot of this process.
#pragma once

#include <memory>

#include <QUrlQuery>
#include <tl/expected.hpp>

#include "robot/address.h"
#include "robot/robot.h"
#include "simulator/simulator.h"

namespace mapwright::app {

/// Whether the demo's world runs, or stands still so that all snapshots are the same.
enum class DemoTime { Running, Frozen };

/// Parses the query of "demo:?scene=warehouse&submaps=500&seed=3" into simulator options; the error is a
/// sentence.
tl::expected<simulator::Options, QString> parseDemoQuery(const QUrlQuery& query, DemoTime time);

/// "demo:", "demo:?scene=warehouse". The part after the ? is checked when the robot is made.
robot::AddressScheme demoAddressScheme();

/// Starts a simulator on a free loopback port and a client connected to it.
tl::expected<std::unique_ptr<robot::Robot>, QString> makeDemoRobot(const QString& address,
                                                                   const simulator::Options& options);

}  // namespace mapwright::app
