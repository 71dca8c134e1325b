// Exports a part of a bag to a file for other programs: its messages, or the robot's path. Used by the
// command line and the window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "disk/existing.h"
#include "disk/file_error.h"
#include "excerpt/time_span.h"
#include "fault/fault.h"
#include "replay/chunks.h"

namespace mapwright::excerpt {

enum class Kind {
  Mcap,      // like a session recorded here (recorder/layout.h)
  Lines,     // every message as recorded, one JSON object per line
  TrackCsv,  // where the robot was (replay/track.h)
  TrackGeoJson,
  TrackTum,
};

struct Order {
  Kind kind = Kind::Mcap;
  std::string path;  // of the file; an MCAP file needs one, others may go to the standard output ("-")
  disk::Existing existing = disk::Existing::Replace;  // a file of that name
  TimeSpan span;
  std::vector<std::string> topics;  // only these; empty = all. Not used for tracks
  /// For recordings, instead of `span`, exact to the nanosecond: both inclusive.
  std::optional<std::int64_t> first_ns, last_ns;
  bool repair = false;  // of an interrupted recording: the file says so, and is complete
  // Where an MCAP file comes from, stored in it.
  std::string address, robot_kind, bag;  // robot_kind: robot::Addresses::kindOf(address)
};

/// What was written.
struct Written {
  std::int64_t messages = 0;     // of the span
  std::int64_t said_before = 0;  // initial state from before the span
  std::set<std::string> topics;  // of all these messages
  std::int64_t attachments = 0;
  std::int64_t samples = 0, pieces = 0;  // of a track
  std::int64_t odd = 0;                  // left out: unreadable or without time stamp
  std::vector<Fault> losses;             // what is damaged or cut off in the input file
  bool damaged = false;                  // more of it is lost than its end
};

/// Whether it is one of the topics, or the list is empty.
bool isOneOf(const std::vector<std::string>& topics, const std::string& topic);

/// One thread at a time. The file gets its name in place(); without it nothing is left.
class Writing {
 public:
  virtual ~Writing() = default;
  /// Ranges in order, from readsFrom() on.
  virtual std::optional<disk::FileError> add(const replay::Chunk& chunk) = 0;
  virtual tl::expected<Written, disk::FileError> place() = 0;
};

/// Fails if the file cannot be created. Read its messages with complete texts if wantsWholeTexts().
tl::expected<std::unique_ptr<Writing>, disk::FileError> begin(const Order& order);
/// Where to start reading; nullopt: at the start of the bag. The state before a span belongs into an MCAP
/// file.
std::optional<double> readsFrom(const Order& order);
bool wantsWholeTexts(Kind kind);

/// Recorded JSON on one line: line breaks between values become blanks; JSON texts contain none.
std::string jsonLine(std::string_view json);

}  // namespace mapwright::excerpt
