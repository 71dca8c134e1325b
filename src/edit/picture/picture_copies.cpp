#include "edit/picture/picture_copies.h"

#include <algorithm>
#include <map>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

#include "grids/export_grid.h"
#include "sentences/fault_sentence.h"
#include "words/file_name.h"
#include "words/qt_versions.h"

namespace mapwright::edit {
namespace {

struct PictureCopiesText {
  Q_DECLARE_TR_FUNCTIONS(mapwright::edit::PictureCopies)
};

const QString kTime = QStringLiteral("yyyy-MM-dd_HH-mm-ss-zzz");
constexpr qint64 kLongestHead = 64, kLongestYaml = 4'096;

grids::MapServerFiles filesOf(const QString& yaml) {
  return grids::mapServerFiles(QFile::encodeName(yaml).toStdString());
}
QString pictureOf(const QString& yaml) { return QFile::decodeName(filesOf(yaml).picture.c_str()); }

/// nullopt: the name is not from copyPath().
std::optional<QDateTime> madeAt(const QString& name) {
  const QDateTime made = QDateTime::fromString(QFileInfo(name).completeBaseName(), kTime);
  if (!made.isValid()) return std::nullopt;
  return words::takenAsUtc(made);
}

PictureCopy lookAt(const QString& path, const QDateTime& made) {
  const QDir of_map = QFileInfo(path).dir();
  PictureCopy copy{path, QFileInfo(of_map.path()).dir().dirName(), of_map.dirName(), made};
  QFile picture(pictureOf(path));
  if (!picture.open(QIODevice::ReadOnly)) return copy;
  copy.bytes = picture.size() + QFileInfo(path).size();
  static const QRegularExpression head(QStringLiteral("^P5\\s+(\\d{1,6})\\s+(\\d{1,6})\\s+255\\s"));
  const auto size = head.match(QString::fromLatin1(picture.read(kLongestHead)));
  copy.width = size.captured(1).toInt();
  copy.height = size.captured(2).toInt();
  return copy;
}

/// "name: value" of a map.yaml as it is written here.
QString valueOf(const QString& yaml, const QString& name) {
  const QRegularExpression line(QStringLiteral("^%1:\\s*(.*?)\\s*$").arg(name),
                                QRegularExpression::MultilineOption);
  return line.match(yaml).captured(1);
}

}  // namespace

QString PictureCopy::folder() const { return QFileInfo(path).path(); }

QString allCopiesFolder(const QString& drafts_folder) {
  if (drafts_folder.isEmpty()) return {};
  return QDir(QFileInfo(QDir(drafts_folder).absolutePath()).path()).filePath(QStringLiteral("overwritten"));
}

QString copiesFolder(const QString& drafts_folder, const QString& robot, const QString& map) {
  if (drafts_folder.isEmpty()) return {};
  return QDir(allCopiesFolder(drafts_folder))
      .filePath(QStringLiteral("%1/%2").arg(words::shortFileName(robot, QStringLiteral("map")),
                                            words::shortFileName(map, QStringLiteral("map"))));
}

QString copyPath(const QString& folder, const QDateTime& now) {
  return QDir(folder).filePath(now.toUTC().toString(kTime) + QStringLiteral(".yaml"));
}

std::optional<Fault> keepCopy(const grids::GridPyramid& cells, const map::GridReference& reference,
                              const QString& path) {
  QDir folder = QFileInfo(path).dir();
  QDir().mkpath(folder.path());  // if that fails, the next step fails, too, and reports why
  // It is put back as it was: every percentage counts.
  const auto written = grids::writeMapServer(cells, reference, QFile::encodeName(path).toStdString(),
                                             {.mode = grids::MapServerForm::Mode::Raw});
  if (!written) return written.error();
  folder.cd(QStringLiteral("../.."));
  for (const PictureCopy& old : copiesTooMany(copiesKept(folder.path()))) {
    QFile::remove(old.path);
    QFile::remove(pictureOf(old.path));
  }
  return std::nullopt;
}

std::vector<PictureCopy> copiesKept(const QString& all_folder) {
  std::vector<PictureCopy> copies;
  constexpr auto kFolders = QDir::Dirs | QDir::NoDotAndDotDot | QDir::NoSymLinks;
  for (const QFileInfo& robot : QDir(all_folder).entryInfoList(kFolders)) {
    for (const QFileInfo& map : QDir(robot.filePath()).entryInfoList(kFolders)) {
      for (const QFileInfo& file :
           QDir(map.filePath()).entryInfoList({QStringLiteral("*.yaml")}, QDir::Files | QDir::NoSymLinks)) {
        if (const auto made = madeAt(file.fileName())) copies.push_back(lookAt(file.filePath(), *made));
      }
    }
  }
  std::stable_sort(copies.begin(), copies.end(),
                   [](const PictureCopy& a, const PictureCopy& b) { return a.made > b.made; });
  return copies;
}

std::vector<PictureCopy> copiesTooMany(const std::vector<PictureCopy>& newest_first, qint64 most_bytes) {
  std::vector<PictureCopy> too_many;
  std::map<QString, int> of_map;
  qint64 sum = 0;
  for (const PictureCopy& copy : newest_first) {
    const int number = ++of_map[copy.folder()];
    const bool newest = number == 1;
    if (number > kMostCopies || (!newest && sum + copy.bytes > most_bytes)) {
      too_many.push_back(copy);
    } else {
      sum += copy.bytes;
    }
  }
  return too_many;
}

tl::expected<ReadCopy, QString> readCopy(const QString& path, const std::atomic<bool>& cancelled) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return tl::make_unexpected(file.errorString());
  const QString yaml = QString::fromUtf8(file.read(kLongestYaml));
  using Mode = map::CellReading::Mode;
  grids::GridOptions options;
  options.reading.mode =
      valueOf(yaml, QStringLiteral("mode")) == QLatin1String("raw") ? Mode::Raw : Mode::Trinary;
  auto reading = grids::openGridFile(QFile::encodeName(pictureOf(path)).toStdString(), options);
  if (!reading) return tl::make_unexpected(sentences::wordsOf(reading.error()));
  if (const auto trouble = (*reading)->read(cancelled, [] {}))
    return tl::make_unexpected(sentences::wordsOf(*trouble));
  ReadCopy copy{(*reading)->pyramid(), {}};
  copy.place.width = copy.cells->width();
  copy.place.height = copy.cells->height();
  bool has_resolution = false;
  copy.place.resolution_m = valueOf(yaml, QStringLiteral("resolution")).toDouble(&has_resolution);
  QStringList origin = valueOf(yaml, QStringLiteral("origin"))
                           .remove(QLatin1Char('['))
                           .remove(QLatin1Char(']'))
                           .split(QLatin1Char(','));
  if (!has_resolution || origin.size() != 3 || cancelled)
    return tl::make_unexpected(PictureCopiesText::tr("Its map.yaml was changed afterwards."));
  copy.place.origin = {origin[0].toDouble(), origin[1].toDouble(), origin[2].toDouble()};
  return copy;
}

}  // namespace mapwright::edit
