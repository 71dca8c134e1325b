// A recording that is read, whichever format it has. Nothing in the file is trusted: lengths are checked
// before memory is taken, what is not sound is skipped and noted (Summary::notes), nothing throws.
//
// One thread at a time for a source and its cursors; messages may go anywhere.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "recording/bytes.h"
#include "recording/message.h"
#include "recording/note.h"

namespace mapwright::recording {

/// How much memory a file may make us take.
struct Limits {
  std::uint64_t most_chunk_bytes = std::uint64_t(256) << 20;  // of one chunk, unpacked and packed
  std::uint64_t most_record_bytes = std::uint64_t(64)
                                    << 20;          // of a schema, a channel, metadata; the index: 16 times
  std::size_t held_bytes = std::size_t(256) << 20;  // unpacked chunks that are kept for their next use
};

/// The messages from first_ns to last_ns, both included, on these topics (none = all).
struct Query {
  std::int64_t first_ns = std::numeric_limits<std::int64_t>::min();
  std::int64_t last_ns = std::numeric_limits<std::int64_t>::max();
  std::vector<std::string> topics;
  bool backwards = false;
};

/// The chunks that are packed alike.
struct Packing {
  std::string compression;  // "zstd", "lz4", "bz2"; empty: none
  std::uint64_t chunks = 0, packed_bytes = 0, unpacked_bytes = 0;
};

/// Messages one after the other. Must not outlive its source.
class Cursor {
 public:
  virtual ~Cursor() = default;
  /// nullopt: no more.
  virtual std::optional<Message> next() = 0;
};

class Source {
 public:
  virtual ~Source() = default;

  virtual Summary summary() const = 0;
  virtual std::vector<ChannelPtr> channels() const = 0;  // by id

  /// In the order of their log times; those of the same time as they stand in the file (backwards: exactly
  /// the other way round). It is about what refresh() has found until now.
  virtual std::unique_ptr<Cursor> messages(const Query& query) = 0;
  /// Of each of the topics (none = all) the last message at or before `at_ns`: the one that messages() would
  /// give last. Found by the index; only the chunks that hold one of them are unpacked.
  virtual std::vector<Message> lastBefore(std::int64_t at_ns, const std::vector<std::string>& topics) = 0;

  /// "MCAP", "ROS bag 2.0".
  virtual std::string format() const = 0;
  /// By the heads of the chunks, each of which is read. Messages outside of chunks are not in it.
  virtual std::vector<Packing> packing() const = 0;

  virtual const std::vector<AttachmentPlace>& attachments() const = 0;
  /// nullopt: it is not sound, which is noted.
  virtual std::optional<Attachment> attachment(const AttachmentPlace& place) = 0;
  virtual const std::vector<Metadata>& metadata() const = 0;

  /// Looks for what was written since; true: there is more. A file that is finished does not change.
  virtual bool refresh() = 0;
};

using Opened = tl::expected<std::unique_ptr<Source>, Failure>;

/// Whatever it is, by its first bytes.
Opened openRecording(const std::string& path, const Limits& limits = {});
Opened openRecording(std::unique_ptr<Bytes> bytes, const Limits& limits = {});

}  // namespace mapwright::recording
