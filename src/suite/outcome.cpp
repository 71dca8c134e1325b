#include "suite/outcome.h"

#include <utility>

#include <QCoreApplication>

#include "compare/comparison_sentence.h"
#include "compare/picture_view.h"
#include "sentences/plural.h"
#include "words/figures.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::suite {
namespace {

struct OutcomeText {
  Q_DECLARE_TR_FUNCTIONS(OutcomeText)
};

constexpr std::size_t kMostRows = 20;

}  // namespace

std::vector<ViewOutcome::ClusterRow> clusterRows(const compare::Comparison& comparison,
                                                 const std::optional<geometry::ViewTransform>& view,
                                                 const Explanation& explanation) {
  std::vector<ViewOutcome::ClusterRow> rows;
  for (const compare::Cluster& cluster : comparison.clusters) {
    if (rows.size() == kMostRows) break;
    ViewOutcome::ClusterRow row;
    const compare::PixelBox& box = cluster.box;
    row.box = OutcomeText::tr("%1 × %2 at %3, %4").arg(box.width).arg(box.height).arg(box.x).arg(box.y);
    row.size = QString::fromStdString(words::grouped(cluster.pixels));
    if (view) row.place = compare::placeText(compare::worldOf(*view, box).center());
    if (rows.size() < explanation.near.size()) {
      row.near = words::joined(explanation.near[rows.size()]);
      if (row.near.isEmpty() && explanation.everywhere.isEmpty())
        row.near = OutcomeText::tr("nothing that is known");
    }
    rows.push_back(row);
  }
  return rows;
}

QString ViewOutcome::Figure::words() const {
  if (before.isEmpty() || before == now) return OutcomeText::tr("%1 %2").arg(name, now);
  return OutcomeText::tr("%1 %2 -> %3").arg(name, before, now);
}

QStringList linesOf(const QString& head, const ViewOutcome& outcome) {
  constexpr qsizetype kMostPlaces = 3;
  const QString indent = QStringLiteral("  ");
  QStringList lines = outcome.sentence.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  for (const auto& [title, places] :
       {std::pair(OutcomeText::tr("The worst loop closures:"), &outcome.worst_closures),
        std::pair(OutcomeText::tr("The worst squares of 1 m:"), &outcome.worst_squares)}) {
    if (places->isEmpty()) continue;
    lines << title;
    for (const QString& place : places->mid(0, kMostPlaces)) lines << indent + place;
  }
  if (lines.isEmpty()) return {head};
  if (lines.size() == 1) return {QStringLiteral("%1. %2").arg(head, lines.first())};
  for (QString& line : lines) line.prepend(indent);
  lines.prepend(head);
  return lines;
}

Tally tallyOf(const std::vector<ViewOutcome>& outcomes) {
  Tally tally;
  for (const ViewOutcome& outcome : outcomes) {
    switch (outcome.verdict) {
      case Verdict::AsExpected:
        ++tally.as_expected;
        break;
      case Verdict::Differs:
        ++tally.differ;
        break;
      case Verdict::OverLimit:
        ++tally.over_limit;
        break;
      case Verdict::NotExpectedYet:
        ++tally.not_expected_yet;
        break;
      case Verdict::Failed:
        ++tally.failed;
        break;
    }
  }
  return tally;
}

QString tallyText(const Tally& tally) {
  using sentences::counted;
  using sentences::formOf;
  QStringList parts{counted(OutcomeText::tr("%1 views as expected", nullptr, formOf(tally.as_expected)),
                            tally.as_expected)};
  if (tally.differ > 0)
    parts << counted(OutcomeText::tr("%1 views differ", nullptr, formOf(tally.differ)), tally.differ);
  if (tally.over_limit > 0)
    parts << counted(OutcomeText::tr("%1 views are over a limit", nullptr, formOf(tally.over_limit)),
                     tally.over_limit);
  if (tally.not_expected_yet > 0)
    parts << counted(
        OutcomeText::tr("%1 views have no expected picture", nullptr, formOf(tally.not_expected_yet)),
        tally.not_expected_yet);
  if (tally.failed > 0)
    parts << counted(OutcomeText::tr("%1 views failed", nullptr, formOf(tally.failed)), tally.failed);
  return words::asSentence(words::listed(parts));
}

QString verdictText(Verdict verdict) {
  switch (verdict) {
    case Verdict::AsExpected:
      return OutcomeText::tr("as expected");
    case Verdict::Differs:
      return OutcomeText::tr("differs");
    case Verdict::OverLimit:
      return OutcomeText::tr("over a limit");
    case Verdict::NotExpectedYet:
      return OutcomeText::tr("not expected yet");
    case Verdict::Failed:
      break;
  }
  return OutcomeText::tr("failed");
}

}  // namespace mapwright::suite
