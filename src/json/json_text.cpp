#include "json/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

#include "json/faults.h"

namespace mapwright::json {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

int hexDigit(char c) {
  if (isDigit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// The four digits of \uXXXX; -1: they are none.
int codeUnit(std::string_view digits) {
  if (digits.size() < 4) return -1;
  int unit = 0;
  for (int i = 0; i < 4; ++i) {
    const int digit = hexDigit(digits[std::size_t(i)]);
    if (digit < 0) return -1;
    unit = unit * 16 + digit;
  }
  return unit;
}

void appendUtf8(std::string& out, char32_t code) {
  if (code < 0x80) {
    out += char(code);
  } else if (code < 0x800) {
    out += char(0xC0 | (code >> 6));
    out += char(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    out += char(0xE0 | (code >> 12));
    out += char(0x80 | ((code >> 6) & 0x3F));
    out += char(0x80 | (code & 0x3F));
  } else {
    out += char(0xF0 | (code >> 18));
    out += char(0x80 | ((code >> 12) & 0x3F));
    out += char(0x80 | ((code >> 6) & 0x3F));
    out += char(0x80 | (code & 0x3F));
  }
}

/// What stands between the quotes, decoded. It is known to be valid.
std::string decoded(std::string_view inner) {
  if (inner.find('\\') == std::string_view::npos) return std::string(inner);
  std::string out;
  out.reserve(inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != '\\') {
      out += inner[i];
      continue;
    }
    switch (const char escape = inner[++i]) {
      case 'b':
        out += '\b';
        break;
      case 'f':
        out += '\f';
        break;
      case 'n':
        out += '\n';
        break;
      case 'r':
        out += '\r';
        break;
      case 't':
        out += '\t';
        break;
      case 'u': {
        char32_t code = char32_t(codeUnit(inner.substr(i + 1)));
        i += 4;
        const bool paired = code >= 0xD800 && code < 0xDC00 && inner.substr(i + 1, 2) == "\\u";
        const int low = paired ? codeUnit(inner.substr(i + 3)) : -1;
        if (low >= 0xDC00 && low < 0xE000) {
          code = 0x10000 + ((code - 0xD800) << 10) + (char32_t(low) - 0xDC00);
          i += 6;
        }
        appendUtf8(out, code);
        break;
      }
      default:
        out += escape;
    }
  }
  return out;
}

/// Where the text stops being UTF-8 (RFC 3629); npos: nowhere.
std::size_t endOfUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const unsigned char first = static_cast<unsigned char>(text[i]);
    if (first < 0x80) {
      ++i;
      continue;
    }
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    if (first < 0xC2 || first > 0xF4 || i + std::size_t(more) >= text.size()) return i;
    char32_t code = first & (0x3F >> more);
    for (int k = 1; k <= more; ++k) {
      const unsigned char byte = static_cast<unsigned char>(text[i + std::size_t(k)]);
      if ((byte & 0xC0) != 0x80) return i;
      code = (code << 6) | (byte & 0x3F);
    }
    const bool shortest = more == 1 || (more == 2 && code >= 0x800) || (more == 3 && code >= 0x10000);
    if (!shortest || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return i;
    i += std::size_t(more) + 1;
  }
  return std::string_view::npos;
}

bool isWhole(std::string_view number) {
  return number.find_first_not_of("-0123456789") == std::string_view::npos;
}

std::string canonicalNumber(const JsonValue& value) {
  const std::string_view written = value.text();
  if (isWhole(written)) return written == "-0" ? "0" : std::string(written);
  const double number = value.number();
  if (!std::isfinite(number) || number == 0) return number == 0 ? "0" : std::string(written);
  constexpr double kExact = 9007199254740992;  // up to here doubles hold every whole number
  if (number == std::floor(number) && std::abs(number) <= kExact) return std::to_string(std::int64_t(number));
  char shortest[32];
  const auto end = std::to_chars(shortest, shortest + sizeof shortest, number).ptr;
  return std::string(shortest, end);
}

}  // namespace

/// Reads a text once, from its begin to its end.
class JsonReading {
 public:
  explicit JsonReading(JsonText& out) : out_(out), text_(out.text_) {}

