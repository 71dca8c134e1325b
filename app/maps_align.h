// The command `maps align`, and what it shares with those that carry things over.
#pragma once

#include <string>
#include <vector>

#include <QJsonObject>

#include "app/commands.h"
#include "geometry/pose.h"
#include "placing/align.h"

namespace mapwright::app {

/// "X,Y:X,Y" of --pair. The error is a sentence.
tl::expected<std::vector<placing::PointPair>, QString> pairsFrom(const std::vector<std::string>& typed);
/// {"x","y","yaw_rad"}.
QJsonObject transformJson(const geometry::Pose2& transform);

void addMapAlign(Commands& commands, CLI::App& maps);

}  // namespace mapwright::app
