#include "exchange/pasted_waypoints.h"

#include <algorithm>
#include <map>
#include <set>

#include <QCoreApplication>
#include <QUtf8StringView>

#include "exchange/waypoint_csv.h"
#include "geometry/pose.h"

namespace mapwright::exchange {
namespace {

class PastedWaypointsText {
  Q_DECLARE_TR_FUNCTIONS(PastedWaypoints)
};

constexpr std::size_t kMostColumns = 100;

std::string lowered(std::string_view field) {
  std::string text;
  for (const char c : field) {
    if (c != ' ' && c != '_' && c != '[' && c != ']' && c != '(' && c != ')')
      text += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  }
  return text;
}

/// The column of a waypoint list for this header; "" = none. "heading" may have either unit.
std::string columnCalled(std::string_view field) {
  static const std::map<std::string, std::string> kNames{{"id", "id"},
                                                         {"name", "name"},
                                                         {"waypoint", "name"},
                                                         {"label", "name"},
                                                         {"x", "x"},
                                                         {"xm", "x"},
                                                         {"y", "y"},
                                                         {"ym", "y"},
                                                         {"yawrad", "yaw_rad"},
                                                         {"yaw", "heading"},
                                                         {"heading", "heading"},
                                                         {"yaw\xc2\xb0", "degrees"},
                                                         {"yawdeg", "degrees"},
                                                         {"headingdeg", "degrees"},
                                                         {"theta", "heading"},
                                                         {"heading\xc2\xb0", "degrees"},
                                                         {"tags", "tags"},
                                                         {"tag", "tags"},
                                                         {"type", "type"},
                                                         {"kind", "type"},
                                                         {"frame", "frame"},
                                                         {"map", "map"}};
  const auto found = kNames.find(lowered(field));
  return found == kNames.end() ? std::string() : found->second;
}

bool isBlank(const std::string& field) { return field.find_first_not_of(" \t") == std::string::npos; }

std::string withPoint(std::string field, const TableShape& shape) {
  if (shape.decimal_comma) std::replace(field.begin(), field.end(), ',', '.');
  return field;
}

bool looksLikeDecimalComma(const std::string& field) {
  if (field.find('.') != std::string::npos || std::count(field.begin(), field.end(), ',') != 1) return false;
  std::string pointed = field;
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  return csvNumber(pointed).has_value();
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
  if (x >= 1) header[x - 1] = std::string("name");
  if (x >= 2) header[x - 2] = std::string("id");
  if (x < columns) {
    header[x] = std::string("x");
    header[x + 1] = std::string("y");
    std::size_t next = x + 2;
    if (next < columns && numbers[next])
      header[next++] = std::string(shape.turns_in_degrees ? "degrees" : "yaw_rad");
    if (next < columns) header[next] = std::string("tags");
  }
  return header;
}

}  // namespace

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
  if (text.size() > kMaxWantedBytes)
    return tl::make_unexpected(PastedWaypointsText::tr("It is larger than 64 MiB."));
  if (!QUtf8StringView(text.data(), qsizetype(text.size())).isValidUtf8())
    return tl::make_unexpected(PastedWaypointsText::tr("It is not UTF-8 text."));
  auto records = csvRecords(text, shape.separator);
  if (!records) return tl::make_unexpected(records.error());
  if (records->empty()) return tl::make_unexpected(PastedWaypointsText::tr("It is empty."));
  std::size_t columns = 0;
  for (const CsvRecord& record : *records) columns = std::max(columns, record.fields.size());
  if (columns > kMostColumns)
    return tl::make_unexpected(PastedWaypointsText::tr("It has too many columns for a waypoint list."));
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
      return tl::make_unexpected(
          PastedWaypointsText::tr("It needs two adjacent columns of numbers: x and y in metres. Or start "
                                  "with a row that names the columns: name, x, y, heading, tags."));
    records->insert(records->begin(), CsvRecord{records->front().line, {}});
  }
  // Converts to CSV conventions: decimal points, radians, and a required column.
  for (std::size_t i = 1; i < records->size(); ++i) {
    CsvRecord& record = (*records)[i];
    for (std::size_t column = 0; column < columns; ++column) {
      std::string& field = record.fields[column];
      const std::string& what = header[column];
      if (what == "x" || what == "y" || what == "yaw_rad" || what == "degrees")
        field = withPoint(field, shape);
      if (what != "degrees") continue;
      const auto degrees = csvNumber(field);
      if (!degrees && !isBlank(field))
        return tl::make_unexpected(
            PastedWaypointsText::tr("Line %1: the heading \"%2\" is not a number such as 90.")
                .arg(QString::number(record.line), QString::fromStdString(field.substr(0, 80))));
      field = degrees ? csvNumber(geometry::radiansFromDegrees(*degrees)) : std::string();
    }
  }
  std::vector<bool> used(columns);
  for (std::size_t column = 0; column < columns; ++column) {
    if (header[column] == "degrees") header[column] = std::string("yaw_rad");
    used[column] = shape.header || !header[column].empty();
  }
  for (CsvRecord& record : *records) {
    if (record.fields.empty()) record.fields = header;
    std::vector<std::string> kept;
    for (std::size_t column = 0; column < columns; ++column) {
      if (used[column]) kept.push_back(&record == &records->front() ? header[column] : record.fields[column]);
    }
    const bool has_name = std::find(header.begin(), header.end(), "name") != header.end();
    if (!has_name) kept.push_back(&record == &records->front() ? "name" : "");
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
  const bool types =
      std::any_of(points.begin(), points.end(), [](const auto& one) { return !one.type.empty(); });
  std::vector<std::string> header{"id", "name", "x", "y", "yaw_rad", "tags"};
  if (types) header.push_back("type");
  std::string text = csvLine(header, '\t') + "\n";
  for (const map::Waypoint& point : points) {
    std::vector<std::string> fields{point.id,
                                    point.name,
                                    csvNumber(point.position_m.x()),
                                    csvNumber(point.position_m.y()),
                                    point.yaw_rad ? csvNumber(*point.yaw_rad) : std::string(),
                                    point.tags.empty() ? std::string() : csvLine(point.tags)};
    if (types) fields.push_back(point.type);
    text += csvLine(fields, '\t') + "\n";
  }
  return text;
}

}  // namespace mapwright::exchange
