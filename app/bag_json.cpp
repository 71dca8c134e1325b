#include "app/bag_json.h"

#include <algorithm>
#include <utility>

#include "app/command_text.h"
#include "incident/report.h"
#include "ui/kit/status_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using incident::utcText;
using words::text;

/// Stable (docs/json.md).
constexpr std::pair<replay::EventKind, const char*> kEventWords[] = {
    {replay::EventKind::AlertBegan, "alert_begin"},
    {replay::EventKind::AlertEnded, "alert_end"},
    {replay::EventKind::MoveState, "move_state"},
    {replay::EventKind::PositionJump, "jump"},
    {replay::EventKind::MapChanged, "map"},
    {replay::EventKind::SessionChanged, "session"},
    {replay::EventKind::QualityLow, "low_quality_begin"},
    {replay::EventKind::QualityGood, "low_quality_end"},
    {replay::EventKind::EmergencyStopOn, "emergency_stop_begin"},
    {replay::EventKind::EmergencyStopOff, "emergency_stop_end"}};

QString wordOf(replay::EventKind kind) {
  for (const auto& [one, word] : kEventWords) {
    if (one == kind) return QLatin1String(word);
  }
  return {};
}

bool hasCode(replay::EventKind kind) {
  return kind == replay::EventKind::AlertBegan || kind == replay::EventKind::AlertEnded ||
         kind == replay::EventKind::QualityLow || kind == replay::EventKind::QualityGood;
}

template <typename Value>
QJsonValue orNull(const std::optional<Value>& value) {
  return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
}

bool knowsSlam(const map::SlamStatus& slam) {
  return !slam.state.empty() || slam.position_quality || slam.reliable;
}

}  // namespace

QJsonObject bagJson(const robot::BagEntry& entry) {
  const bool recording = entry.key.kind == robot::BagKind::Recording;
  return {{QStringLiteral("name"), text(entry.key.name)},
          {QStringLiteral("kind"), recording ? QStringLiteral("recording") : QStringLiteral("bag")},
          {QStringLiteral("size_bytes"),
           entry.size_bytes ? QJsonValue(qint64(*entry.size_bytes)) : QJsonValue(QJsonValue::Null)},
          {QStringLiteral("end"), orNull(entry.end_s)}};
}

namespace {

// A file cut off before its first messages has no times.
bool hasTimes(const robot::BagInfo& info) { return info.messages.value_or(0) > 0 || info.end_s > 0; }

}  // namespace

QJsonObject infoJson(const std::string& name, const robot::BagInfo& info) {
  QJsonArray away;
  for (const robot::BagAway& one : info.away)
    away.append(
        QJsonObject{{QStringLiteral("from"), one.from_s}, {QStringLiteral("to"), orNull(one.until_s)}});
  QJsonObject all{
      {QStringLiteral("name"), text(name)},
      {QStringLiteral("messages"), info.messages ? QJsonValue(qint64(*info.messages)) : QJsonValue::Null},
      {QStringLiteral("start"), hasTimes(info) ? QJsonValue(info.start_s) : QJsonValue::Null},
      {QStringLiteral("end"), hasTimes(info) ? QJsonValue(info.end_s) : QJsonValue::Null},
      {QStringLiteral("interrupted"), info.interrupted},
      {QStringLiteral("away"), away}};
  if (info.repair)
    all[QStringLiteral("repaired")] =
        QJsonObject{{QStringLiteral("broke_off"), orNull(info.repair->broke_off_s)}};
  if (info.format.empty()) return all;  // a robot gives no further details
  QJsonArray topics, packing;
  for (const robot::BagTopic& one : info.topics)
    topics.append(QJsonObject{{QStringLiteral("topic"), text(one.name)},
                              {QStringLiteral("type"), text(one.type)},
                              {QStringLiteral("encoding"), text(one.encoding)},
                              {QStringLiteral("messages"), one.messages ? QJsonValue(qint64(*one.messages))
                                                                        : QJsonValue(QJsonValue::Null)},
                              {QStringLiteral("hz"), orNull(one.rate_hz)}});
  for (const robot::BagPacking& one : info.packing)
    packing.append(QJsonObject{{QStringLiteral("compression"), text(one.compression)},
                               {QStringLiteral("chunks"), qint64(one.parts)},
                               {QStringLiteral("stored_bytes"), qint64(one.stored_bytes)},
                               {QStringLiteral("unpacked_bytes"), qint64(one.unpacked_bytes)}});
  all[QStringLiteral("format")] = text(info.format);
  all[QStringLiteral("written_by")] = text(info.written_by);
  all[QStringLiteral("attachments")] = qint64(info.attachments);
  QJsonArray robots;
  for (const std::string& one : info.robots) robots.append(text(one));
  all[QStringLiteral("robots")] = robots;
  all[QStringLiteral("topics")] = topics;
  all[QStringLiteral("packing")] = packing;
  return all;
}

