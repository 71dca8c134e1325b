#include "exchange/waypoint_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include <QCoreApplication>
#include <QJsonDocument>
#include <QUuid>

#include "exchange/waypoint_json.h"
#include "sentences/plural.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::exchange {
namespace {

class WaypointPlanText {
  Q_DECLARE_TR_FUNCTIONS(WaypointPlan)
};

constexpr double kFarthestM = 1e7;
constexpr int kPlanVersion = 1;

using words::text;
QString plainShort(const std::string& name) { return words::plainName(text(name).left(80)); }

bool isOneLine(const std::string& line) {
  const QString name = text(line);
  return std::none_of(name.begin(), name.end(), [](QChar c) { return c.category() == QChar::Other_Control; });
}

/// Which of `kept` each of `wanted` is; "" = none of them.
tl::expected<std::vector<edit::Key>, QString> found(const WaypointItems& kept,
                                                    const std::vector<WantedWaypoint>& wanted,
                                                    Others others) {
  std::vector<edit::Key> keys(wanted.size());
  std::map<edit::Key, int> taken;  // in which row
  const auto claim = [&](std::size_t i, const edit::Key& key) -> std::optional<QString> {
    const auto [before, is_new] = taken.emplace(key, wanted[i].row);
    if (!is_new)
      return WaypointPlanText::tr("Rows %1 and %2 are about the same waypoint %3. Remove one of them.")
          .arg(QString::number(before->second), QString::number(wanted[i].row), plainShort(key));
    keys[i] = key;
    return std::nullopt;
  };
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!kept.contains(wanted[i].id)) continue;
    if (const auto twice = claim(i, wanted[i].id)) return wrong(*twice);
  }
  if (others == Others::Go) return keys;
  std::multimap<std::string, edit::Key> by_name;
  for (const auto& [key, point] : kept) {
    if (!taken.contains(key)) by_name.emplace(point.name, key);
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!keys[i].empty() || !wanted[i].name) continue;
    const auto [first, last] = by_name.equal_range(*wanted[i].name);
    if (first == last) continue;
    if (std::next(first) != last)
      return wrong(WaypointPlanText::tr("Row %1: several waypoints are called \"%2\" (%3, %4). Give the id.")
                       .arg(QString::number(wanted[i].row), plainShort(first->first),
                            plainShort(first->second), plainShort(std::next(first)->second)));
    if (const auto twice = claim(i, first->second)) return wrong(*twice);
  }
  return keys;
}

map::Waypoint withWanted(map::Waypoint point, const WantedWaypoint& wanted) {
  if (wanted.name) point.name = *wanted.name;
  if (wanted.type) point.type = *wanted.type;
  if (wanted.position_m) point.position_m = *wanted.position_m;
  if (wanted.yaw_rad) point.yaw_rad = *wanted.yaw_rad;
  if (wanted.tags) point.tags = *wanted.tags;
  return point;
}

/// The change of a plan's row, on top of those before; returns its waypoint.
tl::expected<edit::Key, QString> addRow(const QJsonObject& row, const WaypointItems& base,
                                        std::map<edit::Key, WaypointEdit>& edits) {
  const QString kind = row.value(QLatin1String("kind")).toString();
  const auto read = wantedFromJson(row);
  if (!read) return wrong(read.error());
  if (kind == wordOf(StepKind::Create)) {
    const auto point = waypointFromJson(row);
    if (!point) return wrong(point.error());
    const edit::Key key = point->id.empty() ? freshKey() : point->id;
    const bool is_new =
        !base.contains(key) && edits.emplace(key, WaypointEdit{key, std::nullopt, *point}).second;
    if (!is_new) return wrong(WaypointPlanText::tr("a waypoint %1 already exists.").arg(plainShort(key)));
    return key;
  }
  const auto before = base.find(read->id);
  if (before == base.end())
    return wrong(WaypointPlanText::tr("the base of the plan has no waypoint %1.").arg(plainShort(read->id)));
  WaypointEdit& edit =
      edits.try_emplace(read->id, WaypointEdit{read->id, before->second, before->second}).first->second;
  if (kind == wordOf(StepKind::Delete)) {
    edit.after.reset();
    return read->id;
  }
  if (!edit.after) return wrong(WaypointPlanText::tr("%1 is already deleted.").arg(plainShort(read->id)));
  const QJsonValue to = row.value(QLatin1String("to"));
  if (kind == wordOf(StepKind::Move) && read->position_m) {
    edit.after->position_m = *read->position_m;
    if (read->yaw_rad) edit.after->yaw_rad = *read->yaw_rad;
  } else if (kind == wordOf(StepKind::Rename) && to.isString()) {
    edit.after->name = to.toString().toStdString();
  } else if (kind == wordOf(StepKind::Retag) && read->tags) {
    edit.after->tags = *read->tags;
  } else if (kind == wordOf(StepKind::Retype) && read->type) {
    edit.after->type = *read->type;
  } else {
    return wrong(WaypointPlanText::tr("it does not say what to change about %1.").arg(plainShort(read->id)));
  }
  return read->id;
}

}  // namespace

