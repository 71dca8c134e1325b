// A change of a map that the robot keeps: what is checked before it is asked for, and afterwards. Pure.
#pragma once

#include <QString>

#include "map/catalogue.h"
#include "robot/map_administration.h"

namespace mapwright::jobs {

/// Why this name of a map is not even sent; empty when it is.
QString whyNoMapName(const QString& name);
/// Likewise, of a file that a map dispatcher is to write.
QString whyNoFilename(const QString& name);

/// The robot took `order`, but what it says of the map does not fit: a sentence; empty when it does.
QString oddity(const robot::MapOrder& order, const map::CatalogueEntry& now);

}  // namespace mapwright::jobs
