#include "sentences/absence_sentence.h"

#include <QCoreApplication>
#include <QStringList>

#include "robot/faults.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::sentences {
namespace {

using robot::Absence;
using robot::Capability;
using robot::MapChange;
using robot::Obstacle;

class AbsenceText {
  Q_DECLARE_TR_FUNCTIONS(Absence)
};

/// In other words where the program itself says what is missing.
QString argument(const Absence& absence) {
  return absence.arguments.empty() ? QString() : AbsenceText::tr(absence.arguments.front().c_str());
}

struct Lack {
  Capability capability;
  const char* of_robot;
  const char* of_file = of_robot;
};

constexpr Lack kLacks[] = {
    {Capability::Submaps, QT_TRANSLATE_NOOP("Absence", "There are no submaps here, only whole maps.")},
    {Capability::Catalogue, QT_TRANSLATE_NOOP("Absence", "This robot does not list its maps."),
     QT_TRANSLATE_NOOP("Absence", "This file has no list of maps.")},
    {Capability::WholeMaps, QT_TRANSLATE_NOOP("Absence", "This robot provides no whole map."),
     QT_TRANSLATE_NOOP("Absence", "There is no whole map in this file.")},
    {Capability::Overview, QT_TRANSLATE_NOOP("Absence", "This robot provides no overview of its map."),
     QT_TRANSLATE_NOOP("Absence", "There is no overview of a map in this file.")},
    {Capability::Waypoints, QT_TRANSLATE_NOOP("Absence", "This robot provides no waypoints."),
     QT_TRANSLATE_NOOP("Absence", "There are no waypoints in this file.")},
    {Capability::WaypointEditing, QT_TRANSLATE_NOOP("Absence", "The waypoints of this robot are read-only."),
     QT_TRANSLATE_NOOP("Absence", "Waypoints cannot be edited in this file.")},
    {Capability::Live, QT_TRANSLATE_NOOP("Absence", "There is no live data here.")},
    {Capability::Administration,
     QT_TRANSLATE_NOOP("Absence", "The maps of this robot cannot be changed from here."),
     QT_TRANSLATE_NOOP("Absence", "Local maps are named after their files, and no robot uses them.")},
    {Capability::PictureEditing,
     QT_TRANSLATE_NOOP("Absence", "The pictures of this robot's maps are read-only."),
     QT_TRANSLATE_NOOP("Absence", "There is no picture in this file that can be edited.")},
    {Capability::OverlayEditing,
     QT_TRANSLATE_NOOP("Absence", "This robot keeps no overlays that can be edited."),
     QT_TRANSLATE_NOOP("Absence", "There are no overlays in this file that can be edited.")},
    {Capability::Bags, QT_TRANSLATE_NOOP("Absence", "This robot has no bags that can be replayed."),
     QT_TRANSLATE_NOOP("Absence", "There is nothing in this file that can be replayed.")},
    {Capability::Dispatch,
     QT_TRANSLATE_NOOP("Absence",
                       "This robot does not send parts of its map: no regions, no clouds, no projections."),
     QT_TRANSLATE_NOOP("Absence", "This is a file: there is no robot to fetch from.")},
    {Capability::Localization,
     QT_TRANSLATE_NOOP("Absence", "The position of this robot cannot be set from here."),
     QT_TRANSLATE_NOOP("Absence", "This is a file: there is no robot whose position could be set.")},
    {Capability::MapTransfer,
     QT_TRANSLATE_NOOP("Absence",
                       "The maps of this robot cannot be downloaded whole, and none can be added."),
     QT_TRANSLATE_NOOP("Absence", "This is a file: there is no robot to download maps from.")},
    {Capability::PoseGraph, QT_TRANSLATE_NOOP("Absence", "There is no pose graph here.")},
};

/// What there is none of, whatever the reason.
QString nothing(Capability capability, bool in_file = false) {
  for (const Lack& lack : kLacks) {
    if (lack.capability == capability)
      return QCoreApplication::translate("Absence", in_file ? lack.of_file : lack.of_robot);
  }
  return {};
}

class ObstacleText {
  Q_DECLARE_TR_FUNCTIONS(Obstacle)
};

QString notOffered(MapChange change) {
  switch (change) {
    case MapChange::Rename:
      return ObstacleText::tr("The maps of this robot cannot be renamed from here.");
    case MapChange::Load:
      return ObstacleText::tr("The current map of this robot cannot be changed from here.");
    case MapChange::Archive:
    case MapChange::Unarchive:
      return ObstacleText::tr("This robot has no map archive.");
    case MapChange::Delete:
      return ObstacleText::tr("The maps of this robot cannot be deleted from here.");
    case MapChange::StartMapping:
    case MapChange::StopMapping:
      return ObstacleText::tr("Mapping cannot be started on this robot from here.");
    case MapChange::ContinueMapping:
      return ObstacleText::tr("The current map of this robot cannot be extended from here.");
    case MapChange::CancelMapping:
      return ObstacleText::tr("Mapping cannot be cancelled on this robot from here.");
    case MapChange::Save:
      return ObstacleText::tr("The mapping result of this robot cannot be saved from here.");
  }
  return {};
}

}  // namespace

