#include "app/waypoint_file.h"

#include <string_view>

#include <QCoreApplication>
#include <QFileInfo>

#include "app/output_paths.h"
#include "app/robot_factory.h"
#include "disk/file_error.h"
#include "disk/read_file.h"
#include "exchange/waypoint_json.h"
#include "exchange/waypoint_table.h"
#include "robot/files/waypoint_file.h"
#include "sentences/fault_sentence.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class WaypointFileText {
  Q_DECLARE_TR_FUNCTIONS(WaypointFile)
};

using words::text;

constexpr const char* kStandardInput = "-";

/// After a UTF-8 byte order mark and blanks.
bool beginsLikeJson(std::string_view bytes) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{';
}

std::optional<WaypointFileKind> kindCalled(const QString& word) {
  if (word == QLatin1String("csv")) return WaypointFileKind::Csv;
  if (word == QLatin1String("geojson") || word == QLatin1String("json")) return WaypointFileKind::GeoJson;
  return std::nullopt;
}

}  // namespace

tl::expected<WaypointFileKind, QString> waypointFileKind(const std::string& path, const std::string& format) {
  if (!format.empty()) {
    if (const auto kind = kindCalled(text(format))) return *kind;
    return tl::make_unexpected(
        WaypointFileText::tr("--format %1: must be csv or geojson.").arg(text(format)));
  }
  if (isStandardOutput(text(path))) return WaypointFileKind::GeoJson;
  if (const auto kind = kindCalled(QFileInfo(text(path)).suffix().toLower())) return *kind;
  return tl::make_unexpected(
      WaypointFileText::tr("%1: the name must end in .geojson or .csv; or pass --format geojson or csv.")
          .arg(text(path)));
}

tl::expected<std::string, disk::FileError> bytesOf(const std::string& path, std::size_t most) {
  return path == kStandardInput ? disk::readStandardInput(most + 1) : disk::readFile(path, most + 1);
}

QString inputCalled(const std::string& path) {
  return path == kStandardInput ? WaypointFileText::tr("The standard input") : text(path);
}

tl::expected<exchange::WantedList, QString> readWantedFile(const std::string& path,
                                                           const std::string& format) {
  const bool by_content = path == kStandardInput && format.empty();
  auto kind = by_content ? tl::expected<WaypointFileKind, QString>(WaypointFileKind::GeoJson)
                         : waypointFileKind(path, format);
  if (!kind) return tl::make_unexpected(kind.error());
  const QString called = inputCalled(path);
  const auto bytes = bytesOf(path, exchange::kMaxWantedBytes);
  if (!bytes)
    return tl::make_unexpected(
        WaypointFileText::tr("%1 cannot be read: %2.").arg(called, sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > exchange::kMaxWantedBytes)
    return tl::make_unexpected(WaypointFileText::tr("%1 is larger than 64 MiB.").arg(called));
  if (by_content && !beginsLikeJson(*bytes)) kind = WaypointFileKind::Csv;
  exchange::WantedFile wanted =
      *kind == WaypointFileKind::Csv ? exchange::wantedFromCsv(*bytes) : exchange::wantedFromGeoJson(*bytes);
  if (!wanted) return tl::make_unexpected(QStringLiteral("%1: %2").arg(called, wanted.error()));
  return wanted;
}

std::vector<std::string> waypointSources(const std::string& address, const map::MapKey& key) {
  std::vector<std::string> sources = sourceFilesOf(text(address), key.id, {});
  for (std::size_t i = 0, maps = sources.size(); i < maps; ++i)
    sources.push_back(robot::files::waypointPathOf(sources[i]));
  return sources;
}

}  // namespace mapwright::app
