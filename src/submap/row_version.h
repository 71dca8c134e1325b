// The version of a submap for people.
#pragma once

#include "map/submap_version.h"
#include "submap/submap_store.h"

namespace mapwright::submap {

/// The listed version; where none is listed, the loaded one; map::kNoVersion = neither.
inline std::int32_t versionOf(const SubmapRow& row) {
  return row.entry.version == map::kNoVersion ? row.shown_version : row.entry.version;
}

}  // namespace mapwright::submap