edit::Key freshKey() { return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString(); }

QString notKeptReason(const std::optional<map::Waypoint>& before, const map::Waypoint& after) {
  if (!before || before->name != after.name) {
    if (text(after.name).trimmed().isEmpty()) return WaypointPlanText::tr("A waypoint must have a name.");
    if (!isOneLine(after.name))
      return WaypointPlanText::tr("The name of a waypoint must be one line without control characters.");
  }
  if (!before || before->tags != after.tags) {
    for (const std::string& tag : after.tags) {
      if (text(tag).trimmed().isEmpty() || !isOneLine(tag))
        return WaypointPlanText::tr("A tag must be one line without control characters, and not empty.");
    }
    if (std::set<std::string>(after.tags.begin(), after.tags.end()).size() != after.tags.size())
      return WaypointPlanText::tr("A tag appears twice.");
  }
  if (!before || before->position_m != after.position_m) {
    if (!(after.position_m.cwiseAbs().maxCoeff() <= kFarthestM))
      return WaypointPlanText::tr("Its position is more than %1 m from the origin.")
          .arg(kFarthestM, 0, 'f', 0);
  }
  return {};
}

QString notRemovedReason(const robot::KeptFields& keeps) {
  if (keeps.removal) return {};
  return WaypointPlanText::tr("Waypoints of this robot cannot be deleted from here.");
}

FittedEdits fitted(std::vector<WaypointEdit> edits, const robot::KeptFields& keeps) {
  qint64 typed = 0, tagged = 0, unturned = 0, unmoved = 0;
  for (WaypointEdit& edit : edits) {
    if (!edit.after) continue;
    const map::Waypoint as_wanted = *edit.after;
    edit::fit(*edit.after, keeps, edit.before ? &*edit.before : nullptr);
    unmoved += map::samePlace(edit.after->position_m, as_wanted.position_m) ? 0 : 1;
    tagged += edit.after->tags != as_wanted.tags ? 1 : 0;
    typed += !keeps.type && edit.after->type != as_wanted.type ? 1 : 0;
    unturned += edit.after->yaw_rad != as_wanted.yaw_rad ? 1 : 0;
  }
  const auto staying = qint64(keeps.removal ? 0 : std::erase_if(edits, [](const WaypointEdit& edit) {
    return edit.before && !edit.after;
  }));
  std::erase_if(edits, [](const WaypointEdit& edit) { return edit::same(edit.before, edit.after); });
  FittedEdits fitted{std::move(edits), {}};
  if (typed > 0)
    fitted.notes << sentences::counted(
        WaypointPlanText::tr("Waypoint types cannot be stored here: those of %1 waypoints are left out.",
                             nullptr, sentences::formOf(typed)),
        typed);
  if (tagged > 0)
    fitted.notes << sentences::counted(
        WaypointPlanText::tr("Tags cannot be stored here: those of %1 waypoints are left out.", nullptr,
                             sentences::formOf(tagged)),
        tagged);
  if (unturned > 0)
    fitted.notes << sentences::counted(
        WaypointPlanText::tr("Every waypoint needs a heading here: %1 waypoints without one get 0°.", nullptr,
                             sentences::formOf(unturned)),
        unturned);
  if (staying > 0)
    fitted.notes << sentences::counted(
        WaypointPlanText::tr("Waypoints cannot be deleted here: %1 waypoints that should go stay.", nullptr,
                             sentences::formOf(staying)),
        staying);
  if (unmoved > 0)
    fitted.notes << sentences::counted(
        WaypointPlanText::tr(
            "Waypoints are kept on pixels of %2 m here: %1 waypoints stay where they are, less "
            "than half a pixel from where they should be.",
            nullptr, sentences::formOf(unmoved))
            .replace(QLatin1String("%2"), QString::number(keeps.pixel_m)),
        unmoved);
  return fitted;
}

