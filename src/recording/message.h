// The content of a recording, in any format: channels, messages, attachments. Value types, any thread. Times
// are nanoseconds since the epoch of the recorder's clock (usually 1970, UTC); texts are UTF-8 as in the
// file, and untrusted. Sources: MCAP format specification, "Records"; "ROS bag format 2.0".
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "recording/note.h"

namespace mapwright::recording {

using Words = std::map<std::string, std::string>;

/// A stream of messages of one type on one topic. Several channels may have the same topic.
struct Channel {
  std::uint32_t id = 0;  // within the file
  std::string topic;
  std::string message_encoding;  // "json", "cdr", "ros1", "cbor", "protobuf" …
  std::string schema_name;       // "nav_msgs/Path"; empty: none
  std::string schema_encoding;   // "jsonschema", "ros1msg", "ros2msg" …; empty: none
  std::string schema_data;
  Words metadata;  // for a bag: "callerid", "latching", "md5sum" …
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
struct AttachmentPlace {
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
  Words words;
  bool operator==(const Metadata&) const = default;
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

}  // namespace mapwright::recording
