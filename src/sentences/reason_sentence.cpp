#include "sentences/reason_sentence.h"

#include <QCoreApplication>
#include <QStringList>

#include "sentences/absence_sentence.h"
#include "sentences/plural.h"
#include "sentences/ros_reasons.h"
#include "words/sentences.h"

namespace mapwright::sentences {
namespace {

using map::Consequence;
using map::Reason;
using map::ReasonCode;

class Words {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

// One function for each group of codes; a null text = none of the group.

QString ofSubmaps(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::TurnIsZero:
      return Words::tr("its orientation is a zero quaternion");
    case ReasonCode::PoseNotFinite:
      return Words::tr("its pose holds numbers that are not finite");
    case ReasonCode::PoseTooFar:
      return Words::tr("its pose lies more than 1,000 km from the map's origin");
    case ReasonCode::CannotBePlaced:
      return Words::tr("It cannot be placed");
    case ReasonCode::VersionCannotBePlaced:
      return Words::tr("Version %1 cannot be placed");
    case ReasonCode::RowWithoutNumbers:
      return Words::tr("Row %1 has no usable trajectory_id, submap_index or submap_version. Left out.");
    case ReasonCode::ListedTwice:
      return Words::tr("It is listed twice. Counted once.");
    case ReasonCode::ListedTwiceUnlike:
      return Words::tr("It is listed twice, differently. The highest version with a usable pose is used.");
    case ReasonCode::VersionWentBack:
      return Words::tr(
          "Its version went back from %1 to %2. The newer picture stays unless the robot insists.");
    case ReasonCode::OlderVersionListed:
      return Words::tr("The robot lists an older version than the one shown.");
    case ReasonCode::NoListYet:
      return Words::tr(
          "The robot has not sent one yet. It may have no SLAM session, or its firmware may not know the "
          "topic %1. Still listening.");
    case ReasonCode::SlicePoseUnusable:
      return Words::tr("its slice pose is not usable (a number that is not finite, or a zero quaternion)");
    case ReasonCode::OneSlice:
      return Words::tr("slice %1");
    case ReasonCode::VersionBroken:
      return Words::tr("Version %1 is broken");
    case ReasonCode::VersionNotHad:
      return Words::tr("Version %1");
    case ReasonCode::EmptyAnswer:
      return Words::tr("The robot sent an empty answer.");
    case ReasonCode::AnswerIsNoSubmap:
      return Words::tr("The robot's answer (%1 bytes) is cut off or is not a submap.", nullptr, count);
    case ReasonCode::RobotAnswered:
      return Words::tr("The robot answered %1");
    case ReasonCode::MemoryUsedUp:
      return Words::tr(
          "It is used up, and a file for the others cannot be written: %1. They stay in memory; make room on "
          "the disk.");
    default:
      return {};
  }
}

QString ofPlaces(ReasonCode code) {
  switch (code) {
    case ReasonCode::ResolutionNoNumber:
      return Words::tr("Its resolution is not a number, so it cannot be placed.");
    case ReasonCode::ResolutionNotPositive:
      return Words::tr("Its resolution is %1, which is no size of a cell.");
    case ReasonCode::ResolutionOutOfBounds:
      return Words::tr("Its resolution of %1 m is out of bounds: between 0.1 mm and 1 km can be shown.");
    case ReasonCode::OriginNoNumber:
      return Words::tr("Its origin is missing or not a number, so it cannot be placed.");
    case ReasonCode::OriginTooFar:
      return Words::tr("Its origin lies farther than 10,000 km away, so it cannot be placed.");
    default:
      return {};
  }
}

QString ofMaps(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::SizesDiffer:
      return Words::tr(
          "It is said to have %1 x %2 cells, but its picture has %3 x %4. It is shown as the picture has "
          "it.");
    case ReasonCode::SizesDisagree:
      return Words::tr(
          "Its picture has %1 x %2 cells, but the robot says %3 x %4. Placed by the picture's own size.");
    case ReasonCode::TurnNoNumber:
      return Words::tr("The turn of its origin is not a number. It is shown unturned.");
    case ReasonCode::CacheCopyDamaged:
      return Words::tr("Its copy in the cache was damaged. The map was read again from its picture.");
    case ReasonCode::AnotherMapCame:
      return Words::tr("The robot answered with another map, %1. It is not shown.");
    case ReasonCode::FileNotHad:
      return Words::tr("Shown without %1");
    case ReasonCode::RowsWithoutId:
      return Words::tr("%1 rows without an id were left out.", nullptr, count);
    case ReasonCode::AnswerIsNoList:
      return Words::tr("its answer is not a list");
    case ReasonCode::AnswerIsNoMap:
      return Words::tr("the robot's answer is not a map");
    case ReasonCode::AnswerIsNoPicture:
      return Words::tr("The robot's answer is no map picture, or is cut off.");
    case ReasonCode::NoPictureSent:
      return Words::tr("The robot sent no picture.");
    case ReasonCode::AnswerIsNoJson:
      return Words::tr("The robot's answer is not JSON, so it may not be an %1 robot.");
    case ReasonCode::AnswerHoldsNoData:
      return Words::tr("its answer holds no data");
    case ReasonCode::MapsAreNoList:
      return Words::tr("The robot's list of maps is not a list.");
    case ReasonCode::PointsAreNoList:
      return Words::tr("The robot's list of points is not a list.");
    case ReasonCode::ScaleNotPositive:
      return Words::tr("Its resolution is missing or not above 0 pixels per metre, so it cannot be placed.");
    case ReasonCode::WrongMapSent:
      return Words::tr("The robot sent the map %1 instead of it.");
    case ReasonCode::NoPictureOfItSent:
      return Words::tr("The robot sent no picture of it.");
    case ReasonCode::PictureNotBase64:
      return Words::tr("Its picture is not base64, or larger than 256 MB.");
    case ReasonCode::HeightNotSaid:
      return Words::tr("Its picture is not a PNG, and the robot does not say how high it is.");
    case ReasonCode::PointOff:
      return Words::tr("Point %1 (%2): its pixels lie %3 px from its metres. Shown where its metres say.");
    case ReasonCode::PointsUnplaced:
      return Words::tr("%1 points without a place were left out.", nullptr, count);
    case ReasonCode::MorePointsOff:
      return Words::tr("%1 points more disagree with their pixels.", nullptr, count);
    default:
      return {};
  }
}

QString ofFiles(ReasonCode code) {
  switch (code) {
    case ReasonCode::NoSuchFile:
      return Words::tr("There is no file %1.");
    case ReasonCode::NotAFile:
      return Words::tr("%1 is not a file.");
    case ReasonCode::FileNotReadable:
      return Words::tr("The file %1 may not be read by you.");
    case ReasonCode::FileNotOpened:
      return Words::tr("%1 cannot be opened");
    case ReasonCode::PictureNotReadable:
      return Words::tr("Its picture cannot be read.");
    case ReasonCode::PictureOutsideFolder:
      return Words::tr("Its picture lies outside of its folder: %1.");
    case ReasonCode::ResolutionAssumed:
      return Words::tr(
          "A picture alone does not say how large its cells are. 0.05 m is assumed; give ?resolution=0.05 "
          "after the path to say it.");
    case ReasonCode::YamlBesideUnused:
      return Words::tr("%1 beside it does not name it as its image, or cannot be read as a map.yaml.");
    case ReasonCode::SeveralYamls:
      return Words::tr(
          "More than one map.yaml names this picture, so none is taken: %1. Open the right one.");
    case ReasonCode::SeveralYamlsAndMore:
      return Words::tr(
          "More than one map.yaml names this picture, so none is taken: %1 and %2 more. Open the right one.");
    case ReasonCode::YamlTooLong:
      return Words::tr("It is too long to be a map.yaml.");
    case ReasonCode::YamlIsNone:
      return Words::tr("It is not a map.yaml: it names no image, resolution and origin.");
    case ReasonCode::YamlBroken:
      return Words::tr("It is not YAML (line %1).");
    case ReasonCode::YamlWithoutImage:
      return Words::tr("It names no image.");
    case ReasonCode::YamlWithoutResolution:
      return Words::tr(
          "It has no resolution, so the map cannot be placed. Add for example: resolution: 0.05");
    case ReasonCode::YamlWithoutOrigin:
      return Words::tr(
          "It has no origin, so the map cannot be placed. Add for example: origin: [0.0, 0.0, 0.0]");
    case ReasonCode::OriginNoList:
      return Words::tr("Its origin is not a list of x, y and yaw.");
    case ReasonCode::OriginHoldsNoNumber:
      return Words::tr("Its origin holds something that is not a number.");
    case ReasonCode::OriginTurnNoNumber:
      return Words::tr("The yaw of its origin is not a number. It is taken as 0.");
    case ReasonCode::NegateUnknown:
      return Words::tr("Its negate is neither 0 nor 1.");
    case ReasonCode::ModeUnknown:
      return Words::tr("Its mode is not known. It must be trinary, scale or raw.");
    case ReasonCode::ThresholdMissing:
      return Words::tr("It has no %1. %2 is assumed.");
    case ReasonCode::ThresholdNoNumber:
      return Words::tr("Its %1 is not a number from 0 to 1.");
    case ReasonCode::ThresholdsCrossed:
      return Words::tr("Its free_thresh is not below its occupied_thresh, so no cell can be unknown.");
    case ReasonCode::WaypointIdTwice:
      return Words::tr("Two waypoints have the id %1.");
    case ReasonCode::WaypointTurnNoNumber:
      return Words::tr("Waypoint %1 has a yaw_rad that is no number. It is shown without a heading.");
    default:
      return {};
  }
}

QString ofMessages(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::MessageNotJson:
      return Words::tr("A message of %1 bytes is not a JSON object. It was left out.", nullptr, count);
    case ReasonCode::BinaryTooShort:
      return Words::tr("A binary message of %1 bytes is too short to be read. It was left out.", nullptr,
                       count);
    case ReasonCode::NotUnpacked:
      return Words::tr("A compressed message could not be unpacked. What was shown before stays.");
    case ReasonCode::BinaryWithoutPoints:
      return Words::tr("A binary message holds no points that can be read.");
    case ReasonCode::BinaryWithoutList:
      return Words::tr("A binary message could not be read. The list before it stays.");
    case ReasonCode::PoseWithoutNumbers:
      return Words::tr("The robot's pose holds no usable numbers.");
    case ReasonCode::MemberIsNoList:
      return Words::tr("Its \"%1\" member is not a list.");
    case ReasonCode::PictureInMessageNotBase64:
      return Words::tr("The picture in its message is not base64, or too large.");
    case ReasonCode::NoPictureNorAddress:
      return Words::tr("It holds neither a picture nor the address of one.");
    case ReasonCode::PictureAddressInvalid:
      return Words::tr("The address of its picture is not one.");
    case ReasonCode::PictureNotHad:
      return Words::tr("Its picture %1 cannot be had");
    case ReasonCode::AnswerIsEmpty:
      return Words::tr("the answer is empty");
    case ReasonCode::CameWithoutPicture:
      return Words::tr("It came without a picture.");
    case ReasonCode::PointsNotBase64:
      return Words::tr("Its points are not base64, or too many.");
    case ReasonCode::PointsWithoutFields:
      return Words::tr("Its fields name no x and y, or a type that is not known.");
    case ReasonCode::NoReadablePoints:
      return Words::tr("It holds no points that can be read.");
    case ReasonCode::PointsWithoutScale:
      return Words::tr("Its points have no usable scale or centre.");
    default:
      return {};
  }
}

