// A recording that is being written: entries become channels, messages and attachments (layout.h). Pure but
// for its target; time is handed in. One thread.
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
  std::uint64_t messages = 0;  // those that wait in the open chunk included
  std::uint64_t files = 0;     // attachments
  std::uint64_t lost = 0;      // messages and attachments that are in no file
  std::uint64_t lost_bytes = 0;
  std::optional<disk::FileError> fault;  // why the disk takes nothing now
};

class Tape {
 public:
  explicit Tape(std::unique_ptr<recording::McapWriter> writer) : writer_(std::move(writer)) {}

  /// An attachment that is there already with the same content is left out. One that the disk does not take
  /// waits, within a bound, and is tried again by tick(); so are metadata. A message whose type is not
  /// defined yet waits for that, not for long.
  void write(Entry entry);
  /// To be called several times a second.
  void tick(std::int64_t now_ns);
  /// Once: writes what waits, how it ended and the index. `elsewhere`: what was lost on the way here.
  std::optional<disk::FileError> finish(std::int64_t now_ns, EntryQueue::Losses elsewhere);
  Written written() const;

  static constexpr std::size_t kMostWaitingBytes = std::size_t(64) << 20;
  static constexpr std::int64_t kDefinedWithinNs = 5'000'000'000;

 private:
  void message(Entry entry);
  std::optional<recording::ChannelId> channelOf(const Entry& entry, const MessageForms::Formed& formed);
  void holdUndefined(Entry entry);
  void writeUndefined(const std::string& type);
  /// Those of types that nobody will define any more.
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
  /// Topic, encoding, type, encoding of the schema, said before.
  using Key = std::tuple<std::string, std::string, std::string, std::string, bool>;
  std::map<Key, recording::ChannelId> channels_;
  std::map<std::string, std::pair<std::size_t, std::size_t>> files_;  // size and hash, by name
  std::deque<Entry> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::int64_t tried_ns_ = 0;  // to write what waits
  std::uint64_t files_written_ = 0, lost_ = 0, lost_bytes_ = 0;
  bool ended_ = false;  // what is in no chunk is in no file
  std::optional<disk::FileError> fault_;
};

}  // namespace mapwright::recorder
