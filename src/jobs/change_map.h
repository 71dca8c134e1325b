// Checks for changes of a stored map, before the request and afterwards. Pure.
#pragma once

#include <QString>

#include "map/catalogue.h"
#include "robot/map_administration.h"

namespace mapwright::jobs {

/// Why this map name is not sent at all; empty if it is valid.
QString whyNoMapName(const QString& name);
/// The same for the name of a file that a map dispatcher should write.
QString whyNoFilename(const QString& name);

/// The robot accepted `order`, but what it reports about the map does not match: a sentence; empty if it
/// does.
QString oddity(const robot::MapOrder& order, const map::CatalogueEntry& now);

}  // namespace mapwright::jobs