  bool read() {
    if (text_.size() > JsonText::kLongest) return wrong(0, fault::TooLong);
    if (const std::size_t bad = endOfUtf8(text_); bad != std::string_view::npos)
      return wrong(bad, faultText("json", "the text is not UTF-8"));
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
    skipSpace();
    if (!value(0)) return false;
    skipSpace();
    return at_ == text_.size() || wrong(at_, faultText("json", "something follows the end of the JSON"));
  }

  JsonError error() const {
    JsonError error{bad_at_, 1, 1, why_};
    const std::string_view before = text_.substr(0, bad_at_);
    error.line = int(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::size_t line_begin = before.rfind('\n');
    error.column = int(bad_at_ - (line_begin == std::string_view::npos ? 0 : line_begin + 1)) + 1;
    return error;
  }

 private:
  bool wrong(std::size_t where, Fault why) {
    bad_at_ = std::min(where, text_.size());
    why_ = bad_at_ == text_.size() && !text_.empty() && !(why.code == fault::TooLong) ? Fault(fault::TextEnds)
                                                                                      : std::move(why);
    return false;
  }

  void skipSpace() {
    while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
  }
  bool next(char c) const { return at_ < text_.size() && text_[at_] == c; }
  bool took(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  bool value(int depth, std::size_t key_begin = 0, std::size_t key_end = 0) {
    if (depth > JsonText::kDeepest)
      return wrong(at_, faultText("json", "objects and lists are nested too deeply"));
    const std::size_t node = out_.nodes_.size();
    const std::size_t begin = at_;
    const bool escaped = text_.substr(key_begin, key_end - key_begin).find('\\') != std::string_view::npos;
    out_.nodes_.push_back({std::uint32_t(begin), 0, std::uint32_t(key_begin), std::uint32_t(key_end), 0,
                           JsonKind::Null, escaped});
    JsonKind kind = JsonKind::Null;
    if (!valueOf(depth, kind)) return false;
    JsonText::Node& made = out_.nodes_[node];
    made.kind = kind;
    made.end = std::uint32_t(at_);
    made.next = std::uint32_t(out_.nodes_.size());
    return true;
  }

  bool valueOf(int depth, JsonKind& kind) {
    if (next('{')) {
      kind = JsonKind::Object;
      return object(depth);
    }
    if (next('[')) {
      kind = JsonKind::Array;
      return list(depth);
    }
    if (next('"')) {
      kind = JsonKind::String;
      return string();
    }
    kind = JsonKind::Number;
    if (took("NaN") || took("Infinity") || took("-Infinity")) return true;
    if (at_ < text_.size() && (text_[at_] == '-' || isDigit(text_[at_]))) return number();
    kind = JsonKind::Null;
    if (took("null")) return true;
    kind = JsonKind::True;
    if (took("true")) return true;
    kind = JsonKind::False;
    return took("false") || wrong(at_, faultText("json", "a value is expected here"));
  }

  bool object(int depth) {
    ++at_;
    skipSpace();
    if (next('}')) return ++at_, true;
    for (;;) {
      skipSpace();
      if (!next('"'))
        return wrong(at_, faultText("json", "the name of a member is expected here, in quotes"));
      const std::size_t begin = at_;
      if (!string()) return false;
      const std::size_t end = at_;
      skipSpace();
      if (!next(':')) return wrong(at_, {fault::NoSign, {std::string(":")}});
      ++at_;
      skipSpace();
      if (!value(depth + 1, begin, end)) return false;
      skipSpace();
      if (next('}')) return ++at_, true;
      if (!next(',')) return wrong(at_, {fault::NoSign, {std::string(", }")}});
      ++at_;
    }
  }

  bool list(int depth) {
    ++at_;
    skipSpace();
    if (next(']')) return ++at_, true;
    for (;;) {
      skipSpace();
      if (!value(depth + 1)) return false;
      skipSpace();
      if (next(']')) return ++at_, true;
      if (!next(',')) return wrong(at_, {fault::NoSign, {std::string(", ]")}});
      ++at_;
    }
  }

  bool string() {
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') return ++at_, true;
      if (static_cast<unsigned char>(c) < 0x20) return wrong(at_, fault::BadString);
      if (c != '\\') continue;
      const char escape = ++at_ < text_.size() ? text_[at_] : '\0';
      if (escape == 'u') {
        if (codeUnit(text_.substr(at_ + 1)) < 0) return wrong(at_ - 1, fault::BadString);
        at_ += 4;
      } else if (escape == '\0' || !std::strchr("\"\\/bfnrt", escape)) {
        return wrong(at_ - 1, fault::BadString);
      }
    }
    return wrong(at_, fault::TextEnds);
  }

  bool digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
    return at_ > begin;
  }

