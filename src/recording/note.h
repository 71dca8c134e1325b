// Problems of a recording, as values; the texts are made elsewhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "disk/file_error.h"

namespace mapwright::recording {

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
  IndexLies,          // index entries that point to no message
  RecordTooLarge,     // schemas, channels, metadata beyond Limits::most_record_bytes: skipped
  RecordCorrupt,      // such records that say nothing sound
  UnknownChannel,     // messages of an undescribed channel
  ChannelChanged,     // channels described again differently; the first description is used
  TimeUnusable,       // messages with an invalid log time: after the year 2261
  AttachmentCorrupt,  // wrong checksum, or cut off: `name`
  Unreadable,         // the disk could not read it
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
    File,       // `file` says it
    NotOne,     // neither MCAP nor a bag, or too short to tell
    Version,    // another major version of MCAP, or a bag before 2.0
    Encrypted,  // a bag whose chunks are encrypted
  };
  Code code = Code::File;
  disk::FileError file;
};

}  // namespace mapwright::recording
