#include "regions/region_sentence.h"

#include <QCoreApplication>

#include "sentences/failure_sentence.h"

namespace mapwright::regions {
namespace {

class RegionsText {
  Q_DECLARE_TR_FUNCTIONS(Regions)
};

QString misfitSentence(Misfit misfit) {
  switch (misfit) {
    case Misfit::None:
      break;
    case Misfit::Unusable:
      return RegionsText::tr("The answer does not say where it is, or how large its cells are.");
    case Misfit::FewerCells:
      return RegionsText::tr("The answer has fewer cells than it should.");
    case Misfit::OtherFrame:
      return RegionsText::tr("The answer is in another frame than the regions before it.");
    case Misfit::TooLarge:
      return RegionsText::tr("The answer is far larger than the requested region, and was ignored.");
  }
  return {};
}

}  // namespace

QString sentenceOf(const RegionTrouble& trouble) {
  using Kind = RegionTrouble::Kind;
  switch (trouble.kind) {
    case Kind::None:
      break;
    case Kind::Failed:
      return QString::fromStdString(sentences::sentenceOf(trouble.failure));
    case Kind::Elsewhere:
      return RegionsText::tr("The robot answered with another region.");
    case Kind::Misplaced:
      return misfitSentence(trouble.misfit);
  }
  return {};
}

}  // namespace mapwright::regions
