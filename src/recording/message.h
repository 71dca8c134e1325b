// The content of a recording, in any format: channels, messages, attachments, and problems (the texts are
// made elsewhere). Value types, any thread. Times
// are nanoseconds since the epoch of the recorder's clock (usually 1970, UTC); texts are UTF-8 as in the
// file, and untrusted. Sources: MCAP format specification, "Records"; "ROS bag format 2.0".
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "disk/file_error.h"

namespace mapwright::recording {

using Values = std::map<std::string, std::string>;

/// A stream of messages of one type on one topic. Several channels may have the same topic.
struct Channel {
  std::uint32_t id = 0;  // within the file
  std::string topic;
  std::string message_encoding;  // "json", "cdr", "ros1", "cbor", "protobuf" …
  std::string schema_name;       // "nav_msgs/Path"; empty: none
  std::string schema_encoding;   // "jsonschema", "ros1msg", "ros2msg" …; empty: none
  std::string schema_data;
  Values metadata;  // for a bag: "callerid", "latching", "md5sum" …
  bool operator==(const Channel&) const = default;
};
using ChannelPtr = std::shared_ptr<const Channel>;

/// A message. `bytes` is shared by its copies.
struct Message {
  ChannelPtr channel;                // never null
  std::int64_t log_time_ns = 0;      // when it was recorded: the order of messages
  std::int64_t publish_time_ns = 0;  // when it was sent; the log time if unknown
  std::uint32_t sequence = 0;        // from the publisher or recorder; 0 in bags
  std::span<const std::uint8_t> bytes;
  std::shared_ptr<const void> keeps;  // what `bytes` look into
};

/// An attachment of the recording, without its bytes.
struct AttachmentLocation {
  std::string name, media_type;
  std::int64_t log_time_ns = 0, create_time_ns = 0;  // create time 0: unknown
  std::uint64_t size = 0;                            // bytes of the file
  std::uint64_t offset = 0;                          // of its record in the recording
};

/// An attachment with its content.
struct Attachment {
  std::string name, media_type;
  std::int64_t log_time_ns = 0, create_time_ns = 0;
  std::string bytes;
};

struct Metadata {
  std::string name;
  Values values;
  bool operator==(const Metadata&) const = default;
};

/// Something found in a file that is still readable.
enum class NoteCode : std::uint8_t {
  NotFinished,        // its end is missing: the writer was interrupted, or is still writing
  NoIndex,            // complete but without an index: it was scanned
  IndexUnusable,      // its index is damaged: it was scanned
  CutOff,             // ends within the record at `offset`
  BytesSkipped,       // `count` bytes that are no records
  ChunkCorrupt,       // chunks that cannot be unpacked, or that end in the middle of a record
  ChunkChecksum,      // chunks with a wrong checksum: skipped
  ChunkTooLarge,      // chunks larger than allowed (Limits::most_chunk_bytes)
  ChunkCompression,   // chunks with an unknown compression: `name`
  ChunkTimes,         // chunks with messages outside of their stated times
  RecordTooLarge,     // schemas, channels, metadata beyond Limits::most_record_bytes: skipped
  RecordCorrupt,      // such records that say nothing sound
  UnknownChannel,     // messages of an undescribed channel
  ChannelChanged,     // channels described again, with other messages; the first description is used
  TimeUnusable,       // messages with an invalid log time: after the year 2261
  AttachmentCorrupt,  // wrong checksum, or cut off: `name`
  Unreadable,         // the disk could not read it
  MessagesMissing,    // `count` messages that it counts itself are not in it
  TableDamaged,  // a database whose table of messages cannot be read to its end; `count` messages were read
  FileMissing,   // a recording of several files lacks one, or one that cannot be read: `name`
  NoMetadata,    // a folder of rosbag2 without a usable metadata.yaml: its `count` files are played
  FilesLeftOut,  // `count` more files of such a recording than can be open at a time
  Unpacked,      // it was compressed as a whole (`name`: how), and has `count` bytes
};

/// How often, and where first.
struct Note {
  NoteCode code = NoteCode::NotFinished;
  std::uint64_t offset = 0;  // bytes from the start of the file
  std::uint64_t count = 1;   // number of occurrences
  std::string name;          // untrusted
  bool operator==(const Note&) const = default;
};

/// One note for each code and name, however often it occurs: keeps the list short for broken files.
class Notes {
 public:
  void add(NoteCode code, std::uint64_t offset, std::string_view name = {}, std::uint64_t count = 1);
  void drop(NoteCode code);
  const std::vector<Note>& all() const { return notes_; }

 private:
  std::vector<Note> notes_;
};

/// Why a recording cannot be opened at all.
struct Failure {
  enum class Code : std::uint8_t {
    File,         // `file` says it
    NotOne,       // neither MCAP nor a bag, or too short to tell
    Database,     // of SQLite, but no bag, or a damaged one
    NotUnpacked,  // compressed as a whole, and damaged or too large to be unpacked
    Pointer,      // what Git LFS leaves in its place
    Version,      // another major version of MCAP, or a bag before 2.0
    Encrypted,    // a bag whose chunks are encrypted
  };
  Code code = Code::File;
  disk::FileError file;
};

struct Summary {
  std::string profile, library;                  // the program that wrote it; empty in bags
  std::optional<std::int64_t> start_ns, end_ns;  // of the log times; nullopt: no messages
  std::uint64_t messages = 0;
  std::map<std::uint32_t, std::uint64_t> messages_of;  // by channel id
  bool counted = true;  // false: the file contains no counts; `messages` and `messages_of` are empty
  std::size_t chunks = 0;
  std::uint64_t bytes = 0;  // of the part of the file that was read
  bool finished = true;     // false: its end is missing; it may grow
  bool indexed = true;      // false: it had to be scanned
  std::vector<Note> notes;  // problems found so far

  std::int64_t durationNs() const { return start_ns && end_ns ? *end_ns - *start_ns : 0; }
};

/// The double nearest to the decimal value, so that printing and parsing it gives the same value.
constexpr double secondsOf(std::int64_t ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return double(ns / kSecond) + double(ns % kSecond) / double(kSecond);
}

/// The shortest decimal form of this double, rounded to a nanosecond. Clamped to 63 bits; NaN is 0.
std::int64_t nanosecondsOf(double s);

}  // namespace mapwright::recording
