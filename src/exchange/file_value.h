// What a file of waypoints holds, whatever its format: a tree of JSON, of YAML, or a row of a table. Pure
// functions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QJsonValue>
#include <QString>
#include <tl/expected.hpp>

namespace mapwright::exchange {

struct FileValue {
  enum class Kind { Null, Flag, Number, Text, List, Map };
  Kind kind = Kind::Null;
  double number = 0;                                            // finite
  std::string text = {};                                        // of a scalar, UTF-8, as written
  std::vector<FileValue> items = {};                            // of a list
  std::vector<std::pair<std::string, FileValue>> members = {};  // of a map, in the order of the file

  static FileValue ofText(std::string text);
  static FileValue ofNumber(double number);

  bool isList() const { return kind == Kind::List; }
  bool isMap() const { return kind == Kind::Map; }
  /// Null, or a text of blanks.
  bool isBlank() const;
  /// A finite number, also one that is written as a text: "1.5".
  std::optional<double> asNumber() const;
  /// null = there is no such member.
  const FileValue* find(std::string_view member) const;
};

/// A finite number with a decimal point in any locale, blanks around it; nullopt = none.
std::optional<double> numberIn(std::string_view text);
/// With enough digits to read the same value back.
std::string digitsOf(double number);

FileValue fromJson(const QJsonValue& value);

/// One value for each document of a YAML file. Parts that are referred to by aliases are repeated, within a
/// bound. The error is a sentence.
tl::expected<std::vector<FileValue>, QString> fromYaml(std::string_view text);

}  // namespace mapwright::exchange