QString ofTheRobot(ReasonCode code) {
  switch (code) {
    case ReasonCode::AnswersNotKept:
      return Words::tr("What the robot answers cannot be kept on disk");
    case ReasonCode::MapsNotKept:
      return Words::tr("What was made of large maps cannot be kept in %1");
    case ReasonCode::DiskMayBeFull:
      return Words::tr("the disk may be full");
    case ReasonCode::DoesNotSayWhatItIs:
      return Words::tr("It does not say what it is: %1");
    case ReasonCode::ItAnswered:
      return Words::tr("It answered: %1");
    case ReasonCode::EmergencyStop:
      return Words::tr("It is pressed: the robot does not drive until it is released.");
    case ReasonCode::PositionLost:
      return Words::tr("Where the robot stands on the map may be wrong.");
    case ReasonCode::WheelsReleased:
      return Words::tr("The robot can be pushed, and rolls on a slope.");
    case ReasonCode::ManualControl:
      return Words::tr("The robot does not drive by itself.");
    case ReasonCode::PositionUncertain:
      return Words::tr("The robot may stand beside its place on the map.");
    case ReasonCode::WheelsSlipping:
      return Words::tr("The robot may not be where its wheels say.");
    case ReasonCode::AlertWithoutText:
      return Words::tr("The robot gives no text with it.");
    default:
      return {};
  }
}

