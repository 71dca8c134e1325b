#include "robot/files/local_maps.h"

#include <algorithm>
#include <cmath>
#include <sys/stat.h>

#include <QCollator>
#include <QDir>
#include <QFileInfo>

#include "disk/file_error.h"
#include "disk/read_file.h"
#include "geometry/rect.h"
#include "overlays/overlay_document.h"
#include "overlays/overlay_shapes.h"
#include "robot/files/faults.h"

namespace mapwright::robot::files {
namespace {

constexpr qsizetype kMostMaps = 10'000;
constexpr double kUsualResolutionM = 0.05;
constexpr std::size_t kMostOverlayFileBytes = std::size_t(256) << 20;
constexpr double kAroundOverlaysM = 5;
constexpr int kMostEmptyEdge = 2'000;  // cells

bool hasSuffix(const QString& path, std::initializer_list<const char*> suffixes) {
  for (const char* suffix : suffixes) {
    if (path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive)) return true;
  }
  return false;
}

bool isYaml(const QString& path) { return hasSuffix(path, {".yaml", ".yml"}); }

/// The real path of a file, with links resolved as far as possible.
QString trueName(const QString& path) {
  const QString canonical = QFileInfo(path).canonicalFilePath();
  return canonical.isEmpty() ? QDir::cleanPath(path) : canonical;
}

QString trueFolder(const QString& path) { return QFileInfo(trueName(path)).absolutePath(); }

bool liesBelow(const QString& folder, const QString& above) {
  return folder == above ||
         folder.startsWith(above.endsWith(QLatin1Char('/')) ? above : above + QLatin1Char('/'));
}

std::string readingText(const map::CellReading& reading) {
  return std::to_string(int(reading.mode)) + (reading.negate ? "n" : "p") + " " +
         std::to_string(reading.occupied_thresh) + " " + std::to_string(reading.free_thresh);
}

void addNote(map::WholeMap& whole, map::Severity severity, Fault odd) {
  whole.notes.push_back({severity, map::subjectOf(whole.key, whole.name), std::move(odd)});
}

std::optional<Fault> unreadableReason(const QString& path) {
  const QFileInfo info(path);
  const std::string name = path.toStdString();
  if (!info.exists()) return Fault(fault::NoSuchFile, {name});
  if (!info.isFile()) return Fault(faultText("files", "%1 is not a file."), {name});
  if (!info.isReadable())
    return Fault(faultText("files", "You are not allowed to read the file %1."), {name});
  return std::nullopt;
}

tl::expected<map::WholeMap, Fault> fromYaml(const QString& path, YamlShelf& yamls) {
  auto yaml = yamls.read(path.toStdString());
  if (!yaml) return refused(yaml.error());
  map::WholeMap whole;
  whole.name = QFileInfo(path).fileName().toStdString();
  whole.grid = yaml->grid;
  whole.reading = yaml->reading;
  const QString folder = QFileInfo(path).absolutePath();
  const QString picture = QDir::cleanPath(QDir(folder).absoluteFilePath(QString::fromStdString(yaml->image)));
  if (auto why = unreadableReason(picture)) return refused({fault::PictureNotReadable, {}, {*why}});
  whole.path = picture.toStdString();
  for (Fault& odd : yaml->notes) addNote(whole, map::Severity::Warning, std::move(odd));
  if (!liesBelow(trueFolder(picture), trueFolder(path))) {
    addNote(whole, map::Severity::Info,
            {faultText("files", "Its picture is outside its folder: %1."), {whole.path}});
  }
  return whole;
}

Fault several(const QStringList& yamls) {
  constexpr qsizetype kMostNames = 3;
  QStringList names;
  for (const QString& path : yamls.mid(0, kMostNames)) names << QFileInfo(path).fileName();
  const std::string first = names.join(QStringLiteral(", ")).toStdString();
  if (yamls.size() <= kMostNames) return {fault::SeveralYamls, {first}};
  return {
      faultText(
          "files",
          "Several map.yaml files name this picture, so none is used: %1 and %2 more. Open the right one."),
      {first, std::int64_t(yamls.size() - kMostNames)}};
}

map::WholeMap fromPicture(const QString& path, const PicturePlace& place, const QStringList& named_by) {
  map::WholeMap whole;
  whole.name = QFileInfo(path).fileName().toStdString();
  whole.path = path.toStdString();
  whole.grid.resolution_m = place.resolution_m.value_or(kUsualResolutionM);
  whole.grid.origin = place.origin.value_or(geometry::Pose2{});
  if (!place.resolution_m) {
    addNote(whole, map::Severity::Warning,
            faultText("files",
                      "A picture alone does not tell the size of its cells. 0.05 m is assumed; "
                      "append ?resolution=0.05 to the path to change it."));
  }
  const QString stem = QFileInfo(path).absolutePath() + QLatin1Char('/') + QFileInfo(path).completeBaseName();
  for (const char* suffix : {".yaml", ".yml"}) {
    const QString beside = stem + QLatin1String(suffix);
    if (!named_by.isEmpty() || place.resolution_m || !QFileInfo::exists(beside)) continue;
    addNote(
        whole, map::Severity::Info,
        {faultText(
             "files",
             "%1 in the same folder does not name this picture as its image, or is not a valid map.yaml."),
         {QFileInfo(beside).fileName().toStdString()}});
    break;
  }
  if (!named_by.isEmpty()) {
    addNote(whole, map::Severity::Warning, several(named_by));
  }
  return whole;
}

/// Nothing is known of it but where its overlays lie.
tl::expected<map::WholeMap, Fault> fromOverlays(const QString& path) {
  const std::string name = path.toStdString();
  auto bytes = disk::readFile(name, kMostOverlayFileBytes + 1);
  const auto unreadable = [&](Fault why) {
    return refused({fault::WaypointFileNotRead, {name}, {std::move(why)}});
  };
  if (!bytes) return unreadable(bytes.error().cause);
  if (bytes->size() > kMostOverlayFileBytes) return unreadable({fault::FileTooLarge, {"256 MiB"}});
  const auto document = overlays::OverlayDocument::read(*bytes);
  if (!document) return unreadable(document.error());
  if (!overlays::OverlayDocument::isCollection(*bytes)) return unreadable(fault::NotAFeatureCollection);
  geometry::WorldRect around;
  for (const overlays::Feature& feature : document->features()) {
    for (const overlays::Path& shape : overlays::shapesOf(feature).paths) {
      for (const Eigen::Vector2d& point : shape.points) around.extend(point);
    }
  }
  if (around.empty()) around.extend(Eigen::Vector2d(0, 0));
  around = around.grown(kAroundOverlaysM);
  const double edge_m = std::max(around.max_x - around.min_x, around.max_y - around.min_y);
  map::WholeMap whole;
  whole.name = QFileInfo(path).fileName().toStdString();
  whole.grid.resolution_m = std::clamp(edge_m / kMostEmptyEdge, kUsualResolutionM, 1000.0);
  const auto cells = [&](double length_m) {
    return std::clamp(int(std::ceil(length_m / whole.grid.resolution_m)), 1, 2 * kMostEmptyEdge);
  };
  whole.grid.width = cells(around.max_x - around.min_x);
  whole.grid.height = cells(around.max_y - around.min_y);
  whole.grid.origin = {std::max(around.min_x, -overlays::kFarthestM),
                       std::max(around.min_y, -overlays::kFarthestM), 0};
  whole.cells = std::make_shared<const std::vector<std::int8_t>>(
      std::size_t(whole.grid.width) * std::size_t(whole.grid.height), std::int8_t(-1));
  return whole;
}

}  // namespace