std::vector<QStringList> topicRows(const robot::BagInfo& info) {
  if (info.topics.empty()) return {};
  std::vector<QStringList> rows{
      {Text::tr("MESSAGES"), Text::tr("HZ"), Text::tr("ENCODING"), Text::tr("TOPIC"), Text::tr("TYPE")}};
  for (const robot::BagTopic& one : info.topics) {
    rows.push_back({one.messages ? QString::number(*one.messages) : QStringLiteral("-"),
                    one.rate_hz ? QString::number(*one.rate_hz, 'f', 2) : QStringLiteral("-"),
                    one.encoding.empty() ? QStringLiteral("-") : words::plainName(one.encoding),
                    words::plainName(one.name),
                    one.type.empty() ? QStringLiteral("-") : words::plainName(one.type)});
  }
  return rows;
}

std::vector<QStringList> infoRows(const std::string& name, const robot::BagInfo& info) {
  const bool times = hasTimes(info);
  std::vector<QStringList> rows{
      {Text::tr("name"), words::plainName(name)},
      {Text::tr("messages"), info.messages ? QString::number(*info.messages) : Text::tr("unknown")},
      {Text::tr("start"), times ? utcText(info.start_s) : QStringLiteral("-")},
      {Text::tr("end"), times ? utcText(info.end_s) : QStringLiteral("-")}};
  if (!info.format.empty()) {
    rows.push_back({Text::tr("length"), Text::tr("%1 s").arg(info.end_s - info.start_s, 0, 'f', 3)});
    rows.push_back({Text::tr("format"), text(info.format)});
  }
  if (!info.written_by.empty()) rows.push_back({Text::tr("written by"), words::plainName(info.written_by)});
  QStringList robots;
  for (const std::string& one : info.robots) robots << words::plainName(one);
  if (!robots.isEmpty()) rows.push_back({Text::tr("robots"), words::listed(robots)});
  for (const robot::BagPacking& one : info.packing)
    rows.push_back({Text::tr("compression"),
                    Text::tr("%1, chunks: %2, %3 of %4")
                        .arg(one.compression.empty() ? Text::tr("none") : words::plainName(one.compression),
                             QString::number(one.parts), ui::bytesText(one.stored_bytes),
                             ui::bytesText(one.unpacked_bytes))});
  if (info.attachments > 0) rows.push_back({Text::tr("files"), QString::number(info.attachments)});
  if (info.interrupted)
    rows.push_back(
        {Text::tr("interrupted"), times ? utcText(info.end_s) : Text::tr("no message was written")});
  if (info.repair)
    rows.push_back(
        {Text::tr("repaired"), info.repair->broke_off_s
                                   ? Text::tr("cut off at %1").arg(utcText(*info.repair->broke_off_s))
                                   : Text::tr("cut off before any message was written")});
  for (const robot::BagAway& one : info.away)
    rows.push_back(
        {Text::tr("no connection"),
         Text::tr("%1 to %2")
             .arg(utcText(one.from_s), one.until_s ? utcText(*one.until_s) : Text::tr("the end"))});
  return rows;
}

