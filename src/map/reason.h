// What was found to be wrong, or odd, as a value: a code with its arguments. The words are made of it in one
// place, sentences::wordsOf, which is also where each code's arguments are named (%1 is the first).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mapwright::map {

enum class ReasonCode {
  None,
  Said,  // arguments[0] is what somebody else said of it: a robot, the system, a reader of files

  // The place of a submap.
  TurnIsZero,
  PoseNotFinite,
  PoseTooFar,
  CannotBePlaced,         // because: why
  VersionCannotBePlaced,  // version; because: why
  // The list of submaps.
  RowWithoutNumbers,  // position in the list
  ListedTwice,
  ListedTwiceUnlike,
  VersionWentBack,  // from, to
  OlderVersionListed,
  NoListYet,  // topic
  // The pictures of submaps.
  SlicePoseUnusable,
  OneSlice,       // slice; because: what is wrong with it
  Slices,         // because: what is wrong with each
  VersionBroken,  // version; because: what is wrong with its slices
  VersionNotHad,  // version; because: why
  EmptyAnswer,
  AnswerIsNoSubmap,  // bytes
  RobotAnswered,     // its code; because: its words
  MemoryUsedUp,      // why no file can be written

  // Where a grid lies.
  ResolutionNoNumber,
  ResolutionNotPositive,  // metres
  ResolutionOutOfBounds,  // metres
  OriginNoNumber,
  OriginTooFar,
  // Whole maps.
  SizesDiffer,    // width and height as said, width and height of the picture
  SizesDisagree,  // width and height of the picture, width and height as the robot says
  TurnNoNumber,
  CacheCopyDamaged,
  AnotherMapCame,     // its key
  CapabilityLacking,  // robot::Capability, robot::Absence::Reason, then its arguments
  FileNotHad,         // its name; because: why
  RowsWithoutId,      // how many
  AnswerIsNoList,
  AnswerIsNoMap,
  AnswerIsNoPicture,
  NoPictureSent,
  // Whole maps by remote calls.
  AnswerIsNoJson,  // whose robot it should be
  AnswerHoldsNoData,
  MapsAreNoList,
  PointsAreNoList,
  ScaleNotPositive,
  WrongMapSent,  // its id
  NoPictureOfItSent,
  PictureNotBase64,
  HeightNotSaid,
  PointOff,        // id, name, pixels
  PointsUnplaced,  // how many
  MorePointsOff,   // how many

  // Map files.
  NoSuchFile,            // path
  NotAFile,              // path
  FileNotReadable,       // path
  FileNotOpened,         // path; because: why
  PictureNotReadable,    // because: why
  PictureOutsideFolder,  // path
  ResolutionAssumed,
  YamlBesideUnused,     // file name
  SeveralYamls,         // file names
  SeveralYamlsAndMore,  // file names, how many more
  YamlTooLong,
  YamlIsNone,
  YamlBroken,  // line
  YamlWithoutImage,
  YamlWithoutResolution,
  YamlWithoutOrigin,
  OriginNoList,
  OriginHoldsNoNumber,
  OriginTurnNoNumber,
  NegateUnknown,
  ModeUnknown,
  ThresholdMissing,   // member, the value taken
  ThresholdNoNumber,  // member
  ThresholdsCrossed,
  WaypointIdTwice,       // id
  WaypointTurnNoNumber,  // id

  // Live messages.
  MessageNotJson,  // bytes
  BinaryTooShort,  // bytes
  NotUnpacked,
  BinaryWithoutPoints,
  BinaryWithoutList,
  PoseWithoutNumbers,
  MemberIsNoList,  // member
  PictureInMessageNotBase64,
  NoPictureNorAddress,
  PictureAddressInvalid,
  PictureNotHad,  // path; because: why
  AnswerIsEmpty,
  CameWithoutPicture,
  PointsNotBase64,
  PointsWithoutFields,
  NoReadablePoints,
  PointsWithoutScale,

