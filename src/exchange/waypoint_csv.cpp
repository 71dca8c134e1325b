#include "exchange/waypoint_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include <QCoreApplication>
#include <QUtf8StringView>

namespace mapwright::exchange {
namespace {

class WaypointCsvText {
  Q_DECLARE_TR_FUNCTIONS(WaypointCsv)
};

constexpr std::string_view kMark = "\xef\xbb\xbf";
const std::array<std::string, 9> kColumns{"id", "name", "x", "y", "yaw_rad", "tags", "frame", "map", "type"};

tl::unexpected<QString> wrongAt(int line, const QString& why) {
  return tl::make_unexpected(WaypointCsvText::tr("Line %1: %2").arg(QString::number(line), why));
}

QString shown(const std::string& text) { return QString::fromStdString(text.substr(0, 80)); }

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  return begin == std::string_view::npos ? std::string() : std::string(text.substr(begin, end - begin + 1));
}

/// Reads one field after the other.
class Reader {
 public:
  Reader(std::string_view text, char separator) : rest_(text), separator_(separator) {}
  bool atEnd() const { return rest_.empty(); }
  int line() const { return line_; }

  /// An empty line, left behind.
  bool skipEmptyLine() {
    if (rest_.find_first_of("\r\n") != 0) return false;
    goesOn();
    return true;
  }
  /// The next field.
  tl::expected<std::string, QString> field() {
    std::string value;
    if (!rest_.starts_with('"')) {
      const bool quotes_are_letters = separator_ == '\t';
      const std::string ends{separator_, '\r', '\n', quotes_are_letters ? '\n' : '"'};
      const std::size_t end = std::min(rest_.find_first_of(ends), rest_.size());
      value = std::string(rest_.substr(0, end));
      rest_.remove_prefix(end);
      if (rest_.starts_with('"'))
        return wrongAt(line_, WaypointCsvText::tr("there is a quote in the middle of a field. Quote the "
                                                  "whole field and double the quotes inside it."));
      return value;
    }
    const int begun = line_;
    rest_.remove_prefix(1);
    for (;;) {
      const std::size_t end = rest_.find('"');
      if (end == std::string_view::npos)
        return wrongAt(begun, WaypointCsvText::tr("a quote is missing at the end of a field."));
      line_ += int(std::count(rest_.begin(), rest_.begin() + std::ptrdiff_t(end), '\n'));
      value += rest_.substr(0, end);
      rest_.remove_prefix(end + 1);
      if (!rest_.starts_with('"')) break;
      value += '"';
      rest_.remove_prefix(1);
    }
    if (!rest_.empty() && rest_.find_first_of(std::string{separator_, '\r', '\n'}) != 0)
      return wrongAt(line_, WaypointCsvText::tr("there is text after a closing quote."));
    return value;
  }
  /// True if a separator ended the field; false at the end of the record.
  bool goesOn() {
    if (rest_.starts_with(separator_)) {
      rest_.remove_prefix(1);
      return true;
    }
    if (rest_.starts_with('\r')) rest_.remove_prefix(1);
    if (rest_.starts_with('\n')) rest_.remove_prefix(1);
    ++line_;
    return false;
  }

 private:
  std::string_view rest_;
  char separator_;
  int line_ = 1;
};

using Columns = std::map<std::string, std::size_t>;

tl::expected<Columns, QString> columnsOf(const CsvRecord& header, QStringList& notes) {
  Columns columns;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    std::string name = trimmed(header.fields[i]);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    if (std::find(kColumns.begin(), kColumns.end(), name) == kColumns.end()) {
      notes << WaypointCsvText::tr("The column \"%1\" is not one of a waypoint list. It was left out.")
                   .arg(shown(header.fields[i]));
    } else if (!columns.emplace(name, i).second) {
      return wrongAt(header.line, WaypointCsvText::tr("the column \"%1\" appears twice.").arg(shown(name)));
    }
  }
  if (!columns.contains("id") && !columns.contains("name"))
    return wrongAt(header.line,
                   WaypointCsvText::tr("there is neither a column id nor a column name. The header is %1.")
                       .arg(QStringLiteral("id,name,x,y,yaw_rad,tags,frame,map")));
  if (columns.contains("x") != columns.contains("y"))
    return wrongAt(header.line, WaypointCsvText::tr("only one of the columns x and y is present."));
  return columns;
}

