#include "exchange/waypoint_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <QCoreApplication>
#include <QUtf8StringView>

#include "exchange/waypoint_json.h"
#include "exchange/waypoint_reading.h"
#include "map/waypoint.h"
#include "sentences/plural.h"
#include "words/listed.h"

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

bool isKnown(const std::string& column) { return meaningOf(column) != FieldMeaning::None; }

bool isNumber(FieldMeaning meaning) { return meaning >= FieldMeaning::X; }

/// Whether it can be the header of a list.
std::optional<QString> noHeaderReason(const CsvRecord& header) {
  std::set<std::string> names;
  std::set<FieldMeaning> meanings;
  for (const std::string& field : header.fields) {
    if (isKnown(field) && !names.insert(lowerCase(trimmed(field))).second)
      return WaypointTableText::tr("the column \"%1\" appears twice.").arg(shown(lowerCase(trimmed(field))));
    meanings.insert(meaningOf(field));
  }
  const auto has = [&](FieldMeaning meaning) { return meanings.contains(meaning); };
  if (has(FieldMeaning::X) != has(FieldMeaning::Y))
    return WaypointTableText::tr("only one of the columns x and y is present.");
  const bool place = has(FieldMeaning::X) || has(FieldMeaning::Latitude) || has(FieldMeaning::Longitude);
  if (!place && !has(FieldMeaning::Id) && !has(FieldMeaning::Name))
    return WaypointTableText::tr("there is neither a place (x, y) nor an id or a name. The header is %1.")
        .arg(QStringLiteral("id,name,x,y,yaw_rad,tags,frame,map"));
  return std::nullopt;
}

bool isBlank(const std::string& field) { return field.find_first_not_of(" \t") == std::string::npos; }

std::string withPoint(std::string field, bool decimal_comma) {
  if (decimal_comma) std::replace(field.begin(), field.end(), ',', '.');
  return field;
}

bool looksLikeDecimalComma(const std::string& field) {
  if (field.find('.') != std::string::npos || std::count(field.begin(), field.end(), ',') != 1) return false;
  return numberIn(withPoint(field, true)).has_value();
}

