// Topic messages by subject. Each function returns nullopt for topics of other subjects, and an
// UnreadableMessage if a message of its own is invalid. Source: docs/protocols/autoxing.md, "Topics that the
// map shows".
#pragma once

#include <optional>
#include <string>

#include "map/live_topics.h"
#include "robot/axbot/parse_topics.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {

using MaybeMessage = std::optional<map::TopicMessage>;

/// /submap_list.
MaybeMessage readSubmapTopic(const std::string& topic, const wire::Json& message);
/// Pose and motion: pose, model, paths, trajectory, planning, localization.
MaybeMessage readMotionTopic(const std::string& topic, const wire::Json& message);
/// State: slam, battery, wheels, sensors, alerts, map info.
MaybeMessage readStateTopic(const std::string& topic, const wire::Json& message);
/// Surroundings: other robots, landmarks, doors, pallets, racks, detected objects, constraints, barcodes.
MaybeMessage readWorldTopic(const std::string& topic, const wire::Json& message);
/// Points of the map: the known cloud topics, as points or as fields and data.
MaybeMessage readCloudTopic(const std::string& topic, const wire::Json& message);
bool isCloudTopic(const std::string& topic);
/// The layer of a picture topic; nullopt for other topics.
std::optional<map::GridKind> gridKindOf(const std::string& topic);
/// A picture topic: sets frame.message or frame.grid_to_fetch.
void readGridTopic(map::GridKind kind, const wire::Json& message, TextFrame& frame);

}  // namespace mapwright::robot::axbot
