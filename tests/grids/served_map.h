// A written map.yaml, read by the published rules of map_server, AMCL and nav2's static layer. Shares no code
// with the program.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QMap>
#include <QString>

namespace mapwright::test {

/// Releases of map_server differ: nav2 compared strictly with the thresholds at first, later not; ROS 1
/// interpolates to 99.
enum class MapServer { Nav2, Nav2Later, Ros1 };

struct ServedMap {
  int width = 0, height = 0;
  QString mode;
  double occupied_thresh = 0, free_thresh = 0;
  std::vector<std::uint8_t> grays, alphas;  // of the picture
  std::vector<int> cells;                   // -1 unknown, 0..100; top row first, like the picture
};

namespace served {

inline QMap<QString, QString> keysOf(const QString& yaml) {
  QFile file(yaml);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QMap<QString, QString> keys;
  for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
    const qsizetype colon = line.indexOf(QLatin1Char(':'));
    if (colon > 0) keys[line.left(colon)] = line.mid(colon + 1).trimmed().remove(QLatin1Char('"'));
  }
  return keys;
}

inline bool readPicture(const QString& path, ServedMap& map) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return false;
  const QByteArray bytes = file.readAll();
  if (bytes.startsWith("P5\n")) {
    qsizetype end = 0;
    for (int line = 0; line < 3; ++line) end = bytes.indexOf('\n', end) + 1;
    const QList<QByteArray> size = bytes.mid(3, end - 3).simplified().split(' ');
    map.width = size[0].toInt();
    map.height = size[1].toInt();
    if (size.size() != 3 || size[2] != "255" || bytes.size() - end != qsizetype(map.width) * map.height)
      return false;
    map.grays.assign(bytes.begin() + end, bytes.end());
    map.alphas.assign(map.grays.size(), 255);
    return true;
  }
  const QImage image = QImage::fromData(bytes).convertToFormat(QImage::Format_RGBA8888);
  map.width = image.width();
  map.height = image.height();
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const std::uint8_t* const pixel = image.constScanLine(y) + 4 * x;
      if (pixel[0] != pixel[1] || pixel[0] != pixel[2]) return false;
      map.grays.push_back(pixel[0]);
      map.alphas.push_back(pixel[3]);
    }
  }
  return map.width > 0;
}

inline int cellOf(const ServedMap& map, std::uint8_t gray, std::uint8_t alpha, MapServer server) {
  const double shade = gray / 255.0, occupied = 1.0 - shade;
  if (map.mode == QLatin1String("raw")) {
    if (server == MapServer::Ros1) return gray == 255 ? -1 : gray;
    const double value = std::round(shade * 255);
    return value <= 100 ? int(value) : -1;
  }
  const bool scale = map.mode == QLatin1String("scale");
  if (scale && server != MapServer::Ros1 && alpha != 255) return -1;
  const bool inclusive = server == MapServer::Nav2Later;
  if (occupied > map.occupied_thresh || (inclusive && occupied == map.occupied_thresh)) return 100;
  if (occupied < map.free_thresh || (inclusive && occupied == map.free_thresh)) return 0;
  if (!scale || alpha == 0) return -1;
  const double ratio = (occupied - map.free_thresh) / (map.occupied_thresh - map.free_thresh);
  return server == MapServer::Ros1 ? int(99 * ratio) : int(std::rint(ratio * 100));
}

}  // namespace served

inline std::optional<ServedMap> servedMap(const QString& yaml, MapServer server) {
  const auto keys = served::keysOf(yaml);
  ServedMap map;
  map.mode = keys.value(QStringLiteral("mode"));
  map.occupied_thresh = keys.value(QStringLiteral("occupied_thresh")).toDouble();
  map.free_thresh = keys.value(QStringLiteral("free_thresh")).toDouble();
  if (keys.value(QStringLiteral("negate")) != QLatin1String("0")) return std::nullopt;
  const QString image = QFileInfo(yaml).dir().filePath(keys.value(QStringLiteral("image")));
  if (!served::readPicture(image, map)) return std::nullopt;
  for (std::size_t n = 0; n < map.grays.size(); ++n)
    map.cells.push_back(served::cellOf(map, map.grays[n], map.alphas[n], server));
  return map;
}

/// AMCL: convertMap().
enum class AmclCell { Free = -1, Unknown = 0, Occupied = 1 };
inline AmclCell amclCell(int cell) {
  return cell == 0 ? AmclCell::Free : cell == 100 ? AmclCell::Occupied : AmclCell::Unknown;
}
/// nav2_costmap_2d::StaticLayer::interpretValue() as it is set up by default: a wall, no information, or
/// free.
enum class CostmapCell { Free, NoInformation, Lethal };
inline CostmapCell costmapCell(int cell) {
  const auto value = static_cast<unsigned char>(cell);
  return value == 255 ? CostmapCell::NoInformation : value >= 100 ? CostmapCell::Lethal : CostmapCell::Free;
}

}  // namespace mapwright::test
