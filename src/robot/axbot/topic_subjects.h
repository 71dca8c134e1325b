// Topic messages by subject. Each function answers nullopt for topics of other subjects, and an
// UnreadableMessage when a message of its own cannot be used. Source: docs/protocols/autoxing.md, "Topics
// that the map shows".
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
/// Where the robot is and goes: pose, model, paths, trajectory, planning, positioning.
MaybeMessage readMotionTopic(const std::string& topic, const wire::Json& message);
/// How the robot does: slam, battery, wheels, sensors, alerts, map info.
MaybeMessage readStateTopic(const std::string& topic, const wire::Json& message);
/// What is around it: other robots, landmarks, doors, pallets, racks, seen objects, constraints, barcodes.
MaybeMessage readWorldTopic(const std::string& topic, const wire::Json& message);
/// Points of the map: the known cloud topics, as points or as fields and data.
MaybeMessage readCloudTopic(const std::string& topic, const wire::Json& message);
bool isCloudTopic(const std::string& topic);
/// Which layer a picture topic belongs to; nullopt for other topics.
std::optional<map::GridKind> gridKindOf(const std::string& topic);
/// A picture topic: sets frame.message or frame.grid_to_fetch.
void readGridTopic(map::GridKind kind, const wire::Json& message, TextFrame& frame);

}  // namespace mapwright::robot::axbot
