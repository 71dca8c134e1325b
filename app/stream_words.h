// Kinds of data that a robot sends, as typed on the command line.
#pragma once

#include <QStringList>
#include <tl/expected.hpp>

#include "map/stream.h"

namespace mapwright::app {

QStringList streamWords();
/// Parses "pose,cloud", "all" or "none". The error is the unknown word.
tl::expected<map::Streams, QString> streamsFrom(const QString& typed);

}  // namespace mapwright::app
