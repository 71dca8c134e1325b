#include "sentences/problem_sentence.h"

#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"

namespace mapwright::sentences {

QString sentenceOf(const map::Problem& problem) {
  if (problem.reason.any() || !problem.request) return wordsOf(problem.reason);
  return QString::fromStdString(sentenceOf(*problem.request));
}

QString sentenceOf(const std::optional<map::Problem>& problem) {
  return problem ? sentenceOf(*problem) : QString();
}

}  // namespace mapwright::sentences
