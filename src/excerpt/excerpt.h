// A part of a bag as a file for other programs: its messages, or where the robot was. The same for the
// command line and the window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "disk/file_error.h"
#include "excerpt/time_span.h"
#include "fault/fault.h"
#include "replay/chunk.h"

namespace mapwright::excerpt {

enum class Kind {
  Mcap,      // like a session that was recorded here (recorder/layout.h)
  Lines,     // every message as it was recorded, a JSON object a line
  TrackCsv,  // where the robot was (replay/track.h)
  TrackGeoJson,
  TrackTum,
};

struct Order {
  Kind kind = Kind::Mcap;
  std::string path;  // of the file; an MCAP file needs one, all else may go to the standard output ("-")
  TimeSpan span;
  std::vector<std::string> topics;  // of these alone; none = all. Not of tracks
  /// Of recordings, instead of `span`, to the nanosecond: both counted in.
  std::optional<std::int64_t> first_ns, last_ns;
  bool repair = false;  // of a recording that was interrupted: the file says so, and is whole
  // What is written into an MCAP file about where it comes from.
  std::string address, bag;
};

/// What was written.
struct Written {
  std::int64_t messages = 0;     // of the span
  std::int64_t said_before = 0;  // the last ones before it
  std::int64_t attachments = 0;
  std::int64_t samples = 0, pieces = 0;  // of a track
  std::int64_t odd = 0;                  // left out: they cannot be read, or have no stamp
  std::vector<Fault> losses;             // of what is damaged in a file that was read, or cut off
};

/// Whether it is wanted: one of the topics, or there are none.
bool isOneOf(const std::vector<std::string>& topics, const std::string& topic);

/// One thread at a time. Nothing has the name of the file before place(), and nothing is left without it.
class Writing {
 public:
  virtual ~Writing() = default;
  /// Ranges in their order, those of readsFrom() and later.
  virtual std::optional<disk::FileError> take(const replay::Chunk& chunk) = 0;
  virtual tl::expected<Written, disk::FileError> place() = 0;
};

/// Fails where the file cannot be begun. Its messages should be read with whole texts where
/// wantsWholeTexts().
tl::expected<std::unique_ptr<Writing>, disk::FileError> begin(const Order& order);
/// Where reading begins; nullopt: with the bag. What was said before a span is a part of what was so in it,
/// and belongs into an MCAP file.
std::optional<double> readsFrom(const Order& order);
bool wantsWholeTexts(Kind kind);

/// JSON as recorded, on one line: line breaks between values become blanks, and none stands within a text.
std::string jsonLine(std::string_view json);

}  // namespace mapwright::excerpt
