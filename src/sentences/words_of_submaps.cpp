// What is found about submaps, their cells, and in messages.
#include <QCoreApplication>

#include "sentences/words_by_code.h"

namespace mapwright::sentences {
namespace {

using map::ReasonCode;

class WordsOfSubmapsText {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

// One function for each group of codes.

QString ofSubmaps(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::TurnIsZero:
      return WordsOfSubmapsText::tr("its orientation is a zero quaternion");
    case ReasonCode::PoseNotFinite:
      return WordsOfSubmapsText::tr("its pose holds numbers that are not finite");
    case ReasonCode::PoseTooFar:
      return WordsOfSubmapsText::tr("its pose lies more than 1,000 km from the map's origin");
    case ReasonCode::CannotBePlaced:
      return WordsOfSubmapsText::tr("It cannot be placed");
    case ReasonCode::VersionCannotBePlaced:
      return WordsOfSubmapsText::tr("Version %1 cannot be placed");
    case ReasonCode::RowWithoutNumbers:
      return WordsOfSubmapsText::tr(
          "Row %1 has no usable trajectory_id, submap_index or submap_version. Left out.");
    case ReasonCode::ListedTwice:
      return WordsOfSubmapsText::tr("It is listed twice. Counted once.");
    case ReasonCode::ListedTwiceUnlike:
      return WordsOfSubmapsText::tr(
          "It is listed twice, differently. The highest version with a usable pose is used.");
    case ReasonCode::VersionWentBack:
      return WordsOfSubmapsText::tr(
          "Its version went back from %1 to %2. The newer picture stays unless the robot insists.");
    case ReasonCode::OlderVersionListed:
      return WordsOfSubmapsText::tr("The robot lists an older version than the one shown.");
    case ReasonCode::NoListYet:
      return WordsOfSubmapsText::tr(
          "The robot has not sent one yet. It may have no SLAM session, or its firmware may not know the "
          "topic %1. Still listening.");
    case ReasonCode::SlicePoseUnusable:
      return WordsOfSubmapsText::tr(
          "its slice pose is not usable (a number that is not finite, or a zero quaternion)");
    case ReasonCode::OneSlice:
      return WordsOfSubmapsText::tr("slice %1");
    case ReasonCode::VersionBroken:
      return WordsOfSubmapsText::tr("Version %1 is broken");
    case ReasonCode::VersionNotHad:
      return WordsOfSubmapsText::tr("Version %1");
    case ReasonCode::EmptyAnswer:
      return WordsOfSubmapsText::tr("The robot sent an empty answer.");
    case ReasonCode::AnswerIsNoSubmap:
      return WordsOfSubmapsText::tr("The robot's answer (%1 bytes) is cut off or is not a submap.", nullptr,
                                    count);
    case ReasonCode::RobotAnswered:
      return WordsOfSubmapsText::tr("The robot answered %1");
    case ReasonCode::MemoryUsedUp:
      return WordsOfSubmapsText::tr(
          "It is used up, and a file for the others cannot be written: %1. They stay in memory; make room on "
          "the disk.");
    default:
      return {};
  }
}

QString ofCells(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::BytesUnexpected:
      return WordsOfSubmapsText::tr("%1 bytes where %2 (or %3) were expected", nullptr, count);
    case ReasonCode::BytesTooMany:
      return WordsOfSubmapsText::tr("more than %1 bytes where %2 (or %3) were expected");
    case ReasonCode::CellFormatUnknown:
      return WordsOfSubmapsText::tr(
          "cell format %1 is unknown: with one byte a cell only 0, 1 and 2 can be read");
    case ReasonCode::GzipDamaged:
      return WordsOfSubmapsText::tr("the gzip data is damaged or cut off");
    case ReasonCode::ZlibDamaged:
      return WordsOfSubmapsText::tr("the zlib data is damaged or cut off");
    case ReasonCode::TextureEmpty:
      return WordsOfSubmapsText::tr("the texture is announced with %1 cells");
    case ReasonCode::TextureTooLarge:
      return WordsOfSubmapsText::tr("the texture is announced with %1 cells; at most %2 are allowed");
    case ReasonCode::CellSizeNotPositive:
      return WordsOfSubmapsText::tr("the cell size is not a positive number of metres");
    case ReasonCode::CellSizeTooSmall:
      return WordsOfSubmapsText::tr("the cell size is less than 0.1 mm");
    case ReasonCode::CellSizeTooLarge:
      return WordsOfSubmapsText::tr("the cell size is more than 100 m");
    case ReasonCode::PngNotRead:
      return WordsOfSubmapsText::tr("the PNG cannot be read");
    case ReasonCode::PngNotReadBy:
      return WordsOfSubmapsText::tr("the PNG cannot be read (%1)");
    case ReasonCode::PngShort:
      return WordsOfSubmapsText::tr("the PNG is cut off in its header");
    case ReasonCode::PngWithoutMemory:
      return WordsOfSubmapsText::tr("no memory is left to read the PNG");
    case ReasonCode::PngOfOtherSize:
      return WordsOfSubmapsText::tr("the PNG is %1 where %2 was announced");
    case ReasonCode::PngBytesTooFew:
      return WordsOfSubmapsText::tr("the PNG is cut off: %1 bytes cannot hold %2 pixels");
    default:
      return {};
  }
}

QString ofMessages(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::MessageNotJson:
      return WordsOfSubmapsText::tr("A message of %1 bytes is not a JSON object. It was left out.", nullptr,
                                    count);
    case ReasonCode::BinaryTooShort:
      return WordsOfSubmapsText::tr("A binary message of %1 bytes is too short to be read. It was left out.",
                                    nullptr, count);
    case ReasonCode::NotUnpacked:
      return WordsOfSubmapsText::tr(
          "A compressed message could not be unpacked. What was shown before stays.");
    case ReasonCode::BinaryWithoutPoints:
      return WordsOfSubmapsText::tr("A binary message holds no points that can be read.");
    case ReasonCode::BinaryWithoutList:
      return WordsOfSubmapsText::tr("A binary message could not be read. The list before it stays.");
    case ReasonCode::PoseWithoutNumbers:
      return WordsOfSubmapsText::tr("The robot's pose holds no usable numbers.");
    case ReasonCode::MemberIsNoList:
      return WordsOfSubmapsText::tr("Its \"%1\" member is not a list.");
    case ReasonCode::PictureInMessageNotBase64:
      return WordsOfSubmapsText::tr("The picture in its message is not base64, or too large.");
    case ReasonCode::NoPictureNorAddress:
      return WordsOfSubmapsText::tr("It holds neither a picture nor the address of one.");
    case ReasonCode::PictureAddressInvalid:
      return WordsOfSubmapsText::tr("The address of its picture is not one.");
    case ReasonCode::PictureNotHad:
      return WordsOfSubmapsText::tr("Its picture %1 cannot be had");
    case ReasonCode::AnswerIsEmpty:
      return WordsOfSubmapsText::tr("the answer is empty");
    case ReasonCode::CameWithoutPicture:
      return WordsOfSubmapsText::tr("It came without a picture.");
    case ReasonCode::PointsNotBase64:
      return WordsOfSubmapsText::tr("Its points are not base64, or too many.");
    case ReasonCode::PointsWithoutFields:
      return WordsOfSubmapsText::tr("Its fields name no x and y, or a type that is not known.");
    case ReasonCode::NoReadablePoints:
      return WordsOfSubmapsText::tr("It holds no points that can be read.");
    case ReasonCode::PointsWithoutScale:
      return WordsOfSubmapsText::tr("Its points have no usable scale or centre.");
    default:
      return {};
  }
}

}  // namespace

QString wordsOfSubmaps(ReasonCode code, int count) {
  QString text;
  if (text.isEmpty()) text = ofSubmaps(code, count);
  if (text.isEmpty()) text = ofCells(code, count);
  if (text.isEmpty()) text = ofMessages(code, count);
  return text;
}

}  // namespace mapwright::sentences
