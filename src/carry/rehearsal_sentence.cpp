#include "carry/rehearsal_sentence.h"

#include <QCoreApplication>
#include <QStringList>

#include "words/fixed.h"
#include "words/listed.h"

namespace mapwright::carry {
namespace {

struct RehearsalText {
  Q_DECLARE_TR_FUNCTIONS(RehearsalText)
};

QString reachText(Rehearsed::Reach reach) {
  switch (reach) {
    case Rehearsed::Reach::Reached:
      return RehearsalText::tr("Its end can be reached from its start.");
    case Rehearsed::Reach::CutOff:
      return RehearsalText::tr("Its end cannot be reached from its start on this map.");
    case Rehearsed::Reach::NoStart:
      return RehearsalText::tr("The robot cannot drive where it starts.");
    case Rehearsed::Reach::NoEnd:
      return RehearsalText::tr("The robot cannot drive where it ends.");
  }
  return {};
}

}  // namespace

QString crossingText(Crossing crossing) {
  switch (crossing) {
    case Crossing::Free:
      return RehearsalText::tr("free");
    case Crossing::Outside:
      return RehearsalText::tr("outside of the map");
    case Crossing::Unknown:
      return RehearsalText::tr("unknown to the map");
    case Crossing::TooClose:
      return RehearsalText::tr("too close to a wall");
    case Crossing::Obstacle:
      return RehearsalText::tr("in an obstacle");
  }
  return {};
}

QString rehearsedText(const Rehearsed& way) {
  if (way.points == 0) return RehearsalText::tr("It has no position of the robot.");
  QStringList not_free, said;
  for (int i = kCrossings - 1; i > 0; --i) {
    const auto what = Crossing(i);
    for (const Stretch& stretch : way.stretches) {
      if (stretch.what != what) continue;
      not_free << RehearsalText::tr("%1 m %2").arg(words::fixed(way.lengths_m[std::size_t(i)], 2),
                                                   crossingText(what));
      break;
    }
  }
  const QString length = words::fixed(way.length_m, 1);
  said << (not_free.isEmpty()
               ? RehearsalText::tr("%1 m, all free.").arg(length)
               : RehearsalText::tr("%1 m. Not free: %2.").arg(length, words::listed(not_free)));
  const double away_m =
      way.lengths_m[std::size_t(Crossing::Outside)] + way.lengths_m[std::size_t(Crossing::Unknown)];
  if (away_m > way.length_m / 2)
    said << RehearsalText::tr("Most of it lies where this map knows nothing: it may be of another place.");
  said << reachText(way.reach);
  if (way.of_another) said << RehearsalText::tr("By what is recorded, it was driven on another map.");
  if (way.part == Rehearsed::Part::ByGround)
    said << RehearsalText::tr(
        "The robot was on several maps, and which of them is meant is not known: the part that fits best is "
        "rehearsed.");
  if (way.elsewhere_m > 0)
    said << RehearsalText::tr("Driven on another map, not rehearsed: %1 m.")
                .arg(words::fixed(way.elsewhere_m, 1));
  if (way.jumps > 0)
    said << RehearsalText::tr("Jumps and pauses, where the way is not known: %1.").arg(qint64(way.jumps));
  if (way.unusable > 0)
    said
        << RehearsalText::tr("Positions left out because they are no numbers: %1.").arg(qint64(way.unusable));
  return words::paragraph(said);
}

}  // namespace mapwright::carry