  // Messages of ROS.
  RosFieldMissing,   // field
  RosFieldWrong,     // field, its value
  RosLengthDiffers,  // field, how many it holds, how many are needed
  RosGridEmpty,      // width, height
  RosTurnIsZero,
  RosCellsOutOfRange,  // how many
  RosPatchOutside,     // its width and height, x and y, width and height of the grid
  RosPointsThinned,    // how many came, of which each n-th is shown
  // Where the frames of ROS lie to each other.
  RosFrameUnknown,     // frame
  RosFramesApart,      // frame, the other one
  RosTransformTooOld,  // child, parent
  RosTransformTooNew,  // child, parent
  RosTransformLoop,    // child, parent
  // Topics of ROS that are asked for and silent.
  TopicSilent,  // because: what is known of why
  TopicNotListed,
  TopicNobodySends,
  TopicsNotTold,
  TopicListedOnly,
  // A manager of maps (KABAM).
  NoAnswerInTime,
  LinkBrokeOff,
  NotConnected,
  AnswerWithoutResult,
  ResultMapUnknown,
  ResultNameTaken,  // name
  ResultWaypointUnknown,
  ResultUndefined,
  ResultInvalid,
  ResultInvalidLoad,
  ResultAlreadyLoaded,
  ResultUnknown,     // its code
  NotConfirmed,      // seconds
  TagsNotTaken,      // name
  ChangedMeanwhile,  // name
  ListsNotTold,
  OnlyCurrentMapSent,
  MessageNotUnderstood,
  WaypointTurnIsZero,    // name
  WaypointInOtherFrame,  // name, frame, the map's frame

  // The robot itself.
  AnswersNotKept,  // because: why
  MapsNotKept,     // folder; because: why
  DiskMayBeFull,
  DoesNotSayWhatItIs,  // why
  ItAnswered,          // its words
  EmergencyStop,
  PositionLost,
  WheelsReleased,
  ManualControl,
  PositionUncertain,
  WheelsSlipping,
  AlertWithoutText,
};
inline constexpr ReasonCode kLastReasonCode = ReasonCode::AlertWithoutText;

/// What follows from it.
enum class Consequence {
  None,
  ShownWithoutIt,
  ShownWithoutItUntilTheNext,  // and asked for again at the next version
  StaysWhereItWas,
  AskedAgain,
  AskedAgainAtTheNext,  // version
  PictureBeforeStays,
  PictureBeforeItStays,
  AlertsBeforeStay,
  TheyWereLeftOut,
  ItsPointsWereLeftOut,
  AskedAgainEachTime,
  ReadAnewEachTime,
};
inline constexpr Consequence kLastConsequence = Consequence::ReadAnewEachTime;

/// Texts are untrusted plain text.
using Argument = std::variant<std::int64_t, double, std::string>;

struct Reason {
  ReasonCode code = ReasonCode::None;
  std::vector<Argument> arguments;
  std::vector<Reason> because;  // what lies behind it
  Consequence then = Consequence::None;

  Reason() = default;
  Reason(ReasonCode its_code, std::vector<Argument> its_arguments = {}, std::vector<Reason> behind_it = {},
         Consequence follows = Consequence::None)
      : code(its_code), arguments(std::move(its_arguments)), because(std::move(behind_it)), then(follows) {}
  bool any() const { return code != ReasonCode::None; }
  Reason followedBy(Consequence follows) && {
    then = follows;
    return std::move(*this);
  }
  bool operator==(const Reason&) const = default;
};

/// The words of somebody else: of a robot, the system, or a reader of files.
inline Reason said(std::string words) { return {ReasonCode::Said, {std::move(words)}}; }

/// What equal reasons share when their numbers differ: names what is one row in a list of problems.
std::string patternOf(const Reason& reason);
/// A text with every number replaced: what "Row 12 is 3.5 m off" and "Row 7 is 1,200 m off" share.
std::string withoutNumbers(const std::string& text);

}  // namespace mapwright::map