  bool number() {
    const std::size_t begin = at_;
    if (next('-')) ++at_;
    if (next('0')) {
      ++at_;
    } else if (!digits()) {
      return wrong(begin, fault::BadNumber);
    }
    if (next('.')) {
      ++at_;
      if (!digits()) return wrong(begin, fault::BadNumber);
    }
    if (next('e') || next('E')) {
      ++at_;
      if (next('+') || next('-')) ++at_;
      if (!digits()) return wrong(begin, fault::BadNumber);
    }
    return (at_ == text_.size() || !std::isalnum(static_cast<unsigned char>(text_[at_]))) ||
           wrong(begin, fault::BadNumber);
  }

  JsonText& out_;
  std::string_view text_;
  std::size_t at_ = 0, bad_at_ = 0;
  Fault why_;
};

tl::expected<JsonText, JsonError> JsonText::read(std::string text) {
  JsonText out;
  out.text_ = std::move(text);
  JsonReading reading(out);
  if (!reading.read()) return tl::make_unexpected(reading.error());
  return out;
}

JsonText JsonText::of(const JsonValue& value) {
  const JsonText& from = *value.text_;
  const std::uint32_t first = value.node_, base = from.nodes_[first].begin;
  JsonText out;
  out.text_ = value.text();
  out.nodes_.assign(from.nodes_.begin() + first, from.nodes_.begin() + from.nodes_[first].next);
  out.nodes_[0].key_begin = out.nodes_[0].key_end = base;
  for (Node& node : out.nodes_) {
    for (std::uint32_t* const at : {&node.begin, &node.end, &node.key_begin, &node.key_end})
      *at -= std::min(*at, base);
    node.next -= first;
  }
  return out;
}

JsonText JsonText::rewritten(std::vector<Rewrite> rewrites) {
  std::sort(rewrites.begin(), rewrites.end(),
            [](const Rewrite& a, const Rewrite& b) { return a.value.node_ < b.value.node_; });
  const JsonText& from = *rewrites.front().value.text_;
  JsonText out;
  out.nodes_ = from.nodes_;
  out.text_.reserve(from.text_.size() + 16 * rewrites.size());
  std::vector<std::pair<std::size_t, std::uint32_t>> shifts{{0, 0}};  // from where on, by how much
  std::size_t copied = 0;
  for (const Rewrite& each : rewrites) {
    out.text_.append(from.text_, copied, each.value.begin() - copied).append(each.text);
    copied = each.value.end();
    shifts.emplace_back(copied, std::uint32_t(out.text_.size() - copied));  // may go below 0, and back
    out.nodes_[each.value.node_].kind = each.text.front() == '"' ? JsonKind::String : JsonKind::Number;
  }
  out.text_.append(from.text_, copied);
  for (Node& node : out.nodes_) {
    for (std::uint32_t* const at : {&node.begin, &node.end, &node.key_begin, &node.key_end}) {
      const auto after =
          std::upper_bound(shifts.begin(), shifts.end(), std::size_t(*at),
                           [](std::size_t offset, const auto& shift) { return offset < shift.first; });
      *at += std::prev(after)->second;
    }
  }
  return out;
}

Fault faultOf(const JsonError& error) {
  return {faultText("json", "line %1, column %2"),
          {std::int64_t(error.line), std::int64_t(error.column)},
          {error.reason}};
}

JsonKind JsonValue::kind() const { return text_->nodes_[node_].kind; }
std::size_t JsonValue::begin() const { return text_->nodes_[node_].begin; }
std::size_t JsonValue::end() const { return text_->nodes_[node_].end; }
std::size_t JsonValue::keyBegin() const { return text_->nodes_[node_].key_begin; }

std::string_view JsonValue::text() const {
  return std::string_view(text_->text_).substr(begin(), end() - begin());
}

std::string JsonValue::key() const {
  const JsonText::Node& node = text_->nodes_[node_];
  if (node.key_end == node.key_begin) return {};
  return decoded(
      std::string_view(text_->text_).substr(node.key_begin + 1, node.key_end - node.key_begin - 2));
}

std::string JsonValue::string() const {
  return kind() == JsonKind::String ? decoded(text().substr(1, text().size() - 2)) : std::string();
}

double JsonValue::number() const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (kind() != JsonKind::Number) return kNone;
  const std::string_view written = text();
  if (written == "NaN") return kNone;
  const bool negative = written.front() == '-';
  if (written.back() == 'y') return negative ? -HUGE_VAL : HUGE_VAL;
  double number = 0;
  const auto [end, problem] = std::from_chars(written.data(), written.data() + written.size(), number);
  if (problem != std::errc::result_out_of_range) return number;
  // Too large or too small: the sign of the exponent tells.
  const std::size_t exponent = written.find_first_of("eE");
  const bool tiny = exponent != std::string_view::npos && written[exponent + 1] == '-';
  return tiny ? 0 : negative ? -HUGE_VAL : HUGE_VAL;
}

