#include "suite/judgement.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "compare/comparison_sentence.h"
#include "disk/read_file.h"
#include "sentences/fault_sentence.h"
#include "suite/facts_changes.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::suite {
namespace {

struct JudgementText {
  Q_DECLARE_TR_FUNCTIONS(JudgementText)
};

constexpr std::size_t kMostFactsBytes = std::size_t(64) << 20;

}  // namespace

Judgement judge(const QStringList& accepted, const QString& actual, const compare::Allowed& allowed) {
  Judgement best;
  for (const QString& picture : accepted) {
    auto made = compare::comparePictures(picture.toStdString(), actual.toStdString(), allowed);
    if (!made) {
      best.verdict = Verdict::Failed;
      best.sentence = sentences::sentenceOf(made.error());
      return best;
    }
    const bool nearer = !best.comparison || made->equal || made->differing < best.comparison->differing;
    if (!nearer) continue;
    best.verdict = made->equal ? Verdict::AsExpected : Verdict::Differs;
    best.expected = picture;
    best.comparison = std::move(*made);
    if (best.verdict == Verdict::AsExpected) break;
  }
  return best;
}

QString factsBeside(const QString& picture) { return picture.chopped(4) + QStringLiteral(".json"); }

tl::expected<Facts, QString> factsIn(const QString& path) {
  const auto bytes = disk::readFile(path.toStdString(), kMostFactsBytes);
  if (!bytes) return tl::make_unexpected(sentences::sentenceOf(bytes.error().cause));
  return factsFrom(QByteArray::fromStdString(*bytes));
}

std::optional<Facts> expectedFacts(const Judgement& judgement) {
  if (judgement.expected.isEmpty()) return std::nullopt;
  auto facts = factsIn(factsBeside(judgement.expected));
  const bool of_it = facts && (facts->picture.empty() || facts->picture == sumOf(judgement.expected));
  return of_it ? std::optional(std::move(*facts)) : std::nullopt;
}

void explain(const Judgement& judgement, const Facts& facts, ViewOutcome& outcome) {
  const compare::Comparison& comparison = *judgement.comparison;
  Explanation explanation;
  QString why = words::asSentence(compare::clustersText(comparison, facts.view));
  const QString kept = factsBeside(judgement.expected);
  if (QFileInfo::exists(kept)) {
    const auto before = factsIn(kept);
    if (before && !before->picture.empty() && before->picture != sumOf(judgement.expected)) {
      why = words::paragraph(
          {why, JudgementText::tr("The facts beside %1 are of another picture.").arg(judgement.expected)});
    } else if (before && facts.view) {
      explanation = explained(comparison, *facts.view, changesBetween(*before, facts));
      why = explanationText(comparison, *facts.view, explanation);
    } else if (!before) {
      why = words::paragraph({why, words::about(kept, before.error())});
    }
  }
  outcome.sentence = words::paragraph(
      {compare::sizesText(comparison), why, words::asSentence(compare::amountText(comparison))});
  outcome.clusters = clusterRows(comparison, facts.view, explanation);
  outcome.clusters_in_all = comparison.clusters_in_all;
  outcome.everywhere = explanation.everywhere;
  outcome.somewhere = explanation.somewhere;
  outcome.elsewhere = explanation.elsewhere;
}

}  // namespace mapwright::suite