QString textOf(const map::Argument& argument) {
  if (const auto* const whole = std::get_if<std::int64_t>(&argument)) return QString::number(*whole);
  if (const auto* const number = std::get_if<double>(&argument)) return QString::number(*number, 'g', 6);
  return QString::fromStdString(std::get<std::string>(argument));
}

/// What the sentence counts, where it counts anything.
int countIn(const Reason& reason) {
  const auto* const count =
      reason.arguments.empty() ? nullptr : std::get_if<std::int64_t>(&reason.arguments[0]);
  return count ? formOf(*count) : 2;
}

/// Arguments are put in at once: what they hold is no template.
QString filled(const QString& text, const std::vector<map::Argument>& arguments) {
  QString full;
  full.reserve(text.size());
  for (qsizetype i = 0; i < text.size(); ++i) {
    const int place = text[i] == QLatin1Char('%') && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
    if (place < 1) {
      full += text[i];
      continue;
    }
    ++i;
    if (std::size_t(place) <= arguments.size()) full += textOf(arguments[std::size_t(place) - 1]);
  }
  return full;
}

QString lackWords(const Reason& reason) {
  robot::Absence absence;
  const auto number = [&](std::size_t at) {
    const auto* const given =
        at < reason.arguments.size() ? std::get_if<std::int64_t>(&reason.arguments[at]) : nullptr;
    return given ? int(*given) : 0;
  };
  absence.reason = robot::Absence::Reason(number(1));
  for (std::size_t i = 2; i < reason.arguments.size(); ++i)
    absence.arguments.push_back(textOf(reason.arguments[i]).toStdString());
  return whyAbsent(robot::Capability(number(0)), absence);
}

