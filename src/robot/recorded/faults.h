// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::recorded::fault {

using namespace mapwright::fault;  // what all rooms share

// Recordings as files. Places are bytes from the start of the file.
/// its name; because: why
inline constexpr FaultCode RecordingNotOpened{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The recording %1 cannot be opened")};
inline constexpr FaultCode RecordingIsNone{
    "recorded", QT_TRANSLATE_NOOP("recorded", "It is neither an MCAP file nor a bag of ROS 1.")};
inline constexpr FaultCode RecordingOfOtherVersion{
    "recorded",
    QT_TRANSLATE_NOOP(
        "recorded", "It is of a version that cannot be read here. MCAP 0 and ROS bags of version 2.0 can.")};
inline constexpr FaultCode RecordingEncrypted{
    "recorded", QT_TRANSLATE_NOOP("recorded", "Its messages are encrypted. Decrypt it with rosbag first.")};
inline constexpr FaultCode RecordingOnlyRead{
    "recorded", QT_TRANSLATE_NOOP("recorded", "a recording on this computer is only read here")};
inline constexpr FaultCode RecordingLacksPicture{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "The recording does not hold the picture that this message names.")};
inline constexpr FaultCode RecordingLacksSubmap{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The recording does not hold this submap.")};
/// the time of its last message
inline constexpr FaultCode RecordingNotFinished{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "Its end is missing: it was interrupted after %1, or is still being written.")};
/// likewise, without any message
inline constexpr FaultCode RecordingNotBegun{
    "recorded",
    QT_TRANSLATE_NOOP(
        "recorded",
        "Its end is missing, and so are its messages: it was interrupted, or is still being written.")};
/// from when, until when
inline constexpr FaultCode RecordingLinkAway{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The connection to the robot was away from %1 to %2.")};
/// since when
inline constexpr FaultCode RecordingLinkGone{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The connection to the robot was away from %1 to the end.")};
inline constexpr FaultCode RecordingWithoutIndex{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "It has no index and was looked through. Opening it takes longer.")};
inline constexpr FaultCode RecordingIndexUnusable{
    "recorded", QT_TRANSLATE_NOOP("recorded", "Its index is damaged. It was looked through instead.")};
/// place
inline constexpr FaultCode RecordingCutOff{
    "recorded", QT_TRANSLATE_NOOP("recorded", "It is cut off at byte %1. What comes before is played.")};
/// how many, place of the first
inline constexpr FaultCode RecordingBytesSkipped{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded",
                        "%1 bytes of it are nothing that can be read (from byte %2 on). They are skipped.")};
/// how many, place of the first
inline constexpr FaultCode RecordingChunksCorrupt{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded",
                        "%1 parts of it cannot be unpacked (the first at byte %2). They are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChunksChanged{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded",
                        "%1 parts of it are not what was written (the first at byte %2). They are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChunksTooLarge{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded", "%1 parts of it would take too much memory (the first at byte %2). They are skipped.")};
/// likewise, their compression
inline constexpr FaultCode RecordingChunksPacked{
    "recorded", QT_TRANSLATE_N_NOOP("recorded",
                                    "%1 parts of it are compressed in a way that is not known here: %3 (the "
                                    "first at byte %2). They are skipped.")};
/// how many, place of the first
inline constexpr FaultCode RecordingChunkTimesWrong{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded", "%1 parts of it say wrong times of themselves (the first at byte %2).")};
/// likewise
inline constexpr FaultCode RecordingIndexLies{
    "recorded", QT_TRANSLATE_N_NOOP(
                    "recorded", "Its index names %1 messages that are not there (the first at byte %2).")};
/// likewise
inline constexpr FaultCode RecordingRecordsTooLarge{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded",
                        "%1 descriptions in it are too large (the first at byte %2). They are skipped.")};
/// likewise
inline constexpr FaultCode RecordingRecordsCorrupt{
    "recorded",
    QT_TRANSLATE_N_NOOP("recorded",
                        "%1 descriptions in it cannot be read (the first at byte %2). They are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChannelsUnknown{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded",
        "%1 messages are of topics that it does not describe (the first at byte %2). They are skipped.")};
/// likewise
inline constexpr FaultCode RecordingChannelsChanged{
    "recorded",
    QT_TRANSLATE_N_NOOP(
        "recorded",
        "%1 topics are described twice and differently (the first at byte %2). The first stands.")};
/// its name
inline constexpr FaultCode RecordingFileInItCorrupt{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The file %1 in the recording is damaged.")};
/// place
inline constexpr FaultCode RecordingNotReadByDisk{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The disk cannot read it at byte %1.")};

// Messages in recordings.
/// type
inline constexpr FaultCode RosSchemaTooLong{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The definition of %1 is longer than any message has.")};
/// type, line, what stands there
inline constexpr FaultCode RosSchemaBroken{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The definition of %1 cannot be read (line %2: \"%3\").")};
/// type, the one that is missing
inline constexpr FaultCode RosSchemaTypeUnknown{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The definition of %1 does not say what %2 is.")};
/// type, the one in it
inline constexpr FaultCode RosSchemaHoldsItself{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The definition of %1 is endless: %2 holds itself.")};
/// type
inline constexpr FaultCode RosSchemaMissing{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "The recording does not say what a message of type %1 is made of.")};
/// encoding of the message, of its schema
inline constexpr FaultCode RosEncodingUnknown{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "Messages in the encoding \"%1\" with definitions in \"%2\" cannot be read here.")};
/// encoding
inline constexpr FaultCode RosMessageOtherwise{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The message is not encoded as the recording says (%1).")};
/// field
inline constexpr FaultCode RosMessageCutOff{
    "recorded", QT_TRANSLATE_NOOP("recorded", "The message ends within its field \"%1\".")};
/// field
inline constexpr FaultCode RosMessageTooLarge{
    "recorded",
    QT_TRANSLATE_NOOP("recorded", "The message is larger than can be read, at its field \"%1\".")};
/// field
inline constexpr FaultCode RosMessageWideText{
    "recorded",
    QT_TRANSLATE_NOOP("recorded",
                      "The message has a text of wide characters (\"%1\"), which cannot be read here.")};

}  // namespace mapwright::robot::recorded::fault
