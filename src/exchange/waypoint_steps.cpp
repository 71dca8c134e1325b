#include "exchange/waypoint_steps.h"

#include <cmath>

#include <QCoreApplication>
#include <QJsonDocument>

#include "exchange/waypoint_json.h"
#include "geometry/pose.h"
#include "map/waypoint.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::exchange {
namespace {

class WaypointStepsText {
  Q_DECLARE_TR_FUNCTIONS(WaypointSteps)
};

using words::text;

bool isNear(const map::Waypoint& wanted, const map::Waypoint& kept) {
  if (!map::samePlace(wanted.position_m, kept.position_m)) return false;
  // Some robots give everything a heading.
  if (!kept.yaw_rad) return !wanted.yaw_rad;
  return map::sameHeading(wanted.yaw_rad.value_or(0), *kept.yaw_rad);
}

QString figure(double value) { return QString::number(std::round(value * 1000) / 1000, 'g', 10); }

QJsonValue rowOr(const std::optional<map::Waypoint>& point, const std::string& map) {
  return point ? QJsonValue(waypointJson(*point, map)) : QJsonValue();
}

QString wordOf(edit::ConflictKind kind) {
  switch (kind) {
    case edit::ConflictKind::BothChanged:
      return QStringLiteral("both-changed");
    case edit::ConflictKind::DeletedHere:
      return QStringLiteral("deleted-here");
    case edit::ConflictKind::DeletedThere:
      return QStringLiteral("deleted-there");
    case edit::ConflictKind::BothAdded:
      break;
  }
  return QStringLiteral("both-added");
}

QStringList fieldWords(edit::FieldMask fields) {
  QStringList words;
  for (const auto& [bit, word] : {std::pair{edit::waypoint_field::kName, "name"},
                                  {edit::waypoint_field::kPosition, "position"},
                                  {edit::waypoint_field::kYaw, "yaw_rad"},
                                  {edit::waypoint_field::kTags, "tags"},
                                  {edit::waypoint_field::kType, "type"}}) {
    if (fields & bit) words << QLatin1String(word);
  }
  return words;
}

QString conflictText(const edit::Conflict<map::Waypoint>& conflict) {
  switch (conflict.kind) {
    case edit::ConflictKind::DeletedHere:
      return WaypointStepsText::tr("you delete it, but it was changed on the robot");
    case edit::ConflictKind::DeletedThere:
      return WaypointStepsText::tr("you change it, but it was deleted on the robot");
    case edit::ConflictKind::BothChanged:
    case edit::ConflictKind::BothAdded:
      break;
  }
  return WaypointStepsText::tr("it was changed on the robot, too (%1)")
      .arg(fieldWords(conflict.fields).join(QStringLiteral(", ")));
}

}  // namespace

WaypointItems itemsOf(const std::vector<map::Waypoint>& points) {
  WaypointItems items;
  for (const map::Waypoint& point : points) items.emplace(point.id, point);
  return items;
}

QString wordOf(StepKind kind) {
  switch (kind) {
    case StepKind::Create:
      return QStringLiteral("create");
    case StepKind::Move:
      return QStringLiteral("move");
    case StepKind::Rename:
      return QStringLiteral("rename");
    case StepKind::Retag:
      return QStringLiteral("retag");
    case StepKind::Retype:
      return QStringLiteral("retype");
    case StepKind::Delete:
      break;
  }
  return QStringLiteral("delete");
}

std::vector<WaypointStep> stepsOf(const std::vector<WaypointEdit>& edits) {
  namespace field = edit::waypoint_field;
  std::vector<WaypointStep> steps;
  for (const WaypointEdit& edit : edits) {
    const auto add = [&](StepKind kind) { steps.push_back({kind, edit.key, edit.before, edit.after}); };
    if (!edit.before && !edit.after) continue;
    if (!edit.before) {
      add(StepKind::Create);
    } else if (!edit.after) {
      add(StepKind::Delete);
    } else {
      const edit::FieldMask changed = edit::difference(*edit.before, *edit.after);
      if (changed & field::kName) add(StepKind::Rename);
      if (changed & (field::kPosition | field::kYaw)) add(StepKind::Move);
      if (changed & field::kTags) add(StepKind::Retag);
      if (changed & field::kType) add(StepKind::Retype);
    }
  }
  return steps;
}

bool isDone(const WaypointStep& step, const map::Waypoint* kept) {
  if (step.kind == StepKind::Delete || !kept) return step.kind == StepKind::Delete && !kept;
  switch (step.kind) {
    case StepKind::Create:
      return isAlike(*step.after, *kept);
    case StepKind::Move:
      return isNear(*step.after, *kept);
    case StepKind::Rename:
      return step.after->name == kept->name;
    case StepKind::Retag:
      return step.after->tags == kept->tags;
    case StepKind::Retype:
      return step.after->type == kept->type;
    case StepKind::Delete:
      break;
  }
  return false;
}

