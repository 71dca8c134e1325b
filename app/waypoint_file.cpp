#include "app/waypoint_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "app/output_paths.h"
#include "app/robot_factory.h"
#include "app/waypoint_csv.h"
#include "app/waypoint_json.h"
#include "disk/read_file.h"
#include "reasons/file_reason.h"
#include "robot/files/waypoint_file.h"
#include "sentences/reason_sentence.h"

namespace mapwright::app {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(WaypointFile)
};

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

std::optional<WaypointFileKind> kindCalled(const QString& word) {
  if (word == QLatin1String("csv")) return WaypointFileKind::Csv;
  if (word == QLatin1String("geojson") || word == QLatin1String("json")) return WaypointFileKind::GeoJson;
  return std::nullopt;
}

}  // namespace

tl::expected<WaypointFileKind, QString> waypointFileKind(const std::string& path, const std::string& format) {
  if (!format.empty()) {
    if (const auto kind = kindCalled(text(format))) return *kind;
    return tl::make_unexpected(Words::tr("--format %1: give csv or geojson.").arg(text(format)));
  }
  if (isStandardOutput(text(path))) return WaypointFileKind::GeoJson;
  if (const auto kind = kindCalled(QFileInfo(text(path)).suffix().toLower())) return *kind;
  return tl::make_unexpected(
      Words::tr("%1: the name ends in .geojson or .csv; or give --format geojson or csv.").arg(text(path)));
}

WantedFile readWantedFile(const std::string& path, const std::string& format) {
  const auto kind = waypointFileKind(path, format);
  if (!kind) return tl::make_unexpected(kind.error());
  const auto bytes = disk::readFile(path, kMaxWantedBytes + 1);
  if (!bytes)
    return tl::make_unexpected(Words::tr("%1 cannot be read: %2.")
                                   .arg(text(path), sentences::wordsOf(reasons::causeOf(bytes.error()))));
  if (bytes->size() > kMaxWantedBytes)
    return tl::make_unexpected(Words::tr("%1 is larger than 64 MiB.").arg(text(path)));
  WantedFile wanted = *kind == WaypointFileKind::Csv ? wantedFromCsv(*bytes) : wantedFromGeoJson(*bytes);
  if (!wanted) return tl::make_unexpected(QStringLiteral("%1: %2").arg(text(path), wanted.error()));
  return wanted;
}

std::vector<std::string> waypointSources(const std::string& address, const map::MapKey& key) {
  std::vector<std::string> sources = sourceFilesOf(text(address), key.id, {});
  for (std::size_t i = 0, maps = sources.size(); i < maps; ++i)
    sources.push_back(robot::files::waypointPathOf(sources[i]));
  return sources;
}

}  // namespace mapwright::app
