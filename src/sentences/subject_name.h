// Names for the subjects of problems.
#pragma once

#include <QString>

#include "map/subject.h"

namespace mapwright::sentences {

/// "Submap 1-593", "Topic /map_v2", "Map 12", "Map \"Hall\"". Plain text.
QString nameOf(const map::Subject& subject);

}  // namespace mapwright::sentences
