#include "replay/track_file.h"

#include <cmath>
#include <limits>
#include <optional>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>

namespace mapwright::replay {
namespace {

using TrackRead = tl::expected<std::vector<TrackPoint>, std::size_t>;
/// Names of more are not kept: their numbers may be anything.
constexpr double kMostMaps = 10'000;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::optional<double> numberFrom(const QByteArray& word) {
  bool ok = false;
  const double value = word.trimmed().toDouble(&ok);
  return ok ? std::optional(value) : std::nullopt;
}

TrackRead fromCsv(const QList<QByteArray>& lines) {
  const QList<QByteArray> head = lines[0].trimmed().split(',');
  const qsizetype stamp = head.indexOf("stamp_s"), x = head.indexOf("x_m"), y = head.indexOf("y_m"),
                  yaw = head.indexOf("yaw_rad"), piece = head.indexOf("piece"), map = head.indexOf("map");
  if (stamp < 0 || x < 0 || y < 0) return tl::make_unexpected(1);
  std::vector<TrackPoint> track;
  for (qsizetype i = 1; i < lines.size(); ++i) {
    if (lines[i].trimmed().isEmpty()) continue;
    const QList<QByteArray> words = lines[i].split(',');
    const auto number = [&](qsizetype column, double missing) -> std::optional<double> {
      if (column < 0) return missing;
      return column < words.size() ? numberFrom(words[column]) : std::nullopt;
    };
    const auto stamp_s = number(stamp, 0), x_m = number(x, 0), y_m = number(y, 0), yaw_rad = number(yaw, 0),
               of_piece = number(piece, 0), of_map = number(map, 0);
    const auto counts = [](const std::optional<double>& value) {
      return value && *value >= 0 && *value < 1e9;
    };
    if (!stamp_s || !x_m || !y_m || !yaw_rad || !counts(of_piece) || !counts(of_map))
      return tl::make_unexpected(std::size_t(i + 1));
    track.push_back({*stamp_s, {*x_m, *y_m, *yaw_rad}, 0, 0, std::size_t(*of_piece), std::size_t(*of_map)});
  }
  return track;
}

TrackRead fromTum(const QList<QByteArray>& lines) {
  std::vector<TrackPoint> track;
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const QByteArray line = lines[i].simplified();
    if (line.isEmpty() || line.startsWith('#')) continue;
    std::vector<double> numbers;
    for (const QByteArray& word : line.split(' ')) {
      if (const auto number = numberFrom(word)) numbers.push_back(*number);
    }
    if (numbers.size() != 8) return tl::make_unexpected(std::size_t(i + 1));
    track.push_back({numbers[0], {numbers[1], numbers[2], 2 * std::atan2(numbers[6], numbers[7])}});
  }
  return track;
}

TrackRead fromGeoJson(const QByteArray& text, std::vector<map::MapIdentity>* maps) {
  const QJsonObject all = QJsonDocument::fromJson(text).object();
  const QJsonValue features = all[QLatin1String("features")];
  if (!features.isArray()) return tl::make_unexpected(0);
  std::vector<TrackPoint> track;
  std::size_t piece = 0;
  for (const QJsonValue feature : features.toArray()) {
    const QJsonValue geometry = feature[QLatin1String("geometry")],
                     properties = feature[QLatin1String("properties")];
    const QJsonArray stamps = properties[QLatin1String("stamps_s")].toArray(),
                     yaws = properties[QLatin1String("yaws_rad")].toArray(),
                     there = geometry[QLatin1String("coordinates")].toArray();
    const bool line = geometry[QLatin1String("type")] == QLatin1String("LineString");
    const double map = properties[QLatin1String("map")].toDouble();
    if (!(map >= 0 && map < 1e9)) return tl::make_unexpected(0);
    const QJsonArray places = line ? there : QJsonArray{there};
    if ((!line && geometry[QLatin1String("type")] != QLatin1String("Point")) ||
        stamps.size() != places.size())
      return tl::make_unexpected(0);
    for (qsizetype i = 0; i < places.size(); ++i) {
      track.push_back(
          {stamps[i].toDouble(kNoNumber),
           {places[i][0].toDouble(kNoNumber), places[i][1].toDouble(kNoNumber), yaws[i].toDouble()},
           0,
           0,
           piece,
           std::size_t(map)});
    }
    const map::MapIdentity called{properties[QLatin1String("map_uid")].toString().toStdString(),
                                  properties[QLatin1String("map_name")].toString().toStdString()};
    if (maps && !called.empty() && map < kMostMaps) {
      if (maps->size() <= std::size_t(map)) maps->resize(std::size_t(map) + 1);
      (*maps)[std::size_t(map)] = called;
    }
    ++piece;
  }
  return track;
}

}  // namespace

bool isTrackName(std::string_view path) {
  const QByteArray name = QByteArray(path.data(), qsizetype(path.size())).toLower();
  for (const char* const ending : {".csv", ".geojson", ".json", ".tum", ".txt"}) {
    if (name.endsWith(ending)) return true;
  }
  return false;
}

tl::expected<std::vector<TrackPoint>, std::size_t> trackFrom(std::string_view text,
                                                             std::vector<map::MapIdentity>* maps) {
  const auto bytes = QByteArray::fromRawData(text.data(), qsizetype(text.size()));
  const QByteArray begin = bytes.left(200).trimmed();
  if (begin.startsWith('{')) return fromGeoJson(bytes, maps);
  const QList<QByteArray> lines = bytes.split('\n');
  return begin.contains("stamp_s") ? fromCsv(lines) : fromTum(lines);
}

}  // namespace mapwright::replay
