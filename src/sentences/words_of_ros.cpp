// What is found in messages of ROS, about its topics and by a manager of maps.
#include <QCoreApplication>

#include "sentences/words_by_code.h"

namespace mapwright::sentences {
namespace {

using map::ReasonCode;

class WordsOfRosText {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

// One function for each group of codes.

QString ofRos(ReasonCode code, int count) {
  switch (code) {
    case ReasonCode::RosFieldMissing:
      return WordsOfRosText::tr("Its field %1 is missing or cannot be read.");
    case ReasonCode::RosFieldWrong:
      return WordsOfRosText::tr("Its field %1 is %2, which cannot be.");
    case ReasonCode::RosLengthDiffers:
      return WordsOfRosText::tr("Its field %1 holds %2 values, but its other fields say %3.");
    case ReasonCode::RosRowsHoldMore:
      return WordsOfRosText::tr(
          "Its rows are %1 bytes long (row_step), but its points fill %2 of them (width and point_step). "
          "What "
          "lies behind them is left out.");
    case ReasonCode::RosGridEmpty:
      return WordsOfRosText::tr("It has no cells: it is %1 x %2.");
    case ReasonCode::RosTurnIsZero:
      return WordsOfRosText::tr(
          "Its orientation is no rotation (a zero quaternion). It is shown with yaw 0.");
    case ReasonCode::RosCellsOutOfRange:
      return WordsOfRosText::tr("%1 cells are neither -1 nor 0 to 100. They are shown as unknown.", nullptr,
                                count);
    case ReasonCode::PictureShownOtherwise:
      return WordsOfRosText::tr(
          "The robot has taken the picture, but shows %1 cells otherwise than they were sent. Compare both.",
          nullptr, count);
    case ReasonCode::RosPatchOutside:
      return WordsOfRosText::tr(
          "An update of %1 x %2 cells at %3, %4 does not lie in its %5 x %6 cells. It was left out.");
    case ReasonCode::RosPointsThinned:
      return WordsOfRosText::tr("It has %1 points, too many to be drawn. One of every %2 is shown.");
    case ReasonCode::RosPatchInOtherFrame:
      return WordsOfRosText::tr(
          "An update of it lies in the frame %1, but it lies in the frame %2. The update was left out.");
    case ReasonCode::RosOneConnection:
      return WordsOfRosText::tr(
          "The rosbridge server takes no second connection: %1. Maps and clouds share the one that poses "
          "come "
          "by, so these may come late while a map is sent.");
    case ReasonCode::RosFrameUnknown:
      return WordsOfRosText::tr(
          "The robot has sent no transform of the frame %1 yet, so it cannot be placed.");
    case ReasonCode::RosFramesApart:
      return WordsOfRosText::tr(
          "No transforms connect the frame %1 to the frame %2, so it cannot be placed.");
    case ReasonCode::RosTransformTooOld:
      return WordsOfRosText::tr(
          "It is older than the transforms of %1 in %2 that are kept, so it cannot be placed. The clocks of "
          "the robot may differ.");
    case ReasonCode::RosTransformTooNew:
      return WordsOfRosText::tr(
          "It is newer than the last transform of %1 in %2, so it cannot be placed. Whoever sends that "
          "transform may be late, or may have stopped.");
    case ReasonCode::RosTransformLoop:
      return WordsOfRosText::tr(
          "A transform of %1 in %2 would close a loop of frames. It was left out: two nodes of the robot "
          "contradict each other.");
    default:
      return {};
  }
}

QString ofTopics(ReasonCode code) {
  switch (code) {
    case ReasonCode::TopicSilent:
      return WordsOfRosText::tr("Waiting: nothing comes by it now");
    case ReasonCode::TopicNotListed:
      return WordsOfRosText::tr("the robot knows no such topic now");
    case ReasonCode::TopicNobodySends:
      return WordsOfRosText::tr("the topic is there, but no node of the robot sends anything by it");
    case ReasonCode::TopicsNotTold:
      return WordsOfRosText::tr(
          "the robot does not tell which topics it has (its node rosapi does not run), so it may not have "
          "it");
    case ReasonCode::TopicAskedInstead:
      return WordsOfRosText::tr(
          "Nothing has come by it. Its map has been asked for by the service %1, and is shown as it was "
          "then.");
    case ReasonCode::MapServiceFailed:
      return WordsOfRosText::tr(
          "The map could not be had by the service %1 either: %2. It will be asked for again.");
    case ReasonCode::PoseSourceAway:
      return WordsOfRosText::tr(
          "The rosbridge that tells where the robot is cannot be reached at %1: %2. Maps and waypoints come "
          "all "
          "the same.");
    case ReasonCode::TopicListedOnly:
      return WordsOfRosText::tr(
          "the topic is there; it may have nothing to say now, or the rosbridge server may lack its type");
    default:
      return {};
  }
}

QString ofDispatchers(ReasonCode code) {
  switch (code) {
    case ReasonCode::RegionMeansNothing:
      return WordsOfRosText::tr(
          "The robot has not been asked: a region needs a place and a size that are numbers, and a size of "
          "more than 0 m.");
    case ReasonCode::FileNameMeansNothing:
      return WordsOfRosText::tr(
          "The robot has not been asked: the name of a file needs one to 4,096 bytes, and no line ends or "
          "other control characters.");
    case ReasonCode::ProjectionMeansNothing:
      return WordsOfRosText::tr(
          "The robot has not been asked: a projection needs a place and heights that are numbers, a size of "
          "more than 0 m, and its lower height below the upper one.");
    case ReasonCode::ProjectionsNotTold:
      return WordsOfRosText::tr(
          "What it projects cannot be told: it does not say which topics and services it has (its node "
          "rosapi "
          "does not run), and nothing has come by the usual topics (projected_map_0 and so on).");
    default:
      return {};
  }
}

QString ofMapManagers(ReasonCode code) {
  switch (code) {
    case ReasonCode::NoAnswerInTime:
      return WordsOfRosText::tr("the robot did not answer in time");
    case ReasonCode::LinkBrokeOff:
      return WordsOfRosText::tr("the connection broke off");
    case ReasonCode::NotConnected:
      return WordsOfRosText::tr("there is no connection to the robot");
    case ReasonCode::AnswerWithoutResult:
      return WordsOfRosText::tr("its answer holds no result");
    case ReasonCode::ResultMapUnknown:
      return WordsOfRosText::tr("it has no such map");
    case ReasonCode::ResultNameTaken:
      return WordsOfRosText::tr(
          "another waypoint of this map is called \"%1\", too; give one of the two another name");
    case ReasonCode::ResultWaypointUnknown:
      return WordsOfRosText::tr("it has no such waypoint any more");
    case ReasonCode::ResultUndefined:
      return WordsOfRosText::tr("it failed, and does not say why");
    case ReasonCode::ResultInvalid:
      return WordsOfRosText::tr("it takes the request for invalid");
    case ReasonCode::ResultInvalidLoad:
      return WordsOfRosText::tr(
          "it takes the request for invalid; it may want to be told at which waypoint it stands");
    case ReasonCode::ResultAlreadyLoaded:
      return WordsOfRosText::tr("it works with this map already");
    case ReasonCode::ResultNothingToSave:
      return WordsOfRosText::tr(
          "it takes the request for invalid; there may be nothing to save, or the name may not do");
    case ReasonCode::ResultMapNameTaken:
      return WordsOfRosText::tr("another map is called \"%1\" already; choose another name");
    case ReasonCode::NoRosbridgeThere:
      return WordsOfRosText::tr(
          "something answers at %1, but not as a rosbridge server: %2. Check the address and the port.");
    case ReasonCode::NoMapManagerThere:
      return WordsOfRosText::tr(
          "a rosbridge server answers at %1, but its robot runs no KABAM map manager (/map_manager). Start "
          "it, or "
          "connect to ros+ws:// for what else there is.");
    case ReasonCode::ResultUnknown:
      return WordsOfRosText::tr("%1 is no answer that this program knows");
    case ReasonCode::NotConfirmed:
      return WordsOfRosText::tr(
          "not confirmed: the robot said that it was done, but did not show it within %1 s. Look again");
    case ReasonCode::TagsNotTaken:
      return WordsOfRosText::tr(
          "The robot has taken the change of \"%1\", but not its tags. To be rid of its last tag, delete the "
          "waypoint and create it anew.");
    case ReasonCode::ChangedMeanwhile:
      return WordsOfRosText::tr("\"%1\" has been changed on the robot meanwhile");
    case ReasonCode::ListsNotTold:
      return WordsOfRosText::tr("the robot's map manager has not told its maps in time");
    case ReasonCode::OnlyCurrentMapSent:
      return WordsOfRosText::tr(
          "The robot sends only the map that it works with. Load this one on the robot to see it.");
    case ReasonCode::OnlyCurrentMapTaken:
      return WordsOfRosText::tr(
          "The robot sends only the map that it works with, so only that one's picture can be saved and "
          "compared. Nothing was sent. Load this map on the robot first.");
    case ReasonCode::PictureChangedMeanwhile:
      return WordsOfRosText::tr("the picture of \"%1\" has been changed on the robot meanwhile");
    case ReasonCode::CellBetweenKinds:
      return WordsOfRosText::tr(
          "Some of its cells are neither free, occupied nor unknown but in between (%1 of 100), and for "
          "these the "
          "map manager names no shade. Nothing was sent. Export the map to edit it as files.");
    case ReasonCode::MessageNotUnderstood:
      return WordsOfRosText::tr("Its message is not what is expected there. It was left out.");
    case ReasonCode::WaypointTurnIsZero:
      return WordsOfRosText::tr(
          "Waypoint \"%1\" has no heading (a zero quaternion). It is shown with yaw 0, and kept as it is "
          "until "
          "you turn it.");
    case ReasonCode::WaypointInOtherFrame:
      return WordsOfRosText::tr("Waypoint \"%1\" lies in the frame %2 instead of %3. It was left out.");
    default:
      return {};
  }
}

}  // namespace

QString wordsOfLoneFrame(ReasonCode code) {
  switch (code) {
    case ReasonCode::RosFramesApart:
      return WordsOfRosText::tr(
          "Neither a map nor a transform tells where the frame %1 lies. It is shown as seen from there, as "
          "if "
          "the robot never moved.");
    case ReasonCode::WaypointInOtherFrame:
      return WordsOfRosText::tr(
          "Waypoint \"%1\" is told in the frame %2, and no map has come that tells its own. It is taken for "
          "a "
          "place on the map.");
    default:
      return {};
  }
}

QString wordsOfRos(ReasonCode code, int count) {
  QString text = ofRos(code, count);
  if (text.isEmpty()) text = ofTopics(code);
  if (text.isEmpty()) text = ofDispatchers(code);
  return text.isEmpty() ? ofMapManagers(code) : text;
}

}  // namespace mapwright::sentences
