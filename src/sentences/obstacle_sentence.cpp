#include "sentences/obstacle_sentence.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

using robot::MapChange;
using robot::Obstacle;

class Words {
  Q_DECLARE_TR_FUNCTIONS(Obstacle)
};

QString notOffered(MapChange change) {
  switch (change) {
    case MapChange::Rename:
      return Words::tr("The maps of this robot cannot be renamed from here.");
    case MapChange::Load:
      return Words::tr("This robot cannot be told from here which map to work with.");
    case MapChange::Archive:
    case MapChange::Unarchive:
      return Words::tr("This robot has no archive of maps.");
    case MapChange::Delete:
      return Words::tr("The maps of this robot cannot be deleted from here.");
    case MapChange::StartMapping:
    case MapChange::StopMapping:
      return Words::tr("Mapping cannot be started on this robot from here.");
    case MapChange::Save:
      return Words::tr("What this robot maps cannot be saved from here.");
  }
  return {};
}

}  // namespace

QString whyNotNow(MapChange change, Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::NotOffered:
      break;
    case Obstacle::NotOfThisMap:
      return Words::tr("Only with a map that the robot keeps, not with what it is mapping.");
    case Obstacle::WhileMapping:
      return Words::tr("Not while the robot is mapping: stop mapping first.");
    case Obstacle::NotMapping:
      return Words::tr("The robot is not mapping.");
    case Obstacle::IsArchived:
      return Words::tr("It is archived: take it out of the archive first.");
    case Obstacle::IsNotArchived:
      return Words::tr("It is not archived.");
    case Obstacle::IsLoaded:
      return Words::tr("The robot works with it already.");
    case Obstacle::NotKnownYet:
      return Words::tr("The robot has not told yet what it does.");
  }
  return notOffered(change);
}

}  // namespace mapwright::sentences
