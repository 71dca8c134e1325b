// Bags as JSON (docs/command-line.md) and as rows for people. Pure.
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

/// {"name","kind","size_bytes","end"}: size and end are null where the robot does not tell them.
QJsonObject bagJson(const robot::BagEntry& entry);
/// What a robot, or a file, tells of it as a whole (docs/command-line.md, "mapwright bags").
QJsonObject infoJson(const std::string& name, const robot::BagInfo& info);
std::vector<QStringList> infoRows(const std::string& name, const robot::BagInfo& info);
/// What a file holds by which topic; empty: it is none, or nothing is in it.
std::vector<QStringList> topicRows(const robot::BagInfo& info);
/// The world of a time (docs/command-line.md, "mapwright bags").
QJsonObject stateJson(double at_s, const replay::Moment& moment, const robot::BagInfo& bag);
std::vector<QStringList> stateRows(double at_s, const replay::Moment& moment, const robot::BagInfo& bag);
/// [{"at","kind"}] with "code", "text" or "metres" where it has them.
QJsonArray eventsJson(const std::vector<replay::Event>& events);
QStringList eventRow(const replay::Event& event);
/// "2024-06-03 09:00:00.250", UTC.
QString timeText(double epoch_s);

}  // namespace mapwright::app
