// What went wrong, as a value: who it concerns, what kind of trouble, what happened, what to do. Plain text,
// never markup. Logic looks at the subject and the code; the sentence is for people only.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace mapwright::map {

enum class Severity { Info, Warning, Error };

enum class SubjectKind {
  Other,       // nothing but a name
  Robot,       // the robot itself, or the link to it
  Catalogue,   // the list of its maps, or a part of the list
  Map,         // one whole map
  Places,      // the named places of a map
  Overview,    // the coarse picture of the SLAM map
  SubmapList,  // what the robot lists
  Submap,      // one submap, whatever its version
  Topic,       // a live topic
  Condition,   // a state of the robot that people must know of (an alert, a pressed emergency stop)
};

/// What a problem is about. The same thing has the same subject in every state of it: versions, times and
/// numbers belong into the sentence.
struct Subject {
  SubjectKind kind = SubjectKind::Other;
  std::string id;     // "1-593", "/map_v2", "mapping:48"
  std::string label;  // how people call it, where the id does not say it; no part of the identity

  Subject() = default;
  Subject(SubjectKind its_kind, std::string its_id, std::string its_label = {})
      : kind(its_kind), id(std::move(its_id)), label(std::move(its_label)) {}
  /// Something without a kind of its own: the name is all there is.
  Subject(std::string name) : id(std::move(name)) {}
  Subject(const char* name) : id(name) {}

  bool operator==(const Subject& other) const { return kind == other.kind && id == other.id; }
};

/// "Submap 1-593", "Topic /map_v2", "Map 12".
std::string toText(const Subject& subject);

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
};

/// A problem as reported by whoever found it.
struct Problem {
  Severity severity = Severity::Error;
  Subject subject;
  std::string sentence;  // "3,200 bytes where 51,200 were expected. Shown without it."
  ProblemCode code = ProblemCode::Unspecified;
  FailureKind failure = FailureKind::None;
  bool operator==(const Problem&) const = default;
};

/// What is well again: one kind of trouble of a subject, or (nullopt) all that was wrong with it.
struct Recovery {
  Subject subject;
  std::optional<ProblemCode> code = {};
  bool operator==(const Recovery&) const = default;
};

}  // namespace mapwright::map