bool isAlike(const map::Waypoint& wanted, const map::Waypoint& kept) {
  return isNear(wanted, kept) && wanted.name == kept.name && wanted.tags == kept.tags &&
         wanted.type == kept.type;
}

QJsonObject stepJson(const WaypointStep& step, const std::string& map) {
  QJsonObject row;
  if (step.kind == StepKind::Create) row = waypointJson(*step.after, map);
  const std::string id = step.id();
  row[QStringLiteral("id")] = id.empty() ? QJsonValue() : QJsonValue(text(id));
  row[QStringLiteral("name")] = text(step.name());
  row[QStringLiteral("kind")] = wordOf(step.kind);
  if (!step.before || !step.after) return row;
  const QJsonObject after = waypointJson(*step.after, map);
  const auto take = [&](const QString& member) { row[member] = after.value(member); };
  if (step.kind == StepKind::Rename) row[QStringLiteral("to")] = text(step.after->name);
  if (step.kind == StepKind::Retag) take(QStringLiteral("tags"));
  if (step.kind == StepKind::Retype) row[QStringLiteral("type")] = text(step.after->type);
  if (step.kind == StepKind::Move) {
    for (const QString& member : {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("yaw_rad")})
      take(member);
  }
  return row;
}

QJsonArray stepsJson(const std::vector<WaypointStep>& steps, const std::string& map) {
  QJsonArray rows;
  for (const WaypointStep& step : steps) rows << stepJson(step, map);
  return rows;
}

QString placeText(const map::Waypoint& point) {
  QString place =
      WaypointStepsText::tr("x %1 m, y %2 m").arg(figure(point.position_m.x()), figure(point.position_m.y()));
  if (point.yaw_rad)
    place += WaypointStepsText::tr(", %1°").arg(figure(geometry::degreesFromRadians(*point.yaw_rad)));
  return place;
}

QString tagText(const map::Waypoint& point) {
  QStringList tags;
  for (const std::string& tag : point.tags) tags << words::plainName(tag);
  return tags.isEmpty() ? QStringLiteral("-") : tags.join(QStringLiteral(", "));
}

QString detailOf(const WaypointStep& step) {
  switch (step.kind) {
    case StepKind::Create:
    case StepKind::Move:
      return placeText(*step.after);
    case StepKind::Rename:
      return words::plainName(step.after->name);
    case StepKind::Retag:
      return tagText(*step.after);
    case StepKind::Retype:
      return words::plainName(step.after->type);
    case StepKind::Delete:
      break;
  }
  return {};
}

QJsonArray callsJson(const robot::WaypointStore& store, const std::vector<robot::WaypointRequest>& requests,
                     const map::MapKey& map) {
  const std::string id = map::toText(map);
  QJsonArray calls;
  for (const robot::WaypointRequest& request : requests) {
    const robot::WaypointCall call = store.callOf(map, request);
    QJsonObject arguments = QJsonDocument::fromJson(QByteArray::fromStdString(call.arguments)).object();
    if (call.service.empty()) {
      std::vector<WaypointEdit> edits;
      for (const robot::WaypointChange& one : request.changes)
        edits.push_back({one.id, one.before, one.after});
      arguments = {{QStringLiteral("map"), text(id)},
                   {QStringLiteral("changes"), stepsJson(stepsOf(edits), id)}};
    }
    calls << QJsonObject{
        {QStringLiteral("service"), call.service.empty() ? QStringLiteral("write") : text(call.service)},
        {QStringLiteral("args"), arguments}};
  }
  return calls;
}

QJsonArray conflictsJson(const WaypointConflicts& conflicts, const std::string& map) {
  QJsonArray rows;
  for (const auto& [key, conflict] : conflicts) {
    const auto& known = conflict.base ? conflict.base : conflict.theirs ? conflict.theirs : conflict.mine;
    rows << QJsonObject{{QStringLiteral("id"), text(key)},
                        {QStringLiteral("name"), known ? text(known->name) : QString()},
                        {QStringLiteral("kind"), wordOf(conflict.kind)},
                        {QStringLiteral("fields"), QJsonArray::fromStringList(fieldWords(conflict.fields))},
                        {QStringLiteral("base"), rowOr(conflict.base, map)},
                        {QStringLiteral("mine"), rowOr(conflict.mine, map)},
                        {QStringLiteral("theirs"), rowOr(conflict.theirs, map)}};
  }
  return rows;
}

QStringList conflictLines(const WaypointConflicts& conflicts) {
  QStringList lines;
  for (const auto& [key, conflict] : conflicts) {
    const auto& known = conflict.base ? conflict.base : conflict.theirs ? conflict.theirs : conflict.mine;
    lines << QStringLiteral("%1  %2: %3")
                 .arg(words::plainName(key), words::plainName(known ? known->name : std::string()),
                      conflictText(conflict));
  }
  return lines;
}

}  // namespace mapwright::exchange
