#include "compare/picture_view.h"

#include <cmath>

#include <QFileInfo>
#include <QJsonDocument>

#include "disk/read_file.h"
#include "geometry/pose.h"

namespace mapwright::compare {
namespace {

constexpr std::size_t kMostReportBytes = std::size_t(64) << 20;

QJsonObject reportIn(const QString& path) {
  const auto bytes = disk::readFile(path.toStdString(), kMostReportBytes);
  return bytes ? QJsonDocument::fromJson(QByteArray::fromStdString(*bytes)).object() : QJsonObject();
}

QStringList reportsBeside(const QString& picture) {
  const QFileInfo info(picture);
  const QString suffix = QStringLiteral(".json");
  return {info.path() + QLatin1Char('/') + info.completeBaseName() + suffix, picture + suffix};
}

/// Farther away places are no longer told apart in a picture.
constexpr double kFarthestM = 1e9;

double toThousandths(double metres) { return std::round(metres * 1000) / 1000; }

}  // namespace

QJsonObject jsonOf(const geometry::ViewTransform& view) {
  return {{QStringLiteral("center"), QJsonArray{view.center_m.x(), view.center_m.y()}},
          {QStringLiteral("scale"), view.scale_m_per_px},
          {QStringLiteral("size"), QJsonArray{view.width_px, view.height_px}},
          {QStringLiteral("rotation_deg"), geometry::degreesFromRadians(view.rotation_rad)}};
}

std::optional<geometry::ViewTransform> viewOf(const QJsonObject& report) {
  const QJsonObject json = report[QLatin1String("view")].toObject();
  const QJsonArray center = json[QLatin1String("center")].toArray(),
                   size = json[QLatin1String("size")].toArray();
  geometry::ViewTransform view;
  view.center_m = {center.at(0).toDouble(NAN), center.at(1).toDouble(NAN)};
  view.scale_m_per_px = json[QLatin1String("scale")].toDouble();
  view.width_px = size.at(0).toInt();
  view.height_px = size.at(1).toInt();
  view.rotation_rad = geometry::radiansFromDegrees(json[QLatin1String("rotation_deg")].toDouble());
  const bool useful = (view.center_m.array().abs() <= kFarthestM).all() && std::isfinite(view.rotation_rad) &&
                      view.scale_m_per_px >= geometry::kMinScaleMPerPx &&
                      view.scale_m_per_px <= geometry::kMaxScaleMPerPx && view.width_px > 0 &&
                      view.height_px > 0;
  return useful ? std::optional(view) : std::nullopt;
}

bool isOf(const geometry::ViewTransform& view, PictureSize size) {
  return view.width_px == size.width && view.height_px == size.height;
}

std::optional<geometry::ViewTransform> viewIn(const QString& report) { return viewOf(reportIn(report)); }

std::optional<geometry::ViewTransform> viewBeside(const QString& picture, PictureSize size) {
  for (const QString& name : reportsBeside(picture)) {
    const auto view = viewIn(name);
    if (view && isOf(*view, size)) return view;
  }
  return std::nullopt;
}

geometry::WorldRect worldOf(const geometry::ViewTransform& view, const PixelBox& box) {
  geometry::WorldRect world;
  for (const int x : {box.x, box.x + box.width}) {
    for (const int y : {box.y, box.y + box.height}) world.extend(view.worldFromPixel({double(x), double(y)}));
  }
  return world;
}

QJsonArray clustersJson(const Comparison& comparison, const std::optional<geometry::ViewTransform>& view) {
  QJsonArray clusters;
  for (const Cluster& cluster : comparison.clusters) {
    const PixelBox& box = cluster.box;
    QJsonObject json{{QStringLiteral("box"), QJsonArray{box.x, box.y, box.width, box.height}},
                     {QStringLiteral("pixels"), qint64(cluster.pixels)}};
    if (view) {
      const geometry::WorldRect world = worldOf(*view, box);
      json[QStringLiteral("world")] = QJsonArray{toThousandths(world.min_x), toThousandths(world.min_y),
                                                 toThousandths(world.width()), toThousandths(world.height())};
    }
    clusters.append(json);
  }
  return clusters;
}

}  // namespace mapwright::compare
