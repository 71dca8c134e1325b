// A map that a command names as an argument: one of --robot, a file or address of its own, or ID@ADDRESS.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/robot_command.h"

namespace mapwright::app {

struct MapOperand {
  QString id;  // "" = the only or current one; "submaps"
  QString address;
};
/// Of plain pictures, as typed: --resolution (also for submaps) and --origin.
struct PicturePlace {
  const std::string& resolution;
  const std::string& origin;
};
/// The number of --resolution: the usual one if it was not given, NaN if it is none.
double resolutionOf(const std::string& typed);
/// Connects to where it is.
CommandResult<RobotReading*> openPlaced(RobotCommand& command, const MapOperand& operand,
                                        const PicturePlace& place, RobotReading::Purpose purpose);

struct OpenedMaps {
  std::vector<render::PlacedGrid> maps;
  std::vector<std::string> source_files;  // on this computer
};
/// Why --robot would have no effect on these words; what the environment says needs no effect.
std::optional<QString> robotWithoutEffectReason(const std::vector<std::string>& typed, const QString& robot);
/// Called with what is connected, before its map is read: afterwards nothing else can be asked. The index is
/// 0 for the first map.
using BeforeMap =
    std::function<std::optional<CommandFailure>(int index, RobotReading& robot, const QString& id)>;
/// Reads maps completely, as typed. All words are checked before the first one is read, which may take long.
CommandResult<OpenedMaps> openMaps(RobotCommand& command, const std::vector<std::string>& typed,
                                   const QString& robot, const PicturePlace& place,
                                   const BeforeMap& before = {});

}  // namespace mapwright::app
