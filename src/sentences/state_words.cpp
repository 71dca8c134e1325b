#include "sentences/state_words.h"

#include <QCoreApplication>

#include "words/qt_plain.h"

namespace mapwright::sentences {
namespace {

class StateText {
  Q_DECLARE_TR_FUNCTIONS(State)
};

/// Why a task of driving failed, by the maker's codes (docs/protocols/autoxing.md).
struct FailureName {
  int code;
  const char* name;
  const char* words;
};
constexpr FailureName kFailures[] = {
    {1, "unknown", QT_TRANSLATE_NOOP("State", "a reason that it does not know")},
    {2, "GetMapFailed", QT_TRANSLATE_NOOP("State", "it has no map")},
    {3, "StartingPointOutOfMap", QT_TRANSLATE_NOOP("State", "the start lies outside of the map")},
    {4, "EndingPointOutOfMap", QT_TRANSLATE_NOOP("State", "the target lies outside of the map")},
    {5, "StartingPointNotInGround", QT_TRANSLATE_NOOP("State", "the start is not on free ground")},
    {6, "EndingPointNotInGround", QT_TRANSLATE_NOOP("State", "the target is not on free ground")},
    {7, "StartingEqualEnding", QT_TRANSLATE_NOOP("State", "start and target are the same")},
    {8, "CalculateGlobalPathExtendedDataError",
     QT_TRANSLATE_NOOP("State", "the details of the path could not be worked out")},
    {9, "CalculationFailed", QT_TRANSLATE_NOOP("State", "no road leads from the start to the target")},
    {10, "CalculationTimeout", QT_TRANSLATE_NOOP("State", "working out the path took too long")},
    {11, "NoGlobalPath", QT_TRANSLATE_NOOP("State", "there is no path")},
    {12, "NotGrabStartIndexOnGlobalPath", QT_TRANSLATE_NOOP("State", "the start was not found on the path")},
    {13, "NotGrabEndIndexOnGlobalPath", QT_TRANSLATE_NOOP("State", "the target was not found on the path")},
    {14, "PlanningTimeout", QT_TRANSLATE_NOOP("State", "no way was found for too long")},
    {15, "MoveTimeout", QT_TRANSLATE_NOOP("State", "a way was found, but driving took too long")},
    {16, "ControlCostmapError",
     QT_TRANSLATE_NOOP("State", "the data for avoiding obstacles is wrong, or a sensor is")},
    {17, "PowerCableConnected", QT_TRANSLATE_NOOP("State", "it is charging by a cable")},
    {18, "RotateTimeout", QT_TRANSLATE_NOOP("State", "turning took too long")},
    {100, "ChargeRetryCountExceeded",
     QT_TRANSLATE_NOOP("State", "it tried to dock at the charger too often")},
    {101, "ChargeDockDetectionError", QT_TRANSLATE_NOOP("State", "it did not recognise the charger")},
    {102, "ChargeDockSignalError", QT_TRANSLATE_NOOP("State", "the charger did not confirm the docking")},
    {103, "InvalidChargeDock", QT_TRANSLATE_NOOP("State", "the place of the charger is not valid")},
    {104, "AlreadyInCharging", QT_TRANSLATE_NOOP("State", "it is charging already")},
    {105, "NoChargeCurrent", QT_TRANSLATE_NOOP("State", "no current came from the charger")},
    {200, "InvalidCabinetPos", QT_TRANSLATE_NOOP("State", "the place of the cabinet is not valid")},
    {201, "CabinetDetectionError", QT_TRANSLATE_NOOP("State", "it did not recognise the cabinet")},
    {202, "NoDockWithConveyer", QT_TRANSLATE_NOOP("State", "it is not docked at the conveyor")},
    {203, "NoApproachConveyer", QT_TRANSLATE_NOOP("State", "it is not in front of the conveyor")},
    {300, "ElevatorPointOccupied", QT_TRANSLATE_NOOP("State", "the place in the elevator is taken")},
    {301, "ElevatorClosed", QT_TRANSLATE_NOOP("State", "the elevator is closed")},
    {302, "ElevatorPointObscuredTimeout",
     QT_TRANSLATE_NOOP("State", "the place in the elevator was out of sight for too long")},
    {303, "ElevatorPointOccupancyDetectionTimeout",
     QT_TRANSLATE_NOOP("State", "looking whether the place in the elevator is free took too long")},
    {304, "ElevatorEnterProgressUpdateTimeout",
     QT_TRANSLATE_NOOP("State", "entering the elevator made no progress for too long")},
    {400, "InvalidTrackPoints", QT_TRANSLATE_NOOP("State", "the points of the track are not valid")},
    {401, "TooFarFromStartOfTrack", QT_TRANSLATE_NOOP("State", "it is too far from the start of the track")},
    {500, "InvalidRackDetectionPos",
     QT_TRANSLATE_NOOP("State", "the place to look for the rack from is not valid")},
    {501, "RackDetectionError", QT_TRANSLATE_NOOP("State", "it did not recognise the rack")},
    {502, "RackRetryCountExceeded", QT_TRANSLATE_NOOP("State", "it tried to dock at the rack too often")},
    {503, "UnloadPointOccupied", QT_TRANSLATE_NOOP("State", "the place to unload at is taken")},
    {504, "UnloadPointUnreachable", QT_TRANSLATE_NOOP("State", "the place to unload at cannot be reached")},
    {505, "RackMoved", QT_TRANSLATE_NOOP("State", "the rack has moved")},
    {506, "JackInUpState", QT_TRANSLATE_NOOP("State", "its jack is up")},
    {507, "InvalidRackAreaId", QT_TRANSLATE_NOOP("State", "the id of the rack zone is not valid")},
    {508, "InvalidRackArea", QT_TRANSLATE_NOOP("State", "the rack zone has no places")},
    {509, "UnknownRackSpaceState",
     QT_TRANSLATE_NOOP("State", "it does not know whether places of the rack zone are free")},
    {510, "NoRackInRackArea", QT_TRANSLATE_NOOP("State", "there is no rack in the rack zone")},
    {511, "AlignFailedInRackArea",
     QT_TRANSLATE_NOOP("State", "it could not dock at a rack of the rack zone")},
    {512, "NoFreeSpaceInRackArea", QT_TRANSLATE_NOOP("State", "the rack zone has no free place")},
    {513, "FailedToUnloadInRackArea", QT_TRANSLATE_NOOP("State", "it could not unload in the rack zone")},
    {600, "FollowFailed", QT_TRANSLATE_NOOP("State", "it lost whom it followed")},
    {700, "PoiDetectionError", QT_TRANSLATE_NOOP("State", "it did not recognise the place")},
    {701, "PoiUnreachable", QT_TRANSLATE_NOOP("State", "the place cannot be reached")},
    {702, "BarcodeDetectionError", QT_TRANSLATE_NOOP("State", "it did not recognise the barcode")},
    {1000, "PlatformAlertError", QT_TRANSLATE_NOOP("State", "something is wrong with the robot itself")},
    {1001, "ServiceCallError", QT_TRANSLATE_NOOP("State", "a request to it was wrong")},
    {1002, "InternalError", QT_TRANSLATE_NOOP("State", "its program found itself in error")},
    {1003, "MapChanged", QT_TRANSLATE_NOOP("State", "its map was changed or taken away meanwhile")},
    {1004, "MoveActionTypeDeprecated",
     QT_TRANSLATE_NOOP("State", "it does not know this kind of task any more")},
};

}  // namespace

QString qualityWord(int quality) {
  switch (quality) {
    case 0:
      return StateText::tr("unknown");
    case 1:
      return StateText::tr("lost");
    case 3:
      return StateText::tr("poor");
    case 8:
      return StateText::tr("good");
    case 10:
      return StateText::tr("excellent");
    default:
      return StateText::tr("quality %1").arg(quality);
  }
}

QString plannerWord(const std::string& move_state) {
  if (move_state.empty()) return StateText::tr("state unknown");
  if (move_state == "none" || move_state == "idle") return StateText::tr("idle");
  if (move_state == "moving") return StateText::tr("driving to its target");
  if (move_state == "succeeded") return StateText::tr("arrived");
  if (move_state == "failed") return StateText::tr("failed to get there");
  if (move_state == "cancelled") return StateText::tr("cancelled");
  return StateText::tr("\"%1\"").arg(words::plainName(move_state));
}

QString stateWord(const std::string& state) {
  for (const char* word :
       {QT_TRANSLATE_NOOP("State", "charging"),    QT_TRANSLATE_NOOP("State", "discharging"),
        QT_TRANSLATE_NOOP("State", "full"),        QT_TRANSLATE_NOOP("State", "auto"),
        QT_TRANSLATE_NOOP("State", "manual"),      QT_TRANSLATE_NOOP("State", "remote"),
        QT_TRANSLATE_NOOP("State", "positioning"), QT_TRANSLATE_NOOP("State", "idle"),
        QT_TRANSLATE_NOOP("State", "moving"),      QT_TRANSLATE_NOOP("State", "succeeded"),
        QT_TRANSLATE_NOOP("State", "failed"),      QT_TRANSLATE_NOOP("State", "cancelled"),
        QT_TRANSLATE_NOOP("State", "running"),     QT_TRANSLATE_NOOP("State", "finished"),
        QT_TRANSLATE_NOOP("State", "awake"),       QT_TRANSLATE_NOOP("State", "awakening"),
        QT_TRANSLATE_NOOP("State", "sleeping"),    QT_TRANSLATE_NOOP("State", "ok"),
        QT_TRANSLATE_NOOP("State", "hold"),        QT_TRANSLATE_NOOP("State", "jacking_up"),
        QT_TRANSLATE_NOOP("State", "jacking_down")}) {
    if (state == word) return StateText::tr(word);
  }
  return words::plainName(state);
}

QString doorWord(const std::string& state) {
  if (state.empty() || state == "unknown") return StateText::tr("unknown");
  if (state == "open") return StateText::tr("open");
  if (state == "closed") return StateText::tr("closed");
  if (state == "opening") return StateText::tr("opening");
  if (state == "closing") return StateText::tr("closing");
  return words::plainName(state);
}

QString failureWords(const std::string& reason) {
  const QString said = words::plainName(reason);
  const QString name = said.section(QStringLiteral(" - "), 0, 0);
  for (const FailureName& known : kFailures) {
    if (name.compare(QLatin1String(known.name), Qt::CaseInsensitive) == 0 ||
        name == QString::number(known.code))
      return StateText::tr("%1 (%2)").arg(StateText::tr(known.words), said);
  }
  return said;
}

}  // namespace mapwright::sentences
