#include "ui/objects/object_facts.h"

#include <cmath>

#include <QCoreApplication>
#include <QDateTime>

#include "submap/submap_store.h"
#include "ui/kit/status_text.h"
#include "ui/objects/map_facts.h"
#include "ui/scene/lengths.h"
#include "ui/view/notice_bar.h"
#include "ui/view/replay_state.h"
#include "words/listed.h"
#include "words/qt_versions.h"

namespace mapwright::ui {
namespace {

class FactText {
  Q_DECLARE_TR_FUNCTIONS(ObjectFacts)
};

constexpr double kMillimetres = 0.001;  // a scale that shows them

QString clockText(double at_s, bool utc) {
  const qint64 at_ms = std::llround(at_s * 1000);
  const QDateTime at = utc ? words::utcOfMs(at_ms) : QDateTime::fromMSecsSinceEpoch(at_ms);
  return at.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

/// Of a thing that belongs to a map that was opened.
QString mapOf(const scene::MapObject& object, const session::Session& session) {
  const session::MapSlot& slot =
      object.id.of == scene::FeaturesOf::ComparedMap ? session.comparedMap() : session.wholeMap();
  QString text = mapOnScreen(slot);
  const map::CatalogueEntry* const entry = map::entryOf(session.catalogue().entries(), slot.shown().key);
  if (entry && entry->map_version) text += FactText::tr(", version %1").arg(*entry->map_version);
  return text;
}

/// Adds from which message it comes, and how old that is.
std::vector<scene::ObjectProperty> withSource(std::vector<scene::ObjectProperty> facts,
                                              const scene::MapObject& object, const session::Session& session,
                                              const QDateTime& now) {
  const auto heard = object.topic < 0 ? std::nullopt : session.heard(object.topic);
  if (!heard) return facts;
  const bool replay = replayOf(&session) != nullptr;
  const double now_s = replay ? session.world().at_s : double(now.toMSecsSinceEpoch()) / 1000;
  if (!heard->topic.isEmpty())
    facts.push_back({FactText::tr("Topic"), plainWords(heard->topic.toStdString(), 120)});
  facts.push_back({FactText::tr("Last message"),
                   FactText::tr("%1 (%2 ago)")
                       .arg(clockText(heard->last_s, replay), lengthText(qint64(now_s - heard->last_s)))});
  if (heard->unchanged_s < heard->last_s)
    facts.push_back({FactText::tr("The same since"), clockText(heard->unchanged_s, replay)});
  return facts;
}

}  // namespace

std::vector<scene::ObjectProperty> factsOf(const scene::MapObject& object, const session::Session& session,
                                           const QDateTime& now,
                                           const std::optional<grids::CellCounts>& counts) {
  std::vector<scene::ObjectProperty> facts;
  const auto add = [&](const QString& name, const QString& value) {
    if (!value.isEmpty()) facts.push_back({name, value});
  };
  facts = object.properties;
  if (object.id.layer == scene::Layer::WholeMap) {
    const bool compared = object.id.of == scene::FeaturesOf::ComparedMap;
    facts = mapFacts(compared ? session.comparedMap() : session.wholeMap(), session, counts);
    return withSource(std::move(facts), object, session, now);
  }
  if (const auto submap = scene::submapOf(object.id); submap && session.submaps().find(*submap))
    add(FactText::tr("Status"), statusWord(session.status(*submap)));
  add(object.form == scene::ObjectForm::Point ? FactText::tr("Position") : FactText::tr("Middle"),
      coordinatesText(object.at_m, kMillimetres));
  if (object.yaw_rad && std::isfinite(*object.yaw_rad))
    add(FactText::tr("Heading"), rotationText(*object.yaw_rad));
  if (object.form == scene::ObjectForm::Line)
    add(FactText::tr("Length"), scene::lengthText(object.lengthM()));
  if (object.form == scene::ObjectForm::Area) add(FactText::tr("Area"), scene::areaText(object.areaM2()));
  if (const auto& robot = session.live().robot_pose;
      robot && object.id.layer != scene::Layer::Robot && object.form == scene::ObjectForm::Point)
    add(FactText::tr("From the robot"),
        scene::lengthText((object.at_m - Eigen::Vector2d(robot->x_m, robot->y_m)).norm()));
  if (object.id.of != scene::FeaturesOf::Robot) add(FactText::tr("Belongs to"), mapOf(object, session));
  return withSource(std::move(facts), object, session, now);
}

QString calledInFull(const scene::MapObject& object) {
  if (object.name.isEmpty()) return object.kind;
  // "Waypoint 29" is one already.
  if (object.name.startsWith(object.kind + QLatin1Char(' '), Qt::CaseInsensitive)) return object.name;
  return QStringLiteral("%1 %2").arg(object.kind, object.name);
}

QString asText(const scene::MapObject& object, const std::vector<scene::ObjectProperty>& facts) {
  QStringList lines{calledInFull(object)};
  for (const scene::ObjectProperty& fact : facts) lines << words::about(fact.name, fact.value);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace mapwright::ui
