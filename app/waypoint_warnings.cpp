#include "app/waypoint_warnings.h"

#include <chrono>
#include <cmath>
#include <set>

#include <QCoreApplication>
#include <QJsonObject>

#include "sentences/fault_sentence.h"
#include "sentences/placing_sentence.h"
#include "sentences/problem_sentence.h"

namespace mapwright::app {
namespace {

class WaypointWarningsText {
  Q_DECLARE_TR_FUNCTIONS(WaypointWarnings)
};

constexpr double kMapWithinS = 20;   // the command waits at most this long for its picture
constexpr double kModelWithinS = 2;  // for the robot's footprint

struct Ground {
  placing::PlacedMap map;
  QString why_not;
};

Ground groundOf(MapReading& reading, const map::MapKey& key) {
  session::Session& session = reading.session();
  const session::MapSlot& slot = session.wholeMap();
  session.openMap(key);
  const bool in_time = reading.waitUntil([&] { return slot.key() == key && slot.settled(); }, kMapWithinS);
  if (slot.cells() && slot.shown().key == key && slot.cells()->complete())
    return {{slot.cells(), slot.reference()}, {}};
  if (slot.remark()) return {{}, sentences::sentenceOf(*slot.remark())};
  return {{}, in_time ? QString() : WaypointWarningsText::tr("It had not arrived in time.")};
}

double radiusOf(MapReading& reading) {
  session::Session& session = reading.session();
  const auto told = [&] { return placing::radiusOf(session.live().model); };
  robot::LiveTopics* const live = session.robot().liveTopics();
  if (live && !live->topicsOf(map::Stream::Model).isEmpty()) {
    session.want(QStringLiteral("waypoints"), {map::Stream::Model});
    reading.waitUntil([&] { return told() > 0; }, kModelWithinS);
  }
  return told() > 0 ? told() : placing::kUsualRadiusM;
}

QString stableWordOf(placing::WarningKind kind) {
  using placing::WarningKind;
  switch (kind) {
    case WarningKind::InWall:
      return QStringLiteral("in_wall");
    case WarningKind::OutsideMap:
      return QStringLiteral("outside_map");
    case WarningKind::NearWall:
      return QStringLiteral("near_wall");
    case WarningKind::OnUnknown:
      return QStringLiteral("on_unknown");
    case WarningKind::NameTwice:
      return QStringLiteral("name_twice");
    case WarningKind::TemporaryName:
      return QStringLiteral("temporary_name");
    case WarningKind::ZeroTurn:
      break;
  }
  return QStringLiteral("zero_turn");
}

}  // namespace

tl::expected<std::optional<double>, QString> radiusFrom(const std::string& word) {
  if (word.empty()) return std::nullopt;
  bool ok = false;
  const double metres = QString::fromStdString(word).toDouble(&ok);
  if (ok && std::isfinite(metres) && metres >= 0 && metres <= placing::kMostRadiusM)
    return std::optional(metres);
  return tl::make_unexpected(
      WaypointWarningsText::tr("--radius %1: give metres from 0 to %2, for example 0.3.")
          .arg(QString::fromStdString(word))
          .arg(placing::kMostRadiusM));
}

DoubtfulWaypoints doubtsOf(const ListedWaypoints& list, const std::vector<map::Waypoint>& points,
                           std::optional<double> radius_m) {
  const double radius = radius_m ? *radius_m : radiusOf(*list.robot);
  const Ground ground = groundOf(*list.robot, list.map);
  std::vector<Eigen::Vector2d> places;
  places.reserve(points.size());
  std::vector<std::string> names;
  for (const map::Waypoint& point : points) {
    places.push_back(point.position_m);
    names.push_back(point.name);
  }
  const std::set<std::string> twice = placing::namesTwice(names);
  const placing::GroundWarnings found = placing::groundWarnings(places, ground.map, radius, nullptr);
  DoubtfulWaypoints doubtful;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool zero_turn = points[i].yaw_rad == 0.0 && list.stored.zero_turns.contains(points[i].id);
    doubtful.of.push_back(
        placing::together(found.of[i], points[i].name, twice.contains(points[i].name), zero_turn));
  }
  doubtful.looked = found.state != placing::GroundState::None;
  if (!doubtful.looked) {
    doubtful.untold = WaypointWarningsText::tr(
        "The map under the waypoints cannot be read, so they are not checked for walls.");
    if (!ground.why_not.isEmpty()) doubtful.untold += QLatin1Char(' ') + ground.why_not;
  } else {
    doubtful.untold = sentences::sentenceOf(found.state);
  }
  return doubtful;
}

QJsonArray warningsJson(const placing::Warnings& warnings) {
  QJsonArray rows;
  for (const placing::Warning& warning : warnings) {
    QJsonObject row{{QStringLiteral("kind"), stableWordOf(warning.kind)},
                    {QStringLiteral("sentence"), sentences::sentenceOf(warning)}};
    if (warning.kind == placing::WarningKind::NearWall) {
      row[QStringLiteral("distance_m")] = warning.distance_m;
      row[QStringLiteral("radius_m")] = warning.radius_m;
    }
    rows << row;
  }
  return rows;
}

QString warningsLine(const placing::Warnings& warnings) {
  return sentences::sentencesOf(warnings).replace(QLatin1Char('\n'), QLatin1Char(' '));
}

}  // namespace mapwright::app
