#include "robot/recorded/recording_reasons.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>

#include <QDateTime>

#include "recorder/layout.h"
#include "robot/recorded/faults.h"
#include "words/qt_versions.h"

namespace mapwright::robot::recorded {
namespace {

constexpr const char* kBrokeOff = "broke_off_ns";

/// Which arguments the fault of a note has.
enum class Says { Nothing, Offset, Count, CountAndOffset, CountOffsetAndName, Name };
struct NoteFault {
  recording::NoteCode note;
  FaultCode fault;
  Says says;
  bool is_loss;
};
using Code = recording::NoteCode;
// Without NotFinished (interruptionOf) and TimeUnusable, which is counted when messages are read
// (BagChunk::without_stamp).
constexpr NoteFault kNoteFaults[] = {
    {Code::NoIndex,
     faultText("recorded", "It has no index, so the whole file was scanned. Opening it takes longer."),
     Says::Nothing, false},
    {Code::IndexUnusable, faultText("recorded", "Its index is damaged, so the whole file was scanned."),
     Says::Nothing, false},
    {Code::CutOff, fault::RecordingCutOff, Says::Offset, true},
    {Code::BytesSkipped, fault::RecordingBytesSkipped, Says::CountAndOffset, true},
    {Code::ChunkCorrupt, fault::RecordingChunksCorrupt, Says::CountAndOffset, true},
    {Code::ChunkChecksum, fault::RecordingChunksChanged, Says::CountAndOffset, true},
    {Code::ChunkTooLarge, fault::RecordingChunksTooLarge, Says::CountAndOffset, true},
    {Code::ChunkCompression, fault::RecordingChunksPacked, Says::CountOffsetAndName, true},
    {Code::ChunkTimes, fault::RecordingChunkTimesWrong, Says::CountAndOffset, false},
    {Code::RecordTooLarge, fault::RecordingRecordsTooLarge, Says::CountAndOffset, true},
    {Code::RecordCorrupt, fault::RecordingRecordsCorrupt, Says::CountAndOffset, true},
    {Code::UnknownChannel, fault::RecordingChannelsUnknown, Says::CountAndOffset, true},
    {Code::ChannelChanged, fault::RecordingChannelsChanged, Says::CountAndOffset, true},
    {Code::AttachmentCorrupt, fault::RecordingFileInItCorrupt, Says::Name, true},
    {Code::Unreadable, faultText("recorded", "The disk cannot read it at byte %1."), Says::Offset, true},
    {Code::MessagesMissing, fault::RecordingMessagesMissing, Says::Count, true},
    {Code::TableDamaged, fault::RecordingTableDamaged, Says::Count, true},
    {Code::FileMissing,
     faultText("recorded", "Its file %1 is missing or cannot be read. The others are played."), Says::Name,
     true},
    {Code::NoMetadata, fault::RecordingWithoutMetadata, Says::Count, true},
    {Code::FilesLeftOut, fault::RecordingFilesLeftOut, Says::Count, true},
    {Code::Unpacked,
     faultText("recorded", "It is compressed as a whole (zstd), so it was unpacked to a temporary file."),
     Says::Nothing, false}};

std::optional<std::int64_t> numberIn(const recording::Values& values, const char* name) {
  const auto found = values.find(name);
  if (found == values.end()) return std::nullopt;
  std::int64_t value = 0;
  const char* const end = found->second.data() + found->second.size();
  const auto [stop, error] = std::from_chars(found->second.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

/// "2024-06-03 09:00:00.250 UTC".
std::string timeWords(std::int64_t epoch_ns) {
  return words::utcOfMs(epoch_ns / 1'000'000)
      .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz 'UTC'"))
      .toStdString();
}

}  // namespace

Fault reasonOf(const recording::Note& note) {
  const std::int64_t count = std::int64_t(note.count), offset = std::int64_t(note.offset);
  for (const NoteFault& one : kNoteFaults) {
    if (one.note != note.code) continue;
    switch (one.says) {
      case Says::Nothing:
        return one.fault;
      case Says::Offset:
        return {one.fault, {offset}};
      case Says::Count:
        return {one.fault, {count}};
      case Says::CountAndOffset:
        return {one.fault, {count, offset}};
      case Says::CountOffsetAndName:
        return {one.fault, {count, offset, note.name}};
      case Says::Name:
        return {one.fault, {note.name}};
    }
  }
  return {};
}

bool isLoss(recording::NoteCode code) {
  const auto* const found = std::find_if(std::begin(kNoteFaults), std::end(kNoteFaults),
                                         [&](const NoteFault& one) { return one.note == code; });
  return found != std::end(kNoteFaults) && found->is_loss;
}

Fault reasonOf(const recording::Failure& failure) {
  using Why = recording::Failure::Code;
  if (failure.code == Why::NotOne)
    return faultText("recorded", "It is neither an MCAP file nor a bag of ROS 1 or ROS 2.");
  if (failure.code == Why::Database)
    return faultText("recorded",
                     "It is an SQLite database, but no bag of ROS 2, or one that is damaged or cut off.");
  if (failure.code == Why::NotUnpacked)
    return faultText("recorded", "It is compressed (zstd), and damaged or too large to be unpacked.");
  if (failure.code == Why::Pointer)
    return faultText("recorded",
                     "It is a pointer of Git LFS, not the recording itself (git lfs pull fetches it).");
  if (failure.code == Why::Version)
    return faultText("recorded",
                     "This version of the format is not supported. MCAP 0 and ROS bags of version 2.0 are.");
  if (failure.code == Why::Encrypted)
    return faultText("recorded", "Its messages are encrypted. Decrypt it with rosbag first.");
  return {fault::RecordingNotOpened, {failure.file.path}, {failure.file.cause}};
}

Fault reasonOf(const recording::RosSchemaFault& fault, const std::string& type) {
  using Why = recording::RosSchemaFault::Code;
  switch (fault.code) {
    case Why::TooLong:
      return {faultText("recorded", "The definition of %1 is longer than that of any real message."), {type}};
    case Why::NotAField:
      return {faultText("recorded", "The definition of %1 cannot be read (line %2: \"%3\")."),
              {type, std::int64_t(fault.line), fault.word}};
    case Why::UnknownType:
      return {faultText("recorded", "The definition of %1 does not define %2."), {type, fault.word}};
    case Why::HoldsItself:
      return {faultText("recorded", "The definition of %1 is recursive: %2 contains itself."),
              {type, fault.word}};
  }
  return {};
}

Fault reasonOf(const recording::RosDecodeFault& fault, const std::string& encoding) {
  using Why = recording::RosDecodeFault::Code;
  switch (fault.code) {
    case Why::NotThisEncoding:
      return {
          faultText("recorded", "The encoding of the message is not the one stated in the recording (%1)."),
          {encoding}};
    case Why::CutOff:
      return {faultText("recorded", "The message ends inside its field \"%1\"."), {fault.field}};
    case Why::TooMany:
      return {faultText("recorded", "The message is too large to be read, at its field \"%1\"."),
              {fault.field}};
    case Why::NotSupported:
      return {
          faultText("recorded", "The message has a field of type wstring (\"%1\"), which is not supported."),
          {fault.field}};
  }
  return {};
}

bool isInterrupted(const recording::Source& file) {
  if (!file.summary().finished) return true;
  const std::vector<recording::Metadata>& all = file.metadata();
  const auto has = [&](const char* name) {
    return std::any_of(all.begin(), all.end(),
                       [&](const recording::Metadata& one) { return one.name == name; });
  };
  return has(recorder::kAbout) && !has(recorder::kEnd) && !has(recorder::kRepaired);
}

bool isEndMark(const recording::Metadata& metadata) {
  return metadata.name == recorder::kEnd || metadata.name == recorder::kRepaired;
}

recording::Metadata repairMark(const recording::Summary& interrupted) {
  recording::Metadata mark{recorder::kRepaired, {}};
  if (interrupted.end_ns) mark.values[kBrokeOff] = std::to_string(*interrupted.end_ns);
  return mark;
}

std::optional<BagRepair> repairOf(const recording::Source& file) {
  std::optional<BagRepair> repair;
  for (const recording::Metadata& metadata : file.metadata()) {
    if (metadata.name != recorder::kRepaired) continue;
    repair.emplace();  // the last one counts
    if (const auto at_ns = numberIn(metadata.values, kBrokeOff))
      repair->broke_off_s = recording::secondsOf(*at_ns);
  }
  return repair;
}

Fault interruptionOf(const recording::Summary& summary) {
  if (!summary.end_ns) return fault::RecordingNotBegun;
  return {fault::RecordingNotFinished, {timeWords(*summary.end_ns)}};
}

std::vector<BagAway> awayIn(const recording::Source& file) {
  // The record of a reconnect repeats the time of the loss.
  std::map<std::int64_t, std::optional<std::int64_t>> back_of;
  for (const recording::Metadata& metadata : file.metadata()) {
    if (metadata.name != recorder::kLink) continue;
    const auto lost_ns = numberIn(metadata.values, "lost_ns");
    if (!lost_ns) continue;
    std::optional<std::int64_t>& back_ns = back_of[*lost_ns];
    if (const auto told_ns = numberIn(metadata.values, "back_ns")) back_ns = told_ns;
  }
  std::vector<BagAway> all;
  for (const auto& [lost_ns, back_ns] : back_of) {
    BagAway away{recording::secondsOf(lost_ns), std::nullopt};
    if (back_ns) away.until_s = recording::secondsOf(*back_ns);
    all.push_back(away);
  }
  return all;
}

Fault reasonOf(const BagAway& away) {
  const std::string from = timeWords(recording::nanosecondsOf(away.from_s));
  if (!away.until_s)
    return {faultText("recorded", "The connection to the robot was lost from %1 to the end."), {from}};
  return {faultText("recorded", "The connection to the robot was lost from %1 to %2."),
          {from, timeWords(recording::nanosecondsOf(*away.until_s))}};
}

}  // namespace mapwright::robot::recorded
