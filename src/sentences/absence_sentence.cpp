#include "sentences/absence_sentence.h"

#include <QCoreApplication>
#include <QStringList>

#include "robot/faults.h"
#include "words/qt_plain.h"

namespace mapwright::sentences {
namespace {

using robot::Absence;
using robot::Capability;

class AbsenceText {
  Q_DECLARE_TR_FUNCTIONS(Absence)
};

QString argument(const Absence& absence) {
  return absence.arguments.empty() ? QString() : QString::fromStdString(absence.arguments.front());
}

/// What there is none of, whatever the reason.
QString nothing(Capability capability) {
  switch (capability) {
    case Capability::Submaps:
      return AbsenceText::tr("There are no submaps here, only whole maps.");
    case Capability::Catalogue:
      return AbsenceText::tr("This robot does not list its maps.");
    case Capability::WholeMaps:
      return AbsenceText::tr("This robot provides no whole map.");
    case Capability::Overview:
      return AbsenceText::tr("This robot provides no overview of its map.");
    case Capability::Waypoints:
      return AbsenceText::tr("This robot provides no waypoints.");
    case Capability::WaypointEditing:
      return AbsenceText::tr("The waypoints of this robot are read-only.");
    case Capability::Live:
      return AbsenceText::tr("There is no live data here.");
    case Capability::Administration:
      return AbsenceText::tr("The maps of this robot cannot be changed from here.");
    case Capability::PictureEditing:
      return AbsenceText::tr("The pictures of this robot's maps are read-only.");
    case Capability::Bags:
      return AbsenceText::tr("This robot has no bags that can be replayed.");
    case Capability::Dispatch:
      return AbsenceText::tr(
          "This robot does not send parts of its map: no regions, no clouds, no projections.");
  }
  return {};
}

}  // namespace

QString whyAbsent(Capability capability, const Absence& absence) {
  switch (absence.reason) {
    case Absence::Reason::NotOfThisKind:
      break;
    case Absence::Reason::ReadOnly:
      return AbsenceText::tr("Read only: %1's interface offers no editing.").arg(argument(absence));
    case Absence::Reason::NotYetHere:
      return nothing(capability) + QLatin1Char(' ') + AbsenceText::tr("Not supported in this version yet.");
    case Absence::Reason::FirmwareLacks:
      return nothing(capability) + QLatin1Char(' ') +
             AbsenceText::tr("Its firmware does not support this request (%1).").arg(argument(absence));
    case Absence::Reason::NoService:
      if (capability == Capability::Live)
        return AbsenceText::tr(
                   "Its interface does not report its pose. If a rosbridge server runs on it, add %1 to its "
                   "address.")
            .arg(argument(absence));
      return nothing(capability) + QLatin1Char(' ') +
             AbsenceText::tr("%1 is not running on it, or cannot be reached from here.")
                 .arg(argument(absence));
    case Absence::Reason::LocalFiles:
      // A replay is described by its name: replay::ReplayRobot.
      if (!absence.arguments.empty())
        return AbsenceText::tr("This is a replay of %1: nothing can be changed.")
            .arg(words::plainName(absence.arguments.front()));
      if (capability == Capability::Live)
        return AbsenceText::tr("This is a local map: there is no robot, so nothing moves on it.");
      if (capability == Capability::Administration)
        return AbsenceText::tr("Local maps are named after their files, and no robot uses them.");
      break;
  }
  return nothing(capability);
}

QString limitsOf(robot::Robot& robot) {
  QStringList limits;
  const auto add = [&](Capability capability) {
    const Absence absence = robot.whyNot(capability);
    // Nobody expects this of files.
    if (capability == Capability::Administration && absence.reason == Absence::Reason::LocalFiles) return;
    const bool telling = absence.reason == Absence::Reason::ReadOnly ||
                         absence.reason == Absence::Reason::NotYetHere ||
                         absence.reason == Absence::Reason::LocalFiles ||
                         (capability == Capability::Live && absence.reason == Absence::Reason::NoService);
    if (telling) limits << whyAbsent(capability, absence);
  };
  if (!robot.mapAdministration()) add(Capability::Administration);
  if (!robot.liveTopics()) add(Capability::Live);
  limits.removeDuplicates();
  return limits.join(QLatin1Char(' '));
}

Fault lackOf(Capability capability, const Absence& absence) {
  std::vector<FaultArgument> arguments{std::int64_t(capability), std::int64_t(absence.reason)};
  arguments.insert(arguments.end(), absence.arguments.begin(), absence.arguments.end());
  return {robot::fault::CapabilityLacking, std::move(arguments)};
}

}  // namespace mapwright::sentences
