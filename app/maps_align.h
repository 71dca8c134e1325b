// The command `maps align`, and what it shares with those that carry things over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QJsonObject>

#include "app/commands.h"
#include "geometry/pose.h"
#include "placing/align.h"

namespace mapwright::app {

/// "X,Y:X,Y" of --pair. The error is a sentence.
tl::expected<std::vector<placing::PointPair>, QString> pairsFrom(const std::vector<std::string>& typed);
/// --transform; nullopt = not given. `paired`: there are pairs, too. The error is a sentence.
tl::expected<std::optional<geometry::Pose2>, QString> transformFrom(const std::string& typed, bool paired);
/// {"x","y","yaw_rad"}.
QJsonObject transformJson(const geometry::Pose2& transform);

void addMapAlign(Commands& commands, CLI::App& maps);
/// `maps rehearse`: recorded ways on a new map.
void addMapRehearsal(Commands& commands, CLI::App& maps);

}  // namespace mapwright::app
