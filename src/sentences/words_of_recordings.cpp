// What is found in recordings as files, and in their messages.
#include <QCoreApplication>

#include "sentences/words_by_code.h"

namespace mapwright::sentences {
namespace {

using map::ReasonCode;

class WordsOfRecordingsText {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

QString ofRecordings(ReasonCode code) {
  switch (code) {
    case ReasonCode::RecordingNotOpened:
      return WordsOfRecordingsText::tr("The recording %1 cannot be opened");
    case ReasonCode::RecordingIsNone:
      return WordsOfRecordingsText::tr("It is neither an MCAP file nor a bag of ROS 1.");
    case ReasonCode::RecordingOfOtherVersion:
      return WordsOfRecordingsText::tr(
          "It is of a version that cannot be read here. MCAP 0 and ROS bags of version 2.0 can.");
    case ReasonCode::RecordingEncrypted:
      return WordsOfRecordingsText::tr("Its messages are encrypted. Decrypt it with rosbag first.");
    case ReasonCode::RecordingOnlyRead:
      return WordsOfRecordingsText::tr("a recording on this computer is only read here");
    case ReasonCode::RecordingLacksPicture:
      return WordsOfRecordingsText::tr("The recording does not hold the picture that this message names.");
    case ReasonCode::RecordingLacksSubmap:
      return WordsOfRecordingsText::tr("The recording does not hold this submap.");
    case ReasonCode::RecordingNotFinished:
      return WordsOfRecordingsText::tr(
          "Its end is missing: it was interrupted after %1, or is still being written.");
    case ReasonCode::RecordingNotBegun:
      return WordsOfRecordingsText::tr(
          "Its end is missing, and so are its messages: it was interrupted, or is still being written.");
    case ReasonCode::RecordingLinkAway:
      return WordsOfRecordingsText::tr("The connection to the robot was away from %1 to %2.");
    case ReasonCode::RecordingLinkGone:
      return WordsOfRecordingsText::tr("The connection to the robot was away from %1 to the end.");
    case ReasonCode::RecordingWithoutIndex:
      return WordsOfRecordingsText::tr("It has no index and was looked through. Opening it takes longer.");
    case ReasonCode::RecordingIndexUnusable:
      return WordsOfRecordingsText::tr("Its index is damaged. It was looked through instead.");
    default:
      return {};
  }
}

QString ofDamage(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::RecordingCutOff:
      return WordsOfRecordingsText::tr("It is cut off at byte %1. What comes before is played.");
    case ReasonCode::RecordingBytesSkipped:
      return WordsOfRecordingsText::tr(
          "%1 bytes of it are nothing that can be read (from byte %2 on). They are skipped.", nullptr, count);
    case ReasonCode::RecordingChunksCorrupt:
      return WordsOfRecordingsText::tr(
          "%1 parts of it cannot be unpacked (the first at byte %2). They are skipped.", nullptr, count);
    case ReasonCode::RecordingChunksChanged:
      return WordsOfRecordingsText::tr(
          "%1 parts of it are not what was written (the first at byte %2). They are skipped.", nullptr,
          count);
    case ReasonCode::RecordingChunksTooLarge:
      return WordsOfRecordingsText::tr(
          "%1 parts of it would take too much memory (the first at byte %2). They are skipped.", nullptr,
          count);
    case ReasonCode::RecordingChunksPacked:
      return WordsOfRecordingsText::tr(
          "%1 parts of it are compressed in a way that is not known here: %3 (the first at byte %2). They "
          "are "
          "skipped.",
          nullptr, count);
    case ReasonCode::RecordingChunkTimesWrong:
      return WordsOfRecordingsText::tr("%1 parts of it say wrong times of themselves (the first at byte %2).",
                                       nullptr, count);
    case ReasonCode::RecordingIndexLies:
      return WordsOfRecordingsText::tr(
          "Its index names %1 messages that are not there (the first at byte %2).", nullptr, count);
    case ReasonCode::RecordingRecordsTooLarge:
      return WordsOfRecordingsText::tr(
          "%1 descriptions in it are too large (the first at byte %2). They are skipped.", nullptr, count);
    case ReasonCode::RecordingRecordsCorrupt:
      return WordsOfRecordingsText::tr(
          "%1 descriptions in it cannot be read (the first at byte %2). They are skipped.", nullptr, count);
    case ReasonCode::RecordingChannelsUnknown:
      return WordsOfRecordingsText::tr(
          "%1 messages are of topics that it does not describe (the first at byte %2). They are skipped.",
          nullptr, count);
    case ReasonCode::RecordingChannelsChanged:
      return WordsOfRecordingsText::tr(
          "%1 topics are described twice and differently (the first at byte %2). The first stands.", nullptr,
          count);
    case ReasonCode::RecordingFileInItCorrupt:
      return WordsOfRecordingsText::tr("The file %1 in the recording is damaged.");
    case ReasonCode::RecordingNotReadByDisk:
      return WordsOfRecordingsText::tr("The disk cannot read it at byte %1.");
    default:
      return {};
  }
}

QString ofMessages(ReasonCode code) {
  switch (code) {
    case ReasonCode::RosSchemaTooLong:
      return WordsOfRecordingsText::tr("The definition of %1 is longer than any message has.");
    case ReasonCode::RosSchemaBroken:
      return WordsOfRecordingsText::tr("The definition of %1 cannot be read (line %2: \"%3\").");
    case ReasonCode::RosSchemaTypeUnknown:
      return WordsOfRecordingsText::tr("The definition of %1 does not say what %2 is.");
    case ReasonCode::RosSchemaHoldsItself:
      return WordsOfRecordingsText::tr("The definition of %1 is endless: %2 holds itself.");
    case ReasonCode::RosSchemaMissing:
      return WordsOfRecordingsText::tr("The recording does not say what a message of type %1 is made of.");
    case ReasonCode::RosEncodingUnknown:
      return WordsOfRecordingsText::tr(
          "Messages in the encoding \"%1\" with definitions in \"%2\" cannot be read here.");
    case ReasonCode::RosMessageOtherwise:
      return WordsOfRecordingsText::tr("The message is not encoded as the recording says (%1).");
    case ReasonCode::RosMessageCutOff:
      return WordsOfRecordingsText::tr("The message ends within its field \"%1\".");
    case ReasonCode::RosMessageTooLarge:
      return WordsOfRecordingsText::tr("The message is larger than can be read, at its field \"%1\".");
    case ReasonCode::RosMessageWideText:
      return WordsOfRecordingsText::tr(
          "The message has a text of wide characters (\"%1\"), which cannot be read here.");
    default:
      return {};
  }
}

}  // namespace

QString wordsOfRecordings(ReasonCode code, int count) {
  QString text = ofRecordings(code);
  if (text.isEmpty()) text = ofDamage(code, count);
  if (text.isEmpty()) text = ofMessages(code);
  return text;
}

}  // namespace mapwright::sentences