std::vector<JsonValue> JsonValue::children() const {
  std::vector<JsonValue> children;
  const std::uint32_t end = text_->nodes_[node_].next;
  for (std::uint32_t child = node_ + 1; child < end; child = text_->nodes_[child].next)
    children.push_back({text_, child});
  return children;
}

std::optional<JsonValue> JsonValue::member(std::string_view name) const {
  if (!isObject()) return std::nullopt;
  std::optional<JsonValue> found;
  const std::uint32_t end = text_->nodes_[node_].next;
  for (std::uint32_t child = node_ + 1; child < end; child = text_->nodes_[child].next) {
    const JsonText::Node& node = text_->nodes_[child];
    const auto written =
        std::string_view(text_->text_).substr(node.key_begin + 1, node.key_end - node.key_begin - 2);
    if (node.key_escaped ? decoded(written) == name : written == name) found = JsonValue(text_, child);
  }
  return found;
}

std::vector<std::pair<std::string, JsonValue>> membersOf(const JsonValue& object) {
  std::vector<std::pair<std::string, JsonValue>> members;
  const std::vector<JsonValue> children = object.children();
  members.reserve(children.size());
  for (const JsonValue& child : children) members.emplace_back(child.key(), child);
  std::sort(members.begin(), members.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.begin() > b.second.begin();
  });
  const auto isSameName = [](const auto& a, const auto& b) { return a.first == b.first; };
  members.erase(std::unique(members.begin(), members.end(), isSameName), members.end());
  return members;
}