QString refusedText(const std::set<edit::Key>& refused, const std::vector<WaypointEdit>& edits) {
  constexpr int kNamed = 3;
  QStringList names;
  qint64 count = 0;
  for (const WaypointEdit& edit : edits) {
    if (!edit.after || !refused.contains(edit.key)) continue;
    ++count;
    names << plainShort(edit.after->name);
  }
  if (count == 0) return {};
  names.removeDuplicates();
  if (names.size() > kNamed) names = names.mid(0, kNamed) << QStringLiteral("…");
  const QString what = sentences::counted(
      WaypointPlanText::tr("%1 waypoints are not sent: the robot does not allow duplicate names", nullptr,
                           sentences::formOf(count)),
      count);
  return WaypointPlanText::tr("%1 (%2).").arg(what, words::listed(names));
}

WaypointEdits editsFor(const WaypointItems& kept, const std::vector<WantedWaypoint>& wanted, Others others) {
  const auto keys = found(kept, wanted, others);
  if (!keys) return tl::make_unexpected(keys.error());
  std::vector<WaypointEdit> edits;
  std::set<edit::Key> listed;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const WantedWaypoint& row = wanted[i];
    const auto inRow = [&](const QString& why) {
      return wrong(WaypointPlanText::tr("Row %1: %2").arg(QString::number(row.row), why));
    };
    WaypointEdit edit;
    const auto before = kept.find((*keys)[i]);
    // Its numbers are meant in that frame: in another one they would be another place.
    if (!row.frame.empty() && (before == kept.end() || frameOf(before->second) != row.frame))
      return inRow(
          WaypointPlanText::tr("the frame is \"%1\". Only \"map\" is supported.").arg(plainShort(row.frame)));
    if (before != kept.end()) {
      edit = {before->first, before->second, withWanted(before->second, row)};
    } else {
      if (!row.position_m) return inRow(WaypointPlanText::tr("A new waypoint needs a position (x and y)."));
      map::Waypoint fresh;
      fresh.id = row.id;
      edit = {row.id.empty() ? freshKey() : row.id, std::nullopt, withWanted(fresh, row)};
    }
    if (!listed.insert(edit.key).second)
      return inRow(WaypointPlanText::tr("The waypoint %1 appears twice. Remove one of them.")
                       .arg(plainShort(edit.key)));
    if (const QString why = notKeptReason(edit.before, *edit.after); !why.isEmpty()) return inRow(why);
    if (!edit::same(edit.before, edit.after)) edits.push_back(std::move(edit));
  }
  if (others == Others::Stay) return edits;
  for (const auto& [key, point] : kept) {
    if (!listed.contains(key)) edits.push_back({key, point, std::nullopt});
  }
  return edits;
}

MergedEdits merged(const std::vector<WaypointEdit>& edits, const WaypointItems& now) {
  MergedEdits merged;
  for (const WaypointEdit& edit : edits) {
    const auto found = now.find(edit.key);
    const std::optional<map::Waypoint> theirs =
        found == now.end() ? std::nullopt : std::optional(found->second);
    auto together = edit::merge(edit.before, edit.after, theirs);
    if (together.conflict) {
      merged.conflicts.emplace(edit.key, std::move(*together.conflict));
    } else if (!edit::same(theirs, together.item)) {
      merged.edits.push_back({edit.key, theirs, std::move(together.item)});
    }
  }
  return merged;
}