tl::expected<WantedWaypoint, QString> wantedOf(const CsvRecord& record, const Columns& columns) {
  WantedWaypoint wanted{record.line, {}};
  const auto at = [&](const char* column) -> const std::string* {
    const auto found = columns.find(column);
    return found == columns.end() ? nullptr : &record.fields[found->second];
  };
  if (const auto* id = at("id")) wanted.id = *id;
  if (const auto* name = at("name"); name && !name->empty()) wanted.name = *name;
  if (const auto* type = at("type")) wanted.type = *type;
  if (const auto* frame = at("frame"); frame && !frame->empty() && *frame != "map")
    return wrongAt(record.line,
                   WaypointCsvText::tr("the frame is \"%1\". Only \"map\" is supported.").arg(shown(*frame)));
  const std::string *const x = at("x"), *const y = at("y");
  if (x && y && !(trimmed(*x).empty() && trimmed(*y).empty())) {
    const auto x_m = csvNumber(*x), y_m = csvNumber(*y);
    if (!x_m || !y_m)
      return wrongAt(record.line,
                     WaypointCsvText::tr("x \"%1\" and y \"%2\" are not two numbers such as 1.5.")
                         .arg(shown(*x), shown(*y)));
    wanted.position_m = Eigen::Vector2d(*x_m, *y_m);
  }
  if (const auto* yaw = at("yaw_rad")) {
    wanted.yaw_rad.emplace();
    if (!trimmed(*yaw).empty()) {
      *wanted.yaw_rad = csvNumber(*yaw);
      if (!*wanted.yaw_rad)
        return wrongAt(record.line,
                       WaypointCsvText::tr("yaw_rad \"%1\" is not a number such as 1.5.").arg(shown(*yaw)));
    }
  }
  if (const auto* tags = at("tags")) {
    auto read = tagsOf(*tags);
    if (!read)
      return wrongAt(record.line, WaypointCsvText::tr("the tags are not a list: %1").arg(read.error()));
    wanted.tags = std::move(*read);
  }
  return wanted;
}

}  // namespace

tl::expected<std::vector<CsvRecord>, QString> csvRecords(std::string_view text, char separator) {
  std::vector<CsvRecord> records;
  Reader reader(text.starts_with(kMark) ? text.substr(kMark.size()) : text, separator);
  while (!reader.atEnd()) {
    if (reader.skipEmptyLine()) continue;
    CsvRecord record{reader.line(), {}};
    do {
      auto field = reader.field();
      if (!field) return tl::make_unexpected(field.error());
      record.fields.push_back(std::move(*field));
    } while (reader.goesOn());
    records.push_back(std::move(record));
  }
  return records;
}

std::string csvNumber(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::optional<double> csvNumber(const std::string& field) {
  const std::string digits = trimmed(field);
  const char* const begin = digits.data() + (digits.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto read = std::from_chars(begin, digits.data() + digits.size(), value);
  const bool whole = read.ec == std::errc() && read.ptr == digits.data() + digits.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string csvLine(const std::vector<std::string>& fields, char separator) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string& field = fields[i];
    // A line with a single empty field would look like an empty line.
    const bool bare = field.find_first_of(std::string{separator, '"', '\r', '\n'}) == std::string::npos &&
                      (!field.empty() || fields.size() > 1);
    if (i > 0) line += separator;
    if (bare) {
      line += field;
      continue;
    }
    line += '"';
    for (const char c : field) line += c == '"' ? "\"\"" : std::string(1, c);
    line += '"';
  }
  return line;
}

tl::expected<std::vector<std::string>, QString> tagsOf(std::string_view text) {
  if (text.empty()) return std::vector<std::string>();
  auto records = csvRecords(text);
  if (!records) return tl::make_unexpected(records.error());
  if (records->size() != 1) return tl::make_unexpected(WaypointCsvText::tr("the tags contain a line break."));
  return std::move(records->front().fields);
}

std::string waypointsCsv(const std::vector<map::Waypoint>& points, const std::string& map) {
  const bool types =
      std::any_of(points.begin(), points.end(), [](const auto& one) { return !one.type.empty(); });
  std::vector<std::string> header(kColumns.begin(), kColumns.end() - (types ? 0 : 1));
  std::string text = csvLine(header) + "\r\n";
  for (const map::Waypoint& point : points) {
    std::vector<std::string> fields{point.id,
                                    point.name,
                                    csvNumber(point.position_m.x()),
                                    csvNumber(point.position_m.y()),
                                    point.yaw_rad ? csvNumber(*point.yaw_rad) : std::string(),
                                    point.tags.empty() ? std::string() : csvLine(point.tags),
                                    "map",
                                    map};
    if (types) fields.push_back(point.type);
    text += csvLine(fields) + "\r\n";
  }
  return text;
}

WantedFile wantedFromCsv(std::string_view bytes) {
  if (!QUtf8StringView(bytes.data(), qsizetype(bytes.size())).isValidUtf8())
    return tl::make_unexpected(WaypointCsvText::tr("It is not UTF-8 text."));
  const auto records = csvRecords(bytes);
  if (!records) return tl::make_unexpected(records.error());
  return wantedFromRecords(*records);
}

WantedFile wantedFromRecords(const std::vector<CsvRecord>& records) {
  if (records.empty())
    return tl::make_unexpected(WaypointCsvText::tr("It is empty: even the header is missing."));
  if (records.size() > kMaxWanted + 1)
    return tl::make_unexpected(WaypointCsvText::tr("It has more than %1 waypoints.").arg(kMaxWanted));
  WantedList list;
  const auto columns = columnsOf(records.front(), list.notes);
  if (!columns) return tl::make_unexpected(columns.error());
  for (std::size_t i = 1; i < records.size(); ++i) {
    const CsvRecord& record = records[i];
    if (record.fields.size() != records.front().fields.size())
      return wrongAt(record.line, WaypointCsvText::tr("it has %1 fields, but the header has %2.")
                                      .arg(QString::number(record.fields.size()),
                                           QString::number(records.front().fields.size())));
    auto wanted = wantedOf(record, *columns);
    if (!wanted) return tl::make_unexpected(wanted.error());
    list.points.push_back(std::move(*wanted));
  }
  return list;
}

}  // namespace mapwright::exchange
