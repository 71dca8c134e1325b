#include "app/map_operand.h"

#include <cmath>

#include <QFileInfo>

#include "app/command_map.h"
#include "app/command_text.h"
#include "app/robot_factory.h"
#include "robot/address.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

/// Whether it is a file or address of its own, not a map of `robot`.
bool standsAlone(const QString& operand, const QString& robot) {
  if (operand.contains(QLatin1Char('/')) || knownAddresses().isAddress(operand)) return true;
  // An address, refused because of the part before its @: maps have no such names.
  if (robot.isEmpty() && operand.contains(QLatin1Char('@')) && !QFileInfo(operand).isFile()) return true;
  // In a folder of maps their names are ids.
  const auto folder = knownAddresses().parse(robot);
  if (folder && !folder->path.isEmpty() && QFileInfo(folder->path + QLatin1Char('/') + operand).isFile()) {
    return false;
  }
  const QStringList kinds{QStringLiteral("yaml"), QStringLiteral("yml"), QStringLiteral("png"),
                          QStringLiteral("pgm"), QStringLiteral("bmp")};
  // A file that happens to have the name of one of the robot's maps is not that map.
  return kinds.contains(QFileInfo(operand).suffix().toLower()) ||
         (robot.isEmpty() && QFileInfo(operand).isFile());
}

/// ID@ADDRESS, unless there is a file of that name.
std::optional<MapOperand> ofAnotherRobot(const QString& typed) {
  const qsizetype at = typed.indexOf(QLatin1Char('@'));
  if (at <= 0 || QFileInfo(typed).isFile()) return std::nullopt;
  const QString id = typed.left(at), address = typed.mid(at + 1);
  // NAME:SECRET@HOST is an address that is refused, without repeating the secret.
  const bool secret = id.contains(QLatin1Char(':')) && !id.startsWith(QLatin1String("mapping:"));
  if (secret || !isPlainId(id.toStdString()) || !knownAddresses().parse(address)) return std::nullopt;
  return MapOperand{id, address};
}

/// The error is a sentence: it is no file, and no address that is known.
tl::expected<MapOperand, QString> mapOperand(const QString& typed, const QString& robot) {
  if (const auto elsewhere = ofAnotherRobot(typed)) return *elsewhere;
  if (!standsAlone(typed, robot)) return MapOperand{typed, robot};
  if (const auto parsed = knownAddresses().parse(typed); !parsed) return tl::make_unexpected(parsed.error());
  // A state file has submaps, and no map besides.
  return MapOperand{stateFileOf(typed) ? QStringLiteral("submaps") : QString(), typed};
}

/// Why --resolution and --origin would have no effect on any of these.
std::optional<QString> withoutEffectReason(const std::vector<MapOperand>& operands,
                                           const PicturePlace& place) {
  if (place.resolution.empty() && place.origin.empty()) return std::nullopt;
  std::optional<QString> why;
  for (const MapOperand& operand : operands) {
    if (operand.id == QLatin1String("submaps") && place.origin.empty()) return std::nullopt;
    why = noPlaceReason(operand.address, place.resolution, place.origin);
    if (!why) return std::nullopt;
  }
  return why;
}

RobotReading::Purpose purposeOf(const MapOperand& operand) {
  return operand.id == QLatin1String("submaps") ? RobotReading::Purpose::Submaps
                                                : RobotReading::Purpose::Maps;
}

CommandResult<RobotReading*> connectTo(RobotCommand& command, const MapOperand& operand,
                                       const PicturePlace& place, RobotReading::Purpose purpose) {
  if (!place.resolution.empty() && !(resolutionOf(place.resolution) > 0))
    return wrong(
        Text::tr("--resolution %1: give metres per cell, for example 0.05.").arg(text(place.resolution)));
  // Of submaps it is the resolution of what is made of them, not of a file.
  const std::string of_file = stateFileOf(operand.address) ? std::string() : place.resolution;
  // Of two maps only one may need it: the other one says itself where it is.
  if (noPlaceReason(operand.address, of_file, place.origin)) return command.open(purpose, operand.address);
  return command.open(purpose, placedFile(operand.address, of_file, place.origin));
}

}  // namespace

double resolutionOf(const std::string& typed) {
  bool ok = false;
  const double value = text(typed).toDouble(&ok);
  return typed.empty() ? 0.05 : ok && std::isfinite(value) ? value : std::nan("");
}

CommandResult<RobotReading*> openPlaced(RobotCommand& command, const MapOperand& operand,
                                        const PicturePlace& place, RobotReading::Purpose purpose) {
  if (const auto why = withoutEffectReason({operand}, place)) return wrong(*why);
  return connectTo(command, operand, place, purpose);
}

std::optional<QString> robotWithoutEffectReason(const std::vector<std::string>& typed, const QString& robot) {
  if (robot.isEmpty() || robot == qEnvironmentVariable("MAPWRIGHT_ROBOT")) return std::nullopt;
  for (const std::string& word : typed) {
    const auto operand = mapOperand(text(word), robot);
    if (!operand || operand->address == robot) return std::nullopt;
  }
  return Text::tr("--robot %1 has no effect: neither map is one of its maps. Leave it out.").arg(robot);
}

CommandResult<OpenedMaps> openMaps(RobotCommand& command, const std::vector<std::string>& typed,
                                   const QString& robot, const PicturePlace& place, const BeforeMap& before) {
  std::vector<MapOperand> operands;
  for (const std::string& word : typed) {
    const auto operand = mapOperand(text(word), robot);
    if (!operand) return wrong(operand.error());
    operands.push_back(*operand);
  }
  if (const auto why = withoutEffectReason(operands, place)) return wrong(*why);
  OpenedMaps opened;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    auto reading = connectTo(command, operands[i], place, purposeOf(operands[i]));
    if (!reading) return passOn(reading);
    if (auto failed = before ? before(int(i), **reading, operands[i].id) : std::nullopt)
      return tl::make_unexpected(std::move(*failed));
    auto map = (*reading)->map(operands[i].id, resolutionOf(place.resolution));
    if (!map) return passOn(map);
    opened.maps.push_back(std::move(*map));
    for (std::string& file : (*reading)->sourceFiles()) opened.source_files.push_back(std::move(file));
  }
  return opened;
}

}  // namespace mapwright::app
