#include "recording/ros_schema.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

namespace mapwright::recording {
namespace {

constexpr std::size_t kLongest = std::size_t(1) << 20;
constexpr std::size_t kMostTypes = 1000, kMostFields = 10'000, kDeepest = 32;

using Fault = RosSchemaFault;

constexpr std::pair<std::string_view, RosKind> kWords[] = {
    {"bool", RosKind::Flag},        {"int8", RosKind::Int8},       {"uint8", RosKind::Uint8},
    {"int16", RosKind::Int16},      {"uint16", RosKind::Uint16},   {"int32", RosKind::Int32},
    {"uint32", RosKind::Uint32},    {"int64", RosKind::Int64},     {"uint64", RosKind::Uint64},
    {"float32", RosKind::Float32},  {"float64", RosKind::Float64}, {"string", RosKind::Text},
    {"wstring", RosKind::WideText}, {"char", RosKind::Uint8}};

std::optional<RosKind> builtIn(std::string_view word, RosDialect dialect) {
  for (const auto& [known, kind] : kWords) {
    if (known == word) return kind;
  }
  const bool ros1 = dialect == RosDialect::Ros1;
  if (word == "byte") return ros1 ? RosKind::Int8 : RosKind::Uint8;
  if (ros1 && word == "time") return RosKind::Time;
  if (ros1 && word == "duration") return RosKind::Duration;
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool isName(std::string_view text) {
  constexpr std::size_t kLongestName = 255;
  return !text.empty() && text.size() <= kLongestName && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// "nav_msgs/msg/Path" is "nav_msgs/Path"; former types of roslib get their present package.
std::string plainName(std::string_view name) {
  if (name == "roslib/Header") return "std_msgs/Header";
  const std::size_t first = name.find('/');
  const std::size_t last = name.rfind('/');
  if (first == std::string_view::npos || first == last) return std::string(name);
  return std::string(name.substr(0, first)) + std::string(name.substr(last));
}

/// A field whose type is not resolved yet.
struct Draft {
  RosField field;
  std::string type;  // of Nested, as written
  std::size_t line = 0;
};
struct Section {
  std::string name;
  std::vector<Draft> drafts;
};

/// "float32[3]", "Pose[]", "string<=10[<=5]"; nullopt: invalid.
std::optional<Draft> typeIn(std::string_view text, RosDialect dialect) {
  Draft draft;
  const std::size_t bracket = text.find('[');
  std::string_view base = text.substr(0, bracket);
  if (bracket != std::string_view::npos) {
    if (text.back() != ']') return std::nullopt;
    const std::string_view inside = trimmed(text.substr(bracket + 1, text.size() - bracket - 2));
    if (inside.empty() || inside.starts_with("<=")) {
      draft.field.many = RosField::Many::Open;
    } else {
      const char* const end = inside.data() + inside.size();
      const auto [stop, error] = std::from_chars(inside.data(), end, draft.field.count);
      if (stop != end || error != std::errc()) return std::nullopt;
      draft.field.many = RosField::Many::Fixed;
    }
  }
  base = trimmed(base.substr(0, base.find("<=")));
  if (base.empty()) return std::nullopt;
  if (const std::optional<RosKind> kind = builtIn(base, dialect)) {
    draft.field.kind = *kind;
  } else {
    draft.field.kind = RosKind::Nested;
    draft.type = base;
  }
  return draft;
}

/// nullopt: a constant.
tl::expected<std::optional<Draft>, Fault> fieldIn(std::string_view line, std::size_t number,
                                                  RosDialect dialect) {
  const Fault fault{Fault::Code::NotAField, number, std::string(line.substr(0, 200))};
  const std::size_t blank = line.find_first_of(" \t");
  if (blank == std::string_view::npos) return tl::unexpected(fault);
  std::optional<Draft> draft = typeIn(line.substr(0, blank), dialect);
  std::string_view rest = trimmed(line.substr(blank));
  if (!draft) return tl::unexpected(fault);
  const std::size_t past = rest.find_first_of(" \t=");
  const std::string_view name = rest.substr(0, past);
  rest = past == std::string_view::npos ? std::string_view() : trimmed(rest.substr(past));
  if (!isName(name)) return tl::unexpected(fault);
  if (rest.starts_with('=')) return std::nullopt;
  if (!rest.empty() && dialect == RosDialect::Ros1) return tl::unexpected(fault);  // ROS 2: its default
  draft->field.name = name;
  draft->line = number;
  return draft;
}

tl::expected<std::vector<Section>, Fault> sectionsIn(std::string_view name, std::string_view text,
                                                     RosDialect dialect) {
  std::vector<Section> sections{{plainName(name), {}}};
  std::size_t fields = 0;
  bool named = true;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    line = trimmed(line.substr(0, line.find('#')));  // a '#' in a constant's text: the rest is ignored
    if (line.empty()) continue;
    if (line.find_first_not_of('=') == std::string_view::npos) {
      named = false;
      continue;
    }
    if (!named && line.starts_with("MSG:")) {
      sections.push_back({plainName(trimmed(line.substr(4))), {}});
      named = true;
    } else if (line.starts_with("IDL:")) {
      return tl::unexpected(Fault{Fault::Code::NotAField, number, "IDL"});
    } else {
      auto field = fieldIn(line, number, dialect);
      if (!field) return tl::unexpected(std::move(field.error()));
      if (*field) sections.back().drafts.push_back(std::move(**field));
      ++fields;
    }
    if (fields > kMostFields || sections.size() > kMostTypes) {
      return tl::unexpected(Fault{Fault::Code::TooLong, number, {}});
    }
  }
  return sections;
}

/// Well-known types that some recorders do not include.
std::optional<RosType> wellKnown(const std::string& name) {
  if (name != "builtin_interfaces/Time" && name != "builtin_interfaces/Duration") return std::nullopt;
  return RosType{name, {{"sec", RosKind::Int32}, {"nanosec", RosKind::Uint32}}};
}

class Linker {
 public:
  explicit Linker(std::vector<Section> sections) : sections_(std::move(sections)) {
    for (std::size_t i = sections_.size(); i > 0; --i) section_indexes_[sections_[i - 1].name] = i - 1;
  }

  tl::expected<RosSchema, Fault> link() {
    if (auto fault = addSection(0, 0)) return tl::unexpected(std::move(*fault));
    return std::move(schema_);
  }

 private:
  enum class State : std::uint8_t { Open, Done };

  /// Adds a section, with everything it contains, to the schema.
  std::optional<Fault> addSection(std::size_t section, std::size_t depth) {
    const Section& taken = sections_[section];
    if (depth > kDeepest) return Fault{Fault::Code::TooLong, 0, taken.name};
    const std::size_t at = schema_.types.size();
    made_[section] = {State::Open, at};
    schema_.types.push_back({taken.name, {}});
    for (const Draft& draft : taken.drafts) {
      RosField field = draft.field;
      if (field.kind == RosKind::Nested) {
        auto type = nested(draft, taken.name, depth);
        if (!type) return std::move(type.error());
        field.type = *type;
      }
      schema_.types[at].fields.push_back(std::move(field));
    }
    made_[section].first = State::Done;
    return std::nullopt;
  }

  tl::expected<std::size_t, Fault> nested(const Draft& draft, const std::string& inside, std::size_t depth) {
    std::string name = plainName(draft.type);
    if (name.find('/') == std::string::npos) {
      const std::string beside = inside.substr(0, inside.find('/') + 1) + name;
      // "Header" means the standard one, unless the package has its own.
      name = name == "Header" && !section_indexes_.contains(beside) ? "std_msgs/Header" : beside;
    }
    const auto found = section_indexes_.find(name);
    if (found == section_indexes_.end()) {
      if (const auto added = added_.find(name); added != added_.end()) return added->second;
      std::optional<RosType> known = wellKnown(name);
      if (!known) return tl::unexpected(Fault{Fault::Code::UnknownType, draft.line, name});
      schema_.types.push_back(std::move(*known));
      return added_[name] = schema_.types.size() - 1;
    }
    const auto made = made_.find(found->second);
    if (made != made_.end()) {
      if (made->second.first == State::Open) {
        return tl::unexpected(Fault{Fault::Code::HoldsItself, draft.line, name});
      }
      return made->second.second;
    }
    const std::size_t at = schema_.types.size();
    if (auto fault = addSection(found->second, depth + 1)) return tl::unexpected(std::move(*fault));
    return at;
  }

  std::vector<Section> sections_;
  std::map<std::string, std::size_t> section_indexes_;  // the first of each name
  std::map<std::size_t, std::pair<State, std::size_t>> made_;
  std::map<std::string, std::size_t> added_;
  RosSchema schema_;
};

}  // namespace

std::optional<RosDialect> rosDialect(std::string_view schema_encoding) {
  if (schema_encoding == "ros1msg") return RosDialect::Ros1;
  if (schema_encoding == "ros2msg") return RosDialect::Ros2;
  return std::nullopt;
}

tl::expected<RosSchema, RosSchemaFault> parseRosSchema(std::string_view name, std::string_view definition,
                                                       RosDialect dialect) {
  if (definition.size() > kLongest) return tl::unexpected(Fault{Fault::Code::TooLong, 0, {}});
  auto sections = sectionsIn(name, definition, dialect);
  if (!sections) return tl::unexpected(std::move(sections.error()));
  return Linker(std::move(*sections)).link();
}

}  // namespace mapwright::recording