std::string canonical(const JsonValue& value) {
  switch (value.kind()) {
    case JsonKind::Number:
      return canonicalNumber(value);
    case JsonKind::String:
      return quoted(value.string());
    case JsonKind::Array: {
      std::string list = "[";
      for (const JsonValue& element : value.children()) list += canonical(element) + ',';
      return list + ']';
    }
    case JsonKind::Object: {
      std::string object = "{";
      for (const auto& [name, member] : membersOf(value))
        object += quoted(name) + ':' + canonical(member) + ',';
      return object + '}';
    }
    default:
      return std::string(value.text());
  }
}

bool sameValue(const JsonValue& a, const JsonValue& b) {
  if (a.text() == b.text()) return true;
  if (a.kind() != b.kind()) return false;
  switch (a.kind()) {
    case JsonKind::Number:
      // Doubles that are the same may still be whole numbers that differ.
      return a.number() == b.number() && canonicalNumber(a) == canonicalNumber(b);
    case JsonKind::String:
      return a.string() == b.string();
    case JsonKind::Array: {
      const std::vector<JsonValue> left = a.children(), right = b.children();
      return std::equal(left.begin(), left.end(), right.begin(), right.end(), sameValue);
    }
    case JsonKind::Object: {
      const auto left = membersOf(a), right = membersOf(b);
      return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                        [](const auto& one, const auto& other) {
                          return one.first == other.first && sameValue(one.second, other.second);
                        });
    }
    default:
      return true;
  }
}

std::string quoted(std::string_view plain) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const char c = plain[i];
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(plain[at]); };
    if (byte(i) == 0xED && i + 2 < plain.size() && byte(i + 1) >= 0xA0) {
      // Half a surrogate pair, as string() gives it: only an escape can stand for it.
      const unsigned half = 0xD000u | (byte(i + 1) & 0x3Fu) << 6 | (byte(i + 2) & 0x3Fu);
      out += "\\u";
      for (int shift = 12; shift >= 0; shift -= 4) out += kHex[half >> shift & 0xF];
      i += 2;
    } else if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += "\\u00";
      out += kHex[(c >> 4) & 0xF];
      out += kHex[c & 0xF];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string withMember(const JsonValue& object, std::string_view name, std::string_view value) {
  std::string text(object.text());
  const std::size_t start = object.begin();
  if (const auto old = object.member(name)) {
    text.replace(old->begin() - start, old->end() - old->begin(), value);
    return text;
  }
  const auto members = object.children();
  if (members.empty()) {
    text.insert(1, quoted(name) + ": " + std::string(value));
    return text;
  }
  // What stands before the last name (or between the brace and the only one) is repeated.
  const JsonValue& last = members.back();
  const std::size_t before = members.size() > 1 ? members[members.size() - 2].end() - start : 0;
  const std::string gap = text.substr(before, last.keyBegin() - start - before);
  const std::string colon = text.substr(last.keyBegin() - start, last.begin() - last.keyBegin());
  const std::size_t sign = colon.rfind(':');
  text.insert(last.end() - start, (members.size() > 1 ? gap : "," + gap.substr(1)) + quoted(name) +
                                      colon.substr(sign) + std::string(value));
  return text;
}

std::string withoutMember(const JsonValue& object, std::string_view name) {
  std::string text(object.text());
  const auto members = object.children();
  const auto found = std::find_if(members.begin(), members.end(),
                                  [name](const JsonValue& member) { return member.key() == name; });
  if (found == members.end()) return text;
  // The comma before it goes, too; with the first one the comma after it.
  const bool first = found == members.begin(), only = members.size() == 1;
  const std::size_t from = first ? found->keyBegin() : std::prev(found)->end();
  const std::size_t to = first && !only ? std::next(found)->keyBegin() : found->end();
  text.erase(from - object.begin(), to - from);
  const auto rest = JsonText::read(text);
  return rest && rest->root().member(name) ? withoutMember(rest->root(), name) : text;
}

}  // namespace mapwright::json
