// What was found to be wrong, or odd, as a value: a code with its arguments. The words are made of it in one
// place, sentences::wordsOf, which is also where each code's arguments are named (%1 is the first). Numbers
// that are to be grouped ("51,200") are texts.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mapwright::map {

enum class ReasonCode {
  None,
  Said,  // arguments[0] is what somebody else said of it: a robot, the system, a library

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
  // The cells of a slice.
  BytesUnexpected,    // bytes, as many as one byte a cell makes, as two make
  BytesTooMany,       // the most, as many as one byte a cell makes, as two make
  CellFormatUnknown,  // its number
  GzipDamaged,
  ZlibDamaged,
  TextureEmpty,     // size
  TextureTooLarge,  // size, the most cells
  CellSizeNotPositive,
  CellSizeTooSmall,
  CellSizeTooLarge,
  PngNotRead,
  PngNotReadBy,  // the library's words
  PngShort,
  PngWithoutMemory,
  PngOfOtherSize,  // size, as announced
  PngBytesTooFew,  // bytes, size

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
  // The pictures of whole maps. Sizes are texts: "400 x 300".
  PictureEmpty,
  PictureFileNotOpened,  // path; because: why
  NotRead,               // because: why
  PictureKindUnknown,
  PictureWithoutPixels,     // size
  PictureTooLarge,          // size, the most along an edge, in all
  PictureTooLargeForLayer,  // size, the most
  PictureEndsEarly,         // rows that came, size; because: what ends it
  PictureEndsEarlyUnused,   // the same
  PictureDoubtful,          // size; because: what is wrong
  DataEnds,
  DataDamaged,
  PixelChecksumWrong,
  ChecksumWrong,  // near which byte
  ReadingStopped,
  NumberBeyondGreatest,
  NotANumber,
  BmpHeaderShort,
  BmpHeaderUnknown,  // bytes of its header
  BmpWidthNegative,
  BmpBitsUnknown,  // bits a pixel
  BmpCompressed,   // bits a pixel
  BmpColoursUneven,
  BmpPaletteShort,
  PgmHeaderBroken,
  PgmGreatestWrong,  // its greatest gray
  PngHeaderShort,
  PngHeaderMisplaced,
  PngHeaderDamaged,
  PngKindUnknown,  // colour type, bits a sample
  PngMethodUnknown,
  PngEndsBeforePixels,
  PngWithoutPixels,
  PngPaletteDamaged,
  PngTransparencyDamaged,
  PngPartUnknown,
  PngPaletteMissing,
  PngTooShortForPixels,   // size, bytes
  InterlacedTooLarge,     // size, the most bytes
  InterlacedWithoutRoom,  // size
  CacheCopyLost,
  // Making and writing pictures.
  ResolutionNotAboveZero,
  NoSubmapToExport,
  ComposedTooLarge,
  WritingStopped,
  EncoderFailed,          // path
  PictureNotEncoded,      // path, the library's words
  PictureOnlyRead,        // path
  PictureOfOtherSize,     // path
  CellWithoutShade,       // path, the cell
  PictureReadsOtherwise,  // path; because: why
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
  // Files with waypoints.
  NoSuchMap,
  WaypointFileNotRead,  // path; because: why
  FileChanged,          // path
  FileTooLarge,         // the most, with its unit
  FileEmpty,
  FileNotJson,  // the library's words
  NotAFeatureCollection,
  SeveralFeatureLists,
  TwoFeatureLists,
  WaypointsTooMany,  // the most
  WaypointListGone,
  FolderWithoutMaps,  // path
  // Files of any kind.
  FileNotWritten,    // path; because: why
  OutputNotWritten,  // because: why
  IsAFolder,
  IsADisk,
  IsASocket,
  NotARegularFile,
  NoFileInFolder,  // folder, the system's words
  NobodyReadsPipe,
  ReaderTakesNothing,
  // Drafts.
  DraftFolderNotMade,  // folder
  DraftFileNotMade,    // folder
  DraftNotRemoved,     // path
  DraftNotRead,        // path; because: why
  DraftBroken,         // path
  DraftSetAside,       // path, where it is kept

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
  RosRowsHoldMore,   // bytes of a row, bytes of its points
  RosGridEmpty,      // width, height
  RosTurnIsZero,
  RosCellsOutOfRange,    // how many
  RosPatchOutside,       // its width and height, x and y, width and height of the grid
  RosPointsThinned,      // how many came, of which each n-th is shown
  RosPatchInOtherFrame,  // its frame, that of the grid
  RosOneConnection,      // because: what became of the second
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
  TopicAskedInstead,  // the service that was asked for it
  MapServiceFailed,   // service; because: why
  PoseSourceAway,     // host; because: why
  // What a map dispatcher is not asked, or does not tell.
  RegionMeansNothing,
  FileNameMeansNothing,
  ProjectionMeansNothing,
  ProjectionsNotTold,
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
  ResultNothingToSave,
  ResultMapNameTaken,  // name
  ResultUnknown,       // its code
  NotConfirmed,        // seconds
  TagsNotTaken,        // name
  ChangedMeanwhile,    // name
  ListsNotTold,
  OnlyCurrentMapSent,
  OnlyCurrentMapTaken,
  PictureChangedMeanwhile,  // name
  CellBetweenKinds,         // the cell, of 100
  PictureShownOtherwise,    // how many cells
  MessageNotUnderstood,
  WaypointTurnIsZero,    // name
  WaypointInOtherFrame,  // name, frame, the map's frame

