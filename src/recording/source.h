// A recording opened for reading, in any format. Nothing in the file is trusted: lengths are checked before
// memory is allocated, invalid parts are skipped and noted (Summary::notes), nothing throws.
// A source and its cursors are used by one thread at a time; messages may be passed to any.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "recording/bytes.h"
#include "recording/message.h"

namespace mapwright::recording {

/// How much memory a file may use.
struct Limits {
  std::uint64_t most_chunk_bytes = std::uint64_t(256) << 20;  // of one chunk, unpacked and packed
  std::uint64_t most_record_bytes = std::uint64_t(64)
                                    << 20;          // of a schema, a channel, metadata; the index: 16 times
  std::size_t held_bytes = std::size_t(256) << 20;  // unpacked chunks kept for reuse
  std::uint64_t most_unpacked_bytes = std::uint64_t(64) << 30;  // of a file that is compressed as a whole
};

/// The messages from first_ns to last_ns, both inclusive, on these topics (none = all).
struct Query {
  std::int64_t first_ns = std::numeric_limits<std::int64_t>::min();
  std::int64_t last_ns = std::numeric_limits<std::int64_t>::max();
  std::vector<std::string> topics;
  bool backwards = false;
};

/// The chunks with the same compression.
struct Packing {
  std::string compression;  // "zstd", "lz4", "bz2"; empty: none
  std::uint64_t chunks = 0, packed_bytes = 0, unpacked_bytes = 0;
};

/// Iterates over messages. Must not outlive its source.
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

  /// In the order of log times; messages of the same time in file order (backwards: exactly reversed). Covers
  /// what refresh() has found so far.
  virtual std::unique_ptr<Cursor> messages(const Query& query) = 0;
  /// For each of the topics (none = all) the last message at or before `at_ns`: the one that messages() would
  /// give last. Only chunks that may hold one are unpacked.
  virtual std::vector<Message> lastBefore(std::int64_t at_ns, const std::vector<std::string>& topics) = 0;

  /// The log time of the first or last message of each of these channels; without messages it is left out.
  virtual std::map<std::uint32_t, std::int64_t> outermostTimes(const std::set<std::uint32_t>& channels,
                                                               bool last) = 0;

  /// "MCAP", "ROS bag 2.0", "SQLite (rosbag2)".
  virtual std::string format() const = 0;
  /// From the headers of the chunks, all of which are read. Does not include messages outside of chunks.
  virtual std::vector<Packing> packing() const = 0;

  virtual const std::vector<AttachmentLocation>& attachments() const = 0;
  /// nullopt: it is damaged, which is noted.
  virtual std::optional<Attachment> attachment(const AttachmentLocation& location) = 0;
  virtual const std::vector<Metadata>& metadata() const = 0;

  /// Checks for data written since; true: there is more. A complete file does not change.
  virtual bool refresh() = 0;
};

using Opened = tl::expected<std::unique_ptr<Source>, Failure>;

/// True: whatever is being read ends now, as if the disk failed.
using Stop = std::function<bool()>;

/// How many of a file's first bytes tell whether it is a recording.
inline constexpr std::size_t kLookedAt = 16;
bool looksLikeRecording(std::span<const std::uint8_t> start);
/// A folder with a metadata.yaml of rosbag2, or that file; or a folder in which a recorder did not get to it.
bool isRosbagFolder(const std::string& path);
/// A file: the format is detected from the first bytes. Compressed with Zstandard as a whole, it is unpacked
/// to a temporary file first, which is noted. A folder (isRosbagFolder()): its files, one after the other.
Opened openRecording(const std::string& path, const Limits& limits = {}, Stop stop = {});
Opened openRecording(std::unique_ptr<Bytes> bytes, const Limits& limits = {});

}  // namespace mapwright::recording
