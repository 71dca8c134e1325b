// The facts that are kept beside an expected picture.
#include "suite/facts.h"
#include "target.h"

namespace mapwright::fuzz::facts {
namespace {

using namespace suite;

void read(Input input) {
  const std::string text = textOf(input);
  const auto facts = factsFrom(QByteArray(text.data(), qsizetype(text.size())));
  if (!facts) return;
  const QByteArray bytes = factsBytes(*facts);
  const auto again = factsFrom(bytes);
  MUST(again);
  MUST(factsBytes(*again) == bytes);
}

}  // namespace
}  // namespace mapwright::fuzz::facts

MAPWRIGHT_FUZZ_TARGET(facts)
