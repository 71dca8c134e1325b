#include "exchange/waypoint_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <QCoreApplication>
#include <QUtf8StringView>

#include "exchange/waypoint_json.h"
#include "geometry/pose.h"
#include "words/shortest.h"

namespace mapwright::exchange {
namespace {

class WaypointTableText {
  Q_DECLARE_TR_FUNCTIONS(WaypointTable)
};

constexpr std::size_t kMostColumns = 100;
constexpr std::string_view kMark = "\xef\xbb\xbf";
const std::array<std::string, 9> kColumns{"id", "name", "x", "y", "yaw_rad", "tags", "frame", "map", "type"};

tl::unexpected<QString> wrongAt(int line, const QString& why) {
  return wrong(WaypointTableText::tr("Line %1: %2").arg(QString::number(line), why));
}

QString shown(const std::string& text) { return QString::fromStdString(text.substr(0, 80)); }

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  return begin == std::string_view::npos ? std::string() : std::string(text.substr(begin, end - begin + 1));
}

std::string lowerCase(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return text;
}

/// With enough digits to read the same value back.
std::string csvNumber(double value) { return words::shortest(value); }

/// A finite number with a decimal point in any locale; nullopt = invalid.
std::optional<double> csvNumber(const std::string& field) {
  const std::string digits = trimmed(field);
  const char* const begin = digits.data() + (digits.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto read = std::from_chars(begin, digits.data() + digits.size(), value);
  const bool whole = read.ec == std::errc() && read.ptr == digits.data() + digits.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
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
        return wrongAt(line_, WaypointTableText::tr("there is a quote in the middle of a field. Quote the "
                                                    "whole field and double the quotes inside it."));
      return value;
    }
    const int begun = line_;
    rest_.remove_prefix(1);
    for (;;) {
      const std::size_t end = rest_.find('"');
      if (end == std::string_view::npos)
        return wrongAt(begun, WaypointTableText::tr("a quote is missing at the end of a field."));
      line_ += int(std::count(rest_.begin(), rest_.begin() + std::ptrdiff_t(end), '\n'));
      value += rest_.substr(0, end);
      rest_.remove_prefix(end + 1);
      if (!rest_.starts_with('"')) break;
      value += '"';
      rest_.remove_prefix(1);
    }
    if (!rest_.empty() && rest_.find_first_of(std::string{separator_, '\r', '\n'}) != 0)
      return wrongAt(line_, WaypointTableText::tr("there is text after a closing quote."));
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
    const std::string name = lowerCase(trimmed(header.fields[i]));
    if (std::find(kColumns.begin(), kColumns.end(), name) == kColumns.end()) {
      notes << WaypointTableText::tr("The column \"%1\" is not one of a waypoint list. It was left out.")
                   .arg(shown(header.fields[i]));
    } else if (!columns.emplace(name, i).second) {
      return wrongAt(header.line, WaypointTableText::tr("the column \"%1\" appears twice.").arg(shown(name)));
    }
  }
  if (!columns.contains("id") && !columns.contains("name"))
    return wrongAt(header.line,
                   WaypointTableText::tr("there is neither a column id nor a column name. The header is %1.")
                       .arg(QStringLiteral("id,name,x,y,yaw_rad,tags,frame,map")));
  if (columns.contains("x") != columns.contains("y"))
    return wrongAt(header.line, WaypointTableText::tr("only one of the columns x and y is present."));
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
  if (const auto* frame = at("frame"); frame && *frame != "map") wanted.frame = *frame;
  if (!wanted.frame.empty() && wanted.id.empty())
    return wrongAt(
        record.line,
        WaypointTableText::tr("the frame is \"%1\". Only \"map\" is supported.").arg(shown(wanted.frame)));
  const std::string *const x = at("x"), *const y = at("y");
  if (x && y && !(trimmed(*x).empty() && trimmed(*y).empty())) {
    const auto x_m = csvNumber(*x), y_m = csvNumber(*y);
    if (!x_m || !y_m)
      return wrongAt(record.line,
                     WaypointTableText::tr("x \"%1\" and y \"%2\" are not two numbers such as 1.5.")
                         .arg(shown(*x), shown(*y)));
    wanted.position_m = Eigen::Vector2d(*x_m, *y_m);
  }
  if (const auto* yaw = at("yaw_rad")) {
    wanted.yaw_rad.emplace();
    if (!trimmed(*yaw).empty()) {
      *wanted.yaw_rad = csvNumber(*yaw);
      if (!*wanted.yaw_rad)
        return wrongAt(record.line,
                       WaypointTableText::tr("yaw_rad \"%1\" is not a number such as 1.5.").arg(shown(*yaw)));
    }
  }
  if (const auto* tags = at("tags")) {
    auto read = tagsOf(*tags);
    if (!read)
      return wrongAt(record.line, WaypointTableText::tr("the tags are not a list: %1").arg(read.error()));
    wanted.tags = std::move(*read);
  }
  return wanted;
}

