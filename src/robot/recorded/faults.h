// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::recorded::fault {

using namespace mapwright::fault;  // what all rooms share

// Recordings as files. Offsets are bytes from the start of the file.
/// its name; because: why
inline constexpr FaultCode RecordingNotOpened{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The recording %1 cannot be opened")};
/// the time of its last message
inline constexpr FaultCode RecordingNotFinished{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "Its end is missing: recording was interrupted after %1, or is still going on.")};
/// likewise, without any message
inline constexpr FaultCode RecordingNotBegun{
    "recorded",
    QT_TRANSLATE_NOOP(
        "recorded",
        "Its end is missing and it has no messages yet: recording was interrupted, or is still going on.")};
/// offset
inline constexpr FaultCode RecordingCutOff{
    "recorded", QT_TRANSLATE_NOOP("recorded", "It is cut off at byte %1. Everything before that is played.")};
/// how many, offset of the first
inline constexpr FaultCode RecordingBytesSkipped{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded", "%1 bytes of it cannot be read (from byte %2 on) and are skipped.")};
/// how many, offset of the first
inline constexpr FaultCode RecordingChunksCorrupt{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded",
                        "%1 chunks of it cannot be unpacked (the first at byte %2) and are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChunksChanged{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded", "%1 chunks of it are corrupted (the first at byte %2) and are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChunksTooLarge{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded", "%1 chunks of it would need too much memory (the first at byte %2) and are skipped.")};
/// likewise, their compression
inline constexpr FaultCode RecordingChunksPacked{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded",
        "%1 chunks of it use an unknown compression: %3 (the first at byte %2). They are skipped.")};
/// how many, offset of the first
inline constexpr FaultCode RecordingChunkTimesWrong{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded", "%1 chunks of it state a wrong time range (the first at byte %2).")};
/// likewise
inline constexpr FaultCode RecordingRecordsTooLarge{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded", "%1 message definitions in it are too large (the first at byte %2) and are skipped.")};
/// likewise
inline constexpr FaultCode RecordingRecordsCorrupt{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded", "%1 message definitions in it cannot be read (the first at byte %2) and are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChannelsUnknown{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded",
        "%1 messages belong to topics that it does not describe (the first at byte %2) and are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChannelsChanged{
    "recorded", QT_TRANSLATE_N_NOOP("recorded",
                                    "%1 topics are described twice and differently (the first at byte %2). "
                                    "The first description is used.")};
/// its name
inline constexpr FaultCode RecordingFileInItCorrupt{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The file %1 in the recording is damaged.")};
/// how many
inline constexpr FaultCode RecordingMessagesUntimed{
    "recorded", QT_TRANSLATE_N_NOOP("recorded", "%1 messages have no usable time and are left out.")};
/// how many
inline constexpr FaultCode RecordingMessagesMissing{
    "recorded", QT_TRANSLATE_N_NOOP("recorded", "%1 messages that it counts are not in it.")};
/// how many files
inline constexpr FaultCode RecordingWithoutMetadata{
    "recorded", QT_TRANSLATE_N_NOOP("recorded",
                                    "Its metadata.yaml is missing or damaged, as after an interrupted "
                                    "recording. The %1 files in its folder are played.")};
/// how many
inline constexpr FaultCode RecordingFilesLeftOut{
    "recorded", QT_TRANSLATE_N_NOOP("recorded", "%1 files of it are not played: it has too many.")};
/// how many
inline constexpr FaultCode RecordingTableDamaged{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded", "It is damaged: after %1 messages no more of it can be read.")};

// Messages in recordings.
/// type
inline constexpr FaultCode RosSchemaMissing{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The recording does not define the message type %1.")};
/// bytes
inline constexpr FaultCode RosMessageLonger{
    "recorded", QT_TRANSLATE_N_NOOP("recorded",
                                    "A message has %1 bytes more than its definition describes: the "
                                    "definition may be another one. They are not shown.")};
/// encoding of the message, of its schema
inline constexpr FaultCode RosEncodingUnknown{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "Messages with encoding \"%1\" and definitions in \"%2\" are not supported.")};

}  // namespace mapwright::robot::recorded::fault