QString absenceReason(Capability capability, const Absence& absence) {
  switch (absence.reason) {
    case Absence::Reason::NotOfThisKind:
      break;
    case Absence::Reason::ReadOnly:
      return AbsenceText::tr("Read only: %1's interface offers no editing.").arg(argument(absence));
    case Absence::Reason::NotToldYet:
      return AbsenceText::tr(
          "It is not known yet whether this robot can be edited: it has not answered that question. It is "
          "asked again.");
    case Absence::Reason::NotYetHere:
      return words::paragraph({nothing(capability), AbsenceText::tr("Not supported in this version yet.")});
    case Absence::Reason::FirmwareLacks:
      return words::paragraph(
          {nothing(capability),
           AbsenceText::tr("Its firmware does not support this request (%1).").arg(argument(absence))});
    case Absence::Reason::NoService:
      if (capability == Capability::Live)
        return AbsenceText::tr(
                   "Its interface does not report its pose. If a rosbridge server runs on it, add %1 to its "
                   "address.")
            .arg(argument(absence));
      return words::paragraph(
          {nothing(capability), AbsenceText::tr("%1 is not running on it, or cannot be reached from here.")
                                    .arg(argument(absence))});
    case Absence::Reason::LocalFiles:
      // A replay is described by its name: replay::ReplayRobot.
      if (!absence.arguments.empty())
        return AbsenceText::tr("This is a replay of %1: nothing can be changed.")
            .arg(words::plainName(absence.arguments.front()));
      if (capability == Capability::Live)
        return AbsenceText::tr("This is a local map: there is no robot, so nothing moves on it.");
      return nothing(capability, true);
  }
  return nothing(capability);
}

QString unconfirmedOf(robot::Robot& robot, Capability capability) {
  if (capability == Capability::Administration && robot.mapAdministration() &&
      robot.isUnconfirmed(capability))
    return AbsenceText::tr(
        "This is not confirmed by the robot's maker: how maps are changed is only known from third parties. "
        "The result is read back.");
  if (capability == Capability::WaypointEditing && robot.waypointStore() && robot.isUnconfirmed(capability))
    return AbsenceText::tr(
        "This is not confirmed by the robot's maker: how waypoints are changed is only known from third "
        "parties. The result is read back.");
  return {};
}

QString limitsOf(robot::Robot& robot) {
  // Without a single map the reason for that is enough.
  if (robot.isLocal() && robot.connection().phase == robot::ConnectionPhase::Refused) return {};
  QStringList limits;
  const auto add = [&](Capability capability) {
    const Absence absence = robot.unavailableReason(capability);
    // Nobody expects this of files.
    if (capability == Capability::Administration && absence.reason == Absence::Reason::LocalFiles) return;
    const bool telling = absence.reason == Absence::Reason::ReadOnly ||
                         absence.reason == Absence::Reason::NotYetHere ||
                         absence.reason == Absence::Reason::LocalFiles ||
                         (absence.reason == Absence::Reason::NotToldYet &&
                          robot.connection().phase == robot::ConnectionPhase::Online) ||
                         (capability == Capability::Live && absence.reason == Absence::Reason::NoService);
    if (telling) limits << absenceReason(capability, absence);
  };
  if (!robot.mapAdministration()) add(Capability::Administration);
  if (!robot.liveTopics()) add(Capability::Live);
  if (!unconfirmedOf(robot, Capability::Administration).isEmpty())
    limits << AbsenceText::tr(
        "How maps and waypoints are changed on this robot is not confirmed by its maker: try it where "
        "nothing "
        "can go wrong.");
  limits.removeDuplicates();
  return words::paragraph(limits);
}

Fault lackOf(Capability capability, const Absence& absence) {
  std::vector<FaultArgument> arguments{std::int64_t(capability), std::int64_t(absence.reason)};
  arguments.insert(arguments.end(), absence.arguments.begin(), absence.arguments.end());
  return {robot::fault::CapabilityLacking, std::move(arguments)};
}

QString notNowReason(MapChange change, Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::NotOffered:
      break;
    case Obstacle::NotOfThisMap:
      return ObstacleText::tr("This only works with a stored map, not with the one being mapped.");
    case Obstacle::WhileMapping:
      return ObstacleText::tr("Not while the robot is mapping: stop mapping first.");
    case Obstacle::NotMapping:
      return ObstacleText::tr("The robot is not mapping.");
    case Obstacle::IsArchived:
      return ObstacleText::tr("It is archived: restore it from the archive first.");
    case Obstacle::IsNotArchived:
      return ObstacleText::tr("It is not archived.");
    case Obstacle::IsLoaded:
      return ObstacleText::tr("The robot already uses it.");
    case Obstacle::EndsBySaving:
      return ObstacleText::tr("This robot ends a mapping by saving the map, or by discarding it.");
    case Obstacle::NotKnownYet:
      return ObstacleText::tr("The robot has not reported its state yet.");
    case Obstacle::NothingToSave:
      return ObstacleText::tr("There is no new map to save.");
  }
  return notOffered(change);
}

}  // namespace mapwright::sentences