bool isPicture(const QString& path) { return hasSuffix(path, {".png", ".pgm", ".bmp"}); }
bool isMapFile(const QString& path) { return isYaml(path) || isPicture(path); }
bool isOverlayFile(const QString& path) { return hasSuffix(path, {".geojson"}); }

QString mapBeside(const QString& overlay_file) {
  const QFileInfo file(overlay_file);
  QString stem = file.absolutePath() + QLatin1Char('/') + file.completeBaseName();
  const QString kind = QStringLiteral(".overlays");
  if (stem.endsWith(kind, Qt::CaseInsensitive)) stem.chop(kind.size());
  for (const char* suffix : {".yaml", ".yml", ".png", ".pgm", ".bmp"}) {
    const QString beside = stem + QLatin1String(suffix);
    if (QFileInfo(beside).isFile()) return beside;
  }
  return {};
}

QStringList mapFilesIn(const QString& folder) {
  QStringList names;
  for (const QString& name : QDir(folder).entryList(QDir::Files, QDir::Unsorted)) {
    if (isMapFile(name)) names << name;
  }
  // "floor2" before "floor10", in every locale; names that differ only in case have a fixed order.
  QCollator order(QLocale(QLocale::English, QLocale::UnitedStates));
  order.setNumericMode(true);
  order.setCaseSensitivity(Qt::CaseInsensitive);
  std::sort(names.begin(), names.end(), [&](const QString& one, const QString& other) {
    const int compared = order.compare(one, other);
    return compared != 0 ? compared < 0 : one < other;
  });
  return names.mid(0, kMostMaps);
}

