// `mapwright clouds export`: writes the cloud of a robot's map to a file (docs/command-line.md).
#pragma once

#include <optional>
#include <string>

#include <QString>
#include <tl/expected.hpp>

#include "app/commands.h"
#include "map/map_part.h"

namespace mapwright::app {

/// The options as typed; empty = not given.
struct CloudsArguments : RobotArguments {
  std::string box;     // X,Y,Z,LX,LY,LZ in metres
  std::string sphere;  // X,Y,Z,R
  bool all = false, occupancy = false, ascii = false, force = false;
  std::string output;
};

/// The requested region; nullopt = the whole map. The error is a sentence.
tl::expected<std::optional<map::CloudRegion>, QString> cloudRegionFrom(const CloudsArguments& args);

}  // namespace mapwright::app
