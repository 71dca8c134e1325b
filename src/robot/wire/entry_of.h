// One map of a list, for whoever asks about it alone.
#pragma once

#include <utility>
#include <vector>

#include "map/catalogue.h"
#include "robot/call.h"
#include "robot/wire/failures.h"

namespace mapwright::robot::wire {

inline Outcome<map::CatalogueEntry> entryOf(const map::MapKey& key,
                                            Outcome<std::vector<map::CatalogueEntry>> entries) {
  if (!entries) {
    entries.error().subject = map::subjectOf(key);
    return fail(std::move(entries.error()));
  }
  for (map::CatalogueEntry& entry : *entries) {
    if (entry.key == key) return std::move(entry);
  }
  return fail(notThere(map::subjectOf(key)));
}

}  // namespace mapwright::robot::wire
