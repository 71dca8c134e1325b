// What is found in files, and about what keeps them.
#include <QCoreApplication>

#include "sentences/words_by_code.h"

namespace mapwright::sentences {
namespace {

using map::ReasonCode;

class WordsOfFilesText {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

// One function for each group of codes.

QString ofFiles(ReasonCode code) {
  switch (code) {
    case ReasonCode::NoSuchFile:
      return WordsOfFilesText::tr("There is no file %1.");
    case ReasonCode::NotAFile:
      return WordsOfFilesText::tr("%1 is not a file.");
    case ReasonCode::FileNotReadable:
      return WordsOfFilesText::tr("The file %1 may not be read by you.");
    case ReasonCode::FileNotOpened:
      return WordsOfFilesText::tr("%1 cannot be opened");
    case ReasonCode::PictureNotReadable:
      return WordsOfFilesText::tr("Its picture cannot be read.");
    case ReasonCode::PictureOutsideFolder:
      return WordsOfFilesText::tr("Its picture lies outside of its folder: %1.");
    case ReasonCode::ResolutionAssumed:
      return WordsOfFilesText::tr(
          "A picture alone does not say how large its cells are. 0.05 m is assumed; give ?resolution=0.05 "
          "after the path to say it.");
    case ReasonCode::YamlBesideUnused:
      return WordsOfFilesText::tr(
          "%1 beside it does not name it as its image, or cannot be read as a map.yaml.");
    case ReasonCode::SeveralYamls:
      return WordsOfFilesText::tr(
          "More than one map.yaml names this picture, so none is taken: %1. Open the right one.");
    case ReasonCode::SeveralYamlsAndMore:
      return WordsOfFilesText::tr(
          "More than one map.yaml names this picture, so none is taken: %1 and %2 more. Open the right one.");
    case ReasonCode::YamlTooLong:
      return WordsOfFilesText::tr("It is too long to be a map.yaml.");
    case ReasonCode::YamlIsNone:
      return WordsOfFilesText::tr("It is not a map.yaml: it names no image, resolution and origin.");
    case ReasonCode::YamlBroken:
      return WordsOfFilesText::tr("It is not YAML (line %1).");
    case ReasonCode::YamlWithoutImage:
      return WordsOfFilesText::tr("It names no image.");
    case ReasonCode::YamlWithoutResolution:
      return WordsOfFilesText::tr(
          "It has no resolution, so the map cannot be placed. Add for example: resolution: 0.05");
    case ReasonCode::YamlWithoutOrigin:
      return WordsOfFilesText::tr(
          "It has no origin, so the map cannot be placed. Add for example: origin: [0.0, 0.0, 0.0]");
    case ReasonCode::OriginNoList:
      return WordsOfFilesText::tr("Its origin is not a list of x, y and yaw.");
    case ReasonCode::OriginHoldsNoNumber:
      return WordsOfFilesText::tr("Its origin holds something that is not a number.");
    case ReasonCode::OriginTurnNoNumber:
      return WordsOfFilesText::tr("The yaw of its origin is not a number. It is taken as 0.");
    case ReasonCode::NegateUnknown:
      return WordsOfFilesText::tr("Its negate is neither 0 nor 1.");
    case ReasonCode::ModeUnknown:
      return WordsOfFilesText::tr("Its mode is not known. It must be trinary, scale or raw.");
    case ReasonCode::ThresholdMissing:
      return WordsOfFilesText::tr("It has no %1. %2 is assumed.");
    case ReasonCode::ThresholdNoNumber:
      return WordsOfFilesText::tr("Its %1 is not a number from 0 to 1.");
    case ReasonCode::ThresholdsCrossed:
      return WordsOfFilesText::tr(
          "Its free_thresh is not below its occupied_thresh, so no cell can be unknown.");
    case ReasonCode::WaypointIdTwice:
      return WordsOfFilesText::tr("Two waypoints have the id %1.");
    case ReasonCode::WaypointTurnNoNumber:
      return WordsOfFilesText::tr(
          "Waypoint %1 has a yaw_rad that is no number. It is shown without a heading.");
    default:
      return {};
  }
}

QString ofWaypointFiles(ReasonCode code) {
  switch (code) {
    case ReasonCode::NoSuchMap:
      return WordsOfFilesText::tr("There is no such map.");
    case ReasonCode::WaypointFileNotRead:
      return WordsOfFilesText::tr("%1 cannot be read");
    case ReasonCode::FileChanged:
      return WordsOfFilesText::tr("%1 has changed on disk meanwhile.");
    case ReasonCode::FileTooLarge:
      return WordsOfFilesText::tr("it is larger than %1");
    case ReasonCode::FileEmpty:
      return WordsOfFilesText::tr("it is empty");
    case ReasonCode::FileNotJson:
      return WordsOfFilesText::tr("it is no JSON (%1)");
    case ReasonCode::NotAFeatureCollection:
      return WordsOfFilesText::tr("it is no GeoJSON FeatureCollection");
    case ReasonCode::SeveralFeatureLists:
      return WordsOfFilesText::tr("it has more than one list of features");
    case ReasonCode::TwoFeatureLists:
      return WordsOfFilesText::tr("it has two lists of features");
    case ReasonCode::FolderWithoutMaps:
      return WordsOfFilesText::tr("There are no maps (map.yaml, PNG, PGM, BMP) in %1.");
    case ReasonCode::WaypointListGone:
      return WordsOfFilesText::tr(
          "The list of waypoints is gone from where it was kept. They are still here: saving writes them "
          "again.");
    case ReasonCode::WaypointsTooMany:
      return WordsOfFilesText::tr("it has more than %1 waypoints");
    default:
      return {};
  }
}

QString ofDisks(ReasonCode code) {
  switch (code) {
    case ReasonCode::FileNotWritten:
      return WordsOfFilesText::tr("%1 cannot be written");
    case ReasonCode::OutputNotWritten:
      return WordsOfFilesText::tr("The standard output cannot be written");
    case ReasonCode::IsAFolder:
      return WordsOfFilesText::tr("it is a folder");
    case ReasonCode::IsADisk:
      return WordsOfFilesText::tr("it is a disk, not a file");
    case ReasonCode::IsASocket:
      return WordsOfFilesText::tr("it is a socket, not a file");
    case ReasonCode::NotARegularFile:
      return WordsOfFilesText::tr("it is not a regular file");
    case ReasonCode::NoFileInFolder:
      return WordsOfFilesText::tr("no file can be made in %1 (%2)");
    case ReasonCode::NobodyReadsPipe:
      return WordsOfFilesText::tr("nobody reads from this pipe");
    case ReasonCode::ReaderTakesNothing:
      return WordsOfFilesText::tr("whoever reads from it takes nothing");
    case ReasonCode::DraftFolderNotMade:
      return WordsOfFilesText::tr("No draft can be kept: the folder %1 cannot be made.");
    case ReasonCode::DraftFileNotMade:
      return WordsOfFilesText::tr("No draft can be kept: no file can be made in %1. Is the disk full?");
    case ReasonCode::DraftNotRemoved:
      return WordsOfFilesText::tr("The draft %1 cannot be removed.");
    case ReasonCode::DraftNotRead:
      return WordsOfFilesText::tr("The draft %1 cannot be read");
    case ReasonCode::DraftBroken:
      return WordsOfFilesText::tr("The draft %1 cannot be understood.");
    case ReasonCode::DraftSetAside:
      return WordsOfFilesText::tr("The draft %1 cannot be understood. It is kept as %2.");
    case ReasonCode::FolderNotMade:
      return WordsOfFilesText::tr("the folder %1 cannot be made");
    case ReasonCode::FileNotRemoved:
      return WordsOfFilesText::tr("%1 cannot be removed: %2");
    case ReasonCode::FileNotKept:
      return WordsOfFilesText::tr("%1 cannot be written: %2");
    default:
      return {};
  }
}

}  // namespace

QString wordsOfFiles(ReasonCode code, int /*count*/) {
  QString text;
  if (text.isEmpty()) text = ofFiles(code);
  if (text.isEmpty()) text = ofWaypointFiles(code);
  if (text.isEmpty()) text = ofDisks(code);
  return text;
}

}  // namespace mapwright::sentences
