#include "exchange/file_value.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <set>
#include <string>

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>

#include "words/shortest.h"
#include "yaml/read_yaml.h"

namespace mapwright::exchange {
namespace {

class FileValueText {
  Q_DECLARE_TR_FUNCTIONS(FileValue)
};

/// Bounded by those who parsed it. `values`: how many there are, itself included.
FileValue valueOf(const YAML::Node& node, std::size_t& values) {
  ++values;
  FileValue value;
  if (node.IsSequence()) {
    value.kind = FileValue::Kind::List;
    for (const YAML::Node& item : node) value.items.push_back(valueOf(item, values));
  } else if (node.IsMap()) {
    value.kind = FileValue::Kind::Map;
    std::vector<FileValue> merged;
    std::set<std::string> names;
    for (const auto& member : node) {
      std::string name = member.first.IsScalar() ? member.first.Scalar() : "?";
      FileValue one = valueOf(member.second, values);
      if (name == "<<" && one.isMap()) {
        merged.push_back(std::move(one));
      } else if (name == "<<" && one.isList() && std::ranges::all_of(one.items, &FileValue::isMap)) {
        std::ranges::move(one.items, std::back_inserter(merged));
      } else {
        names.insert(name);
        value.members.emplace_back(std::move(name), std::move(one));
      }
    }
    // What a map has itself goes first (https://yaml.org/type/merge.html).
    for (FileValue& from : merged) {
      for (auto& member : from.members) {
        if (names.insert(member.first).second) value.members.push_back(std::move(member));
      }
    }
  } else if (node.IsScalar()) {
    value = FileValue::ofText(node.Scalar());
    const bool in_quotes = node.Tag() == "!";
    const auto number = numberIn(value.text);
    if (in_quotes) {
      // A text, whatever it looks like.
    } else if (number) {
      value.kind = FileValue::Kind::Number;
      value.number = *number;
    } else if (value.text == "true" || value.text == "false") {
      value.kind = FileValue::Kind::Flag;
    } else if (value.text == "~" || value.text == "null") {
      value = {};
    }
  }
  return value;
}

QString sentenceOf(yaml::Broken::Code code, int line, const yaml::Limits& limits) {
  using Code = yaml::Broken::Code;
  if (code == Code::TooLong)
    return FileValueText::tr("It is larger than %1 MiB.").arg(limits.most_bytes >> 20);
  if (code == Code::TooMuch || code == Code::TooDeep)
    return FileValueText::tr("It is too large or too deep for a list of waypoints.");
  return FileValueText::tr("It is not YAML (line %1).").arg(std::max(line, 1));
}

/// The documents of a YAML file: each on lines between those that begin with three dashes, or end it with
/// three dots.
std::vector<std::string_view> documentsOf(std::string_view text) {
  std::vector<std::string_view> documents;
  std::size_t begin = 0, line = 0;
  while (line < text.size()) {
    const std::size_t end = std::min(text.find('\n', line), text.size());
    const std::string_view whole = text.substr(line, end - line);
    const bool marks = whole.starts_with("---") || whole.starts_with("...");
    if (marks && (whole.size() == 3 || std::string_view(" \t\r").find(whole[3]) != whole.npos)) {
      documents.push_back(text.substr(begin, line - begin));
      begin = line + 3;
    }
    line = end + 1;
  }
  documents.push_back(text.substr(std::min(begin, text.size())));
  return documents;
}

}  // namespace

FileValue FileValue::ofText(std::string text) {
  FileValue value;
  value.kind = Kind::Text;
  value.text = std::move(text);
  return value;
}

FileValue FileValue::ofNumber(double number) {
  FileValue value;
  value.kind = Kind::Number;
  value.number = number;
  value.text = digitsOf(number);
  return value;
}

bool FileValue::isBlank() const {
  return kind == Kind::Null || (kind == Kind::Text && text.find_first_not_of(" \t") == text.npos);
}

std::optional<double> FileValue::asNumber() const {
  if (kind == Kind::Number) return number;
  return kind == Kind::Text ? numberIn(text) : std::nullopt;
}

const FileValue* FileValue::find(std::string_view member) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& one) { return one.first == member; });
  return found == members.end() ? nullptr : &found->second;
}

std::optional<double> numberIn(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  if (first == text.npos) return std::nullopt;
  text = text.substr(first, last - first + 1);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string digitsOf(double number) { return words::shortest(number); }

FileValue fromJson(const QJsonValue& json) {
  FileValue value;
  switch (json.type()) {
    case QJsonValue::Bool:
      value.kind = FileValue::Kind::Flag;
      value.text = json.toBool() ? "true" : "false";
      break;
    case QJsonValue::Double: {
      constexpr double kExact = 9007199254740992.0;
      value = FileValue::ofNumber(json.toDouble());
      const bool whole = std::abs(value.number) < kExact && value.number == std::floor(value.number);
      if (whole) value.text = std::to_string(json.toInteger());
      break;
    }
    case QJsonValue::String:
      value = FileValue::ofText(json.toString().toStdString());
      break;
    case QJsonValue::Array:
      value.kind = FileValue::Kind::List;
      for (const QJsonValue& item : json.toArray()) value.items.push_back(fromJson(item));
      break;
    case QJsonValue::Object: {
      value.kind = FileValue::Kind::Map;
      const QJsonObject object = json.toObject();
      for (auto member = object.begin(); member != object.end(); ++member)
        value.members.emplace_back(member.key().toStdString(), fromJson(member.value()));
      break;
    }
    case QJsonValue::Null:
    case QJsonValue::Undefined:
      break;
  }
  return value;
}

tl::expected<std::vector<FileValue>, QString> fromYaml(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  yaml::Limits limits;  // of the whole file, not of each document
  if (text.size() > limits.most_bytes)
    return tl::make_unexpected(sentenceOf(yaml::Broken::Code::TooLong, 0, limits));
  std::vector<FileValue> values;
  int lines = 0;
  for (const std::string_view text_of_one : documentsOf(text)) {
    const auto document = yaml::readYaml(std::string(text_of_one), limits);
    if (!document)
      return tl::make_unexpected(sentenceOf(document.error().code, lines + document.error().line, limits));
    if (document->next)
      return tl::make_unexpected(
          FileValueText::tr("It is not YAML: text follows where the file should end."));
    std::size_t count = 0;
    FileValue value = valueOf(document->root, count);
    limits.most_nodes -= std::min(count, limits.most_nodes);
    if (value.kind != FileValue::Kind::Null) values.push_back(std::move(value));
    lines += int(std::count(text_of_one.begin(), text_of_one.end(), '\n'));
  }
  return values;
}

}  // namespace mapwright::exchange
