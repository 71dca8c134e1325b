// Capability: a robot's recordings, for replay. Source: docs/protocols/autoxing.md, "Bags".
// A bag is requested range by range. The answer for a range is passed on as received: in its own order, with
// the earlier messages that a robot adds for the initial state (back-filled), and with those at the very end
// of the range if the robot includes them. replay::inRange() reduces it to the range.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QString>

#include "map/live_topics.h"
#include "map/subject.h"
#include "robot/call.h"

namespace mapwright::robot {

enum class BagKind {
  Bag,        // recorded all the time
  Recording,  // recorded on demand
  File,       // a local file
};

struct BagKey {
  BagKind kind = BagKind::Bag;
  std::string name;  // untrusted; unique among its kind
  bool operator==(const BagKey&) const = default;
  auto operator<=>(const BagKey&) const = default;
};

inline map::Subject subjectOf(const BagKey& key) { return {map::SubjectKind::Bag, key.name}; }

/// A row of the list. Texts are untrusted.
struct BagEntry {
  BagKey key;
  std::optional<std::int64_t> size_bytes;
  std::string size_text;        // "6.8KB"
  std::optional<double> end_s;  // seconds since the epoch; robots give it without a time zone: taken as UTC
  std::string end_text;         // "31-Oct-2023 14:36:17"
  bool operator==(const BagEntry&) const = default;
};

/// The messages of one topic in one format in a file. Texts are untrusted.
struct BagTopic {
  std::string name, type, encoding;      // "/scan", "sensor_msgs/LaserScan", "ros1"; empty: not stated
  std::optional<std::int64_t> messages;  // nullopt: unknown without counting them
  /// Per second, the average from its first message to its last one, without initial-state messages; nullopt:
  /// there are fewer than two, or all have the same time.
  std::optional<double> rate_hz = std::nullopt;
  bool operator==(const BagTopic&) const = default;
};

/// The parts of a file with the same compression.
struct BagPacking {
  std::string compression;  // "zstd", "bz2"; empty: none
  std::int64_t parts = 0, stored_bytes = 0, unpacked_bytes = 0;
  bool operator==(const BagPacking&) const = default;
};

/// When the connection to the robot was lost during recording. Seconds since the epoch.
struct BagAway {
  double from_s = 0;
  std::optional<double> until_s;  // nullopt: to the end
  bool operator==(const BagAway&) const = default;
};

/// An interrupted recording that was repaired.
struct BagRepair {
  std::optional<double> broke_off_s;  // seconds since the epoch; nullopt: before its first message
  bool operator==(const BagRepair&) const = default;
};

/// General information about a bag. Seconds since the epoch; robots round them: the last message may be after
/// end_s. An empty bag has no times, or equal ones.
struct BagInfo {
  std::optional<std::int64_t> messages = 0;  // nullopt: the robot does not say
  double start_s = 0, end_s = 0;
  // Of files alone.
  bool interrupted = false;  // its end is missing: the writer was interrupted, or is still writing
  std::optional<BagRepair> repair = std::nullopt;
  std::vector<BagAway> away = {};
  std::vector<BagTopic> topics = {};  // by name
  std::vector<BagPacking> packing = {};
  std::string format = {}, written_by = {};  // "MCAP", "ROS bag 2.0"; in the writer's own words
  std::int64_t attachments = 0;
  std::vector<std::string> robots = {};  // their namespaces ("/robot1"), if there are several
  bool operator==(const BagInfo&) const = default;

  /// The gap in the connection that contains `at_s`; null: there was a connection.
  const BagAway* awayAt(double at_s) const {
    for (const BagAway& one : away) {
      if (at_s >= one.from_s && at_s < one.until_s.value_or(at_s + 1)) return &one;
    }
    return nullptr;
  }
};

/// One message of a bag. Its stamp is message.received_s: when it was recorded.
struct BagMessage {
  map::StampedMessage message;  // for an unknown topic: UnreadableMessage without a reason
  bool known = false;           // `message` affects the world
  bool latched = false;         // the robot marks its topic as latched
  std::size_t at = 0,
              size = 0;  // its JSON in BagChunk::text; with size 0 it was derived from others, not recorded
  std::string picture_url = {};  // the address on the robot of a GridMessage's missing picture
};

/// The robot's answer for a range. Immutable; may be read on any thread.
struct BagChunk {
  double from_s = 0, until_s = 0;  // as requested
  std::shared_ptr<const std::string> text;
  std::vector<BagMessage> messages;  // in the order of the answer
  std::size_t without_stamp = 0;     // number of messages left out because their stamp is not a number
  std::size_t unreadable = 0;        // number of messages that are not JSON objects
  bool from_cache = false;
  /// Approximate memory of the messages besides the text, if that is much more than the text suggests.
  std::size_t value_bytes = 0;

  std::string_view textOf(const BagMessage& message) const {
    return text ? std::string_view(*text).substr(message.at, message.size) : std::string_view();
  }
};
using BagChunkPtr = std::shared_ptr<const BagChunk>;

/// From `from_s` on; robots may or may not include `until_s`. Seconds since the epoch. Ranges with the same
/// limits are answered from the disk cache if the robot allows it.
struct BagRange {
  double from_s = 0, until_s = 0;
  std::int64_t max_bytes = std::int64_t(64) << 20;  // a longer answer is FailureKind::MalformedAnswer, with
                                                    // fault::AnswerTooLong
  /// The earlier state is unknown: for files, where this has a cost, the last message of each topic before
  /// the range is added, as robots do anyway. It equals the result of reading everything up to there.
  bool back_fill = false;
  /// The texts of messages are for programs, not for people: nothing is truncated (BagChunk::text).
  bool whole_texts = false;
};

/// A recording to start, or just started.
struct BagOrder {
  std::string suffix;    // of its name
  std::string duration;  // "90s", "2m"; empty = the robot's default
  std::string category;  // empty, or one of the robot's categories
};

struct BagDownload {
  QString path;
  std::int64_t bytes = 0;
  bool resumed = false;  // an earlier part was resumed
};

class BagLibrary {
 public:
  virtual ~BagLibrary() = default;
  /// Bags and recordings, in the robot's order. If one of the two lists fails problemFound() is emitted.
  virtual Call list(OutcomeTo<std::vector<BagEntry>> reply) = 0;
  virtual Call info(const BagKey& key, OutcomeTo<BagInfo> reply) = 0;
  /// Read on a thread of its own. The caller limits the number of requests in progress, as replay::Chunks
  /// does.
  virtual Call messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) = 0;
  /// A picture given only by address (BagMessage::picture_url), while the robot or the cache has it. The
  /// subject of a failure is `topic`.
  virtual Call picture(const std::string& topic, const std::string& url,
                       OutcomeTo<std::shared_ptr<const std::string>> reply) = 0;
  virtual Call record(const BagOrder& order, OutcomeTo<BagEntry> reply) = 0;
  virtual Call remove(const BagKey& key, OutcomeTo<BagKey> reply) = 0;
  /// To a file: first next to `path` (".part"), then renamed. Resumes an earlier part if the robot supports
  /// it, otherwise starts over.
  virtual Call download(const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply) = 0;
};

}  // namespace mapwright::robot
