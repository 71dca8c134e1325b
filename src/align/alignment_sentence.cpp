#include "align/alignment_sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include "words/decimal.h"
#include "words/listed.h"

namespace mapwright::align {
namespace {

struct AlignmentText {
  Q_DECLARE_TR_FUNCTIONS(AlignmentText)
};

QString figure(double value, int digits) { return QLocale::c().toString(value, 'f', digits); }
QString percent(double share) { return figure(share * 100, 0); }

/// What does not fit with the rest; empty when all does.
QString partText(const Agreement& agreement) {
  if (!agreement.part) return {};
  return AlignmentText::tr("A part lies %1 cm beside, near (%2, %3) of the new map: look there.")
      .arg(figure(agreement.part->off_m * 100, 0), figure(agreement.part->middle_m.x(), 1),
           figure(agreement.part->middle_m.y(), 1));
}

/// How sure it is that this is the same floor; empty when nothing speaks against it.
QString furnitureText(const Furniture& furniture) {
  if (!furniture.mostDiffers()) return {};
  return AlignmentText::tr(
             "Of %1 pieces of furniture %2 stand where they stood: much was moved, or it "
             "is another floor of the "
             "same shape.")
      .arg(furniture.pieces)
      .arg(furniture.again);
}

QString pairHint(const Alignment& alignment) {
  return alignment.pair_residuals_m.empty()
             ? AlignmentText::tr("Give one point that is on both maps; it decides between the candidates.")
             : AlignmentText::tr("Give a second point, far from the first.");
}

/// Why nothing is chosen; empty when something is.
QString doubtText(const Alignment& alignment) {
  switch (alignment.doubt) {
    case Doubt::None:
      return {};
    case Doubt::NoWalls:
      return AlignmentText::tr("One of the maps has no walls, so there is nothing to align by.");
    case Doubt::NoOverlap:
      return alignment.pair_residuals_m.empty()
                 ? AlignmentText::tr(
                       "The walls of these maps fit nowhere: they seem to be of different places.")
                 : AlignmentText::tr("With that pair of points the walls fit nowhere. Check the points.");
    case Doubt::Bent:
      return AlignmentText::tr(
          "In many places the walls fit a little beside: one of the maps is bent, or much was "
          "moved. Two points that are on both maps align them by hand, as well as it goes.");
    case Doubt::Poor:
      if (!alignment.pair_residuals_m.empty())
        return AlignmentText::tr("With that pair of points the walls do not agree. Check the points.");
      return AlignmentText::tr(
          "The walls do not agree well enough anywhere: the maps may be of different "
          "places. Two points that are on both maps align them by hand.");
    case Doubt::LittleSeen:
      return AlignmentText::tr(
          "Too little of the maps overlaps to be sure. Two points that are on both maps "
          "align them by hand.");
    case Doubt::Ambiguous:
      return AlignmentText::tr("The maps fit in more than one way, about equally well. %1")
          .arg(pairHint(alignment));
    case Doubt::Loose:
      return AlignmentText::tr(
          "It is about right, but the walls that both maps show do not hold it to 5 cm and 0.3 degrees. Two "
          "points that are on both maps align them by hand.");
    case Doubt::OtherFloor:
      return AlignmentText::tr(
          "The walls agree, but almost no furniture does: it may be another floor of the same shape. If "
          "you know that it is not, give one point that is on both maps.");
    case Doubt::Slides:
      return AlignmentText::tr(
                 "The maps can be moved against each other and still fit, as along a corridor. "
                 "%1")
          .arg(pairHint(alignment));
    case Doubt::Mirrored:
      return AlignmentText::tr("One of the maps seems to be mirrored, or they are of different places.");
    case Doubt::PairsDisagree:
      return AlignmentText::tr(
          "The pairs of points contradict each other: the distances between them are not the same on both "
          "maps.");
    case Doubt::PairsTooClose:
      return AlignmentText::tr(
          "The points lie too close together to tell the turn. Give points that are some metres apart.");
    case Doubt::PairsAgainstWalls:
      return AlignmentText::tr(
          "With these pairs of points the walls agree no better than by chance. Check the points.");
  }
  return {};
}

}  // namespace

QString transformText(const geometry::Pose2& transform) {
  return AlignmentText::tr("x %1 m, y %2 m, turned by %3°")
      .arg(figure(transform.x_m, 3), figure(transform.y_m, 3),
           figure(geometry::degreesFromRadians(transform.yaw_rad), 2));
}

QString scoreText(const Candidate& candidate) { return figure(candidate.score, 2); }

QString overlapText(const Agreement& agreement) {
  return AlignmentText::tr("%1 % of the smaller map").arg(percent(agreement.overlap));
}

QString distancesText(const WallDistances& distances) {
  return AlignmentText::tr("%1 % within 10 cm, median %2 m, 95 % within %3 m, largest %4 m (%5 % compared)")
      .arg(figure(distances.within_10cm * 100, 1), words::decimal(distances.median_m, 3),
           words::decimal(distances.p95_m, 3), words::decimal(distances.max_m, 3),
           percent(distances.seen_share));
}

QString offText(const Agreement& agreement) {
  if (agreement.off.empty()) return {};
  const OffSquare& worst = agreement.off.front();
  return AlignmentText::tr(
             "In %1 of %2 squares of %3 m the walls are off by more than %4 cm, most at (%5, %6) "
             "of the new map: by %7 m. Something was moved there, or a map is bent.")
      .arg(agreement.off.size())
      .arg(agreement.squares)
      .arg(figure(kSquare_m, 0), figure(kOff_m * 100, 0), figure(worst.middle_m.x(), 1),
           figure(worst.middle_m.y(), 1), figure(worst.off_m, 2));
}

QString alignmentText(const Alignment& alignment) {
  if (!alignment.sure()) return AlignmentText::tr("Not sure. %1").arg(doubtText(alignment));
  const QString share = words::paragraph(
      {AlignmentText::tr("%1 % of the old map's walls have a wall of the new map within 10 cm.")
           .arg(percent(alignment.agreement.forward.within_10cm)),
       partText(alignment.agreement), furnitureText(alignment.furniture)});
  if (alignment.pair_residuals_m.empty())
    return AlignmentText::tr("Sure: the maps fit in one way only. %1").arg(share);
  if (alignment.pair_residuals_m.size() == 1) {
    return AlignmentText::tr("Chosen by the pair of points, which is %1 m off. %2")
        .arg(figure(alignment.pair_residuals_m.front(), 2), share);
  }
  if (alignment.agreement.forward.seen_share == 0)
    return AlignmentText::tr(
        "Aligned by the pairs of points. The maps do not overlap, so no wall confirms it.");
  return AlignmentText::tr("Aligned by the pairs of points. %1").arg(share);
}

}  // namespace mapwright::align