char separatorOf(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  for (const char separator : {'\t', ';'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

/// What the columns of a table are. `fields` are those that become one value: a list.
struct TableColumn {
  std::string name;  // empty: of no use
  bool listed = false;
};

QString columnNumber(std::size_t column) { return WaypointTableText::tr("column %1").arg(column + 1); }

/// Whether the four columns from `first` on are quaternions in all rows.
bool areQuaternions(const std::vector<CsvRecord>& records, std::size_t first, bool decimal_comma) {
  return std::all_of(records.begin(), records.end(), [&](const CsvRecord& record) {
    double sum = 0;
    for (std::size_t i = first; i < first + 4; ++i) {
      const auto number = numberIn(withPoint(record.fields[i], decimal_comma));
      if (!number) return false;
      sum += *number * *number;
    }
    return std::abs(sum - 1) < 0.02;
  });
}

/// For a table without a header, guessed from its columns. Empty: there is no position in it.
std::vector<TableColumn> guessedColumns(const std::vector<CsvRecord>& records, const TableShape& shape) {
  const std::size_t columns = records.front().fields.size();
  std::vector<TableColumn> guessed(columns);
  std::vector<bool> number(columns, true), any(columns, false);
  for (const CsvRecord& record : records) {
    for (std::size_t i = 0; i < columns; ++i) {
      if (isBlank(record.fields[i])) continue;
      any[i] = true;
      if (!numberIn(withPoint(record.fields[i], shape.decimal_comma))) number[i] = false;
    }
  }
  const auto isNumeric = [&](std::size_t i) { return i < columns && number[i] && any[i]; };
  std::size_t x = 0;
  while (x + 1 < columns && !(isNumeric(x) && isNumeric(x + 1))) ++x;
  if (x + 1 >= columns) return {};
  if (x >= 1) guessed[x - 1].name = "name";
  if (x >= 2) guessed[x - 2].name = "id";
  guessed[x].name = "x";
  guessed[x + 1].name = "y";
  std::size_t end = x + 2;
  while (isNumeric(end)) ++end;
  const std::size_t more = end - x - 2;
  if (more == 1) {
    guessed[x + 2].name = "heading";
  } else if ((more == 4 || more == 5) && areQuaternions(records, end - 4, shape.decimal_comma)) {
    if (more == 5) guessed[x + 2].name = "z";
    for (std::size_t i = end - 4; i < end; ++i) guessed[i] = {"orientation", true};
  }
  if (end < columns && any[end]) guessed[end].name = "tags";
  return guessed;
}

QString namesOf(const std::vector<TableColumn>& columns) {
  QStringList names;
  for (const TableColumn& column : columns) {
    if (!column.name.empty()) names << QString::fromStdString(column.name);
  }
  return words::listed(names);
}

/// One row as a map of its columns.
tl::expected<FileValue, QString> rowOf(const CsvRecord& record, const std::vector<TableColumn>& columns,
                                       bool decimal_comma) {
  FileValue row{FileValue::Kind::Map};
  FileValue list{FileValue::Kind::List};
  std::string list_name;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name.empty()) continue;
    const FieldMeaning meaning = meaningOf(columns[i].name);
    std::string field = isNumber(meaning) || columns[i].listed ? withPoint(record.fields[i], decimal_comma)
                                                               : record.fields[i];
    if (columns[i].listed) {
      list.items.push_back(FileValue::ofText(std::move(field)));
      list_name = columns[i].name;
      continue;
    }
    FileValue value = FileValue::ofText(std::move(field));
    if (meaning == FieldMeaning::Tags) {
      const auto tags = tagsOf(value.text);
      if (!tags) return wrong(WaypointTableText::tr("the tags are not a list: %1").arg(tags.error()));
      value = FileValue{FileValue::Kind::List};
      for (const std::string& tag : *tags) value.items.push_back(FileValue::ofText(tag));
    }
    row.members.emplace_back(columns[i].name, std::move(value));
  }
  if (!list.items.empty()) row.members.emplace_back(list_name, std::move(list));
  return row;
}

/// Lines before the header that begin with #: comments, unless that is how the header begins.
int withoutComments(std::vector<CsvRecord>& records) {
  int comments = 0;
  while (!records.empty() && trimmed(records.front().fields.front()).starts_with('#')) {
    auto& fields = records.front().fields;
    if (fields.size() > 1 && !noHeaderReason(records.front())) {
      fields.front() = fields.front().substr(fields.front().find('#') + 1);
      break;
    }
    records.erase(records.begin());
    ++comments;
  }
  return comments;
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
                                    digitsOf(point.position_m.x()),
                                    digitsOf(point.position_m.y()),
                                    point.yaw_rad ? digitsOf(*point.yaw_rad) : std::string(),
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

WantedFile wantedFromCsv(std::string_view bytes, AngleUnit angles) {
  TableShape shape = shapeOf(bytes);
  shape.angles = angles;
  shape.ragged = false;
  return wantedFromTable(bytes, shape);
}

TableShape shapeOf(std::string_view text) {
  TableShape shape;
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  shape.separator = separatorOf(text);
  shape.header = false;
  auto records = csvRecords(text, shape.separator);
  // What cannot be read whole may still begin with a header.
  if (!records) records = csvRecords(text.substr(0, text.find('\n')), shape.separator);
  if (!records) return shape;
  withoutComments(*records);
  if (records->empty()) return shape;
  const auto& first = records->front().fields;
  shape.header =
      std::any_of(first.begin(), first.end(), isKnown) &&
      std::none_of(first.begin(), first.end(), [](const auto& field) { return numberIn(field).has_value(); });
  if (shape.separator != ',') {
    shape.decimal_comma = std::any_of(records->begin(), records->end(), [](const CsvRecord& record) {
      return std::any_of(record.fields.begin(), record.fields.end(), looksLikeDecimalComma);
    });
  }
  return shape;
}

WantedFile wantedFromTable(std::string_view text, const TableShape& shape) {
  if (text.size() > kMaxWantedBytes) return wrong(WaypointTableText::tr("It is larger than 64 MiB."));
  if (!QUtf8StringView(text.data(), qsizetype(text.size())).isValidUtf8())
    return wrong(WaypointTableText::tr("It is not UTF-8 text."));
  auto records = csvRecords(text, shape.separator);
  if (!records) return wrong(records.error());
  const int comments = withoutComments(*records);
  if (records->empty()) return wrong(WaypointTableText::tr("It is empty."));
  if (records->size() > kMaxWanted + 1)
    return wrong(WaypointTableText::tr("It has more than %1 waypoints.").arg(kMaxWanted));
  std::size_t width = shape.header && !shape.ragged ? records->front().fields.size() : 0;
  for (CsvRecord& record : *records) {
    if (shape.ragged || width == 0) {
      width = std::max(width, record.fields.size());
    } else if (record.fields.size() != width) {
      return wrongAt(record.line, WaypointTableText::tr("it has %1 fields, but the header has %2.")
                                      .arg(QString::number(record.fields.size()), QString::number(width)));
    }
  }
  if (width > kMostColumns)
    return wrong(WaypointTableText::tr("It has too many columns for a waypoint list."));
  for (CsvRecord& record : *records) record.fields.resize(width);

  WaypointReading reading(shape.angles);
  if (comments > 0)
    reading.addRemark(sentences::counted(
        WaypointTableText::tr("%1 comment lines (#) were left out.", nullptr, sentences::formOf(comments)),
        comments));
  if (shape.decimal_comma)
    reading.addRemark(WaypointTableText::tr("Commas in numbers were read as decimal points."));
  std::vector<TableColumn> columns;
  if (shape.header) {
    if (const auto why = noHeaderReason(records->front())) return wrongAt(records->front().line, *why);
    for (const std::string& field : records->front().fields)
      columns.push_back({isBlank(field) ? std::string() : trimmed(field)});
    records->erase(records->begin());
  } else {
    columns = guessedColumns(*records, shape);
    if (columns.empty())
      return wrong(
          WaypointTableText::tr("It needs two adjacent columns of numbers: x and y in metres. Or start "
                                "with a row that names the columns: name, x, y, heading, tags."));
    reading.addRemark(
        WaypointTableText::tr("It has no column names. Its columns were read as %1.").arg(namesOf(columns)));
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name.empty() &&
        std::any_of(records->begin(), records->end(),
                    [&](const CsvRecord& record) { return !isBlank(record.fields[i]); }))
      reading.leaveOut(columnNumber(i).toStdString());
  }
  if (records->size() > kMaxWanted)
    return wrong(WaypointTableText::tr("It has more than %1 waypoints.").arg(kMaxWanted));
  for (const CsvRecord& record : *records) {
    const auto row = rowOf(record, columns, shape.decimal_comma);
    if (!row) return wrongAt(record.line, row.error());
    if (const auto read = reading.add(record.line, *row); !read) return wrongAt(record.line, read.error());
  }
  return std::move(reading).finish();
}

void knowByPlace(std::vector<WantedWaypoint>& wanted, const WaypointItems& kept) {
  using Cell = std::pair<double, double>;
  const auto cellOf = [](const Eigen::Vector2d& at_m, int dx, int dy) {
    return Cell(std::floor(at_m.x() * 1'000) + dx, std::floor(at_m.y() * 1'000) + dy);
  };
  std::multimap<Cell, const map::Waypoint*> by_cell;
  std::set<edit::Key> taken;
  for (const WantedWaypoint& one : wanted) taken.insert(one.id);
  std::map<const map::Waypoint*, edit::Key> keys;
  for (const auto& [key, point] : kept) {
    if (taken.contains(key)) continue;
    by_cell.emplace(cellOf(point.position_m, 0, 0), &point);
    keys.emplace(&point, key);
  }
  const auto findFor = [&](WantedWaypoint& one) {
    for (int neighbour = 0; neighbour < 9; ++neighbour) {
      const auto [first, last] =
          by_cell.equal_range(cellOf(*one.position_m, neighbour / 3 - 1, neighbour % 3 - 1));
      for (auto near = first; near != last; ++near) {
        const map::Waypoint& point = *near->second;
        if (!map::samePlace(point.position_m, *one.position_m)) continue;
        if (one.yaw_rad && !map::sameHeading(point.yaw_rad, *one.yaw_rad)) continue;
        one.id = keys.at(&point);
        by_cell.erase(near);
        return;
      }
    }
  };
  for (WantedWaypoint& one : wanted) {
    if (!one.name && one.id.empty() && one.position_m) findFor(one);
  }
}

QString nameNameless(std::vector<WantedWaypoint>& wanted, const WaypointItems& kept) {
  std::set<std::string> taken;
  for (const auto& [key, point] : kept) taken.insert(point.name);
  for (const WantedWaypoint& one : wanted) {
    if (one.name) taken.insert(*one.name);
  }
  std::size_t number = 0;
  qint64 named = 0;
  for (WantedWaypoint& one : wanted) {
    if (one.name || kept.contains(one.id)) continue;
    std::string name;
    do name = madeUpName(++number);
    while (!taken.insert(name).second);
    one.name = std::move(name);
    ++named;
  }
  if (named == 0) return {};
  return sentences::counted(
      WaypointTableText::tr("%1 waypoints without a name were numbered.", nullptr, sentences::formOf(named)),
      named);
}

std::string waypointsTable(const std::vector<map::Waypoint>& points) {
  return linesOf(points, std::nullopt, '\t', "\n");
}

}  // namespace mapwright::exchange
