#include "edit/waypoint_fields.h"

#include <cmath>

#include <QJsonArray>

#include "words/text.h"

namespace mapwright::edit {
namespace {

using words::text;

}  // namespace

QJsonObject ItemJson<map::Waypoint>::write(const map::Waypoint& point) {
  QJsonObject object{
      {QStringLiteral("id"), text(point.id)},        {QStringLiteral("name"), text(point.name)},
      {QStringLiteral("type"), text(point.type)},    {QStringLiteral("x_m"), point.position_m.x()},
      {QStringLiteral("y_m"), point.position_m.y()}, {QStringLiteral("source"), text(point.source)}};
  if (point.yaw_rad) object[QStringLiteral("yaw_rad")] = *point.yaw_rad;
  QJsonArray tags;
  for (const std::string& tag : point.tags) tags << text(tag);
  object[QStringLiteral("tags")] = tags;
  return object;
}

std::optional<map::Waypoint> ItemJson<map::Waypoint>::read(const QJsonObject& object) {
  map::Waypoint point;
  for (const auto& [name, into] : {std::pair{"id", &point.id},
                                   {"name", &point.name},
                                   {"type", &point.type},
                                   {"source", &point.source}}) {
    const QJsonValue value = object.value(QLatin1String(name));
    if (!value.isString()) return std::nullopt;
    *into = value.toString().toStdString();
  }
  const QJsonValue x = object.value(QLatin1String("x_m")), y = object.value(QLatin1String("y_m")),
                   yaw = object.value(QLatin1String("yaw_rad")), tags = object.value(QLatin1String("tags"));
  if (!x.isDouble() || !y.isDouble() || !tags.isArray()) return std::nullopt;
  point.position_m = {x.toDouble(), y.toDouble()};
  if (yaw.isDouble()) point.yaw_rad = yaw.toDouble();
  if (!point.position_m.allFinite() || !std::isfinite(point.yaw_rad.value_or(0))) return std::nullopt;
  for (const QJsonValue& tag : tags.toArray()) {
    if (!tag.isString()) return std::nullopt;
    point.tags.push_back(tag.toString().toStdString());
  }
  return point;
}

void fit(map::Waypoint& point, const robot::KeptFields& keeps) {
  if (!keeps.type) point.type.clear();
  if (!keeps.no_heading && !point.yaw_rad) point.yaw_rad = 0;
}

std::set<Key> refusedNames(const Items<map::Waypoint>& kept,
                           const std::vector<Change<map::Waypoint>>& changes,
                           const robot::KeptFields& keeps) {
  std::set<Key> refused;
  if (keeps.name_twice) return refused;
  std::map<Key, std::string> names;  // afterwards
  for (const auto& [key, point] : kept) names[key] = point.name;
  for (const Change<map::Waypoint>& one : changes) {
    one.after ? void(names[one.key] = one.after->name) : void(names.erase(one.key));
  }
  // A refused waypoint keeps its name, for which another one may be waiting.
  for (bool any = true; any;) {
    any = false;
    std::map<std::string, int> bearers;
    for (const auto& [key, name] : names) ++bearers[name];
    for (const Change<map::Waypoint>& one : changes) {
      const bool named = one.after && (!one.before || one.before->name != one.after->name);
      if (!named || refused.contains(one.key) || bearers[one.after->name] < 2) continue;
      refused.insert(one.key);
      one.before ? void(names[one.key] = one.before->name) : void(names.erase(one.key));
      any = true;
    }
  }
  return refused;
}

}  // namespace mapwright::edit
