#include "robot/files/local_maps.h"

#include <sys/stat.h>

#include <QDir>
#include <QFileInfo>

#include "robot/files/picture_yamls.h"
#include "robot/files/yaml_shelf.h"

namespace mapwright::robot::files {
namespace {

constexpr qsizetype kMostFiles = 10'000;
constexpr double kUsualResolutionM = 0.05;

bool hasSuffix(const QString& path, std::initializer_list<const char*> suffixes) {
  for (const char* suffix : suffixes) {
    if (path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive)) return true;
  }
  return false;
}

bool isYaml(const QString& path) { return hasSuffix(path, {".yaml", ".yml"}); }

auto refused(std::string sentence) { return tl::make_unexpected(std::move(sentence)); }

/// Where a file really lies, links followed as far as they lead.
QString trueFolder(const QString& path) {
  const QFileInfo info(path);
  const QString canonical = info.canonicalFilePath();
  return canonical.isEmpty() ? QDir::cleanPath(info.absolutePath()) : QFileInfo(canonical).absolutePath();
}

bool liesBelow(const QString& folder, const QString& above) {
  return folder == above ||
         folder.startsWith(above.endsWith(QLatin1Char('/')) ? above : above + QLatin1Char('/'));
}

std::string readingText(const map::CellReading& reading) {
  return std::to_string(int(reading.mode)) + (reading.negate ? "n" : "p") + " " +
         std::to_string(reading.occupied_thresh) + " " + std::to_string(reading.free_thresh);
}

void note(map::WholeMap& whole, map::Severity severity, std::string sentence) {
  whole.notes.push_back({severity, "File " + whole.name, std::move(sentence)});
}

std::optional<std::string> whyUnreadable(const QString& path) {
  const QFileInfo info(path);
  const std::string name = path.toStdString();
  if (!info.exists()) return "There is no file " + name + ".";
  if (!info.isFile()) return name + " is not a file.";
  if (!info.isReadable()) return "The file " + name + " may not be read by you.";
  return std::nullopt;
}

tl::expected<map::WholeMap, std::string> fromYaml(const QString& path, YamlShelf& yamls) {
  auto yaml = yamls.read(path.toStdString());
  if (!yaml) return refused(yaml.error());
  map::WholeMap whole;
  whole.name = QFileInfo(path).fileName().toStdString();
  whole.grid = yaml->grid;
  whole.reading = yaml->reading;
  const QString folder = QFileInfo(path).absolutePath();
  const QString picture = QDir::cleanPath(QDir(folder).absoluteFilePath(QString::fromStdString(yaml->image)));
  if (auto why = whyUnreadable(picture)) return refused("Its picture cannot be read. " + *why);
  whole.path = picture.toStdString();
  for (std::string& sentence : yaml->notes) note(whole, map::Severity::Warning, std::move(sentence));
  if (!liesBelow(trueFolder(picture), trueFolder(path))) {
    note(whole, map::Severity::Info, "Its picture lies outside of its folder: " + whole.path + ".");
  }
  return whole;
}

std::string namesOf(const QStringList& paths) {
  constexpr qsizetype kMostNames = 3;
  QStringList names;
  for (const QString& path : paths.mid(0, kMostNames)) names << QFileInfo(path).fileName();
  std::string text = names.join(QStringLiteral(", ")).toStdString();
  if (paths.size() > kMostNames) text += " and " + std::to_string(paths.size() - kMostNames) + " more";
  return text;
}

map::WholeMap fromPicture(const QString& path, const PicturePlace& place, const QStringList& named_by) {
  map::WholeMap whole;
  whole.name = QFileInfo(path).fileName().toStdString();
  whole.path = path.toStdString();
  whole.grid.resolution_m = place.resolution_m.value_or(kUsualResolutionM);
  whole.grid.origin = place.origin.value_or(geometry::Pose2{});
  if (!place.resolution_m) {
    note(whole, map::Severity::Warning,
         "A picture alone does not say how large its cells are. 0.05 m is assumed; give ?resolution=0.05 "
         "after "
         "the path to say it.");
  }
  const QString stem = QFileInfo(path).absolutePath() + QLatin1Char('/') + QFileInfo(path).completeBaseName();
  for (const char* suffix : {".yaml", ".yml"}) {
    const QString beside = stem + QLatin1String(suffix);
    if (!named_by.isEmpty() || place.resolution_m || !QFileInfo::exists(beside)) continue;
    note(whole, map::Severity::Info,
         QFileInfo(beside).fileName().toStdString() +
             " beside it does not name it as its image, or cannot be read as a map.yaml.");
    break;
  }
  if (!named_by.isEmpty()) {
    note(whole, map::Severity::Warning,
         "More than one map.yaml names this picture, so none is taken: " + namesOf(named_by) +
             ". Open the right one.");
  }
  return whole;
}

}  // namespace

bool isPicture(const QString& path) { return hasSuffix(path, {".png", ".pgm", ".bmp"}); }
bool isMapFile(const QString& path) { return isYaml(path) || isPicture(path); }

QStringList mapFilesIn(const QString& folder) {
  QStringList names;
  for (const QString& name : QDir(folder).entryList(QDir::Files, QDir::Name | QDir::IgnoreCase)) {
    if (isMapFile(name) && names.size() < kMostFiles) names << name;
  }
  return names;
}

tl::expected<map::WholeMap, std::string> readLocalMap(const QString& path, const PicturePlace& place,
                                                      YamlShelf& yamls, const PictureYamls* beside) {
  if (auto why = whyUnreadable(path)) return refused(std::move(*why));
  QStringList named_by;
  if (!isYaml(path) && !place.resolution_m && !place.origin)
    named_by = beside ? beside->naming(path) : yamlsNaming(path);
  const bool described = named_by.size() == 1;
  tl::expected<map::WholeMap, std::string> whole = isYaml(path) ? fromYaml(path, yamls)
                                                   : described  ? fromYaml(named_by.front(), yamls)
                                                                : fromPicture(path, place, named_by);
  if (!whole) return whole;
  if (auto why = map::whyUnusable(whole->grid)) return refused(std::move(*why));
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
  if (const auto whole = readLocalMap(path, place, yamls, beside)) {
    entry.grid = whole->grid;
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
