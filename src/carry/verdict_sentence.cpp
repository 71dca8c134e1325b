#include "carry/verdict_sentence.h"

#include <QCoreApplication>

namespace mapwright::carry {
namespace {

struct CarryText {
  Q_DECLARE_TR_FUNCTIONS(CarryText)
};

}  // namespace

QString verdictText(Verdict verdict) {
  switch (verdict) {
    case Verdict::Kept:
      return CarryText::tr("kept");
    case Verdict::Adjusted:
      return CarryText::tr("adjusted");
    case Verdict::InObstacle:
      return CarryText::tr("in an obstacle");
    case Verdict::Outside:
      return CarryText::tr("outside");
    case Verdict::Unreachable:
      return CarryText::tr("unreachable");
    case Verdict::NotSupported:
      return CarryText::tr("not supported");
  }
  return {};
}

QString meaningOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Kept:
      return CarryText::tr("Moved by the transform alone.");
    case Verdict::Adjusted:
      return CarryText::tr("Moved a little further, to where the walls around it are now.");
    case Verdict::InObstacle:
      return CarryText::tr("A wall is there now, or so close that the robot does not fit.");
    case Verdict::Outside:
      return CarryText::tr("The new map knows nothing there.");
    case Verdict::Unreachable:
      return CarryText::tr("It is cut off: the robot cannot drive there.");
    case Verdict::NotSupported:
      return CarryText::tr("No wall around it agrees, so its place is a guess.");
  }
  return {};
}

}  // namespace mapwright::carry
