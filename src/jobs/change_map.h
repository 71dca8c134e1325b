// Checks for changes of a stored map, before the request and afterwards. Pure.
#pragma once

#include <vector>

#include <QString>

#include "map/catalogue.h"
#include "robot/map_administration.h"

namespace mapwright::jobs {

/// Why this map name is not sent at all; empty if it is valid.
QString noMapNameReason(const QString& name);
/// A remark that other stored maps are called as `order` says; empty if none is. Names need not be unique.
QString alsoCalledSo(const robot::MapOrder& order, const std::vector<map::CatalogueEntry>& maps);
/// noMapNameReason() for the name of a file that a map dispatcher should write.
QString noFilenameReason(const QString& name);

/// The robot accepted `order`, but what it reports about the map does not match: a sentence; empty if it
/// does.
QString oddity(const robot::MapOrder& order, const map::CatalogueEntry& now);

}  // namespace mapwright::jobs
