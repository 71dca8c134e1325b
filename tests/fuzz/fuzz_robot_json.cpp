// The nearly-JSON of robots. What reads their messages and what keeps their overlays to the byte find the
// same values.
#include <algorithm>

#include <simdjson.h>

#include "json/json_text.h"
#include "robot/wire/read_json.h"
#include "target.h"

namespace mapwright::fuzz::robot_json {
namespace {

using namespace robot::wire;
using json::JsonKind;
using json::JsonText;
using json::JsonValue;

void mustAgree(const Json& read, const JsonValue& kept) {
  switch (read.type()) {
    case simdjson::dom::element_type::ARRAY: {
      MUST(kept.isArray());
      const auto items = kept.children();
      std::size_t at = 0;
      for (const Json item : JsonList(read)) {
        MUST(at < items.size());
        mustAgree(item, items[at++]);
      }
      MUST(at == items.size());
      break;
    }
    case simdjson::dom::element_type::OBJECT: {
      MUST(kept.isObject());
      const auto members = kept.children();
      std::size_t at = 0;
      for (const auto [name, value] : simdjson::dom::object(read)) {
        MUST(at < members.size() && members[at].key() == name);
        mustAgree(value, members[at++]);
      }
      MUST(at == members.size());
      break;
    }
    case simdjson::dom::element_type::STRING:
      MUST(kept.kind() == JsonKind::String && kept.string() == std::string_view(read));
      break;
    case simdjson::dom::element_type::BOOL:
      MUST(kept.kind() == (bool(read) ? JsonKind::True : JsonKind::False));
      break;
    case simdjson::dom::element_type::NULL_VALUE:  // also a number that a double cannot hold
      MUST(kept.kind() == JsonKind::Null || kept.kind() == JsonKind::Number);
      break;
    default:
      MUST(kept.kind() == JsonKind::Number && kept.number() == double(read));
  }
}

void read(Input input) {
  const std::string text = textOf(input);
  const auto open = [](char c) { return c == '[' || c == '{'; };
  if (std::count_if(text.begin(), text.end(), open) > JsonText::kDeepest) return;
  JsonReader reader, digits;
  const auto read = reader.read(text);
  const auto kept = JsonText::read(text);
  if (read && kept) mustAgree(*read, kept->root());
  if (read) MUST(digits.readKeepingDigits(text));
  // The tree reads all that is JSON; the other all that the tree reads, but for half surrogates and what is
  // no UTF-8.
  simdjson::dom::parser strict;
  if (strict.parse(text).error() == simdjson::SUCCESS) MUST(kept);
  if (kept && simdjson::validate_utf8(text) && text.find("\\u") == std::string::npos) MUST(read);
}

}  // namespace
}  // namespace mapwright::fuzz::robot_json

MAPWRIGHT_FUZZ_TARGET(robot_json)
