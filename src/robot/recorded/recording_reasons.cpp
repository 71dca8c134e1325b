#include "robot/recorded/recording_reasons.h"

#include "reasons/file_reason.h"

namespace mapwright::robot::recorded {

using map::ReasonCode;

map::Reason reasonOf(const recording::Note& note) {
  using Code = recording::NoteCode;
  const std::vector<map::Argument> counted{std::int64_t(note.count), std::int64_t(note.offset)};
  const std::int64_t place(static_cast<std::int64_t>(note.offset));
  switch (note.code) {
    case Code::NotFinished:
      break;  // reasonOf(Interruption)
    case Code::NoIndex:
      return ReasonCode::RecordingWithoutIndex;
    case Code::IndexUnusable:
      return ReasonCode::RecordingIndexUnusable;
    case Code::CutOff:
      return {ReasonCode::RecordingCutOff, {place}};
    case Code::BytesSkipped:
      return {ReasonCode::RecordingBytesSkipped, counted};
    case Code::ChunkCorrupt:
      return {ReasonCode::RecordingChunksCorrupt, counted};
    case Code::ChunkChecksum:
      return {ReasonCode::RecordingChunksChanged, counted};
    case Code::ChunkTooLarge:
      return {ReasonCode::RecordingChunksTooLarge, counted};
    case Code::ChunkCompression:
      return {ReasonCode::RecordingChunksPacked, {std::int64_t(note.count), place, note.name}};
    case Code::ChunkTimes:
      return {ReasonCode::RecordingChunkTimesWrong, counted};
    case Code::IndexLies:
      return {ReasonCode::RecordingIndexLies, counted};
    case Code::RecordTooLarge:
      return {ReasonCode::RecordingRecordsTooLarge, counted};
    case Code::RecordCorrupt:
      return {ReasonCode::RecordingRecordsCorrupt, counted};
    case Code::UnknownChannel:
      return {ReasonCode::RecordingChannelsUnknown, counted};
    case Code::ChannelChanged:
      return {ReasonCode::RecordingChannelsChanged, counted};
    case Code::AttachmentCorrupt:
      return {ReasonCode::RecordingFileInItCorrupt, {note.name}};
    case Code::TimeUnusable:
      break;  // they are counted where messages are read (BagChunk::without_stamp)
    case Code::Unreadable:
      return {ReasonCode::RecordingNotReadByDisk, {place}};
  }
  return {};
}

bool isLoss(recording::NoteCode code) {
  using Code = recording::NoteCode;
  return code != Code::NotFinished && code != Code::NoIndex && code != Code::IndexUnusable &&
         code != Code::TimeUnusable && code != Code::ChunkTimes && code != Code::IndexLies &&
         code != Code::ChannelChanged;
}

map::Reason reasonOf(const recording::Failure& failure) {
  using Code = recording::Failure::Code;
  switch (failure.code) {
    case Code::File:
      break;
    case Code::NotOne:
      return ReasonCode::RecordingIsNone;
    case Code::Version:
      return ReasonCode::RecordingOfOtherVersion;
    case Code::Encrypted:
      return ReasonCode::RecordingEncrypted;
  }
  return {ReasonCode::RecordingNotOpened, {failure.file.path}, {reasons::causeOf(failure.file)}};
}

map::Reason reasonOf(const recording::RosSchemaFault& fault, const std::string& type) {
  using Code = recording::RosSchemaFault::Code;
  switch (fault.code) {
    case Code::TooLong:
      return {ReasonCode::RosSchemaTooLong, {type}};
    case Code::NotAField:
      return {ReasonCode::RosSchemaBroken, {type, std::int64_t(fault.line), fault.word}};
    case Code::UnknownType:
      return {ReasonCode::RosSchemaTypeUnknown, {type, fault.word}};
    case Code::HoldsItself:
      return {ReasonCode::RosSchemaHoldsItself, {type, fault.word}};
  }
  return {};
}

map::Reason reasonOf(const recording::RosDecodeFault& fault, const std::string& encoding) {
  using Code = recording::RosDecodeFault::Code;
  switch (fault.code) {
    case Code::NotThisEncoding:
      return {ReasonCode::RosMessageOtherwise, {encoding}};
    case Code::CutOff:
      return {ReasonCode::RosMessageCutOff, {fault.field}};
    case Code::TooMany:
      return {ReasonCode::RosMessageTooLarge, {fault.field}};
    case Code::NotSupported:
      return {ReasonCode::RosMessageWideText, {fault.field}};
  }
  return {};
}

}  // namespace mapwright::robot::recorded
