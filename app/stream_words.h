// Kinds of data that a robot sends, as they are typed.
#pragma once

#include <QStringList>
#include <tl/expected.hpp>

#include "map/stream.h"

namespace mapwright::app {

QStringList streamWords();
/// Of "pose,cloud", "all" or "none". The error is the word that names nothing.
tl::expected<map::Streams, QString> streamsFrom(const QString& typed);

}  // namespace mapwright::app
