// A recording being written: a queue of entries, the form in which others can read them, and the tape, which
// turns them into channels, messages and attachments (layout.h). Pure except for the target; time is passed
// in.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "recording/mcap_writer.h"
#include "recording/message.h"
#include "recording/ros_schema.h"

namespace mapwright::recorder {

/// A message, an attachment, metadata, or a message definition.
struct Entry {
  enum class Kind : std::uint8_t { Message, File, Metadata, Definition };
  Kind kind = Kind::Message;
  std::string name;              // topic; or name of an attachment, metadata or type
  std::string encoding, schema;  // of a message; for an attachment `encoding` is its media type
  bool before = false;           // sent before the recording began
  std::int64_t log_ns = 0, publish_ns = 0;
  std::uint32_t sequence = 0;  // set by the queue
  std::string bytes;
  recording::Values values;
};

/// Thread-safe. Bounded: producers never wait for the disk; entries without space are lost and counted.
class EntryQueue {
 public:
  explicit EntryQueue(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// `bytes` become those of the entry. False: full or closed.
  bool put(Entry entry, std::string_view bytes);
  /// All entries, in order; waits up to `at_most` for the first. Empty: nothing came, or it is closed.
  std::vector<Entry> take(std::chrono::milliseconds at_most);
  /// Nothing more is taken in.
  void close();
  /// Closed and empty.
  bool over() const;

  /// Whether a message of this topic has arrived, including lost ones.
  bool heard(const std::string& topic) const;

  struct Losses {
    std::uint64_t entries = 0, bytes = 0;
  };
  Losses lost() const;

 private:
  std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::vector<Entry> entries_;
  std::size_t held_bytes_ = 0;
  int being_put_ = 0;  // space is reserved, they are being copied
  bool closed_ = false;
  Losses lost_;
  std::unordered_map<std::string, std::uint32_t> sequences_;  // by topic
  std::unordered_set<std::string> said_before_;               // topics
};

/// The format of recorded messages, so that other programs can read them: by their type definition, or as
/// JSON if there is none (layout.h). One thread.
class MessageForms {
 public:
  /// Whether it can be written: its type is defined, never will be, or does not matter.
  bool ready(const Entry& message) const;
  /// A definition (robot::Delivery::Kind::Definition) of type `name` for `encoding`. Empty bytes: not
  /// available. The first valid one counts: messages that do not match it are written as received.
  void define(const Entry& definition);
  /// Stop waiting for the definition. If it still comes it is used from then on.
  void giveUp(const std::string& type);

  /// The message with content `bytes` in its final form, and the encodings and schema of its channel.
  struct Formed {
    std::string encoding, schema_name, schema_encoding, schema_data;
    std::string bytes;
  };
  Formed formed(const Entry& message, std::string bytes) const;

 private:
  struct Definition {
    std::string encoding, text;               // empty: not available
    std::optional<recording::RosSchema> ros;  // for ROS types, if it can be parsed
  };
  static Formed asJson(const Entry& message, std::string bytes);
  std::map<std::string, Definition> definitions_;  // by type
};

struct Written {
  std::uint64_t bytes = 0;     // in the file
  std::uint64_t messages = 0;  // including those in the open chunk
  std::uint64_t files = 0;     // attachments
  std::uint64_t lost = 0;      // messages and attachments that were not written
  std::uint64_t lost_bytes = 0;
  std::optional<disk::FileError> fault;  // why the disk accepts nothing now
};

/// One thread.
class Tape {
 public:
  explicit Tape(std::unique_ptr<recording::McapWriter> writer) : writer_(std::move(writer)) {}

  /// Attachments with the same content as before are skipped. If the disk accepts no attachment it waits, up
  /// to a limit, and tick() tries again; the same for metadata. A message whose type is not defined yet waits
  /// a short time.
  void write(Entry entry);
  /// Call this several times a second.
  void tick(std::int64_t now_ns);
  /// Call once: writes what is waiting, how the recording ended, and the index. `elsewhere`: losses before
  /// this point.
  std::optional<disk::FileError> finish(std::int64_t now_ns, EntryQueue::Losses elsewhere);
  Written written() const;

  static constexpr std::size_t kMostWaitingBytes = std::size_t(64) << 20;
  static constexpr std::int64_t kDefinedWithinNs = 5'000'000'000;

 private:
  void message(Entry entry);
  std::optional<recording::ChannelId> channelOf(const Entry& entry, const MessageForms::Formed& formed);
  void holdUndefined(Entry entry);
  void writeUndefined(const std::string& type);
  /// Messages of types that will never be defined.
  void giveUp(std::optional<std::int64_t> now_ns);
  std::optional<disk::FileError> beside(const Entry& entry);
  void wait(Entry entry);
  void lose(std::size_t bytes);

  std::unique_ptr<recording::McapWriter> writer_;
  MessageForms forms_;
  /// Messages of a type that is not defined yet.
  struct Undefined {
    std::vector<Entry> messages;
    std::optional<std::int64_t> since_ns;  // by the clock of tick()
  };
  std::map<std::string, Undefined> undefined_;  // by type
  std::size_t undefined_bytes_ = 0;
  /// Topic, encoding, type, schema encoding, sent before.
  using Key = std::tuple<std::string, std::string, std::string, std::string, bool>;
  std::map<Key, recording::ChannelId> channels_;
  std::map<std::string, std::pair<std::size_t, std::size_t>> files_;  // size and hash, by name
  std::deque<Entry> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::int64_t tried_ns_ = 0;  // when writing was last tried
  std::uint64_t files_written_ = 0, lost_ = 0, lost_bytes_ = 0;
  bool ended_ = false;  // data in no chunk is lost
  std::optional<disk::FileError> fault_;
};

}  // namespace mapwright::recorder
