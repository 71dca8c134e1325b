#include "exchange/waypoint_file.h"

#include <algorithm>

#include <QCoreApplication>
#include <QUtf8StringView>

#include "exchange/waypoint_json.h"
#include "exchange/waypoint_poses.h"
#include "exchange/waypoint_table.h"

namespace mapwright::exchange {
namespace {

class WaypointFileText {
  Q_DECLARE_TR_FUNCTIONS(WaypointFile)
};

/// "key: value", "key:", "- item", "---".
bool looksLikeYaml(std::string_view line) {
  const std::size_t first = line.find_first_not_of(' ');
  if (first == std::string_view::npos) return false;
  line.remove_prefix(first);
  if (line == "---" || line == "-" || line.starts_with("- ")) return true;
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  const bool a_key = line.substr(0, colon).find_first_of(",;\t\"") == std::string_view::npos;
  return a_key && (colon + 1 == line.size() || line[colon + 1] == ' ');
}

}  // namespace

std::optional<WaypointFormat> waypointFormatCalled(const QString& word) {
  const auto is = [&](auto... names) { return ((word == QLatin1String(names)) || ...); };
  if (is("csv", "tsv", "txt")) return WaypointFormat::Table;
  if (is("geojson", "json")) return WaypointFormat::Json;
  if (is("yaml", "yml")) return WaypointFormat::Yaml;
  return std::nullopt;
}

WaypointFormat waypointFormatOf(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos || line[first] == '#') continue;
    if (line[first] == '{' || line[first] == '[') return WaypointFormat::Json;
    return looksLikeYaml(line) ? WaypointFormat::Yaml : WaypointFormat::Table;
  }
  return WaypointFormat::Table;
}

WantedFile wantedFromFile(std::string_view bytes, WaypointFormat format, AngleUnit angles) {
  if (bytes.size() > kMaxWantedBytes) return wrong(WaypointFileText::tr("It is larger than 64 MiB."));
  if (format == WaypointFormat::Table) return wantedFromCsv(bytes, angles);
  if (format == WaypointFormat::Json) {
    const auto json = jsonOf(bytes);
    if (!json) return wrong(json.error());
    const QJsonObject root = json->object();
    const QJsonValue type = root.value(QLatin1String("type"));
    const bool geo = root.contains(QLatin1String("features")) || root.contains(QLatin1String("geometry")) ||
                     root.contains(QLatin1String("geometries")) ||
                     (type.isString() && root.contains(QLatin1String("coordinates"))) ||
                     type.toString() == QLatin1String("FeatureCollection");
    if (geo) return wantedFromGeoJson(root, angles);
    const FileValue whole =
        json->isArray() ? fromJson(QJsonValue(json->array())) : fromJson(QJsonValue(root));
    return wantedFromPoses({whole}, angles);
  }
  if (!QUtf8StringView(bytes.data(), qsizetype(bytes.size())).isValidUtf8())
    return wrong(WaypointFileText::tr("It is not UTF-8 text."));
  const auto documents = fromYaml(bytes);
  if (!documents) return wrong(documents.error());
  return wantedFromPoses(*documents, angles);
}

}  // namespace mapwright::exchange