QString mapPathOf(const QString& path, const map::MapKey& key) {
  if (key.kind != map::MapKind::File) return {};
  const QString id = QString::fromStdString(key.id);
  if (!QFileInfo(path).isDir()) return id.isEmpty() || id == QFileInfo(path).fileName() ? path : QString();
  const bool plain = isMapFile(id) && !id.contains(QLatin1Char('/')) && !id.contains(QChar::Null);
  const QString inside = path + QLatin1Char('/') + id;
  return plain && QFileInfo(inside).isFile() ? inside : QString();
}

PictureYamls::PictureYamls(const QString& folder, YamlShelf& shelf) {
  const QDir dir(folder);
  const QStringList names = dir.entryList({QStringLiteral("*.yaml"), QStringLiteral("*.yml")}, QDir::Files,
                                          QDir::Name | QDir::IgnoreCase);
  for (const QString& name : names.mid(0, kMostFiles)) {
    const QString path = dir.absoluteFilePath(name);
    const QFileInfo file(path);
    if (!file.isFile() || file.size() > kLongest) continue;
    const auto yaml = shelf.read(path.toStdString());
    if (!yaml) continue;
    yamls_[trueName(dir.absoluteFilePath(QString::fromStdString(yaml->image)))] << path;
  }
}

QStringList PictureYamls::naming(const QString& picture) const { return yamls_.value(trueName(picture)); }

QStringList yamlsNaming(const QString& picture) {
  if (!isPicture(picture)) return {};
  YamlShelf shelf;
  return PictureYamls(QFileInfo(picture).absolutePath(), shelf).naming(picture);
}

tl::expected<map::WholeMap, Fault> readLocalMap(const QString& path, const PicturePlace& place,
                                                YamlShelf& yamls, const PictureYamls* beside) {
  if (auto why = unreadableReason(path)) return refused(std::move(*why));
  if (isOverlayFile(path)) {
    const QString map = mapBeside(path);
    return map.isEmpty() ? fromOverlays(path) : readLocalMap(map, place, yamls);
  }
  QStringList named_by;
  if (!isYaml(path) && !place.resolution_m && !place.origin)
    named_by =
        beside ? beside->naming(path) : PictureYamls(QFileInfo(path).absolutePath(), yamls).naming(path);
  const bool described = named_by.size() == 1;
  tl::expected<map::WholeMap, Fault> whole = isYaml(path) ? fromYaml(path, yamls)
                                             : described  ? fromYaml(named_by.front(), yamls)
                                                          : fromPicture(path, place, named_by);
  if (!whole) return whole;
  if (auto why = map::unusableReason(whole->grid)) return refused(std::move(*why));
  if (!whole->path.empty())
    whole->fingerprint = stampOf(QString::fromStdString(whole->path)) + "|" + readingText(whole->reading);
  return whole;
}

map::CatalogueEntry entryOf(const map::MapKey& key, const QString& path, const PicturePlace& place,
                            YamlShelf& yamls, const PictureYamls* beside) {
  map::CatalogueEntry entry;
  entry.key = key;
  entry.name = QFileInfo(path).fileName().toStdString();
  entry.modified_s = double(QFileInfo(path).lastModified().toMSecsSinceEpoch()) / 1000;
  entry.bytes = std::uint64_t(QFileInfo(path).size());
  // Overlays alone have no cells.
  if (const auto whole = readLocalMap(path, place, yamls, beside); whole && !whole->path.empty()) {
    entry.grid = whole->grid;
    entry.has_thumbnail = true;
    entry.bytes = std::uint64_t(QFileInfo(QString::fromStdString(whole->path)).size());
  }
  return entry;
}

std::string stampOf(const QString& path) {
  const std::string name = path.toStdString();
  struct stat about {};
  if (::stat(name.c_str(), &about) != 0) return name + "|gone";
  return name + "|" + std::to_string(about.st_size) + "|" + std::to_string(about.st_mtim.tv_sec) + "." +
         std::to_string(about.st_mtim.tv_nsec) + "|" + std::to_string(about.st_ino);
}

}  // namespace mapwright::robot::files