QJsonObject stateJson(double at_s, const replay::Moment& moment, const robot::BagInfo& bag) {
  const map::LiveState& live = moment.at.world.live;
  const QJsonValue null(QJsonValue::Null);
  QJsonObject state;
  state[QStringLiteral("at")] = at_s;
  state[QStringLiteral("pose")] =
      live.robot_pose ? QJsonValue(QJsonObject{{QStringLiteral("x"), live.robot_pose->x_m},
                                               {QStringLiteral("y"), live.robot_pose->y_m},
                                               {QStringLiteral("yaw_rad"), live.robot_pose->yaw_rad}})
                      : null;
  state[QStringLiteral("battery")] = live.battery ? orNull(live.battery->level) : null;
  QJsonArray alerts;
  for (const map::Alert& alert : live.alerts) alerts.append(qint64(alert.code));
  state[QStringLiteral("alerts")] = alerts;
  state[QStringLiteral("slam")] =
      knowsSlam(live.slam)
          ? QJsonValue(QJsonObject{{QStringLiteral("state"), text(live.slam.state)},
                                   {QStringLiteral("position_quality"), orNull(live.slam.position_quality)}})
          : null;
  state[QStringLiteral("planning")] =
      live.planning ? QJsonValue(QJsonObject{{QStringLiteral("move_state"), text(live.planning->move_state)}})
                    : null;
  state[QStringLiteral("map")] =
      live.map_info
          ? QJsonValue(QJsonObject{{QStringLiteral("name"), text(live.map_info->name)},
                                   {QStringLiteral("uid"), text(live.map_info->uid)},
                                   {QStringLiteral("map_version"), orNull(live.map_info->map_version)}})
          : null;
  state[QStringLiteral("jack")] =
      live.jack ? QJsonValue(QJsonObject{{QStringLiteral("state"), text(live.jack->state)},
                                         {QStringLiteral("progress"), orNull(live.jack->progress)},
                                         {QStringLiteral("weight"), orNull(live.jack->weight)}})
                : null;
  state[QStringLiteral("towing")] =
      live.towing ? QJsonValue(QJsonObject{{QStringLiteral("state"), text(live.towing->state)},
                                           {QStringLiteral("progress"), orNull(live.towing->progress)},
                                           {QStringLiteral("cargo"), orNull(live.towing->cargo_detected)},
                                           {QStringLiteral("error_code"), qint64(live.towing->error_code)},
                                           {QStringLiteral("error"), text(live.towing->error)}})
                  : null;
  state[QStringLiteral("path_points")] = qint64(live.path.size());
  state[QStringLiteral("local_path_points")] = qint64(live.local_path.points.size());
  const auto& submaps = moment.at.world.submaps;
  state[QStringLiteral("submaps")] =
      submaps ? QJsonValue(QJsonObject{{QStringLiteral("uuid"), text(submaps->uuid)},
                                       {QStringLiteral("count"), qint64(submaps->entries.size())}})
              : null;
  QJsonObject topics;
  for (const auto& [topic, stamp_s] : moment.topics)
    topics[text(topic)] = QJsonObject{{QStringLiteral("stamp"), stamp_s}};
  state[QStringLiteral("topics")] = topics;
  const robot::BagAway* const away = bag.awayAt(at_s);
  state[QStringLiteral("away_since")] = away ? QJsonValue(away->from_s) : null;
  return state;
}

std::vector<QStringList> stateRows(double at_s, const replay::Moment& moment, const robot::BagInfo& bag) {
  const map::LiveState& live = moment.at.world.live;
  std::vector<QStringList> rows{{Text::tr("at"), utcText(at_s)}};
  if (const robot::BagAway* const away = bag.awayAt(at_s))
    rows.push_back({Text::tr("no connection"), Text::tr("since %1").arg(utcText(away->from_s))});
  if (live.robot_pose) {
    rows.push_back({Text::tr("pose"), Text::tr("%1, %2, %3 rad")
                                          .arg(live.robot_pose->x_m, 0, 'f', 3)
                                          .arg(live.robot_pose->y_m, 0, 'f', 3)
                                          .arg(live.robot_pose->yaw_rad, 0, 'f', 3)});
  }
  if (live.battery && live.battery->level)
    rows.push_back({Text::tr("battery"), QStringLiteral("%1 %").arg(qRound(*live.battery->level * 100))});
  for (const map::Alert& alert : live.alerts)
    rows.push_back(
        {Text::tr("alert"), QStringLiteral("%1 %2").arg(alert.code).arg(words::plainName(alert.text))});
  if (knowsSlam(live.slam)) rows.push_back({Text::tr("SLAM"), words::plainName(live.slam.state)});
  if (live.planning) rows.push_back({Text::tr("planner"), words::plainName(live.planning->move_state)});
  if (live.jack) rows.push_back({Text::tr("jack"), words::plainName(live.jack->state)});
  if (live.towing) rows.push_back({Text::tr("towing"), words::plainName(live.towing->state)});
  if (live.map_info) rows.push_back({Text::tr("map"), words::plainName(live.map_info->name)});
  if (const auto& submaps = moment.at.world.submaps)
    rows.push_back({Text::tr("submaps"), QString::number(submaps->entries.size())});
  for (const auto& [topic, stamp_s] : moment.topics)
    rows.push_back({utcText(stamp_s), words::plainName(topic)});
  return rows;
}

QJsonArray eventsJson(const std::vector<replay::Event>& events) {
  QJsonArray all;
  for (const replay::Event& event : events) {
    QJsonObject row{{QStringLiteral("at"), event.at_s}, {QStringLiteral("kind"), wordOf(event.kind)}};
    if (hasCode(event.kind)) row[QStringLiteral("code")] = qint64(event.code);
    if (!event.text.empty()) row[QStringLiteral("text")] = text(event.text);
    if (event.kind == replay::EventKind::PositionJump) row[QStringLiteral("metres")] = event.metres;
    all.append(row);
  }
  return all;
}

QStringList eventRow(const replay::Event& event) {
  QString what = words::plainName(event.text);
  if (hasCode(event.kind)) what = QStringLiteral("%1 %2").arg(event.code).arg(what);
  if (event.kind == replay::EventKind::PositionJump)
    what = QStringLiteral("%1 m").arg(event.metres, 0, 'f', 2);
  return {utcText(event.at_s), wordOf(event.kind), what};
}

}  // namespace mapwright::app
