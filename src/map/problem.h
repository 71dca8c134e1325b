// Something that went wrong, as a value: subject, kind, and what was found. Code uses subject and codes; the
// room `sentences` makes the text.
#pragma once

#include <optional>
#include <string>

#include "fault/fault.h"
#include "map/failure.h"
#include "map/subject.h"

namespace mapwright::map {

enum class Severity { Info, Warning, Error };

/// The kind of problem. A subject may have several at a time, and recovers from each separately.
enum class ProblemCode {
  Unspecified,
  Unavailable,      // it cannot be loaded: no answer, an error, not there
  Unreadable,       // it came, and cannot be read
  Unplaced,         // it has no valid pose
  ListedTwice,      // two rows of a list are about it
  VersionWentBack,  // an older state than the loaded one is offered
  Odd,              // used, but something about it is strange
};

/// A problem as reported by the code that found it.
struct Problem {
  Severity severity = Severity::Error;
  Subject subject;
  Fault reason = {};  // none: the failed request explains it
  ProblemCode code = ProblemCode::Unspecified;
  FailureKind failure = FailureKind::None;
  std::optional<Failure> request = {};  // that failed
  bool operator==(const Problem&) const = default;
};

/// The failure as a problem of its subject.
Problem problemOf(const Failure& failure, Severity severity = Severity::Error);

/// The same for problems with the same subject that differ only in numbers.
std::string patternOf(const Problem& problem);

/// Something works again: one kind of problem of a subject, or (nullopt) all of them.
struct Recovery {
  Subject subject;
  std::optional<ProblemCode> code = {};
  bool operator==(const Recovery&) const = default;
};

}  // namespace mapwright::map
