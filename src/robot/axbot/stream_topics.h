// Which topics of an Autoxing robot bring which kind of data. Source: docs/protocols/autoxing.md, "Topics
// that the map shows".
#pragma once

#include <QStringList>

#include "map/stream.h"

namespace mapwright::robot::axbot {

struct StreamTopics {
  QStringList usual;  // asked for together
  /// What older firmware calls it, and sends whole on the socket of the fast topics: asked for when the usual
  /// ones stay silent.
  QStringList older;
};
StreamTopics topicsOf(map::Stream stream);

}  // namespace mapwright::robot::axbot
