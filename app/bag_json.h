// Bags as JSON (docs/json.md) and as rows for people. Pure.
#pragma once

#include <string>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>
#include <QStringList>

#include "replay/events.h"
#include "replay/reading.h"
#include "robot/bag_library.h"

namespace mapwright::app {

/// {"name","kind","size_bytes","end"}: size and end are null if the robot does not report them.
QJsonObject bagJson(const robot::BagEntry& entry);
/// General information about a robot or a file (docs/json.md).
QJsonObject infoJson(const std::string& name, const robot::BagInfo& info);
std::vector<QStringList> infoRows(const std::string& name, const robot::BagInfo& info);
/// The topics of a file with their messages; empty if it has none.
std::vector<QStringList> topicRows(const robot::BagInfo& info);
/// The state at a given time (docs/json.md).
QJsonObject stateJson(double at_s, const replay::Moment& moment, const robot::BagInfo& bag);
std::vector<QStringList> stateRows(double at_s, const replay::Moment& moment, const robot::BagInfo& bag);
/// [{"at","kind"}] with "code", "text" or "metres" where it has them.
QJsonArray eventsJson(const std::vector<replay::Event>& events);
QStringList eventRow(const replay::Event& event);

}  // namespace mapwright::app
