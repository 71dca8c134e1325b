#include "ui/maps/map_files.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace mapwright::window {

namespace {

bool endsWithAny(const QString& path, std::initializer_list<const char*> suffixes) {
  return std::any_of(suffixes.begin(), suffixes.end(), [&](const char* suffix) {
    return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
  });
}

QString exact(double value) { return QString::number(value, 'g', 15); }

}  // namespace

bool isMapYaml(const QString& path) { return endsWithAny(path, {".yaml", ".yml"}); }
bool isBarePicture(const QString& path) { return endsWithAny(path, {".png", ".pgm", ".bmp"}); }
bool isRecordingFile(const QString& path) { return endsWithAny(path, {".mcap", ".bag"}); }

QString fileAddress(const QString& path, const std::optional<PicturePlacement>& placement) {
  const QString address = QStringLiteral("file:") + QDir::cleanPath(QFileInfo(path).absoluteFilePath());
  if (!placement) return address;
  return address + QStringLiteral("?resolution=") + exact(placement->resolution_m) +
         QStringLiteral("&origin=") + exact(placement->origin.x_m) + QLatin1Char(',') +
         exact(placement->origin.y_m) + QLatin1Char(',') + exact(placement->origin.yaw_rad);
}

QString droppedMap(const QList<QUrl>& urls) {
  QString picture;
  for (const QUrl& url : urls) {
    if (!url.isLocalFile()) continue;
    const QString path = url.toLocalFile();
    // Dropping a map.yaml together with its picture means the map.
    if (isMapYaml(path) || isRecordingFile(path) || QFileInfo(path).isDir()) return path;
    if (picture.isEmpty() && isBarePicture(path)) picture = path;
  }
  return picture;
}

QString mapFileFilter() {
  return QCoreApplication::translate(
      "window",
      "Maps and recordings (*.yaml *.yml *.png *.pgm *.bmp *.mcap *.bag *.YAML *.PNG *.PGM *.BMP);;"
      "ROS maps (*.yaml *.yml);;Pictures (*.png *.pgm *.bmp);;Recordings (*.mcap *.bag);;All files (*)");
}

}  // namespace mapwright::window
