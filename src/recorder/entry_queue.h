// The queue between producers and the writer of a recording.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "recording/message.h"

namespace mapwright::recorder {

/// A message, an attachment, metadata, or a message definition.
struct Entry {
  enum class Kind : std::uint8_t { Message, File, Words, Definition };
  Kind kind = Kind::Message;
  std::string name;              // topic; or name of an attachment, metadata or type
  std::string encoding, schema;  // of a message; for an attachment `encoding` is its media type
  bool before = false;           // sent before the recording began
  std::int64_t log_ns = 0, publish_ns = 0;
  std::uint32_t sequence = 0;  // set by the queue
  std::string bytes;
  recording::Words words;
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

}  // namespace mapwright::recorder