  // The robot itself.
  AnswersNotKept,  // because: why
  MapsNotKept,     // folder; because: why
  DiskMayBeFull,
  DoesNotSayWhatItIs,  // because: why
  ItAnswered,          // its words
  EmergencyStop,
  PositionLost,
  WheelsReleased,
  ManualControl,
  PositionUncertain,
  WheelsSlipping,
  AlertWithoutText,
  // Bags.
  BagWithoutTimes,
  BagWithoutMessages,
  BagNotAsked,         // what is wrong with the range that was asked for
  BagFileNotWritten,   // path, the system's words
  BagFileOfOtherSize,  // bytes that came, bytes as announced
  // Recordings as files. Places are bytes from the start of the file.
  RecordingNotOpened,  // its name; because: why
  RecordingIsNone,
  RecordingOfOtherVersion,
  RecordingEncrypted,
  RecordingOnlyRead,
  RecordingLacksPicture,
  RecordingLacksSubmap,
  RecordingNotFinished,  // the time of its last message
  RecordingNotBegun,     // likewise, without any message
  RecordingLinkAway,     // from when, until when
  RecordingLinkGone,     // since when
  RecordingWithoutIndex,
  RecordingIndexUnusable,
  RecordingCutOff,           // place
  RecordingBytesSkipped,     // how many, place of the first
  RecordingChunksCorrupt,    // how many, place of the first
  RecordingChunksChanged,    // likewise
  RecordingChunksTooLarge,   // likewise
  RecordingChunksPacked,     // likewise, their compression
  RecordingChunkTimesWrong,  // how many, place of the first
  RecordingIndexLies,        // likewise
  RecordingRecordsTooLarge,  // likewise
  RecordingRecordsCorrupt,   // likewise
  RecordingChannelsUnknown,  // likewise
  RecordingChannelsChanged,  // likewise
  RecordingFileInItCorrupt,  // its name
  RecordingNotReadByDisk,    // place
  // Messages in recordings.
  RosSchemaTooLong,      // type
  RosSchemaBroken,       // type, line, what stands there
  RosSchemaTypeUnknown,  // type, the one that is missing
  RosSchemaHoldsItself,  // type, the one in it
  RosSchemaMissing,      // type
  RosEncodingUnknown,    // encoding of the message, of its schema
  RosMessageOtherwise,   // encoding
  RosMessageCutOff,      // field
  RosMessageTooLarge,    // field
  RosMessageWideText,    // field

  // What goes over the network. Hosts come with their ports.
  RequestCancelled,
  NoWebAddress,
  ConnectionRefused,  // host
  HostUnknown,        // name
  ConnectionClosed,
  ConnectionClosedSaying,  // the robot's words
  ConnectionBroke,         // host
  ConnectionNotSecure,     // host, the system's words
  HostSilent,              // host
  HostNotReached,          // host, the system's words
  NoAnswerWithin,          // how long, with its unit
  LeadsToAnotherServer,    // host
  LeadsToAnotherAddress,
  LeadsInCircles,
  AnswerTooLong,             // the most bytes
  AnswerBrokeOff,            // bytes
  AnswerBrokeOffEarly,       // bytes, of how many
  AnsweredWithStatus,        // HTTP status
  AnsweredWithStatusSaying,  // HTTP status, the robot's words
  NoAddressToConnectTo,
  NoWebSocketThere,  // host
  ClosedBeforeOpen,
  BrokeBeforeOpen,       // host
  ConnectionForbidden,   // HTTP status
  ConnectionRejected,    // HTTP status
  MessageTooLong,        // the most bytes
  NoAutoxingRobotThere,  // host; because: how it answers
  NoRosbridgeThere,      // likewise
  NoMapManagerThere,     // host
  NoAgibotRobotThere,    // because: how it answers
  FolderNotMade,         // path
  FileNotRemoved,        // path, the system's words
  FileNotKept,           // path, the system's words
  // Certificates. Days are texts.
  CertificateUntrusted,  // host, SHA-256; because: why
  CertificateChanged,    // host, SHA-256 of the trusted one, of the present one
  SelfSigned,
  AuthorityUnnamed,
  AuthorityUnknown,        // its name
  CertificateExpired,      // day
  AuthorityExpired,        // day
  CertificateNotYetValid,  // day
  CertificateOfOtherName,  // name
  CertificateWithoutName,
  CertificateWithdrawn,
  CertificateIsAnother,
  AuthoritiesNotRead,   // path, the system's words
  NoAuthoritiesInFile,  // path
};
inline constexpr ReasonCode kLastReasonCode = ReasonCode::NoAuthoritiesInFile;

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
  LeftAsItIs,
  NothingWritten,
};
inline constexpr Consequence kLastConsequence = Consequence::NothingWritten;

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

/// The words of somebody else: of a robot, the system, a library.
inline Reason said(std::string words) { return {ReasonCode::Said, {std::move(words)}}; }

/// What equal reasons share when their numbers differ: names what is one row in a list of problems.
std::string patternOf(const Reason& reason);
/// A text with every number replaced: what "Row 12 is 3.5 m off" and "Row 7 is 1,200 m off" share.
std::string withoutNumbers(const std::string& text);

}  // namespace mapwright::map
