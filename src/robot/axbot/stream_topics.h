// Which topics of an Autoxing robot carry which kind of data. Source: docs/protocols/autoxing.md, "Topics
// that the map shows".
#pragma once

#include <QStringList>

#include "map/stream.h"

namespace mapwright::robot::axbot {

struct StreamTopics {
  QStringList usual;  // asked for together
  /// The name in older firmware, which sends it unreduced: subscribed if the usual ones stay silent.
  QStringList older;
};
StreamTopics topicsOf(map::Stream stream);

}  // namespace mapwright::robot::axbot
