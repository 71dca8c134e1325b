// What is wrong with a recording, as values; sentences are made of them elsewhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "disk/file_error.h"

namespace mapwright::recording {

/// What was found in a file that can be read all the same.
enum class NoteCode : std::uint8_t {
  NotFinished,        // its end is missing: whoever wrote it was interrupted, or still writes
  NoIndex,            // finished, and without an index: it was looked through
  IndexUnusable,      // its index is damaged: it was looked through
  CutOff,             // ends within the record at `offset`
  BytesSkipped,       // `count` bytes that are no records
  ChunkCorrupt,       // chunks that cannot be unpacked, or whose records end within
  ChunkChecksum,      // chunks that are not what was written: skipped
  ChunkTooLarge,      // chunks that would take more memory than is allowed (Limits::most_chunk_bytes)
  ChunkCompression,   // chunks in a compression that nobody here knows: `name`
  ChunkTimes,         // chunks with messages outside of the times that they say of themselves
  IndexLies,          // places where the index says a message is and none is
  RecordTooLarge,     // schemas, channels, metadata beyond Limits::most_record_bytes: skipped
  RecordCorrupt,      // such records that say nothing sound
  UnknownChannel,     // messages of a channel that nothing describes
  ChannelChanged,     // channels described a second time and otherwise; the first stands
  TimeUnusable,       // messages whose log time is none: beyond the year 2261
  AttachmentCorrupt,  // its checksum does not fit, or it is cut off: `name`
  Unreadable,         // the disk could not read it
};

/// How often, and where first.
struct Note {
  NoteCode code = NoteCode::NotFinished;
  std::uint64_t offset = 0;  // bytes from the start of the file
  std::uint64_t count = 1;   // of what the code names
  std::string name;          // untrusted
  bool operator==(const Note&) const = default;
};

/// One note for each code and name, however often it is found: a broken file makes no long list.
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
    File,       // `file` says it
    NotOne,     // neither MCAP nor a bag, or shorter than its first mark
    Version,    // MCAP of another major version, a bag before 2.0
    Encrypted,  // a bag whose chunks are encrypted
  };
  Code code = Code::File;
  disk::FileError file;
};

}  // namespace mapwright::recording
