// The report as values, for programs.
#include <QJsonArray>

#include "incident/report.h"
#include "map/safety.h"
#include "sentences/subject_name.h"
#include "words/text.h"

namespace mapwright::incident {
namespace {

QJsonValue orNothing(const std::optional<double>& value) {
  return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
}

QJsonObject runJson(const Run& run) {
  const map::LiveState& live = run.live;
  QJsonArray conditions, safety, jumps, things, unknown;
  for (const auto& [said, code_since_s] : run.conditions.all) {
    const QString name = sentences::nameOf(map::problemOf(said).subject);
    conditions.append(name);
    safety.append(QJsonObject{{QStringLiteral("condition"), name},
                              {QStringLiteral("code"), qint64(said.code)},
                              {QStringLiteral("text"), words::text(said.text)},
                              {QStringLiteral("since"), said.since_s},
                              {QStringLiteral("code_since"), code_since_s}});
  }
  for (const NamedJump& jump : namedJumps(run))
    jumps.append(QJsonObject{{QStringLiteral("at"), jump.at_s},
                             {QStringLiteral("metres"), jump.metres},
                             {QStringLiteral("with_loss"), jump.with_loss}});
  for (const OnTheWay& thing : onTheWay(remainingWay(live), radiusOf(live.model), run.overlays, live.doors))
    things.append(QJsonObject{{QStringLiteral("along_m"), thing.along_m},
                              {QStringLiteral("away_m"), thing.away_m},
                              {QStringLiteral("type"), thing.type},
                              {QStringLiteral("name"), words::text(thing.name)}});
  for (const QString& sentence : notKnown(run)) unknown.append(sentence);
  std::optional<double> speed;
  for (const Curve& curve : run.curves) {
    if (curve.quantity == series::Quantity::Speed) speed = curve.at_moment;
  }
  return {{QStringLiteral("name"), words::text(run.name)},
          {QStringLiteral("at"), run.at_s},
          {QStringLiteral("pose"),
           live.robot_pose ? QJsonValue(QJsonObject{{QStringLiteral("x"), live.robot_pose->x_m},
                                                    {QStringLiteral("y"), live.robot_pose->y_m},
                                                    {QStringLiteral("yaw_rad"), live.robot_pose->yaw_rad}})
                           : QJsonValue(QJsonValue::Null)},
          {QStringLiteral("speed"), orNothing(speed)},
          {QStringLiteral("conditions"), conditions},
          {QStringLiteral("safety"), safety},
          {QStringLiteral("poor_since"), orNothing(run.conditions.poor_since_s)},
          {QStringLiteral("jumps"), jumps},
          {QStringLiteral("on_the_way"), things},
          {QStringLiteral("not_known"), unknown}};
}

}  // namespace

QJsonObject reportJson(const Report& report) {
  QJsonObject all = runJson(report.run);
  if (!report.against) return all;
  QJsonObject against = runJson(*report.against);
  against[QStringLiteral("metres")] = orNothing(report.against_m);
  all[QStringLiteral("against")] = against;
  return all;
}

}  // namespace mapwright::incident
