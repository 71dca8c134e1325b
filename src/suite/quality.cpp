#include "suite/quality.h"

#include <cmath>

#include <QCoreApplication>

#include "compare/comparison_sentence.h"
#include "geometry/pose.h"
#include "sentences/plural.h"
#include "words/decimal.h"
#include "words/figures.h"
#include "words/listed.h"

namespace mapwright::suite {
namespace {

struct QualityText {
  Q_DECLARE_TR_FUNCTIONS(Quality)
};

constexpr qsizetype kMostListed = 20, kMostSubmaps = 8;
constexpr int kDecimals = 4;

QString metresText(double value) { return QualityText::tr("%1 m").arg(words::decimal(value, kDecimals)); }
QString percentText(double share) {
  return QualityText::tr("%1 %").arg(words::decimal(100 * share, kDecimals));
}
QString countText(std::int64_t value) { return QString::fromStdString(words::grouped(value)); }

QString closureText(const map::Closure& closure) {
  return QualityText::tr("%1 and %2°: submap %3, node %4 at %5, by the closure at %6")
      .arg(metresText(closure.residual_m),
           words::decimal(geometry::degreesFromRadians(closure.residual_rad), 2),
           QString::fromStdString(map::toText(closure.submap)),
           QString::fromStdString(map::toText(closure.node)), compare::placeText(closure.at),
           compare::placeText(closure.expected));
}

QString squareText(const Examined::Square& square) {
  QStringList submaps;
  for (const map::SubmapId id : square.submaps) {
    if (submaps.size() == kMostSubmaps) break;
    submaps << QString::fromStdString(map::toText(id));
  }
  if (std::size_t(submaps.size()) < square.submaps.size()) submaps << QStringLiteral("…");
  return sentences::counted(
             QualityText::tr("%1 cells at %2, submaps %3", nullptr, sentences::formOf(square.cells)),
             square.cells)
      .arg(compare::placeText(square.center_m), submaps.join(QLatin1Char(' ')));
}

std::vector<ViewOutcome::Figure> figuresOf(const Facts& now, const Facts& before, const Quality& limits) {
  std::vector<ViewOutcome::Figure> figures;
  const auto adding = [&figures](const auto& is, const auto& was) {
    return [&figures, &is, &was](const QString& name, const auto& textOf, const QString& limit = {}) {
      figures.push_back({name, was ? textOf(*was) : QString(), textOf(*is), limit});
    };
  };
  if (now.closures && limits.closures_over_m) {
    const auto add = adding(now.closures, before.closures);
    const auto largest = [](const ClosuresFact& of) {
      return of.largest_m ? metresText(*of.largest_m) : QualityText::tr("none");
    };
    const int least = limits.closures_at_least;
    add(
        QualityText::tr("loop closures"), [](const ClosuresFact& of) { return countText(of.inter); },
        least > 0 ? QualityText::tr("at least %1").arg(countText(least)) : QString());
    add(QualityText::tr("largest residual"), largest, metresText(*limits.closures_over_m));
  }
  if (now.disagreement && limits.disagreement_over) {
    using Fact = DisagreementFact;
    const auto add = adding(now.disagreement, before.disagreement);
    const auto share = [](const Fact& of) { return percentText(of.share()); };
    add(QualityText::tr("share"), share, percentText(*limits.disagreement_over));
    add(QualityText::tr("contradicted cells"),
        [](const Fact& of) { return countText(of.contradicted_cells); });
    add(QualityText::tr("occupied cells"), [](const Fact& of) { return countText(of.occupied_cells); });
    add(QualityText::tr("tolerance in cells"), [](const Fact& of) { return countText(of.tolerance_cells); });
  }
  return figures;
}

/// A sentence if the limit is not held.
QString judgeClosures(double limit_m, const map::Closures& closures, ViewOutcome& outcome) {
  if (const std::size_t unjudged = closures.dangling + closures.without_pose; unjudged > 0)
    outcome.figures.push_back(
        {QualityText::tr("constraints that could not be judged"), {}, countText(std::int64_t(unjudged)), {}});
  std::int64_t over = 0;
  for (const map::Closure& closure : closures.ranked) {
    if (!(closure.residual_m > limit_m)) break;
    if (closure.kind != map::ConstraintKind::Inter) continue;
    if (++over <= kMostListed) outcome.worst_closures << closureText(closure);
  }
  if (over == 0) return {};
  return QualityText::tr("Loop closures that contradict the finished map by more than %1: %2 of %3.")
      .arg(metresText(limit_m), countText(over), countText(std::int64_t(closures.inter)));
}

/// A sentence if the limit is not held.
QString judgeDisagreement(double limit, const Examined& examined, ViewOutcome& outcome) {
  const double share = examined.disagreement->share();
  if (!(share > limit)) return {};
  for (const Examined::Square& square : examined.squares) {
    if (outcome.worst_squares.size() == kMostListed) break;
    outcome.worst_squares << squareText(square);
  }
  return QualityText::tr("Submaps contradict each other in %1 of the occupied cells, more than %2.")
      .arg(percentText(share), percentText(limit));
}

}  // namespace

void addFigures(const Examined& examined, Facts& facts) {
  if (const map::Closures* const closures = examined.closures.get()) {
    facts.closures = ClosuresFact{std::int64_t(closures->inter), {}};
    for (const map::Closure& closure : closures->ranked) {
      if (closure.kind != map::ConstraintKind::Inter) continue;
      facts.closures->largest_m = std::round(closure.residual_m * 1e4) / 1e4;
      break;
    }
  }
  facts.disagreement = examined.disagreement;
}

void judgeQuality(const Quality& limits, const Examined& examined, const std::optional<Facts>& before,
                  ViewOutcome& outcome) {
  Facts now;
  addFigures(examined, now);
  outcome.figures = figuresOf(now, before.value_or(Facts()), limits);
  QStringList over;
  if (limits.closures_over_m && examined.closures) {
    over << judgeClosures(*limits.closures_over_m, *examined.closures, outcome);
    if (const auto inter = std::int64_t(examined.closures->inter); inter < limits.closures_at_least)
      over << QualityText::tr("Loop closures: %1, at least %2 are wanted.")
                  .arg(countText(inter), countText(limits.closures_at_least));
  }
  if (limits.disagreement_over && examined.disagreement)
    over << judgeDisagreement(*limits.disagreement_over, examined, outcome);
  over.removeAll(QString());
  if (outcome.verdict == Verdict::AsExpected && !over.isEmpty()) outcome.verdict = Verdict::OverLimit;
  if (outcome.verdict == Verdict::AsExpected && !examined.lacks.isEmpty()) outcome.verdict = Verdict::Failed;
  QStringList told = examined.lacks + over, figures;
  if (limits.closures_over_m && limits.closures_at_least == 0 && examined.closures &&
      examined.closures->inter == 0)
    told << QualityText::tr("No loop was closed, so there is nothing to hold against the limit of %1.")
                .arg(metresText(*limits.closures_over_m));
  for (const ViewOutcome::Figure& figure : outcome.figures) figures << figure.words();
  if (!figures.isEmpty()) told << QualityText::tr("SLAM session: %1.").arg(words::listed(figures));
  if (!outcome.sentence.isEmpty()) told.prepend(outcome.sentence);
  outcome.sentence = told.join(QLatin1Char('\n'));
}

}  // namespace mapwright::suite
