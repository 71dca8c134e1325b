#include "sentences/obstacle_sentence.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

using robot::MapChange;
using robot::Obstacle;

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
    case MapChange::Save:
      return ObstacleText::tr("The mapping result of this robot cannot be saved from here.");
  }
  return {};
}

}  // namespace

QString whyNotNow(MapChange change, Obstacle obstacle) {
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
    case Obstacle::NotKnownYet:
      return ObstacleText::tr("The robot has not reported its state yet.");
  }
  return notOffered(change);
}

}  // namespace mapwright::sentences
