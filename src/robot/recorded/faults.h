// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::recorded::fault {

using namespace mapwright::fault;  // what all rooms share

// Recordings as files. Places are bytes from the start of the file.
/// its name; because: why
inline constexpr FaultCode RecordingNotOpened{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The recording %1 cannot be opened")};
inline constexpr FaultCode RecordingIsPointer{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "It is a pointer of Git LFS, not the recording itself (git lfs pull fetches it).")};
inline constexpr FaultCode RecordingIsNone{
    "recorded", QT_TRANSLATE_NOOP("recorded", "It is neither an MCAP file nor a bag of ROS 1 or ROS 2.")};
inline constexpr FaultCode RecordingOfOtherVersion{
    "recorded",
    QT_TRANSLATE_NOOP(
        "recorded", "This version of the format is not supported. MCAP 0 and ROS bags of version 2.0 are.")};
inline constexpr FaultCode RecordingEncrypted{
    "recorded", QT_TRANSLATE_NOOP("recorded", "Its messages are encrypted. Decrypt it with rosbag first.")};
/// their namespaces, the one that is shown
inline constexpr FaultCode RecordingOfRobots{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "It contains several robots: %1. Shown as the robot is %2. To see another one, add "
                      "?ns=/NAMESPACE to the address of the file.")};
/// the namespace asked for, those that it has
inline constexpr FaultCode RecordingLacksRobot{
    "recorded", QT_TRANSLATE_NOOP("recorded", "It contains no robot %1, only %2.")};
/// the namespace asked for
inline constexpr FaultCode RecordingOfOneRobot{
    "recorded", QT_TRANSLATE_NOOP("recorded", "It contains no topic in the namespace %1.")};
inline constexpr FaultCode RecordingOnlyRead{
    "recorded", QT_TRANSLATE_NOOP("recorded", "recordings on this computer are read-only here")};
inline constexpr FaultCode RecordingLacksPicture{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "The recording does not contain the picture that this message names.")};
inline constexpr FaultCode RecordingLacksSubmap{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The recording does not contain this submap.")};
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
/// from when, until when
inline constexpr FaultCode RecordingLinkAway{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The connection to the robot was lost from %1 to %2.")};
/// since when
inline constexpr FaultCode RecordingLinkGone{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The connection to the robot was lost from %1 to the end.")};
inline constexpr FaultCode RecordingWithoutIndex{
    "recorded", QT_TRANSLATE_NOOP(
                    "recorded", "It has no index, so the whole file was scanned. Opening it takes longer.")};
inline constexpr FaultCode RecordingIndexUnusable{
    "recorded", QT_TRANSLATE_NOOP("recorded", "Its index is damaged, so the whole file was scanned.")};
/// place
inline constexpr FaultCode RecordingCutOff{
    "recorded", QT_TRANSLATE_NOOP("recorded", "It is cut off at byte %1. Everything before that is played.")};
/// how many, place of the first
inline constexpr FaultCode RecordingBytesSkipped{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded", "%1 bytes of it cannot be read (from byte %2 on) and are skipped.")};
/// how many, place of the first
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
/// how many, place of the first
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
/// place
inline constexpr FaultCode RecordingNotReadByDisk{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The disk cannot read it at byte %1.")};
/// how many
inline constexpr FaultCode RecordingTableDamaged{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded", "It is damaged: after %1 messages no more of it can be read.")};
/// the name of the file
inline constexpr FaultCode RecordingPartMissing{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "Its file %1 is missing or cannot be read. The others are played.")};
inline constexpr FaultCode RecordingUnpacked{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "It is compressed as a whole (zstd), so it was unpacked to a temporary file.")};
inline constexpr FaultCode RecordingNotUnpacked{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "It is compressed (zstd), and damaged or too large to be unpacked.")};

// Messages in recordings.
/// type
inline constexpr FaultCode RosSchemaTooLong{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "The definition of %1 is longer than that of any real message.")};
/// type, line, what stands there
inline constexpr FaultCode RosSchemaBroken{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The definition of %1 cannot be read (line %2: \"%3\").")};
/// type, the one that is missing
inline constexpr FaultCode RosSchemaTypeUnknown{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The definition of %1 does not define %2.")};
/// type, the one in it
inline constexpr FaultCode RosSchemaHoldsItself{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The definition of %1 is recursive: %2 contains itself.")};
/// type
inline constexpr FaultCode RosSchemaMissing{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The recording does not define the message type %1.")};
/// encoding of the message, of its schema
inline constexpr FaultCode RosEncodingUnknown{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "Messages with encoding \"%1\" and definitions in \"%2\" are not supported.")};
/// encoding
inline constexpr FaultCode MessageEncodingUnknown{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "Messages with encoding \"%1\" are not supported, only their bytes are shown.")};
/// encoding
inline constexpr FaultCode RosMessageOtherwise{
    "recorded", QT_TRANSLATE_NOOP(
                    "recorded", "The encoding of the message is not the one stated in the recording (%1).")};
/// field
inline constexpr FaultCode RosMessageCutOff{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The message ends inside its field \"%1\".")};
/// field
inline constexpr FaultCode RosMessageTooLarge{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The message is too large to be read, at its field \"%1\".")};
/// field
inline constexpr FaultCode RosMessageWideText{
    "recorded", QT_TRANSLATE_NOOP(
                    "recorded", "The message has a field of type wstring (\"%1\"), which is not supported.")};

}  // namespace mapwright::robot::recorded::fault