/// The first record is the header.
WantedFile wantedFromRecords(const std::vector<CsvRecord>& records) {
  if (records.empty()) return wrong(WaypointTableText::tr("It is empty: even the header is missing."));
  if (records.size() > kMaxWanted + 1)
    return wrong(WaypointTableText::tr("It has more than %1 waypoints.").arg(kMaxWanted));
  WantedList list;
  const auto columns = columnsOf(records.front(), list.notes);
  if (!columns) return wrong(columns.error());
  for (std::size_t i = 1; i < records.size(); ++i) {
    const CsvRecord& record = records[i];
    if (record.fields.size() != records.front().fields.size())
      return wrongAt(record.line, WaypointTableText::tr("it has %1 fields, but the header has %2.")
                                      .arg(QString::number(record.fields.size()),
                                           QString::number(records.front().fields.size())));
    auto wanted = wantedOf(record, *columns);
    if (!wanted) return wrong(wanted.error());
    list.points.push_back(std::move(*wanted));
  }
  return list;
}

std::string lowered(std::string_view field) {
  std::string text;
  for (const char c : lowerCase(std::string(field))) {
    if (std::string_view(" _[]()").find(c) == std::string_view::npos) text += c;
  }
  return text;
}

/// The column of a waypoint list for this header; "" = none. "heading" may have either unit.
std::string columnCalled(std::string_view field) {
  static const std::map<std::string, std::set<std::string>> kNames{
      {"id", {"id"}},
      {"name", {"name", "waypoint", "label"}},
      {"x", {"x", "xm"}},
      {"y", {"y", "ym"}},
      {"yaw_rad", {"yawrad"}},
      {"heading", {"yaw", "heading", "theta"}},
      {"degrees", {"yaw\xc2\xb0", "yawdeg", "headingdeg", "heading\xc2\xb0"}},
      {"tags", {"tags", "tag"}},
      {"type", {"type", "kind"}},
      {"frame", {"frame"}},
      {"map", {"map"}}};
  const std::string name = lowered(field);
  for (const auto& [column, names] : kNames) {
    if (names.contains(name)) return column;
  }
  return {};
}

bool isBlank(const std::string& field) { return field.find_first_not_of(" \t") == std::string::npos; }

std::string withPoint(std::string field, const TableShape& shape) {
  if (shape.decimal_comma) std::replace(field.begin(), field.end(), ',', '.');
  return field;
}

bool looksLikeDecimalComma(const std::string& field) {
  if (field.find('.') != std::string::npos || std::count(field.begin(), field.end(), ',') != 1) return false;
  return csvNumber(withPoint(field, {.decimal_comma = true})).has_value();
}

