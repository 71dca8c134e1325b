#include "sentences/region_sentence.h"

#include <QCoreApplication>

#include "sentences/failure_sentence.h"

namespace mapwright::sentences {
namespace {

class RegionsText {
  Q_DECLARE_TR_FUNCTIONS(Regions)
};

QString misfitSentence(regions::Misfit misfit) {
  using regions::Misfit;
  switch (misfit) {
    case Misfit::None:
      break;
    case Misfit::Unusable:
      return RegionsText::tr("What came does not say where it lies, or how large its cells are.");
    case Misfit::FewerCells:
      return RegionsText::tr("What came has fewer cells than it says.");
    case Misfit::OtherFrame:
      return RegionsText::tr("What came lies in another frame than the regions before it.");
    case Misfit::TooLarge:
      return RegionsText::tr("What came is far larger than what was asked for, and was not taken.");
  }
  return {};
}

}  // namespace

QString sentenceOf(const regions::RegionTrouble& trouble) {
  using Kind = regions::RegionTrouble::Kind;
  switch (trouble.kind) {
    case Kind::None:
      break;
    case Kind::Failed:
      return QString::fromStdString(sentenceOf(trouble.failure));
    case Kind::Elsewhere:
      return RegionsText::tr("The robot answered with another region.");
    case Kind::Misplaced:
      return misfitSentence(trouble.misfit);
  }
  return {};
}

}  // namespace mapwright::sentences
