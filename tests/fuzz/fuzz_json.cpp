// JSON as a tree over its own bytes, and the edits of it.
#include "json/json_text.h"
#include "target.h"

namespace mapwright::fuzz::json {
namespace {

using mapwright::json::JsonKind;
using mapwright::json::JsonText;
using mapwright::json::JsonValue;

std::size_t walk(const JsonValue& value, int depth = 0) {
  MUST(depth <= JsonText::kDeepest + 1);
  std::size_t sum = value.string().size() + value.key().size();
  if (value.kind() == JsonKind::Number) sum += value.number() > 0 ? 1 : 0;
  for (const JsonValue& child : value.children()) sum += walk(child, depth + 1);
  return sum;
}

void edit(const JsonValue& object) {
  const auto with = JsonText::read(withMember(object, "k\"\n", "[1]"));
  MUST(with && with->root().member("k\"\n"));
  MUST(with->root().member("k\"\n")->text() == "[1]");
  const auto without = JsonText::read(withoutMember(with->root(), "k\"\n"));
  MUST(without && !without->root().member("k\"\n"));
  const auto children = object.children();
  if (children.empty()) return;
  const std::string key = children.front().key();
  const auto gone = JsonText::read(withoutMember(object, key));
  MUST(gone && !gone->root().member(key));
  const auto set = JsonText::read(withMember(object, key, "7"));
  MUST(set && set->root().member(key));
  MUST(set->root().member(key)->text() == "7");
}

void read(Input input) {
  const std::string text = textOf(input);
  const auto whole = JsonText::read(text);
  if (!whole) {
    MUST(whole.error().offset <= text.size());
    use(faultOf(whole.error()));
    return;
  }
  MUST(whole->text() == text);
  use(walk(whole->root()));
  const std::string meaning = canonical(whole->root());
  const JsonText part = JsonText::of(whole->root());
  MUST(part.text() == whole->root().text());
  MUST(canonical(part.root()) == meaning);
  const auto again = JsonText::read(part.text());
  MUST(again && canonical(again->root()) == meaning);
  if (whole->root().isObject()) edit(whole->root());
}

}  // namespace
}  // namespace mapwright::fuzz::json

MAPWRIGHT_FUZZ_TARGET(json)
