#include "exchange/waypoint_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include <QCoreApplication>
#include <QJsonDocument>

#include "exchange/waypoint_json.h"
#include "geometry/pose.h"
#include "map/waypoint.h"
#include "sentences/failure_sentence.h"
#include "words/decimal.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::exchange {
namespace {

class WaypointStepsText {
  Q_DECLARE_TR_FUNCTIONS(WaypointSteps)
};

using words::text;

bool isNear(const map::Waypoint& wanted, const map::Waypoint& kept, double pixel_m) {
  const double off_m = (wanted.position_m - kept.position_m).cwiseAbs().maxCoeff();
  if (!map::samePlace(wanted.position_m, kept.position_m) && !(off_m <= 1.01 * pixel_m)) return false;
  // Some robots give everything a heading.
  if (!kept.yaw_rad) return !wanted.yaw_rad;
  return map::sameHeading(wanted.yaw_rad.value_or(0), *kept.yaw_rad);
}

QString figure(double value) { return words::decimal(value, 3); }

QJsonValue rowOr(const std::optional<map::Waypoint>& point, const std::string& map) {
  return point ? QJsonValue(waypointJson(*point, map)) : QJsonValue();
}

QString wordOf(edit::ConflictKind kind) {
  static constexpr std::array kWords{"both-changed", "deleted-here", "deleted-there", "both-added"};
  return QLatin1String(kWords.at(std::size_t(kind)));
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

std::string nameIn(const edit::Conflict& conflict) {
  const auto& known = conflict.base ? conflict.base : conflict.theirs ? conflict.theirs : conflict.mine;
  return known ? known->name : std::string();
}

QString conflictText(const edit::Conflict& conflict) {
  if (conflict.kind == edit::ConflictKind::DeletedHere)
    return WaypointStepsText::tr("you delete it, but it was changed on the robot");
  if (conflict.kind == edit::ConflictKind::DeletedThere)
    return WaypointStepsText::tr("you change it, but it was deleted on the robot");
  return WaypointStepsText::tr("it was changed on the robot, too (%1)")
      .arg(words::listed(fieldWords(conflict.fields)));
}

/// The stored state is what the request should produce.
bool isSo(const robot::WaypointRequest& request, const edit::WaypointDocument& document) {
  return std::all_of(request.changes.begin(), request.changes.end(), [&](const robot::WaypointChange& one) {
    const edit::Key key = document.ourName(one.id);
    const std::vector<WaypointStep> steps = stepsOf({{key, one.before, one.after}});
    return std::all_of(steps.begin(), steps.end(),
                       [&](const WaypointStep& step) { return isDone(step, document.findKept(key)); });
  });
}

/// What was not carried out for this reason was not even sent: nobody has refused it.
bool neverLeft(map::FailureKind kind) {
  return kind == map::FailureKind::Unreachable || kind == map::FailureKind::TimedOut ||
         kind == map::FailureKind::Cancelled;
}

}  // namespace

QString wordOf(StepKind kind) {
  static constexpr std::array kWords{"create", "move", "rename", "retag", "retype", "delete"};
  return QLatin1String(kWords.at(std::size_t(kind)));
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

bool isDone(const WaypointStep& step, const map::Waypoint* kept, double pixel_m) {
  if (step.kind == StepKind::Delete || !kept) return step.kind == StepKind::Delete && !kept;
  switch (step.kind) {
    case StepKind::Create:
      return isAlike(*step.after, *kept, pixel_m);
    case StepKind::Move:
      return isNear(*step.after, *kept, pixel_m);
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

bool isAlike(const map::Waypoint& wanted, const map::Waypoint& kept, double pixel_m) {
  return isNear(wanted, kept, pixel_m) && wanted.name == kept.name && wanted.tags == kept.tags &&
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
  const auto copyMember = [&](const QString& member) { row[member] = after.value(member); };
  if (step.kind == StepKind::Rename) row[QStringLiteral("to")] = text(step.after->name);
  if (step.kind == StepKind::Retag) copyMember(QStringLiteral("tags"));
  if (step.kind == StepKind::Retype) row[QStringLiteral("type")] = text(step.after->type);
  if (step.kind == StepKind::Move) {
    for (const QString& member : {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("yaw_rad")})
      copyMember(member);
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
  return tags.isEmpty() ? QStringLiteral("-") : words::listed(tags);
}

QString detailOf(const WaypointStep& step) {
  if (step.kind == StepKind::Delete) return {};
  if (step.kind == StepKind::Rename) return words::plainName(step.after->name);
  if (step.kind == StepKind::Retag) return tagText(*step.after);
  return step.kind == StepKind::Retype ? words::plainName(step.after->type) : placeText(*step.after);
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
    rows << QJsonObject{{QStringLiteral("id"), text(key)},
                        {QStringLiteral("name"), text(nameIn(conflict))},
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
    lines << QStringLiteral("%1  %2: %3")
                 .arg(words::plainName(key), words::plainName(nameIn(conflict)), conflictText(conflict));
  }
  return lines;
}

SentOutcome answered(const SentRequest& sent) {
  if (sent.state == SentRequest::State::Done) return {SentState::Applied};
  if (sent.state == SentRequest::State::InProgress) return {SentState::Unknown};
  if (sent.state != SentRequest::State::Failed) return {};
  map::Failure failure = *sent.failure;
  failure.asked_for = map::AskedFor::Change;
  const SentState state = failure.applied == map::Applied::Yes     ? SentState::Applied
                          : failure.applied == map::Applied::Maybe ? SentState::Unknown
                          : neverLeft(failure.kind)                ? SentState::NotSent
                                                                   : SentState::Failed;
  return {state, std::move(failure)};
}

SentOutcome judged(SentOutcome by_answer, bool is_so) {
  if (is_so) return {SentState::Applied};
  if (by_answer.state == SentState::Applied) {
    // A partial result says which part was applied.
    const bool says_why = by_answer.failure && by_answer.failure->reason == map::FailureReason::Unfit;
    return {SentState::Failed, says_why ? std::move(by_answer.failure) : std::nullopt};
  }
  // A request without an answer may still be carried out: not seeing its effect yet proves nothing.
  const bool may_come = !by_answer.failure || edit::isOfTheLink(*by_answer.failure);
  if (by_answer.state == SentState::Unknown && !may_come) {
    by_answer.state = SentState::Failed;
    by_answer.failure->applied = map::Applied::No;
  }
  return by_answer;
}

SentOutcome outcomeOf(const SentRequest& sent, const edit::WaypointDocument* looked) {
  SentOutcome outcome = answered(sent);
  const bool in_doubt = sent.state == SentRequest::State::Failed;
  return in_doubt && looked ? judged(std::move(outcome), isSo(sent.request, *looked)) : outcome;
}

SentCounts countsOf(const std::vector<SentRequest>& sent, const edit::WaypointDocument* looked) {
  std::map<SentState, std::size_t> counts;
  for (const SentRequest& one : sent) ++counts[outcomeOf(one, looked).state];
  return {counts[SentState::Applied], counts[SentState::Failed], counts[SentState::Unknown],
          counts[SentState::NotSent]};
}

QString sentenceOf(const SentOutcome& outcome) {
  if (outcome.state == SentState::Applied) return {};
  if (outcome.failure) return QString::fromStdString(sentences::sentenceOf(*outcome.failure));
  if (outcome.state == SentState::NotSent) return {};
  if (outcome.state == SentState::Unknown) return WaypointStepsText::tr("Whether it was changed is unknown.");
  return WaypointStepsText::tr("The robot accepted the change, but it has no effect.");
}

std::vector<TemporaryName> temporaryNamesIn(const WaypointItems& items) {
  std::vector<TemporaryName> found;
  for (const auto& [key, point] : items) {
    const std::string_view permanent = map::permanentName(point.name);
    if (!permanent.empty()) found.push_back({key, point.name, std::string(permanent)});
  }
  if (found.empty()) return found;
  std::set<std::string> names;
  for (const auto& [key, point] : items) names.insert(point.name);
  // Of two with the same original name only the first can have it back.
  for (TemporaryName& one : found) one.is_free = names.insert(one.permanent).second;
  return found;
}

}  // namespace mapwright::exchange
