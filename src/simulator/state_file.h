// A stored map as the state file (.pbstream) that the robot positions itself by. Format:
// docs/protocols/pbstream.md.
#pragma once

#include <string>

#include "simulator/pictures.h"

namespace mapwright::simulator {

/// The picture cut into submaps that overlap, driven past one after the other, each with a loop closure to
/// the one before. Cells are coarser than those of a very large picture. The same picture gives the same
/// bytes; no submaps if there is no picture. Pure; a tenth of a second for an office.
std::string stateFileOf(const MapPicturePtr& picture);

}  // namespace mapwright::simulator
