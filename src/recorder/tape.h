// A recording being written: turns entries into channels, messages and attachments (layout.h). Pure except
// for its target; time is passed in. One thread.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "recorder/entry_queue.h"
#include "recorder/message_forms.h"
#include "recording/mcap_writer.h"

namespace mapwright::recorder {

struct Written {
  std::uint64_t bytes = 0;     // in the file
  std::uint64_t messages = 0;  // including those in the open chunk
  std::uint64_t files = 0;     // attachments
  std::uint64_t lost = 0;      // messages and attachments that were not written
  std::uint64_t lost_bytes = 0;
  std::optional<disk::FileError> fault;  // why the disk accepts nothing now
};

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
