// What went wrong, as a value: who it concerns, what kind of trouble, what was found. Logic looks at subject
// and codes; what people read is made by the room `sentences`.
#pragma once

#include <optional>
#include <string>

#include "fault/fault.h"
#include "map/failure.h"
#include "map/subject.h"

namespace mapwright::map {

enum class Severity { Info, Warning, Error };

/// What kind of trouble. One subject may have several at a time, and recovers from each by itself.
enum class ProblemCode {
  Unspecified,
  Unavailable,      // it cannot be had: no answer, an error, not there
  Unreadable,       // it came, and cannot be read
  Unplaced,         // it has no pose that can be used
  ListedTwice,      // two rows of one list are about it
  VersionWentBack,  // an older state than the one at hand is offered
  Odd,              // used, but something about it is strange
};

/// A problem as reported by whoever found it.
struct Problem {
  Severity severity = Severity::Error;
  Subject subject;
  Fault reason = {};  // none: the request tells it
  ProblemCode code = ProblemCode::Unspecified;
  FailureKind failure = FailureKind::None;
  std::optional<Failure> request = {};  // that failed
  bool operator==(const Problem&) const = default;
};

/// The failure as a problem of its subject.
Problem problemOf(const Failure& failure, Severity severity = Severity::Error);

/// What problems that differ in numbers only share, beside their subject.
std::string patternOf(const Problem& problem);

/// What is well again: one kind of trouble of a subject, or (nullopt) all that was wrong with it.
struct Recovery {
  Subject subject;
  std::optional<ProblemCode> code = {};
  bool operator==(const Recovery&) const = default;
};

}  // namespace mapwright::map
