#include "robot/recorded/recording_reasons.h"

#include "disk/file_error.h"
#include "robot/recorded/faults.h"

namespace mapwright::robot::recorded {

Fault reasonOf(const recording::Note& note) {
  using Code = recording::NoteCode;
  const std::vector<FaultArgument> counted{std::int64_t(note.count), std::int64_t(note.offset)};
  const std::int64_t place(static_cast<std::int64_t>(note.offset));
  switch (note.code) {
    case Code::NotFinished:
      break;  // reasonOf(Interruption)
    case Code::NoIndex:
      return fault::RecordingWithoutIndex;
    case Code::IndexUnusable:
      return fault::RecordingIndexUnusable;
    case Code::CutOff:
      return {fault::RecordingCutOff, {place}};
    case Code::BytesSkipped:
      return {fault::RecordingBytesSkipped, counted};
    case Code::ChunkCorrupt:
      return {fault::RecordingChunksCorrupt, counted};
    case Code::ChunkChecksum:
      return {fault::RecordingChunksChanged, counted};
    case Code::ChunkTooLarge:
      return {fault::RecordingChunksTooLarge, counted};
    case Code::ChunkCompression:
      return {fault::RecordingChunksPacked, {std::int64_t(note.count), place, note.name}};
    case Code::ChunkTimes:
      return {fault::RecordingChunkTimesWrong, counted};
    case Code::IndexLies:
      return {fault::RecordingIndexLies, counted};
    case Code::RecordTooLarge:
      return {fault::RecordingRecordsTooLarge, counted};
    case Code::RecordCorrupt:
      return {fault::RecordingRecordsCorrupt, counted};
    case Code::UnknownChannel:
      return {fault::RecordingChannelsUnknown, counted};
    case Code::ChannelChanged:
      return {fault::RecordingChannelsChanged, counted};
    case Code::AttachmentCorrupt:
      return {fault::RecordingFileInItCorrupt, {note.name}};
    case Code::TimeUnusable:
      break;  // counted when messages are read (BagChunk::without_stamp)
    case Code::Unreadable:
      return {fault::RecordingNotReadByDisk, {place}};
  }
  return {};
}

bool isLoss(recording::NoteCode code) {
  using Code = recording::NoteCode;
  return code != Code::NotFinished && code != Code::NoIndex && code != Code::IndexUnusable &&
         code != Code::TimeUnusable && code != Code::ChunkTimes && code != Code::IndexLies &&
         code != Code::ChannelChanged;
}

Fault reasonOf(const recording::Failure& failure) {
  using Code = recording::Failure::Code;
  switch (failure.code) {
    case Code::File:
      break;
    case Code::NotOne:
      return fault::RecordingIsNone;
    case Code::Version:
      return fault::RecordingOfOtherVersion;
    case Code::Encrypted:
      return fault::RecordingEncrypted;
  }
  return {fault::RecordingNotOpened, {failure.file.path}, {failure.file.cause}};
}

Fault reasonOf(const recording::RosSchemaFault& fault, const std::string& type) {
  using Code = recording::RosSchemaFault::Code;
  switch (fault.code) {
    case Code::TooLong:
      return {fault::RosSchemaTooLong, {type}};
    case Code::NotAField:
      return {fault::RosSchemaBroken, {type, std::int64_t(fault.line), fault.word}};
    case Code::UnknownType:
      return {fault::RosSchemaTypeUnknown, {type, fault.word}};
    case Code::HoldsItself:
      return {fault::RosSchemaHoldsItself, {type, fault.word}};
  }
  return {};
}

Fault reasonOf(const recording::RosDecodeFault& fault, const std::string& encoding) {
  using Code = recording::RosDecodeFault::Code;
  switch (fault.code) {
    case Code::NotThisEncoding:
      return {fault::RosMessageOtherwise, {encoding}};
    case Code::CutOff:
      return {fault::RosMessageCutOff, {fault.field}};
    case Code::TooMany:
      return {fault::RosMessageTooLarge, {fault.field}};
    case Code::NotSupported:
      return {fault::RosMessageWideText, {fault.field}};
  }
  return {};
}

}  // namespace mapwright::robot::recorded