std::string causesOf(const Reason& reason) {
  QStringList causes;
  for (const Reason& cause : reason.because) causes << wordsOf(cause);
  return causes.join(QStringLiteral("; ")).toStdString();
}

QString withCauses(const Reason& reason, const QString& text) {
  if (reason.because.empty()) return text;
  const std::string causes = causesOf(reason);
  switch (reason.code) {
    case ReasonCode::OneSlice:  // goes on in a sentence of others
      return QStringLiteral("%1: %2").arg(text, QString::fromStdString(causes));
    case ReasonCode::Slices:
      return QString::fromStdString(words::asSentence(causes));
    case ReasonCode::PictureNotReadable:
      return text + QLatin1Char(' ') + QString::fromStdString(words::asSentence(causes));
    case ReasonCode::VersionNotHad:
      return QString::fromStdString(words::because(text.toStdString(), words::asSentence(causes)));
    default:
      return QString::fromStdString(words::because(text.toStdString(), causes));
  }
}

}  // namespace

QString templateOf(ReasonCode code, int count) {
  if (code == ReasonCode::Said) return QStringLiteral("%1");
  for (const QString& text : {ofSubmaps(code, count), ofPlaces(code), ofMaps(code, count), ofFiles(code),
                              ofMessages(code, count), ofRos(code, count), ofTheRobot(code)}) {
    if (!text.isEmpty()) return text;
  }
  return {};  // None, and what is put together otherwise
}

QString consequenceOf(Consequence consequence) {
  switch (consequence) {
    case Consequence::None:
      break;
    case Consequence::ShownWithoutIt:
      return Words::tr("Shown without it.");
    case Consequence::ShownWithoutItUntilTheNext:
      return Words::tr("Shown without it. It will be asked for again at the next version.");
    case Consequence::StaysWhereItWas:
      return Words::tr("It stays where it was.");
    case Consequence::AskedAgain:
      return Words::tr("It will be asked for again.");
    case Consequence::AskedAgainAtTheNext:
      return Words::tr("It will be asked for again at the next version.");
    case Consequence::PictureBeforeStays:
      return Words::tr("The picture before stays.");
    case Consequence::PictureBeforeItStays:
      return Words::tr("The picture before it stays.");
    case Consequence::AlertsBeforeStay:
      return Words::tr("The alerts before stay.");
    case Consequence::TheyWereLeftOut:
      return Words::tr("They were left out.");
    case Consequence::ItsPointsWereLeftOut:
      return Words::tr("Its points were left out.");
    case Consequence::AskedAgainEachTime:
      return Words::tr("It is asked for again each time.");
    case Consequence::ReadAnewEachTime:
      return Words::tr("They are read anew each time.");
  }
  return {};
}

QString wordsOf(const Reason& reason) {
  const QString text = reason.code == ReasonCode::CapabilityLacking
                           ? lackWords(reason)
                           : filled(templateOf(reason.code, countIn(reason)), reason.arguments);
  const QString whole = withCauses(reason, text);
  if (reason.then == Consequence::None || whole.isEmpty()) return whole + consequenceOf(reason.then);
  QString ended = QString::fromStdString(words::asSentence(whole.toStdString()));
  ended[0] = whole[0];  // it may be a name
  return ended + QLatin1Char(' ') + consequenceOf(reason.then);
}

QString sentenceOf(const Reason& reason) {
  return QString::fromStdString(words::asSentence(wordsOf(reason).toStdString()));
}

}  // namespace mapwright::sentences
