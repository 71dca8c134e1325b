#include "app/command_map.h"

#include <algorithm>
#include <cmath>

#include "app/command_text.h"
#include "disk/read_file.h"
#include "grids/grid_pyramid.h"
#include "map/live_state.h"
#include "placing/warnings.h"
#include "robot/sends_map.h"
#include "sentences/problem_sentence.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

constexpr double kMapWithinS = 20;   // the command waits at most this long for its picture
constexpr double kModelWithinS = 2;  // for the robot's footprint

}  // namespace

bool isPlainId(const std::string& id) {
  const QString plain = text(id);
  const auto odd = [](QChar c) {
    return c.isSpace() || c.category() == QChar::Other_Control || c.category() == QChar::Other_Format ||
           QStringLiteral("/\\?#%").contains(c);
  };
  return !plain.isEmpty() && plain != QLatin1String(".") && plain != QLatin1String("..") &&
         std::none_of(plain.begin(), plain.end(), odd);
}

CommandResult<map::MapKey> storedMap(RobotReading& robot, const std::string& id) {
  const map::MapKey named = map::mapKeyFromText(id);
  if (!id.empty() && !robot.local()) {
    if (named.kind == map::MapKind::Stored && isPlainId(named.id)) return named;
    return robot.failure(
        kUsage, Text::tr("--map %1: pass the id of a stored map (see mapwright maps list).").arg(text(id)));
  }
  const auto rows = robot.catalogue();
  if (!rows) return passOn(rows);
  const session::Catalogue& catalogue = robot.session().catalogue();
  const map::CatalogueEntry* entry = id.empty() ? catalogue.current() : catalogue.called(id);
  if (!entry && id.empty() && (*rows)->size() == 1) entry = &(*rows)->front();
  if (entry) return entry->key;
  if (!id.empty())
    return robot.failure(kUsage, Text::tr("There is no map %1 (see mapwright maps list).").arg(text(id)));
  return (*rows)->empty()
             ? robot.failure(kRobotError, Text::tr("There are no maps."))
             : robot.failure(
                   kRobotError,
                   Text::tr("None of its maps is the current one. Pass --map ID (see mapwright maps list)."));
}

MapBelow mapBelow(RobotReading& reading, const map::MapKey& key) {
  session::Session& session = reading.session();
  const session::MapSlot& slot = session.wholeMap();
  const map::CatalogueEntry* const entry = session.catalogue().find(key);
  // It may be gigabytes, and nobody asked for it.
  if (entry && entry->is_current && robot::givesByRegion(session.robot()))
    return {{}, Text::tr("The robot sends it by region.")};
  session.openMap(key);
  const bool in_time = reading.waitUntil([&] { return slot.key() == key && slot.settled(); }, kMapWithinS);
  if (slot.shown().key == key && slot.isWhole()) return {{slot.cells(), slot.reference()}, {}};
  if (slot.remark()) return {{}, sentences::sentenceOf(*slot.remark())};
  return {{}, in_time ? QString() : Text::tr("It had not arrived in time.")};
}

double robotRadius(RobotReading& reading) {
  session::Session& session = reading.session();
  const auto told = [&] { return placing::radiusOf(session.live().model); };
  robot::LiveTopics* const live = session.robot().liveTopics();
  if (live && !live->topicsOf(map::Stream::Model).isEmpty()) {
    session.want(QStringLiteral("waypoints"), {map::Stream::Model});
    reading.waitUntil([&] { return told() > 0; }, kModelWithinS);
  }
  return told() > 0 ? told() : placing::kUsualRadiusM;
}

tl::expected<std::optional<double>, QString> radiusFrom(const std::string& word) {
  if (word.empty()) return std::nullopt;
  bool ok = false;
  const double metres = QString::fromStdString(word).toDouble(&ok);
  if (ok && std::isfinite(metres) && metres >= 0 && metres <= placing::kMostRadiusM)
    return std::optional(metres);
  return tl::make_unexpected(Text::tr("--radius %1: give metres from 0 to %2, for example 0.3.")
                                 .arg(QString::fromStdString(word))
                                 .arg(placing::kMostRadiusM));
}

tl::expected<std::string, disk::FileError> bytesOf(const std::string& path, std::size_t most) {
  return isStandardInput(path) ? disk::readStandardInput(most + 1) : disk::readFile(path, most + 1);
}

QString inputCalled(const std::string& path) {
  return isStandardInput(path) ? Text::tr("The standard input") : text(path);
}

}  // namespace mapwright::app
