// Aligning two maps, for `maps align` and what is carried over.
#pragma once

#include <string>
#include <vector>

#include <QJsonObject>

#include "align/align.h"
#include "app/commands.h"
#include "render/sample_grid.h"

namespace mapwright::app {

/// Blocks until it is done.
align::Alignment alignPlaced(const render::PlacedGrid& old_map, const render::PlacedGrid& new_map,
                             align::Options options);

/// "X,Y:X,Y" of --pair. The error is a sentence.
tl::expected<std::vector<placing::PointPair>, QString> pairsFrom(const std::vector<std::string>& typed);
/// {"x","y","yaw_rad"}.
QJsonObject transformJson(const geometry::Pose2& transform);

void addMapAlign(Commands& commands, CLI::App& maps);

}  // namespace mapwright::app
