// The words of each code, by what it is about: the parts of sentences::templateOf.
#pragma once

#include <QString>

#include "map/reason.h"

namespace mapwright::sentences {

// Each answers a null text for codes that are not its own; `count` is of what the code counts.
QString wordsOfSubmaps(map::ReasonCode code, int count);
QString wordsOfMaps(map::ReasonCode code, int count);
QString wordsOfFiles(map::ReasonCode code, int count);
QString wordsOfLinks(map::ReasonCode code, int count);
QString wordsOfRos(map::ReasonCode code, int count);
/// Of a frame that fits no other, because none is known. The codes are those of wordsOfRos().
QString wordsOfLoneFrame(map::ReasonCode code);
QString wordsOfRecordings(map::ReasonCode code, int count);

}  // namespace mapwright::sentences
