// What commands share that lay an old map of a site on a new one: `waypoints carry`, `overlays carry`,
// `maps rehearse`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/robot_command.h"
#include "geometry/pose.h"
#include "placing/align.h"

namespace mapwright::app {

/// The options as typed; empty = not given.
struct SiteArguments : RobotArguments {
  std::string transform, resolution, origin, radius, output;
  std::string page;  // --report NAME.html
  std::vector<std::string> pairs;
  bool force = false;
};
/// `output`: what -o writes.
void addSiteOptions(CLI::App& command, SiteArguments& args, const QString& output);

struct SiteWishes {
  std::vector<placing::PointPair> pairs;
  std::optional<double> radius_m;
  std::optional<geometry::Pose2> transform;
};
CommandResult<SiteWishes> wishesFrom(const SiteArguments& args);

}  // namespace mapwright::app
