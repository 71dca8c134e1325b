// A failed request to a robot as a value: code acts on it, and one place turns it into a sentence. Why:
// docs/decisions/0005-failures-and-problems-are-values.md.
#pragma once

#include <string>
#include <vector>

#include "fault/fault.h"
#include "map/subject.h"

namespace mapwright::map {

/// The kind of failure, for code that acts on it: sentences are only for people.
enum class FailureKind {
  None,             // no failure, or not about a request
  Unreachable,      // no connection, or it broke off
  TimedOut,         // no answer in time
  Refused,          // the secret is missing or wrong, or this user lacks the permission
  RejectedByRobot,  // the robot answered with an error for this request
  MalformedAnswer,  // it answered what cannot be read
  NotARobot,        // the server is not a robot of this kind
  Certificate,      // its certificate is not trusted
  Cancelled,        // nobody wants it any more
  Conflict,         // someone else has changed the object in the meantime
  Unsupported,      // this robot, or this version of it, does not support it
};

/// Whether the robot did what was requested although the request failed. After Maybe, check the state before
/// you repeat the request.
enum class Applied {
  No,     // it did nothing, or the request was read-only
  Maybe,  // the request was sent, and its result is unknown
  Yes,    // it was done; only the answer was lost or unreadable
};

/// Which part of the subject was requested.
enum class AskedFor {
  All,
  Picture,
  SmallPicture,
  Change,    // it was to be changed
  Addition,  // it was to be added
  Action,    // the robot was to do something
};
/// Whether it happened is a question of its own (Failure::applied).
constexpr bool changes(AskedFor asked_for) { return asked_for >= AskedFor::Change; }

/// Why it failed, beyond its kind.
enum class FailureReason {
  Told,      // robot_code and detail say why
  Unfit,     // it arrived, but is unusable; cause or detail explains why
  Empty,     // it arrived, but is empty
  NotThere,  // there is no such thing
  NoSuchId,  // not a valid id; arguments[0] is what ids look like
  NotOffered,
};

/// A request that failed. All texts are untrusted plain text. sentences::sentenceOf makes the sentence.
struct Failure {
  FailureKind kind = FailureKind::Unreachable;  // never None
  Subject subject = {};                         // what the request was about
  Applied applied = Applied::No;
  std::string robot_code = {};              // the robot's own code ("404", "-3", "MAP_IN_USE"); empty = none
  std::string detail = {};                  // what the robot or the system said about it; empty = nothing
  std::vector<std::string> arguments = {};  // for the sentence, in the order that its reason needs
  AskedFor asked_for = AskedFor::All;
  FailureReason reason = FailureReason::Told;
  Fault cause = {};  // what is wrong with the answer, instead of detail
  bool operator==(const Failure&) const = default;
};

/// Something arrived, but it cannot be read.
inline bool isUnreadable(const Failure& failure) {
  return failure.kind == FailureKind::MalformedAnswer || failure.kind == FailureKind::NotARobot;
}

/// The server has a problem of its own (HTTP 500 to 599) that is unrelated to the request: a repetition may
/// succeed.
inline bool mayPass(const Failure& failure) {
  return failure.kind == FailureKind::RejectedByRobot && failure.robot_code.size() == 3 &&
         failure.robot_code.front() == '5';
}

}  // namespace mapwright::map
