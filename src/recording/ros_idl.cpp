#include "recording/ros_idl.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mapwright::recording {
namespace {

using IdlFault = RosSchemaFault;

constexpr std::size_t kLongestIdl = std::size_t(1) << 20;
constexpr std::size_t kMostIdlStructs = 1000, kMostIdlMembers = 10'000, kDeepestIdl = 32;
// Of a name with all its modules: every member keeps those that it stands in.
constexpr std::size_t kLongestIdlName = 255;

struct Token {
  enum class Kind : std::uint8_t { End, Word, Number, Text, Mark } kind = Kind::End;
  std::string_view text;
  std::size_t line = 1;
};

bool isWordChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Words, numbers, texts and marks; comments, directives and the lines between files are left out.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) { advance(); }
  const Token& now() const { return now_; }
  Token take() {
    const Token taken = now_;
    advance();
    return taken;
  }
  bool is(std::string_view text) const { return now_.kind != Token::Kind::Text && now_.text == text; }
  bool skipIf(std::string_view text) {
    const bool is_it = is(text);
    if (is_it) advance();
    return is_it;
  }

 private:
  void advance() {
    skip();
    now_ = {Token::Kind::End, {}, line_};
    if (at_ >= text_.size()) return;
    const std::size_t from = at_;
    const char c = text_[at_];
    if (c == '"' || c == '\'') {
      for (++at_; at_ < text_.size() && text_[at_] != c; ++at_) {
        if (text_[at_] == '\\') ++at_;
        if (at_ < text_.size() && text_[at_] == '\n') ++line_;
      }
      at_ = std::min(at_ + 1, text_.size());
      now_ = {Token::Kind::Text, text_.substr(from, at_ - from), now_.line};
    } else if (isWordChar(c)) {
      const bool number = c >= '0' && c <= '9';
      while (at_ < text_.size() && (isWordChar(text_[at_]) || (number && text_[at_] == '.'))) ++at_;
      now_ = {number ? Token::Kind::Number : Token::Kind::Word, text_.substr(from, at_ - from), now_.line};
    } else {
      at_ += text_.substr(at_).starts_with("::") ? 2 : 1;
      now_ = {Token::Kind::Mark, text_.substr(from, at_ - from), now_.line};
    }
  }

  void skip() {
    bool at_line_start = at_ == 0;
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      const char c = rest.front();
      if (c == '\n') {
        ++line_;
        ++at_;
        at_line_start = true;
      } else if (c == ' ' || c == '\t' || c == '\r') {
        ++at_;
      } else if (rest.starts_with("//") ||
                 (at_line_start && (c == '#' || rest.starts_with("===") || rest.starts_with("IDL:")))) {
        at_ += std::min(rest.find('\n'), rest.size());
      } else if (rest.starts_with("/*")) {
        const std::size_t end = std::min(rest.find("*/", 2), rest.size() - 2) + 2;
        line_ += std::size_t(std::count(rest.begin(), rest.begin() + std::ptrdiff_t(end), '\n'));
        at_ += end;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
  Token now_;
};

/// The type of a member: built in, or by its name.
struct IdlType {
  RosField field;    // without its name
  std::string name;  // of Nested, "a::b::C"
  std::string scope;
  std::size_t line = 0;
};
struct IdlStruct {
  std::vector<std::pair<std::string, IdlType>> members;
};

/// "a::b::C" is "a/C", as ROS names it.
std::string rosNameOf(const std::string& scoped) {
  const std::size_t first = scoped.find("::"), last = scoped.rfind("::");
  if (first == std::string::npos) return scoped;
  return scoped.substr(0, first) + '/' + scoped.substr(last + 2);
}

class IdlReader {
 public:
  explicit IdlReader(std::string_view text) : in_(text) {}

  std::optional<IdlFault> read() {
    while (in_.now().kind != Token::Kind::End && !fault_) declaration({}, 0);
    return fault_;
  }

  tl::expected<RosSchema, IdlFault> link(std::string_view name) {
    const std::string wanted = plainOf(name);
    for (const auto& [scoped, found] : structs_) {
      if (rosNameOf(scoped) != wanted) continue;
      if (auto fault = add(scoped, 0)) return tl::unexpected(std::move(*fault));
      return std::move(schema_);
    }
    return tl::unexpected(IdlFault{IdlFault::Code::UnknownType, 0, wanted});
  }

 private:
  static std::string plainOf(std::string_view name) {
    const std::size_t first = name.find('/'), last = name.rfind('/');
    if (first == std::string_view::npos || first == last) return std::string(name);
    return std::string(name.substr(0, first)) + std::string(name.substr(last));
  }
  void fail(IdlFault::Code code = IdlFault::Code::NotAField) {
    if (!fault_) fault_ = IdlFault{code, in_.now().line, std::string(in_.now().text.substr(0, 200))};
  }
  void expect(std::string_view mark) {
    if (!in_.skipIf(mark)) fail();
  }
  std::string word() {
    if (in_.now().kind != Token::Kind::Word) fail();
    return bounded(std::string(in_.take().text));
  }
  std::string bounded(std::string name) {
    if (name.size() <= kLongestIdlName) return name;
    fail(IdlFault::Code::TooLong);
    return {};
  }

  /// @name, @name(…), any number of them.
  void annotations() {
    while (in_.skipIf("@")) {
      word();
      while (in_.skipIf("::")) word();
      if (in_.skipIf("(")) skipTo(")", "(");
    }
  }
  /// Behind the mark that closes what `opening` has opened.
  void skipTo(std::string_view closing, std::string_view opening) {
    for (std::size_t open = 1; open > 0 && in_.now().kind != Token::Kind::End;) {
      if (in_.is(opening)) ++open;
      if (in_.is(closing)) --open;
      in_.take();
    }
  }
  static std::string inside(const std::string& scope, const std::string& name) {
    return scope.empty() ? name : scope + "::" + name;
  }

  void declaration(const std::string& scope, std::size_t depth) {
    if (depth > kDeepestIdl) return fail(IdlFault::Code::TooLong);
    annotations();
    if (in_.skipIf("module")) {
      const std::string own = bounded(inside(scope, word()));
      expect("{");
      while (!fault_ && !in_.is("}") && in_.now().kind != Token::Kind::End) declaration(own, depth + 1);
      expect("}");
      in_.skipIf(";");
    } else if (in_.skipIf("struct")) {
      structure(scope);
    } else if (in_.skipIf("enum")) {
      enums_.insert(inside(scope, word()));
      expect("{");
      skipTo("}", "{");
      in_.skipIf(";");
    } else if (in_.skipIf("typedef")) {
      IdlType type = this->type(scope);
      const std::string name = inside(scope, word());
      dimensions(type, scope);
      expect(";");
      typedefs_[name] = std::move(type);
    } else if (in_.skipIf("const")) {
      type(scope);
      const std::string name = inside(scope, word());
      expect("=");
      const Token value = in_.now();
      if (value.kind == Token::Kind::Number) constants_[name] = std::string(value.text);
      while (!in_.is(";") && in_.now().kind != Token::Kind::End) in_.take();
      expect(";");
    } else if (!in_.skipIf(";")) {
      fail();
    }
  }

  void structure(const std::string& scope) {
    const std::string name = inside(scope, word());
    IdlStruct made;
    expect("{");
    while (!fault_ && !in_.is("}")) {
      annotations();
      const IdlType type = this->type(scope);
      do {
        IdlType own = type;
        std::string member = word();
        dimensions(own, scope);
        made.members.emplace_back(std::move(member), std::move(own));
        if (++members_ > kMostIdlMembers) fail(IdlFault::Code::TooLong);
      } while (!fault_ && in_.skipIf(","));
      expect(";");
    }
    expect("}");
    in_.skipIf(";");
    // A message without members has one for the wire.
    if (made.members.size() == 1 && made.members.front().first == "structure_needs_at_least_one_member")
      made.members.clear();
    if (structs_.size() >= kMostIdlStructs) fail(IdlFault::Code::TooLong);
    structs_.emplace(name, std::move(made));
  }

  std::optional<std::uint32_t> count(const std::string& scope) {
    const Token token = in_.take();
    std::string text(token.text);
    if (token.kind == Token::Kind::Word) {
      while (!fault_ && in_.skipIf("::")) text = bounded(text + "::" + word());
      const auto found =
          resolved(text, scope, [&](const std::string& name) { return constants_.contains(name); });
      text = found ? constants_[*found] : std::string();
    }
    std::uint32_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (text.empty() || error != std::errc() || stop != end) return std::nullopt;
    return value;
  }

  /// [3], also several of them: the wire knows their product.
  void dimensions(IdlType& type, const std::string& scope) {
    while (!fault_ && in_.skipIf("[")) {
      const auto length = count(scope);
      if (!length || type.field.many == RosField::Many::Open) return fail();
      const bool more = type.field.many == RosField::Many::Fixed;
      const std::uint64_t all = std::uint64_t(more ? type.field.count : 1) * *length;
      if (all > UINT32_MAX) return fail(IdlFault::Code::TooLong);
      type.field.many = RosField::Many::Fixed;
      type.field.count = std::uint32_t(all);
      expect("]");
    }
  }

  IdlType type(const std::string& scope) {
    IdlType type;
    type.line = in_.now().line;
    type.scope = scope;
    if (in_.skipIf("sequence")) {
      expect("<");
      if (in_.is("sequence")) fail();  // a list of lists has no like in ROS
      if (fault_) return type;
      type = this->type(scope);
      type.field.many = RosField::Many::Open;
      if (in_.skipIf(",")) count(scope);
      expect(">");
      return type;
    }
    const bool root = in_.skipIf("::");
    std::string name = word();
    if (!root && (name == "string" || name == "wstring")) {
      type.field.kind = name == "string" ? RosKind::Text : RosKind::WideText;
      if (in_.skipIf("<")) {
        count(scope);
        expect(">");
      }
      return type;
    }
    const bool is_unsigned = !root && name == "unsigned";
    if (is_unsigned) name = word();
    if (!root && name == "long") {
      const bool twice = in_.skipIf("long");
      if (!twice && in_.is("double")) fail();  // no such type in ROS
      type.field.kind = twice ? (is_unsigned ? RosKind::Uint64 : RosKind::Int64)
                              : (is_unsigned ? RosKind::Uint32 : RosKind::Int32);
      return type;
    }
    if (is_unsigned && name != "short") fail();
    constexpr std::pair<std::string_view, RosKind> kBuiltIn[] = {
        {"boolean", RosKind::Flag},  {"octet", RosKind::Uint8},    {"char", RosKind::Uint8},
        {"float", RosKind::Float32}, {"double", RosKind::Float64}, {"int8", RosKind::Int8},
        {"uint8", RosKind::Uint8},   {"int16", RosKind::Int16},    {"uint16", RosKind::Uint16},
        {"int32", RosKind::Int32},   {"uint32", RosKind::Uint32},  {"int64", RosKind::Int64},
        {"uint64", RosKind::Uint64}, {"wchar", RosKind::Uint16}};
    if (name == "short") {
      type.field.kind = is_unsigned ? RosKind::Uint16 : RosKind::Int16;
      return type;
    }
    for (const auto& [word, kind] : kBuiltIn) {
      if (root || word != name) continue;
      type.field.kind = kind;
      return type;
    }
    while (!fault_ && in_.skipIf("::")) name = bounded(name + "::" + word());
    type.field.kind = RosKind::Nested;
    type.name = std::move(name);
    return type;
  }

  /// The name in the innermost scope that has it.
  template <typename Known>
  static std::optional<std::string> resolved(const std::string& name, std::string scope, Known known) {
    while (true) {
      const std::string full = inside(scope, name);
      if (known(full)) return full;
      if (scope.empty()) return std::nullopt;
      const std::size_t last = scope.rfind("::");
      scope = last == std::string::npos ? std::string() : scope.substr(0, last);
    }
  }

  std::optional<IdlFault> add(const std::string& scoped, std::size_t depth) {
    if (depth > kDeepestIdl) return IdlFault{IdlFault::Code::TooLong, 0, scoped};
    const std::size_t at = schema_.types.size();
    made_[scoped] = {at, false};
    schema_.types.push_back({rosNameOf(scoped), {}});
    for (const auto& [name, member] : structs_.at(scoped).members) {
      IdlType type = member;
      for (std::size_t hops = 0; type.field.kind == RosKind::Nested; ++hops) {
        const auto known = [&](const std::string& full) {
          return structs_.contains(full) || typedefs_.contains(full) || enums_.contains(full);
        };
        const auto full = resolved(type.name, type.scope, known);
        if (!full && isTime(type.name)) {
          type.field.type = timeType(type.name);
          break;
        }
        if (!full) return IdlFault{IdlFault::Code::UnknownType, member.line, type.name};
        if (const auto alias = typedefs_.find(*full); alias != typedefs_.end()) {
          IdlType target = alias->second;
          const bool both =
              target.field.many != RosField::Many::One && type.field.many != RosField::Many::One;
          if (both || hops > kDeepestIdl)
            return IdlFault{IdlFault::Code::HoldsItself, member.line, type.name};
          if (type.field.many != RosField::Many::One) {
            target.field.many = type.field.many;
            target.field.count = type.field.count;
          }
          type = std::move(target);
          continue;
        }
        if (!structs_.contains(*full)) {
          type.field.kind = RosKind::Uint32;  // an enumeration
          break;
        }
        const auto known_type = made_.find(*full);
        if (known_type != made_.end()) {
          if (!known_type->second.second) return IdlFault{IdlFault::Code::HoldsItself, member.line, *full};
          type.field.type = known_type->second.first;
          break;
        }
        type.field.type = schema_.types.size();
        if (auto fault = add(*full, depth + 1)) return fault;
        break;
      }
      type.field.name = name;
      schema_.types[at].fields.push_back(std::move(type.field));
    }
    made_[scoped].second = true;
    return std::nullopt;
  }

  static bool isTime(const std::string& name) {
    return name == "builtin_interfaces::msg::Time" || name == "builtin_interfaces::msg::Duration";
  }
  /// Some recorders do not include it.
  std::size_t timeType(const std::string& name) {
    schema_.types.push_back({rosNameOf(name), {}});
    for (const auto& [part, kind] :
         {std::pair("sec", RosKind::Int32), std::pair("nanosec", RosKind::Uint32)}) {
      RosField field;
      field.name = part;
      field.kind = kind;
      schema_.types.back().fields.push_back(std::move(field));
    }
    return schema_.types.size() - 1;
  }

  Tokens in_;
  std::optional<IdlFault> fault_;
  std::map<std::string, IdlStruct> structs_;
  std::map<std::string, IdlType> typedefs_;
  std::map<std::string, std::string> constants_;
  std::set<std::string> enums_;
  std::size_t members_ = 0;
  std::map<std::string, std::pair<std::size_t, bool>> made_;  // index in the schema, whether it is complete
  RosSchema schema_;
};

}  // namespace

tl::expected<RosSchema, RosSchemaFault> parseRosIdl(std::string_view name, std::string_view definition) {
  if (definition.size() > kLongestIdl) return tl::unexpected(IdlFault{IdlFault::Code::TooLong, 0, {}});
  IdlReader reader(definition);
  if (auto fault = reader.read()) return tl::unexpected(std::move(*fault));
  return reader.link(name);
}

}  // namespace mapwright::recording
