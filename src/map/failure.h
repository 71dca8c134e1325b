// How a request to a robot failed, as a value: code acts on it, people get a sentence that is made of it in
// one place. Why: docs/decisions/0005-failures-and-problems-are-values.md.
#pragma once

#include <string>
#include <vector>

#include "fault/fault.h"
#include "map/subject.h"

namespace mapwright::map {

/// What kind of failure it is, for code that acts on it: sentences are for people alone.
enum class FailureKind {
  None,             // it did not fail, or it concerns no request
  Unreachable,      // no connection, or it broke off
  TimedOut,         // no answer in time
  Refused,          // not without (the right) secret, or not for this user
  RejectedByRobot,  // the robot answered with an error for this request
  MalformedAnswer,  // it answered what cannot be read
  NotARobot,        // what answers there is no robot of this kind
  Certificate,      // its certificate is not trusted
  Cancelled,        // nobody wants it any more
  Conflict,         // what it was to change has been changed by somebody else
  Unsupported,      // this robot, or this version of it, cannot do that
};

/// Whether the robot did what it was asked to do although the request failed. Who asked for something that
/// Maybe happened looks again before he asks once more.
enum class Applied {
  No,     // it did nothing, or the request only read
  Maybe,  // the request went out, and what became of it is not known
  Yes,    // it did it; only the answer was lost or cannot be read
};

/// What of the subject was asked for.
enum class AskedFor {
  All,
  Picture,
  SmallPicture,
  Change,  // it was to be changed
};

/// Why it failed, beyond its kind.
enum class FailureReason {
  Told,      // robot_code and detail say why
  Unfit,     // it came, and what it says is of no use; cause or detail is a sentence about that
  Empty,     // it came, and there is nothing in it
  NotThere,  // there is no such thing
  NoSuchId,  // nothing can be asked for by this id; arguments[0] is what ids look like
  NotOffered,
};

/// What a request ended in, when not in its value. All texts are untrusted plain text. The sentence is made
/// by sentences::sentenceOf.
struct Failure {
  FailureKind kind = FailureKind::Unreachable;  // never None
  Subject subject = {};                         // what the request was about
  Applied applied = Applied::No;
  std::string robot_code = {};              // the robot's own ("404", "-3", "MAP_IN_USE"); empty = none
  std::string detail = {};                  // what the robot, or the system, said about it; empty = nothing
  std::vector<std::string> arguments = {};  // of the sentence, in the order that its reason asks for
  AskedFor asked_for = AskedFor::All;
  FailureReason reason = FailureReason::Told;
  Fault cause = {};  // what is wrong with what came, instead of detail
  bool operator==(const Failure&) const = default;
};

/// Something came, and it cannot be read.
inline bool isUnreadable(const Failure& failure) {
  return failure.kind == FailureKind::MalformedAnswer || failure.kind == FailureKind::NotARobot;
}

}  // namespace mapwright::map
