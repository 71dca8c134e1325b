// Failures that requests of all robots have in common.
#pragma once

#include <utility>
#include <vector>

#include "map/catalogue.h"
#include "map/failure.h"
#include "robot/call.h"

namespace mapwright::robot::wire {

/// There is no such thing on this robot.
inline map::Failure notThere(map::Subject subject) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = std::move(subject),
          .reason = map::FailureReason::NotThere};
}

/// Robots of this kind, or this one, do not offer it.
inline map::Failure notOffered(map::Subject subject, map::AskedFor asked_for = map::AskedFor::All) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = std::move(subject),
          .asked_for = asked_for,
          .reason = map::FailureReason::NotOffered};
}

/// It arrived, and cannot be used.
inline map::Failure unfit(map::Subject subject, Fault cause) {
  return {.kind = map::FailureKind::MalformedAnswer,
          .subject = std::move(subject),
          .reason = map::FailureReason::Unfit,
          .cause = std::move(cause)};
}

/// The robot accepted a change, and shows something else.
inline map::Failure otherwise(map::Subject subject, Fault what) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = std::move(subject),
          .asked_for = map::AskedFor::Change,
          .reason = map::FailureReason::Unfit,
          .cause = std::move(what)};
}

/// The map `key` of a list of all maps.
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
