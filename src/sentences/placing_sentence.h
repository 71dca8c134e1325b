// What is doubtful about a waypoint where it lies, as people read it.
#pragma once

#include <QString>

#include "placing/warnings.h"

namespace mapwright::sentences {

/// "It is in a wall."
QString sentenceOf(const placing::Warning& warning);
/// A line for each, the gravest first; empty = there are none.
QString sentencesOf(const placing::Warnings& warnings);
/// What cannot be told, because of the map below; empty where all can.
QString sentenceOf(placing::GroundState ground);

}  // namespace mapwright::sentences
