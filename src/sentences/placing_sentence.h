// Texts for warnings about waypoints.
#pragma once

#include <QString>

#include "placing/warnings.h"

namespace mapwright::sentences {

/// "It is in a wall."
QString sentenceOf(const placing::Warning& warning);
/// One line each, most severe first; empty = there are none.
QString sentencesOf(const placing::Warnings& warnings);
/// What cannot be checked because of the map below; empty if everything can.
QString sentenceOf(placing::GroundState ground);

}  // namespace mapwright::sentences
