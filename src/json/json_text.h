// A JSON text as a tree over its own bytes, so that whatever is not touched is written back to the byte.
// Source: RFC 8259. Also accepts NaN, Infinity and -Infinity as numbers, which encoders of robots write.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "fault/fault.h"

namespace mapwright::json {

enum class JsonKind : std::uint8_t { Null, False, True, Number, String, Array, Object };

/// Where a text stops being JSON. Lines and columns count from 1, columns in bytes.
struct JsonError {
  std::size_t offset = 0;
  int line = 1, column = 1;
  Fault reason;
};
/// "Line 3, column 14: …"
Fault faultOf(const JsonError& error);

class JsonText;

/// A value in a JsonText; valid as long as that lives. Cheap to copy.
class JsonValue {
 public:
  JsonKind kind() const;
  bool isObject() const { return kind() == JsonKind::Object; }
  bool isArray() const { return kind() == JsonKind::Array; }
  /// As written.
  std::string_view text() const;
  /// Offsets in the text.
  std::size_t begin() const;
  std::size_t end() const;
  /// Its name in the object around it, decoded; empty outside objects.
  std::string key() const;
  /// Where that name begins in the text.
  std::size_t keyBegin() const;
  /// A string, decoded to UTF-8; empty for other kinds. Half a surrogate pair becomes the three bytes that it
  /// would have, which is no UTF-8; quoted() writes it as an escape again.
  std::string string() const;
  /// NaN if it is no number. Beyond doubles: infinite.
  double number() const;
  /// Elements or members, as written; a name may occur more than once.
  std::vector<JsonValue> children() const;
  /// The last member with that name, as most parsers read it.
  std::optional<JsonValue> member(std::string_view name) const;

 private:
  friend class JsonText;
  JsonValue(const JsonText* text, std::uint32_t node) : text_(text), node_(node) {}

  const JsonText* text_;
  std::uint32_t node_;
};

/// A string or number, and the one that is to stand in its place, as JSON.
struct Rewrite {
  JsonValue value;
  std::string text;
};

class JsonText {
 public:
  static constexpr int kDeepest = 200;
  static constexpr std::size_t kLongest = std::size_t(1) << 30;

  static tl::expected<JsonText, JsonError> read(std::string text);
  // What is known already is not read anew:
  /// The value as a text of its own.
  static JsonText of(const JsonValue& value);
  /// The text of the values, which there must be, with the others in their stead.
  static JsonText rewritten(std::vector<Rewrite> rewrites);

  const std::string& text() const { return text_; }
  JsonValue root() const { return {this, 0}; }

 private:
  friend class JsonValue;
  friend class JsonReading;
  struct Node {
    std::uint32_t begin = 0, end = 0;
    std::uint32_t key_begin = 0, key_end = 0;  // equal: it has no name
    std::uint32_t next = 0;                    // the node after all that lies within this one
    JsonKind kind = JsonKind::Null;
    bool key_escaped = false;
  };

  std::string text_;
  std::vector<Node> nodes_;  // each before those within it
};

/// By name; of those with the same name the last one.
std::vector<std::pair<std::string, JsonValue>> membersOf(const JsonValue& object);

/// The value without its notation: 1.50, 1.5 and 15e-1 are the same, and so are "A" and "\u0041". Members are
/// in the order of their names, as their order means nothing; whole numbers keep every digit.
std::string canonical(const JsonValue& value);
/// Whether their canonical() is the same; faster than comparing that.
bool sameValue(const JsonValue& a, const JsonValue& b);

/// A JSON string with the quotes around it.
std::string quoted(std::string_view plain);

/// The object with the member set to `value` (JSON), replaced in place or added at the end in the style of
/// the others.
std::string withMember(const JsonValue& object, std::string_view name, std::string_view value);
/// The object without any member of that name.
std::string withoutMember(const JsonValue& object, std::string_view name);

}  // namespace mapwright::json