QByteArray planBytes(const WaypointPlan& plan, const QJsonArray& calls) {
  QJsonArray base;
  for (const auto& [key, point] : plan.base) base << waypointJson(point, plan.map);
  const QJsonObject json{{QStringLiteral("mapwright"), QStringLiteral("waypoint-plan")},
                         {QStringLiteral("version"), kPlanVersion},
                         {QStringLiteral("robot"), plan.robot},
                         {QStringLiteral("map"), text(plan.map)},
                         {QStringLiteral("base"), base},
                         {QStringLiteral("changes"), stepsJson(stepsOf(plan.edits), plan.map)},
                         {QStringLiteral("calls"), calls},
                         {QStringLiteral("conflicts"), QJsonArray()}};
  return words::escapedJson(QJsonDocument(json).toJson());
}

tl::expected<WaypointPlan, QString> planFromBytes(std::string_view bytes) {
  QJsonParseError error;
  const QJsonObject json =
      QJsonDocument::fromJson(QByteArray::fromRawData(bytes.data(), qsizetype(bytes.size())), &error)
          .object();
  if (error.error != QJsonParseError::NoError)
    return wrong(
        WaypointPlanText::tr("It is not JSON (%1, byte %2).").arg(error.errorString()).arg(error.offset));
  const QJsonValue base = json.value(QLatin1String("base")), changes = json.value(QLatin1String("changes"));
  if (json.value(QLatin1String("mapwright")).toString() != QLatin1String("waypoint-plan") ||
      !base.isArray() || !changes.isArray())
    return wrong(WaypointPlanText::tr("It is not a plan written by mapwright waypoints plan -o."));
  if (json.value(QLatin1String("version")).toInt() != kPlanVersion)
    return wrong(
        WaypointPlanText::tr("The plan was made by another version of this program. Make a new plan."));
  WaypointPlan plan;
  plan.robot = json.value(QLatin1String("robot")).toString();
  plan.map = json.value(QLatin1String("map")).toString().toStdString();
  int row = 0;
  for (const QJsonValue& value : base.toArray()) {
    ++row;
    auto point = waypointFromJson(value.toObject());
    if (!point || point->id.empty() || !plan.base.emplace(point->id, *point).second)
      return wrong(
          WaypointPlanText::tr("Waypoint %1 in the base of the plan cannot be read. Make a new plan.")
              .arg(row));
  }
  row = 0;
  std::map<edit::Key, WaypointEdit> edits;
  std::vector<edit::Key> order;  // of the file
  for (const QJsonValue& value : changes.toArray()) {
    ++row;
    const std::size_t known = edits.size();
    const auto added = addRow(value.toObject(), plan.base, edits);
    if (!added) return wrong(WaypointPlanText::tr("Change %1: %2").arg(QString::number(row), added.error()));
    if (edits.size() > known) order.push_back(*added);
  }
  for (const edit::Key& key : order) {
    WaypointEdit& edit = edits.at(key);
    const QString why = edit.after ? notKeptReason(edit.before, *edit.after) : QString();
    if (!why.isEmpty()) return wrong(words::about(plainShort(key), why));
    plan.edits.push_back(std::move(edit));
  }
  return plan;
}

std::vector<WaypointEdit> withoutCreated(const WaypointPlan& plan, const WaypointItems& now) {
  std::vector<WaypointEdit> edits;
  std::set<edit::Key> taken;  // an existing one may only be meant once
  for (const WaypointEdit& edit : plan.edits) {
    if (edit.before) {
      edits.push_back(edit);
      continue;
    }
    // Robots may give what they create other tags or another type.
    map::Waypoint wanted = *edit.after;
    const auto there = std::find_if(now.begin(), now.end(), [&](const auto& one) {
      wanted.tags = one.second.tags;
      wanted.type = one.second.type;
      return !plan.base.contains(one.first) && isAlike(wanted, one.second) && taken.insert(one.first).second;
    });
    if (there == now.end()) {
      edits.push_back(edit);
    } else if (!isAlike(*edit.after, there->second)) {
      WaypointEdit rest{there->first, there->second, there->second};
      rest.after->tags = edit.after->tags;
      rest.after->type = edit.after->type;
      edits.push_back(std::move(rest));
    }
  }
  return edits;
}

}  // namespace mapwright::exchange
