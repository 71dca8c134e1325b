#include "sentences/placing_sentence.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace mapwright::sentences {
namespace {

class PlacingText {
  Q_DECLARE_TR_FUNCTIONS(Placing)
};

QString metres(double value) { return QLocale::c().toString(value, 'f', 2); }

}  // namespace

QString sentenceOf(const placing::Warning& warning) {
  using placing::WarningKind;
  switch (warning.kind) {
    case WarningKind::InWall:
      return PlacingText::tr("It is in a wall.");
    case WarningKind::OutsideMap:
      return PlacingText::tr("It is outside the map.");
    case WarningKind::NearWall:
      return PlacingText::tr("It is %1 m from a wall: closer than the robot's radius of %2 m.")
          .arg(metres(warning.distance_m), metres(warning.radius_m));
    case WarningKind::OnUnknown:
      return PlacingText::tr("It is in an unknown part of the map.");
    case WarningKind::NameTwice:
      return PlacingText::tr("Another waypoint has the same name.");
    case WarningKind::ZeroTurn:
      return PlacingText::tr("Its orientation is a zero quaternion, so it has no heading: turn it.");
    case WarningKind::TemporaryName:
      return PlacingText::tr("Its name looks temporary: a swap of names was interrupted.");
  }
  return {};
}

QString sentencesOf(const placing::Warnings& warnings) {
  QStringList lines;
  for (const placing::Warning& warning : warnings) lines << sentenceOf(warning);
  return lines.join(QLatin1Char('\n'));
}

QString sentenceOf(placing::GroundState ground) {
  switch (ground) {
    case placing::GroundState::None:
      return PlacingText::tr("There is no map below: walls are not checked.");
    case placing::GroundState::Unknown:
      return PlacingText::tr("The map below is unknown everywhere: walls cannot be checked.");
    case placing::GroundState::Known:
      break;
  }
  return {};
}

}  // namespace mapwright::sentences