char separatorOf(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  for (const char separator : {'\t', ';'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

/// For a table without a header, guessed from its columns.
std::vector<std::string> guessedHeader(const std::vector<CsvRecord>& records, const TableShape& shape) {
  const std::size_t columns = records.front().fields.size();
  std::vector<std::string> header(columns);
  std::vector<bool> numbers(columns, true), any(columns, false);
  for (const CsvRecord& record : records) {
    for (std::size_t i = 0; i < columns; ++i) {
      if (isBlank(record.fields[i])) continue;
      any[i] = true;
      if (!csvNumber(withPoint(record.fields[i], shape))) numbers[i] = false;
    }
  }
  std::size_t x = 0;
  while (x + 1 < columns && !(numbers[x] && any[x] && numbers[x + 1] && any[x + 1])) ++x;
  if (x + 1 >= columns) x = columns;  // there is no position in it
  if (x >= 1) header[x - 1] = "name";
  if (x >= 2) header[x - 2] = "id";
  if (x < columns) {
    header[x] = "x";
    header[x + 1] = "y";
    std::size_t next = x + 2;
    if (next < columns && numbers[next]) header[next++] = shape.turns_in_degrees ? "degrees" : "yaw_rad";
    if (next < columns) header[next] = "tags";
  }
  return header;
}

/// A header and the waypoints. `map`: its id; nullopt = without frame and map.
std::string linesOf(const std::vector<map::Waypoint>& points, const std::optional<std::string>& map,
                    char separator, const char* end) {
  const bool types =
      std::any_of(points.begin(), points.end(), [](const auto& one) { return !one.type.empty(); });
  std::vector<std::string> header(kColumns.begin(), kColumns.begin() + 6);
  if (map) header.insert(header.end(), {"frame", "map"});
  if (types) header.push_back("type");
  std::string text = csvLine(header, separator) + end;
  for (const map::Waypoint& point : points) {
    std::vector<std::string> fields{point.id,
                                    point.name,
                                    csvNumber(point.position_m.x()),
                                    csvNumber(point.position_m.y()),
                                    point.yaw_rad ? csvNumber(*point.yaw_rad) : std::string(),
                                    point.tags.empty() ? std::string() : csvLine(point.tags)};
    if (map) fields.insert(fields.end(), {frameOf(point), *map});
    if (types) fields.push_back(point.type);
    text += csvLine(fields, separator) + end;
  }
  return text;
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
      if (!field) return wrong(field.error());
      record.fields.push_back(std::move(*field));
    } while (reader.goesOn());
    records.push_back(std::move(record));
  }
  return records;
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
  if (!records) return wrong(records.error());
  if (records->size() != 1) return wrong(WaypointTableText::tr("the tags contain a line break."));
  return std::move(records->front().fields);
}

std::string waypointsCsv(const std::vector<map::Waypoint>& points, const std::string& map) {
  return linesOf(points, map, ',', "\r\n");
}

WantedFile wantedFromCsv(std::string_view bytes) {
  if (!QUtf8StringView(bytes.data(), qsizetype(bytes.size())).isValidUtf8())
    return wrong(WaypointTableText::tr("It is not UTF-8 text."));
  const auto records = csvRecords(bytes);
  if (!records) return wrong(records.error());
  return wantedFromRecords(*records);
}

TableShape shapeOf(std::string_view text) {
  TableShape shape;
  shape.separator = separatorOf(text);
  shape.header = false;
  // The first rows decide.
  std::size_t end = 0;
  for (int line = 0; line < 50 && end < text.size(); ++line)
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  const auto records = csvRecords(text.substr(0, end), shape.separator);
  if (!records || records->empty()) return shape;
  const auto& first = records->front().fields;
  shape.header = std::any_of(first.begin(), first.end(),
                             [](const auto& field) { return !columnCalled(field).empty(); }) &&
                 std::none_of(first.begin(), first.end(),
                              [](const auto& field) { return csvNumber(field).has_value(); });
  if (shape.separator != ',') {
    for (const CsvRecord& record : *records)
      shape.decimal_comma = shape.decimal_comma ||
                            std::any_of(record.fields.begin(), record.fields.end(), looksLikeDecimalComma);
  }
  return shape;
}

WantedFile wantedFromTable(std::string_view text, const TableShape& shape) {
  if (text.size() > kMaxWantedBytes) return wrong(WaypointTableText::tr("It is larger than 64 MiB."));
  if (!QUtf8StringView(text.data(), qsizetype(text.size())).isValidUtf8())
    return wrong(WaypointTableText::tr("It is not UTF-8 text."));
  auto records = csvRecords(text, shape.separator);
  if (!records) return wrong(records.error());
  if (records->empty()) return wrong(WaypointTableText::tr("It is empty."));
  std::size_t columns = 0;
  for (const CsvRecord& record : *records) columns = std::max(columns, record.fields.size());
  if (columns > kMostColumns)
    return wrong(WaypointTableText::tr("It has too many columns for a waypoint list."));
  for (CsvRecord& record : *records) record.fields.resize(columns);
  std::vector<std::string> header;
  if (shape.header) {
    for (const std::string& field : records->front().fields) {
      const std::string known = columnCalled(field);
      header.push_back(known == "heading" ? shape.turns_in_degrees ? "degrees" : "yaw_rad"
                       : known.empty()    ? field
                                          : known);
    }
  } else {
    header = guessedHeader(*records, shape);
    if (std::find(header.begin(), header.end(), "x") == header.end())
      return wrong(
          WaypointTableText::tr("It needs two adjacent columns of numbers: x and y in metres. Or start "
                                "with a row that names the columns: name, x, y, heading, tags."));
    records->insert(records->begin(), CsvRecord{records->front().line, header});
  }
  // Converts to CSV conventions: decimal points, radians, and a required column.
  const bool has_name = std::find(header.begin(), header.end(), "name") != header.end();
  for (CsvRecord& record : *records) {
    const bool is_header = &record == &records->front();
    std::vector<std::string> kept;
    for (std::size_t column = 0; column < columns; ++column) {
      const std::string& what = header[column];
      if (!shape.header && what.empty()) continue;
      if (is_header) {
        kept.push_back(what == "degrees" ? "yaw_rad" : what);
        continue;
      }
      std::string field = record.fields[column];
      if (what == "x" || what == "y" || what == "yaw_rad" || what == "degrees")
        field = withPoint(field, shape);
      if (what == "degrees") {
        const auto degrees = csvNumber(field);
        if (!degrees && !isBlank(field))
          return wrong(WaypointTableText::tr("Line %1: the heading \"%2\" is not a number such as 90.")
                           .arg(QString::number(record.line), shown(field)));
        field = degrees ? csvNumber(geometry::radiansFromDegrees(*degrees)) : std::string();
      }
      kept.push_back(std::move(field));
    }
    if (!has_name) kept.push_back(is_header ? "name" : "");
    record.fields = std::move(kept);
  }
  return wantedFromRecords(*records);
}

void nameNameless(std::vector<WantedWaypoint>& wanted, const WaypointItems& kept, const QString& pattern) {
  std::set<std::string> taken;
  for (const auto& [key, point] : kept) taken.insert(point.name);
  for (const WantedWaypoint& one : wanted) {
    if (one.name) taken.insert(*one.name);
  }
  int number = 0;
  for (WantedWaypoint& one : wanted) {
    if (one.name || kept.contains(one.id)) continue;
    std::string name;
    do name = pattern.arg(++number).toStdString();
    while (!taken.insert(name).second);
    one.name = std::move(name);
  }
}

std::string waypointsTable(const std::vector<map::Waypoint>& points) {
  return linesOf(points, std::nullopt, '\t', "\n");
}

}  // namespace mapwright::exchange
