// Capability: what a robot has recorded, to be looked at again. Source: docs/protocols/autoxing.md, "Bags".
//
// A bag is asked for range by range. What a range answers is handed over as it came: in the order of the
// answer, with the messages of before that a robot adds so that the state is known (back-filled), and with
// those at the very end of the range where a robot counts the end in. replay::inRange() makes of it what lies
// in the range.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QString>

#include "map/stamped_message.h"
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
  std::optional<double> end_s;  // seconds since the epoch; robots tell it without a time zone: taken as UTC
  std::string end_text;         // "31-Oct-2023 14:36:17"
  bool operator==(const BagEntry&) const = default;
};

/// What a file holds by one topic in one form. Texts are untrusted.
struct BagTopic {
  std::string name, type, encoding;      // "/scan", "sensor_msgs/LaserScan", "ros1"; empty: it does not say
  std::optional<std::int64_t> messages;  // nullopt: only counting them would tell
  /// A second, on the average from its first message to its last one, those that had been said before left
  /// out; nullopt: there are not two, or all are of one time.
  std::optional<double> rate_hz = std::nullopt;
  bool operator==(const BagTopic&) const = default;
};

/// The parts of a file that are packed alike.
struct BagPacking {
  std::string compression;  // "zstd", "bz2"; empty: none
  std::int64_t parts = 0, stored_bytes = 0, unpacked_bytes = 0;
  bool operator==(const BagPacking&) const = default;
};

/// When the link to the robot was away while it was recorded. Seconds since the epoch.
struct BagAway {
  double from_s = 0;
  std::optional<double> until_s;  // nullopt: to the end
  bool operator==(const BagAway&) const = default;
};

/// A recording that was interrupted, and made whole since.
struct BagRepair {
  std::optional<double> broke_off_s;  // seconds since the epoch; nullopt: before its first message
  bool operator==(const BagRepair&) const = default;
};

/// What a robot says of a bag as a whole. Seconds since the epoch; robots tell whole ones: the last message
/// may lie after end_s. An empty bag has no times, or equal ones.
struct BagInfo {
  std::int64_t messages = 0;
  double start_s = 0, end_s = 0;
  // Of files alone.
  bool interrupted = false;  // its end is missing: whoever wrote it was interrupted, or still writes
  std::optional<BagRepair> repair = std::nullopt;
  std::vector<BagAway> away = {};
  std::vector<BagTopic> topics = {};  // by name
  std::vector<BagPacking> packing = {};
  std::string format = {}, written_by = {};  // "MCAP", "ROS bag 2.0"; in its own words
  std::int64_t attachments = 0;
  bool operator==(const BagInfo&) const = default;

  /// The time without a link in which `at_s` lies; null: there was one.
  const BagAway* awayAt(double at_s) const {
    for (const BagAway& one : away) {
      if (at_s >= one.from_s && at_s < one.until_s.value_or(at_s + 1)) return &one;
    }
    return nullptr;
  }
};

/// One message of a bag. Its stamp is message.received_s: when it was recorded.
struct BagMessage {
  map::StampedMessage message;   // of a topic that nobody here knows: UnreadableMessage without a reason
  bool known = false;            // `message` says something of the world
  bool latched = false;          // the robot says that it is of a latched topic
  std::size_t at = 0, size = 0;  // its JSON in BagChunk::text; of size 0 it was made of others, not recorded
  std::string picture_url = {};  // where the picture of a GridMessage without one lies on the robot
};

/// What the robot answered for a range. Immutable once made; may be read on any thread.
struct BagChunk {
  double from_s = 0, until_s = 0;  // as it was asked for
  std::shared_ptr<const std::string> text;
  std::vector<BagMessage> messages;  // in the order of the answer
  std::size_t without_stamp = 0;     // further ones that have no stamp that is a number: they are left out
  std::size_t unreadable = 0;        // further ones that are no JSON objects
  bool from_cache = false;
  /// About what the messages take beside the text, where that is much more than the text lets one think.
  std::size_t value_bytes = 0;

  std::string_view textOf(const BagMessage& message) const {
    return text ? std::string_view(*text).substr(message.at, message.size) : std::string_view();
  }
};
using BagChunkPtr = std::shared_ptr<const BagChunk>;

/// From `from_s` on; robots may or may not count `until_s` in. Seconds since the epoch. Ranges of the same
/// numbers are answered from the disk where the robot allows that.
struct BagRange {
  double from_s = 0, until_s = 0;
  std::int64_t max_bytes = std::int64_t(64) << 20;  // a longer answer is FailureKind::MalformedAnswer, with
                                                    // fault::AnswerTooLong
  /// What lies before is not known: where that costs more than nothing (files), the last message of each
  /// topic before the range comes first, as robots add it unasked. It is what reading that far would tell.
  bool back_fill = false;
  /// The texts of messages are for programs, not for people: nothing in them is cut (BagChunk::text).
  bool whole_texts = false;
};

/// What is to be recorded from now on, or was just now.
struct BagOrder {
  std::string suffix;    // of its name
  std::string duration;  // "90s", "2m"; empty = what the robot thinks right
  std::string category;  // empty, or the robot's own word
};

struct BagDownload {
  QString path;
  std::int64_t bytes = 0;
  bool resumed = false;  // an earlier part was gone on with
};

class BagLibrary {
 public:
  virtual ~BagLibrary() = default;
  /// Bags and recordings, in the robot's order. Where one of the two lists failed it is a problemFound().
  virtual Call list(OutcomeTo<std::vector<BagEntry>> reply) = 0;
  virtual Call info(const BagKey& key, OutcomeTo<BagInfo> reply) = 0;
  /// Read on a thread of its own. Whoever asks for many bounds how many are under way: replay::Chunks does.
  virtual Call messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) = 0;
  /// The picture that a message only names (BagMessage::picture_url), while the robot or the disk has it.
  /// Subject of a failure is `topic`.
  virtual Call picture(const std::string& topic, const std::string& url,
                       OutcomeTo<std::shared_ptr<const std::string>> reply) = 0;
  virtual Call record(const BagOrder& order, OutcomeTo<BagEntry> reply) = 0;
  virtual Call remove(const BagKey& key, OutcomeTo<BagKey> reply) = 0;
  /// Into a file: beside `path` first (".part"), which then gets its name. An earlier part is gone on with
  /// where the robot can do that, and begun anew where it cannot.
  virtual Call download(const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply) = 0;
};

}  // namespace mapwright::robot
